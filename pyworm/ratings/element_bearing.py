"""Bearings of rollers on their pins: loads over the mesh, speeds, and where the rollers' power is lost."""

from pyworm.drives.answers import ElementBearing
from pyworm.drives.forces import BearingForce
from pyworm.ratings.bearing import ShaftLoad
from pyworm.ratings.rating import RatedFigure, Rating

SOURCE = "equilibrium of a roller; ISO 281 (mean load)"

WORDS = (
    "Losses are of sliding, by closed forms over Hertz's contact and the oil's flow law without heating; "
    "rolling friction is not in them. The mean load is that of equal life, over the turns under load."
)


def element_load(found: ElementBearing) -> ShaftLoad:
    """Load and speed of the bearing for its life, with where they come from."""
    words = (
        f"Mean radial load {found.radial:.4g} N of equal life over the mesh, {found.radial_max:.4g} N at "
        f"most; a washer takes the thrust, {found.axial_max:.4g} N at most."
    )
    return ShaftLoad(BearingForce(found.radial, 0.0), found.speed, "", words)


def rate_element_bearing(found: ElementBearing) -> Rating:
    """Loads, speeds and losses of the elements."""
    losses = tuple(
        RatedFigure(f"loss_{number}_W", f"  {words}", (power,), "W")
        for number, (words, power) in enumerate(found.losses.items())
    )
    return Rating(
        key="element_bearing",
        title="Rollers on their pins",
        source=SOURCE,
        columns=("computed",),
        figures=(
            RatedFigure("radial_N", "Radial load, mean of equal life", (found.radial,), "N"),
            RatedFigure("radial_max_N", "Radial load, maximum", (found.radial_max,), "N"),
            RatedFigure("axial_max_N", "Thrust, maximum", (found.axial_max,), "N"),
            RatedFigure("speed_rad_s", "Speed, mean under load", (found.speed,), "rpm"),
            RatedFigure("speed_max_rad_s", "Speed, maximum", (found.speed_max,), "rpm"),
            RatedFigure("loss_W", "Loss of all rollers", (sum(found.losses.values()),), "W"),
            *losses,
        ),
        words=(WORDS,),
    )
