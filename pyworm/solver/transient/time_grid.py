"""The time grid of a life: time in transits of the oil, and grids that fit the contact at every time."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import ceil, exp, hypot, inf, log

import numpy as np
import scipy

from pyworm.planning.discretisation import moving_grid
from pyworm.planning.expected_work import STEPS_A_TRANSIT, Kind
from pyworm.planning.grid import Grid
from pyworm.planning.line_grid import LineGrid
from pyworm.planning.plan import Plan, effects_for, planned
from pyworm.planning.prediction import Prediction, predicted
from pyworm.planning.window import OUTFLOW_FRACTION, enlarged
from pyworm.scene.any_contact import AnyContact
from pyworm.scene.life import Life
from pyworm.scene.line import LineScene
from pyworm.solver.transient.moving_grid import MeshMotion, Stretching

KNOTS = 17
"""Times of a life at which its contact is predicted."""

HALVINGS = 10
"""Bisections between two of them for the first and the last time under load."""

KNOT_STRIDE = 2
"""Every which of these has its window drawn, beside the first of each direction of flow."""

MIN_LOAD_FRACTION = 0.05
"""Load, over the largest, below which a contact does not count for the size of the grids: under light loads
windows are wide, and films thick."""

SPACING_DEGREE = 4
"""Degree of the polynomials in time that the logarithm of the grids' spacing follows."""

MAX_SPACING_RATIO = 1.5
"""Ratio of the spacing of a written course to that of each time up to which it stays the same.

A polynomial does not follow a blow, and swings before and after it: where a load rose fourfold and fell back,
the grid grew faster than oil flows when that was over, and the minimum film thickness by three transient
solves was 33, 14 and 4 % above its limit; on a grid that stays, 0.6, 0.3 and 0 %."""

LEAST_TRANSITS = 4.0
"""Transits that a life counts at least, where oil hardly moves."""

FOLDS = 1.0
"""E-folds of the load of a tooth pair that count as a transit: as teeth part it falls three- or fourfold
while oil passes, and as they come together it grows from nothing. With 2 the first and the second solve of
`cases/zi_drive.toml` differ by 10 % in the least film at phase 0.06, with 1 by 8 %, at the same number of
Newton steps, since each begins nearer to its end."""

LEAST_PASSAGES = 0.1
"""Passages of oil that a transit counts at least: a blow is over before oil has moved."""

COVERED_KNOT_SHARE = 0.6
"""Share of the knots whose windows the grid covers on each side, of those of each direction of flow.

The inlet reaches several times as far as the exit, and where the entrainment reverses each side is the inlet
in turn. A line whose speed goes from -1.6 to 1.6 m/s, in a window whose later inlet is an exit at most knots,
loses 14 % of its film (`tests/python/solver/test_symmetries.py`)."""

CONTACT_MARGIN = 1.2
"""Reach of the grid at the knots whose windows are drawn, over that of Hertz's contact at least, where
surfaces go so far.

A long contact that runs off a tooth flank grows longer in cells. Where the grid of a worm gear (drive 1 of
seed 99013 of `tests/hard`, phase 0.9) ended at 0.7 to 0.9 of it, what was left bore the load that it cut off:
the largest pressure was 852 MPa for 650, and no film was found with its rate of change."""

COARSENING: dict[Kind, float] = {"point": 2.0, "line": 0.5}
"""Spacing of the first transient solve over that of the first grid of usual cells
(`planning.discretisation.moving_grid`); nodes of lines cost next to nothing."""

FORMING = 0.25
"""Transits after the first touch up to which films form: the window is that of surfaces that come together,
and the rate of change of first order, by the last film alone.

The wide window ends there, since its spacing is twice that of a contact, whose films are thin by then. Up to
half a transit the central film of an isothermal worm gear (a = 100 mm) at phase 0.1 changes by 11 % from the
first solve to the second, up to a quarter by 5 %, up to a tenth by 4 %, and the second by 1 % from one to the
other; films of `cases/zi_drive.toml` at phase 0.02 change by 1 % either way.

Where surfaces come together the gap at a place falls by many films in a time step, and then stays as the film
that has formed. A difference of higher order still sees the fall, and presses out of that film what is no
longer there. Where flanks come together on an edge, at phase 0.1 of an isothermal worm gear (a = 100 mm), it
leaves 19, 10 and 2 % less than the least film of 144 steps a transit with 18, 36 and 72 of them, one of first
order 11 and 5 % more with 18 and 36 (`FOLDS` = 2). Where they come together on their flanks both are as good:
4 % less and 8 % more at phase 0.02 of the first solve of `cases/zi_drive.toml`."""

APPROACH_WINDOW_RATIO = 3.0
"""That window, over the one of a steady film at the first touch.

While surfaces come together oil is pressed out of all of their gap. At phase 0.02 of `cases/zi_drive.toml`
the least film of a first isothermal solve is 0.97 um in the window of a steady film, 1.20 um in this one and
1.205 um in one of 5 times. Films are thick there and do with twice the spacing."""

TURNED_STEPS: dict[Kind, int] = {"point": 2, "line": 1}
"""Factor of the number of time steps where the entrainment turns round.

The film of each turn is a dip a few cells wide, which stays in the contact as long as oil goes to and fro.
By the second solve of `past:4` of `tests/hard` the central film is 21.3, 22.2 and 22.8 um with 1, 2 and 4
times the steps; the third and fourth, of 8 and 64 times the work, have 22.0 and 22.4 um
(`benchmarks/accuracy/turned_steps.py`)."""

CELLS = 8
"""Cells of the coarsest grid to either side of the contact point come in multiples of half of this."""

ROUNDING = 1e-6
"""Part of a cell or a time step by which one may be short: rounding decides about none."""


@dataclass(frozen=True)
class Approach:
    """Surfaces that come together: a larger window, with twice the spacing."""

    until: float
    """Time up to which it is taken, while films form [s]."""
    sides: tuple[tuple[int, int], ...]
    """Its cells before and behind the contact point along each direction, on its coarsest grid."""


@dataclass(frozen=True)
class TimeGrid:
    """Time steps, grids and plan of a life, from entry to exit.

    Before and after the times for which grids were fitted they stay as they are.
    """

    life: Life
    """The life."""
    plan: Plan
    """One plan for the whole life: effects that any of its knots calls for."""
    begin: float
    """First time under load [s]."""
    end: float
    """Last time under load [s]."""
    sides: tuple[tuple[int, int], ...]
    """Cells of the coarsest grid before and behind the contact point along each direction."""
    _log_spacing: tuple[np.polynomial.Polynomial, ...]
    _fitted: tuple[float, float]
    _transits: "scipy.interpolate.PPoly"
    _passages: "scipy.interpolate.PPoly"
    approach: Approach | None = None
    """Surfaces that come together, if they do."""
    steps: float = 1.0
    """Time steps of a transit in the first transient solve."""

    def transits(self, seconds: float) -> float:
        """Transits of oil through the contact from the first time under load to another."""
        return float(self._transits(seconds) - self._transits(self.begin))

    def place(self, seconds: float) -> float:
        """Transits from the first time under load to another, not before it."""
        return max(self.transits(seconds), 0.0)

    def transit(self, seconds: float) -> float:
        """Transit time of the oil at a time [s]."""
        return 1 / float(self._transits(seconds, 1))

    def passages_of_transit(self, seconds: float) -> float:
        """Passages of oil through the contact in a transit at a time [s], one at most."""
        passages = float(self._passages(seconds, 1)) * self.transit(seconds)
        return float(np.clip(passages, LEAST_PASSAGES, 1.0))

    def time_at(self, transits: float) -> float:
        """Time [s] at which so many transits have passed."""
        if transits >= self.transits(self.end):
            return self.end
        return float(
            scipy.optimize.brentq(lambda t: self.transits(t) - transits, self.begin, self.end)
        )

    def place_before(self, place: float, passages: float) -> float:
        """Place [transits] from which oil goes so often through the contact up to another; -inf if none is.

        Transits may be far shorter than a passage of oil: those of a life of less than `LEAST_TRANSITS` of
        them, and where the load changes fast (`FOLDS`).
        """
        seconds = self.time_at(place)

        def too_many(since: float) -> float:
            return float(self._passages(seconds) - self._passages(since)) - passages

        if too_many(self.begin) < 0:
            return -inf
        return self.transits(float(scipy.optimize.brentq(too_many, self.begin, seconds)))

    def come_together(self, seconds: float) -> bool:
        """Whether surfaces come together at a time, and films form between them."""
        return self.approach is not None and seconds < self.approach.until

    def grid(self, seconds: float, refinement: int) -> Grid | LineGrid:
        """The grid at a time, its spacing halved some times."""
        if self.approach is not None and self.come_together(seconds):
            return self._grid(seconds, refinement, self.approach.sides, 2.0)
        return self.grid_of_contact(seconds, refinement)

    def grid_of_contact(self, seconds: float, refinement: int) -> Grid | LineGrid:
        """The grid of surfaces in contact at a time, also where they still come together."""
        return self._grid(seconds, refinement, self.sides, 1.0)

    def _grid(
        self, seconds: float, refinement: int, sides: Sequence[tuple[int, int]], coarser: float
    ) -> Grid | LineGrid:
        within = float(np.clip(seconds, *self._fitted))
        cell = coarser / 2**refinement
        steps = [cell * exp(log_spacing(within)) for log_spacing in self._log_spacing]
        spans = [(before << refinement, behind << refinement) for before, behind in sides]
        if len(steps) == 1:
            ((dx,), ((before, behind),)) = steps, spans
            return LineGrid(dx, -before, before + behind + 1)
        (dx, dy), ((west, east), (south, north)) = steps, spans
        return Grid(-west * dx, -south * dy, dx, dy, west + east + 1, south + north + 1)

    def step(self, refinement: int) -> float:
        """Time step [transits], halved with the spacing."""
        return 1 / (self.steps * 2**refinement)

    def coarser(self) -> "TimeGrid":
        """A time grid of this life with twice the spacing and the time step."""
        doubled = tuple(log_spacing + log(2.0) for log_spacing in self._log_spacing)
        approach = self.approach and replace(self.approach, sides=_halved(self.approach.sides))
        return replace(
            self,
            sides=_halved(self.sides),
            _log_spacing=doubled,
            approach=approach,
            steps=self.steps / 2,
        )

    def mesh(self, seconds: float) -> MeshMotion | Stretching:
        """Velocity of the grid's nodes at a time."""
        first, last = self._fitted
        breathes = first <= seconds <= last
        growth = [float(spacing.deriv()(seconds)) * breathes for spacing in self._log_spacing]
        if len(growth) == 1:
            return Stretching(*growth)
        along_x, along_y = growth
        return MeshMotion(along_x, along_y, self.life.turning(seconds))


def time_grid_of(life: Life, plan: Plan) -> TimeGrid:
    """The time grid of a life under the plan of one of its contacts.

    ValueError if it carries no load, or load without motion, at all of its knots.
    """
    times, contacts = _loaded(life)
    heaviest = max(contact.load for contact in contacts)
    counted = [
        (seconds, contact, prediction)
        for seconds, contact in zip(times, contacts, strict=True)
        if contact.load >= MIN_LOAD_FRACTION * heaviest
        and (prediction := _predicted(contact)) is not None
    ]
    if not counted:
        raise ValueError("its surfaces carry no load in motion")
    times_under_load, contacts_under_load, predictions = zip(*counted, strict=True)
    whole = _whole_plan(contacts_under_load, predictions, plan)
    flows = [_flow(contact) for contact in contacts_under_load]
    some = _drawn(flows)
    drawn, flows = [times_under_load[number] for number in some], [flows[number] for number in some]
    simple = [whole.simplified(contacts_under_load[number]) for number in some]
    grids = [moving_grid(contact, whole.accuracy, whole.model) for contact in simple]
    coarsening = COARSENING[whole.work.kind]
    sides = _sides(grids, flows, coarsening)
    spacings = _spacings(drawn, grids, coarsening, written=bool(life.kinks))
    if whole.work.kind == "line":
        half_widths = [prediction.half_width for prediction in predictions]
        lines = [grid for grid in grids if isinstance(grid, LineGrid)]
        sides = (_covering(sides[0], times_under_load, half_widths, drawn, lines, spacings[0]),)
    else:
        points = [grid for grid in grids if isinstance(grid, Grid)]
        sides = _holding(sides, drawn, [predictions[number] for number in some], points, spacings)
    paced = list(zip(times_under_load, contacts_under_load, predictions, strict=True))
    if times[0] < life.touched < times_under_load[0]:
        touching = life.at(life.touched)
        paced.insert(0, (life.touched, touching, predicted(touching)))
    paced_times, paced_contacts, expected = zip(*paced, strict=True)
    pace = _pace(paced_times, paced_contacts, expected, life)
    passing = [1 / prediction.transit for prediction in expected]
    kind, turned = whole.work.kind, _turns_round(contacts_under_load)
    time_grid = TimeGrid(
        life,
        whole,
        times[0],
        times[-1],
        sides,
        spacings,
        (times_under_load[0], times_under_load[-1]),
        pace,
        _summed(paced_times, passing, life.duration),
        steps=STEPS_A_TRANSIT[kind] * (TURNED_STEPS[kind] if turned else 1),
    )
    if whole.work.kind == "line" or not life.touched > time_grid.begin:
        return time_grid
    return replace(time_grid, approach=_approach(time_grid))


def _approach(time_grid: TimeGrid) -> Approach:
    """Window of surfaces that come together, up to the ends of teeth, and at its end that of a contact."""
    touched = time_grid.place(time_grid.life.touched)
    touch, until = (time_grid.time_at(touched + later) for later in (0.0, FORMING))
    contact = time_grid.plan.simplified(time_grid.life.at(touch))
    grid = moving_grid(contact, time_grid.plan.accuracy, time_grid.plan.model)
    if isinstance(contact, LineScene) or isinstance(grid, LineGrid):
        raise TypeError("the surfaces of a line contact do not come together")
    window = enlarged(contact, grid.box, APPROACH_WINDOW_RATIO)
    cells = 2 * np.array(time_grid.grid(touch, 0).spacing)
    reaches = np.abs(np.reshape(window, (2, 2))) / cells[:, None]
    return Approach(until, _whole_cells(np.maximum(reaches, np.array(time_grid.sides) / 2)))


def _loaded(life: Life) -> tuple[list[float], list[AnyContact]]:
    """Times and contacts of a life at its knots under load, from the first time under load to the last."""
    knots = sorted({*np.linspace(0.0, life.duration, KNOTS).tolist(), *life.kinks})
    states = [_at(life, seconds) for seconds in knots]
    loaded = [number for number, state in enumerate(states) if state is not None]
    if not loaded:
        raise ValueError("its surfaces carry no load at any time")
    first, last = loaded[0], loaded[-1]
    if first > 0:
        knots[first], states[first] = _farthest(life, knots[first], knots[first - 1])
    if last < len(knots) - 1:
        knots[last], states[last] = _farthest(life, knots[last], knots[last + 1])
    found = [
        (seconds, state) for seconds, state in zip(knots, states, strict=True) if state is not None
    ]
    return [seconds for seconds, _ in found], [state for _, state in found]


def _at(life: Life[AnyContact], seconds: float) -> AnyContact | None:
    """The contact at a time; None where it carries no load."""
    try:
        return life.at(seconds)
    except ValueError:
        return None


def _farthest(life: Life, loaded: float, empty: float) -> tuple[float, AnyContact]:
    """The time between one under load and one without that is nearest to the latter under load [s]."""
    for _ in range(HALVINGS):
        middle = (loaded + empty) / 2
        if _at(life, middle) is None:
            empty = middle
        else:
            loaded = middle
    return loaded, life.at(loaded)


def _predicted(contact: AnyContact) -> Prediction | None:
    """Prediction of a contact; None where its surfaces do not move."""
    try:
        return predicted(contact)
    except ValueError:
        return None


def _whole_plan(
    contacts: Sequence[AnyContact], predictions: Sequence[Prediction], plan: Plan
) -> Plan:
    """A plan for the contact in the middle with the effects that any of some calls for.

    It depends on the accuracy and the choice of effects alone, and is the same for all contacts of a life.
    """
    called = frozenset().union(
        *(
            effects_for(contact, plan, prediction)
            for contact, prediction in zip(contacts, predictions, strict=True)
        )
    )
    middle = len(contacts) // 2
    return planned(
        contacts[middle],
        plan.accuracy,
        plan.quantities,
        predictions[middle],
        plan.asked,
        called,
        plan.excluded,
    )


def _entrainment(contact: AnyContact) -> list[float]:
    """Entrainment at the contact point along each axis [m/s]."""
    return [
        float(part) for part in contact.entrainment_at(*(np.zeros(()),) * len(contact.radii_along))
    ]


def _turns_round(contacts: Sequence[AnyContact]) -> bool:
    """Whether the entrainment turns round from one of some contacts to the next."""
    return any(
        np.dot(_entrainment(before), _entrainment(after)) < 0
        for before, after in pairwise(contacts)
    )


def _flow(contact: AnyContact) -> tuple[int, ...]:
    """Direction in which oil leaves along each axis, 1 or -1; 0 along one that it mainly flows across."""
    along = _entrainment(contact)
    leaving = OUTFLOW_FRACTION * hypot(*along)
    return tuple((part > leaving) - (part < -leaving) for part in along)


def _drawn(flows: Sequence[tuple[int, ...]]) -> list[int]:
    """Numbers of the knots whose windows are drawn, at least one of each direction of flow."""
    # windows cost more than predictions
    return sorted({*range(0, len(flows), KNOT_STRIDE), *(flows.index(flow) for flow in set(flows))})


def _sides(
    grids: Sequence[Grid | LineGrid], flows: Sequence[tuple[int, ...]], coarsening: float
) -> tuple[tuple[int, int], ...]:
    """Cells before and behind the contact point that hold the windows of most of some grids."""
    sides = []
    for direction in range(len(grids[0].spacing)):
        reaches: dict[int, list[tuple[float, float]]] = {}
        for grid, flow in zip(grids, flows, strict=True):
            places = (grid.x, grid.y)[direction] if isinstance(grid, Grid) else grid.x
            step = grid.spacing[direction] * coarsening
            reach = -places[0] / step, places[-1] / step
            reaches.setdefault(flow[direction], []).append(reach)
        of_flows = [
            np.quantile(reaches_of_flow, COVERED_KNOT_SHARE, axis=0)
            for reaches_of_flow in reaches.values()
        ]
        sides.append(np.max(of_flows, axis=0).tolist())
    return _whole_cells(sides)


def _halved(sides: Sequence[tuple[int, int]]) -> tuple[tuple[int, int], ...]:
    """Cells of twice the size on each side that reach as far as some cells."""
    return _whole_cells(np.array(sides) / 2)


def _whole_cells(sides: Iterable[Sequence[float]]) -> tuple[tuple[int, int], ...]:
    """Cells before and behind the contact point along each direction, as grids of the kernel have them.

    The shorter side is filled up, whichever it is: a contact that is turned round has its grid turned round.
    """
    half, whole = CELLS // 2, []
    for side in sides:
        before, behind = (half * ceil(reach / half - ROUNDING) for reach in side)
        surplus = (before + behind) % CELLS
        shorter = before < behind
        whole.append((before + surplus * shorter, behind + surplus * (not shorter)))
    return tuple(whole)


def _covering(
    sides: tuple[int, int],
    times: Sequence[float],
    half_widths: Sequence[float],
    drawn: Sequence[float],
    grids: Sequence[LineGrid],
    log_spacing: np.polynomial.Polynomial,
) -> tuple[int, int]:
    """Cells of a line's grid before and behind the contact point; more where Hertz's contact lies beyond.

    A spacing that is smooth in time does not follow a blow; then the grid has room for the windows of all
    times, between those that are drawn in proportion to the half-widths.
    """
    steps = np.exp([log_spacing(seconds) for seconds in times])
    widths = np.array(half_widths)
    if min(sides) >= np.max(widths / steps):
        return sides
    ends = []
    for side, reaches in zip(
        sides, zip(*((-grid.x[0], grid.x[-1]) for grid in grids), strict=True), strict=True
    ):
        windows = np.interp(times, drawn, reaches / np.interp(drawn, times, widths))
        ends.append(max(side, np.max(windows * widths / steps)))
    return _whole_cells([ends])[0]


def _holding(
    sides: Sequence[tuple[int, int]],
    times: Sequence[float],
    predictions: Sequence[Prediction],
    grids: Sequence[Grid],
    log_spacings: Sequence[np.polynomial.Polynomial],
) -> tuple[tuple[int, int], ...]:
    """Cells of a point's grid before and behind the contact point; more where Hertz's contact lies beyond.

    It lies within the windows of `grids`, which end where surfaces do.
    """
    needed = [list(side) for side in sides]
    for seconds, prediction, grid in zip(times, predictions, grids, strict=True):
        reaches = np.abs(np.reshape(grid.box, (2, 2)))
        lengths = prediction.half_width, prediction.half_length
        for side, log_spacing, reach, length in zip(
            needed, log_spacings, reaches, lengths, strict=True
        ):
            cells = np.minimum(reach, CONTACT_MARGIN * length) / exp(log_spacing(seconds))
            side[:] = np.maximum(side, cells)
    return _whole_cells(needed)


def _spacings(
    times: Sequence[float], grids: Sequence[Grid | LineGrid], coarsening: float, written: bool
) -> tuple[np.polynomial.Polynomial, ...]:
    """Logarithm of the spacing along each direction over time; constant if possible (`MAX_SPACING_RATIO`)."""
    logs = np.log([[coarsening * step for step in grid.spacing] for grid in grids])
    if written and np.all(np.ptp(logs, axis=0) <= 2 * log(MAX_SPACING_RATIO)):
        middle = (logs.max(axis=0) + logs.min(axis=0)) / 2
        return tuple(np.polynomial.Polynomial([values]) for values in middle)
    degree = min(SPACING_DEGREE, len(times) - 1)
    return tuple(np.polynomial.Polynomial.fit(times, values, degree) for values in logs.T)


def _pace(
    times: Sequence[float],
    contacts: Sequence[AnyContact],
    predictions: Sequence[Prediction],
    life: Life,
) -> "scipy.interpolate.PPoly":
    """Transits over time; the integral of the inverse of the transit time.

    In a written course, which may change far faster than oil passes, an e-fold of load, or of the distance of
    surfaces that are apart, counts as one, in a tooth pair's two of them (`FOLDS`).
    """
    duration = life.duration
    paces = [max(1 / prediction.transit, LEAST_TRANSITS / duration) for prediction in predictions]
    each = 1.0 if life.kinks else 1 / FOLDS
    for number, (before, after) in enumerate(pairwise(zip(times, contacts, strict=True))):
        folds = each * _folds(before[1], after[1]) / (after[0] - before[0])
        for end in (number, number + 1):
            paces[end] = max(paces[end], folds)
    return _summed(times, paces, duration)


def _summed(
    times: Sequence[float], paces: Sequence[float], duration: float
) -> "scipy.interpolate.PPoly":
    """Integral of a pace over a life; before the first and after the last of its times it stays the same."""
    knots = [0.0] * (times[0] > 0) + [*times] + [duration] * (times[-1] < duration)
    known = np.interp(knots, times, paces)
    return scipy.interpolate.PchipInterpolator(knots, known).antiderivative()


def _folds(before: AnyContact, after: AnyContact) -> float:
    """E-folds of the load between two contacts, or of the distance of surfaces that are apart."""
    if before.separation is not None and after.separation is not None:
        return abs(log(after.separation / before.separation))
    return abs(log(after.load / before.load))
