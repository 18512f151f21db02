"""Random robots, programs and inputs, from any `random.Random`: a seeded one for volume, Hypothesis' for shrinking."""

from tests.strategies.inputs import TickInputs, random_script
from tests.strategies.programs import Shape, random_program
from tests.strategies.robots import random_robot, random_robot_xml, shipped_robots
from tests.strategies.shrinking import shrink
from tests.strategies.teams import random_team_program

__all__ = [
    "Shape",
    "TickInputs",
    "random_program",
    "random_robot",
    "random_robot_xml",
    "random_script",
    "random_team_program",
    "shipped_robots",
    "shrink",
]
