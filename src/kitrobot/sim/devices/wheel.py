"""One driven wheel of two: a robot that has a left and a right one steers by their speeds.

Each wheel goes to its own speed at the robot's acceleration (or braking), and its way is the exact integral of that.
With ways l and r in a step and the wheels a track t apart, the robot rolls (l + r) / 2 and turns (r - l) / t: at
steady speeds its middle drives an arc of radius (r + l) / (r - l) · t / 2. A wheel that is not there does not roll.
"""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete, DisplayKind, Setting, Values
from kitrobot.sim.tables.columns import (
    A_NOISE,
    A_OWN,
    A_ROBOT,
    ACCELERATION,
    BRAKING,
    DOWN,
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
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

FULL_SPEED, WHEEL_SPEED, WHEEL_TARGET, TRACK = A_OWN
"""Columns of a wheel, in mm/s and mm: full speed, the speed now, the commanded speed, and the track between the wheels,
negative for a left wheel."""

_STOP, _FORWARD, _BACKWARD = range(3)


class Wheel(Actuator):
    """`Forward(speed)`, `Backward(speed)` in percent of full speed, `Stop()`: one wheel, the other has its own."""

    name = "wheel"
    discrete = Discrete.MOTION
    procedures = ("Stop", "Forward", "Backward")
    drives = True
    excludes = ("drive", "turn")
    differs_in = "side"
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("side", "left", Sentence("where it is"), words=("left", "right")),
        Setting("speed", 400.0, Sentence("full speed"), "mm/s", 1.0, 100_000.0),
        Setting("acceleration", 800.0, Sentence("how fast it gains speed"), "mm/s²", 1.0),
        Setting("braking", 800.0, Sentence("how fast it loses speed"), "mm/s²", 1.0),
        Setting("track", 90.0, Sentence("how far the two wheels are apart"), "mm", 1.0, 10_000.0),
        Setting("length", 135.0, Sentence("the robot's length"), "mm", 1.0, 10_000.0),
        Setting("noise", 0.0, Sentence("how far a speed may be off (one standard deviation)"), "%", 0.0, 50.0),
    )

    @classmethod
    def commanded_motion(cls, k: int, state: State) -> tuple[float, float]:
        speed, track = (state.actuators.floats[column][k] for column in (WHEEL_TARGET, TRACK))
        return speed / 2.0, speed / track

    @classmethod
    def display_kind(cls, values: Values) -> DisplayKind:
        return "wheels"

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        track = values.number("track")
        return values.number("speed"), 0.0, 0.0, -track if values.says("side", "left") else track

    @classmethod
    def fit(cls, robot: int, floats: list[list[float]], ints: list[list[int]], values: Values) -> None:
        floats[ACCELERATION][robot] = values.number("acceleration")
        floats[BRAKING][robot] = values.number("braking")
        floats[LENGTH][robot] = max(floats[LENGTH][robot], values.number("length"))
        floats[RADIUS][robot] = floats[LENGTH][robot] / 2
        ints[SOLID][robot] = 1
        ints[ROAD][robot] = FREE


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Begins to do what a command says."""
    procedure = command.procedure
    actuator_floats = state.actuators.floats
    speed = 0.0
    if procedure != _STOP:
        factor = max(1.0 + deviate * actuator_floats[A_NOISE][k], 0.0)
        speed = command.first / 100 * actuator_floats[FULL_SPEED][k] * factor
    actuator_floats[WHEEL_TARGET][k] = -speed if procedure == _BACKWARD else speed


def advance(first: int, last: int, dt: float, state: State) -> None:
    """Goes on for a step with the devices `first` … `last` - 1; those of one robot stand side by side.

    The wheels of a robot that failed brake. The robot is told the mean speed
    of the step, which it has at once: its wheels have done the accelerating.
    """
    actuator = state.actuators.ints
    actuator_floats = state.actuators.floats
    floats = state.robots.floats
    down = state.robots.ints[DOWN]
    robots = actuator[A_ROBOT]
    speeds = actuator_floats[WHEEL_SPEED]
    targets = actuator_floats[WHEEL_TARGET]
    tracks = actuator_floats[TRACK]
    turn = floats[TURN]
    before = -1
    for k in range(first, last):
        i = robots[k]
        if i != before:
            before = i
            turn[i] = 0.0
            floats[SPEED][i] = 0.0
            floats[TARGET][i] = 0.0
        v = speeds[k]
        u = targets[k] if down[i] != FAILED else 0.0
        if v == 0.0 and u == 0.0:
            continue
        way = v * dt
        if v != u:
            rate = floats[ACCELERATION][i]
            if v * u < 0.0 or abs(u) < abs(v):
                rate = floats[BRAKING][i]
            needed = abs(u - v) / rate
            after = u
            if needed <= dt:
                way = (v + u) / 2.0 * needed + u * (dt - needed)
            else:
                after = v + rate * dt if u > v else v - rate * dt
                way = (v + after) / 2.0 * dt
            speeds[k] = after
        turn[i] += way / tracks[k]
        mean = floats[SPEED][i] + way / dt / 2.0
        floats[SPEED][i] = mean
        floats[TARGET][i] = mean


def is_busy(k: int, state: State) -> bool:
    """Whether it rolls, or is to."""
    return state.actuators.floats[WHEEL_SPEED][k] != 0.0 or state.actuators.floats[WHEEL_TARGET][k] != 0.0
