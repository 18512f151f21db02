"""What a program is compiled for: the meaning of the names it calls.

The target of an agent's program is a kind of robot, by its name.
"""

from __future__ import annotations

from typing import TypeAlias

from kitrobot.graph import Program
from kitrobot.primitives import Catalogue, Robot

Target: TypeAlias = Robot


def target_of(program: Program, catalogue: Catalogue) -> Target:
    """The target that a program names.

    Raises KitRobotError when the catalogue has no such robot.
    """
    return catalogue.robot(program.target)
