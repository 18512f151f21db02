"""Setup of a run: places agents and their devices in the world and fills the tables.

All mistakes are collected and raised together. Left to others: what the tables look like (tables), and what
happens then (simulation).
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from functools import reduce

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.compiler.team.points import TeamPlan
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.image.machine import Machine
from kitrobot.mission.model import ALL, Mission
from kitrobot.mission.model import Agent as Member
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot import Robot, RobotObject
from kitrobot.primitives.team_objects import with_team
from kitrobot.sim.devices import Device, Placement, Values
from kitrobot.sim.devices.base import COUNTS_BOXES, MOVES_BOXES
from kitrobot.sim.setup import rules
from kitrobot.sim.setup.initial_state import Tables
from kitrobot.sim.setup.limits import MAX_AGENTS, SimulationError
from kitrobot.sim.setup.settings import find_device, name_problems, read_conflicts, read_settings
from kitrobot.sim.setup.shared_tables import SharedTables
from kitrobot.sim.setup.start_places import StartPlaces
from kitrobot.sim.setup.team_tables import TeamMember, TeamSetup, assign_roles
from kitrobot.sim.step.agents import Agent
from kitrobot.sim.step.fault_schedule import fault_plan
from kitrobot.sim.tables.columns import AT, BED, ROAD, SOLID
from kitrobot.text.collection import collection_paused
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import COMMA, Help, Sentence, Series, Word
from kitrobot.text.suggestions import Suggestions, did_you_mean
from kitrobot.world.model import LOAD, Start, World

MOST_STEP_MS = 20
"""A step is not longer than this, and divides it: so a robot that ticks as ours changes no run of others."""


def free_start(name: str, free: Sequence[str], suggestions: Suggestions) -> Help:
    """The help for an agent whose start a world has not: the free one that was meant, or those there are."""
    if free:
        return suggestions.did_you_mean(name, free) or Sentence(
            "starts that are free there: {free}", Series(COMMA, free[:20])
        )
    return Sentence("no start of this world is free: add one to it, or take an agent out of the team")


class Setup:
    """Builds the tables and the agents of a run; with `check_only` no more of it than says whether it can be run.

    Raises:
        SimulationError: the mission cannot be run.
    """

    def __init__(
        self,
        mission: Mission,
        world: World,
        images: Mapping[ImageName, CompiledProgram],
        catalogue: Catalogue,
        fail_rate: float = 0.0,
        check_only: bool = False,
        team: TeamPlan | None = None,
    ) -> None:
        self.mission = mission
        self.world = world
        self.images = images
        self.catalogue = catalogue
        self.fail_rate = fail_rate
        self._check_only = check_only
        self._team = team
        self.agents: list[Agent] = []
        self.problems: list[Diagnostic] = []
        self.step_ms = 1
        self.tables = Tables(world, 1)
        self._machines: dict[ImageName, Machine] = {}
        self._placements: dict[tuple[str, str, str], Placement] = {}
        self._checked: dict[tuple[str, str, str], tuple[type[Device] | None, Values | None]] = {}
        self._starts = {start.name: start for start in world.starts}
        self._free_starts = mission.team.free(self._starts)
        self._suggestions = Suggestions()
        self._kinds: Counter[str] = Counter()
        self._places: dict[tuple[int, int], int] = {}
        self._build()
        if self.problems:
            first = self.problems[0]
            raise SimulationError(first.message, first.help, tuple(self.problems))

    def _build(self) -> None:
        members = self.mission.team.agents
        if not members:
            help = Sentence('add one in the studio, or write <agent name="robot-1" program="…"/> into its <team>')
            self.problems.append(
                rules.NO_AGENT(Sentence("this mission has no agents, so there is nobody to run"), help=help)
            )
            return
        if len(members) > MAX_AGENTS:
            message = Sentence("expected at most {most} agents in a run, found {count}", MAX_AGENTS, len(members))
            self.problems.append(rules.TOO_MANY(message, help=Sentence("take some out of the team")))
            return
        robots = {member.image_name: self._robot(member) for member in _one_of_each(members)}
        for kind in {robot.name: robot for robot in robots.values() if robot is not None}.values():
            self.problems += read_conflicts(kind)
        if self.problems:
            return
        self.step_ms = reduce(math.gcd, (robot.tick_ms for robot in robots.values() if robot is not None), MOST_STEP_MS)
        self.tables = Tables(self.world, self.step_ms)
        self.tables.radio = self.mission.radio
        self.tables.numbers = {agent.name: number for number, agent in enumerate(members)}
        if self._team is not None:
            self.tables.team = TeamSetup(self._team, self.mission.team)
        for member in members:
            robot = robots[member.image_name]
            if robot is not None:
                self._member(member, robot)
        houses = [house.name for house in self.world.storehouses]
        total = sum(house.stock for house in self.world.storehouses)
        for goal in self.mission.team.goals:
            if goal.storehouse in houses:
                self.tables.goals[0].append(houses.index(goal.storehouse))
                self.tables.goals[1].append(total if goal.stock == ALL else int(goal.stock))
            else:
                message = Sentence(
                    "the goal's storehouse {storehouse} is not in the world {world}",
                    shown(goal.storehouse),
                    self.world.name,
                )
                self.problems.append(rules.GOAL(message, help=did_you_mean(goal.storehouse, houses)))
        if self.tables.team is not None:
            self._fill_roles(self.tables.team)
        if not self.problems:
            places = StartPlaces(self.world, self.mission.team, self.agents, self.tables, self._free_starts)
            self.problems += places.problems()
        if self._check_only:
            return
        self.tables.breakdown = self.mission.breakdown
        names = [agent.name for agent in self.agents]
        self.tables.fault_plan = fault_plan(self.mission.failures, names, self.step_ms, self.fail_rate)

    def _fill_roles(self, team: TeamSetup) -> None:
        """Whether each role has as many robots as it needs at least."""
        playing = Counter(assign_roles(team.declared.roles, team.members).values())
        for number, role in enumerate(team.declared.roles):
            if playing[number] < role.least:
                message = Sentence(
                    "the role `{role}` wants {least} of the robot `{robot}`, and {found} are free for it",
                    role.name,
                    role.least,
                    role.robot,
                    playing[number],
                )
                help = Sentence("add agents that run the team's program on that robot, or want fewer")
                self.problems.append(rules.ROLE(message, help=help))

    def _robot(self, member: Member) -> Robot | None:
        program_name = member.program
        program = self.mission.program(program_name)
        compiled = self.images.get(member.image_name)
        if program is None or compiled is None or compiled.image is None:
            what = Sentence("is not in this mission") if program is None else Sentence("has errors")
            self.problems.append(
                rules.NO_PROGRAM(
                    Sentence("the program {program} {what}", shown(program_name), what), program=program_name
                )
            )
            return None
        if member.robot:
            return with_team(self.catalogue.robots[member.robot], self.mission.team.works)
        robot = self.catalogue.robots.get(program.target)
        if robot is None:
            message = Sentence(
                "the program {program} is for the robot {robot}, which is not at hand",
                program_name,
                shown(program.target),
            )
            help = did_you_mean(program.target, self.catalogue.robots)
            self.problems.append(rules.NO_PROGRAM(message, help=help, program=program_name))
        return robot

    def _member(self, member: Member, robot: Robot) -> None:
        start = self._starts.get(member.start_name)
        if start is None:
            message = Sentence(
                "{agent} has no start {start} in the world {world}",
                member.name,
                shown(member.start_name),
                self.world.name,
            )
            help = free_start(member.start_name, self._free_starts, self._suggestions)
            self.problems.append(rules.START(message, help=help))
            return
        tables = self.tables
        machine = self._machine(member.image_name, robot)
        period = robot.tick_ms // self.step_ms
        index = tables.add_robot(self.world.start_pose(start), robot, machine, period)
        agent = Agent(index, member.name, member.program, robot, machine, period)
        self.agents.append(agent)
        placement = self._placement(start)
        if start.road:
            tables.ints[ROAD][index] = placement.road
            tables.floats[AT][index] = self.world.roads[placement.road].line.wrapped(start.at_mm)
        handles: set[str] = set()
        for parts in (robot.actuators, robot.sensors):
            for number, part in enumerate(parts):
                device, values = self._device(agent, part, placement, start)
                if device is None or values is None:
                    continue
                handles.add(device.handles)
                if self._check_only:
                    device.fit(index, tables.floats, tables.ints, values)
                else:
                    tables.add_device(index, number, part, device, values, placement)
        if tables.team is not None and member.robot:
            agent.image_name = member.image_name
            place = self._place(placement, handles)
            tables.team.members.append(TeamMember(index, member.name, member.robot, place=place))
        agent.kind = self._kind(index, handles, placement)
        self._kinds[agent.kind] += 1
        agent.number = self._kinds[agent.kind]

    def _place(self, placement: Placement, handles: Collection[str]) -> int:
        """A number for where a robot stands for good: its storehouse, and the road there that its arm serves."""
        if placement.storehouse < 0:
            return -1
        key = placement.storehouse, placement.road if MOVES_BOXES in handles else -1
        return self._places.setdefault(key, len(self._places))

    def _machine(self, image_name: ImageName, robot: Robot) -> Machine:
        """A machine at the beginning of a program; those of one program share what does not change."""
        first = self._machines.get(image_name)
        if first is None:
            image = self.images[image_name].image
            assert image is not None, "checked before"
            first = self._machines[image_name] = Machine(image, robot)
        return first if self._check_only else first.twin()

    def _placement(self, start: Start) -> Placement:
        key = (start.dock, start.road, start.storehouse)
        if key not in self._placements:
            docks, roads, houses = self.world.docks, self.world.roads, self.world.storehouses
            dock = next((number for number, dock in enumerate(docks) if dock.name == start.dock), -1)
            road_name = docks[dock].road if dock >= 0 else start.road
            house_name = docks[dock].storehouse if dock >= 0 else start.storehouse
            road = next((number for number, road in enumerate(roads) if road.name == road_name), -1)
            house = next((number for number, house in enumerate(houses) if house.name == house_name), -1)
            self._placements[key] = Placement(road, dock, house)
        return self._placements[key]

    def _device(
        self, agent: Agent, part: RobotObject, placement: Placement, start: Start
    ) -> tuple[type[Device] | None, Values | None]:
        """What simulates an actuator or sensor of an agent, and its settings; None for what is wrong."""
        robot = agent.robot
        key = (robot.name, part.category.value, part.name)
        if key not in self._checked:
            device, problems = find_device(robot, part)
            values = None
            if device is not None:
                names = [agent.name for agent in self.mission.team.agents]
                values, wrong = read_settings(part, device, f"{robot.name}.{part.name}")
                problems = problems + (wrong or name_problems(robot, part, device, values, self.world, names))
            self.problems += problems
            self._checked[key] = (None, None) if problems else (device, values)
        device, values = self._checked[key]
        if device is None or values is None:
            return None, None
        needs = "road" if values.says("guide", "road") else device.needs
        has = {"road": bool(start.road), "dock": placement.dock >= 0, "storehouse": placement.storehouse >= 0}
        if needs and not has[needs]:
            message = Sentence(
                "{agent} has {robot}.{part}, which needs a {place}, and the start {start} has none",
                agent.name,
                robot.name,
                part.name,
                Word(needs),
                start.name,
            )
            self.problems.append(
                rules.START(message, help=Sentence('give the <start> of this agent a {place}="…"', needs))
            )
            return None, None
        return device, values

    def _kind(self, robot: int, handles: Collection[str], placement: Placement) -> str:
        """How to draw it: carrier, loader, unloader, store-manager, or any other robot."""
        solid = self.tables.ints[SOLID][robot]
        if solid and self.tables.ints[BED][robot]:
            return "carrier"
        if MOVES_BOXES in handles and placement.dock >= 0:
            return "loader" if self.world.docks[placement.dock].kind == LOAD else "unloader"
        return "store-manager" if COUNTS_BOXES in handles and not solid else "robot"


def _one_of_each(members: Sequence[Member]) -> list[Member]:
    """The first agent of each image."""
    return list({member.image_name: member for member in reversed(members)}.values())[::-1]


def shared_tables_of(agents: Sequence[Agent]) -> SharedTables:
    """The variables that the agents share.

    Raises:
        SimulationError: one of them has two meanings.
    """
    shared = SharedTables(agents)
    if shared.problems:
        first = shared.problems[0]
        raise SimulationError(first.message, first.help, tuple(shared.problems))
    return shared


def check_mission(
    mission: Mission,
    world: World,
    images: Mapping[ImageName, CompiledProgram],
    catalogue: Catalogue,
    team: TeamPlan | None = None,
) -> None:
    """Looks whether a mission can be run in its world, without making the run: quicker where agents are very many.

    Raises:
        SimulationError: it cannot; its diagnostics say everything that is in the way.
    """
    with collection_paused():
        shared_tables_of(Setup(mission, world, images, catalogue, check_only=True, team=team).agents)
