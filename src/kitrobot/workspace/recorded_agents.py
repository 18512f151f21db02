"""The agents of a recording as breakpoints query them: the position of each after a step, what ran in it, its values.

A recording holds the position of every thread after each step, and the commands that devices took. So a vertex is known
to have run when a thread is at it afterwards, or when the agent gave a command that no other vertex of its program can
give; what ran and was left within one step otherwise is not known, and does not count as a visit.

The values of an agent (fault, inputs, variables) are recorded whole, so conditions can be tested, as long as its
robot is still defined as it was.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.image.instructions import ACT
from kitrobot.image.machine import Layout
from kitrobot.lll.tree import WorkDeclaration
from kitrobot.mission.trial import Breakpoint
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.team_objects import has_team, with_team
from kitrobot.trace.model import Place, Threads, TickRecord, TraceAgent, TraceHeader

_CELLS = ("input", "done", "variable")
"""The first words of columns that hold what an agent's program knows."""


class RecordedAgent:
    """One agent of a recording, as it is in the record that was looked at last. It is its own machine."""

    def __init__(
        self, index: int, header: TraceHeader, robot: Robot, cells: slice, givers: Mapping[tuple[str, str], Place]
    ) -> None:
        agent = header.agents[index]
        self.index = index
        self.name = agent.name
        self.program = agent.program
        self.image_name = header.image_name(agent)
        self.robot = robot
        self.active: Threads = ()
        self.cells: list[int] = []
        self.seen: list[int] = []
        self._from = header.places.get(self.image_name, ())
        self._places = cells
        self._givers = givers

    @property
    def machine(self) -> RecordedAgent:
        """What knows and does."""
        return self

    def update(self, record: TickRecord) -> None:
        """As it is in this record."""
        self.active = record.active[self.index]
        self.cells = record.numbers[self._places]
        ran = {self._from[number] for _, number in self.active if number < len(self._from)}
        for command in record.commands:
            if command.agent == self.index:
                ran.add(self._givers.get((command.actuator, command.procedure)))
        ran.discard(None)
        self.seen = [int(place in ran) for place in self._from]


def recorded_agents(
    header: TraceHeader,
    robots: Mapping[str, Robot],
    programs: Mapping[ImageName, CompiledProgram],
    works: Sequence[WorkDeclaration] = (),
) -> list[RecordedAgent]:
    """The agents of a recording whose robots are known, with their programs as they compile now."""
    first: dict[str, int] = {}
    width: Counter[str] = Counter()
    for at, column in enumerate(header.columns):
        if column.name == "fault":
            first[column.owner] = at
        if column.owner in first and column.name.partition(" ")[0] in ("fault", *_CELLS):
            width[column.owner] += 1
    robot_of = {header.image_name(agent): _robot(header, agent, robots, works) for agent in header.agents}
    givers = {
        name: _givers(compiled, robot, header.places.get(name, ()), name.program)
        for name, compiled in programs.items()
        if (robot := robot_of.get(name)) is not None
    }
    made = []
    for index, agent in enumerate(header.agents):
        robot, begin = _robot(header, agent, robots, works), first.get(agent.name, 0)
        if robot is not None:
            cells = slice(begin, begin + width[agent.name])
            made.append(RecordedAgent(index, header, robot, cells, givers.get(header.image_name(agent), {})))
    return made


def select_testable(
    breakpoints: Iterable[Breakpoint],
    header: TraceHeader,
    robots: Mapping[str, Robot],
    works: Sequence[WorkDeclaration],
) -> tuple[list[Breakpoint], bool]:
    """The breakpoints, without conditions where what a condition speaks of is not what was recorded; and whether all
    of their conditions can be tested.
    """
    known: dict[str, bool] = {}
    for agent in header.agents:
        is_known = is_as_recorded(header, agent.name, _robot(header, agent, robots, works))
        for program in {agent.program, *(one[0] for one in header.inner.get(header.image_name(agent), ()) if one)}:
            known[program] = is_known and known.get(program, True)
    made, all_of_them = [], True
    for one in breakpoints:
        tests = not one.when.strip() or known.get(one.program, True)
        made.append(one if tests else replace(one, when=""))
        all_of_them &= tests or not one.enabled
    return made, all_of_them


def _robot(
    header: TraceHeader, agent: TraceAgent, robots: Mapping[str, Robot], works: Sequence[WorkDeclaration]
) -> Robot | None:
    """The robot of an agent, as a member of its team where it is one."""
    robot = robots.get(agent.robot)
    is_of_team = robot is not None and header.image_name(agent).robot and not has_team(robot, works)
    return with_team(robot, works) if robot is not None and is_of_team else robot


def is_as_recorded(header: TraceHeader, agent: str, robot: Robot | None) -> bool:
    """Whether the cells of a robot are those that were recorded of an agent with it."""
    if robot is None:
        return False
    layout = Layout(robot)
    expected = [("input", name) for name in layout.sensors]
    expected += [("done", name) for name in layout.done]
    expected += [("variable", name) for name in layout.variables]
    words = (column.name.partition(" ") for column in header.columns if column.owner == agent)
    return expected == [(kind, name) for kind, _, name in words if kind in _CELLS]


def _givers(
    compiled: CompiledProgram, robot: Robot, places: Sequence[Place], program: str
) -> dict[tuple[str, str], Place]:
    """The commands that only one vertex of a program can give, and that vertex.

    Those that end a marked action are given by no instruction. Nothing is known of a program that compiles to something
    else than what was recorded.
    """
    image = compiled.image
    if image is None or compiled.debug.places_of(program) != list(places):
        return {}
    layout = Layout(robot)
    found: dict[tuple[str, str], set[Place]] = {}
    for number, place in enumerate(places):
        if image.code[4 * number] == ACT:
            _, actuator, procedure = layout.commands[image.code[4 * number + 1]]
            found.setdefault((actuator, procedure), set()).add(place)
    for stop in image.stops:
        _, actuator, procedure = layout.commands[stop.command]
        found.setdefault((actuator, procedure), set()).add(None)
    alone = {call: next(iter(givers)) for call, givers in found.items() if len(givers) == 1}
    return {call: place for call, place in alone.items() if place is not None}
