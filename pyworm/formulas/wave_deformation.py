"""How much of a wave on a rolling surface elastic flattening leaves in the film."""

from math import sqrt

from pyworm.formulas.film import LineGroups, PointGroups

Groups = LineGroups | PointGroups


def left_of_waves(length: float, groups: Groups) -> float:
    """Amplitude of a wave in the film over that on the surface, in pure rolling [-].

    By wave length over half-width, on master curves of A. A. Lubrecht and C. H. Venner: of a line (Venner,
    Couhier, Lubrecht and Greenwood 1997, within 10 % of the films solved in
    `benchmarks/validation/waviness.py` where half or less is left) and of a point (Venner and Lubrecht 2000),
    not seen in print. Short waves keep their shape, long ones are flattened.
    """
    if not groups.moes_l > 0:
        return 0.0
    if isinstance(groups, LineGroups):
        n = length * groups.moes_m**0.75 / sqrt(groups.moes_l)
        return float(1 / (1 + 0.17 * n + 0.03 * n**2))
    n = length * sqrt(groups.moes_m / groups.moes_l)
    return 1 / (1 + 0.15 * n + 0.015 * n**2)
