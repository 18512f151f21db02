"""Robots in their hundreds and thousands, to measure with: they drive about, look in three directions, and turn away.

They stand on a grid of 400 mm in a square arena with a wall around and a short wall for every eight robots, each
looking another way. Each has three range sensors, wheels and a motor; its program reads all three sensors in every
tick, keeps a count, and tells its motor what to do: 20 instructions a tick or more (`instructions_a_tick`).
"""

from __future__ import annotations

import math
import random
from functools import cache

from kitrobot.compiler.compilation import CompiledProgram, compile_text
from kitrobot.graph.model import empty_program
from kitrobot.image.machine import Machine
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.mission.radio import Radio
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.sim.simulation import Simulation
from kitrobot.world.geometry import Pose
from kitrobot.world.model import Start, Wall, World

SPACING_MM = 400.0
_EYE = """<sensor name="{name}" device="range" min="0" max="100" reach="1000" angle="{angle}">
  <operation name="LessThan" test="less"><parameter name="value" min="0" max="100"/></operation></sensor>"""
ROBOT = f"""<robot name="rover" version="1" tick="20" wait-unit="100">
  <actuator name="Motor" device="turn">
    <procedure name="Turn"><parameter name="speed" min="0" max="100"/></procedure>
    <procedure name="Stop"/>
  </actuator>
  <actuator name="Wheel" device="drive">
    <procedure name="Advance"><parameter name="speed" min="0" max="100"/></procedure>
    <procedure name="Stop"/>
  </actuator>
  {_EYE.format(name="Front", angle=0)}{_EYE.format(name="Left", angle=45)}{_EYE.format(name="Right", angle=-45)}
  <variable name="Count" type="integer" min="0" max="100" initial="0"/>
  <variable name="Way" type="integer" min="0" max="1000" initial="0"/>
  <variable name="Near" type="integer" min="0" max="100" initial="0"/>
</robot>
"""
PROGRAM = """Wheel.Advance(30);
*[Near.LessThan(100)](
  Count.Add(1); Way.Add(Count.Value()); Way.Sub(Count.Value());
  [Count.EqualTo(90)]( Count.Set(0); )
  [Left.LessThan(15)]( Near.Set(1); )!( Near.Set(0); )
  [Right.LessThan(15)]( Near.Add(1); )
  [Front.LessThan(20)]( Near.Add(2); )
  [Near.GreaterThan(1)]( Motor.Turn(60); )!( Motor.Stop(); )
);
"""


_SHARED = '<variable name="Heard" type="integer" min="0" max="1000" initial="0" shared="yes"/>'


@cache
def rover(*, talks: bool = False) -> Robot:
    """The robot; one that talks has a variable that all share, and adds to it once in 90 of its ticks."""
    text = ROBOT.replace("</robot>", f"{_SHARED}</robot>") if talks else ROBOT
    robot, problems = read_robot(text.encode(), "rover.robot.xml")
    assert robot is not None, problems
    return robot


@cache
def _compiled(*, talks: bool = False) -> CompiledProgram:
    text = PROGRAM.replace("Count.Set(0);", "Count.Set(0); Heard.Add(1);") if talks else PROGRAM
    compiled = compile_text(text, rover(talks=talks))
    assert compiled.image is not None, compiled.diagnostics
    return compiled


def instructions_a_tick() -> int:
    """How many instructions the program runs in a tick in which nothing is near."""
    image = _compiled().image
    assert image is not None
    machine = Machine(image, rover(), watch=True)
    for eye in ("Front", "Left", "Right"):
        machine.set_input(eye, 100)
    for _ in range(3):
        machine.tick()
    return sum(machine.seen)


def arena(robots: int, seed: int = 1) -> World:
    """The world for so many robots, with a start for each."""
    rng = random.Random(seed)
    side = math.ceil(math.sqrt(robots))
    size = (side + 1) * SPACING_MM
    walls = [Wall(0, 0, size, 0), Wall(size, 0, size, size), Wall(size, size, 0, size), Wall(0, size, 0, 0)]
    for _ in range(robots // 8):
        x, y = (rng.randrange(1, side + 1) + 0.5) * SPACING_MM, (rng.randrange(1, side + 1) + 0.5) * SPACING_MM
        across = rng.random() < 0.5
        walls.append(Wall(x, y, x + (100 if across else 0), y + (0 if across else 100)))
    starts = tuple(
        Start(
            f"r{n}",
            pose=Pose((n % side + 1) * SPACING_MM, (n // side + 1) * SPACING_MM, rng.uniform(-math.pi, math.pi)),
        )
        for n in range(robots)
    )
    return World("arena", size + 500, size + 500, walls=tuple(walls), starts=starts)


def swarm(robots: int, *, talks: bool = False, radio: Radio | None = None) -> Simulation:
    """A run of so many, before its first step."""
    mission = Mission(programs=[empty_program("roam", "rover")], radio=radio)
    mission.team = Team([Agent(f"r{n}", "roam") for n in range(robots)])
    catalogue = Catalogue(robots={"rover": rover(talks=talks)})
    return Simulation(mission, arena(robots), {ImageName("roam"): _compiled(talks=talks)}, catalogue, 1)
