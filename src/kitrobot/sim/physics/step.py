"""One step of all robots and pushables: wheels roll, robots move along their roads or freely and push boxes and balls,
what touches is parted and counted. Who is very fast goes its way in pieces, so that nothing is jumped over.

One contact is one collision however long it lasts: the pairs that touch now are kept until the next step. A step in
which nothing rolls or turns costs next to nothing.
"""

from __future__ import annotations

import math

from kitrobot.sim.physics.contacts import (
    measure_gaps,
    news_first,
    separate_discs,
    separate_on_roads,
    sort_along,
)
from kitrobot.sim.physics.grids import fill
from kitrobot.sim.physics.motion import move_along_roads, move_freely, place, roll
from kitrobot.sim.physics.pushable import separate_pushables, slide_pushables, update_pushable_speeds
from kitrobot.sim.physics.pushable_grid import PUSH_HALF_HEIGHT, PUSH_HALF_WIDTH, PUSH_X, PUSH_Y
from kitrobot.sim.physics.wall_contacts import separate_from_walls
from kitrobot.sim.tables.columns import (
    COLLISION,
    COLLISIONS,
    CONTACTS,
    DT,
    HEIGHT,
    LEAVING,
    LEFT,
    LENGTH,
    MOVED,
    NUDGED,
    PIECES,
    PUSHABLES,
    RADIUS,
    ROAD,
    ROLLING,
    SMALLEST,
    TOGETHER,
    TOUCHING,
    TURN,
    WAY,
    WIDEST,
    WIDTH,
    X,
    Y,
    record_event,
)
from kitrobot.sim.tables.state import Roads, Robots, State

LEAST_ROOM_MM = 0.1
"""Robots go this far at once, however small what they may meet is."""


def arrange(robots: Robots, roads: Roads) -> None:
    """Puts the robots on roads into their order and onto their places, as before the first step."""
    sort_along(robots)
    measure_gaps(robots, roads)
    place(robots, roads)


def move(state: State) -> None:
    """Moves everything by one step: robots, and the objects that they push."""
    robots = state.robots
    clock = state.clock
    has_pushables = len(state.pushables.floats[0]) > 0
    rolling = roll(state.fixed_floats[DT], robots)
    free = robots.free
    turn = robots.floats[TURN]
    for k in range(len(free)):
        if turn[free[k]] != 0.0:
            rolling += 1
    clock[ROLLING] = rolling
    if rolling == 0:
        if has_pushables and clock[PUSHABLES] > 0:
            slide_pushables(state)
            update_pushable_speeds(separate_pushables(0, state), state)
        return
    clock[MOVED] = 1
    count = 0
    pushed = 0
    parts = divide(state)
    for piece in range(parts):
        count = move_robots(piece, count, state)
        if has_pushables:
            if piece == 0:
                slide_pushables(state)
            pushed += separate_pushables(piece, state)
    if parts > 1:
        forget_pieces(robots)
    if count > 0 or clock[CONTACTS] > 0:
        report_contacts(count, state)
    if len(robots.free_solid) > 0:
        report_departures(state)
    if has_pushables:
        update_pushable_speeds(pushed, state)


def move_robots(piece: int, count: int, state: State) -> int:
    """Moves the robots that go so many pieces by one, and parts what touches them; gives how many pairs touch."""
    robots = state.robots
    roads = state.roads
    pairs = state.contacts.pairs
    if len(robots.guided) > 0:
        move_along_roads(piece, robots, roads)
        before = count
        if len(robots.guided) > 1:
            sort_along(robots)
            measure_gaps(robots, roads)
            count = separate_on_roads(piece, robots, roads, pairs, count)
        if count > before or piece > 0:
            arrange(robots, roads)
        else:
            place(robots, roads)
    if len(robots.free) > 0:
        move_freely(piece, robots)
        count = separate_from_walls(piece, robots, state.walls, pairs, count)
    if state.fixed[TOGETHER]:
        fill(robots, state.fixed_floats[WIDEST], state.grid)
        count = separate_discs(piece, state, count)
    return count


def divide(state: State) -> int:
    """In how many pieces robots go their ways in this step, at most; PIECES is in how many each one does.

    None goes further at once than half its own radius, half that of a robot or that of an object that is near enough to
    be met in the step. So no middle comes onto a wall, and two robots do not exchange places. What is far away has no
    say, and who goes one piece goes it first: so others change nothing for those whom they do not meet.
    """
    who = state.robots.solid
    way = state.robots.floats[WAY]
    count = state.robots.ints[PIECES]
    smallest = state.fixed_floats[SMALLEST]
    most = 1
    for k in range(len(who)):
        i = who[k]
        if way[i] > smallest or way[i] < -smallest:
            count[i] = math.ceil(abs(way[i]) / find_room(i, state))
            most = max(most, count[i])
    return most


def forget_pieces(robots: Robots) -> None:
    """In the next step everybody goes in one piece, unless it is fast."""
    who = robots.solid
    for k in range(len(who)):
        robots.ints[PIECES][who[k]] = 1
        robots.ints[NUDGED][who[k]] = 0


def find_room(i: int, state: State) -> float:
    """How far robot i may go at once, by its own size and by that of all that it may meet in this step."""
    robots = state.robots
    who = robots.solid
    floats = robots.floats
    x = floats[X]
    y = floats[Y]
    way = floats[WAY]
    radius = floats[RADIUS]
    length = floats[LENGTH]
    road = robots.ints[ROAD]
    room = radius[i] / 2.0
    if road[i] >= 0:
        room = min(room, length[i] / 2.0)
    for k in range(len(who)):
        j = who[k]
        reach = abs(way[i]) + abs(way[j]) + radius[i] + radius[j]
        if radius[j] / 2.0 < room and abs(x[j] - x[i]) <= reach and abs(y[j] - y[i]) <= reach:
            room = radius[j] / 2.0
    pushables = state.pushables
    for k in range(len(pushables.floats[0])):
        half_width = pushables.floats[PUSH_HALF_WIDTH][k]
        half_height = pushables.floats[PUSH_HALF_HEIGHT][k]
        size = min(half_width, half_height)
        reach = abs(way[i]) + radius[i] + 2.0 * max(half_width, half_height)
        if (
            size < room
            and abs(pushables.floats[PUSH_X][k] - x[i]) <= reach
            and abs(pushables.floats[PUSH_Y][k] - y[i]) <= reach
        ):
            room = size
    return max(room, LEAST_ROOM_MM)


def report_contacts(count: int, state: State) -> None:
    """Says which pairs have begun to touch, and remembers all that do."""
    clock = state.clock
    events = state.events
    pairs = state.contacts.pairs
    before = state.contacts.before
    touching = state.robots.ints[TOUCHING]
    news = news_first(state.contacts, count, clock[CONTACTS])
    clock[COLLISIONS] += news
    for k in range(news):
        record_event(events, clock, COLLISION, pairs[2 * k], pairs[2 * k + 1], 0)
    for k in range(2 * clock[CONTACTS]):
        if before[k] >= 0:
            touching[before[k]] = 0
    for k in range(2 * count):
        before[k] = pairs[k]
        if pairs[k] >= 0:
            touching[pairs[k]] = 1
    clock[CONTACTS] = count


def report_departures(state: State) -> None:
    """Says of each robot, once, that its middle is beyond the edge of the world, which is no wall."""
    who = state.robots.free_solid
    floats = state.robots.floats
    x = floats[X]
    y = floats[Y]
    left = state.robots.ints[LEFT]
    width = state.fixed_floats[WIDTH]
    height = state.fixed_floats[HEIGHT]
    for k in range(len(who)):
        i = who[k]
        if left[i] == 0 and (x[i] < 0.0 or y[i] < 0.0 or x[i] > width or y[i] > height):
            left[i] = 1
            record_event(state.events, state.clock, LEAVING, i, 0, 0)
