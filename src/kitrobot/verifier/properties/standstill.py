"""Standstills of a mission: nothing happens any more except that programs repeat themselves without effect.

As in `sim.step.deadlock_detection`, robots that only poll return to the same places in their programs, and to the same
values of their own variables, again and again. A robot that changes a shared variable has an effect. Repeating the same
command to a device has none, except for one that takes longer; and at the end of an open road a robot gets nowhere. If
a sensor that may read anything makes a difference, something may still happen, and the mission does not stand still.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from kitrobot.verifier.exploration.breadth_first_search import CALM
from kitrobot.verifier.exploration.engines import PLAIN
from kitrobot.verifier.exploration.exploration import StateSpace
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.properties.fair_cycles import CHUNK, mark_states
from kitrobot.verifier.properties.properties import Condition
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.bodies import RUNS

_MOST_AROUND = 300
"""States that are looked at around one, in search of a standstill."""
_MOST_LIVELY = 100_000
"""States that are known to be left, in memory."""
_STIRS = 1
"""The bit of anything that prevents a standstill; each command has a bit of its own above it."""


def find_standstill(space: StateSpace, condition: Condition) -> int:
    """Finds the first state that no step leaves, or else from which on programs only repeat themselves without effect.

    The condition holds in it and in all states after it. Returns -1 for none.
    """
    graph = space.graph
    states = _closed(space, mark_states(space, condition)[0])
    for state in states:
        if all(target == state for target in graph.targets[graph.first_edge[state] : graph.first_edge[state + 1]]):
            return state
    return next(_without_effect(space, states), -1)


class StandstillSearch:
    """Looks for standstills around single states of a space that keeps no steps, while it is explored.

    Attributes:
        looked: how many states were looked at.
    """

    def __init__(self) -> None:
        self.looked = 0
        self._lively: set[State] = set()

    def find_way(self, space: StateSpace, first: State, condition: Condition) -> list[State]:
        """The states on a way from a calm state to a standstill, if calm states are all that follows it, and few."""
        states, before, steps = [first], [-1], []
        numbers = {first: 0}
        for number, state in enumerate(states):
            self.looked += 1
            came, is_dead, row = 0, True, []
            for after, taken, kinds in space.steps_from(state):
                came, is_dead = came | kinds, is_dead and after == state
                if after not in numbers:
                    numbers[after] = len(states)
                    states.append(after)
                    before.append(number)
                row.append((numbers[after], taken))
            if (came & ~CALM and not is_dead) or len(states) > _MOST_AROUND or not self._lively.isdisjoint(numbers):
                self._note_lively(states, before, number)
                return []
            steps.append(row)
        regs = space.model.t.regs
        kept = [int(one) for one in regs]
        around = StateSpace(space.model, space.graph, PLAIN, interruption=space.interruption)
        around.install(states, steps, range(len(states)))
        at = find_standstill(around, condition)
        regs[:] = kept
        way = []
        while at >= 0:
            way.append(states[at])
            at = before[at]
        return way[::-1]

    def _note_lively(self, states: list[State], before: list[int], number: int) -> None:
        """Notes that something happens, or too many states follow, after these."""
        if len(self._lively) > _MOST_LIVELY:
            self._lively.clear()
        while number >= 0:
            self._lively.add(states[number])
            number = before[number]


def standstill_states(space: StateSpace, condition: Condition) -> list[int]:
    """All states of a standstill in which the condition holds; see `find_standstill`."""
    return list(_without_effect(space, _closed(space, mark_states(space, condition)[0])))


def _without_effect(space: StateSpace, states: list[int]) -> Iterator[int]:
    """Those of closed states from which on programs only repeat themselves without effect."""
    graph = space.graph
    begins = [(int(graph.first_edge[state]), int(graph.first_edge[state + 1])) for state in states]
    places = {state: n for n, state in enumerate(states)}
    following = [[places[int(target)] for target in graph.targets[first:end]] for first, end in begins]
    said = _CommandBits(space.model)
    out = _reached(following, list(said.by(space, states)), space)
    return (
        state
        for (state, (first, end)), all_of in zip(zip(states, begins, strict=True), out, strict=False)
        if not said.stirs(all_of) or all(target == state for target in graph.targets[first:end])
    )


def _closed(space: StateSpace, marks: Any) -> list[int]:
    """The marked calm states whose steps all lead to others of them."""
    graph, engine = space.graph, space.engine
    count = int(space.model.t.regs[v.CALMS])
    states, inside = engine.zeros(count), engine.bytes(max(1, len(space)))
    states[:] = graph.calm[:count]
    left = -1
    while left != count:
        if cut := space.interruption():
            space.interrupted_by = cut
            return []
        count, left = int(engine.prune_open_states(graph, states, count, marks, inside)), count
    return [int(state) for state in states[:count]]


def _reached(following: list[list[int]], out: list[int], space: StateSpace) -> list[int]:
    """For each state, the bits of all states reachable from it; empty if the search ended early."""
    changed = True
    while changed:
        changed = False
        if cut := space.interruption():
            space.interrupted_by = cut
            return []
        for n in range(len(following) - 1, -1, -1):
            now = out[n]
            for other in following[n]:
                now |= out[other]
            changed = changed or now != out[n]
            out[n] = now
    return out


class _CommandBits:
    """The commands of agents to their devices, as bits: a device with two different commands in turn has an effect."""

    def __init__(self, model: Model) -> None:
        self._model = model
        self._bits: dict[tuple[object, ...], int] = {}
        self._of_device: dict[tuple[int, int], int] = {}
        self._known: list[dict[int, int]] = [{} for _ in model.parts]

    def by(self, space: StateSpace, states: list[int]) -> Iterator[int]:
        """The bits of the next ticks in each of these states."""
        engine, two = space.engine, space.model.layout.words == 2
        keys = engine.words(CHUNK)
        at = 0
        while at < len(states):
            first = states[at]
            end = at
            while end < len(states) and states[end] < first + CHUNK:
                end += 1
            here = [state - first for state in states[at:end]]
            bits = [0] * len(here)
            for i, known in enumerate(self._known):
                engine.sense_agent(space.model.t, space.graph, first, first + here[-1] + 1, two, i, keys)
                for n, offset in enumerate(here):
                    key = int(keys[offset])
                    if key not in known:
                        known[key] = self._of_tick(i, key)
                    bits[n] |= known[key]
            yield from bits
            at = end

    def stirs(self, bits: int) -> bool:
        """Whether the commands of these bits have an effect, again and again."""
        return bool(bits & _STIRS) or any((bits & device).bit_count() > 1 for device in self._of_device.values())

    def _of_tick(self, i: int, key: int) -> int:
        model, part = self._model, self._model.parts[i]
        inside = model.inside(i, key & v.MOST_INSIDES - 1)
        if inside.down != RUNS or model.has_ended(i, inside):
            return 0
        (first, (written, _)), *others = model.reactions_to(i, key)
        if others or written:
            return _STIRS
        bits = 0
        for (actuator, command, argument), second, more in zip(first.commands, first.seconds, first.more, strict=True):
            if part.acts[actuator].agrees >= 0:
                continue
            if command in part.acts[actuator].later:
                return _STIRS
            said = i, actuator, command, argument, second, more
            bit = self._bits.setdefault(said, 2 << len(self._bits))
            self._of_device[i, actuator] = self._of_device.get((i, actuator), 0) | bit
            bits |= bit
        return bits
