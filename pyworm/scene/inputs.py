"""The numbers that a contact is given by, one by one, by the names of the attributes that hold them.

`load`, `radius_x` and `radius_y` (of a line `radius`), `bodies[0].youngs_modulus`, `oil.viscosity.eta0`,
`motions[1].u` and so on; and `temperature`, that of oil and bodies with all that follows from it. Geometry
and motion that a drive makes are no numbers of the contact.
"""

from collections.abc import Callable, Iterator
from dataclasses import fields, is_dataclass, replace
from typing import Any

from pyworm.materials.body import Body
from pyworm.materials.tabulated import Tabulated
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.line import LineScene
from pyworm.scene.point import Paraboloid, RigidMotion

TEMPERATURE = "temperature"
"""Name of the temperature of oil and bodies: oil that arrives between warmer bodies is as warm as they."""

UNUSED = frozenset({"lay", "inlet_temperature", "alpha_spread"})
"""Attributes that are no inputs of a steady film: directions, what a law is given at, and a spread."""

ATTRIBUTES = ("bodies", "motions", "velocities", "oil")
"""Attributes of a contact that hold numbers."""

FIELDS = "__dataclass_fields__"
"""Attribute of a dataclass that has its fields by name; `dataclasses.fields` makes a list of them."""

OF_HEAT = frozenset({"conductivity", "specific_heat", "bulk_temperature", "heat", "rho0"})
"""Attributes that only heat takes, beside the density of the bodies."""

OF_ROUGHNESS = ("roughness", "asperity", "boundary")
"""First words of attributes that only roughness takes."""


def inputs_of(scene: AnyContact, *, heated: bool = True, rough: bool = True) -> dict[str, float]:
    """Numbers of a contact other than zero, by name; a temperature in K.

    Those that only heat or only roughness takes are left out without it.
    """

    def counts(path: str, name: str) -> bool:
        if name in UNUSED or (name.startswith(OF_ROUGHNESS) and not rough):
            return False
        return heated or not (name in OF_HEAT or (name == "density" and path.startswith("bodies")))

    found = {"load": scene.load, **dict(_radii(scene))}
    for attribute in ATTRIBUTES:
        if attribute != "motions" or _rigid(scene):
            found |= _numbers(getattr(scene, attribute, None), attribute, counts)
    if scene.oil.heat is not None and not isinstance(scene.oil.viscosity, Tabulated):
        found[TEMPERATURE] = scene.oil.thermal.inlet_temperature
    return found


def with_input(scene: AnyContact, name: str, value: float) -> AnyContact:
    """The contact with another value of one of its numbers; KeyError without it."""
    path = name.replace("[", ".").replace("]", "").split(".")
    if not _has(scene, name, path):
        raise KeyError(f"{scene.name} has no number {name}; it has {', '.join(inputs_of(scene))}")
    if name == TEMPERATURE:
        warmer = value - scene.oil.thermal.inlet_temperature
        first, second = (_warmed(body, warmer) for body in scene.bodies)
        # between bodies of a temperature of their own the oil is as warm as they (`Contact`)
        follows = None not in (first.bulk_temperature, second.bulk_temperature)
        oil = scene.oil if follows else scene.oil.warmed(warmer)
        return replace(scene, oil=oil, bodies=(first, second))
    changed: AnyContact = (
        _SHAPES[name](scene, value) if name in _SHAPES else _replaced(scene, path, value)
    )
    return changed


def _has(scene: AnyContact, name: str, path: list[str]) -> bool:
    """Whether a name is one of `inputs_of`; by its path alone, without the others."""
    if name == TEMPERATURE or name in _SHAPES:
        return name in inputs_of(scene)
    if not (name == "load" or path[0] in ATTRIBUTES) or UNUSED.intersection(path):
        return False
    if path[0] == "motions" and not _rigid(scene):
        return False
    part: Any = scene
    for step in path:
        if isinstance(part, tuple):
            part = part[int(step)] if step.isdecimal() and int(step) < len(part) else None
        else:
            part = getattr(part, step) if step in getattr(part, FIELDS, ()) else None
    return isinstance(part, float) and part != 0


def _rigid(scene: AnyContact) -> bool:
    return all(isinstance(motion, RigidMotion) for motion in getattr(scene, "motions", ()))


def _warmed(body: Body, rise: float) -> Body:
    bulk = body.bulk_temperature
    return body if bulk is None else replace(body, bulk_temperature=bulk + rise)


def _radii(scene: AnyContact) -> Iterator[tuple[str, float]]:
    """Radii of a contact whose gap is that of its radii."""
    if isinstance(scene, LineScene):
        if hasattr(scene.gap, "radius"):
            yield "radius", scene.radius
    elif isinstance(scene.gap, Paraboloid):
        yield from zip(("radius_x", "radius_y"), scene.radii, strict=True)


def _of_line(scene: Any, value: float) -> Any:
    return replace(scene, radius=value, gap=replace(scene.gap, radius=value))


def _of_point(axis: int) -> Callable[[Any, float], Any]:
    def changed(scene: Any, value: float) -> Any:
        radii = tuple(
            value if index == axis else radius for index, radius in enumerate(scene.radii)
        )
        return replace(scene, radii=radii, gap=Paraboloid(*radii))

    return changed


_SHAPES: dict[str, Callable[[Any, float], Any]] = {
    "radius": _of_line,
    "radius_x": _of_point(0),
    "radius_y": _of_point(1),
}


def _numbers(part: Any, path: str, counts: Callable[[str, str], bool]) -> dict[str, float]:
    """Numbers other than zero within a part, by path."""
    if isinstance(part, float):
        return {path: part} if part else {}
    if isinstance(part, tuple):
        inner = [(f"{path}[{index}]", item) for index, item in enumerate(part)]
    elif is_dataclass(part):
        inner = [
            (f"{path}.{attribute.name}", getattr(part, attribute.name))
            for attribute in fields(part)
            if counts(path, attribute.name)
        ]
    else:
        return {}
    return {
        name: value
        for place, item in inner
        for name, value in _numbers(item, place, counts).items()
    }


def _replaced(part: Any, path: list[str], value: float) -> Any:
    """A part with another number at the end of a path within it."""
    if not path:
        return value
    first, *rest = path
    if isinstance(part, tuple):
        return tuple(
            _replaced(item, rest, value) if index == int(first) else item
            for index, item in enumerate(part)
        )
    return replace(part, **{first: _replaced(getattr(part, first), rest, value)})
