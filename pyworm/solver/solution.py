"""The result of one solve: fields, figures with error bars, convergence history and cost."""

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields, is_dataclass, replace
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np

from pyworm.formulas.layered_half_space import Layer
from pyworm.formulas.regimes import Regime
from pyworm.formulas.thermal_stress import ThermalSolid
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.on_demand import attribute_of, lazy_property
from pyworm.io.on_demand import xarray as xr
from pyworm.io.plain_dataset import PlainDataset, held, reads_as_xarray, same_data
from pyworm.io.quantities import QUANTITIES, Quantity
from pyworm.io.quantity_text import with_bars
from pyworm.io.shown import Shown
from pyworm.planning.effects.judgement import Judgement
from pyworm.planning.no_friction import no_friction
from pyworm.scene.index import ContactIndex
from pyworm.solver.ending import Ending
from pyworm.solver.estimate import ORIGINS, Estimate, in_words
from pyworm.solver.neglected_effects import NeglectedEffects, judged
from pyworm.solver.oil_supply import SupplyFigures


@dataclass(frozen=True)
class DryFigures:
    """Figures of the dry contact under the same load."""

    pressure_max: float
    """Maximum pressure [Pa]."""
    length: float
    """Extent of the contact along its long direction [m]."""
    width: float
    """Extent of the contact across its long direction [m]."""
    approach: float
    """Rigid approach [m]."""


@dataclass(frozen=True)
class StressFigures:
    """Largest stresses below both surfaces, and what they depend on besides the fields."""

    von_mises_max_body_1: Estimate
    """Maximum equivalent stress of von Mises in body 1 [Pa]."""
    von_mises_max_body_2: Estimate
    """That in body 2 [Pa]."""
    depth_body_1: float
    """Depth of the maximum in body 1 [m]."""
    depth_body_2: float
    """That in body 2 [m]."""
    poisson_ratios: tuple[float, float]
    """Poisson's ratio of each body [-]."""
    boundary_friction: float
    """Friction coefficient of asperities [-]."""
    coatings: tuple[Layer | None, Layer | None] = (None, None)
    """Layer on each body; None of a bare one."""
    heated: tuple[ThermalSolid, ThermalSolid] | None = None
    """Thermal constants of both bodies, of a stress with that of heat; None without."""
    fatigue_ratio_max_body_1: float | None = None
    """Maximum of Dang Van's equivalent stress in body 1 over its limit [-]; None without fatigue limits."""
    fatigue_ratio_max_body_2: float | None = None
    """That in body 2 [-]."""


@dataclass(frozen=True, repr=False)
class Figures(Shown):
    """The figures of one lubricated contact."""

    film_min: Estimate
    """Minimum film thickness [m] (sub-grid)."""
    film_central: Estimate
    """Film at the contact point [m]."""
    pressure_max: Estimate
    """Maximum pressure [Pa]."""
    film_min_at: tuple[float, ...]
    """Position of the minimum film thickness [m]: (x, y) along the grid, or (x,) of a line contact."""
    moes_m: float
    """Moes' load parameter along the entrainment."""
    moes_l: float
    """Moes' lubricant parameter along the entrainment."""
    load_error: float
    """Relative load imbalance."""
    mass_error: float
    """Net over gross mass flow through the outline of the contact."""
    residual: float
    """Summed Reynolds residual over the summed Couette flow, at the end."""
    film_min_kind: str = "exit"
    """Location of the minimum film thickness: "side lobe", "exit" (of all line contacts) or "middle"."""
    film_exit_min: float | None = None
    """Minimum film thickness on the entrainment line through the contact point [m]; None for a line
    contact, where it is the minimum film thickness."""
    film_exit_min_at: float | None = None
    """Place of that film on the entrainment line [m]; None for a line contact."""
    lift: float | None = None
    """Increase of the rigid separation of the bodies by the film under the same load [m]; None for a line
    contact, which has no approach."""
    dry: DryFigures | None = None
    """The dry contact; None for a line contact, where it is Hertz's in closed form."""
    friction_coefficient: Estimate | None = None
    """Friction over load along the sliding [-]; None where the shear of the film was not computed. Friction
    counts where both surfaces exist and the pressure is above 1 % of the largest. It is the sum there of the
    shear stress in the middle of the film, of oil and asperities, times the area of a node, over the whole
    load, a part of which may lie beyond the domain of the fields."""
    power_loss: Estimate | None = None
    """Work of the friction [W] (of a line contact for each length [W/m]), which counts like it; None where
    the shear of the film was not computed."""
    shear_rate_max: Estimate | None = None
    """Largest shear rate [1/s], which counts where the friction does; None where the shear of the film was
    not computed."""
    temperature_max_body_1: Estimate | None = None
    """Maximum temperature of the surface of body 1 [K], the error relative to the rise over the inlet
    temperature; None where heat was not simulated."""
    temperature_max_body_2: Estimate | None = None
    """Maximum temperature of the surface of body 2, likewise [K]."""
    temperature_max_film: Estimate | None = None
    """Maximum temperature inside the film, likewise [K]."""
    asperity_load_fraction: Estimate | None = None
    """Share of the load that asperities carry [-]; None where roughness was not simulated."""
    friction_boundary: Estimate | None = None
    """Part of the friction coefficient by the friction of asperities [-]; None where roughness was not
    simulated."""
    supply: SupplyFigures | None = None
    """What a limited supply of oil does; None where starvation was not simulated."""
    heat_balance: float | None = None
    """Relative imbalance: heat into the bodies and the oil, less the work of friction, over that work."""
    stress: StressFigures | None = None
    """Stress below the surfaces; None where it was not requested."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the figures in words."""
        power_loss = "power_loss" if self.dry else "power_loss_per_length"  # of a line contact
        return "Figures", {
            name: in_words(figure, QUANTITIES[power_loss if name == "power_loss" else name])
            for name, figure in self
        }

    def __iter__(self) -> Iterator[tuple[str, Estimate]]:
        """Name and figure of each simulated result that has uncertainties."""
        return (
            (name, figure) for name, figure in vars(self).items() if isinstance(figure, Estimate)
        )

    def to_dict(self) -> dict[str, Any]:
        """All that was simulated in SI under flat names, a row of a table.

        Figures are numbers, `film_min`, with their relative uncertainties `film_min_error` and, where the
        model has one, `film_min_model`; those of the dry contact begin with `dry_`.
        """
        flat: dict[str, Any] = {}
        for name, value in vars(self).items():
            if isinstance(value, Estimate):
                flat |= {name: value.value, f"{name}_error": value.error}
                flat |= {} if value.model is None else {f"{name}_model": value.model}
            elif is_dataclass(value):
                flat |= {
                    f"{name}_{part}": number
                    for part, number in vars(value).items()
                    if np.isscalar(number)
                }
            elif value is not None:
                flat[name] = value
        return flat

    def values(self) -> dict[str, float]:
        """Values of the simulated results that have uncertainties, by name."""
        return {name: figure.value for name, figure in self}


@dataclass(frozen=True)
class Cost:
    """Cost of a solve."""

    seconds: float
    """Elapsed time of the film solve, all grids [s]."""
    convolutions: float
    """Processor time of the film solve, in padded FFT convolutions on the finest grid."""
    unit_seconds: float = 0.0
    """Processor time of one such convolution [s]."""
    transient_solves: int = 0
    """Transient solves of its life whose rates of change its film took; 0 of a steady film."""

    @property
    def processor_seconds(self) -> float:
        """Processor time of the film solve [s]."""
        return self.convolutions * self.unit_seconds


DATASETS = ("fields", "history", "profile", "life")
"""Attributes of a solution that are datasets."""


@reads_as_xarray(*DATASETS)
@dataclass(frozen=True, repr=False)
class Solution(Shown):
    """One solved scene: its figures, its fields and what they rest on."""

    name: str
    """The scene's name."""
    kind: Literal["point", "line"]
    """Kind of contact: "point" or "line"."""
    phase: float | None
    """Place in the mesh cycle."""
    load: float
    """Normal load [N], of a line contact that for each length [N/m]."""
    converged: bool
    """Whether the figures may be trusted within their uncertainties, which may be larger than requested
    (`accurate`)."""
    ending: Ending
    """How the solve ended."""
    stop_reason: str
    """Its message: the reason why the solver stopped."""
    figures: Figures
    """Scalars."""
    regime: Regime
    """The regime of lubrication."""
    fields: "xr.Dataset"
    """Fields over (y, x) in SI with units, in single precision: gap, covered, dry_pressure, pressure, film,
    entrainment_x, entrainment_y, sliding_x, sliding_y. Where the shear of the film was computed also
    shear_stress_x, shear_stress_y, shear_rate, friction_power, slip, flow_factor_sliding, flow_factor_across;
    where heat was simulated temperature_body_1, temperature_body_2, temperature_middle; where roughness was
    simulated asperity_pressure, real_area; where starvation was oil_fraction. Those of a line contact are
    over x, and have no dry_pressure and nothing along y."""
    history: "xr.Dataset"
    """Over iteration: points_x, points_y (not of a line contact), residual, load_error, krylov; of a point
    contact also the work of each step: convolutions, cycles and processor times by part."""
    cost: Cost
    """Time taken."""
    inlet_temperature: float | None = None
    """Temperature of the oil at the inlet [K]; None where heat was not simulated."""
    slide_roll_ratio: float | None = None
    """Place on a traction curve [-]."""
    section: str | None = None
    """Section of a worm that has two."""
    station: float | None = None
    """Place along the contact line, 0 to 1."""
    composite_roughness: float | None = None
    """Root mean square height of both surfaces together [m]; None if it is not known."""
    profile: "xr.Dataset | None" = None
    """Over level, across the film at its maximum temperature: level_position, profile_temperature,
    profile_velocity_x, profile_velocity_y; and profile_x, profile_y, its place (no y of a line contact). None
    where heat was not simulated."""
    life: "xr.Dataset | None" = None
    """Over instant, of a transient film since the contact solved before it, or since its first touch:
    life_seconds, life_phase, life_load, and by the name of a quantity life_NAME and life_NAME_error; over
    frame and nodes: frame_seconds, frame_x, frame_y, frame_pressure, frame_film (no y of a line contact), of
    rough surfaces frame_rubbing. They are of the transient solve's own grids. None of a steady film."""
    effects: tuple[Judgement, ...] = ()
    """Every effect, judged by the solved figures."""
    accuracy: float = 0.0
    """Requested relative error [-]; 0 where it is not known, so that every neglected effect counts."""
    accuracy_of: tuple[str, ...] = ()
    """Names of the figures to which it refers (`pyworm.planning.target.AccuracyTarget`); empty where that is
    not known."""

    solved: Any = field(default=None, compare=False)
    """The contact and its plan; None of a solution from a file."""

    plot = lazy_property(
        "pyworm.plots.of_solution", "Pictures", "Its pictures, such as `solution.plot.film()`."
    )

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows of the solution in words."""
        figures = self.figures.shown()[1]
        films = {name: figures.pop(name) for name in ("film_min", "film_central")}
        state = "converged" if self.converged else "not converged"
        if self.accurate:
            state = "accurate"
        plain = self.ending is Ending.ACCURATE
        return f"Solution {self.name}", {
            "status": state if plain else f"{state} ({self.stop_reason})",
            **films,
            **figures,
            "regime": self.regime.words,
            "grid": " x ".join(str(self._sizes[axis]) for axis in self._axes),
            "effects": ", ".join(effect.name for effect in self.effects if effect.on),
        }

    @property
    def _sizes(self) -> Mapping[Any, int]:
        return self.dataset("fields").sizes

    @property
    def _axes(self) -> tuple[str, ...]:
        return ("x", "y") if self.kind == "point" else ("x",)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Solution):
            return NotImplemented
        plain = (part.name for part in fields(self) if part.compare and part.name not in DATASETS)
        return all(getattr(self, name) == getattr(other, name) for name in plain) and all(
            same_data(getattr(self, name), getattr(other, name)) for name in DATASETS
        )

    def __hash__(self) -> int:
        return hash((self.name, self.kind, self.load, self.converged, self.figures))

    @property
    def accurate(self) -> bool:
        """Whether the figures have the requested accuracy."""
        return self.ending.accurate

    @property
    def neglected_effects(self) -> NeglectedEffects:
        """Effects neglected in the results; the lubrication of a film that did not converge is unknown."""
        figures = self.figures
        films = (figures.film_central.value, figures.film_min.value) if self.converged else ()
        share = figures.asperity_load_fraction
        return judged(
            self.effects,
            self.accuracy,
            films,
            self.composite_roughness,
            (share.value, share.model) if share is not None and self.converged else (None, None),
        )

    def held(self, part: str) -> "PlainDataset | xr.Dataset | None":
        """One of `DATASETS` as it is held: xarray is not loaded for it."""
        return held(self, part)

    def dataset(self, part: str) -> "PlainDataset | xr.Dataset":
        """One of `DATASETS` as it is held; ValueError where it has none."""
        held = self.held(part)
        if held is None:
            raise ValueError(f"{self.name}: has no {part}")
        return held

    def changed(self, **changes: Any) -> "Solution":
        """The solution with other values of some attributes; xarray is not loaded for it."""
        return replace(self, **{part: self.held(part) for part in DATASETS} | changes)

    def sensitivities(self, inputs: Sequence[str] | None = None) -> Any:
        """Sensitivities of the figures to the contact's inputs, as of `pyworm.sensitivities`.

        ValueError of a solution from a file, whose contact is not in it, besides.
        """
        if self.solved is None:
            raise ValueError(
                f"{self.name}: read from a file, which has no contact; "
                "use pyworm.sensitivities(case.scene(...)) with its case"
            )
        scene, plan = self.solved
        find: Callable[..., Any] = attribute_of("pyworm.solver.sensitivities", "sensitivities")
        return find(scene, plan, self, inputs=inputs)

    def stress(
        self, body: int = 1, depths: Sequence[Any] | Any = None, thermal: bool | None = None
    ) -> Any:
        """Stress below the surface of body 1 or 2 at depths, by default down to twice the half-width.

        With that of the surface temperature where it is `thermal`.

        ValueError as of `pyworm.solver.stress.subsurface.subsurface_stress`, which makes it.
        """
        find: Callable[..., Any] = attribute_of(
            "pyworm.solver.stress.subsurface", "subsurface_stress"
        )
        return find(self, body, depths, thermal)

    def fatigue(self, body: int = 1, strength: Any = None, thermal: bool | None = None) -> Any:
        """Dang Van's fatigue stress of the material of body 1 or 2 that passes through the contact.

        ValueError as of `pyworm.solver.stress.fatigue.fatigue_pass`, which makes it.
        """
        find: Callable[..., Any] = attribute_of("pyworm.solver.stress.fatigue", "fatigue_pass")
        return find(self, body, strength, thermal)

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write one NetCDF file, which `pyworm.open_solution` and the commands read; returns its path."""
        write: Callable[..., Path] = attribute_of("pyworm.result.result", "save_solution")
        return write(self, path)

    def summary(self) -> dict:
        """The scalars of this solution as one object, units in the keys, neglected effects first.

        Places and grids are lists with an entry for each direction, [x, y] or [x]; temperatures are objects
        with an entry for each body and the film. Values that are not simulated, not known or not defined for
        the kind of contact have no key.
        """
        summary: dict[str, Any] = {
            "name": self.name,
            "kind": self.kind,
            **asdict(ContactIndex.of(self)),
            **self.neglected_effects.summary(),
            "converged": self.converged,
            "accurate": self.accurate,
            "stop_reason": self.stop_reason,
            **(
                {"accuracy": self.accuracy, "accuracy_of": list(self.accuracy_of)}
                if self.accuracy_of
                else {}
            ),
        }
        for quantity in QUANTITIES.values():
            value = quantity.value_in(self)
            if isinstance(value, Estimate) and quantity.unit == "K":
                for key, part in self._in_celsius(quantity, value).items():
                    summary.setdefault(key, {}).update(part)
            elif value is not None:
                summary |= _flat(quantity, value)
        reason = no_friction(self.effects) if self.figures.friction_coefficient is None else ""
        return {
            **summary,
            **({"friction_coefficient_reason": reason} if reason else {}),
            **self.regime.summary(),
            "grid": [self._sizes[axis] for axis in ("x", "y") if axis in self._sizes],
            "effects": [effect.name for effect in self.effects if effect.on],
        }

    def figure_text(self, quantity: Quantity) -> str:
        """A result with its unit and uncertainties (temperatures: K); empty without it, or unconverged."""
        figure = quantity.value_in(self)
        if figure is None or not self.converged:
            return ""
        if not isinstance(figure, Estimate | Ratio):
            return figure if isinstance(figure, str) else quantity.text(figure)
        if isinstance(figure, Estimate):
            return in_words(figure, quantity, self.rise(figure))
        value = quantity.text(figure.value)
        return with_bars(value, figure.error, figure.model, reason=figure.reason)

    @property
    def specific_film(self) -> "Ratio | None":
        """Minimum film thickness over composite roughness [-]; None without a roughness or a film."""
        film = self.figures.film_min
        if self.composite_roughness is None or not self.converged:
            return None
        ratio = film.value / self.composite_roughness
        return Ratio(ratio, film.error, film.model, film.reason)

    @property
    def friction_fluid(self) -> float | None:
        """Part of the friction coefficient by the oil [-]; None where roughness was not simulated."""
        whole, rubbing = self.figures.friction_coefficient, self.figures.friction_boundary
        return None if whole is None or rubbing is None else whole.value - rubbing.value

    @property
    def supply_ratio(self) -> "Ratio | None":
        """Oil supplied over that of the flooded film [-]; None where starvation was not simulated."""
        supply = self.figures.supply
        return None if supply is None else Ratio(supply.supply_ratio, supply.flooded_error)

    @property
    def film_over_flooded(self) -> "Ratio | None":
        """Central film thickness over the flooded one [-]; None where starvation was not simulated."""
        supply, film = self.figures.supply, self.figures.film_central
        if supply is None:
            return None
        return Ratio(supply.film_over_flooded, film.error + supply.flooded_error)

    def rise(self, temperature: Estimate) -> float:
        """Rise of a temperature, to which its errors are relative, above the colder body's [K].

        Where that is not stored with it, above the inlet's.
        """
        return abs(temperature.value - (temperature.datum or self.inlet_temperature or 0.0))

    def _in_celsius(self, quantity: Quantity, temperature: Estimate) -> dict[str, dict[str, float]]:
        """A temperature [°C] and its uncertainties [K], each beneath the key of the object of all."""
        name, _, place = quantity.key.partition("_C_")
        rise, model = self.rise(temperature), temperature.model
        return {
            f"{name}_C": {place: temperature.value - ZERO_CELSIUS},
            f"{name}_error_K": {place: temperature.error * rise},
            **({} if model is None else {f"{name}_model_error_K": {place: model * rise}}),
        }


class Ratio(NamedTuple):
    """A figure that follows from others [-], with their relative uncertainties and the reason of no bound."""

    value: float
    error: float
    model: float | None = None
    reason: str | None = None


def _flat(quantity: Quantity, value: Any) -> dict[str, Any]:
    """A figure, its error bar, the parts of that and the reason of an infinite one under flat names."""
    if not isinstance(value, Estimate | Ratio):
        shown = value - ZERO_CELSIUS if quantity.unit == "K" else value
        return {quantity.key: list(shown) if isinstance(shown, tuple) else shown}
    name, unit = quantity.figure, quantity.key.removeprefix(quantity.figure)
    model = {} if value.model is None else {quantity.model_key: value.model}
    if isinstance(value, Ratio):
        return {quantity.key: value.value, quantity.error_key: value.error, **model}
    return {
        quantity.key: value.value,
        **({} if value.on_grid is None else {f"{name}_on_grid{unit}": value.on_grid}),
        quantity.error_key: value.error,
        **{f"{quantity.error_key}_{part}": getattr(value, part) for part in ORIGINS},
        **model,
        **({} if value.reason is None else {f"{quantity.error_key}_reason": value.reason}),
    }
