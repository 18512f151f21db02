"""A buzzer that plays a tone or a melody, one at a time; the simulator knows what sounds and how long."""

from __future__ import annotations

import math

from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, DisplayKind, Values
from kitrobot.sim.tables.columns import A_DONE, A_OWN, A_ROBOT, DOWN, FAILED
from kitrobot.sim.tables.state import State

REMAINING_S = A_OWN[1]
"""Column of a buzzer: how many seconds it still sounds."""

_STOP, _TONE, _PLAY = range(3)

MELODIES_MS = (1125, 1125, 625, 625, 500, 2625, 4000, 3375, 16_000, 12_000, 2750, 2625)
"""How long the melodies of the board take, each by its number: power up, power down, jump up, jump down, ba ding,
wawawawaa, dadadadum, entertainer, ode, birthday, ringtone, punchline."""


class Music(Actuator):
    """`Tone(frequency, duration)` in Hz and ms (without a duration until `Stop()`), `Play(melody)`, `Stop()`."""

    name = "music"
    procedures = ("Stop", "Tone", "Play")
    shown = 2
    outputs = 2
    settings = (LATENCY, LOST_COMMANDS)

    @classmethod
    def display_kind(cls, values: Values) -> DisplayKind:
        return "melody"


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Begins to do what a command says. The outputs are the frequency, 0 when it is
    silent or plays a melody, and the number of the melody and one, or 0.
    """
    output = state.actuators.outputs[k]
    output[0] = 0
    output[1] = 0
    left = 0.0
    if command.procedure == _TONE:
        output[0] = max(command.first, 0)
        left = command.last / 1000.0 if command.arguments > 1 else math.inf
    elif command.procedure == _PLAY:
        melody = min(max(command.first, 0), len(MELODIES_MS) - 1)
        output[1] = melody + 1
        left = MELODIES_MS[melody] / 1000.0
    state.actuators.floats[REMAINING_S][k] = left
    state.actuators.ints[A_DONE][k] = 0 if 0.0 < left < math.inf else 1
    if left <= 0.0:
        output[0] = 0


def advance(first: int, last: int, dt: float, state: State) -> None:
    """Goes on for a step with the devices `first` … `last` - 1; a robot that failed is silent."""
    actuator = state.actuators.ints
    outputs = state.actuators.outputs
    down = state.robots.ints[DOWN]
    done = actuator[A_DONE]
    lefts = state.actuators.floats[REMAINING_S]
    for k in range(first, last):
        failed = down[actuator[A_ROBOT][k]] == FAILED
        if failed:
            outputs[k][0] = 0
            outputs[k][1] = 0
        if done[k] or failed:
            continue
        lefts[k] -= dt
        if lefts[k] <= 1e-9:
            lefts[k] = 0.0
            outputs[k][0] = 0
            outputs[k][1] = 0
            done[k] = 1
