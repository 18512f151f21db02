"""Sensing: passes measurements to the machines' inputs with latency, dropout, noise and forced values.

In that order: a reading is as old as the latency says, it may be lost (then the one before stays), noise is added, and
a forced value replaces the result. A machine whose input changes is woken.
"""

from __future__ import annotations

from kitrobot.sim.tables.columns import (
    A_CELL,
    A_DONE,
    A_QUEUED_LATER,
    A_ROBOT,
    ASLEEP,
    ENDED,
    PERIOD,
    S_CELL,
    S_DRAWS,
    S_DROPOUT,
    S_FILLED,
    S_FLIPS,
    S_FORCE,
    S_FORCED,
    S_HELD,
    S_KEY_A,
    S_KEY_B,
    S_LAST,
    S_LEAST,
    S_MOST,
    S_NEXT,
    S_NOISE,
    S_PLAIN,
    S_RING,
    S_ROBOT,
    S_SIZE,
    S_VALUE,
)
from kitrobot.sim.tables.random_numbers import drawn, gauss, happens
from kitrobot.sim.tables.state import Sensors, State


def reading(k: int, sensors: Sensors) -> int:
    """What the machine gets to see of sensor k now."""
    sensor = sensors.ints
    sensor_floats = sensors.floats
    past = sensors.past
    size = sensor[S_SIZE][k]
    ring = sensor[S_RING][k]
    at = sensor[S_NEXT][k]
    past[ring + at] = sensor[S_VALUE][k]
    at = at + 1 if at + 1 < size else 0
    sensor[S_NEXT][k] = at
    if sensor[S_FILLED][k] < size:
        sensor[S_FILLED][k] += 1
    value = past[ring + at] if sensor[S_FILLED][k] == size else past[ring]
    a = sensor[S_KEY_A][k]
    b = sensor[S_KEY_B][k]
    lost = False
    if sensor_floats[S_DROPOUT][k] > 0.0:
        lost = happens(a, b, sensor[S_DRAWS][k], sensor_floats[S_DROPOUT][k])
        sensor[S_DRAWS][k] += 1
    if lost:
        value = sensor[S_HELD][k]
    elif sensor_floats[S_NOISE][k] > 0.0:
        draws = sensor[S_DRAWS][k]
        if sensor[S_FLIPS][k] == 0:
            spread = gauss(a, b, draws) * sensor_floats[S_NOISE][k]
            value += int(spread + 0.5) if spread >= 0.0 else -int(0.5 - spread)
            sensor[S_DRAWS][k] = draws + 3
        else:
            others = sensor[S_MOST][k] - sensor[S_LEAST][k]
            if others > 0 and happens(a, b, draws, sensor_floats[S_NOISE][k]):
                value = value + 1 + drawn(a, b, draws + 1) % others
                if value > sensor[S_MOST][k]:
                    value -= others + 1
            sensor[S_DRAWS][k] = draws + 2
    sensor[S_HELD][k] = value
    if sensor[S_FORCED][k]:
        value = sensor[S_FORCE][k]
    return value


def sample(step: int, state: State) -> None:
    """Gives every machine whose tick it is the readings of its sensors, each within the sensor's range."""
    sensor = state.sensors.ints
    ints = state.robots.ints
    cells = state.machines.cells
    robots = sensor[S_ROBOT]
    plain = sensor[S_PLAIN]
    values = sensor[S_VALUE]
    lasts = sensor[S_LAST]
    ended = ints[ENDED]
    period = ints[PERIOD]
    for k in range(len(robots)):
        value = values[k]
        if plain[k] and value == lasts[k]:
            continue
        i = robots[k]
        if ended[i] or step % period[i]:
            continue
        if plain[k] == 0:
            value = reading(k, state.sensors)
            if value == lasts[k]:
                continue
        lasts[k] = value
        if value < sensor[S_LEAST][k]:
            value = sensor[S_LEAST][k]
        elif value > sensor[S_MOST][k]:
            value = sensor[S_MOST][k]
        row = cells[i]
        if row[sensor[S_CELL][k]] != value:
            row[sensor[S_CELL][k]] = value
            ints[ASLEEP][i] = 0


def sample_done(step: int, state: State) -> None:
    """Tells every machine whose tick it is which of its actuators have ended what takes them longer."""
    waited_for = state.actuators.waited_for
    actuator = state.actuators.ints
    ints = state.robots.ints
    cells = state.machines.cells
    for n in range(len(waited_for)):
        k = waited_for[n]
        i = actuator[A_ROBOT][k]
        done = 0 if actuator[A_QUEUED_LATER][k] > 0 else actuator[A_DONE][k]
        row = cells[i]
        if row[actuator[A_CELL][k]] != done and ints[ENDED][i] == 0 and step % ints[PERIOD][i] == 0:
            row[actuator[A_CELL][k]] = done
            ints[ASLEEP][i] = 0
