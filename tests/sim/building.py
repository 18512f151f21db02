"""Missions, worlds and runs for tests, from LLL texts and a few words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

from kitrobot.compiler.compilation import CompiledProgram, compile_program, compile_text
from kitrobot.graph.model import empty_program
from kitrobot.mission.model import Agent, Goal, Mission, Team
from kitrobot.mission.radio import Radio
from kitrobot.mission.reader import read_mission
from kitrobot.mission.trial import Failure
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import FREE, PIECES, ROAD, ROBOT_FLOATS, ROBOT_INTS
from kitrobot.sim.tables.state import Robots
from kitrobot.world.geometry import Pose
from kitrobot.world.lookup import find_world
from kitrobot.world.model import Start, World
from kitrobot.world.xml_reader import read_world

EXAMPLE = Path(__file__).parents[2] / "examples" / "transport" / "transport.krt"

AVATAR = """
<robot name="avatar" version="1" tick="{tick}" wait-unit="100">
  <help>A robot for tests.</help>
  {parts}
</robot>
"""

WHEEL = """<actuator name="Wheel" device="drive" {settings}>
  <procedure name="Advance" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
  <procedure name="Reverse" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
  <procedure name="Stop"/>
</actuator>"""

SIDE = """<actuator name="{name}" device="wheel" {settings}>
  <procedure name="Forward" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
  <procedure name="Backward" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
  <procedure name="Stop"/>
</actuator>"""

MOTOR = """<actuator name="Motor" device="turn" {settings}>
  <procedure name="AbsoluteTurn" completes="later" stop="Stop">
    <parameter name="angle" min="0" max="100"/><parameter name="speed" min="0" max="100"/>
  </procedure>
  <procedure name="Turn" stop="Stop"><parameter name="speed" min="0" max="100"/></procedure>
  <procedure name="Stop"/>
</actuator>"""


@cache
def catalogue() -> Catalogue:
    """What is shipped."""
    return load_catalogue()


def avatar(*parts: str, tick: int = 20, name: str = "avatar") -> Robot:
    """A robot from the XML of its parts."""
    text = AVATAR.format(tick=tick, parts="\n".join(parts)).replace('name="avatar"', f'name="{name}"')
    robot, problems = read_robot(text.encode(), f"{name}.robot.xml")
    assert robot is not None, problems
    return robot


def shipped_world(name: str) -> World:
    """A world that comes with KitRobot."""
    path = find_world(f"{name}.world.xml")
    assert path is not None
    world, problems = read_world(path.read_bytes(), path.name)
    assert world is not None
    assert problems == []
    return world


def empty_world(**poses: tuple[float, float, float]) -> World:
    """The empty room, with a start for each robot named."""
    starts = tuple(Start(name, pose=Pose(*pose)) for name, pose in poses.items())
    return replace(shipped_world("empty"), starts=starts)


def robots_with(real: Mapping[int, list[float]]) -> Robots:
    """Tables of robots that have wheels and are free, with these columns of numbers; all else is 0."""
    count = len(next(iter(real.values())))
    who = list(range(count))
    reals = [list(real.get(column, [0.0] * count)) for column in range(ROBOT_FLOATS)]
    wholes = [[{ROAD: FREE, PIECES: 1}.get(column, 0)] * count for column in range(ROBOT_INTS)]
    return Robots(reals, wholes, solid=who, guided=[], free=who, free_solid=who, carriers=[])


def run_of(
    agents: Mapping[str, tuple[Robot, str]],
    world: World,
    goals: Sequence[Goal] = (),
    seed: int = 1,
    seconds: float | None = 60,
    failures: Sequence[Failure] = (),
    fail_rate: float = 0.0,
    radio: Radio | None = None,
) -> Simulation:
    """A run in which each agent has its own robot and LLL text."""
    mission = Mission(team=Team(goals=list(goals)), failures=list(failures), radio=radio)
    images: dict[ImageName, CompiledProgram] = {}
    robots = Catalogue(robots={})
    for name, (robot, text) in agents.items():
        mission.programs.append(empty_program(f"program of {name}", robot.name))
        mission.team.agents.append(Agent(name, f"program of {name}"))
        robots.robots[robot.name] = robot
        images[ImageName(f"program of {name}")] = compiled = compile_text(text, robot)
        assert compiled.ok, compiled.diagnostics
    return Simulation(mission, world, images, robots, seed, seconds, fail_rate)


def steps(simulation: Simulation, count: int) -> Simulation:
    """The run after so many steps more."""
    for _ in range(count):
        simulation.advance(1)
    return simulation


@cache
def _example() -> tuple[bytes, dict[ImageName, CompiledProgram]]:
    data = EXAMPLE.read_bytes()
    mission, problems = read_mission(data, EXAMPLE.name)
    assert mission is not None
    assert problems == []
    images = {ImageName(program.name): compile_program(program, catalogue()) for program in mission.programs}
    assert [diagnostic for compiled in images.values() for diagnostic in compiled.diagnostics] == []
    return data, images


def example_images() -> dict[ImageName, CompiledProgram]:
    """The compiled programs of the transport example."""
    return _example()[1]


def transport(
    seed: int = 1,
    stock: int = 12,
    carriers: int = 3,
    seconds: float | None = 600,
    failures: Sequence[Failure] = (),
    fail_rate: float = 0.0,
    radio: Radio | None = None,
) -> Simulation:
    """The example that everybody sees first, with so many boxes in A and so many carriers."""
    data, images = _example()
    mission, _ = read_mission(data, EXAMPLE.name)
    assert mission is not None
    mission.failures, mission.radio = list(failures), radio
    mission.team.agents = [
        agent for agent in mission.team.agents if agent.program != "carrier" or int(agent.name[-1]) <= carriers
    ]
    ring = shipped_world("ring")
    houses = tuple(replace(house, stock=stock) if house.name == "A" else house for house in ring.storehouses)
    return Simulation(mission, replace(ring, storehouses=houses), images, catalogue(), seed, seconds, fail_rate)
