"""The radio in a step: who is in reach of whom, and shared variables that travel in messages (`<radio>` of a mission).

A message of a robot holds its copies of all shared variables, each with the stamp of its write. It is sent in the tick
in which the robot wrote one, and in each beat besides, so copies are equal again once robots have heard each other;
of two writes the one with the later stamp wins (clock, then writer). It arrives DELAY steps later at all who are then
in reach of its sender, but for those by whom it gets lost.

In reach are two robots that are no further apart than the range, neither of which has lost its radio, and that are both
cut off from the rest, or neither is. A team's members go on only with those that hear a majority of the team.

The rows of `robots`: on which SIDE it is (1: cut off), whether it hears a majority of the team (QUORUM), and the step
after which it was last told that it did not hear a message. Messages on their way are a ring: the first of its slots in
`due`, how many there are, where its copies begin in `air`, the oldest message, and how many are UNDERWAY. Without a
radio all tables are empty.
"""

from __future__ import annotations

import math

from kitrobot.sim.physics.grids import fill_places
from kitrobot.sim.tables.columns import (
    ASLEEP,
    DOWN,
    ENDED,
    FAILED,
    MUTED,
    PERIOD,
    ROLLING,
    TICK,
    UNHEARD,
    X,
    Y,
    record_event,
)
from kitrobot.sim.tables.random_numbers import happens
from kitrobot.sim.tables.state import State
from kitrobot.sim.tables.team_columns import T_ACTUATOR, T_MISSED
from kitrobot.sim.team.shared_variables import APART_CLOCK, APART_VALUE, APART_WRITER, note

DELAY, BEAT, STALE, ANY_QUORUM = range(4)
"""Steps that a message takes, and from one beat to the next; 1: robots moved since the grid was filled; 1: somebody
hears a majority of the team."""

RANGE, LOSS = range(2)
"""How far a robot is heard (infinite for everywhere), and the part of messages that gets lost (0…1)."""

SIDE, QUORUM, UNHEARD_AFTER, SLOTS_FIRST, SLOTS, AIR_FIRST, OLDEST, UNDERWAY = range(8)
RADIO_ROWS = 8


MOST_TRIES = 256
"""After so many messages a meeting is over, however many get lost."""


def has_radio(state: State) -> bool:
    """Whether the mission has a radio."""
    return len(state.radio.numbers) > 0


def is_on(i: int, state: State) -> bool:
    """Whether robot i can send and hear."""
    ints = state.robots.ints
    return ints[MUTED][i] == 0 and ints[DOWN][i] != FAILED


def is_in_reach(i: int, j: int, state: State) -> bool:
    """Whether robots i and j, whose radios are on, hear each other."""
    side = state.radio.robots[SIDE]
    if side[i] != side[j]:
        return False
    reach = state.radio.floats[RANGE]
    if math.isinf(reach):
        return True
    floats = state.robots.floats
    dx = floats[X][i] - floats[X][j]
    dy = floats[Y][i] - floats[Y][j]
    return dx * dx + dy * dy <= reach * reach


def see_places(state: State) -> None:
    """Puts the robots into the grid, when they have moved since they were."""
    numbers = state.radio.numbers
    if numbers[STALE] and not math.isinf(state.radio.floats[RANGE]):
        numbers[STALE] = 0
        fill_places(state.robots, state.radio.floats[RANGE], state.radio.grid)


def first_column(i: int, state: State) -> int:
    """The first column of cells in which somebody may be in reach of robot i; the last is two further at most."""
    grid = state.radio.grid
    return max(int((state.robots.floats[X][i] - grid.frame[0]) / grid.frame[2]) - 1, 0)


def first_row(i: int, state: State) -> int:
    """The first row of such cells."""
    grid = state.radio.grid
    return max(int((state.robots.floats[Y][i] - grid.frame[1]) / grid.frame[2]) - 1, 0)


def neighbours(i: int, state: State) -> int:
    """How many robots hear robot i."""
    if not is_on(i, state):
        return 0
    see_places(state)
    grid = state.radio.grid
    found = 0
    row_from = first_row(i, state)
    column_from = first_column(i, state)
    for row in range(row_from, min(row_from + 3, grid.shape[1])):
        for column in range(column_from, min(column_from + 3, grid.shape[0])):
            c = row * grid.shape[0] + column
            for n in range(grid.starts[c], grid.starts[c + 1]):
                j = grid.items[n]
                if j != i and is_on(j, state) and is_in_reach(i, j, state):
                    found += 1
    return found


def exchange_by_radio(step: int, state: State) -> None:
    """Sends what was written in this step, or is due for a beat, and delivers what arrives."""
    ints = state.robots.ints
    radio = state.radio
    beat = radio.numbers[BEAT]
    mine_first = state.shared.mine_first
    count = len(ints[PERIOD])
    if state.clock[ROLLING] > 0:
        radio.numbers[STALE] = 1
    for i in range(count):
        if mine_first[i] == mine_first[i + 1]:
            continue
        # Who sleeps has written nothing.
        wrote = ints[ASLEEP][i] == 0 and step % ints[PERIOD][i] == 0 and note(i, True, state)
        if (wrote or (step + i) % beat == 0) and is_on(i, state):
            send(i, step, state)
    for i in range(count):
        while radio.robots[UNDERWAY][i] > 0:
            slot = radio.robots[OLDEST][i]
            if radio.due[radio.robots[SLOTS_FIRST][i] + slot] > step:
                break
            broadcast(i, radio.robots[AIR_FIRST][i] + slot * (mine_first[i + 1] - mine_first[i]), step, state)
            radio.robots[OLDEST][i] = (slot + 1) % radio.robots[SLOTS][i]
            radio.robots[UNDERWAY][i] -= 1


def send(i: int, step: int, state: State) -> None:
    """Robot i sends its copies."""
    radio = state.radio
    shared = state.shared
    first = shared.mine_first[i]
    count = shared.mine_first[i + 1] - first
    slot = (radio.robots[OLDEST][i] + radio.robots[UNDERWAY][i]) % radio.robots[SLOTS][i]
    radio.due[radio.robots[SLOTS_FIRST][i] + slot] = step + radio.numbers[DELAY]
    at = radio.robots[AIR_FIRST][i] + slot * count
    for row in range(len(shared.apart)):
        for k in range(count):
            radio.air[row][at + k] = shared.apart[row][first + k]
    radio.robots[UNDERWAY][i] += 1


def broadcast(i: int, at: int, step: int, state: State) -> None:
    """Delivers a message of robot i, whose copies begin at `at`, to all who are in reach."""
    see_places(state)
    radio = state.radio
    grid = radio.grid
    shared = state.shared
    loss = radio.floats[LOSS]
    count = len(radio.robots[SIDE])
    row_from = first_row(i, state)
    column_from = first_column(i, state)
    for row in range(row_from, min(row_from + 3, grid.shape[1])):
        for column in range(column_from, min(column_from + 3, grid.shape[0])):
            c = row * grid.shape[0] + column
            for n in range(grid.starts[c], grid.starts[c + 1]):
                j = grid.items[n]
                if j == i or shared.mine_first[j] == shared.mine_first[j + 1]:
                    continue
                if is_on(j, state) and is_in_reach(i, j, state):
                    lost = loss > 0.0 and happens(radio.keys[0][j], radio.keys[1][j], step * count + i, loss)
                    hear(i, at, j, lost, state)


def hear(i: int, at: int, j: int, lost: bool, state: State) -> None:
    """Robot j hears a message of robot i, whose copies begin at `at`; a lost one that had news for it is told."""
    shared = state.shared
    known = shared.apart
    air = state.radio.air
    cells = state.machines.cells[j]
    first = shared.mine_first[i]
    for k in range(shared.mine_first[j], shared.mine_first[j + 1]):
        for own in range(first, shared.mine_first[i + 1]):
            m = at + own - first
            if shared.mine[own] != shared.mine[k] or not (
                air[APART_CLOCK][m] > known[APART_CLOCK][k]
                or (air[APART_CLOCK][m] == known[APART_CLOCK][k] and air[APART_WRITER][m] > known[APART_WRITER][k])
            ):
                continue
            if lost:
                report_lost_message(j, i, state)
                return
            known[APART_VALUE][k] = air[APART_VALUE][m]
            known[APART_CLOCK][k] = air[APART_CLOCK][m]
            known[APART_WRITER][k] = air[APART_WRITER][m]
            if cells[shared.mine_cell[k]] != air[APART_VALUE][m]:
                cells[shared.mine_cell[k]] = air[APART_VALUE][m]
                state.robots.ints[ASLEEP][j] = 0


def report_lost_message(j: int, i: int, state: State) -> None:
    """Tells that robot j did not hear a message of robot i, once in a step at most."""
    after = state.clock[TICK] + 1
    if state.radio.robots[UNHEARD_AFTER][j] != after:
        state.radio.robots[UNHEARD_AFTER][j] = after
        record_event(state.events, state.clock, UNHEARD, j, i, 0)


def latency(p: int, state: State) -> int:
    """Steps that it takes until all know what is agreed at point p: from a robot to the first, who asks all, hears a
    majority and tells all, that is four messages; one that gets lost is said again with the next beat.
    """
    radio = state.radio
    loss = radio.floats[LOSS]
    taken = 4 * radio.numbers[DELAY]
    if loss > 0.0:
        tries = 0
        heard = 0
        while heard < 4 and tries < MOST_TRIES:
            number = (state.clock[TICK] * len(state.team.points[0]) + p) * MOST_TRIES + tries
            if happens(radio.keys[0][0], radio.keys[1][0], number, loss):
                taken += radio.numbers[BEAT]
            else:
                heard += 1
            tries += 1
    return taken


def is_of_view(i: int, state: State) -> bool:
    """Whether robot i is of the team, has not ended its program and is not missed."""
    robots = state.team.robots
    return robots[T_ACTUATOR][i] >= 0 and robots[T_MISSED][i] == 0 and state.robots.ints[ENDED][i] == 0


def find_quorum(state: State) -> None:
    """Finds out which robots of the team hear a majority of those not missed, or half of them with the first one."""
    robots = state.team.robots
    quorum = state.radio.robots[QUORUM]
    count = len(quorum)
    members = 0
    first = -1
    for j in range(count):
        if is_of_view(j, state):
            members += 1
            if first < 0:
                first = j
    state.radio.numbers[ANY_QUORUM] = 0
    for i in range(count):
        heard = 0
        hears_first = i == first
        if robots[T_ACTUATOR][i] >= 0 and is_on(i, state):
            for j in range(count):
                if is_of_view(j, state) and (i == j or (is_on(j, state) and is_in_reach(i, j, state))):
                    heard += 1
                    if j == first:
                        hears_first = True
        quorum[i] = 1 if 2 * heard > members or (2 * heard == members and hears_first) else 0
        if quorum[i]:
            state.radio.numbers[ANY_QUORUM] = 1
