"""Sees the colour of the floor."""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Sensor, Setting, Values
from kitrobot.sim.physics.sight import colour_at, floor_at
from kitrobot.sim.tables.columns import DIRECTED, ENDED, S_OWN, S_ROBOT, S_VALUE, UX, UY, X, Y
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

AHEAD, LEFT = S_OWN[:2]
"""Columns of a colour sensor: how far it is ahead of the middle of its robot, and to the left, in mm."""


class Colour(Sensor):
    """The number of the colour under it (1 red, 2 green, 3 blue), or 0; lines lie on floors, the last on top."""

    name = "colour"
    settings = (
        LATENCY,
        LOST_READINGS,
        WRONG,
        Setting("ahead", 0.0, Sentence("how far in front of the robot's middle it looks"), "mm", -10_000.0, 10_000.0),
        Setting("side", 0.0, Sentence("how far to the left of the robot's middle it looks"), "mm", -10_000.0, 10_000.0),
    )

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return values.number("ahead"), values.number("side")

    @classmethod
    def fit(cls, robot: int, floats: list[list[float]], ints: list[list[int]], values: Values) -> None:
        ints[DIRECTED][robot] = 1


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1; on a bare floor everything stays 0."""
    lines = state.lines
    floors = state.floors
    if len(lines.colours) == 0 and len(floors.ints[0]) == 0:
        return
    sensor = state.sensors.ints
    sensor_floats = state.sensors.floats
    floats = state.robots.floats
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    aheads = sensor_floats[AHEAD]
    sides = sensor_floats[LEFT]
    ended = state.robots.ints[ENDED]
    for k in range(first, last):
        i = robots[k]
        if ended[i] == 0:
            ux = floats[UX][i]
            uy = floats[UY][i]
            x = floats[X][i] + aheads[k] * ux - sides[k] * uy
            y = floats[Y][i] + aheads[k] * uy + sides[k] * ux
            colour = 0
            if len(lines.colours) > 0:
                colour = colour_at(x, y, lines)
            if colour == 0:
                colour = floor_at(x, y, floors)
            values[k] = colour
