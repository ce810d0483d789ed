"""Films of starved contacts against flooded ones.

Chevalier, Lubrecht, Cann, Colin and Dalmaz (J. Tribol. 120 (1998) 126): h/h_flooded = r/(1 + r^g)^(1/g),
with r the oil supplied over that of the flooded film. The exponent g is infinite in line contacts, where no
oil can escape to the sides.
"""

import math


def film_over_flooded(supply_ratio: float, exponent: float) -> float:
    """Film over that of a flooded contact [-] by the oil supplied over that of the flooded film [-].

    The exponent g is infinite for a line contact.
    """
    if math.isinf(exponent) or math.isinf(supply_ratio):
        return min(1.0, supply_ratio)
    if not supply_ratio > 0:
        return 0.0
    return float((1 + supply_ratio**-exponent) ** (-1 / exponent))


def supply_after_passes(supply_ratio: float, passes: int, exponent: float) -> float:
    """Film over that of a flooded contact after some passes over one track without new oil [-].

    h/h_flooded = (r^-g + n)^(-1/g) (Chevalier et al. 1998), of a contact whose next pass gets what it left.
    """
    if not supply_ratio > 0:
        return 0.0
    return float((supply_ratio**-exponent + passes) ** (-1 / exponent))
