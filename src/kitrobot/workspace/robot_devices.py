"""Devices of a robot that the simulator lacks, or for which no board has a driver, reported at their lines of its file.

A device that only one of the two knows is a hint, since the robot runs there; one that neither knows is an error, and
so are settings that the simulator's device cannot follow.
"""

from __future__ import annotations

from pathlib import Path

from kitrobot.deploy.package.package import Package
from kitrobot.diagnostics.model import Diagnostic, Severity, in_reading_order, rule
from kitrobot.primitives.robot import Robot, RobotObject
from kitrobot.sim.setup.settings import device_problems, simulated_devices
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.user_folders import config_folder

NOT_SIMULATED = rule(
    "robot-not-simulated",
    Severity.HINT,
    "The simulator lacks a device of a robot",
    "A board has a driver of that name, so the robot runs there. In the simulator no program for it runs.",
)
NO_DRIVER = rule(
    "robot-no-driver",
    Severity.HINT,
    "No board has the driver of a device",
    "The simulator has the device, so the robot runs there. On a board each actuator and sensor that a program uses"
    " needs the driver that its `<board>` names, or one with the name of its device.",
)


def robot_problems(robot: Robot, folder: Path) -> list[Diagnostic]:
    """What there is to say about the devices of a robot; drivers of one's own are looked for in `folder` too."""
    package = Package((config_folder(), folder))
    parts = [*robot.actuators, *robot.sensors]
    missing = set(package.missing(part.board.driver for part in parts))
    found: list[Diagnostic] = []
    at_hand: list[RobotObject] = []
    for part in parts:
        simulated = part.model in simulated_devices(part.category)
        if simulated and part.board.driver in missing:
            found.append(_no_driver(robot, part))
        elif not simulated and part.model == part.device and part.board.driver not in missing:
            found.append(_not_simulated(robot, part))
            at_hand.append(part)
    # What a board alone can do is no mistake; all else is told as a run tells it.
    on_board = {(part.category, part.name) for part in at_hand}
    return in_reading_order(found + device_problems(robot, on_board))


_SIMULATE = Sentence('run it on a board, or say what stands for it in the simulator, as in <simulate as="slider"/>')


def _not_simulated(robot: Robot, part: RobotObject) -> Diagnostic:
    message = Sentence(
        "`{robot}.{part}`: the simulator has no device {device}, only a board has",
        robot.name,
        part.name,
        shown(part.device),
    )
    near = did_you_mean(part.device, simulated_devices(part.category))
    return NOT_SIMULATED(message, part.place, help=near or _SIMULATE)


def _no_driver(robot: Robot, part: RobotObject) -> Diagnostic:
    message = Sentence(
        "`{robot}.{part}`: no board has a driver {driver}, only the simulator has it",
        robot.name,
        part.name,
        shown(part.board.driver),
    )
    file = f"{part.board.driver}.driver.py"
    help = Sentence('to run it on a board, name a driver in it, as in <board driver="…"/>, or write `{file}`', file)
    return NO_DRIVER(message, part.place, help=help)
