"""Small random missions, explored a second time without any cleverness: the verifier says the same of them.

Two robots with a button each, which may be pressed at any tick, share two variables. In lockstep the second explorer
steps the simulator itself, from snapshots, with every choice of buttons; in free timing it ticks one real `Machine`
after another, or both at once. It knows nothing of tables, liveness of cells, classes of readings or masks.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, combinations, product
from typing import Any

import pytest

from kitrobot.image.machine import Machine
from kitrobot.lll.printer import print_program
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.state import numbers
from kitrobot.sim.team.shared_variables import SHARED_VALUE
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.exploration import StateSpace, explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.custom_properties import build_custom_properties, property_variables
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from tests.effort import examples
from tests.sim.building import avatar, empty_world, run_of
from tests.strategies.programs import Shape, random_program

MOST_STATES = 1_500
"""Missions with more are left out: both explorers would take long."""

ROBOT = avatar(
    """<sensor name="Button" device="key" type="boolean"><operation name="IsPressed" test="equal" to="1"/></sensor>""",
    """<variable name="Flag" type="boolean" initial="false" shared="yes"/>""",
    """<variable name="Count" type="integer" min="0" max="3" initial="0" shared="yes"/>""",
)

State = tuple[Any, ...]


def explored(first: State, after: Callable[[State], Iterator[State]]) -> dict[State, set[State]] | None:
    """Every state that can be reached, with those that may follow it; None when there are too many."""
    found: dict[State, set[State]] = {}
    todo = [first]
    while todo:
        state = todo.pop()
        if state in found:
            continue
        if len(found) == MOST_STATES:
            return None
        found[state] = set(after(state))
        todo += found[state]
    return found


@dataclass(frozen=True)
class Standstill:
    """Whether nothing can come any more before both programs have ended, but that they go round: `strictly`, when no
    button makes any difference; `as_seen`, when it makes one in temporary cells only, which a later tick may or may not
    read.
    """

    strictly: bool
    as_seen: bool


def standstill(
    found: dict[State, set[State]],
    ways: Callable[[State], list[set[State]]],
    seen: Callable[[State], State],
    values: Callable[[State], State],
    ended: Callable[[State], bool],
) -> Standstill:
    """Looks for states that are never left, in which no shared variable changes and buttons make no difference.

    Args:
        found: the states that may follow each.
        ways: the same, apart for each that may tick next.
        seen: a state without its temporary cells.
        values: the shared variables of a state.
        ended: whether both programs have ended in it.
    """

    def is_there(looks: Callable[[State], State]) -> bool:
        still = {
            state
            for state, following in found.items()
            if not ended(state)
            and all(values(one) == values(state) for one in following)
            and all(len({looks(one) for one in way}) < 2 for way in ways(state))
        }
        while left := {state for state in still if not found[state] <= still}:
            still -= left
        return bool(still)

    return Standstill(is_there(lambda state: state), is_there(seen))


def without_temporaries(machine: Machine, cells: Sequence[int]) -> tuple[int, ...]:
    """The fault flag and the variables."""
    return (cells[0], *(cells[cell] for cell in machine.layout.variables.values()))


def random_run(rng: random.Random, robots: int = 2) -> tuple[Simulation, list[str]]:
    """Robots with random programs in an empty room."""
    texts = [print_program(random_program(rng, ROBOT, Shape(instructions=5, depth=3))) for _ in range(robots)]
    names = "abc"[:robots]
    world = empty_world(**{name: (200.0 + 300 * n, 600, 0) for n, name in enumerate(names)})
    return run_of({name: (ROBOT, text) for name, text in zip(names, texts, strict=True)}, world, seconds=None), texts


def in_lockstep(run: Simulation) -> Standstill | None:
    """Whether the simulator can come to stand still; None when it has too many states."""
    snapshots: dict[State, bytes] = {}
    ends: dict[State, bool] = {}

    def seen() -> State:
        made: list[object] = [tuple(numbers(run.state.shared.ints[SHARED_VALUE]))]
        for member in run.members:
            rows = (run.state.machines.cells, run.state.machines.threads, run.state.machines.pars)
            cells, threads, pars = (list(numbers(row[member.index])) for row in rows)
            for cell in member.machine.layout.sensors.values():
                cells[cell] = 0
            made.append((tuple(cells), tuple(threads), tuple(pars)))
        state = tuple(made)
        snapshots.setdefault(state, run.snapshot())
        ends[state] = all(numbers(run.state.machines.threads[member.index])[0] < 0 for member in run.members)
        return state

    def after(state: State) -> Iterator[State]:
        for pressed in product((0, 1), repeat=len(run.members)):
            run.restore(snapshots[state])
            # What it makes of its end is not asked: it does not know that a button may be pressed.
            run.outcome = None
            for member, value in zip(run.members, pressed, strict=True):
                run.force(member.name, "Button", value)
            run.advance(1)
            yield seen()

    found = explored(seen(), after)
    if found is None:
        return None
    machines = [member.machine for member in run.members]

    def looks(state: State) -> State:
        return state[0], *(
            (without_temporaries(m, one[0]), one[1:]) for m, one in zip(machines, state[1:], strict=True)
        )

    return standstill(found, lambda state: [found[state]], looks, lambda state: state[0], lambda state: ends[state])


DOWNS = ("well", "stalled", "failed")


class Free:
    """Machines of which any may tick next, or all, and tell what they wrote at once; so many may fail for good, or
    stall and perhaps go on. A state is their snapshots, what befell each, and how many failures may still come.
    """

    def __init__(self, run: Simulation, failures: int = 0) -> None:
        self.machines = [member.machine.twin() for member in run.members]
        self.first = self.seen((0,) * len(self.machines), failures)

    def put(self, state: State) -> None:
        for machine, snapshot in zip(self.machines, state[:-2], strict=True):
            cells, threads, pars = (list(part) for part in snapshot)
            machine.restore((cells, threads, pars))

    def seen(self, downs: tuple[int, ...], left: int) -> State:
        for machine in self.machines:
            machine.set_input("Button", 0)
        return *(tuple(map(tuple, machine.snapshot())) for machine in self.machines), downs, left

    def ways(self, state: State) -> list[set[State]]:
        """What may follow where these tick next: one alone, or several at once, which read what was there before."""
        *_, downs, _ = state
        well = [n for n, down in enumerate(downs) if DOWNS[down] == "well"]
        return [
            {self.ticked(state, dict(zip(who, pressed, strict=True))) for pressed in product((0, 1), repeat=len(who))}
            for who in chain.from_iterable(combinations(well, size + 1) for size in range(len(well)))
        ]

    def ticked(self, state: State, pressed: dict[int, int]) -> State:
        """After a tick of these machines, each with its button so; of what several write the last one's holds."""
        *_, downs, left = state
        self.put(state)
        before = dict(self.machines[0].variables())
        after = dict(before)
        for n, value in pressed.items():
            self.machines[n].set_input("Button", value)
            self.machines[n].tick()
            after.update({name: one for name, one in self.machines[n].variables().items() if one != before[name]})
        for machine, (name, one) in product(self.machines, after.items()):
            machine.set_variable(name, one)
        return self.seen(downs, left)

    def after(self, state: State) -> Iterator[State]:
        *snapshots, downs, left = state
        for way in self.ways(state):
            yield from way
        for n, ended in enumerate(self.ended(state)):
            if left and not ended:
                for what in range(downs[n] + 1, len(DOWNS)):
                    yield *snapshots, (*downs[:n], what, *downs[n + 1 :]), left - 1
            if DOWNS[downs[n]] == "stalled":
                yield *snapshots, (*downs[:n], 0, *downs[n + 1 :]), left

    def ended(self, state: State) -> tuple[bool, ...]:
        self.put(state)
        return tuple(machine.ended for machine in self.machines)

    def looks(self, state: State) -> State:
        return tuple(
            (without_temporaries(m, one[0]), one[1:]) for m, one in zip(self.machines, state[:-2], strict=True)
        )

    def shown(self, state: State) -> State:
        """The shared variables, whose programs have ended, what befell whom, and how many failures are left."""
        ended = self.ended(state)
        values = self.machines[0].variables()
        return (int(values["Flag"]), int(values["Count"])), ended, *state[-2:]


def in_free_timing(run: Simulation) -> Standstill | None:
    """Whether robots that lag as they like can come to stand still; None when there are too many states."""
    free = Free(run)
    found = explored(free.first, free.after)
    if found is None:
        return None
    return standstill(
        found, free.ways, free.looks, lambda state: free.shown(state)[0], lambda state: all(free.ended(state))
    )


@pytest.mark.parametrize(
    ("timing", "brute_force"), [(Timing.LOCKSTEP, in_lockstep), (Timing.FREE, in_free_timing)], ids=["lockstep", "free"]
)
def test_random_missions_stand_still_where_brute_force_says_so(
    timing: Timing, brute_force: Callable[[Simulation], Standstill | None]
) -> None:
    said = {True: 0, False: 0}
    for seed in range(examples(15, 2000)):
        run, texts = random_run(random.Random(seed))
        model = Model(run, abstract_run(run), 0, timing)
        stands = brute_force(run)
        if stands is None:
            continue
        ready = [one for one in ready_properties(model) if one.name == "deadlock"]
        made = check_properties(model, ready, Budget(10 * MOST_STATES))
        assert made.complete, texts
        broken = made.verdicts[0].answer.value == "broken"
        assert stands.strictly <= broken <= stands.as_seen, (seed, texts)
        said[broken] += stands.strictly == stands.as_seen
    assert min(said.values()) > 5


def shown(made: StateSpace) -> set[State]:
    """What `Free.shown` shows, of the states of a model."""
    model, found = made.model, set()
    for number in range(len(made)):
        shared, *agents = made.state(number)[: 1 + model.count]
        left, flag, count = model.shareds()[shared]
        insides = [model.inside(i, inside) for i, inside in enumerate(agents)]
        ended = tuple(model.has_ended(i, inside) for i, inside in enumerate(insides))
        found.add(((flag, count), ended, tuple(inside.down for inside in insides), left))
    return found


@pytest.mark.parametrize(("robots", "failures"), [(2, 0), (2, 1), (2, 2), (3, 0)])
def test_random_missions_with_failures_come_where_brute_force_comes_and_nowhere_else(
    robots: int, failures: int
) -> None:
    compared = 0
    for seed in range(examples(8, 500)):
        run, texts = random_run(random.Random(seed), robots)
        free = Free(run, failures)
        found = explored(free.first, free.after)
        if found is None:
            continue
        model = Model(run, abstract_run(run), failures, Timing.FREE)
        made = explore(model, Budget(10 * MOST_STATES), False)
        assert made.complete, texts
        assert shown(made) == {free.shown(state) for state in found}, (seed, texts)
        compared += 1
    assert compared > 5


def test_whoever_lags_as_he_likes_comes_wherever_he_comes_in_step() -> None:
    """Each state of lockstep is one of free timing, and of prompt where the world has no events."""
    compared = more = 0
    for seed in range(examples(10, 2000)):
        run, texts = random_run(random.Random(seed), 3)
        models = {timing: Model(run, abstract_run(run), 0, timing) for timing in Timing}
        made = {timing: explore(model, Budget(10 * MOST_STATES), False) for timing, model in models.items()}
        if all(one.complete for one in made.values()):
            seen = {timing: shown(one) for timing, one in made.items()}
            assert seen[Timing.LOCKSTEP] <= seen[Timing.PROMPT] == seen[Timing.FREE], (seed, texts)
            compared += 1
            more += seen[Timing.LOCKSTEP] < seen[Timing.FREE]
    assert min(compared, more) > 5


ENTERS = """*( {own}.Set(1); Last.Set({number}); <{other}.EqualTo(0) | Last.EqualTo({turn})>(
    In{own}.Set(1); WAIT(20); In{own}.Set(0); {own}.Set(0); WAIT(20);
); );"""


@pytest.mark.parametrize("timing", list(Timing))
def test_two_that_ask_in_the_same_moment_enter_together_in_every_timing(timing: Timing) -> None:
    """Peterson's algorithm needs one write after another: it is no good for robots that tick in the same moment."""
    robot = avatar(
        *(
            f'<variable name="{name}" type="integer" min="0" max="2" initial="0" shared="yes"/>'
            for name in ("A", "B", "Last", "InA", "InB")
        )
    )
    a, b = ENTERS.format(own="A", number=1, other="B", turn=2), ENTERS.format(own="B", number=2, other="A", turn=1)
    run = run_of({"a": (robot, a), "b": (robot, b)}, empty_world(a=(200, 200, 0), b=(600, 600, 0)))
    asked = [AskedProperty("mutex", Form.NEVER, "any a (InA.EqualTo(1)) & any b (InB.EqualTo(1))")]
    model = Model(run, abstract_run(run, property_variables(run, asked)), 0, timing)
    properties, left_out = build_custom_properties(model, asked)
    assert left_out == []
    (verdict,) = check_properties(model, properties, Budget(10_000)).verdicts
    assert verdict.answer.value == "broken"
