"""One step of all robots: wheels roll, robots move along their roads or freely, what touches is parted and counted.

One contact is one collision however long it lasts: the pairs that touch now are kept until the next step. A step in
which nothing rolls or turns costs next to nothing.
"""

from __future__ import annotations

from kitrobot.sim.columns import (
    ACCELERATION,
    AT,
    BRAKING,
    COLLISION,
    COLLISIONS,
    CONTACTS,
    DIRECTED,
    GAP_AHEAD,
    GAP_BEHIND,
    HEADING,
    LEADER,
    LEAVING,
    LENGTH,
    LOW_X,
    LOW_Y,
    MOVED,
    RADIUS,
    ROAD,
    ROLLING,
    SPEED,
    STRETCH,
    TARGET,
    TOUCHING,
    TURN,
    UX,
    UY,
    WAY,
    X,
    Y,
    tell,
)
from kitrobot.sim.contacts import measure_gaps, news_first, part_discs, part_from_walls, part_on_roads, sort_along
from kitrobot.sim.grids import fill
from kitrobot.sim.motion import follow, pieces, place, roll, wander

# The rows of `roads` (whole numbers): whether it is closed, its points (the last one inclusive), its sections.
CLOSED, FIRST, LAST, CUT_FIRST, CUT_LAST = range(5)


def arrange(
    real: list[list[float]],
    whole: list[list[int]],
    guided: list[int],
    roads: list[list[int]],
    road_length: list[float],
    points: list[list[float]],
) -> None:
    """Puts the robots on roads into their order and onto their places, as before the first step."""
    sort_along(guided, whole[ROAD], real[AT])
    measure_gaps(
        guided,
        whole[ROAD],
        real[AT],
        real[LENGTH],
        road_length,
        roads[CLOSED],
        real[GAP_AHEAD],
        real[GAP_BEHIND],
        whole[LEADER],
    )
    place(
        guided,
        whole[ROAD],
        real[AT],
        whole[STRETCH],
        whole[DIRECTED],
        real[X],
        real[Y],
        real[HEADING],
        real[UX],
        real[UY],
        points,
        roads[FIRST],
        roads[LAST],
    )


def move_robots(
    dt: float,
    widest: float,
    together: int,
    real: list[list[float]],
    whole: list[list[int]],
    solid: list[int],
    guided: list[int],
    free: list[int],
    free_solid: list[int],
    roads: list[list[int]],
    road_length: list[float],
    points: list[list[float]],
    walls: list[list[float]],
    wall_frame: list[float],
    wall_shape: list[int],
    wall_starts: list[int],
    wall_items: list[int],
    frame: list[float],
    shape: list[int],
    starts: list[int],
    items: list[int],
    pairs: list[int],
    before: list[int],
    buckets: list[int],
    chain: list[int],
    events: list[int],
    clock: list[int],
) -> None:
    """Moves everything by one step. `together`: 1 when discs can meet at all."""
    way = real[WAY]
    rolling = roll(dt, solid, real[SPEED], real[TARGET], real[ACCELERATION], real[BRAKING], way)
    turn = real[TURN]
    for k in range(len(free)):
        if turn[free[k]] != 0.0:
            rolling += 1
    clock[ROLLING] = rolling
    if rolling == 0:
        return
    clock[MOVED] = 1
    count = 0
    road = whole[ROAD]
    if len(guided) > 0:
        follow(guided, way, real[SPEED], road, real[AT], road_length, roads[CLOSED])
        if len(guided) > 1:
            sort_along(guided, road, real[AT])
            measure_gaps(
                guided,
                road,
                real[AT],
                real[LENGTH],
                road_length,
                roads[CLOSED],
                real[GAP_AHEAD],
                real[GAP_BEHIND],
                whole[LEADER],
            )
            count = part_on_roads(
                guided,
                road,
                real[AT],
                real[SPEED],
                road_length,
                roads[CLOSED],
                real[GAP_AHEAD],
                whole[LEADER],
                pairs,
                0,
            )
        if count > 0:
            arrange(real, whole, guided, roads, road_length, points)
        else:
            place(
                guided,
                road,
                real[AT],
                whole[STRETCH],
                whole[DIRECTED],
                real[X],
                real[Y],
                real[HEADING],
                real[UX],
                real[UY],
                points,
                roads[FIRST],
                roads[LAST],
            )
    if len(free) > 0:
        # A wall is thin: who is very fast looks for it on the way too. The last piece tells who touches one.
        on_roads = count
        parts = pieces(free_solid, way, real[RADIUS])
        for _ in range(parts):
            wander(1.0 / parts, free, way, turn, real[X], real[Y], real[HEADING], real[UX], real[UY])
            count = part_from_walls(
                free_solid,
                real[X],
                real[Y],
                real[RADIUS],
                walls,
                wall_frame,
                wall_shape,
                wall_starts,
                wall_items,
                pairs,
                on_roads,
            )
    if together:
        low_x = whole[LOW_X]
        low_y = whole[LOW_Y]
        fill(solid, real[X], real[Y], real[RADIUS], widest, low_x, low_y, frame, shape, starts, items)
        count = part_discs(road, real[X], real[Y], real[RADIUS], low_x, low_y, shape, starts, items, pairs, count)
    if count > 0 or clock[CONTACTS] > 0:
        tell_contacts(whole[TOUCHING], pairs, count, before, buckets, chain, events, clock)


def tell_contacts(
    touching: list[int],
    pairs: list[int],
    count: int,
    before: list[int],
    buckets: list[int],
    chain: list[int],
    events: list[int],
    clock: list[int],
) -> None:
    """Says which pairs have begun to touch, and remembers all that do."""
    news = news_first(pairs, count, before, clock[CONTACTS], buckets, chain)
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


def tell_leaving(
    who: list[int],
    x: list[float],
    y: list[float],
    width: float,
    height: float,
    left: list[int],
    events: list[int],
    clock: list[int],
) -> None:
    """Says of each robot, once, that its middle is beyond the edge of the world, which is no wall."""
    for k in range(len(who)):
        i = who[k]
        if left[i] == 0 and (x[i] < 0.0 or y[i] < 0.0 or x[i] > width or y[i] > height):
            left[i] = 1
            tell(events, clock, LEAVING, i, 0, 0)
