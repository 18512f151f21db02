"""Consistency of a mission: its agents, their programs and robots, and the places of the world that they need."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from kitrobot.compiler.team.names import check_declarations
from kitrobot.diagnostics.model import Diagnostic, Place, Severity, rule
from kitrobot.files.places import Places
from kitrobot.lll.tree import AnyDeclaration
from kitrobot.mission.model import Agent, Mission
from kitrobot.mission.rules import AGENT_ROBOT, NO_PROGRAM
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.crew import Crew
from kitrobot.primitives.levels import Level
from kitrobot.primitives.team_objects import has_team
from kitrobot.sim.setup.setup import free_start
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import Suggestions
from kitrobot.world.model import World

SAME_NAME = rule(
    "mission-same-name",
    Severity.ERROR,
    "Two programs or two agents have one name",
    "Programs and agents are known by their names, so each name is used once.",
)
NO_ROBOT = rule(
    "mission-no-robot",
    Severity.ERROR,
    "A program is for a robot that is not at hand",
    "Robots come with KitRobot, from the user's own folder, and from the mission's folder.",
)
NO_START = rule(
    "mission-no-start",
    Severity.ERROR,
    "An agent has no place to start from",
    "An agent starts at the start of the world that has its name, or at the one that its `start` names.",
)
NO_STOREHOUSE = rule(
    "mission-no-storehouse",
    Severity.ERROR,
    "A goal names a storehouse that is not in the world",
    "A goal says what a storehouse of the world holds in the end.",
)
LOST_BREAKPOINT = rule(
    "mission-lost-breakpoint",
    Severity.WARNING,
    "A breakpoint that no run comes to",
    "A breakpoint names a vertex of a program of the mission, and perhaps agents of its team. One that names what is"
    " not there pauses no run; it is kept as it is.",
)


def mission_problems(
    mission: Mission, catalogue: Catalogue, world: World | None, places: Places | None
) -> list[Diagnostic]:
    """What is wrong between the parts of a mission; without a world nothing is said about places in it."""
    checker = _MissionChecker(mission, catalogue, world, places)
    return [*checker.programs(), *checker.agents(), *checker.goals(), *checker.declarations(), *checker.breakpoints()]


class _MissionChecker:
    def __init__(self, mission: Mission, catalogue: Catalogue, world: World | None, places: Places | None) -> None:
        self.mission = mission
        self.catalogue = catalogue
        self.world = world
        self.places = places
        self.suggestions = Suggestions()
        self.social = mission.social
        self.levels = {program.name: program.level for program in reversed(mission.programs)}

    def programs(self) -> Iterable[Diagnostic]:
        names = Counter(program.name for program in self.mission.programs)
        for name in (name for name, count in names.items() if count > 1):
            yield SAME_NAME(
                Sentence.counted(
                    "{count} program is called `{name}`", "{count} programs are called `{name}`", names[name], name
                ),
                self._program(name),
                program=name,
            )
        robots = self.catalogue.robots
        for program in self.mission.programs:
            if not program.level.is_team and program.target not in robots:
                message = Sentence(
                    "the program `{program}` is for the robot `{robot}`, which is not at hand",
                    program.name,
                    program.target,
                )
                help = self._help(program.target, robots) or Sentence("robots at hand: {robots}", listed(robots))
                yield NO_ROBOT(message, self._program(program.name), help=help, program=program.name)

    def agents(self) -> Iterable[Diagnostic]:
        team = self.mission.team
        names = Counter(agent.name for agent in team.agents)
        for name in (name for name, count in names.items() if count > 1):
            yield SAME_NAME(
                Sentence.counted(
                    "{count} agent is called `{name}`", "{count} agents are called `{name}`", names[name], name
                ),
                self._agent(name),
            )
        programs = dict.fromkeys(program.name for program in self.mission.programs)
        known = dict.fromkeys(start.name for start in (self.world.starts if self.world is not None else ()))
        free = team.free(known)
        for agent in team.agents:
            # Of a file, its reader has told this.
            if self.places is None and agent.program not in programs:
                message = Sentence(
                    "`{agent}` runs the program `{program}`, which is not in this mission", agent.name, agent.program
                )
                help = self._help(agent.program, programs) or Sentence(
                    "its programs: {names}", listed(programs) or "none"
                )
                yield NO_PROGRAM(message, help=help)
            yield from self._robot(agent)
            if self.world is not None and agent.start_name not in known:
                message = Sentence(
                    "`{agent}` would start at `{start}`, which the world `{world}` has not",
                    agent.name,
                    agent.start_name,
                    self.world.name,
                )
                start = free_start(agent.start_name, free, self.suggestions)
                yield NO_START(message, self._agent(agent.name), help=start)

    def breakpoints(self) -> Iterable[Diagnostic]:
        vertices = {
            program.name: dict.fromkeys(vertex.id for vertex in program.vertices)
            for program in reversed(self.mission.programs if self.mission.breakpoints else ())
        }
        agents = dict.fromkeys(agent.name for agent in self.mission.team.agents)
        for number, one in enumerate(self.mission.breakpoints):
            place = self.places.breakpoint(number) if self.places is not None else None
            known = vertices.get(one.program)
            if known is None:
                message = Sentence(
                    "a breakpoint stands in the program `{program}`, which is not in this mission", one.program
                )
                yield LOST_BREAKPOINT(message, place, help=self._help(one.program, vertices))
            elif one.vertex not in known:
                message = Sentence(
                    "a breakpoint stands at `{vertex}`, which is not in the program `{program}`",
                    one.vertex,
                    one.program,
                )
                yield LOST_BREAKPOINT(message, place, help=self._help(one.vertex, known), program=one.program)
            for agent in one.agents:
                if agent not in agents:
                    message = Sentence("a breakpoint watches `{agent}`, which is not in the team", agent)
                    yield LOST_BREAKPOINT(message, place, help=self._help(agent, agents))

    def _robot(self, agent: Agent) -> Iterable[Diagnostic]:
        """Whether it is clear of which kind an agent is."""
        level = self.levels.get(agent.program)
        told: tuple[Sentence, Help] | None = None
        if level is Level.GROUP:
            told = (
                Sentence("`{agent}` runs `{program}`, which is the program of a group", agent.name, agent.program),
                Sentence("let it run one of the level social, which names the other with PROGRAM"),
            )
        elif level is Level.SOCIAL and agent.program != self.social:
            told = (
                Sentence(
                    "`{agent}` runs `{program}`, and others run `{other}`, which is for the whole team too",
                    agent.name,
                    agent.program,
                    self.social,
                ),
                Sentence("let all of them run one program, which names others with PROGRAM"),
            )
        elif level is Level.SOCIAL and not agent.robot:
            kinds = dict.fromkeys(role.robot for role in self.mission.team.roles)
            told = (
                Sentence(
                    "`{agent}` runs `{program}`, which is for the whole team, and does not say which robot it is",
                    agent.name,
                    agent.program,
                ),
                Sentence('write robot="…" on it: {robots}', listed(kinds or self.catalogue.robots)),
            )
        elif level is Level.SOCIAL and agent.robot not in self.catalogue.robots:
            message = Sentence("`{agent}` is the robot `{robot}`, which is not at hand", agent.name, agent.robot)
            help = self._help(agent.robot, self.catalogue.robots)
            robots = Sentence("robots at hand: {robots}", listed(self.catalogue.robots))
            yield NO_ROBOT(message, self._agent(agent.name), help=help or robots)
        elif level is Level.SOCIAL and has_team(self.catalogue.robots[agent.robot], self.mission.team.works):
            told = (
                Sentence(
                    "the robot `{robot}` has a part called Team, or as a work, and the team needs that name",
                    agent.robot,
                ),
                Sentence("give its part another name"),
            )
        elif level is Level.AGENT and agent.robot:
            told = (
                Sentence("`{agent}` says which robot it is, and its program says that already", agent.name),
                Sentence('take robot="{robot}" away', agent.robot),
            )
        if told is not None:
            yield AGENT_ROBOT(told[0], self._agent(agent.name), help=told[1])

    def declarations(self) -> Iterable[Diagnostic]:
        return check_declarations(self.mission.crew or Crew(), self.catalogue.robots, self._declaration)

    def goals(self) -> Iterable[Diagnostic]:
        if self.world is None:
            return
        houses = [house.name for house in self.world.storehouses]
        for index, goal in enumerate(self.mission.team.goals):
            if self.world.storehouse(goal.storehouse) is None:
                message = Sentence(
                    "the world `{world}` has no storehouse `{storehouse}`", self.world.name, goal.storehouse
                )
                help = self._help(goal.storehouse, houses) or Sentence(
                    "storehouses there: {houses}", listed(houses) or "none"
                )
                yield NO_STOREHOUSE(message, self.places.goal(index) if self.places else None, help=help)

    def _help(self, name: str, names: Iterable[str]) -> Help:
        return self.suggestions.did_you_mean(name, names)

    def _program(self, name: str) -> Place | None:
        return self.places.program(name) if self.places else None

    def _declaration(self, declaration: AnyDeclaration) -> Place | None:
        return self.places.declaration(declaration.name) if self.places else None

    def _agent(self, name: str) -> Place | None:
        return self.places.agent(name) if self.places else None
