"""Every quantity that users see or files hold, said once: name, unit, label, symbol, colours, key.

Tables, pages, pictures, `Solution.summary` and datasets take their words and units from here. A figure that a
solution's attributes already determine is added by one entry: its `source` reads it, its `places` show it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from pyworm.io.number_with_unit import unit_of
from pyworm.io.on_demand import xarray as xr

BODIES = "body 1", "body 2"
"""What bodies are called that no drive names."""

SCALES = {
    "": 1.0, "%": 100.0, "µm": 1e6, "mm": 1e3, "m/s": 1.0, "N": 1.0, "kN": 1e-3, "N/m": 1.0, "kN/m": 1e-3,
    "N m": 1.0, "W": 1.0, "kW/m": 1e-3, "MPa": 1e-6, "GPa": 1e-9, "MW/m²": 1e-6, "MPa m": 1e-6,
    "°C": 1.0, "°": 1.0, "µrad": 1e6, "1/s": 1.0, "1/m²": 1.0, "s": 1.0, "h": 1.0,
}  # fmt: skip
"""Shown unit -> factor from SI; temperatures in °C also have an offset."""

GREEK = {"lambda": r"\lambda", "eta": r"\eta", "tau": r"\tau", "µ": r"\mu"}
"""Symbol in letters -> as pictures typeset it."""

ENDINGS = {
    "1": "", "m": "_m", "Pa": "_Pa", "N": "_N", "W": "_W", "N/m": "_N_m", "W/m": "_W_m", "1/s": "_1_s",
    "m/s": "_m_per_s", "K": "_C", "s": "_s",
}  # fmt: skip
"""SI unit -> ending of the keys of JSON objects; temperatures there are in °C."""

KEY_UNITS = {
    "_m_per_s": (1.0, "m/s"), "_m_s": (1.0, "m/s"), "_N_m": (1.0, "N m"), "_N": (1.0, "N"),
    "_deg": (1.0, "°"), "_um": (1.0, "µm"), "_MPa": (1.0, "MPa"), "_C": (1.0, "°C"), "_kN": (1.0, "kN"),
    "_h": (1.0, "h"), "_m": (1e3, "mm"),
}  # fmt: skip
"""Ending of other keys -> factor to the unit shown, and that; a longer ending stands before its own end."""


@dataclass(frozen=True)
class Quantity:
    """A quantity and how it is shown."""

    name: str
    """Name in code and in datasets."""
    unit: str
    """SI unit, "1" without dimension."""
    label: str
    """Words of the field in lower case; "{0}" and "{1}" stand for the bodies."""
    shown: str = ""
    """Unit on screens and pages, of `SCALES`."""
    symbol: str = ""
    """Symbol, for headings of narrow columns."""
    source: str | Callable[[Any], Any] = ""
    """Where a solution has its value: a path such as "figures.film_min", or a function of the solution; empty
    where no solution has it. None there means that it was not simulated."""
    figure: str = ""
    """Stem of the keys of its error bars, and its name under [published]; of a field the figure whose error
    bar it has. By default its name."""
    key: str = ""
    """Key in JSON objects; by default the name with the ending of the unit."""
    kind: str = ""
    """Kind of contact that alone has it; empty where both have."""
    places: str = ""
    """Where it is shown, words of `listed`."""
    given: bool = False
    """Whether it is an input, without error bars."""
    part: bool = False
    """Whether its row stands beneath the one before as a part of it."""
    extreme: str = ""
    """Extreme that decides over several contacts, "minimum" or "maximum"; empty where neither does."""
    colours: str = "inferno"
    """Colour map."""
    logarithmic: bool = False
    """Whether maps are logarithmic."""
    clip: float = 0.0
    """Upper end of its maps over the least value; 0 where colours span all values."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "figure", self.figure or self.name)
        object.__setattr__(self, "key", self.key or self.name + ENDINGS.get(self.unit, ""))

    @property
    def scale(self) -> float:
        """Factor from SI to the shown unit."""
        return SCALES[self.shown]

    @property
    def offset(self) -> float:
        """Value in SI that is shown as zero."""
        return unit_of("degC").zero if self.shown == "°C" else 0.0

    def value_in(self, solution: Any) -> Any:
        """Its value in a solution; None where it was not simulated, or belongs to another kind of contact."""
        if not self.source or (self.kind and self.kind != solution.kind):
            return None
        if callable(self.source):
            return self.source(solution)
        value = solution
        for name in self.source.split("."):
            value = None if value is None else getattr(value, name)
        return value

    @property
    def error_key(self) -> str:
        """Key of its numerical uncertainty: relative, of temperatures in K."""
        return self._of_error("error")

    @property
    def model_key(self) -> str:
        """Key of its model uncertainty, as of `error_key`."""
        return self._of_error("model_error")

    @property
    def published(self) -> str:
        """Its name under [published]; empty where that is another quantity's."""
        return self.figure if self.kind or self.figure == self.name else ""

    def _of_error(self, what: str) -> str:
        name, celsius, place = self.key.partition("_C_")
        return f"{name}_{what}_K_{place}" if celsius else f"{self.figure}_{what}"

    def number(self, value: Any) -> Any:
        """A value, or an array of them, in SI as shown."""
        return (value - self.offset) * self.scale

    def by_key(self, value: Any) -> Any:
        """A value of a JSON object, or an array of them, as shown: temperatures are in °C there."""
        return value * self.scale

    def digits(self, number: float) -> str:
        """A shown number as text: four digits, temperatures to a tenth of a kelvin."""
        return f"{number:.1f}" if self.shown == "°C" else f"{number:.4g}"

    def text(self, value: float) -> str:
        """A value in SI as text with its unit."""
        return self.with_unit(self.digits(self.number(value)))

    def with_unit(self, number: str) -> str:
        """A number as text with the unit."""
        return f"{number} {self.shown}".rstrip()

    def words(self, bodies: tuple[str, str] = BODIES) -> str:
        """The label with the bodies' names."""
        return self.label.format(*bodies)

    def title(self, bodies: tuple[str, str] = BODIES) -> str:
        """The label as the beginning of a line."""
        return _capital(self.words(bodies))

    def worst(self, bodies: tuple[str, str] = BODIES) -> str:
        """The label of its extreme over several contacts, or over a flank."""
        words = self.words(bodies)
        return words if words.startswith(("minimum", "maximum")) else f"{self.extreme} {words}"

    def worst_title(self, bodies: tuple[str, str] = BODIES) -> str:
        """The label of its extreme as the beginning of a line."""
        return _capital(self.worst(bodies))

    def axis(self, words: str = "") -> str:
        """Label of an axis or a colour bar: words, by default the label with the symbol, and unit."""
        unit = f"({self.shown})" if "/" in self.shown or " " in self.shown else self.shown
        label = self.words().removesuffix(f" {self.symbol}")
        named = words or f"{label} {self.typeset_symbol}".rstrip()
        return f"{named} / {unit}" if unit else named

    @property
    def typeset_symbol(self) -> str:
        """The symbol as pictures typeset it; empty without one."""
        base, _, index = self.symbol.partition("_")
        letter = GREEK.get(base, base)
        below = f"_\\mathrm{{{index}}}" if index else ""
        return f"${letter}{below}$" if letter else ""

    @property
    def column(self) -> str:
        """Heading of a narrow column: symbol, or label without one, over the unit."""
        return f"{self.symbol or _capital(self.label)}\n{self.shown}".rstrip()


def _capital(words: str) -> str:
    return words[:1].upper() + words[1:]


DECISIVE = "figures film key sweep picture explore"
"""Places of the figures that decide over a contact."""

EVERY_CONTACT = (
    Quantity("load", "N", "load", "kN", "F", "load", kind="point", places="contact figures",
        given=True),
    Quantity("load_per_length", "N/m", "load per length", "kN/m", "w", "load", "load", kind="line",
        places="contact figures", given=True),
    Quantity("radii", "m", "radius of relative curvature", "mm", "R", places="contact"),
    Quantity("radius", "m", "radius of relative curvature", "mm", "R", places="figures"),
    Quantity("radius_x", "m", "radius of relative curvature along x", "mm", "R_x"),
    Quantity("radius_y", "m", "radius of relative curvature along y", "mm", "R_y"),
    Quantity("radius_long", "m", "larger radius of relative curvature", "mm", places="figures"),
    Quantity("radius_short", "m", "smaller radius of relative curvature", "mm", places="figures"),
    Quantity("reduced_modulus", "Pa", "reduced modulus of elasticity", "GPa", "E'", places="contact"),
    Quantity("entrainment", "m/s", "entrainment velocity", "m/s", "u_m", places="contact"),
    Quantity("sliding", "m/s", "sliding velocity", "m/s", "u_s", places="contact", colours="cividis"),
    Quantity("hertz_length", "m", "Hertz contact length", "mm", places="contact figures"),
    Quantity("hertz_width", "m", "Hertz contact width", "mm", places="contact figures"),
    Quantity("hertz_pressure_max", "Pa", "maximum Hertz pressure", "MPa", "p_H",
        places="contact figures film", extreme="maximum"),
    Quantity("dry_pressure_max", "Pa", "maximum dry contact pressure", "MPa", "p_dry",
        "figures.dry.pressure_max", places="figures film", extreme="maximum"),
    Quantity("dry_length", "m", "dry contact length", "mm", "", "figures.dry.length", places="figures"),
    Quantity("dry_width", "m", "dry contact width", "mm", "", "figures.dry.width", places="figures"),
    Quantity("dry_approach", "m", "dry contact approach", "µm", "", "figures.dry.approach"),
    Quantity("film_min", "m", "minimum film thickness", "µm", "h_min", "figures.film_min",
        places=DECISIVE, extreme="minimum"),
    Quantity("film_min_at", "m", "position", "mm", "", "figures.film_min_at", places="figures",
        part=True),
    Quantity("film_min_kind", "1", "location", "", "", "figures.film_min_kind", places="figures film",
        part=True),
    Quantity("film_central", "m", "central film thickness", "µm", "h_c", "figures.film_central",
        places=DECISIVE, extreme="minimum"),
    Quantity("film_exit_min", "m", "minimum film thickness, centre line", "µm", "",
        "figures.film_exit_min", places="figures"),
    Quantity("film_exit_min_at", "m", "position along it", "mm", "", "figures.film_exit_min_at",
        places="figures", part=True),
    Quantity("film_lift", "m", "separation of the bodies by the film", "µm", "", "figures.lift"),
    Quantity("pressure_max", "Pa", "maximum pressure", "MPa", "p_max", "figures.pressure_max",
        places=DECISIVE, extreme="maximum"),
    Quantity("composite_roughness", "m", "composite roughness", "µm", "sigma", "composite_roughness",
        places="contact figures"),
    Quantity("specific_film", "1", "specific film thickness lambda", "", "lambda", "specific_film",
        places="figures film key sweep", extreme="minimum"),
    Quantity("lambda_central", "1", "of the central film thickness", "", "", figure="film_central",
        places="figures", part=True, extreme="minimum"),
    Quantity("film_over_flooded", "1", "film thickness over the fully flooded one", "%", "",
        "film_over_flooded", places="figures"),
    Quantity("supply_ratio", "1", "oil supplied over it", "", "", "supply_ratio", places="figures",
        part=True),
    Quantity("meniscus", "m", "inlet meniscus before the contact point", "mm", "",
        "figures.supply.meniscus", places="figures", part=True),
    Quantity("side_flow", "1", "oil that flows around the middle", "%", "", "figures.supply.side_flow",
        places="figures", part=True),
    Quantity("layer_left", "m", "layer left behind it", "µm", "", "figures.supply.layer_left",
        places="figures", part=True),
    Quantity("asperity_load_fraction", "1", "asperity load ratio", "%", "L_a",
        "figures.asperity_load_fraction", places="figures explore", extreme="maximum"),
    Quantity("friction_coefficient", "1", "friction coefficient", "", "µ",
        "figures.friction_coefficient", places="figures heat key sweep picture explore",
        extreme="maximum"),
    Quantity("friction_boundary", "1", "by asperities", "", "", "figures.friction_boundary",
        places="figures", part=True),
    Quantity("friction_fluid", "1", "by the oil", "", "", "friction_fluid"),
    Quantity("power_loss", "W", "power loss", "W", "P", "figures.power_loss", kind="point",
        places="figures heat explore"),
    Quantity("power_loss_per_length", "W/m", "power loss per length", "kW/m", "P",
        "figures.power_loss", "power_loss", kind="line", places="figures heat explore"),
    Quantity("shear_rate_max", "1/s", "maximum shear rate", "1/s", "", "figures.shear_rate_max",
        places="figures"),
    Quantity("inlet_temperature", "K", "inlet temperature", "°C", "", "inlet_temperature",
        places="figures"),
    Quantity("temperature_max_body_1", "K", "maximum surface temperature ({0})", "°C", "",
        "figures.temperature_max_body_1", key="temperature_max_C_body_1",
        places="figures heat explore", extreme="maximum"),
    Quantity("temperature_max_body_2", "K", "maximum surface temperature ({1})", "°C", "",
        "figures.temperature_max_body_2", key="temperature_max_C_body_2",
        places="figures heat explore", extreme="maximum"),
    Quantity("temperature_max_film", "K", "maximum film temperature", "°C", "T_film",
        "figures.temperature_max_film", key="temperature_max_C_film",
        places="figures heat key sweep picture explore", extreme="maximum"),
    Quantity("temperature_max", "K", "maximum temperature", "°C", "T_max"),
    Quantity("von_mises_max_body_1", "Pa", "maximum von Mises stress ({0})", "MPa", "",
        "figures.stress.von_mises_max_body_1", places="figures explore", extreme="maximum"),
    Quantity("von_mises_depth_body_1", "m", "depth", "µm", "", "figures.stress.depth_body_1",
        places="figures", part=True),
    Quantity("von_mises_max_body_2", "Pa", "maximum von Mises stress ({1})", "MPa", "",
        "figures.stress.von_mises_max_body_2", places="figures explore", extreme="maximum"),
    Quantity("von_mises_depth_body_2", "m", "depth", "µm", "", "figures.stress.depth_body_2",
        places="figures", part=True),
    Quantity("fatigue_ratio_max_body_1", "1", "maximum fatigue stress over its limit ({0})", "", "",
        "figures.stress.fatigue_ratio_max_body_1", places="figures explore", extreme="maximum"),
    Quantity("fatigue_ratio_max_body_2", "1", "maximum fatigue stress over its limit ({1})", "", "",
        "figures.stress.fatigue_ratio_max_body_2", places="figures explore", extreme="maximum"),
    Quantity("heat_balance", "1", "relative heat imbalance", "%", "", "figures.heat_balance",
        places="figures"),
    Quantity("moes_m", "1", "Moes load parameter M", "", "M", "figures.moes_m", key="moes_M",
        places="figures"),
    Quantity("moes_l", "1", "Moes lubricant parameter L", "", "L", "figures.moes_l", key="moes_L",
        places="figures"),
    Quantity("load_error", "1", "relative load imbalance", "%", "", "figures.load_error",
        places="figures"),
    Quantity("mass_error", "1", "relative mass imbalance", "%", "", "figures.mass_error",
        places="figures"),
    Quantity("residual", "1", "relative Reynolds residual", "", "", "figures.residual",
        places="figures"),
    Quantity("solve_time", "s", "elapsed time", "s", "t", "cost.seconds", key="seconds",
        places="figures"),
    Quantity("solve_convolutions", "1", "convolutions", "", "", "cost.convolutions",
        key="convolutions", places="figures"),
)  # fmt: skip
"""Figures of one contact, in the order of their rows."""

MESH_CYCLE = (
    Quantity("mesh_loss", "W", "power loss of the teeth", "W", "P"),
    Quantity("mesh_friction", "1", "mean friction coefficient of the teeth", "", "µ_m"),
    Quantity("mesh_efficiency", "1", "efficiency of the teeth", "%", "eta"),
    Quantity("unit_efficiency", "1", "efficiency of the gear unit", "%", "eta"),
    Quantity("sump_temperature", "K", "oil sump temperature", "°C", "T_S"),
    Quantity("wheel_torque", "N m", "torque of the wheel", "N m", "T_2"),
    Quantity("worm_torque", "N m", "torque of the worm", "N m", "T_1"),
    Quantity("wheel_turn", "rad", "transmission error (loaded)", "µrad"),
    Quantity("transmission_error", "rad", "transmission error (unloaded)", "µrad"),
    Quantity("pattern_margin", "m", "distance of the contact pattern from the end of the face", "mm",
        extreme="minimum"),
)  # fmt: skip
"""Figures of a whole mesh cycle."""

FIELDS = (
    Quantity("film", "m", "film thickness", "µm", "h", extreme="minimum", colours="viridis",
        logarithmic=True, clip=6.0, figure="film_min"),
    Quantity("pressure", "Pa", "pressure", "MPa", "p", extreme="maximum", figure="pressure_max"),
    Quantity("dry_pressure", "Pa", "dry contact pressure", "MPa", "p_dry", extreme="maximum",
        figure="pressure_max"),
    Quantity("asperity_pressure", "Pa", "asperity pressure", "MPa", "p_a", extreme="maximum",
        figure="pressure_max"),
    Quantity("temperature_middle", "K", "temperature in the middle of the film", "°C",
        extreme="maximum", figure="temperature_max_film"),
    Quantity("temperature_body_1", "K", "surface temperature ({0})", "°C", extreme="maximum",
        figure="temperature_max_body_1"),
    Quantity("temperature_body_2", "K", "surface temperature ({1})", "°C", extreme="maximum",
        figure="temperature_max_body_2"),
    Quantity("friction_power", "W/m2", "frictional power per area", "MW/m²", extreme="maximum",
        figure="power_loss"),
    Quantity("shear_stress", "Pa", "shear stress in the middle of the film", "MPa", "tau",
        extreme="maximum", colours="cividis"),
    Quantity("von_mises", "Pa", "von Mises stress", "MPa", extreme="maximum"),
    Quantity("fatigue_ratio_body_1", "1", "fatigue stress over its limit ({0})", "",
        extreme="maximum", colours="magma"),
    Quantity("fatigue_ratio_body_2", "1", "fatigue stress over its limit ({1})", "",
        extreme="maximum", colours="magma"),
    Quantity("fatigue_risk_body_1", "1/m2", "risk of pitting of a pass ({0})", "1/m²",
        extreme="maximum"),
    Quantity("fatigue_risk_body_2", "1/m2", "risk of pitting of a pass ({1})", "1/m²",
        extreme="maximum"),
    Quantity("pitting_probability", "1", "probability of pitting of 1 mm² in 10⁷ passes", "%",
        extreme="maximum"),
    Quantity("asperity_rubbing", "W/m2", "asperity pressure times sliding velocity", "MW/m²",
        extreme="maximum", figure="pressure_max"),
    Quantity("asperity_work", "Pa m", "asperity pressure times sliding distance in a pass", "MPa m",
        extreme="maximum"),
    Quantity("entry", "1", "inflow over mean entrainment velocity", "",
        extreme="minimum", colours="viridis"),
)  # fmt: skip
"""Fields of a contact, or of a flank over a mesh cycle, that maps show."""

IN_DATASETS = (
    Quantity("x", "m", "tangent plane, first direction from the contact point"),
    Quantity("y", "m", "tangent plane, second direction from the contact point"),
    Quantity("gap", "m", "undeformed gap"),
    Quantity("covered", "1", "1 where both surfaces exist"),
    Quantity("real_area", "1", "real area of contact of asperities over the nominal one",
        figure="pressure_max"),
    Quantity("entrainment_x", "m/s", "mean surface velocity along x"),
    Quantity("entrainment_y", "m/s", "mean surface velocity along y"),
    Quantity("sliding_x", "m/s", "velocity of body 1 relative to body 2 along x"),
    Quantity("sliding_y", "m/s", "velocity of body 1 relative to body 2 along y"),
    Quantity("shear_stress_x", "Pa", "shear stress in the middle of the film along x",
        figure="friction_coefficient"),
    Quantity("shear_stress_y", "Pa", "shear stress in the middle of the film along y",
        figure="friction_coefficient"),
    Quantity("shear_rate", "1/s", "maximum shear rate across the film", figure="shear_rate_max"),
    Quantity("slip", "1", "limiting stress reached at: 0 no surface, 1 body 1, 2 body 2, 3 both"),
    Quantity("flow_factor_sliding", "m3/(Pa s)",
        "flow by pressure gradient along the sliding (h^3/12 eta)", figure="film_min"),
    Quantity("flow_factor_across", "m3/(Pa s)",
        "flow by pressure gradient across the sliding (h^3/12 eta)", figure="film_min"),
    Quantity("oil_fraction", "1", "fraction of the gap that oil fills"),
    Quantity("level_position", "1", "place across the film, -1/2 at body 1 to 1/2 at body 2"),
    Quantity("profile_x", "m", "position of the maximum film temperature along x"),
    Quantity("profile_y", "m", "position of the maximum film temperature along y"),
    Quantity("profile_temperature", "K", "temperature across the film where it is hottest"),
    Quantity("profile_velocity_x", "m/s", "velocity across the film where it is hottest, along x"),
    Quantity("profile_velocity_y", "m/s", "velocity across the film where it is hottest, along y"),
    Quantity("tooth_x", "m", "tangent plane, first direction, over the whole tooth"),
    Quantity("tooth_y", "m", "tangent plane, second direction, over the whole tooth"),
    Quantity("tooth_gap", "m", "undeformed gap over the whole tooth"),
    Quantity("tooth_outline_x", "m", "outline of the tooth along x"),
    Quantity("tooth_outline_y", "m", "outline of the tooth along y"),
    Quantity("contact_path_x", "m", "path of the contact point along x"),
    Quantity("contact_path_y", "m", "path of the contact point along y"),
    Quantity("tooth_face", "m", "place on the wheel's flank along its face, from the middle"),
    Quantity("tooth_radius", "m", "position on the wheel flank: radius"),
    Quantity("thread_axial", "m",
        "place on the worm's thread along its axis, from the line of centres"),
    Quantity("thread_radius", "m", "place on the worm's thread: distance from the worm's axis"),
    Quantity("rim_face", "m", "outline of the wheel's flank along its face, from the middle"),
    Quantity("rim_radius", "m", "outline of the wheel flank: radius"),
    Quantity("marked_flank", "1", "the wheel's flank that the worm drives, and the other one"),
    Quantity("marking_place", "m", "place on the wheel's flank along its face, from the middle"),
    Quantity("marking_radius", "m", "position on the wheel flank: radius"),
    Quantity("marking_separation", "m",
        "minimum gap of a place of the flank over the mesh, without load"),
    Quantity("marking_fraction", "1", "part of the flank that marking compound shows"),
    Quantity("loaded_separation", "m",
        "minimum separation of a place of the flank over the mesh, under load"),
    Quantity("loaded_marking_fraction", "1",
        "part of the flank that marking compound shows under load"),
    Quantity("face", "m", "place on the wheel's flank along its face, from the middle"),
    Quantity("load_phase", "1", "place in the mesh cycle under load, continued where edges carry"),
    Quantity("tooth_load", "N", "normal load of a tooth pair"),
    Quantity("dry_tooth_load", "N", "normal load of a tooth pair without the separation by films"),
    Quantity("sliding_speed", "m/s", "velocity of the worm against the wheel at the contact point"),
    Quantity("sliding_lever", "m", "lever about the wheel's axis of a force along that velocity"),
    Quantity("error", "1", "entry of the design that is in error"),
    Quantity("side", "1", "sign of the error: less, as it is, more"),
    Quantity("error_size", "1", "size of the error in m or rad"),
    Quantity("varied_contact_face", "m", "middle of the dry contact along the wheel's face, with it"),
    Quantity("varied_contact_radius_on_wheel", "m", "its radius on the wheel"),
    Quantity("varied_radius_long", "m", "larger radius of relative curvature"),
    Quantity("varied_radius_short", "m", "smaller radius of relative curvature"),
    Quantity("varied_dry_pressure_max", "Pa", "maximum dry contact pressure"),
    Quantity("varied_formula_film", "m", "central film thickness by Nijenbanning, Venner and Moes"),
    Quantity("varied_contact_ratio", "1", "contact ratio"),
    Quantity("iteration", "1", "iteration, counted over all grids"),
    Quantity("points_x", "1", "grid points along x"),
    Quantity("points_y", "1", "grid points along y"),
    Quantity("krylov", "1", "inner iterations of the linear solver"),
    Quantity("convolutions", "1", "convolutions since the previous step"),
    Quantity("cycles", "1", "multigrid cycles since the previous step"),
    Quantity("convolution_seconds", "s", "CPU time of the convolutions"),
    Quantity("flow_seconds", "s", "CPU time of fields, flows and their changes"),
    Quantity("cycle_seconds", "s", "CPU time of the preconditioner, its building included"),
    Quantity("heat_seconds", "s", "CPU time of the columns of heat and of the walls"),
    Quantity("vector_seconds", "s",
        "CPU time of the linear solver's vectors and all else in a step"),
    Quantity("phase", "1", "place in the mesh cycle"),
    Quantity("section", "1", "section of the worm"),
    Quantity("station", "1", "place along the contact line, from its end nearer the wheel's axis"),
    Quantity("regime", "1", "regime of lubrication"),
    Quantity("roller_force", "N", "normal load of a roller"),
    Quantity("line_length", "m", "length of the contact line"),
    Quantity("roller_speed", "rad/s", "rotation of a roller about its own axis"),
    Quantity("rotation_time", "s", "time since the first touch"),
    Quantity("rotation_wheel_angle", "rad", "wheel angle of the roller"),
    Quantity("rotation_speed", "rad/s", "rotation of a roller about its own axis, with inertia"),
    Quantity("rotation_rolling", "rad/s", "rotation of a roller that does not slide in the mean"),
    Quantity("rotation_entrainment", "m/s", "entrainment velocity, mean over the load"),
    Quantity("rotation_film", "m", "central film thickness by Moes, mean over the load"),
    Quantity("spin_up_time", "s", "time until a roller rolls after its entry"),
    Quantity("spin_up_distance", "m", "sliding distance until then"),
    Quantity("spin_up_loss", "J", "sliding loss until then"),
    Quantity("rollers_in_mesh", "1", "rollers that touch the section"),
    Quantity("contact_radius", "m", "radius of relative curvature across the contact line"),
    Quantity("worm_velocity", "m/s", "velocity of the worm across the contact line, relative to it"),
    Quantity("roller_velocity", "m/s",
        "velocity of the roller across the contact line, relative to it"),
    Quantity("sliding_along", "m/s",
        "velocity of the worm relative to the roller along the contact line"),
    Quantity("lubrication_angle", "rad",
        "lubrication angle, between relative velocity and contact line"),
    Quantity("self_rotation_angle", "rad",
        "self-rotation angle, between relative velocity and roller axis"),
    Quantity("induced_curvature", "1/m", "induced normal curvature across the contact line"),
    Quantity("pin_radial", "N", "radial load of a roller's pin"),
    Quantity("pin_axial", "N", "thrust of a roller along its pin"),
    Quantity("relative_spin", "rad/s", "rotation of the worm relative to the roller about the normal"),
    Quantity("lever", "m", "lever of the normal load about the wheel's axis"),
    Quantity("viscosity_parameter", "1", "Johnson's g_V"),
    Quantity("elasticity_parameter", "1", "Johnson's g_E"),
    Quantity("regime_number", "1", "which regime, counted from 0"),
    Quantity("formula_film_min", "m", "minimum film thickness by Dowson and Higginson", "µm",
        extreme="minimum"),
    Quantity("formula_film_central", "m", "central film thickness by Moes"),
    Quantity("printed_film_min", "m", "minimum film thickness by the source's formula", "µm",
        extreme="minimum"),
    Quantity("film_by_regime", "m", "minimum film thickness by the formula of each regime"),
    Quantity("printed_film_by_regime", "1", "the source's formula of each regime with SI numbers"),
    Quantity("heated_share", "1",
        "film thickness with inlet heating over the isothermal one (Wilson and Sheu)"),
    Quantity("flank", "m", "worm flank in the axes of the gear set"),
    Quantity("roller_surface", "m", "rollers in the axes of the gear set"),
    Quantity("contact_line", "m", "contact line of a roller in mesh in the axes of the gear set"),
    Quantity("line_section", "1", "section of a contact line, counted from 0"),
    Quantity("line_force", "N", "load of a contact line"),
    Quantity("end", "1", "entry or exit of a section"),
    Quantity("varied_value", "1", "roller radius in m, throat coefficient, tilt in rad"),
    Quantity("varied_film", "m", "minimum film thickness by Dowson and Higginson with it"),
    Quantity("axis", "1", "axis of the gear set"),
    Quantity("worm_angle", "rad", "angle turned by the worm"),
    Quantity("wheel_angle", "rad", "angle turned by the wheel"),
    Quantity("point", "m", "contact point in the axes of the gear set"),
    Quantity("normal", "1", "common unit normal in the axes of the gear set"),
    Quantity("roll_angle", "rad", "roll angle of the pinion"),
    Quantity("pinion_velocity", "m/s", "velocity of the pinion's surface across the contact line"),
    Quantity("gear_velocity", "m/s", "velocity of the gear's surface across the contact line"),
    Quantity("unit_load", "N/m", "normal load for each length of the contact line"),
    Quantity("friction_load_factor", "1", "normal load with friction over that without"),
    Quantity("load_share", "1", "share of the normal force that the contact line carries"),
    Quantity("pinion_specific_sliding", "1", "sliding over the velocity of the pinion's surface"),
    Quantity("gear_specific_sliding", "1", "sliding of the gear's surface over its velocity"),
    Quantity("closed_form_hertz_pressure", "Pa", "maximum dry contact pressure"),
    Quantity("closed_form_film_central", "m", "central film thickness by Dowson and Toyoda"),
    Quantity("closed_form_film_min", "m", "minimum film thickness by Dowson and Higginson"),
    Quantity("closed_form_specific_film", "1", "specific film thickness lambda by that formula"),
    Quantity("closed_form_flash_temperature", "K", "Blok's flash temperature, a rise over the bulk's"),
    Quantity("closed_form_contact_temperature", "K", "bulk temperature and Blok's flash temperature"),
    Quantity("life_seconds", "s", "time since first contact, or since its history begins"),
    Quantity("life_phase", "1", "place in the mesh cycle"),
    Quantity("life_load", "N", "normal load"),
    Quantity("life_entrainment_x", "m/s", "mean velocity of the surfaces at the contact point along x"),
    Quantity("life_entrainment_y", "m/s", "mean velocity of the surfaces at the contact point along y"),
    Quantity("frame_seconds", "s", "time of the fields"),
    Quantity("frame_x", "m", "tangent plane, first direction from the contact point"),
    Quantity("frame_y", "m", "tangent plane, second direction from the contact point"),
    Quantity("frame_pressure", "Pa", "pressure", figure="pressure_max"),
    Quantity("frame_film", "m", "film thickness", figure="film_min"),
    Quantity("frame_rubbing", "W/m2", "asperity pressure times sliding velocity",
        figure="pressure_max"),
)  # fmt: skip
"""Other variables of fields, convergence histories and mesh cycles."""

OVER_LIFE = (
    "film_min", "film_central", "pressure_max", "friction_coefficient", "friction_boundary",
    "asperity_load_fraction", "power_loss", "shear_rate_max", "temperature_max_body_1",
    "temperature_max_body_2", "temperature_max_film",
)  # fmt: skip
"""Figures that a transient solution has over time."""

QUANTITIES = {
    quantity.name: quantity for quantity in (*EVERY_CONTACT, *MESH_CYCLE, *FIELDS, *IN_DATASETS)
}
"""Name -> quantity."""


SHOWN_AS = {"efficiency": "mesh_efficiency"}
"""Result of gears -> its name in `QUANTITIES`, where that differs."""


def quantity_of(name: str) -> Quantity:
    """How a result is shown; KeyError of one without an entry."""
    return QUANTITIES[SHOWN_AS.get(name, name)]


def listed(place: str) -> tuple[Quantity, ...]:
    """Quantities that a place shows, in their order.

    Places are "contact" and "figures", rows of a contact before and after it is solved; "film" and "heat",
    tables of all contacts; "key", the decisive figures; "sweep" and "picture", table and picture of a sweep;
    "explore", the page to explore.
    """
    return tuple(quantity for quantity in QUANTITIES.values() if place in quantity.places.split())


def read_key(key: str) -> tuple[str, float, str]:
    """A key of a JSON object as name, factor to the unit shown, and that."""
    for ending, (factor, unit) in KEY_UNITS.items():
        if key.endswith(ending):
            return key.removesuffix(ending), factor, unit
    return key, 1.0, ""


def attributes(name: str) -> dict[str, str]:
    """Unit and long name of a variable of a dataset; KeyError for one without an entry."""
    figure = name.removeprefix("life_").removesuffix("_error")
    if name.startswith("life_") and figure in OVER_LIFE:
        quantity = QUANTITIES[figure]
        before = "numerical uncertainty of: " if name.endswith("_error") else ""
    else:
        quantity, before = QUANTITIES[name], ""
    return {"units": quantity.unit, "long_name": f"{before}{quantity.words()}"}


def describe(dataset: "xr.Dataset") -> "xr.Dataset":
    """A copy of a dataset with units and long names of `QUANTITIES`; KeyError of a variable without."""
    described = dataset.copy()
    for name in described.variables:
        described[name].attrs.update(attributes(str(name)))
    return described
