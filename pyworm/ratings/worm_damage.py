"""Simulated temperatures and specific films of a worm gear's contacts: figures, no rating.

No limit stands beside them: the tests of oils against scuffing and micropitting are made with steel gears,
and bronze or iron on steel seizes at other temperatures and wears before it pits.
"""

import numpy as np

from pyworm.case.worm_conditions import MEAN_TO_RMS
from pyworm.drives.duty import WormDuty
from pyworm.materials.oil import Oil
from pyworm.ratings.flank_damage import Limit, simulated_spots
from pyworm.ratings.flank_table import flank_table
from pyworm.ratings.rating import Rating
from pyworm.result.headline import of_all
from pyworm.result.result import Result

NO_RATING = (
    "ISO/TS 14521 and DIN 3996 rate neither scuffing nor micropitting of worm gears, and limits of steel "
    "gears do not hold for their wheels: temperatures and specific film thickness compare variants."
)


def worm_flanks(duty: WormDuty, oil: Oil, result: Result) -> Rating:
    """Simulated contact temperatures and specific films of a worm gear at every converged contact."""
    heights = [height for height in duty.roughness if height is not None]
    return flank_table(
        simulated_spots(result.solutions),
        (Limit(None), Limit(None)),
        None if oil.heat is None else oil.heat.inlet_temperature,
        MEAN_TO_RMS * float(np.mean(heights)) if len(heights) == len(duty.roughness) else None,
        of_all(result.solutions),
        words=(NO_RATING,),
        title="Temperatures and specific film thickness at each solved contact",
        source="simulation",
    )
