"""A table full of boxes, and robots that drive to and fro among them and push them: to measure with."""

from __future__ import annotations

import math
import random

from kitrobot.compiler.compilation import compile_text
from kitrobot.graph.model import empty_program
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.sim.simulation import Simulation
from kitrobot.world.geometry import Pose
from kitrobot.world.model import Box, Start, Wall, World

SIZE_MM = 5000.0
BOX_MM = 80.0
RADIUS_MM = 60.0
SPEED_MM_S = 200.0
BACK_STEPS = 200
"""A robot turns back after so many steps: four seconds, 800 mm."""
_ROW = 25
_APART_MM = 180.0
_ROBOT = """<robot name="pusher" version="1" tick="20" wait-unit="100">
  <actuator name="Wheel" device="drive" speed="400" length="120">
    <procedure name="Advance"><parameter name="speed" min="0" max="100"/></procedure>
    <procedure name="Reverse"><parameter name="speed" min="0" max="100"/></procedure>
  </actuator>
  <variable name="Run" type="boolean" initial="true"/>
</robot>
"""
_PROGRAM = "*[Run.IsTrue()]( Wheel.Advance(50); WAIT(40); Wheel.Reverse(50); WAIT(40); );"


def boxes(count: int) -> list[tuple[float, float]]:
    """Where boxes stand: rows of 25, 180 mm apart."""
    return [(250.0 + _APART_MM * (n % _ROW), 250.0 + _APART_MM * (n // _ROW)) for n in range(count)]


def robots(count: int) -> list[tuple[float, float, float]]:
    """Where robots stand, between the boxes, and where they look."""
    chance = random.Random(1)
    side = math.ceil(math.sqrt(count))
    every = int(_ROW / side)
    return [
        (
            160.0 + _APART_MM * every * (n % side),
            160.0 + _APART_MM * every * (n // side),
            chance.uniform(-math.pi, math.pi),
        )
        for n in range(count)
    ]


def table(box_count: int, robot_count: int) -> Simulation:
    """The run before its first step."""
    robot, problems = read_robot(_ROBOT.encode(), "pusher.robot.xml")
    assert robot is not None, problems
    compiled = compile_text(_PROGRAM, robot)
    ends = [(0.0, 0.0), (SIZE_MM, 0.0), (SIZE_MM, SIZE_MM), (0.0, SIZE_MM)]
    world = World(
        "table",
        SIZE_MM,
        SIZE_MM,
        walls=tuple(Wall(*one, *other) for one, other in zip(ends, ends[1:] + ends[:1], strict=True)),
        starts=tuple(Start(f"r{n}", pose=Pose(*pose)) for n, pose in enumerate(robots(robot_count))),
        boxes=tuple(Box(x, y, BOX_MM, BOX_MM, 200.0, 0.5) for x, y in boxes(box_count)),
    )
    mission = Mission(programs=[empty_program("push", "pusher")])
    mission.team = Team([Agent(f"r{n}", "push") for n in range(robot_count)])
    return Simulation(mission, world, {ImageName("push"): compiled}, Catalogue(robots={"pusher": robot}), 1)
