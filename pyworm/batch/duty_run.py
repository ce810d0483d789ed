"""What a duty costs and damages: sums over its blocks, and solves of the loads that matter."""

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from pyworm.batch.duty import BlockFigures, DutyModel, Load, duty_model, mean_of_teeth
from pyworm.batch.in_python import CaseLike, as_case
from pyworm.batch.operating_points import NotSolvedError
from pyworm.drives.gear_unit import DAY, HOUR
from pyworm.formulas.unit_factors import ZERO_CELSIUS
from pyworm.io.input_error import CaseError
from pyworm.io.plain_values import MOST_COUNTED
from pyworm.io.present import present
from pyworm.io.shown import Shown
from pyworm.planning.plan import plan
from pyworm.result.contact_loss import contact_losses
from pyworm.result.tabulated_loss import TabulatedLoss, read_loss_table
from pyworm.solver.solve import solve

YEAR = 365 * DAY
"""A year [s]."""

ACCURACY = 0.1
"""Accuracy of the contacts that are solved [-]."""

EFFECTS = ("auto", "-squeeze")
"""Effects of the contacts that are solved: steady films."""

ENERGY = "energy"
"""Name of the energy lost beside what is damaged."""


@dataclass(frozen=True)
class ConfirmedLoad:
    """A load whose contacts were solved at its mean temperature."""

    block: str
    """Block of the load with the largest share."""
    temperature: float
    """Mean temperature of its teeth [K]."""
    tooth_loss: float
    """Solved loss between the teeth [W]."""
    error: float
    """Its relative numerical uncertainty [-]."""
    closed_form_loss: float
    """The loss before [W]."""
    film_min: float
    """Solved minimum film thickness [m]."""
    closed_form_film_min: float
    """That by closed forms [m]."""

    @property
    def deviation(self) -> float:
        """Loss before over the solved one, less 1 [-]."""
        return self.closed_form_loss / self.tooth_loss - 1

    def summary(self) -> dict[str, Any]:
        """The load as an object for JSON."""
        return {
            "block": self.block,
            "teeth_temperature_C": self.temperature - ZERO_CELSIUS,
            "tooth_loss_W": self.tooth_loss,
            "error": self.error,
            "closed_form_loss_W": self.closed_form_loss,
            "deviation": self.deviation,
            "film_min_m": self.film_min,
            "closed_form_film_min_m": self.closed_form_film_min,
        }


@dataclass(frozen=True, repr=False)
class CaseDuty(Shown):
    """A duty of a gear unit with all that it costs and damages."""

    name: str
    """Name of the case."""
    model: DutyModel
    """The gear unit at its loads; `history` has temperatures over time."""
    blocks: tuple[BlockFigures, ...]
    """Figures of each block."""
    confirmed: tuple[ConfirmedLoad, ...] = ()
    """Loads that were solved."""

    def shown(self) -> tuple[str, dict[str, str]]:
        """Heading and rows in words."""
        hottest = max(block.oil_max for block in self.blocks)
        return self.heading, {
            "blocks": f"{len(self.blocks)}",
            "duration": f"{self.model.cycle.duration / HOUR:.4g} h",
            "maximum oil temperature": f"{hottest - ZERO_CELSIUS:.4g} °C",
            "energy lost": f"{self.energy_lost / 3.6e6:.4g} kWh",
            **{name: f"Miner sum 1 after {hours:.4g} h" for name, hours in self.lives_h.items()},
        }

    @property
    def heading(self) -> str:
        """What it is, and what films and losses of the teeth rest on."""
        by = "films by closed forms, losses" if self.model.tabulated else "films and losses"
        rest = "a loss table" if self.model.tabulated else "closed forms"
        solved = (
            f"; losses of {len(self.confirmed)} of {len(self.model.loads)} loads solved"
            if self.confirmed
            else ", no contact solved"
        )
        return f"Duty of {self.name}, {by} by {rest}{solved}"

    @property
    def periods_per_year(self) -> float | None:
        """How often the duty repeats in a year; None of one that begins cold."""
        return YEAR / self.model.cycle.duration if self.model.cycle.periodic else None

    @property
    def energy_lost(self) -> float:
        """Energy lost in the duty [J]."""
        return float(self.model.history.dissipated[-1])

    @property
    def energy_out(self) -> float:
        """Work of the second shaft in the duty [J]."""
        return sum(
            block.torque
            * present(self.model.loads[block.load].drive.rotors, "rotors")[1].speed
            * block.duration
            for block in self.model.cycle.blocks
            if block.running
        )

    @property
    def imbalance(self) -> float:
        """Energy lost less the heat given off and stored, over the energy lost [-].

        A duty that repeats stores none.
        """
        history = self.model.history
        stored = 0.0 if self.model.cycle.periodic else history.stored
        return abs(history.supplied - stored) / self.energy_lost

    @property
    def damage(self) -> dict[str, float]:
        """What is damaged -> share of its life that the duty takes once (Miner)."""
        return _summed([block.damage for block in self.blocks])

    @property
    def wear(self) -> dict[str, float]:
        """Gear body -> wear depth in the duty [m]."""
        return _summed([block.wear for block in self.blocks])

    @property
    def lives_h(self) -> dict[str, float]:
        """What is damaged -> hours of the duty until its Miner sum is 1 [h]."""
        hours = self.model.cycle.duration / HOUR
        return {name: hours / part for name, part in self.damage.items() if part > 0}

    @property
    def shares(self) -> dict[str, tuple[float, ...]]:
        """What is damaged, and the energy lost -> the part of each block in it [-]."""
        found = {
            name: tuple((block.damage or {}).get(name, 0.0) / part for block in self.blocks)
            for name, part in self.damage.items()
            if part > 0
        }
        energy = tuple(block.energy_lost / self.energy_lost for block in self.blocks)
        return found | {ENERGY: energy}

    @property
    def decisive(self) -> dict[str, str]:
        """What is damaged, and the energy lost -> name of the block with the largest part."""
        return {
            name: self.blocks[max(range(len(parts)), key=parts.__getitem__)].name
            for name, parts in self.shares.items()
        }

    def summary(self) -> dict[str, Any]:
        """All of it as one object, as `pyworm duty --json` prints it."""
        history, times = self.model.history, self.periods_per_year
        sums = {
            "energy_lost_J": self.energy_lost,
            **{f"wear_{name}_m": depth for name, depth in self.wear.items()},
        }
        return {
            "case": self.name,
            "duration": self.model.cycle.duration / HOUR,
            "periodic": self.model.cycle.periodic,
            "blocks": [_block_summary(block) for block in self.blocks],
            **sums,
            "energy_out_J": self.energy_out,
            **(
                {}
                if times is None
                else {f"{key}_per_year": times * each for key, each in sums.items()}
            ),
            "damage": self.damage,
            "life_h": self.lives_h,
            "decisive_block": self.decisive,
            "imbalance": self.imbalance,
            "confirmed": [each.summary() for each in self.confirmed],
            "not_rated": list(self.not_rated),
            "time_h": (history.time / HOUR).tolist(),
            **{
                f"{node.replace(' ', '_')}_temperature_C": (values - ZERO_CELSIUS).tolist()
                for node, values in history.temperatures.items()
            },
        }

    @property
    def not_rated(self) -> tuple[str, ...]:
        """What is not rated, each with the reason."""
        return tuple(dict.fromkeys(why for block in self.blocks for why in block.not_rated))


def _summed(parts: list[Mapping[str, float] | None]) -> dict[str, float]:
    """Sums by name over blocks; those at rest have none."""
    total: dict[str, float] = {}
    for part in parts:
        for name, value in (part or {}).items():
            total[name] = total.get(name, 0.0) + value
    return total


_BLOCK_KEYS = {
    "torque": "torque_N_m",
    "speed": "speed_rad_s",
    "energy_lost": "energy_lost_J",
    "tooth_loss": "tooth_loss_W",
    "film_min": "film_min_m",
    "wear": "wear_m",
}
"""Name of a figure of a block -> its key in JSON, where that has a unit."""


def _block_summary(block: BlockFigures) -> dict[str, Any]:
    """A block as an object for JSON: SI, but for times in h and temperatures in degC."""
    found = {_BLOCK_KEYS.get(name, name): value for name, value in asdict(block).items()}
    hours = {f"{name}_h": found.pop(name) / HOUR for name in ("start", "duration")}
    celsius = {
        f"{node.replace(' ', '_')}_temperature_C": value - ZERO_CELSIUS
        for node, value in found.pop("temperatures").items()
    }
    del found["not_rated"]
    hottest = found.pop("oil_max") - ZERO_CELSIUS
    return {
        "name": found.pop("name"),
        **hours,
        **found,
        **celsius,
        "oil_temperature_max_C": hottest,
    }


def duty(
    case: CaseLike,
    *,
    table: str | Path | None = None,
    solve_loads: int = 0,
    progress: Callable[[str], None] = lambda words: None,
) -> CaseDuty:
    """Temperatures, losses and damage of a gear unit over its `[duty]`, as the command `pyworm duty`.

    Args:
        case: A gear set with its `duty` and the housing of its `cooling`, its file or its tables.
        table: CSV file of `pyworm table`, by which teeth lose instead of by closed forms.
        solve_loads: Number of loads, those with the largest parts in a damage or the energy first, whose
            contacts are solved; the loss of each is corrected, and temperatures are found anew.
        progress: Called with what is being done, in words.

    Raises:
        CaseError: Invalid input, or a case whose losses or temperatures are not found.
        NotSolvedError: A contact did not converge.
    """
    checked_case = as_case(case)
    if not 0 <= solve_loads <= MOST_COUNTED:
        raise CaseError(f"solve_loads = {solve_loads}: must be a number of loads, 0 or more")
    given = None if table is None else _table(Path(table))
    model = duty_model(checked_case, given)
    try:
        found = CaseDuty(checked_case.name, model, tuple(model.blocks()))
        if not solve_loads:
            return found
        confirmed = tuple(
            _confirmed(found, load, progress) for load in _heaviest(found)[:solve_loads]
        )
        factors = {load: each.tooth_loss / each.closed_form_loss for load, each in confirmed}
        corrected = {
            load: state.corrected(factors.get(load, 1.0)) for load, state in model.loads.items()
        }
        model = replace(model, loads=corrected)
        solved = tuple(each for _, each in confirmed)
        return CaseDuty(checked_case.name, model, tuple(model.blocks()), solved)
    except ValueError as error:
        raise CaseError(f"{checked_case.name}: {error}") from error


def _table(path: Path) -> TabulatedLoss:
    try:
        return read_loss_table(path)
    except ValueError as error:
        raise CaseError(f"{path}: {error}") from error


def _heaviest(found: CaseDuty) -> list[Load]:
    """Loads by their largest part in a damage or the energy, the largest first."""
    blocks = found.model.cycle.blocks

    def part(load: Load) -> float:
        return max(
            sum(share for block, share in zip(blocks, shares, strict=True) if block.load == load)
            for shares in found.shares.values()
        )

    return sorted(found.model.loads, key=part, reverse=True)


def _confirmed(
    found: CaseDuty, load: Load, progress: Callable[[str], None]
) -> tuple[Load, ConfirmedLoad]:
    """A load with its contacts solved at the mean temperature of its longest block."""
    state = found.model.loads[load]
    pairs = zip(found.model.cycle.blocks, found.blocks, strict=True)
    block = max(
        (figures for each, figures in pairs if each.load == load),
        key=lambda figures: figures.duration,
    )
    temperature = mean_of_teeth(state.unit.rotors, block.temperatures)
    solutions = []
    for scene in state.friction.warmed(temperature):
        progress(f"solving {block.name}: {scene.name}")
        solution = solve(scene, plan(scene, ACCURACY, EFFECTS))
        if not solution.converged:
            raise NotSolvedError(
                f"{block.name}, {scene.name} did not converge: {solution.stop_reason}"
            )
        solutions.append(solution)
    loss = present(state.drive.mesh_loss(contact_losses(solutions)), "loss")
    closed = state.friction.at(temperature)
    before = present(state.unit.tooth_loss_at, "tooth_loss_at")(block.temperatures)
    return load, ConfirmedLoad(
        block=block.name,
        temperature=temperature,
        tooth_loss=loss.loss,
        error=loss.error,
        closed_form_loss=before,
        film_min=min(solution.figures.film_min.value for solution in solutions),
        closed_form_film_min=closed.film_min,
    )
