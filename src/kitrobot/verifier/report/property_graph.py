"""The states that follow one state of a model, beside what a property remembers in them, with their steps.

It is explored anew, from any state and within limits, so that a check need not keep its states. Steps that break the
property are marked and not followed. States that were not gone on from are the *rim*: what follows them is unknown.
"""

from __future__ import annotations

from array import array
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from kitrobot.verifier.exploration import engines
from kitrobot.verifier.exploration.breadth_first_search import CALM
from kitrobot.verifier.exploration.budget import CutReason
from kitrobot.verifier.exploration.exploration import StateSpace, fresh_graph
from kitrobot.verifier.exploration.fairness import FIRST, TOP, WORK
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.properties.fair_cycles import component_search, cover_component, next_fair_component
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.standstill import standstill_states
from kitrobot.verifier.properties.verdicts import Counterexample, Step
from kitrobot.verifier.report.property_memory import Memory, PropertyMemory
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.events import FAIL, MUTE, STALL, Event

FAULTS = 1 << FAIL | 1 << STALL | 1 << MUTE
"""The kinds of events that are failures."""
_BROKEN = -1
_PAUSE = 4
"""States between two polls of the limits: one may have thousands of steps."""
_RIM = 8
"""For each state that may be gone on from, so many more may be reached."""

Node = tuple[State, Memory]


class Successor(NamedTuple):
    """A step out of a state: its place there, the state after it, its progress classes and its kinds of events."""

    place: int
    state: State
    taken: int
    kinds: int


class Successors:
    """The steps out of states of a model, each found once."""

    def __init__(self, model: Model, interruption: Callable[[], CutReason | None]) -> None:
        if isinstance(model.t, engines.ArrayTables):
            model.t, _ = engines.PLAIN.take(model.t, fresh_graph(), 0)
        model.t.regs[v.COUNT] = 0
        self.space = StateSpace(model, fresh_graph(), engines.PLAIN, interruption=interruption)
        self._steps: dict[State, list[Successor]] = {}
        self._events: dict[tuple[State, int], tuple[Event, ...]] = {}

    def of(self, state: State) -> list[Successor]:
        """The steps out of a state."""
        found = self._steps.get(state)
        if found is None:
            steps = self.space.steps_from(state)
            found = self._steps[state] = [Successor(place, *step) for place, step in enumerate(steps)]
        return found

    def events(self, state: State, step: Successor) -> tuple[Event, ...]:
        """The events of a step out of a state."""
        key = state, step.place
        found = self._events.get(key)
        if found is None:
            found = self._events[key] = self.space.events_from(state, step.place)
        return found

    def has_good_end(self, state: State) -> bool:
        """Whether every goal is reached in a state or, in a mission without goals, every program has ended."""
        model = self.space.model
        if model.goals:
            return model.goals_hold(model.shareds()[state[0]])
        return all(model.has_ended(i, model.inside(i, state[1 + i])) for i in range(model.count))

    def run_through(self, states: Sequence[State]) -> Counterexample:
        """The run through states that follow each other."""
        steps = []
        for before, after in pairwise(states):
            taken = next(step for step in self.of(before) if step.state == after)
            steps.append(Step(self.events(before, taken), after))
        return Counterexample(tuple(states), tuple(steps))


class PropertyGraph:
    """The nodes that follow one node, in the order of their discovery; a node is a state and a memory.

    Attributes:
        nodes: the nodes; the first `expanded` of them were gone on from.
        numbers: the number of each node.
        is_cut: whether a search through the nodes ended early, so that it may have missed some.
    """

    def __init__(self, successors: Successors, memory: PropertyMemory, first: Node, most: int) -> None:
        self._successors = successors
        self._memory = memory
        self.nodes: list[Node] = [first]
        self.numbers: dict[Node, int] = {first: 0}
        self._steps: list[list[tuple[Successor, int]]] = []
        self._calm: list[int] = []
        self.is_cut = False
        self._explore(most)

    @property
    def expanded(self) -> int:
        return len(self._steps)

    @property
    def is_complete(self) -> bool:
        return self.expanded == len(self.nodes)

    def _explore(self, most: int) -> None:
        space = self._successors.space
        while self.expanded < len(self.nodes) and self.expanded < most and len(self.nodes) <= _RIM * most + 1:
            if self.expanded % _PAUSE == 0 and space.interruption():
                return
            at = self.expanded
            state, memory = self.nodes[at]
            steps, came, is_dead = [], 0, True
            for step in self._successors.of(state):
                following = self._memory.after(memory, state, step.kinds, step.state)
                came |= step.kinds
                number = _BROKEN
                if following is not None:
                    node = step.state, following
                    number = self.numbers.setdefault(node, len(self.nodes))
                    if number == len(self.nodes):
                        self.nodes.append(node)
                is_dead = is_dead and number == at
                steps.append((step, number))
            self._steps.append(steps)
            if is_dead or came & ~CALM == 0:
                self._calm.append(at)

    def steps(self, number: int) -> Iterator[tuple[Successor, int]]:
        """The steps out of a node that break nothing, each with the number of the node after it; none of the rim."""
        if number < self.expanded:
            yield from ((step, target) for step, target in self._steps[number] if target != _BROKEN)

    def events(self, number: int, step: Successor) -> tuple[Event, ...]:
        """The events of a step out of a node."""
        return self._successors.events(self.nodes[number][0], step)

    def has_good_end(self, number: int) -> bool:
        """The same as of the successors, of a node."""
        return self._successors.has_good_end(self.nodes[number][0])

    def standstills(self, one: Property) -> set[int]:
        """The nodes in which the mission stands still before it is done."""
        if one.is_wrong is None:
            return set()
        space = self._install(0)
        found = set(standstill_states(space, one.is_wrong))
        self.is_cut = self.is_cut or space.interrupted_by is not None
        return found

    def fair_parts(self, counts: Iterable[int], avoided: int = 0) -> Iterator[list[int]]:
        """The largest parts in which a fair run can stay for ever, among these nodes.

        Args:
            counts: the numbers of the nodes that count.
            avoided: kinds of events, as bits, whose steps are not taken.
        """
        space, counts = self._install(avoided), list(counts)
        colour, found = array("i", bytes(4 * len(self.nodes) + 8)), array("i", bytes(4 * len(self.nodes) + 8))
        for place, number in enumerate(counts):
            colour[number], found[place] = 1, number
        search = component_search(space, colour, found, len(counts))
        is_found = bool(counts)
        while is_found:
            search, is_found = next_fair_component(space, search)
            if not is_found:
                self.is_cut = self.is_cut or space.interrupted_by is not None
                return
            first = int(search.numbers[FIRST])
            part = [int(one) for one in search.stack[first : int(search.numbers[TOP])]]
            yield part
            for number in part:
                search.order[number] = -1
            search.numbers[TOP] = first
            search.numbers[WORK] -= 1

    def fair_loop(self, part: list[int], begin: int) -> list[int]:
        """The nodes of a way from a node of a fair part through it, as short as is fair, and back; the node alone where
        a run can stay there.
        """
        for smaller in self._smaller_parts(set(part), begin):
            if found := next((one for one in self.fair_parts(smaller) if begin in one), None):
                part = found
                break
        space = self._install(0)
        size = len(space) + 1
        return cover_component(space, part, begin, array("i", bytes(4 * size)), array("i", bytes(4 * size)))

    def _smaller_parts(self, part: set[int], begin: int) -> Iterator[list[int]]:
        """A node alone, and then the ways from it within a part back to it, the shortest first."""
        yield [begin]
        after = {number: [target for _, target in self.steps(number) if target in part] for number in part}
        back: dict[int, int] = {}
        before: dict[int, list[int]] = {}
        for number, targets in after.items():
            for target in targets:
                before.setdefault(target, []).append(number)
        waiting = deque([begin])
        ways: dict[int, int] = {begin: 0}
        while waiting:
            at = waiting.popleft()
            for number in before.get(at, ()):
                if number not in ways:
                    ways[number], back[number] = ways[at] + 1, at
                    waiting.append(number)
        for target in sorted(set(after[begin]) - {begin}, key=lambda one: ways[one]):
            way = [begin, target]
            while way[-1] != begin:
                way.append(back[way[-1]])
            yield way[:-1]

    def _install(self, avoided: int) -> StateSpace:
        """The nodes as a state space for the searches of `fair_cycles`; steps that are not taken lead beyond it."""
        space, beyond = self._successors.space, len(self.nodes)
        rows = [
            [(beyond if target == _BROKEN or step.kinds & avoided else target, step.taken) for step, target in steps]
            for steps in self._steps
        ]
        space.install([state for state, _ in self.nodes], rows, self._calm)
        space.begin_property()
        return space

    def distances_to(self, ends: Iterable[int], avoided: int = 0) -> dict[int, int]:
        """Of the nodes from which some steps lead to one of these, and of these, how many steps it takes at least.

        Steps with events of the kinds `avoided` are not taken.
        """
        before: dict[int, list[int]] = {}
        for number in range(self.expanded):
            for step, target in self.steps(number):
                if not step.kinds & avoided:
                    before.setdefault(target, []).append(number)
        found = dict.fromkeys(ends, 0)
        waiting = deque(found)
        while waiting:
            at = waiting.popleft()
            for number in before.get(at, ()):
                if number not in found:
                    found[number] = found[at] + 1
                    waiting.append(number)
        return found
