"""A scene at another slide-roll ratio and the same entrainment."""

from dataclasses import replace

from pyworm.formulas.ranges import scalar
from pyworm.scene.point import RigidMotion, Scene, require_point


def with_slide_roll_ratio(scene: Scene, ratio: float) -> Scene:
    """The scene with sliding over entrainment [-] of another value, along the entrainment.

    Args:
        scene: A point contact.
        ratio: Velocity of body 1 less that of body 2, over their mean.

    Raises:
        ValueError: Surfaces that do more than translate and spin, or no entrainment.
    """
    require_point(scene)
    ratio = scalar("ratio", ratio)
    first, second = scene.motions
    if not (isinstance(first, RigidMotion) and isinstance(second, RigidMotion)):
        raise ValueError(f"{scene.name}: its motions are no RigidMotion, which slide at one ratio")
    u, v = (first.u + second.u) / 2, (first.v + second.v) / 2
    if u == v == 0:
        raise ValueError(f"{scene.name}: without entrainment there is no slide-roll ratio")
    faster, slower = (
        RigidMotion(factor * u, factor * v, body.spin)
        for factor, body in ((1 + ratio / 2, first), (1 - ratio / 2, second))
    )
    return replace(
        scene,
        name=f"{scene.name}, slide-roll ratio {ratio:g}",
        motions=(faster, slower),
        slide_roll_ratio=float(ratio),
    )
