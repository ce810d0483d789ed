"""Geometric effects: deflection, second dimension, real gap, velocities that vary over the contact."""

from dataclasses import replace
from math import hypot, inf, pi

import numpy as np

from pyworm.formulas.arrays import Array
from pyworm.formulas.hertz import hertz
from pyworm.formulas.regimes import flattening
from pyworm.planning.effects.effect import EVERYTHING, Effect, Influence
from pyworm.planning.prediction import Prediction
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.line import LineScene, Parabola
from pyworm.scene.point import Paraboloid, RigidMotion, Scene

ALIGNED = 0.02
"""Sine of the angle to an axis of the contact up to which entrainment and sliding are along it."""

RIM = tuple(k * pi / 4 for k in range(8))
"""Directions from the middle of a contact in which its gap is sampled [rad]."""

SPEED_POWER = 0.7
"""Exponent of the speed in the film (Dowson and Higginson; 0.66 to 0.71 in other formulas)."""


def _same_all_along(scene: AnyContact) -> str | None:
    return "a line contact is the same all along" if isinstance(scene, LineScene) else None


def _on_the_rim(scene: AnyContact) -> tuple[Array, ...]:
    """Points on the outline of Hertz's contact."""
    if isinstance(scene, LineScene):
        raise TypeError("a line contact has no outline")
    contact = hertz(*scene.radii, scene.load, scene.reduced_modulus)
    angles = np.array(RIM)
    return contact.semi_axis_x * np.cos(angles), contact.semi_axis_y * np.sin(angles)


# ------------------------------------------------------------------------------- elastic deflection


def _deflection(prediction: Prediction) -> float:
    """Ratio of deflection to film thickness: the number by which bodies count as elastic."""
    groups = prediction.groups
    return float(flattening(prediction.half_width, groups.radius, prediction.film_min))


def _by_deflection(prediction: Prediction) -> Influence:
    if prediction.carried_by_heat:
        return EVERYTHING
    change = DEFLECTION_FACTOR * _deflection(prediction)
    return Influence(change, change, change)


DEFLECTION_FACTOR = 2.0
"""Change of a quantity over the ratio of deflection to film."""

ELASTIC_DEFLECTION = Effect(
    name="elastic-deflection",
    symbol="b^2 / 2 R h",
    source="flattening of Hertz's contact along the entrainment (Johnson 1985, 4.2)",
    indicator=_deflection,
    influence=_by_deflection,
    without=lambda scene: replace(scene, rigid=True),
)


# --------------------------------------------------------------------------------- second dimension


def _axis(scene: Scene) -> int | None:
    """The axis of the contact along which entrainment and sliding lie; None if there is none."""
    origin = np.zeros(())
    for axis in (0, 1):
        velocities = [
            velocity_at(origin, origin) for velocity_at in (scene.entrainment, scene.sliding)
        ]
        if all(
            abs(float(v[1 - axis])) <= ALIGNED * hypot(float(v[0]), float(v[1])) for v in velocities
        ):
            return axis
    return None


def _slenderness(prediction: Prediction) -> float:
    return prediction.half_width / prediction.half_length


def _side_flow(prediction: Prediction) -> Influence:
    """Relative error of a line contact of the same largest pressure.

    Ellipses entrained across, of radii 3 to 1000 to one: films and temperatures within these bounds, friction
    5 to 11 % higher, since most slices of an ellipse carry less pressure than the middle one
    (`benchmarks/accuracy/line_for_point.py`).
    """
    if isinstance(prediction.scene, LineScene):
        return Influence()
    at_rest = prediction.oil.heat is not None and 0 in prediction.velocities
    crossed = not prediction.carried_by_heat and prediction.half_width < prediction.half_length
    if _axis(prediction.scene) is None or at_rest or not crossed:
        return EVERYTHING
    slenderness = _slenderness(prediction)
    return Influence(
        film=0.5 * slenderness**2 + 6 * slenderness**4,
        friction=0.12,
        temperature=0.01 + 0.13 * slenderness,
    )


def as_line(scene: AnyContact) -> AnyContact:
    """The line in the middle of a long contact, of its pressure and curvature; ValueError without."""
    if isinstance(scene, LineScene):
        return scene
    axis = _axis(scene)
    if axis is None:
        raise ValueError(
            f"{scene.name}: entrainment and sliding do not lie along one axis of the contact; "
            "second-dimension cannot be neglected"
        )
    radius = scene.radii[axis]
    pressure = hertz(*scene.radii, scene.load, scene.reduced_modulus).pressure_max
    origin = np.zeros(())
    first, second = (float(motion(origin, origin)[axis]) for motion in scene.motions)
    travelled = None
    if scene.travelled is not None:
        travelled = (scene.travelled[0][axis],), (scene.travelled[1][axis],)
    return LineScene(
        name=scene.name,
        gap=Parabola(radius),
        radius=radius,
        velocities=(first, second),
        load=2 * pi * radius * pressure**2 / scene.reduced_modulus,  # Johnson (1985), 4.45
        bodies=scene.bodies,
        oil=scene.oil,
        phase=scene.phase,
        slide_roll_ratio=scene.slide_roll_ratio,
        separation=scene.separation,
        past=scene.past,
        travelled=travelled,
    )


SECOND_DIMENSION = Effect(
    name="second-dimension",
    symbol="b / a",
    source="ellipses against line contacts (`benchmarks/accuracy/line_for_point.py`)",
    indicator=_slenderness,
    influence=_side_flow,
    without=as_line,
    lacking=_same_all_along,
)


# ----------------------------------------------------------------------------------------- real gap


def _own_curves(scene: AnyContact) -> str | None:
    kind = Parabola if isinstance(scene, LineScene) else Paraboloid
    return "the gap is given by its radii alone" if isinstance(scene.gap, kind) else None


RINGS = (1.0, 2.0, 4.0)
"""Outlines about a contact, over its own size, on which the gap is sampled; those farther out weigh less, by
the gap there."""


def departure(prediction: Prediction) -> float:
    """Relative departure of the gap from its paraboloid, on outlines around the contact."""
    scene = prediction.scene
    outline: tuple[Array, ...]
    plain: Parabola | Paraboloid
    if isinstance(scene, LineScene):
        outline = (np.array([-1.0, 1.0]) * prediction.half_width,)
        plain = Parabola(scene.radius)
    else:
        outline, plain = _on_the_rim(scene), Paraboloid(*scene.radii)
    worst = 0.0
    for ring in RINGS:
        places = [ring * place for place in outline]
        gap, covered = scene.gap(*places)
        if not (np.isfinite(gap).all() and (ring > 1 or covered.all())):
            return inf
        opening = plain(*places)[0]
        worst = max(worst, float(np.max(np.abs(gap - opening) / opening)) / ring**2)
    return worst


def _by_departure(prediction: Prediction) -> Influence:
    if _spins_only(prediction.scene):
        return EVERYTHING  # the load of its film comes from all around, far out too
    change = departure(prediction)
    return Influence(change, change, change)


def _spins_only(scene: AnyContact) -> bool:
    if isinstance(scene, LineScene):
        return False
    origin = np.zeros(())
    return all(float(part) == 0 for part in scene.entrainment(origin, origin))


def _plain_gap(scene: AnyContact) -> AnyContact:
    if isinstance(scene, LineScene):
        return replace(scene, gap=Parabola(scene.radius))
    return replace(scene, gap=Paraboloid(*scene.radii))


REAL_GAP = Effect(
    name="real-gap",
    symbol="|gap - paraboloid| / gap, at the rim",
    source="the gap at eight places of the outline of Hertz's contact",
    indicator=departure,
    influence=_by_departure,
    without=_plain_gap,
    lacking=_own_curves,
    together=("second-dimension",),
)


# --------------------------------------------------------------------------------- varying velocity


def _uniform(scene: AnyContact) -> str | None:
    if isinstance(scene, LineScene):
        return _same_all_along(scene)
    rigid = [motion for motion in scene.motions if isinstance(motion, RigidMotion)]
    if len(rigid) == len(scene.motions) and all(motion.spin == 0 for motion in rigid):
        return "both surfaces only translate"
    return None


def _variation(scene: AnyContact, name: str) -> float:
    """Largest change of a velocity field on the rim over its size in the middle."""
    field = getattr(scene, name)
    u, v = field(*_on_the_rim(scene))
    middle = [float(part) for part in field(np.zeros(()), np.zeros(()))]
    change = float(np.max(np.hypot(u - middle[0], v - middle[1])))
    size = hypot(*middle)
    if change == 0:
        return 0.0
    return change / size if size > 0 else inf


def _by_variation(prediction: Prediction) -> Influence:
    film = SPEED_POWER * _variation(prediction.scene, "entrainment")
    sliding = _variation(prediction.scene, "sliding")
    return Influence(film, max(film, sliding), sliding)


def _translating(scene: AnyContact) -> AnyContact:
    if isinstance(scene, LineScene):
        return scene
    origin = np.zeros(())
    first, second = (
        RigidMotion(*(float(part) for part in motion(origin, origin))) for motion in scene.motions
    )
    return replace(scene, motions=(first, second))


VARYING_VELOCITY = Effect(
    name="varying-velocity",
    symbol="|u - u0| / |u0|, at the rim",
    source="velocities at eight places of the outline of Hertz's contact; h ~ u^0.7",
    indicator=lambda prediction: max(
        _variation(prediction.scene, field) for field in ("entrainment", "sliding")
    ),
    influence=_by_variation,
    without=_translating,
    lacking=_uniform,
    together=("second-dimension",),
)
