"""Sees the colour of the floor."""

from __future__ import annotations

from kitrobot.primitives import RobotObject
from kitrobot.sim.columns import DIRECTED, ENDED, S_P, S_Q, S_ROBOT, S_VALUE, UX, UY, X, Y
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Sensor, Setting, Values
from kitrobot.sim.sight import colour_at, floor_at

COLOUR = 4


class Colour(Sensor):
    """The number of the colour under it (1 red, 2 green, 3 blue), or 0; lines lie on floors, the last on top."""

    name = "colour"
    kind = COLOUR
    settings = (
        LATENCY,
        LOST_READINGS,
        WRONG,
        Setting("ahead", 0.0, "how far in front of the robot's middle it looks", "mm", -10_000.0, 10_000.0),
        Setting("side", 0.0, "how far to the left of the robot's middle it looks", "mm", -10_000.0, 10_000.0),
    )

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return values.number("ahead"), values.number("side")

    @classmethod
    def fit(cls, robot: int, real: list[list[float]], whole: list[list[int]], values: Values) -> None:
        whole[DIRECTED][robot] = 1


def sense_colours(
    first: int,
    last: int,
    sensor: list[list[int]],
    sensor_real: list[list[float]],
    real: list[list[float]],
    whole: list[list[int]],
    stretches: list[list[float]],
    colours: list[int],
    frame: list[float],
    shape: list[int],
    starts: list[int],
    items: list[int],
    floors: list[list[int]],
    floor_box: list[list[float]],
    floor_points: list[list[float]],
) -> None:
    """Measures with the devices `first` … `last` - 1; on a bare floor everything stays 0."""
    if len(items) == 0 and len(floors[0]) == 0:
        return
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    aheads = sensor_real[S_P]
    sides = sensor_real[S_Q]
    ended = whole[ENDED]
    for k in range(first, last):
        i = robots[k]
        if ended[i] == 0:
            ux = real[UX][i]
            uy = real[UY][i]
            x = real[X][i] + aheads[k] * ux - sides[k] * uy
            y = real[Y][i] + aheads[k] * uy + sides[k] * ux
            colour = 0
            if len(items) > 0:
                colour = colour_at(x, y, stretches, colours, frame, shape, starts, items)
            if colour == 0:
                colour = floor_at(x, y, floors, floor_box, floor_points)
            values[k] = colour
