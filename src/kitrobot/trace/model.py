"""What happened, tick by tick: the values that every watcher of a run reads.

A run is a `TraceHeader` (who takes part, in what, what the numbers mean) and one `TickRecord` for each number of
finished steps, the first one (0) before any step was made. All numbers of a record stand in one flat list of whole
numbers, one for each `Column` of the header, so that a record is compared and stored fast; a column's `scale` turns a
number back into its unit (0.1: tenths). Nothing here comes from a clock on the wall.

Left to others: the header as bytes (header), records as bytes (`codec`), files (`writer`, `reader`), who produced it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import zip_longest

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.image_name import ImageName

TEAM = ""
"""The owner of a column that belongs to no single agent."""

POSE_WORDS = ("x_mm", "y_mm", "heading_rad", "load", "flags")
"""The numbers of where an agent is. A real robot has none of them: nobody knows that of it."""

PROGRAM, WORLD, PERSON, MISSION, CHANCE = "program", "world", "person", "mission", "chance"
ROBOT, LINK = "robot", "link"
"""What brings an event about: a program's command, a thing that stood in the way, somebody's hand during the run, the
mission's schedule, or chance; of a real robot also the robot itself (a part, its power) and the link to it."""


class TraceError(KitRobotError):
    """A trace that cannot be written or read; the message says where."""


@dataclass(frozen=True)
class TraceAgent:
    """Somebody who takes part; `kind` is what it is drawn as, `number` counts within a kind."""

    name: str
    program: str
    robot: str
    kind: str = "robot"
    number: int = 1


@dataclass(frozen=True)
class Column:
    """The meaning of one number of a record: whose (`TEAM` or an agent's name), what, and its unit's `scale`."""

    owner: str
    name: str
    scale: float = 1.0


@dataclass(frozen=True)
class TracePart:
    """An XML file of a robot or of constructors that the mission needs and that does not come with KitRobot."""

    file: str
    text: str


@dataclass(frozen=True, slots=True)
class TracePoint:
    """A place of a team's program at which robots agree: `waits` says that all of `members` come there first.

    `members` are names of roles, groups and agents, none for the whole team; `vertex` is "" where there is none.
    """

    program: str
    vertex: str
    waits: bool
    members: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TracePlan:
    """What the numbers of a team count: its agents (`members`), roles, groups and points, each in their order.

    Among the numbers of the team stand `role of AGENT` (-1: spare), `seat of AGENT` (whose place it took, by number in
    the run), `waits of AGENT` (the point, or -1), `missed of AGENT` (0 or 1), and `group N of AGENT` (0 or 1).
    """

    members: tuple[str, ...]
    roles: tuple[str, ...]
    groups: tuple[str, ...]
    points: tuple[TracePoint, ...]


Place = tuple[str, str] | None
"""A program and a vertex of it."""
Inner = tuple[Place, ...]
"""Of each instruction the program and the vertex, where that program is another one than the agent's own."""


@dataclass(frozen=True)
class TraceHeader:
    """What holds for the whole run.

    Attributes:
        mission: the canonical `.krt`, as text.
        seed: where chance began.
        world: the file of the world, as text.
        tick_ms: simulated time of a step.
        agents: who takes part, in team order.
        columns: the meaning of the numbers of each record.
        vertices: for each program the vertex of each of its instructions, None where one comes from none; of a team's
            program, by its name and that of each kind of robot (see `vertices_of`).
        parts: XML files that the mission needs besides.
        total: all boxes there are.
        fail_rate: the probability that an agent fails by chance within a minute.
        inner: like `vertices`, where those stand in another program that a team's program names.
        plan: what the numbers of a team count; None where no team's program runs.
    """

    mission: str
    seed: int
    world: str
    tick_ms: int
    agents: tuple[TraceAgent, ...]
    columns: tuple[Column, ...]
    vertices: Mapping[ImageName, tuple[str | None, ...]] = field(default_factory=dict)
    parts: tuple[TracePart, ...] = ()
    total: int = 0
    fail_rate: float = 0.0
    inner: Mapping[ImageName, Inner] = field(default_factory=dict)
    plan: TracePlan | None = None

    def vertices_of(self, agent: TraceAgent) -> tuple[str | None, ...]:
        """The vertex of each instruction of what an agent runs."""
        return self.vertices.get(self.image_name(agent), ())

    @cached_property
    def places(self) -> Mapping[ImageName, tuple[Place, ...]]:
        """The program and the vertex of each instruction, where it has one, of what `vertices` names."""
        return {
            name: tuple(
                (name.program, vertex) if vertex is not None else inner
                for vertex, inner in zip_longest(vertices, self.inner.get(name, ()))
            )
            for name, vertices in self.vertices.items()
        }

    def image_name(self, agent: TraceAgent) -> ImageName:
        """What `vertices` calls what an agent runs: its program, and its kind of robot where that is a team's."""
        name = ImageName(agent.program, agent.robot)
        return name if name in self.vertices else ImageName(agent.program)

    @cached_property
    def unplaced(self) -> frozenset[str]:
        """The agents that nobody knows the place of: real robots."""
        placed = {column.owner for column in self.columns if column.name in POSE_WORDS}
        return frozenset(agent.name for agent in self.agents if agent.name not in placed)

    @property
    def real(self) -> bool:
        """Whether it is of real robots."""
        return 0 < len(self.agents) == len(self.unplaced)


@dataclass(frozen=True, slots=True)
class TraceCommand:
    """A command that a device took: which agent (its index), which procedure, with what."""

    agent: int
    actuator: str
    procedure: str
    arguments: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class TraceEvent:
    """What happened: load, unload, message, collision, end, outside, …; `agent` is -1 for the whole team.

    `tick` is the step in which it happened, or before which somebody did it from outside; at most that of the record it
    is in. `cause` is one of PROGRAM,
    WORLD, PERSON, MISSION, CHANCE, ROBOT and LINK.
    """

    tick: int
    kind: str
    agent: int
    text: str
    cause: str = PROGRAM


Threads = tuple[tuple[int, int], ...]
"""Where the live threads of one agent stand: (slot, instruction) each."""


@dataclass
class TickRecord:
    """The run after `tick` steps: `numbers` by column, `active` by agent; `commands` and `events` only of this step."""

    tick: int
    numbers: list[int]
    active: list[Threads]
    commands: list[TraceCommand] = field(default_factory=list)
    events: list[TraceEvent] = field(default_factory=list)

    def values(self, header: TraceHeader) -> Mapping[str, Mapping[str, float]]:
        """Owner → name → value in its unit."""
        table: dict[str, dict[str, float]] = {}
        for column, number in zip(header.columns, self.numbers, strict=True):
            table.setdefault(column.owner, {})[column.name] = number if column.scale == 1.0 else number * column.scale
        return table
