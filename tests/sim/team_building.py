"""Random teams that run in the simulator, and what each robot did."""

from __future__ import annotations

import random
from dataclasses import replace

from kitrobot.compiler.compilation import compile_lll
from kitrobot.compiler.team.projection import project
from kitrobot.diagnostics.model import Source
from kitrobot.graph.model import Program, empty_program
from kitrobot.lll.printer import print_team_program
from kitrobot.lll.tree import TeamProgram
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.mission.radio import Radio
from kitrobot.mission.trial import Failure
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.crew import Crew, declaring
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.levels import Level
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.primitives.team_objects import with_team
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.team_columns import T_ANCHOR, T_ANCHORED, T_ROLE, T_SEAT, W_LEFT
from tests.sim.building import empty_world
from tests.team_programs.hosting import TooLarge
from tests.team_programs.making import KINDS, TeamMaker

XML = """<robot name="{name}" version="1" tick="{tick}" wait-unit="20">
  <actuator name="Arm" device="indicator" time="60" noise="50">
    <procedure name="Do" completes="later"><parameter name="n" min="0" max="60000"/></procedure>
  </actuator>
  <variable name="Count" min="0" max="1000"/>
  <variable name="Sum" min="0" max="1000" shared="yes"/>
  <variable name="Said" type="boolean" shared="yes"/>
</robot>"""


def worker(name: str, tick: int = 20) -> Robot:
    """A robot that does numbered things, each of which takes a while, and counts."""
    made, problems = read_robot(XML.format(name=name, tick=tick).encode(), f"{name}.robot.xml")
    assert made is not None, problems
    return made


class RunningTeam:
    """A random team in the simulator: `lines` are the numbers of the lines that each robot began, in order."""

    def __init__(
        self,
        maker: TeamMaker,
        program: TeamProgram,
        seed: int,
        failures: list[Failure] | None = None,
        radio: Radio | None = None,
    ) -> None:
        counts = {role.name: sum(one == role.name for _, one in maker.agents.values()) for role in program.roles}
        roles = [replace(role, least=counts[role.name], most=counts[role.name]) for role in program.roles]
        program = TeamProgram(roles, program.groups, program.works, program.seq)
        self.mission = Mission(
            programs=[Program("team", "", level=Level.SOCIAL), empty_program("own", KINDS[0])],
            team=Team(
                [Agent(name, "team", "", kind) for name, (kind, _) in maker.agents.items()],
                [],
                roles,
                program.groups,
                program.works,
            ),
            failures=failures or [],
            radio=radio,
        )
        crew = declaring(Crew(agents=tuple((name, kind) for name, (kind, _) in maker.agents.items())), program)
        source = Source("team.lll", print_team_program(program))
        shared = {work.name for work in program.works} | {"Sum", "Said"}
        projection = project(program.seq, crew, maker.programs, source, "team", lambda call: call.object in shared)
        assert projection.diagnostics == []
        self.crew, self.whole = crew, projection.whole
        self.robots = {name: worker(name, tick) for name, tick in zip(KINDS, (20, 40), strict=True)}
        self.images = {}
        for kind, seq in projection.programs.items():
            compiled = compile_lll(seq, with_team(self.robots[kind], program.works), name="team")
            if compiled.image is None:
                raise TooLarge
            self.images[ImageName("team", kind)] = compiled
        self.plan = projection.plan
        self.seed = seed
        self.names = list(maker.agents)
        self.run = self.anew()
        self.lines: dict[str, list[int]] = {name: [] for name in maker.agents}
        self.moments: dict[str, list[tuple[int, int]]] = {name: [] for name in maker.agents}
        """Of each line that a robot began, the tick, and the tick in which it was over."""

        self.anchors: dict[str, tuple[int, int]] = {}
        """What each robot had counted and how many lines it had begun, at the point at which a substitute begins."""

    def anew(self) -> Simulation:
        """The run before its first step."""
        world = empty_world(**{name: (100.0 * n + 50.0, 50.0, 0.0) for n, name in enumerate(self.names)})
        robots = Catalogue(robots=dict(self.robots))
        return Simulation(self.mission, world, self.images, robots, self.seed, 600, 0.0, self.plan)

    def step(self) -> None:
        """One step, what was begun in it, and who took over: with the counter and the lines as they stood where it is
        led to.
        """
        run = self.run
        run.step()
        table = run.state.team.robots
        for event in run.events:
            lost = lost_for(event)
            if lost:
                count, lines = self.anchors.pop(lost, (0, 0))
                self.lines[lost], self.lines[event.agent] = [], self.lines[lost][:lines]
                self.anchors[event.agent] = count, lines
                run.set_variable(event.agent, "Count", count)
        for agent in run.members:
            for command in agent.commands:
                if command.actuator == "Arm" and command.procedure == "Do":
                    self.lines[agent.name].append(command.arguments[0])
                    self.moments[agent.name].append((run.tick, 0))
            mine = self.moments[agent.name]
            if mine and not mine[-1][1] and not agent.busy:
                mine[-1] = (mine[-1][0], run.tick)
            if table[T_ANCHOR][agent.index] >= 0 and table[T_ANCHORED][agent.index] == run.tick - 1:
                count = int(agent.machine.cells[agent.machine.layout.variables["Count"]])
                self.anchors[agent.name] = count, len(self.lines[agent.name])

    def playing(self) -> list[str]:
        """Who has a role."""
        roles = self.run.state.team.robots[T_ROLE]
        return [agent.name for agent in self.run.members if roles[agent.index] >= 0]

    def lines_of_roles(self) -> dict[str, list[int]]:
        """The lines of those who have a role, by the robot in whose place each stands."""
        seats = self.run.state.team.robots[T_SEAT]
        names = [agent.name for agent in self.run.members]
        return {names[seats[names.index(name)]]: self.lines[name] for name in self.playing()}

    def left(self) -> dict[str, int]:
        """Of each work, how many units are not done."""
        table = self.run.state.team.works
        return {work.name: table[W_LEFT][n] for n, work in enumerate(self.mission.team.works)}

    def finish(self) -> None:
        """Until the run is over."""
        while self.run.outcome is None:
            self.step()


def lost_for(event: Event) -> str:
    """Who was missed before an agent plays its role, which may be the agent itself; "" for other events."""
    if event.text == "plays its role again":
        return event.agent
    told = "takes over for "
    return event.text.removeprefix(told) if event.text.startswith(told) else ""


def random_team_program(seed: int, spares: int = 0, asks: bool = True) -> tuple[TeamMaker, TeamProgram]:
    """What `TeamMaker` makes of a seed."""
    maker = TeamMaker(random.Random(seed), spares, asks)
    return maker, maker.program()
