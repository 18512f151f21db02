"""Puts a mission into its world: every agent at its start, every device in its bank, every wire connected.

Everything wrong is found in one go and raised together. Left to others: what happens then (simulation).
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from functools import reduce
from random import Random

from kitrobot.compiler import Compiled
from kitrobot.diagnostics import Diagnostic, KitRobotError
from kitrobot.image import Machine
from kitrobot.mission import Agent as Member
from kitrobot.mission import Mission
from kitrobot.primitives import Catalogue, Robot, did_you_mean, shown
from kitrobot.sim import rules
from kitrobot.sim.agents import ActuatorWire, Agent, SensorWire
from kitrobot.sim.bodies import FREE
from kitrobot.sim.devices import Actuator, Device, Sensor, Stage, Standing, Values, actuators, sensors
from kitrobot.sim.devices.base import ticks
from kitrobot.sim.settings import find_device, read_settings
from kitrobot.world import LOAD, Start, World, distance_to_stretch

MAX_AGENTS = 10_000
"""Agents in one run at most."""


class SimulationError(KitRobotError):
    """A mission cannot be run in its world; `diagnostics` says everything that is in the way."""


class Staging:
    """Builds the stage, the banks and the agents of a run.

    Raises:
        SimulationError: the mission cannot be run.
    """

    def __init__(
        self, mission: Mission, world: World, images: Mapping[str, Compiled], catalogue: Catalogue, seed: int
    ) -> None:
        self.mission = mission
        self.world = world
        self.images = images
        self.catalogue = catalogue
        self.seed = seed
        self.stage = Stage(world)
        self.agents: list[Agent] = []
        self.problems: list[Diagnostic] = []
        self.step_ms = 1
        self.actuators = {name: device(self.stage) for name, device in actuators().items()}
        self.sensors = {name: device(self.stage) for name, device in sensors().items()}
        self._checked: dict[tuple[str, str, str], tuple[type[Device] | None, Values | None]] = {}
        self._starts = {start.name: start for start in world.starts}
        self._kinds: Counter[str] = Counter()
        self._build()
        if self.problems:
            first = self.problems[0]
            raise SimulationError(first.message, first.help, tuple(self.problems))

    def _build(self) -> None:
        members = self.mission.team.agents
        if not members:
            self.problems.append(rules.NO_AGENT("this mission has no agents, so there is nobody to run"))
            return
        if len(members) > MAX_AGENTS:
            message = f"expected at most {MAX_AGENTS} agents in a run, found {len(members)}"
            self.problems.append(rules.TOO_MANY(message, help="take some out of the team"))
            return
        robots = {name: self._robot(name) for name in dict.fromkeys(member.program for member in members)}
        if self.problems:
            return
        self.step_ms = reduce(math.gcd, (robot.tick_ms for robot in robots.values() if robot is not None))
        self.stage.dt = self.step_ms / 1000
        for member in members:
            robot = robots[member.program]
            if robot is not None:
                self._member(member, robot)
        for goal in self.mission.team.goals:
            if self.world.storehouse(goal.storehouse) is None:
                message = f"the goal's storehouse {shown(goal.storehouse)} is not in the world {self.world.name}"
                known = [house.name for house in self.world.storehouses]
                self.problems.append(rules.GOAL(message, help=did_you_mean(goal.storehouse, known)))
        if not self.problems:
            self._nobody_overlaps()

    def _robot(self, program_name: str) -> Robot | None:
        program = self.mission.program(program_name)
        compiled = self.images.get(program_name)
        if program is None or compiled is None or compiled.image is None:
            what = "is not in this mission" if program is None else "has errors"
            self.problems.append(rules.NO_PROGRAM(f"the program {shown(program_name)} {what}", program=program_name))
            return None
        robot = self.catalogue.robots.get(program.robot)
        if robot is None:
            message = f"the program {program_name} is for the robot {shown(program.robot)}, which is not at hand"
            help = did_you_mean(program.robot, self.catalogue.robots)
            self.problems.append(rules.NO_PROGRAM(message, help=help, program=program_name))
        return robot

    def _member(self, member: Member, robot: Robot) -> None:
        start = self._starts.get(member.start_name)
        if start is None:
            free = list(self._starts)
            message = f"{member.name} has no start {shown(member.start_name)} in the world {self.world.name}"
            help = did_you_mean(member.start_name, free) or f"starts of this world: {', '.join(free[:20]) or 'none'}"
            self.problems.append(rules.START(message, help=help))
            return
        image = self.images[member.program].image
        assert image is not None, "checked before"
        index = self.stage.bodies.add(self.world.start_pose(start))
        self.stage.delivered.append(0)
        agent = Agent(index, member.name, member.program, robot, Machine(image, robot), robot.tick_ms // self.step_ms)
        self.agents.append(agent)
        standing = self._standing(start)
        if start.road:
            self.stage.bodies.road[index] = standing.road
            self.stage.bodies.at[index] = self.world.roads[standing.road].line.wrapped(start.at_mm)
        for part in robot.actuators:
            bank, values, number, chance = self._connect(agent, part.name, "actuator", standing, start)
            if isinstance(bank, Actuator) and values is not None:
                delay = ticks(values.number("latency"), self.stage.dt)
                later = frozenset(method.name for method in part.methods if method.completes_later)
                agent.add_actuator(ActuatorWire(part.name, bank, number, delay, later), delay)
        for part in robot.sensors:
            bank, values, number, chance = self._connect(agent, part.name, "sensor", standing, start)
            if isinstance(bank, Sensor) and values is not None:
                delay = ticks(values.number("latency"), robot.tick_ms / 1000)
                noise = values.number("noise") if any(item.name == "noise" for item in bank.settings) else 0.0
                agent.sensors.append(SensorWire(part.name, bank, number, delay, noise, chance))
        agent.kind = self._kind(agent, standing)
        self._kinds[agent.kind] += 1
        agent.number = self._kinds[agent.kind]

    def _standing(self, start: Start) -> Standing:
        docks, roads, houses = self.world.docks, self.world.roads, self.world.storehouses
        dock = next((number for number, dock in enumerate(docks) if dock.name == start.dock), -1)
        road_name = docks[dock].road if dock >= 0 else start.road
        house_name = docks[dock].storehouse if dock >= 0 else start.storehouse
        road = next((number for number, road in enumerate(roads) if road.name == road_name), -1)
        house = next((number for number, house in enumerate(houses) if house.name == house_name), -1)
        return Standing(road, dock, house)

    def _connect(
        self, agent: Agent, name: str, category: str, standing: Standing, start: Start
    ) -> tuple[Device | None, Values | None, int, Random]:
        """One device of an agent, added to its bank: (bank, settings, its number there, its own chance)."""
        chance = Random(f"{self.seed}/{agent.name}/{category}/{name}")
        robot = agent.robot
        parts = robot.actuators if category == "actuator" else robot.sensors
        part = next(part for part in parts if part.name == name)
        key = (robot.name, category, name)
        if key not in self._checked:
            device, problems = find_device(robot, part)
            values = None
            if device is not None:
                values, wrong = read_settings(robot, part, device)
                problems = problems + wrong
            self.problems += problems
            self._checked[key] = (None, None) if problems else (device, values)
        device, values = self._checked[key]
        if device is None or values is None:
            return None, None, 0, chance
        needs = "road" if values.says("guide", "road") else device.needs
        has = {"road": bool(start.road), "dock": standing.dock >= 0, "storehouse": standing.storehouse >= 0}
        if needs and not has[needs]:
            message = (
                f"{agent.name} has {robot.name}.{name}, which needs a {needs}, and the start {start.name} has none"
            )
            self.problems.append(rules.START(message, help=f'give the <start> of this agent a {needs}="…"'))
            return None, None, 0, chance
        banks: Mapping[str, Device] = self.actuators if category == "actuator" else self.sensors
        bank = banks[part.device]
        return bank, values, bank.add(agent.index, part, values, standing, chance), chance

    def _kind(self, agent: Agent, standing: Standing) -> str:
        """How to draw it: carrier, loader, unloader, store-manager, or any other robot."""
        devices = {part.device for part in (*agent.robot.actuators, *agent.robot.sensors)}
        if {"drive", "cargo"} <= devices:
            return "carrier"
        if "arm" in devices and standing.dock >= 0:
            return "loader" if self.world.docks[standing.dock].kind == LOAD else "unloader"
        return "store-manager" if "store" in devices and "drive" not in devices else "robot"

    def _nobody_overlaps(self) -> None:
        """Robots start apart from one another and from the walls."""
        bodies, world = self.stage.bodies, self.world
        solid = [robot for robot in range(len(bodies)) if bodies.solid[robot]]
        for robot in solid:
            if bodies.road[robot] != FREE:
                continue
            for wall in world.walls:
                x, y = bodies.x[robot], bodies.y[robot]
                away, _ = distance_to_stretch(x, y, wall.x1_mm, wall.y1_mm, wall.x2_mm, wall.y2_mm)
                if away < bodies.radius[robot]:
                    message = f"{self.agents[robot].name} starts in a wall"
                    self.problems.append(rules.START(message, help="move its start away from the wall"))
                    break
        order = sorted(solid, key=lambda robot: bodies.x[robot])
        widest = max((bodies.length[robot] for robot in solid), default=0.0)
        for place, robot in enumerate(order):
            for other in order[place + 1 :]:
                if bodies.x[other] - bodies.x[robot] > widest:
                    break
                if self._overlap(robot, other):
                    message = f"{self.agents[robot].name} and {self.agents[other].name} start in the same place"
                    self.problems.append(rules.START(message, help="give them starts that are apart"))

    def _overlap(self, robot: int, other: int) -> bool:
        bodies = self.stage.bodies
        road = bodies.road[robot]
        if road != FREE and road == bodies.road[other]:
            way = self.stage.road_distance(road, bodies.at[robot], bodies.at[other])
            return way < (bodies.length[robot] + bodies.length[other]) / 2
        away = math.hypot(bodies.x[robot] - bodies.x[other], bodies.y[robot] - bodies.y[other])
        return away < bodies.radius[robot] + bodies.radius[other]
