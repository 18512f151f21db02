"""One step of all robots: wheels roll, robots move along their roads or freely, what touches is parted and counted.

One contact is one collision however long it lasts: the pairs that touch now are kept until the next step. A step in
which nothing rolls or turns costs next to nothing.
"""

from __future__ import annotations

from kitrobot.sim.columns import (
    COLLISION,
    COLLISIONS,
    CONTACTS,
    DT,
    HEIGHT,
    LEAVING,
    LEFT,
    MOVED,
    ROLLING,
    TOGETHER,
    TOUCHING,
    TURN,
    WIDEST,
    WIDTH,
    X,
    Y,
    tell,
)
from kitrobot.sim.contacts import measure_gaps, news_first, part_discs, part_from_walls, part_on_roads, sort_along
from kitrobot.sim.grids import fill
from kitrobot.sim.motion import follow, pieces, place, roll, wander
from kitrobot.sim.state import Roads, Robots, State


def arrange(robots: Robots, roads: Roads) -> None:
    """Puts the robots on roads into their order and onto their places, as before the first step."""
    sort_along(robots)
    measure_gaps(robots, roads)
    place(robots, roads)


def move_robots(state: State) -> None:
    """Moves everything by one step."""
    robots = state.robots
    roads = state.roads
    pairs = state.contacts.pairs
    clock = state.clock
    rolling = roll(state.fixed_floats[DT], robots)
    free = robots.free
    turn = robots.floats[TURN]
    for k in range(len(free)):
        if turn[free[k]] != 0.0:
            rolling += 1
    clock[ROLLING] = rolling
    if rolling == 0:
        return
    clock[MOVED] = 1
    count = 0
    if len(robots.guided) > 0:
        follow(robots, roads)
        if len(robots.guided) > 1:
            sort_along(robots)
            measure_gaps(robots, roads)
            count = part_on_roads(robots, roads, pairs)
        if count > 0:
            arrange(robots, roads)
        else:
            place(robots, roads)
    if len(free) > 0:
        # A wall is thin: who is very fast looks for it on the way too. The last piece tells who touches one.
        on_roads = count
        parts = pieces(robots)
        for _ in range(parts):
            wander(1.0 / parts, robots)
            count = part_from_walls(robots, state.walls, pairs, on_roads)
    if state.fixed[TOGETHER]:
        fill(robots, state.fixed_floats[WIDEST], state.grid)
        count = part_discs(robots, state.grid, pairs, count)
    if count > 0 or clock[CONTACTS] > 0:
        tell_contacts(count, state)
    if len(robots.free_solid) > 0:
        tell_leaving(state)


def tell_contacts(count: int, state: State) -> None:
    """Says which pairs have begun to touch, and remembers all that do."""
    clock = state.clock
    events = state.events
    pairs = state.contacts.pairs
    before = state.contacts.before
    touching = state.robots.ints[TOUCHING]
    news = news_first(state.contacts, count, clock[CONTACTS])
    clock[COLLISIONS] += news
    for k in range(news):
        tell(events, clock, COLLISION, pairs[2 * k], pairs[2 * k + 1], 0)
    for k in range(2 * clock[CONTACTS]):
        if before[k] >= 0:
            touching[before[k]] = 0
    for k in range(2 * count):
        before[k] = pairs[k]
        if pairs[k] >= 0:
            touching[pairs[k]] = 1
    clock[CONTACTS] = count


def tell_leaving(state: State) -> None:
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
            tell(state.events, state.clock, LEAVING, i, 0, 0)
