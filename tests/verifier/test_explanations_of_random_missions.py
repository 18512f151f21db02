"""Explanations of small random missions, held against plain searches of all their states.

The searches here know what a step of the model is, and no more: no delta debugging, no fair parts, no limits. Robots
without roads have no progress classes in lockstep, so there every run that goes on for ever is fair.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import pytest

from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.exploration import StateSpace, explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.custom_properties import build_custom_property, property_variables
from kitrobot.verifier.properties.properties import BROKEN, Condition, Property
from kitrobot.verifier.properties.verdicts import Counterexample, Step, check_properties
from kitrobot.verifier.report.avoidance import Certainty
from kitrobot.verifier.report.explanation import Explanation, explain_run
from kitrobot.verifier.report.minimization import events_of
from kitrobot.verifier.tables.events import Event, EventKind
from kitrobot.verifier.tables.motion import Move
from tests.effort import examples
from tests.sim.building import empty_world, run_of, transport
from tests.verifier.test_brute_force import ROBOT
from tests.verifier.test_custom_properties import holds

MOST_STATES = 1_500
Node = tuple[State, object]
"""A state, and what is left of what came before it."""
CONDITIONS = [
    "any a (Flag.IsTrue())",
    "any a (Count.EqualTo(1))",
    "any b (Count.EqualTo(2))",
    "any a (Count.EqualTo(0))",
    "any b (Flag.IsFalse())",
]


STATEMENTS = [
    "Flag.Set(1);",
    "Flag.Set(0);",
    "Count.Set(1);",
    "Count.Set(2);",
    "WAIT(1);",
    "[Button.IsPressed()]( Count.Set(2); );",
    "[Button.IsPressed()]( Flag.Set(1); );",
    "[Flag.IsTrue()]( Count.Set(1); );",
    "[Count.EqualTo(0)]( Flag.Set(1); );",
    "*[Button.IsPressed()]( Count.Set(1); );",
    "*[Flag.IsFalse()]( [Button.IsPressed()]( Flag.Set(1); ); );",
]


def branching_run(rng: random.Random) -> tuple[Simulation, list[str]]:
    """Two robots whose programs mostly ask for their buttons and for what they share."""
    texts = [" ".join(rng.choices(STATEMENTS, k=4)) for _ in "ab"]
    world = empty_world(a=(200, 600, 0), b=(500, 600, 0))
    return run_of({name: (ROBOT, text) for name, text in zip("ab", texts, strict=True)}, world, seconds=None), texts


def random_property(rng: random.Random) -> AskedProperty:
    one, other = rng.sample(CONDITIONS, 2)
    form = rng.choice([Form.NEVER, Form.EVENTUALLY, Form.AFTER, Form.AT_MOST, Form.STAYS])
    if form is Form.AT_MOST:
        return AskedProperty("asked", form, one, times=1)
    return AskedProperty("asked", form, one, "" if form in (Form.NEVER, Form.EVENTUALLY) else other)


class Memory:
    """The same as `PropertyMemory` says of a run, said plainly: what came before is the whole run."""

    def __init__(self, model: Model, one: Property) -> None:
        self._model, self._one = model, one

    def holds(self, condition: Condition | None, state: State) -> bool:
        return holds(self._model, condition, state)

    def is_broken(self, states: Sequence[State]) -> bool:
        """Whether a run has broken a property of safety."""
        one = self._one
        if one.never is not None:
            return any(self.holds(one.never, state) for state in states)
        if one.breaks is not None:
            first, second = one.breaks
            return any(self.holds(first, before) and self.holds(second, after) for before, after in pairwise(states))
        if one.history is not None:
            memory, had = 0, (False,) * len(one.history.conditions)
            for state in states:
                now = tuple(self.holds(condition, state) for condition in one.history.conditions)
                comes = tuple(new and not old for new, old in zip(now, had, strict=True))
                memory, had = one.history.step(memory, now, comes), now
                if memory == BROKEN:
                    return True
        return False

    def waits(self, states: Sequence[State]) -> bool:
        """Whether a run waits at its end."""
        one, is_waiting = self._one, False
        for number, state in enumerate(states):
            begins = (number == 0 or not one.from_start) and (one.since is None or self.holds(one.since, state))
            is_waiting = self.holds(one.waits, state) and (is_waiting or begins)
        return is_waiting


@dataclass
class Asked:
    """A mission, a property of it that is broken, and the explanation."""

    model: Model
    one: Property
    found: Counterexample
    told: Explanation
    space: StateSpace
    """All states, explored anew."""

    @property
    def memory(self) -> Memory:
        return Memory(self.model, self.one)


def explained(run: Simulation, asked: AskedProperty, timing: Timing, failures: int) -> Asked | None:
    """None where the property is not broken, or there are too many states."""
    variables = property_variables(run, [asked])
    model = Model(run, abstract_run(run, variables), failures, timing)
    one = build_custom_property(model, asked)
    made = check_properties(model, [one], Budget(MOST_STATES))
    found = made.verdicts[0].counterexample
    if found is None or not made.complete:
        return None
    told = explain_run(model, one, found, made.states, Budget())
    if told is None:
        return None
    return Asked(model, one, found, told, explore(model, Budget(), True))


def steps_from(space: StateSpace, state: State) -> Iterator[tuple[State, tuple[Event, ...]]]:
    for place, (after, _, _) in enumerate(list(space.steps_from(state))):
        yield after, space.events_from(state, place)


def is_run(space: StateSpace, run: Counterexample) -> bool:
    """Whether each step is one of the model, with its events."""
    return run.states[0] == space.state(0) and all(
        (step.state, step.events) in list(steps_from(space, before)) and step.state == after
        for before, step, after in zip(run.states[:-1], run.steps, run.states[1:], strict=True)
    )


def is_fault(event: Event) -> bool:
    return event.what in (EventKind.FAIL, EventKind.STALL, EventKind.MUTE)


def can_keep(asked: Asked, run: Sequence[State]) -> bool:
    """Whether a run can go on for ever, without another failure, and keep the property; of lockstep without roads.

    Walks through all continuations: a state is told from another one by itself, and by what is left of the past: how
    far the history is, and whether something is waited for.
    """
    memory, liveness = asked.memory, asked.one.waits is not None
    graph: dict[Node, list[Node]] = {}

    def past(states: Sequence[State]) -> object:
        one = asked.one
        if one.history is None:
            return memory.waits(states) if liveness else None
        comes = [memory.holds(one.history.conditions[0], state) for state in states]
        return sum(now and not was for now, was in zip(comes, [False, *comes], strict=False))

    first = (run[-1], past(run))
    todo = [(first, list(run))]
    while todo:
        node, states = todo.pop()
        if node in graph:
            continue
        graph[node] = []
        for after, events in steps_from(asked.space, node[0]):
            longer = [*states, after]
            if any(is_fault(event) for event in events) or memory.is_broken(longer):
                continue
            following = after, past(longer)
            graph[node].append(following)
            todo.append((following, longer))
    ends = {node for node in graph if not list(steps_from(asked.space, node[0]))}
    for node in graph:
        reached = reachable(graph, graph[node])
        if node in reached:
            ends.add(node)
    if liveness:
        # Round and round through where nothing is waited for.
        ends = {node for node in ends if not node[1]}
    return first in ends or bool(reachable(graph, [first]) & ends)


def reachable(graph: dict[Node, list[Node]], begin: Iterable[Node]) -> set[Node]:
    found: set[Node] = set()
    todo = list(begin)
    while todo:
        node = todo.pop()
        if node not in found:
            found.add(node)
            todo += graph[node]
    return found


def breaks(asked: Asked, run: Counterexample) -> bool:
    """Whether a run breaks the property, by its end or by what repeats."""
    memory = asked.memory
    if run.repeats_from < 0:
        return memory.is_broken(run.states) and not memory.is_broken(run.states[:-1])
    around = run.states[run.repeats_from :]
    waits = all(memory.waits(run.states[: run.repeats_from + 1 + more]) for more in range(len(around)))
    return waits and around[0] == around[-1]


def has_run_with(space: StateSpace, memory: Memory, wanted: Sequence[Event]) -> bool:
    """Whether a run with these events in this order, and ticks, breaks the property of safety."""
    todo, seen = [([space.state(0)], 0)], set()
    while todo:
        states, count = todo.pop()
        if memory.is_broken(states[-2:]):
            return True
        if (states[-1], count) in seen:
            continue
        seen.add((states[-1], count))
        for after, events in steps_from(space, states[-1]):
            told = [event for event in events if event.what is not EventKind.TICK]
            if list(wanted[count : count + len(told)]) == told:
                todo.append(([*states, after], count + len(told)))
    return False


@pytest.mark.parametrize(("timing", "failures"), [(Timing.LOCKSTEP, 0), (Timing.LOCKSTEP, 1), (Timing.FREE, 1)])
def test_a_smaller_run_is_one_of_the_model_and_breaks_the_property(timing: Timing, failures: int) -> None:
    looked = 0
    for seed in range(examples(12, 1500)):
        rng = random.Random(seed)
        run, texts = branching_run(rng)
        asked = explained(run, random_property(rng), timing, failures)
        if asked is None:
            continue
        looked += 1
        smaller = asked.told.run
        assert is_run(asked.space, smaller), (seed, texts)
        assert breaks(asked, smaller), (seed, texts)
        events = events_of(smaller.steps)
        assert len(events) <= len(events_of(asked.found.steps))
        if smaller.repeats_from < 0:
            for at in range(len(events)):
                rest = [*events[:at], *events[at + 1 :]]
                assert not has_run_with(asked.space, asked.memory, rest), (seed, texts)
    assert looked > 5


@pytest.mark.parametrize("failures", [0, 1])
def test_the_moment_is_the_last_one_from_which_another_way_keeps_the_property(failures: int) -> None:
    found = dict.fromkeys(Certainty, 0)
    for seed in range(examples(20, 1500)):
        rng = random.Random(seed)
        run, texts = branching_run(rng)
        asked = explained(run, random_property(rng), Timing.LOCKSTEP, failures)
        if asked is None:
            continue
        smaller, avoidance = asked.told.run, asked.told.avoidance
        able = [can_keep(asked, smaller.states[: at + 1]) for at in range(len(smaller.states))]
        if smaller.repeats_from < 0:
            able[-1] = False
        found[avoidance.certainty] += 1
        if avoidance.certainty is Certainty.NEVER:
            assert not any(able), (seed, texts)
            continue
        assert avoidance.certainty in (Certainty.LAST, Certainty.ALWAYS), (seed, texts)
        last = max(at for at, one in enumerate(able) if one)
        assert able[avoidance.step], (seed, texts)
        if avoidance.certainty is Certainty.LAST:
            assert avoidance.step == last, (seed, texts)
        else:
            assert last >= smaller.repeats_from
        other = avoidance.other
        assert other is not None
        assert is_run(asked.space, other), (seed, texts)
        assert other.states[: avoidance.step + 1] == smaller.states[: avoidance.step + 1]
        assert not asked.memory.is_broken(other.states), (seed, texts)
        assert can_keep(asked, other.states), (seed, texts)
    assert min(found[one] for one in (Certainty.LAST, Certainty.NEVER)) > 2
    assert found[Certainty.UNKNOWN] == 0


@pytest.mark.parametrize("most", [3, 10, 10_000])
def test_from_the_end_backwards_it_finds_the_same_moment_or_says_that_it_does_not_know(most: int) -> None:
    """As in a mission that is too large to be looked at as a whole."""
    same = unknown = 0
    for seed in range(examples(20, 1000)):
        rng = random.Random(seed)
        run, texts = branching_run(rng)
        asked = explained(run, random_property(rng), Timing.LOCKSTEP, 0)
        if asked is None:
            continue
        again = explain_run(asked.model, asked.one, asked.told.run, None, Budget(most))
        assert again is not None
        whole, avoidance = asked.told.avoidance, again.avoidance
        if avoidance.certainty is Certainty.UNKNOWN:
            unknown += 1
            assert avoidance.step <= max(whole.step, len(asked.told.run.steps))
        elif again.run == asked.told.run:
            assert (avoidance.certainty, avoidance.step) == (whole.certainty, whole.step), (seed, texts)
            same += 1
        if avoidance.other is not None:
            assert can_keep(asked, avoidance.other.states), (seed, texts)
    assert same > 5
    assert (unknown > 0) == (most < 100)


LOADED = AskedProperty("loaded", Form.NEVER, "any carrier-1 (Cargo.IsPressed())")


def random_walk(space: StateSpace, memory: Memory, rng: random.Random) -> Counterexample:
    """Steps at random until they break a property of safety."""
    states, steps = [space.state(0)], []
    while not memory.is_broken(states[-2:]):
        following = list(space.steps_from(states[-1]))
        place = rng.randrange(len(following))
        events = space.events_from(states[-1], place)
        steps.append(Step(events, following[place][0]))
        states.append(following[place][0])
    return Counterexample(tuple(states), tuple(steps))


@pytest.mark.parametrize("timing", [Timing.LOCKSTEP, Timing.PROMPT])
def test_of_a_walk_at_random_no_event_is_left_that_could_be_left_out(timing: Timing) -> None:
    """Three carriers drive about until the first one has a box; what the third one does vanishes."""
    simulation = transport(stock=1, carriers=3)
    model = Model(simulation, abstract_run(simulation, property_variables(simulation, [LOADED])), 0, timing)
    one = build_custom_property(model, LOADED)
    space = explore(model, Budget(1), False)
    memory = Memory(model, one)
    third = next(i for i, part in enumerate(model.parts) if part.agent.name == "carrier-3")
    dropped = 0
    for seed in range(examples(3, 40)):
        walk = random_walk(space, memory, random.Random(seed))
        told = explain_run(model, one, walk, None, Budget(2_000))
        assert told is not None
        space = explore(model, Budget(1), False)
        smaller = told.run
        assert is_run(space, smaller)
        assert memory.is_broken(smaller.states)
        events = events_of(smaller.steps)
        # In lockstep whoever has room begins to roll.
        assert all(event.agent != third or event.what is Move.BEGIN for event in events)
        dropped += sum(event.agent == third for event in events_of(walk.steps))
        assert not any(has_run_with(space, memory, [*events[:at], *events[at + 1 :]]) for at in range(len(events)))
    assert dropped > 0
