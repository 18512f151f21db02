"""Traps and dead code: loops that an agent can never leave, and instructions that no run executes, in a state space.

An agent is *trapped* in a loop of its program if one of its threads is in it and stays in it in every state that can be
reached from there, although the loop has a way out. A loop without one (Forever) is intended. In a mission with goals
only states count from which the goals cannot be reached any more: a robot that waits when all is done is right to.

Not here: exploring (`exploration`), words and places for people (`checking.drawing_check`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache

from kitrobot.image.instructions import BY_NUMBER, FORK, JOIN
from kitrobot.image.model import Image
from kitrobot.primitives.image_name import ImageName
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.exploration import StateSpace
from kitrobot.verifier.model.abstraction import Abstraction
from kitrobot.verifier.model.programs import ProgramTable, Reaction

_CHUNK = 10
"""Steps of the simulator between two polls of the position of a thread."""
SEEDS = 4
"""Seeds with which the simulator is run in search of a trap."""


@dataclass(frozen=True)
class Loop:
    """A loop of a program that has an exit: its first instruction, and all of them."""

    head: int
    body: frozenset[int]


@dataclass(frozen=True)
class Trap:
    """A loop that an agent cannot leave any more.

    Attributes:
        agent: the number of the agent.
        slot: the thread.
        loop: the innermost loop that holds it.
        standing: the instructions at which the thread is from then on.
        state: the number of the first such state.
    """

    agent: int
    slot: int
    loop: Loop
    standing: frozenset[int]
    state: int


@dataclass(frozen=True)
class TrapRun:
    """A run of the simulator in which an agent is trapped, from a step on."""

    seed: int
    tick: int


class _CoverageTable(ProgramTable):
    """The reactions of a program, with the instructions that ran in any of them."""

    ran: frozenset[int] = frozenset()

    def run_tick(
        self, local: int, sensed: tuple[int | None, ...], shared: tuple[int, ...], chosen: Mapping[int, int]
    ) -> tuple[Reaction, frozenset[int]]:
        made = super().run_tick(local, sensed, shared, chosen)
        self.ran |= {pc for pc, ran in enumerate(self.machine.seen) if ran}
        return made


def record_coverage(parts: Abstraction) -> None:
    """Replaces the program tables with ones that record which instructions run; call it before making a model."""
    watched: dict[int, ProgramTable] = {}
    for part in parts.parts:
        old = part.table
        if id(old) not in watched:
            watched[id(old)] = _CoverageTable(old.machine.image, old.machine.robot)
        part.table = watched[id(old)]


def unexecuted_instructions(parts: Abstraction) -> dict[ImageName, frozenset[int]]:
    """For each image, by name, the instructions that ran in no reaction of any agent; see `record_coverage`."""
    found = {}
    for part in parts.parts:
        assert isinstance(part.table, _CoverageTable)
        every = range(part.table.machine.image.instructions)
        found[part.agent.image_name] = frozenset(every) - part.table.ran
    return found


@lru_cache(64)
def loops_of(image: Image) -> tuple[Loop, ...]:
    """The loops of an image that have an exit, from the inner to the outer ones."""
    code = image.code
    nexts: list[list[int]] = []
    for pc in range(image.instructions):
        number, _, b, c = code[4 * pc : 4 * pc + 4]
        op = BY_NUMBER[number]
        nexts.append(([pc + 1] if op.falls_through else []) + ([b + 256 * c] if op.jumps else []))
    before: dict[int, list[int]] = {}
    for pc, tos in enumerate(nexts):
        for to in tos:
            before.setdefault(to, []).append(pc)
    bodies: dict[int, set[int]] = {}
    for pc, tos in enumerate(nexts):
        for head in tos:
            if head <= pc:  # Only loops jump back.
                body = bodies.setdefault(head, {head})
                waiting = [pc]
                while waiting:
                    one = waiting.pop()
                    if one not in body:
                        body.add(one)
                        waiting += before.get(one, [])
    found = [
        Loop(head, frozenset(body))
        for head, body in bodies.items()
        if any(to not in body for pc in body for to in nexts[pc])
    ]
    return tuple(sorted(found, key=lambda loop: len(loop.body)))


def find_traps(space: StateSpace, stop: Callable[[], bool]) -> list[Trap]:
    """The first trap of each loop of each program; none if the exploration is incomplete, or the search was stopped."""
    if not space.complete:
        return []
    model = space.model
    places = _ThreadPlaces(space)
    reached = 1 << len(places.known)
    out = []
    for number in range(len(space)):
        if number % 1000 == 0 and stop():
            return []
        state = space.state(number)
        leaves = (reached - 1) & ~places.held(state)
        out.append(leaves | (reached if model.goals and model.goals_hold(model.shareds()[state[0]]) else 0))
    # Lists: reading one number of an array from here takes several times as long.
    begins = list(map(int, space.graph.first_edge[: len(space) + 1]))
    targets = list(map(int, space.graph.targets[: begins[-1]]))
    changed = True
    while changed:
        changed = False
        if stop():
            return []
        for number in range(len(space) - 1, -1, -1):
            now = out[number]
            for target in targets[begins[number] : begins[number + 1]]:
                now |= out[target]
            if now != out[number]:
                out[number] = now
                changed = True
    every = 2 * reached - 1 if model.goals else reached - 1
    found: dict[tuple[ImageName, int], Trap] = {}
    for number, leaves in enumerate(out):
        if leaves != every and not leaves & reached:
            for agent, slot, loop in places.trapped(leaves, space.state(number)):
                name = model.parts[agent].agent.image_name
                if (name, loop.head) not in found:
                    standing = places.standing_from(space, number, agent, slot)
                    found[name, loop.head] = Trap(agent, slot, loop, standing, number)
    return list(found.values())


class _ThreadPlaces:
    """The positions of threads: a bit for each agent, thread and loop."""

    def __init__(self, space: StateSpace) -> None:
        self._model = space.model
        self.known: list[tuple[int, int, Loop]] = []
        self._held: list[list[int]] = []
        for i, part in enumerate(self._model.parts):
            image = part.table.machine.image
            bits: dict[tuple[int, int], int] = {}
            for slot in range(len(image.slots)):
                for n, loop in enumerate(loops_of(image)):
                    bits[slot, n] = 1 << len(self.known)
                    self.known.append((i, slot, loop))
            self._held.append(
                [
                    sum(
                        bits[slot, n]
                        for slot, pc in part.table.places(inside.local)
                        for n, loop in enumerate(loops_of(image))
                        if pc in loop.body
                    )
                    for inside in self._model.insides(i)
                ]
            )

    def held(self, state: tuple[int, ...]) -> int:
        """The loops that agents are in."""
        found = 0
        for i, held in enumerate(self._held):
            found |= held[state[1 + i]]
        return found

    def at(self, state: tuple[int, ...], agent: int, slot: int) -> int:
        """The instruction of a thread; -1 if it is not running."""
        inside = self._model.inside(agent, state[1 + agent])
        return dict(self._model.parts[agent].table.places(inside.local)).get(slot, -1)

    def trapped(self, leaves: int, state: tuple[int, ...]) -> Iterator[tuple[int, int, Loop]]:
        """The innermost loop that each thread of each agent never leaves; threads that wait for others are skipped."""
        seen = set()
        for bit, (agent, slot, loop) in enumerate(self.known):
            if leaves >> bit & 1 or (agent, slot) in seen:
                continue
            seen.add((agent, slot))
            code = self._model.parts[agent].table.machine.image.code
            if code[4 * self.at(state, agent, slot)] not in (FORK, JOIN):
                yield agent, slot, loop

    def standing_from(self, space: StateSpace, number: int, agent: int, slot: int) -> frozenset[int]:
        """The instructions of a thread in all states reachable from one."""
        graph, seen, waiting, found = space.graph, {number}, [number], set()
        while waiting:
            one = waiting.pop()
            found.add(self.at(space.state(one), agent, slot))
            for e in range(graph.first_edge[one], graph.first_edge[one + 1]):
                to = int(graph.targets[e])
                if to not in seen:
                    seen.add(to)
                    waiting.append(to)
        return frozenset(found)


def find_trap_run(trap: Trap, fresh: Callable[[int], Simulation], stop: Callable[[], bool]) -> TrapRun | None:
    """Finds a run of the simulator that shows a trap; None if it finds none.

    In it the agent stays in its loop from a step on up to the end, or for half of a run whose time is up. `fresh` makes
    the run of a seed, with a time limit.
    """
    for seed in range(1, SEEDS + 1):
        run = fresh(seed)
        since = -1
        while run.outcome is None:
            if stop():
                return None
            run.advance(_CHUNK)
            if dict(run.members[trap.agent].active).get(trap.slot, -1) not in trap.loop.body:
                since = -1
            elif since < 0:
                since = run.tick
        if since >= 0 and run.outcome != "done" and (run.outcome != "time" or 2 * since <= run.tick):
            return TrapRun(seed, since)
    return None
