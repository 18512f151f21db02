"""A buzzer that plays a tone or a melody, one at a time; the simulator knows what sounds and how long."""

from __future__ import annotations

import math

from kitrobot.sim.columns import A_DONE, A_Q, A_ROBOT, FAILED
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator

MUSIC = 5
_STOP, _TONE, _PLAY = range(3)

MELODIES_MS = (1125, 1125, 625, 625, 500, 2625, 4000, 3375, 16_000, 12_000, 2750, 2625)
"""How long the melodies of the board take, each by its number: power up, power down, jump up, jump down, ba ding,
wawawawaa, dadadadum, entertainer, ode, birthday, ringtone, punchline."""


class Music(Actuator):
    """`Tone(frequency, duration)` in Hz and ms (without a duration until `Stop()`), `Play(melody)`, `Stop()`."""

    name = "music"
    kind = MUSIC
    procedures = ("Stop", "Tone", "Play")
    shown = 2
    face = 2
    settings = (LATENCY, LOST_COMMANDS)


def take_music(
    k: int,
    procedure: int,
    count: int,
    first: int,
    last: int,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    face: list[int],
) -> None:
    """Begins to do what a command says. Q is how long it still sounds; the face is the frequency, 0 when it is silent
    or plays a melody, and the number of the melody and one, or 0.
    """
    face[0] = 0
    face[1] = 0
    left = 0.0
    if procedure == _TONE:
        face[0] = max(first, 0)
        left = last / 1000.0 if count > 1 else math.inf
    elif procedure == _PLAY:
        melody = min(max(first, 0), len(MELODIES_MS) - 1)
        face[1] = melody + 1
        left = MELODIES_MS[melody] / 1000.0
    actuator_real[A_Q][k] = left
    actuator[A_DONE][k] = 0 if 0.0 < left < math.inf else 1
    if left <= 0.0:
        face[0] = 0


def move_music(
    first: int,
    last: int,
    dt: float,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    faces: list[list[int]],
    down: list[int],
) -> None:
    """Goes on for a step with the devices `first` … `last` - 1; a robot that failed is silent."""
    done = actuator[A_DONE]
    lefts = actuator_real[A_Q]
    for k in range(first, last):
        failed = down[actuator[A_ROBOT][k]] == FAILED
        if failed:
            faces[k][0] = 0
            faces[k][1] = 0
        if done[k] or failed:
            continue
        lefts[k] -= dt
        if lefts[k] <= 1e-9:
            lefts[k] = 0.0
            faces[k][0] = 0
            faces[k][1] = 0
            done[k] = 1
