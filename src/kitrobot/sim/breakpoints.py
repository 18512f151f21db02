"""Breakpoints of a run: told of each step, they say who came to which vertex.

An agent comes to a vertex in the step in which its program runs something of that vertex, unless it stood there
already at the end of its step before: waiting is one visit. A condition is a program of its own, `[when](WAIT(1))`,
tried by the one interpreter on a copy of the agent's inputs and variables: where it is true the program waits, else it
ends at once. So it means exactly what it means in the graph. A visit counts when the condition holds.

Programs that stand in a team's by `PROGRAM` have breakpoints of their own: who runs that team's program comes there.

What it asks of an agent a recording can answer too (`ObservedAgent`).

Left to others: pausing (whoever steers the run), keeping breakpoints (mission).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol

from kitrobot.compiler.compilation import compile_text
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.image.machine import Machine
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import Conditional
from kitrobot.mission.trial import Breakpoint
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot import Robot
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import Place, Threads


class ObservedMachine(Protocol):
    """What a program knows and did: `cells` begin with the fault, inputs and variables; `seen` says of each
    instruction whether it ran in the last step.
    """

    @property
    def cells(self) -> Sequence[int]: ...

    @property
    def seen(self) -> Sequence[int]: ...


class ObservedAgent(Protocol):
    """An agent whose visits are told; `active` is where its live threads stand, (slot, instruction) each."""

    @property
    def index(self) -> int: ...

    @property
    def name(self) -> str: ...

    @property
    def image_name(self) -> ImageName: ...

    @property
    def robot(self) -> Robot: ...

    @property
    def active(self) -> Threads: ...

    @property
    def machine(self) -> ObservedMachine: ...


class ConditionError(KitRobotError):
    """A breakpoint's condition cannot be understood."""


@dataclass(frozen=True)
class Hit:
    """An agent came to the vertex of a breakpoint. `visit` counts from 1."""

    program: str
    vertex: str
    agent: str
    visit: int


class Condition:
    """A condition of LLL that can be asked of any agent with this robot.

    Raises:
        ConditionError: it is no condition, or speaks of something that the robot has not.
    """

    def __init__(self, text: str, robot: Robot) -> None:
        source = f"[{text}](WAIT(1));"
        parsed = parse(source, "condition")
        items = parsed.program.items
        if not parsed.ok or len(items) != 1 or not isinstance(items[0], Conditional) or items[0].orelse is not None:
            raise ConditionError(
                Sentence("`{condition}` is no condition", text),
                Sentence("write one like Count.GreaterThan(3) & Run.IsTrue()"),
            )
        compiled = compile_text(source, robot, "condition")
        if compiled.image is None:
            first = next(item for item in compiled.diagnostics if item.is_error)
            raise ConditionError(first.message, first.help)
        self._machine = Machine(compiled.image, robot)
        self._first = self._machine.snapshot()

    def holds(self, machine: ObservedMachine) -> bool:
        """Whether it is true of what this machine has read and holds."""
        mine = self._machine
        mine.restore(self._first)
        known = mine.layout.cells
        mine.cells[:known] = [int(number) for number in machine.cells[:known]]
        mine.tick()
        return not mine.ended


@dataclass
class _WatchedVertex:
    """One breakpoint: whom it watches, the instructions of its vertex and its condition, for each image that they run,
    and when each agent came there.
    """

    breakpoint: Breakpoint
    instructions: Mapping[ImageName, frozenset[int]]
    conditions: Mapping[ImageName, Condition]
    agents: Sequence[ObservedAgent]
    visits: dict[int, list[int]] = field(default_factory=dict)
    there: set[int] = field(default_factory=set)
    """Who stands there now."""


class Breakpoints:
    """The breakpoints of a run, armed. The run must be one that watches its programs.

    Args:
        breakpoints: those of the mission; one that is off, or whose program or vertex is gone, does nothing.
        agents: the members of the run.
        places: where each instruction of what an agent runs came from, by its `image_name` (`TraceHeader.places`).

    Raises:
        ConditionError: a condition cannot be understood.
    """

    def __init__(
        self,
        breakpoints: Iterable[Breakpoint],
        agents: Sequence[ObservedAgent],
        places: Mapping[ImageName, Sequence[Place]],
    ) -> None:
        self._watched: list[_WatchedVertex] = []
        images = {agent.image_name: agent.robot for agent in agents}
        for breakpoint in breakpoints:
            if not breakpoint.enabled:
                continue
            place = (breakpoint.program, breakpoint.vertex)
            instructions = {
                name: found
                for name in images
                if (found := frozenset(number for number, one in enumerate(places.get(name, ())) if one == place))
            }
            wanted = [
                agent
                for agent in agents
                if agent.image_name in instructions and (not breakpoint.agents or agent.name in breakpoint.agents)
            ]
            asks = {agent.image_name for agent in wanted} if breakpoint.when.strip() else set[ImageName]()
            conditions = {name: Condition(breakpoint.when, images[name]) for name in asks}
            if wanted:
                self._watched.append(_WatchedVertex(breakpoint, instructions, conditions, wanted))

    def __bool__(self) -> bool:
        return bool(self._watched)

    def after_step(self, tick: int) -> list[Hit]:
        """Who came where in the step that led to `tick`, as far as the run is to pause for it."""
        hits: list[Hit] = []
        for watched in self._watched:
            came = [agent for agent in watched.agents if self._comes(watched, agent, tick)]
            counted = [agent for agent in came if len(watched.visits[agent.index]) >= watched.breakpoint.hits]
            everybody = all(agent.index in watched.there for agent in watched.agents)
            if counted and (everybody or not watched.breakpoint.every):
                program, vertex = watched.breakpoint.program, watched.breakpoint.vertex
                hits += [Hit(program, vertex, agent.name, len(watched.visits[agent.index])) for agent in counted]
        return hits

    def went_to(self, tick: int) -> None:
        """The run stands at another step now: visits after it have not been."""
        for watched in self._watched:
            watched.visits = {agent: [at for at in ticks if at <= tick] for agent, ticks in watched.visits.items()}
            watched.there = {agent.index for agent in watched.agents if _is_at(watched, agent)}

    def _comes(self, watched: _WatchedVertex, agent: ObservedAgent, tick: int) -> bool:
        """Whether the agent came to the vertex in this step, and the condition holds; counts the visit."""
        seen = agent.machine.seen
        before = agent.index in watched.there
        runs = any(seen[number] for number in watched.instructions[agent.image_name])
        if _is_at(watched, agent) or (runs and watched.breakpoint.every):
            watched.there.add(agent.index)
        else:
            watched.there.discard(agent.index)
        if not runs or before:
            return False
        condition = watched.conditions.get(agent.image_name)
        if condition is not None and not condition.holds(agent.machine):
            return False
        watched.visits.setdefault(agent.index, []).append(tick)
        return True


def _is_at(watched: _WatchedVertex, agent: ObservedAgent) -> bool:
    here = watched.instructions[agent.image_name]
    return any(instruction in here for _, instruction in agent.active)
