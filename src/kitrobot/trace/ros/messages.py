"""Messages that several parts write: where robots are, how they move, how they are. Lengths are in m, angles in rad."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Final

from kitrobot.trace.ros.cdr import CdrLayout

FRAME: Final = "map"

OK, WARN, ERROR = 0, 1, 2
"""Levels of a `diagnostic_msgs/msg/DiagnosticStatus`."""

_COVARIANCE: Final = 36


def split_time(nanoseconds: int) -> tuple[int, int]:
    """A time as ROS has it: seconds, and the nanoseconds beyond them."""
    return divmod(nanoseconds, 1_000_000_000)


def turn_of(heading: float) -> tuple[float, float]:
    """The z and w of the quaternion that turns by `heading` about the vertical; its x and y are 0."""
    return math.sin(heading / 2), math.cos(heading / 2)


def transforms(robots: Sequence[str]) -> CdrLayout:
    """Where the robots are as a `tf2_msgs/msg/TFMessage`; of each the time, x, y, z and a quaternion."""
    layout = CdrLayout().length(len(robots))
    for robot in robots:
        layout.numbers("iI").text(FRAME).text(robot).numbers("d" * 7)
    return layout


def odometry(robot: str) -> CdrLayout:
    """A `nav_msgs/msg/Odometry`: the time, x, y, z, a quaternion, and six numbers of a twist; covariances are 0."""
    layout = CdrLayout().numbers("iI").text(FRAME).text(robot).numbers("d" * 7).zeros("d" * _COVARIANCE)
    return layout.numbers("d" * 6).zeros("d" * _COVARIANCE)


def twist() -> CdrLayout:
    """A `geometry_msgs/msg/Twist`: linear x, y, z in m/s, angular x, y, z in rad/s."""
    return CdrLayout().numbers("d" * 6)


def clock() -> CdrLayout:
    """A `rosgraph_msgs/msg/Clock`."""
    return CdrLayout().numbers("iI")


def encode_diagnostics(stamp: tuple[int, int], states: Iterable[tuple[int, str, str, str]]) -> bytes:
    """A `diagnostic_msgs/msg/DiagnosticArray`; of each robot a level, a name, a word about it, and its own name."""
    listed = list(states)
    layout = CdrLayout().numbers("iI").text("").length(len(listed))
    for _, *texts in listed:
        layout.numbers("B")
        for text in texts:
            layout.text(text)
        layout.length(0)
    return layout.encode((*stamp, *(level for level, *_ in listed)))
