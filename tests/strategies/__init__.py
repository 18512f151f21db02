"""Random robots, programs and inputs, from any `random.Random`: a seeded one for volume, Hypothesis' for shrinking."""

from tests.strategies.inputs import TickInputs, random_script
from tests.strategies.programs import Shape, random_program
from tests.strategies.robots import random_robot, random_robot_xml, shipped_robots
from tests.strategies.shrinking import shrink

__all__ = [
    "Shape",
    "TickInputs",
    "random_program",
    "random_robot",
    "random_robot_xml",
    "random_script",
    "shipped_robots",
    "shrink",
]
