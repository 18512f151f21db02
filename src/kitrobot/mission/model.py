"""A mission: programs, the team that runs them, and the world they run in, as one `.krt` file holds them.

Plain values in the order of the file. A mission may be unfinished (an agent whose program is not there yet): what is
wrong is said by diagnostics, and by whoever tries to run it. Left to others: what a program means (compiler), the
world itself.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

from kitrobot.graph.model import Program
from kitrobot.lll.tree import GroupDeclaration, RoleDeclaration, WorkDeclaration
from kitrobot.mission.breakdown import Breakdown
from kitrobot.mission.property_forms import AskedProperty
from kitrobot.mission.radio import Radio
from kitrobot.mission.trial import Breakpoint, Failure
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.crew import Crew, CrewProgram
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.levels import Level
from kitrobot.primitives.own_xml import OwnVariable
from kitrobot.primitives.robot import Texts
from kitrobot.world.model import World

VERSION = 1
"""The newest version of the `.krt` format."""

DEFAULT_SEED = 1
"""Where chance begins in a run for which nothing else is said."""

DEFAULT_RUN_S = 600.0
"""Simulated seconds of a run for which nothing else is said."""

ALL = "all"
"""A goal's stock: every box there is."""


@dataclass(slots=True)
class Agent:
    """A member of the team and the program it runs. It starts at the world's start `start`, or the one of its name.

    `robot` is its kind where its program is one of the level social, which speaks of all kinds.
    """

    name: str
    program: str
    start: str = ""
    robot: str = ""

    @property
    def start_name(self) -> str:
        """The name of the start it takes."""
        return self.start or self.name

    @property
    def image_name(self) -> ImageName:
        """By which the image that it runs is known."""
        return ImageName(self.program, self.robot)


@dataclass(slots=True)
class Goal:
    """What must be true in the end: that many boxes (0…65535 in figures, or `ALL`) in a storehouse."""

    storehouse: str
    stock: str = ALL


@dataclass(slots=True)
class Team:
    """Who takes part, and what for; and what the programs of the whole team declare."""

    agents: list[Agent] = field(default_factory=list)
    goals: list[Goal] = field(default_factory=list)
    roles: list[RoleDeclaration] = field(default_factory=list)
    groups: list[GroupDeclaration] = field(default_factory=list)
    works: list[WorkDeclaration] = field(default_factory=list)

    def free(self, starts: Iterable[str]) -> list[str]:
        """Those starts of a world at which no agent starts, in their order."""
        taken = {agent.start_name for agent in self.agents}
        return [start for start in starts if start not in taken]


_WORLD = re.compile(r"<world[\s/>]")


@dataclass(slots=True)
class Mission:
    """A whole mission. `world_href` names a world's file, "" means the empty world; `unknown` is XML kept as it is.
    `prolog` is what stands before the first element, and `attributes` are those of the first element with a prefix.

    `own_world` is the world that it brings along instead, as its author left it: parts of it may not fit together.

    `label` is its title and `help` says in a sentence what happens, each by language, "" for English. `constructors`
    and `variables` are the parts that it brings along; `breakpoints` and `failures` say how it is tried out,
    `breakdown` what becomes of robots that fail on a road, `properties` what is demanded of every run. Without a
    `radio`, everybody hears everybody at once.

    Nothing is checked here: whoever opens it (`kitrobot.open_mission`) says what is wrong.

    Examples:
        >>> import kitrobot
        >>> world = kitrobot.World("yard", 1000, 600, starts=(kitrobot.Start("a", pose=kitrobot.Pose(200, 300, 0)),))
        >>> drive = kitrobot.read_program("Wheel.Advance(50); WAIT(10); Wheel.Stop();", "mini-robot", "drive")
        >>> mission = Mission(programs=[drive], team=Team([Agent("a", "drive")]), own_world=world)
        >>> kitrobot.open_mission(mission).run().sentence
        'Done after 1.0 s: every program has ended.'
    """

    version: int = VERSION
    programs: list[Program] = field(default_factory=list)
    team: Team = field(default_factory=Team)
    world_href: str = ""
    unknown: list[str] = field(default_factory=list)
    label: Texts = field(default_factory=dict)
    help: Texts = field(default_factory=dict)
    constructors: list[Constructor] = field(default_factory=list)
    variables: list[OwnVariable] = field(default_factory=list)
    breakpoints: list[Breakpoint] = field(default_factory=list)
    failures: list[Failure] = field(default_factory=list)
    own_world: World | None = None
    radio: Radio | None = None
    breakdown: Breakdown = field(default_factory=Breakdown)
    properties: list[AskedProperty] = field(default_factory=list)
    prolog: list[str] = field(default_factory=list)
    attributes: dict[str, str] = field(default_factory=dict)

    @property
    def has_unread_world(self) -> bool:
        """Whether its own world has a mistake for which it is left as it is, among `unknown`."""
        return self.own_world is None and any(_WORLD.match(raw) for raw in self.unknown)

    @property
    def crew(self) -> Crew | None:
        """The team as its programs see it; None where there is nothing that speaks of several robots."""
        team = self.team
        if not (team.roles or team.groups or team.works or any(one.level.is_team for one in self.programs)):
            return None
        kinds = {program.name: program.target for program in self.programs}
        return Crew(
            tuple((agent.name, agent.robot or kinds.get(agent.program, "")) for agent in team.agents),
            tuple(CrewProgram(one.name, one.target, one.level) for one in self.programs),
            *(tuple(team.roles), tuple(team.groups), tuple(team.works)),
        )

    @property
    def social(self) -> str:
        """The program of the whole team that agents run; "" for none, the first where they run several."""
        levels = {program.name: program.level for program in reversed(self.programs)}
        return next((one.program for one in self.team.agents if levels.get(one.program) is Level.SOCIAL), "")

    def program(self, name: str) -> Program | None:
        """The program of that name, or None."""
        return next((program for program in self.programs if program.name == name), None)
