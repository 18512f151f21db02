"""Random robots, as XML that the reader must accept: odd ranges, odd ticks, later procedures, several stops."""

from __future__ import annotations

import random
from functools import cache

from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import LARGEST_VALUE, Robot
from kitrobot.primitives.robot_xml import read_robot

RANGES = [
    (0, 1),
    (0, 3),
    (0, 100),
    (0, 255),
    (0, 65535),
    (5, 10),
    (7, 7),
    (-10, 10),
    (-100, -50),
    (-LARGEST_VALUE, LARGEST_VALUE),
    (0, LARGEST_VALUE),
]


@cache
def shipped_robots() -> dict[str, Robot]:
    """The robots that come with the package."""
    return dict(load_catalogue().robots)


def random_robot(rng: random.Random) -> Robot:
    """A robot read from random XML."""
    robot, problems = read_robot(random_robot_xml(rng).encode(), "random.robot.xml")
    assert robot is not None, [problem.message for problem in problems]
    return robot


def random_robot_xml(rng: random.Random) -> str:
    """The XML of a robot with one to four actuators, up to three sensors and up to four variables."""
    tick, unit = rng.choice(((20, 100), (20, 20), (20, 10), (30, 100), (50, 20), (100, 100)))
    lines = [f'<robot name="odd" version="1" tick="{tick}" wait-unit="{unit}">']
    for number in range(rng.randint(1, 4)):
        lines += actuator(rng, f"Act{number}")
    for number in range(rng.randint(0, 3)):
        lines += sensor(rng, f"Sense{number}")
    for number in range(rng.randint(0, 4)):
        lines.append(variable(rng, f"Var{number}"))
    return "\n".join([*lines, "</robot>", ""])


def actuator(rng: random.Random, name: str) -> list[str]:
    stops = ["Halt"] if rng.random() < 0.7 else ["Halt", "Rest"] if rng.random() < 0.7 else []
    lines = [f'  <actuator name="{name}" device="drive">']
    for number in range(rng.randint(1, 3)):
        later = ' completes="later"' if rng.random() < 0.3 else ""
        stop = f' stop="{rng.choice(stops)}"' if stops and rng.random() < 0.8 else ""
        parameters = "".join(parameter(rng, f"p{index}") for index in range(rng.choice((0, 1, 1, 2, 3))))
        lines.append(f'    <procedure name="Do{number}"{later}{stop}>{parameters}</procedure>')
    lines += [f'    <procedure name="{stop}"/>' for stop in stops]
    return [*lines, "  </actuator>"]


def parameter(rng: random.Random, name: str) -> str:
    if rng.random() < 0.15:
        return f'<parameter name="{name}" type="boolean"/>'
    minimum, maximum = rng.choice(RANGES)
    return f'<parameter name="{name}" min="{minimum}" max="{maximum}" default="{maximum}"/>'


def sensor(rng: random.Random, name: str) -> list[str]:
    minimum, maximum = rng.choice(RANGES)
    lines = [f'  <sensor name="{name}" device="range" min="{minimum}" max="{maximum}">']
    for test in ("equal", "less", "greater"):
        if rng.random() < 0.6:
            numbers = f'<parameter name="value" min="{minimum}" max="{maximum}"/>'
            lines.append(f'    <operation name="Is{test}" test="{test}">{numbers}</operation>')
    lines.append(f'    <operation name="IsIt" test="equal" to="{rng.choice((minimum, maximum))}"/>')
    if rng.random() < 0.8:
        lines.append('    <operation name="Value" value="yes"/>')
    return [*lines, "  </sensor>"]


def variable(rng: random.Random, name: str) -> str:
    if rng.random() < 0.3:
        return f'  <variable name="{name}" type="boolean" initial="{rng.choice(("true", "false"))}"/>'
    minimum, maximum = rng.choice(RANGES)
    initial = rng.randint(minimum, maximum)
    return f'  <variable name="{name}" type="integer" min="{minimum}" max="{maximum}" initial="{initial}"/>'
