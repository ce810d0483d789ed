"""Base of the solvers of point and line contacts, by nested iteration.

A solver makes the films of one kind of contact on grids of halving spacing, adds shear and heat to them, and
reads figures and fields from the last one. `pyworm.solver.grid_sequence` decides how far grids are refined.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from copy import copy
from dataclasses import replace
from math import hypot, log, log2, sqrt
from typing import Any, ClassVar, Generic, TypeVar

from pyworm.formulas.arrays import Array
from pyworm.io.present import present
from pyworm.kernel import DryContact
from pyworm.kernel.film import SLIP_STEP
from pyworm.kernel.interpolation import at_levels
from pyworm.materials.body import Body
from pyworm.materials.flow_laws import NEWTONIAN, FlowLaw
from pyworm.planning.discretisation import PLANS
from pyworm.planning.expected_work import Kind
from pyworm.planning.plan import Plan
from pyworm.planning.prediction import predicted
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.scene.scales import LineScales, Scales
from pyworm.scene.waves import moving_waves
from pyworm.solver import figures as figures_of_grid
from pyworm.solver.arrival_uncertainty import arrival_uncertainty
from pyworm.solver.ending import Ending
from pyworm.solver.error_estimate import Convergence, Reading
from pyworm.solver.level import InitialGuess, Level, TransientTerm
from pyworm.solver.newton import Iteration, NewtonStep, converge, iterate
from pyworm.solver.oil_supply import supply_figures
from pyworm.solver.oil_uncertainty import oil_uncertainty
from pyworm.solver.outcome import Outcome, fields, heat_balance, profile
from pyworm.solver.roughness_uncertainty import neglected_waves, roughness_uncertainty
from pyworm.solver.vortex_heat import temperature_varies

COARSE_TOLERANCE = 1e-4
"""Residual at which a grid outside the figures is refined, and at which a Newtonian film is sheared."""

MAX_STRESS_FACTOR = 16.0
"""First factor of the stress continuation: stresses of the flow law over those of the oil."""

STRESS_RATIO, MIN_STRESS_RATIO, MIN_STRESS_RATIO_HEATED = 2.0, 1.05, 1.0005
"""First and least ratio of successive stresses in the continuation; its root is taken if a film is lost.

A heated film bears smaller stresses than the cold one from which it began."""

STRESS_RATIO_GROWTH = 1.2
"""Power to which the ratio is raised after a film that was found."""

MOST_STAGE_NODES = 1.5e7
"""Nodes times the films that the continuation of a heated film has still to find at a ratio below
`MIN_STRESS_RATIO`, up to which it goes on. First grids may creep; on 897 x 385 nodes, begun anew, it had come
to 1.05 times the oil's stresses after 20 minutes, at a ratio of 1.001 (`tests/hard`, seed 99015, drive 6)."""

SLIP_WIDENING = 0.2
"""Growth of the slip step with the factor of the stresses.

Where both walls slip, the pressure gradient follows the limiting stress, and a change of that by a slip step
changes the flow e-fold. With the step of the law itself, a thousandth, gradients would have to follow in
hundreds of films. Under larger stresses the step is wider, and narrows to that of the law as they fall, like
the barrier of an interior-point method (Nocedal and Wright 2006, chapter 19)."""

LARGER_STRESS_FACTORS = (2.0, 8.0)
"""Factors of the stresses from which a heated film that does not settle is softened once more, in order."""

ROUGHENED_TOLERANCE = 1e-2
"""Residual at which the film of smooth surfaces becomes one between rough ones, and that one gets its law of
flow: either changes it by more."""

CONTINUATION_STEPS = 12
"""Largest number of Newton steps from one film of the continuation to the next."""

HEATED_TOLERANCE = 1e-2
"""Residual of a heated film, and change of its temperature, at which the stress continuation advances."""

UNUSABLE_START_RESIDUAL = 1.0
"""Residual beyond which a film is no initial guess for a finer grid: its pressure gradients need more stress
than the limiting stress of the oil, so that its slip is unbounded."""

FED_FALLS: tuple[float, float] = (2.0, 5.0)
"""Ratios of successive errors of films to which oil comes in a layer: of first order, or of second with one
of first order against it. On two grids an error of up to the whole last change follows."""

ContactT = TypeVar("ContactT", Scene, LineScene)
LevelT = TypeVar("LevelT", bound=Level)


class ContactSolver(ABC, Generic[ContactT, LevelT]):
    """Films of one contact on grids of halving spacing, steady without a transient term."""

    kind: ClassVar[Kind]
    """Kind of contact in results: "point" or "line"."""
    level_type: ClassVar[type[Level]]
    """Class of its levels."""
    shear_tolerance: ClassVar[float]
    """Residual of the sheared film from which it is heated."""
    convergence: Convergence
    """Orders and window errors of its figures."""
    _size: Scales | LineScales

    def __init__(self, scene: ContactT, plan: Plan, transient_term: TransientTerm | None = None):
        self._scene: ContactT = scene
        self._plan = plan
        self._model = plan.model
        self._transient_term = transient_term
        self._rough = scene.rough_pair if plan.model.rough else None
        self._curves = None if self._rough is None else self._rough.curves()
        self.origins = (
            dict.fromkeys(HEAT_FIGURES, scene.oil.thermal.inlet_temperature + scene.coldest)
            if self._model.heated
            else {}
        )
        """Offset of each figure whose reading has another origin, such as the inlet temperature [K]."""

    @abstractmethod
    def begin(self, grids: Sequence[Any]) -> tuple[LevelT, list[NewtonStep]]:
        """Solve the grids by nested iteration up to the last one, on which the film is not yet settled."""

    def in_wider_window(
        self, grids: Sequence[Any], narrow: LevelT
    ) -> tuple[LevelT, list[NewtonStep]]:
        """Solve wider windows to the spacing of a level."""
        level, steps = self.begin(grids)
        for _ in range(self._refinements_between(level, narrow)):
            steps += iterate(level, self._plan.tolerance)
            level, further = self.refined(level)
            steps += further
        return level, steps

    def converged(self, level: LevelT, plan: Plan, algebra_wanted: float) -> Iteration:
        """The end of Newton's iteration on a grid of the figures, as of `newton.converge`.

        Where the film is found its reading is `_resolved`.
        """
        found = converge(level, plan.tolerance, plan.target, algebra_wanted)
        if level.film.balance.worst > plan.tolerance:
            return found
        return replace(found, reading=self._resolved(level, found.reading))

    def _resolved(self, level: LevelT, reading: Reading) -> Reading:
        """The reading of a film, its minimum on finer grids where the grid does not resolve it."""
        return reading

    def cut_off(self, narrow: LevelT, wider: LevelT) -> dict[str, float]:
        """Relative parts of friction and loss in a wider window that a narrower one cuts off, if any."""
        return {}

    @staticmethod
    def _refinements_between(coarse: LevelT, fine: LevelT) -> int:
        """Number of halvings from the spacing of one level to that of another."""
        return round(log2(coarse.grid.spacing[0] / fine.grid.spacing[0]))

    @abstractmethod
    def on_grid(self, grid: Any, guess: InitialGuess) -> LevelT:
        """The film on a grid of its own from an initial guess, with shear and heat."""

    @abstractmethod
    def isolated(self, grid: Any, guess: InitialGuess) -> LevelT:
        """The film on a grid of its own from an initial guess, which bears the whole load: none beyond it."""

    def of(self, scene: ContactT) -> "ContactSolver[ContactT, LevelT]":
        """The solver of another contact near this one, which it takes the scales of."""
        other = copy(self)
        other._scene = scene
        if self._model.rough and (scene.bodies, scene.motion_angles) != (
            self._scene.bodies,
            self._scene.motion_angles,
        ):
            other._rough = scene.rough_pair
            other._curves = None if other._rough is None else other._rough.curves()
        return other

    @abstractmethod
    def unsolved(self, level: LevelT) -> LevelT:
        """This contact on the grid of an isolated film, not started, without shear and heat."""

    def displaced(self, level: LevelT, beside: LevelT) -> LevelT:
        """This contact at the state, gap, moduli and load of a level near it, in another level's film.

        That one has the state already, without this contact's laws: its pressure chooses the model of the
        bodies' conduction.
        """
        other = replace(level, scene=self._scene, film=beside.film)
        other.film.take_oil(self._scene.oil)
        other.film.entrain(self._scene.entrainment_at(*level.grid.mesh()))
        if level.film.levels:
            self._shear(other)
        if level.film.heated:
            self._heat(other, level.film.rise())
        other.film.evaluate_at(level.film)
        return other

    @abstractmethod
    def with_rate(self, level: LevelT) -> LevelT:
        """The film of a level with this solver's transient term."""

    def from_dry(self, level: LevelT) -> LevelT | None:
        """The film of a level with this solver's transient term, begun with the dry contact.

        None where that is not known, or surfaces are smooth.
        """
        return None

    @abstractmethod
    def warm_started(self, level: LevelT) -> tuple[LevelT, list[NewtonStep]]:
        """Start the film from that of a level on the same grid, solved with fewer effects."""

    @abstractmethod
    def _guesses(self, level: LevelT) -> Iterator[InitialGuess]:
        """Initial guesses of the film on the grid of half the spacing, the best one first."""

    @abstractmethod
    def _continued(self, level: LevelT, guess: InitialGuess) -> LevelT:
        """The level of half the spacing in the same window, with shear and heat, from an initial guess."""

    @abstractmethod
    def begun_again(self, level: LevelT) -> tuple[LevelT, list[NewtonStep]]:
        """The level of half the spacing in the same window, started from the dry contact."""

    @abstractmethod
    def _warm(
        self, level: LevelT, rise: Array | None, bodies: tuple[Body, Body] | None = None
    ) -> None:
        """Add heat to a sheared film, from a rise over the inlet's [K]; it must be restarted."""

    @abstractmethod
    def _mass_error(self, level: LevelT) -> float:
        """Net over gross mass flow through the outline of the pressurised film."""

    @property
    @abstractmethod
    def _attributes(self) -> dict[str, float]:
        """Attributes of the fields: radii, load and modulus with their units."""

    def refined(self, level: LevelT) -> tuple[LevelT, list[NewtonStep]]:
        """The level of half the spacing in the same window, from the present film or the dry contact."""
        for guess in self._guesses_of_both(level):
            finer = self._continued(level, guess)
            if finer.film.balance.residual <= UNUSABLE_START_RESIDUAL:
                return finer, []
        if self._slips_hot(level) and not level.diverged():
            finer = self._continued(level, level.state().finer())
            steps = self._through_larger_stresses(finer)
            if not finer.diverged():
                return finer, steps
        return self.begun_again(level)

    def _guesses_of_both(self, level: LevelT) -> Iterator[InitialGuess]:
        """Initial guesses by the oil's pressure, then, between rough surfaces, by the total pressure.

        Asperities multiply what the film of an interpolated pressure is off by.
        """
        yield from self._guesses(level)
        if self._rough is not None:
            yield from (replace(guess, oil=None) for guess in self._guesses(level))

    def _add_shear_and_heat(self, level: LevelT) -> list[NewtonStep]:
        """Add shear, then heat, to the film of an isothermal Newtonian oil."""
        steps: list[NewtonStep] = []
        stress_factor = 1.0
        if self._model.levels:
            if self._rough is None:
                steps += iterate(level, COARSE_TOLERANCE)
            else:
                steps += iterate(level, ROUGHENED_TOLERANCE) + self._roughened(level)
            # that film's pressure could make heat without bound by a law that limits the stress
            sheared, stress_factor = self._sheared(level)
            steps += sheared
        if self._model.heated:
            heated, stress_factor = self._heated(level, stress_factor)
            steps += heated
            # hot oil is thin: it may bear stresses that no cold film leads to
            if not level.diverged():
                continuation, stress_factor = self._continue_stresses(
                    level, stress_factor, MIN_STRESS_RATIO_HEATED
                )
                steps += continuation
        if stress_factor > 1:
            self._flow_by_law(level, 1.0, level.state())
        return steps

    def _sheared(self, level: LevelT) -> tuple[list[NewtonStep], float]:
        """Newton steps from a Newtonian film to that of the flow law, and the final factor of its stresses.

        Where the Newtonian film is too far from that of the law for Newton's iteration, the stresses of the
        law are first multiplied by a factor, which falls to 1 (stress continuation).
        """
        newtonian = level.state()
        self._flow_by_law(level, 1.0, newtonian)
        steps: list[NewtonStep] = iterate(level, self.shear_tolerance)
        if level.film.balance.worst <= self.shear_tolerance:
            return steps, 1.0
        level.film.start(newtonian.pressure, newtonian.rigid_film, newtonian.oil)
        continuation: list[NewtonStep]
        continuation, stress_factor = self._continue_stresses(
            level, MAX_STRESS_FACTOR * STRESS_RATIO, MIN_STRESS_RATIO
        )
        return [*steps, *continuation], stress_factor

    def _roughened(self, level: LevelT) -> list[NewtonStep]:
        """Newton steps to the film of rough surfaces, isothermal and Newtonian.

        They begin with the pressure of the smooth film left to the oil, and that of the asperities on top. So
        the load is too large: where asperities are too stiff Newton's steps descend their exponential from
        above, and from below they would overshoot it. But on grids too coarse the smooth film closes, where
        asperities would bear many times the load: they begin with the dry contact if that balances better.
        """
        smooth = level.state()
        film = float(level.film.thickness().flat[smooth.pressure.argmax()])

        def imbalance(guess: InitialGuess) -> float:
            self._set_law(level, NEWTONIAN)
            return level.film.start(guess.pressure, guess.rigid_film, guess.oil).worst

        guesses = [self._lifted(smooth, film), *self.dry_guesses(level)]
        imbalance(min(guesses, key=imbalance))
        return iterate(level, ROUGHENED_TOLERANCE)

    def _lifted(self, guess: InitialGuess, film: float) -> InitialGuess:
        """A guess with this film under its largest pressure, lifted until asperities bear no more."""
        lift = max(
            present(self._curves, "roughness").gap_under(float(guess.pressure.max())) - film, 0.0
        )
        return replace(guess, rigid_film=guess.rigid_film + lift)

    def dry_guesses(self, level: LevelT) -> list[InitialGuess]:
        """The dry contact's pressure with the expected film, where it is known."""
        return []

    def _heated(self, level: LevelT, stress_factor: float) -> tuple[list[NewtonStep], float]:
        """Newton steps from a sheared film to a heated one, and the factor of its stresses.

        A film that is lost when it is heated is heated again under larger stresses.
        """
        cold, steps = level.state(), []
        while True:
            self._heat(level, None)
            level.film.restart()
            steps += self._to_own_entrainment(level)
            steps += iterate(level, HEATED_TOLERANCE)
            if not level.diverged() or stress_factor >= MAX_STRESS_FACTOR or self.circulates(level):
                return steps, stress_factor
            stress_factor *= STRESS_RATIO
            self._shear(level, stress_factor)
            level.film.start(cold.pressure, cold.rigid_film, cold.oil)
            steps += iterate(level, self.shear_tolerance)

    def _continue_stresses(
        self, level: LevelT, stress_factor: float, least: float
    ) -> tuple[list[NewtonStep], float]:
        """Newton steps of the stress continuation, and the factor of the stresses at its end.

        The ratio of successive stresses adapts to what converges, but not below `least`. The level holds the
        last film that converged.
        """
        steps: list[NewtonStep] = []
        found, ratio = level.state(), STRESS_RATIO
        while stress_factor > 1 and ratio >= least and _affordable(level, stress_factor, ratio):
            smaller_factor = max(stress_factor / ratio, 1.0)
            self._flow_by_law(level, smaller_factor, found)
            if level.film.balance.residual <= UNUSABLE_START_RESIDUAL:
                tolerance = HEATED_TOLERANCE if level.film.heated else self.shear_tolerance
                steps += iterate(level, tolerance, most=CONTINUATION_STEPS)
            if level.diverged():
                ratio = sqrt(ratio)
            else:
                found, stress_factor, ratio = (
                    level.state(),
                    smaller_factor,
                    min(ratio**STRESS_RATIO_GROWTH, STRESS_RATIO),
                )
        if level.diverged():
            self._flow_by_law(level, stress_factor, found)
        return steps, stress_factor

    def circulates(self, level: LevelT) -> bool:
        """Whether the heat that has not settled is that of oil which circulates in the inlet of a rigid film.

        Where surfaces deflect, heat is made under pressure, and larger stresses lead to its film.
        """
        return self._plan.regime.deflection < 1 and temperature_varies(level)

    def continued_from_larger_stresses(self, level: LevelT) -> list[NewtonStep]:
        """Newton steps of a heated film that did not settle, through films of larger stresses.

        Where both walls slip, film and temperature may move to and fro without end; the same grid's film of
        larger stresses leads to the one that rests. No steps where the film is not heated or has no flow law.
        """
        return self._through_larger_stresses(level) if self._slips_hot(level) else []

    def _slips_hot(self, level: LevelT) -> bool:
        """Whether a film is heated and has stresses of a flow law, by which heat and film may part."""
        return level.film.heated and self._scene.oil.flow not in (None, NEWTONIAN)

    def _through_larger_stresses(self, level: LevelT) -> list[NewtonStep]:
        """Newton steps of a heated film from its state, through films of larger stresses to its own."""
        steps: list[NewtonStep] = []
        guess = level.state()
        for first_factor in LARGER_STRESS_FACTORS:
            self._flow_by_law(level, first_factor, guess)
            steps += iterate(level, HEATED_TOLERANCE, HEATED_TOLERANCE)
            if level.film.balance.within(HEATED_TOLERANCE, HEATED_TOLERANCE):
                continuation, stress_factor = self._continue_stresses(
                    level, first_factor, MIN_STRESS_RATIO_HEATED
                )
                steps += continuation
                if stress_factor <= 1:
                    return steps
                break  # the films of still larger stresses lead here, too
        self._flow_by_law(level, 1.0, level.state())
        return steps

    def _flow_by_law(self, level: LevelT, stress_factor: float, guess: InitialGuess) -> None:
        """Solve a film under the flow law with its stresses multiplied by a factor, from an initial guess."""
        heated = level.film.heated
        self._shear(level, stress_factor)
        if heated:
            self._heat(level, guess.rise)
        level.film.start(guess.pressure, guess.rigid_film, guess.oil)

    def _shear(self, level: LevelT, stress_factor: float = 1.0) -> None:
        """Set the flow law, its stresses multiplied by a factor; the film must be restarted."""
        law = (self._scene.oil.flow or NEWTONIAN).with_stress_factor(stress_factor)
        self._set_law(level, law, slip_step=SLIP_STEP + SLIP_WIDENING * (stress_factor - 1))

    def _set_law(self, level: LevelT, law: FlowLaw, slip_step: float = SLIP_STEP) -> None:
        """Set a flow law, and the surfaces' roughness; the film must be restarted."""
        level.film.shear(
            law, self._model.levels, self._scene.sliding_at(*level.grid.mesh()), slip_step
        )
        if self._curves is not None:
            level.film.roughen(self._curves, self._scene.boundary_friction)

    def _heat(
        self, level: LevelT, rise: Array | None, bodies: tuple[Body, Body] | None = None
    ) -> None:
        """Add heat from an initial rise, with what surfaces remember and oil stores of films before."""
        self._warm(level, None if rise is None else at_levels(rise, level.film.levels), bodies)
        term = level.transient_term
        if term is None:
            return
        remembered, stored = term.remembered(level.grid), term.stored(level.grid)
        if remembered is not None:
            level.film.remember(remembered)
        if stored is not None:
            level.film.store_heat(stored)

    def _shear_and_warm(self, level: LevelT, guess: InitialGuess) -> None:
        """Set shear and heat together, for a film whose initial guess has both."""
        if self._model.levels:
            self._shear(level)
        if self._model.heated:
            self._heat(level, guess.rise)
        if self._model.levels:
            level.film.start(level.film.pressure, level.film.rigid_film, guess.oil)

    def _to_own_entrainment(self, level: LevelT) -> list[NewtonStep]:
        """Newton steps of the continuation that removes an auxiliary entrainment, where there is one."""
        return []

    def outcome(self, level: LevelT) -> Outcome:
        """Figures without error bars, fields, and the profile across the film where it is hottest."""
        scene, model = self._scene, self._model
        figures: dict[str, Any] = {
            "moes_m": self._size.groups.moes_m,
            "moes_l": self._size.groups.moes_l,
            "mass_error": self._mass_error(level),
            "heat_balance": heat_balance(level) if model.heated else None,
        }
        if level.film.fed:
            figures["supply"] = supply_figures(level, self._flooded())
        dry = self._dry(level)
        if dry is not None:
            figures |= self._dry_figures(level, dry)
        return Outcome(
            figures,
            fields(scene, model, level, None if dry is None else dry.pressure, self._attributes),
            None if dry is None or dry.converged else Ending.NO_DRY_CONTACT,
            profile(scene, level) if model.heated else None,
        )

    def _flooded(self) -> tuple[float, float, float]:
        """Central film with oil in plenty [m], its relative error, and the relative density there."""
        oil = replace(self._scene.oil, supply=None)
        scene = replace(self._scene, oil=oil)
        grids = PLANS[type(scene)](scene, self._plan.accuracy, self._model).grids
        solver = type(self)(scene, replace(self._plan, grids=grids), self._transient_term)
        level, _ = solver.begin(grids)
        iterate(level, COARSE_TOLERANCE)
        coarse = level.read().film_central
        level, _ = solver.refined(level)
        iterate(level, COARSE_TOLERANCE)
        fine = level.read().film_central
        film = fine + (fine - coarse) / 3
        density = figures_of_grid.value_at_origin(level.grid, level.film.fields()[1])
        return film, abs(fine - coarse) / (3 * film), density

    def uncertainties(self, level: LevelT) -> dict[str, float]:
        """Relative model uncertainty of the figures of a converged film; empty where nothing is assumed.

        It is that by its oil's constants, by averaged roughness, and by the temperature of oil that arrives
        between warmer or colder bodies.
        """
        of_models = [oil_uncertainty(self._scene)]
        if self._rough is not None:
            of_models.append(self._roughness_uncertainty(level))
        if self._model.heated and self._scene.oil.thermal.supply_temperature is not None:
            of_models.append(arrival_uncertainty(level, self._warm_between(level)))
        names = {name: None for model in of_models for name in model}
        return {name: hypot(*(model.get(name, 0.0) for model in of_models)) for name in names}

    def _roughness_uncertainty(self, level: LevelT) -> dict[str, float]:
        scene, half_width = self._scene, predicted(self._scene).half_width
        waves = neglected_waves(
            moving_waves(scene), self._size.groups, half_width, scene.reduced_modulus
        )
        return roughness_uncertainty(
            level,
            present(self._rough, "roughness"),
            scene.boundary_friction,
            waves,
            scene.oil.boundary_friction_spread,
        )

    def _warm_between(self, level: LevelT) -> Callable[[tuple[Body, Body], InitialGuess], None]:
        def warm(bodies: tuple[Body, Body], guess: InitialGuess) -> None:
            self._heat(level, guess.rise, bodies)
            level.film.start(guess.pressure, guess.rigid_film, guess.oil)

        return warm

    def _dry(self, level: LevelT) -> DryContact | None:
        """The dry contact on the grid of a level; None where it is Hertz's in closed form."""
        return None

    def _dry_figures(self, level: LevelT, dry: DryContact) -> dict[str, Any]:
        """Figures of the dry contact, and those that refer to it."""
        return {}


def _affordable(level: Level, stress_factor: float, ratio: float) -> bool:
    """Whether the stress continuation still to come is, of stresses times a factor that falls by a ratio."""
    to_come = level.grid.nodes * log(stress_factor) / log(ratio)
    return ratio >= MIN_STRESS_RATIO or to_come <= MOST_STAGE_NODES
