"""How a contact is solved by nested iteration: what point and line contacts share.

A solver of one kind of contact makes its films on grids of halving spacing, gives them shear and heat, and
shows what the last of them holds. `pyworm.solver.grid_sequence` decides how far the grids go.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from math import sqrt
from typing import Any, ClassVar

from pyworm.kernel import DryContact
from pyworm.materials.oil import NEWTONIAN
from pyworm.planning.plan import Plan
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.contact import Array, Contact
from pyworm.solver.error_estimate import Convergence
from pyworm.solver.level import InitialGuess, Level, TransientTerm
from pyworm.solver.newton import NewtonStep, lead
from pyworm.solver.outcome import Outcome, fields, heat_balance, profile

COARSE_TOLERANCE = 1e-4
"""Residual at which a grid that only leads to a finer one is left, and a Newtonian film is sheared."""

FIRMEST = 16.0
"""Stresses of the flow law, over its own, that are tried first where no step leads to these at once."""

SOFTENING, LEAST_SOFTENING = 2.0, 1.02
"""Ratio of the stresses from one film to the next, its root taken where a film is lost, down to the least."""

HEATED_TOLERANCE = 1e-2
"""Residual of a heated film, and change of its temperature, from which its stresses are softened."""

SENSELESS = 1.0
"""Residual beyond which a film is no start for a finer grid: its gradients ask for more stress than oil with
a limit bears, and the slip that its law allows then is without bound."""


class ContactSolver(ABC):
    """Films of one contact on grids of halving spacing.

    Parameters
    ----------
    scene : Contact
        The contact.
    plan : Plan
        The effects that are simulated, and the numerical parameters.
    transient_term : TransientTerm, optional
        d(rho h)/dt; without it the film is steady.

    Attributes
    ----------
    kind : str
        Kind of contact in results: "point" or "line".
    level_type : type
        Class of its levels.
    shear_tolerance : float
        Residual of the sheared film from which it is heated.
    convergence : Convergence
        Orders and window errors of its figures.
    origins : dict
        Value that figures count from, where their readings count from another.
    """

    kind: ClassVar[str]
    level_type: ClassVar[type[Level]]
    shear_tolerance: ClassVar[float]
    convergence: Convergence

    def __init__(self, scene: Contact, plan: Plan, transient_term: TransientTerm | None = None):
        self._scene = scene
        self._plan = plan
        self._model = plan.model
        self._transient_term = transient_term
        self.origins = (
            dict.fromkeys(HEAT_FIGURES, scene.oil.heat.inlet_temperature)
            if self._model.heated
            else {}
        )

    @abstractmethod
    def begin(self, grids: Sequence[Any]) -> tuple[Level, list[NewtonStep]]:
        """Nested iteration over the plan's grids to the last of them, not yet settled there."""

    @abstractmethod
    def at_next_time(self, earlier: Sequence[Level], fraction: float) -> Level:
        """The contact on the grid of its levels at earlier times, the latest first, extrapolated from these.

        `fraction` is the time since the latest over that between it and the one before.
        """

    @abstractmethod
    def warm_started(self, level: Level) -> tuple[Level, list[NewtonStep]]:
        """The grid of a level, from its film, on which the contact was solved with fewer effects."""

    @abstractmethod
    def _guesses(self, level: Level) -> Iterator[InitialGuess]:
        """Where the film on the grid of half the spacing may begin, the best guess first."""

    @abstractmethod
    def _continued(self, level: Level, guess: InitialGuess) -> Level:
        """Half the spacing over the same window, with shear and heat, from a guess."""

    @abstractmethod
    def _begun_again(self, level: Level) -> tuple[Level, list[NewtonStep]]:
        """Half the spacing over the same window, from the dry contact."""

    @abstractmethod
    def _warm(self, level: Level, rise: Array | None) -> None:
        """Adds heat to a sheared film, from a rise above the inlet's [K]; it is to be started again."""

    @abstractmethod
    def _mass_error(self, level: Level) -> float:
        """Net over gross mass flow through the outline of the pressurised film."""

    @property
    @abstractmethod
    def _attributes(self) -> dict[str, float]:
        """Attributes of the fields: radii, load and modulus with their units."""

    def refined(self, level: Level) -> tuple[Level, list[NewtonStep]]:
        """Half the spacing over the same window: from the present film, or again from the dry contact."""
        for guess in self._guesses(level):
            finer = self._continued(level, guess)
            if finer.film.balance.residual <= SENSELESS:
                return finer, []
        return self._begun_again(level)

    def _add_shear_and_heat(self, level: Level) -> list[NewtonStep]:
        """Shear, then heat, for the film of a Newtonian oil of one temperature."""
        steps: list[NewtonStep] = []
        stresses = 1.0
        if self._model.levels:
            steps += lead(level, COARSE_TOLERANCE)
            # that film's pressure could make heat without bound by a law that limits the stress
            sheared, stresses = self._sheared(level)
            steps += sheared
        if self._model.heated:
            self._warm(level, None)
            level.film.restart()
            steps += self._to_own_entrainment(level)
            if stresses > 1:  # hot oil is thin: it may bear stresses that no cold film leads to
                steps += lead(level, HEATED_TOLERANCE)
                softened, stresses = self._softened(level, stresses)
                steps += softened
        if stresses > 1:
            self._flow_by_law(level, 1.0, level.state())
        return steps

    def _sheared(self, level: Level) -> tuple[list[NewtonStep], float]:
        """Steps from a Newtonian film to that of the oil's law, and the stresses reached over the law's own.

        Where stresses of the Newtonian film are so far beyond those of the law that steps do not lead there,
        stresses many times as large are taken first (continuation).
        """
        newtonian = level.state()
        self._flow_by_law(level, 1.0, newtonian)
        steps = lead(level, self.shear_tolerance)
        if level.film.balance.worst <= self.shear_tolerance:
            return steps, 1.0
        level.film.start(newtonian.pressure, newtonian.rigid_film)
        softened, stresses = self._softened(level, FIRMEST * SOFTENING)
        return [*steps, *softened], stresses

    def _softened(self, level: Level, stresses: float) -> tuple[list[NewtonStep], float]:
        """Steps from a film under stresses many times the law's own towards these, and how far they lead.

        The film left is the last that was found.
        """
        steps: list[NewtonStep] = []
        found, ratio = level.state(), SOFTENING
        while stresses > 1 and ratio >= LEAST_SOFTENING:
            softer = max(stresses / ratio, 1.0)
            self._flow_by_law(level, softer, found)
            steps += lead(level, HEATED_TOLERANCE if level.film.heated else self.shear_tolerance)
            if level.lost():
                ratio = sqrt(ratio)
            else:
                found, stresses = level.state(), softer
        if level.lost():
            self._flow_by_law(level, stresses, found)
        return steps, stresses

    def _flow_by_law(self, level: Level, stresses: float, guess: InitialGuess) -> None:
        """A film under the oil's flow law, its stresses so many times as large, from a guess."""
        heated = level.film.heated
        self._shear(level, stresses)
        if heated:
            self._warm(level, guess.rise)
        level.film.start(guess.pressure, guess.rigid_film)

    def _shear(self, level: Level, stresses: float = 1.0) -> None:
        """Flow by the oil's law under stresses so many times as large; the film is to be started again."""
        law = (self._scene.oil.flow or NEWTONIAN).firmer(stresses)
        level.film.shear(law, self._model.levels, self._scene.sliding_at(*level.grid.mesh()))

    def _shear_and_warm(self, level: Level, guess: InitialGuess) -> None:
        """Shear and heat at once, for a film that starts from one that has them."""
        if self._model.levels:
            self._shear(level)
        if self._model.heated:
            self._warm(level, guess.rise)
        if self._model.levels:
            level.film.restart()

    def _to_own_entrainment(self, level: Level) -> list[NewtonStep]:
        """Steps from an auxiliary entrainment to the contact's own, where it began with one."""
        return []

    def outcome(self, level: Level) -> Outcome:
        """Figures without error bars, fields, and the profile across the film where it is hottest."""
        scene, model = self._scene, self._model
        figures = {
            "moes_m": self._size.groups.moes_m,
            "moes_l": self._size.groups.moes_l,
            "mass_error": self._mass_error(level),
            "heat_balance": heat_balance(level) if model.heated else None,
        }
        dry = self._dry(level)
        if dry is not None:
            figures |= self._dry_figures(level, dry)
        return Outcome(
            figures,
            fields(scene, model, level, None if dry is None else dry.pressure, self._attributes),
            None if dry is None or dry.converged else "the dry contact did not converge",
            profile(scene, level) if model.heated else None,
        )

    def _dry(self, level: Level) -> DryContact | None:
        """The dry contact on the grid of a level; None where Hertz's in closed form is that."""
        return None

    def _dry_figures(self, level: Level, dry: DryContact) -> dict[str, Any]:
        """Figures of the dry contact, and those that refer to it."""
        return {}
