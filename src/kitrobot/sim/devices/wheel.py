"""One driven wheel of two: a robot that has a left and a right one steers by their speeds.

Each wheel goes to its own speed at the robot's acceleration (or braking), and its way is the exact integral of that.
With ways l and r in a step and the wheels a track t apart, the robot rolls (l + r) / 2 and turns (r - l) / t: at
steady speeds its middle drives an arc of radius (r + l) / (r - l) · t / 2. A wheel that is not there does not roll.
"""

from __future__ import annotations

from kitrobot.primitives import RobotObject
from kitrobot.sim.columns import (
    A_NOISE,
    A_P,
    A_Q,
    A_R,
    A_ROBOT,
    A_S,
    ACCELERATION,
    BRAKING,
    FAILED,
    FREE,
    LENGTH,
    RADIUS,
    ROAD,
    SOLID,
    SPEED,
    TARGET,
    TURN,
)
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Setting, Values

WHEEL_DEVICE = 9
_STOP, _FORWARD, _BACKWARD = range(3)


class Wheel(Actuator):
    """`Forward(speed)`, `Backward(speed)` in percent of full speed, `Stop()`: one wheel, the other has its own."""

    name = "wheel"
    kind = WHEEL_DEVICE
    procedures = ("Stop", "Forward", "Backward")
    excludes = ("drive", "turn")
    differs_in = "side"
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("side", "left", "where it is", words=("left", "right")),
        Setting("speed", 400.0, "full speed", "mm/s", 1.0, 100_000.0),
        Setting("acceleration", 800.0, "how fast it gains speed", "mm/s²", 1.0),
        Setting("braking", 800.0, "how fast it loses speed", "mm/s²", 1.0),
        Setting("track", 90.0, "how far the two wheels are apart", "mm", 1.0, 10_000.0),
        Setting("length", 135.0, "the robot's length", "mm", 1.0, 10_000.0),
        Setting("noise", 0.0, "how far a speed may be off (one standard deviation)", "%", 0.0, 50.0),
    )

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        track = values.number("track")
        return values.number("speed"), 0.0, 0.0, -track if values.says("side", "left") else track

    @classmethod
    def fit(cls, robot: int, real: list[list[float]], whole: list[list[int]], values: Values) -> None:
        real[ACCELERATION][robot] = values.number("acceleration")
        real[BRAKING][robot] = values.number("braking")
        real[LENGTH][robot] = max(real[LENGTH][robot], values.number("length"))
        real[RADIUS][robot] = real[LENGTH][robot] / 2
        whole[SOLID][robot] = 1
        whole[ROAD][robot] = FREE


def take_wheel(k: int, procedure: int, percent: int, deviate: float, actuator_real: list[list[float]]) -> None:
    """Begins to do what a command says. P is full speed, Q the speed now, R the one it is told."""
    speed = 0.0
    if procedure != _STOP:
        speed = percent / 100 * actuator_real[A_P][k]
        factor = 1.0 + deviate * actuator_real[A_NOISE][k]
        if factor < 0.0:
            factor = 0.0
        speed *= factor
    actuator_real[A_R][k] = -speed if procedure == _BACKWARD else speed


def move_wheels(
    first: int,
    last: int,
    dt: float,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    real: list[list[float]],
    down: list[int],
) -> None:
    """Goes on for a step with the devices `first` … `last` - 1; those of one robot stand side by side.

    S is the track, negative for a left wheel. The wheels of a robot that failed brake. The robot is told the mean speed
    of the step, which it has at once: its wheels have done the accelerating.
    """
    robots = actuator[A_ROBOT]
    speeds = actuator_real[A_Q]
    targets = actuator_real[A_R]
    tracks = actuator_real[A_S]
    turn = real[TURN]
    before = -1
    for k in range(first, last):
        i = robots[k]
        if i != before:
            before = i
            turn[i] = 0.0
            real[SPEED][i] = 0.0
            real[TARGET][i] = 0.0
        v = speeds[k]
        u = targets[k] if down[i] != FAILED else 0.0
        if v == 0.0 and u == 0.0:
            continue
        way = v * dt
        if v != u:
            rate = real[ACCELERATION][i]
            if v * u < 0.0 or abs(u) < abs(v):
                rate = real[BRAKING][i]
            needed = abs(u - v) / rate
            after = u
            if needed <= dt:
                way = (v + u) / 2.0 * needed + u * (dt - needed)
            else:
                after = v + rate * dt if u > v else v - rate * dt
                way = (v + after) / 2.0 * dt
            speeds[k] = after
        turn[i] += way / tracks[k]
        mean = real[SPEED][i] + way / dt / 2.0
        real[SPEED][i] = mean
        real[TARGET][i] = mean
