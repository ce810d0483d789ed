"""The transient term of a contact that changes while oil passes through it.

The Reynolds equation has d(rho h)/dt. Oil under pressure at present entered the contact some time ago, under
other load, curvature and edges, and its film is that of its entry. One transient solve
(`integrate_in_time`) goes through the life of the contact and gives the rate of change at any time of it,
which the films on all grids of the figures take. It is made twice, the second time with half the spacing and
half the time step (of worm teeth through a stretch before that time alone); what that changes tells its
error, and a third time where that does not do.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import ceil, floor, inf, nextafter

import numpy as np

from pyworm.io.plain_dataset import PlainDataset
from pyworm.io.quantity_text import percent
from pyworm.planning import error_budget
from pyworm.planning.expected_work import Kind, solves_of_life
from pyworm.planning.plan import Plan
from pyworm.planning.prediction import predicted
from pyworm.planning.target import HEAT_FIGURES
from pyworm.scene.life import Life, Past
from pyworm.scene.line import LineScene
from pyworm.scene.point import Scene
from pyworm.solver.kinds import SOLVERS
from pyworm.solver.level import Level, TransientTerm
from pyworm.solver.stop_reason import MAX_USED_ERROR
from pyworm.solver.transient.film_series import TooMuchWorkError
from pyworm.solver.transient.next_film import MEMORY_TRANSITS, NoFilmError
from pyworm.solver.transient.rate_errors import error_share, least_error
from pyworm.solver.transient.rated_films import RatedFilms, rated_films
from pyworm.solver.transient.tied_rate import tied
from pyworm.solver.transient.time_grid import ROUNDING, TimeGrid, time_grid_of
from pyworm.solver.transient.time_integration import (
    RateOfChange,
    TimeIntegration,
    integrate_in_time,
    integrate_on,
)
from pyworm.solver.transient.time_records import TimeRecord, completed, curves, until
from pyworm.solver.transient.time_steps import places_of

WARM_UP: dict[Kind, float] = {"point": 2.0, "line": 3.0}
"""Passages of oil before the first wanted time at which a solve of a later part of a life begins, from a
steady film.

What that leaves is the same in all solves, so that their differences do not show it: under a speed that
swings by 40 % in four transits 1.1 % of a thick film of a line after two transits, 0.01 % after four. Errors
of points are larger, and so is the cost of their transits."""

MAX_PART_TRANSITS: dict[Kind, float] = {"point": 16.0, "line": 4.0}
"""Most transits of a part of a life whose films are wanted, so that several processes may work on a long one:
each part repeats the warm-up. The life of a pair of worm teeth, some eleven transits, has one: with two the
whole of `cases/zi_drive.toml` takes a tenth more time by one process (86 s for 78), and a tenth less by two
(55 s for 61)."""

MAX_ALONE_TRANSITS: dict[Kind, float] = {"point": 8.0, "line": 4.0}
"""Most transits of a part whose films are wanted, of one contact alone, solved from the begin of its part.

Two transits of warm-up leave 0.02 % in the film of phase 0.5 of `cases/zi_drive.toml` by the first solve,
0.11 % in that of phase 0.9 of a rough set (a = 100 mm, 2/41); to 1 % the former takes a third of the time
from the first touch."""

MAX_WHOLE_TRANSITS, RECENT_TRANSITS = 30.0, 6.0
"""Transits of the present contact from which on a life is not solved as a whole, and how many of them are
then before the present."""

USABLE_ERROR = error_budget.TIME * MAX_USED_ERROR
"""Error of the films by the last transient solve up to which it is used although it exceeds the accuracy: its
share of the largest error with which a film is used."""

MAX_SOLVES, USUAL_SOLVES = 4, 3
"""Maximum number of transient solves, each of which costs eight times the previous one, and a usual one."""

MOST_WORK = {2: 8e8, 3: 1.2e8}
"""Nodes times time steps of one more solve after two and three, as of a point contact without heat.

The fourth takes up to two and a half minutes: balls and ellipses whose entrainment turns round or starts from
rest come by it from 12 to 43 % to 1 to 3 %. The third, which settles most teeth that touch at an edge, takes
up to five at the usual number of Newton steps. Without end that of phase 0.7 of drive 0 of seed 99016 of
`tests/hard` had found no film after 20 minutes; two leave 6 % in its films and 18 % in temperatures."""

MOST_NEWTON_STEPS = 10
"""Newton steps of one more solve for each of its time steps, on the mean over their nodes, after which it is
given up: 3 to 6 at phases 0.5 and 0.9 of drive 0 of seed 99020."""

LEAST_WORK = 4e7
"""Newton steps times nodes up to which it is not given up, two or three minutes between rough surfaces: 16
Newton steps a time step take 62 s at phase 0.1 of that drive, where two solves differ by 60 %."""

LIMITED_TIME_RATIO = 5.0
"""Time of a time step where rates of change are limited over that where they are not: each is halved, halves
start from worse guesses, and are halved again."""

HEAT_TIME_RATIO, ROUGH_TIME_RATIO = 5.0, 2.5
"""Time of a node's time step with heat over that without, and with rough surfaces over that with smooth ones:
5.6 us of `cases/zi_drive.toml`, 1.2 us of an ellipse, and 14 to 20 us of drives 0 of seeds 61001 and 61002 of
`tests/hard` while the machine did other work."""


@dataclass(frozen=True)
class Part:
    """A part of a life that one transient solve goes through."""

    begin: float
    """Where the solve begins [transits]."""
    first: float
    """From where its films are wanted [transits]."""
    last: float
    """Up to where its films are wanted [transits]."""

    def holds(self, place: float) -> bool:
        """Whether the film of a place is wanted of it [transits]."""
        return self.first <= place < self.last


def parts_of(
    time_grid: TimeGrid, longest: Mapping[Kind, float] = MAX_PART_TRANSITS
) -> tuple[Part, ...]:
    """The parts of a life, which share instants; a written course, which no other contact shares, is one."""
    whole, step = time_grid.transits(time_grid.end), time_grid.step(0)
    kind = time_grid.plan.work.kind
    warm_up, most = WARM_UP[kind], longest[kind]
    count = 1 if time_grid.life.kinks else max(1, ceil((whole - warm_up) / most))
    length = (whole - warm_up) / count
    firsts = [step * round((warm_up + length * number) / step) for number in range(1, count)]
    return tuple(
        Part(step * floor(_begin(time_grid, first) / step + ROUNDING), first, last)
        for first, last in pairwise((0.0, *firsts, inf))
    )


def _begin(time_grid: TimeGrid, wanted: float) -> float:
    """Where a solve begins whose films are wanted from a place on [transits].

    Oil at rest between surfaces nearly in touch, from which it would begin, is not what their approach has
    left: phase 0.1 of drive 3 of seed 99009 of `tests/hard`, 0.9 transits after the touch, had 15 % too much
    of it where a third solve began 1.1 transits before.
    """
    place = time_grid.place_before(wanted, WARM_UP[time_grid.plan.work.kind])
    if place <= 0 or time_grid.come_together(time_grid.time_at(place)):
        return 0.0
    return place


def present_in_life(scene: Scene | LineScene) -> Past:
    """The present of a contact in its life; ValueError of one in which nothing changes."""
    if scene.past is None:
        raise ValueError(f"{scene.name}: has no past")
    return scene.past


def recent(scene: Scene | LineScene) -> Past:
    """The past of a contact, without what is so long ago that it is forgotten."""
    past = present_in_life(scene)
    transit = predicted(scene).transit
    if past.until is not None or past.life.duration <= MAX_WHOLE_TRANSITS * transit:
        return past
    start = max(past.seconds - RECENT_TRANSITS * transit, 0.0)
    end = min(past.seconds + transit, past.life.duration)
    life = Life(
        end - start,
        lambda seconds: past.life.at(start + seconds),
        lambda seconds: past.life.axes_at(start + seconds),
        tuple(kink - start for kink in past.life.kinks if start < kink < end),
        past.life.touch,
        past.life.touched - start,
    )
    return Past(life, past.seconds - start)


def part_at(
    time_grid: TimeGrid, seconds: float, longest: Mapping[Kind, float] = MAX_PART_TRANSITS
) -> Part:
    """The part of a life that a time [s] belongs to; ValueError if it carries no load at that time."""
    if not time_grid.begin <= seconds <= time_grid.end:
        raise ValueError(f"its surfaces carry no load at {seconds:.3g} s")
    place = time_grid.place(seconds)
    return next(part for part in parts_of(time_grid, longest) if part.holds(place))


def begin_of_one(time_grid: TimeGrid, seconds: float) -> float:
    """Where a solve for one contact alone begins, at a time [s]: as long before it as a part does [transits].

    That leaves some per cent in a rate of change, less than the error of those of points. Lines, whose rates
    have smaller errors and cost little, begin with their part, and so does a written course, whose transits
    may be far shorter than the passage of oil.
    """
    begin = part_at(time_grid, seconds, MAX_ALONE_TRANSITS).begin
    kind = time_grid.plan.work.kind
    if kind == "line" or time_grid.life.kinks:
        return begin
    return max(begin, _begin(time_grid, time_grid.place(seconds)))


def begin_of_further(
    time_grid: TimeGrid, seconds: float, solves: int, limited: bool = False
) -> float | None:
    """Where one more transient solve for one contact begins [transits]; None where it is one too many.

    `limited` tells whether rates of change by the one before are limited.
    """
    if solves >= MAX_SOLVES:
        return None
    begin = begin_of_one(time_grid, seconds)
    work = node_steps(time_grid, seconds, solves, begin)
    model = time_grid.plan.model
    work *= HEAT_TIME_RATIO if model.heated else 1
    work *= ROUGH_TIME_RATIO if model.rough else 1
    work *= LIMITED_TIME_RATIO if limited else 1
    return begin if work <= MOST_WORK.get(solves, inf) else None


def node_steps(time_grid: TimeGrid, seconds: float, refinement: int, begin: float) -> float:
    """Nodes times time steps of a transient solve for one contact, from where it begins [transits]."""
    steps = places_of(time_grid, refinement, begin, time_grid.place(seconds))
    return float(sum(time_grid.grid_of_contact(seconds, on).nodes for on, _ in steps))


@dataclass(frozen=True)
class Rates:
    """Rates of change at one time, one of each refinement, or the reason why there are none."""

    found: tuple[RateOfChange, ...]
    """The rates, the finest last."""
    records: tuple[tuple[TimeRecord, ...], ...] = ()
    """What each of the solves that began with the part, at least the first, found up to that time; of
    stretches completed (`time_records.completed`)."""
    since: float = -inf
    """Time of the scene before, after which they are kept [s]."""
    begin: float = 0.0
    """Where the solves of the records begin [transits]."""
    flaw: str | None = None
    """Reason why a film before was not found."""
    finest: bool = False
    """Whether no further solve is to be had."""


@dataclass(frozen=True)
class Transient:
    """The transient term of a contact at present."""

    rate: TransientTerm | None
    """d(rho h)/dt at present; None where a film at an earlier time was not found."""
    level: Level
    """The film with that rate, on the plan's first grid of the figures."""
    errors: dict[str, float]
    """Relative error of its figures by grids and time steps of the transient solve."""
    flaw: str | None
    """Reason why the rate is not to be trusted."""
    coarse: bool = False
    """Whether one more transient solve may mend that."""
    life: PlainDataset | None = None
    """Figures and frames of the film up to now (`records.curves`)."""
    film_error: float = inf
    """Largest error of films and friction by the transient solve."""
    heat_error: float = inf
    """Largest error by it of these and of temperatures."""

    @property
    def usable(self) -> bool:
        """Whether a film with a flawed rate is better than none, with error bars as wide as that leaves."""
        return self.flaw is not None and not self.coarse and self.film_error <= USABLE_ERROR

    def attainable(self, plan: Plan) -> Plan:
        """The plan with the accuracy that the rate leaves, of temperatures where these have it, too."""
        heated = self.heat_error <= USABLE_ERROR
        error = self.heat_error if heated else self.film_error
        target = plan.target if heated else plan.target.without(*HEAT_FIGURES)
        accuracy = max(plan.accuracy, error / error_budget.TIME)
        return replace(plan, accuracy=accuracy, target=target)


def rates_at_present(scene: Scene | LineScene, plan: Plan) -> Rates:
    """Rates of change of a contact at present, by transient solves of the part of its life before."""
    past = recent(scene)
    solves: list[TimeIntegration] = []
    number = solves_of_life(plan.accuracy)
    try:
        time_grid = time_grid_of(past.life, plan)
        begin = part_at(time_grid, past.seconds, MAX_ALONE_TRANSITS).begin
        for _ in range(number):
            found = _next_solve(time_grid, past, begin, solves, number)
            if past.seconds not in found.rates:  # finer ones would cost more, and be of no use
                break
            solves.append(found)
    except (NoFilmError, ValueError) as reason:  # of no contact in motion, or of a film
        if not solves:
            return Rates((), flaw=str(reason))
    if not solves:
        return Rates((), flaw=found.failure)
    return Rates(
        tuple(solve.rates[past.seconds] for solve in solves),
        completed([(until(solve.records, past.last), solve.memory_end) for solve in solves]),
        begin=begin,
        finest=len(solves) < number,
    )


def _next_solve(
    time_grid: TimeGrid, past: Past, begin: float, solves: Sequence[TimeIntegration], number: int
) -> TimeIntegration:
    """The next of some transient solves: it begins at a place [transits], or with films of the last."""
    after = 0 if past.until else number - len(solves) - 1
    restart = solves[-1].restarts.get(past.seconds) if solves else None
    if restart is not None:
        return integrate_on(time_grid, restart, begin, [past.seconds], after)
    how = begin, [past.seconds], past.last, after
    return integrate_in_time(time_grid, len(solves), *how)


def finer(scene: Scene | LineScene, plan: Plan, rates: Rates) -> Rates:
    """The rates with that of one more transient solve of the life before; else marked as the finest."""
    past, solves = recent(scene), len(rates.found)
    time_grid = time_grid_of(past.life, plan)
    begin = begin_of_further(time_grid, past.seconds, solves, rates.found[-1].limited)
    if begin is None:
        return replace(rates, finest=True)
    usual_work = MOST_NEWTON_STEPS * node_steps(time_grid, past.last, solves, begin)
    most_work = max(usual_work, LEAST_WORK)
    try:
        found = integrate_in_time(time_grid, solves, begin, [past.seconds], past.last, 0, most_work)
    except (NoFilmError, TooMuchWorkError):
        return replace(rates, finest=True)
    if past.seconds not in found.rates:
        return replace(rates, finest=True)
    records = [until(found.records, past.last)] * (begin == rates.begin)
    return replace(
        rates,
        found=(*rates.found, found.rates[past.seconds]),
        records=(*rates.records, *records),
    )


def transient(scene: Scene | LineScene, plan: Plan, rates: Rates) -> Transient:
    """The film of a contact with the rate of change of transient solves, and the error of its figures."""
    solver_type = SOLVERS[type(scene)]
    level, _ = solver_type(scene, plan).begin(plan.grids)
    if rates.flaw is not None:
        return Transient(None, level, dict.fromkeys(level.read().figures, inf), rates.flaw)

    slow = _settles_slowly(scene, rates, plan.work.kind)
    first = rated_films(scene, plan, rates.found, slow, level)
    films = _refined(first)
    if not films.within and (solved := tied(scene, rates.found)):
        by_ties = _refined(rated_films(scene, plan, solved, slow, level))
        films = min(films, by_ties, key=lambda some: some.heat_error)
    level = first.level if films.rate is first.rate else first.with_rate(films.rate)
    flaw = None
    # finer grids of the present film would not mend that
    if not films.within:
        flaw = f"the transient solve through the engagement leaves an error of {percent(films.heat_error)}"
    coarse = flaw is not None and not rates.finest and len(rates.found) < MAX_SOLVES
    life = _life(scene, plan, rates, first)
    return Transient(
        films.rate, level, films.errors, flaw, coarse, life, films.film_error, films.heat_error
    )


def _refined(films: RatedFilms) -> RatedFilms:
    """Films on grids so fine that what the transient solves leave is within its share, if any are."""
    while not films.within and (finer := films.finer()) is not None:
        films = finer
    return films


def _settles_slowly(scene: Scene | LineScene, rates: Rates, kind: Kind) -> bool:
    """Whether films settle with the first order of the time step at best."""
    if any(rate.limited for rate in rates.found[-2:]):
        return True
    return _turned_round(scene, rates.records, kind)


def _turned_round(
    scene: Scene | LineScene, solves: Sequence[Sequence[TimeRecord]], kind: Kind
) -> bool:
    """Whether the entrainment has turned round while oil went the last `WARM_UP` lengths of the contact."""
    records = until(solves[-1], recent(scene).seconds)
    length, distance = WARM_UP[kind] * 2 * predicted(scene).half_width, 0.0
    for after, before in pairwise(reversed(records)):
        if np.dot(before.entrainment, records[-1].entrainment) < 0:
            return True
        distance += float(np.hypot.reduce(after.entrainment)) * (after.seconds - before.seconds)
        if distance > length:
            break
    return False


def _life(
    scene: Scene | LineScene,
    plan: Plan,
    rates: Rates,
    films: RatedFilms,
) -> PlainDataset:
    """The film up to now since the scene before, one instant at least.

    It is that of the solves through the whole part, whose curves go on from one scene to the next.
    """
    since = min(rates.since, nextafter(rates.records[-1][-1].seconds, -inf))
    kind = plan.work.kind
    heat = scene.oil.heat
    coldest = None
    if plan.model.heated and heat is not None:
        coldest = heat.inlet_temperature + scene.coldest
    shared = films.readings[: len(rates.records) + 1]
    share, least = error_share(kind, films.slow), least_error(shared, kind, films.slow)
    present_seconds = present_in_life(scene).seconds
    reach = MEMORY_TRANSITS * 2 * predicted(scene).half_width
    shown = share, least, present_seconds, films.figures, coldest, reach
    return curves(rates.records, since, kind, *shown)
