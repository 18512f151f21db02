"""The moves of a robot on a road: the events of the world that are possible for it between its two neighbours.

An event changes one robot, or two: a robot that moves changes the gap to the one ahead and the gap of the one behind.
This module uses only the subset of Python that Numba compiles.
"""

from __future__ import annotations

from enum import IntEnum

from kitrobot.verifier.tables.bodies import (
    HELD_GAP,
    HELD_ZONE,
    NEW_GAP,
    NEW_ZONE,
    TICKS,
    after_approach,
    after_gap_change,
    after_start,
    after_stop,
    after_zone_entry,
    gap_of,
    want_of,
    way_of,
    with_gap,
    zone_of,
)
from kitrobot.verifier.tables.columns import (
    A_BEYOND,
    A_CAN_AT,
    A_CLOSED,
    A_FOLLOWER,
    A_GAP_AT,
    A_LEADER,
    A_ZONE_AT,
    A_ZONES,
    AGENT,
    DOCKS,
)
from kitrobot.verifier.tables.roads import PRESSED, TOUCHING
from kitrobot.verifier.tables.tables import Row, Tables


class Move(IntEnum):
    """The moves of a robot on a road; the numbers differ from those of `events.EventKind`."""

    BEGIN = 1
    HALT = 2
    ZONE = 3
    CLOSER = 4
    TOUCH = 5
    WIDER = 6


BEGIN, HALT, ZONE, CLOSER, TOUCH, WIDER = 1, 2, 3, 4, 5, 6
NOTHING = 0
WAYS_TO_MOVE = 6
"""Moves that a robot may have: begin, halt, zone, closer by itself, closer by the one ahead, wider."""

ZONE_NUMBERS = 3
"""Of each zone: whether it is longer than a robot rolls between two ticks, and than its braking distance; its class;
then, of each dock, whether it is a zone of that."""
GAP_NUMBERS = 2
"""The same two of each class of gap."""


def zones_ahead(agents: Row, i: int, me: int, leader: int) -> int:
    """How many zones ahead the leader is; where it is in the same one, a whole road when a lap is between."""
    zones = agents[i * AGENT + A_ZONES]
    if zone_of(me) == zone_of(leader):
        return zones if gap_of(me) > agents[i * AGENT + A_BEYOND] else 0
    return (zone_of(leader) - zone_of(me)) % zones


def is_gap_possible(agents: Row, geo: Row, i: int, zone: int, ahead: int, gap: int) -> bool:
    """Whether the gap from agent i in a zone to one that is `ahead` zones further can be of this class."""
    a = i * AGENT
    return (
        geo[agents[a + A_CAN_AT] + (zone * (agents[a + A_ZONES] + 1) + ahead) * (agents[a + A_BEYOND] + 1) + gap] != 0
    )


def gap_after_zone(agents: Row, geo: Row, i: int, gap: int, zone: int, ahead: int) -> int:
    """The class of gap after a zone changed: the same, or the one with a lap between; -1 where it cannot be."""
    a = i * AGENT
    zones, beyond = agents[a + A_ZONES], agents[a + A_BEYOND]
    if ahead < 0 or ahead > zones:
        return -1
    if agents[a + A_CLOSED] and ahead == zones:
        return beyond + 1 if gap >= beyond and is_gap_possible(agents, geo, i, zone, ahead, beyond) else -1
    same = gap if gap < beyond else beyond
    return same if is_gap_possible(agents, geo, i, zone, ahead, same) else -1


def next_zone(agents: Row, i: int, zone: int, way: int) -> int:
    """The zone ahead (`way` 1) or behind (-1); -1 where the road ends."""
    zones = agents[i * AGENT + A_ZONES]
    found = zone + way
    if agents[i * AGENT + A_CLOSED]:
        return found % zones
    return found if 0 <= found < zones else -1


def is_blocked(want: int, leader: int, gap: int, follower: int) -> bool:
    """Whether a robot presses on a standing one in the direction of its command; a body of -1 is no robot."""
    if want > 0:
        return leader >= 0 and gap == PRESSED and way_of(leader) <= 0
    return follower >= 0 and gap_of(follower) == PRESSED and way_of(follower) >= 0


def move(t: Tables, bodies: int, k: int, i: int, which: int, behind: int) -> int:
    """Puts the bodies after one of `WAYS_TO_MOVE` of a robot into `made`, which holds those before it.

    Args:
        t: the tables.
        bodies: where the bodies of its road begin in `confs`.
        k: its place among them.
        i: its number in the team.
        which: the way.
        behind: the number in the team of the robot behind it; -1 for none.

    Returns:
        What happens; NOTHING where it cannot.
    """
    if which == 0:
        return begin(t, bodies, k, i)
    if which == 1:
        return halt(t, bodies, k, i)
    if which == 2:
        return enter_zone(t, bodies, k, i, behind)
    return widen_gap(t, bodies, k, i) if which == 5 else narrow_gap(t, bodies, k, i, which == 3)


def neighbour(t: Tables, bodies: int, i: int, column: int) -> int:
    """The body of the robot ahead of agent i (`A_LEADER`) or behind it (`A_FOLLOWER`); -1 for none."""
    place = t.agents[i * AGENT + column]
    return t.confs[bodies + place] if place >= 0 else -1


def begin(t: Tables, bodies: int, k: int, i: int) -> int:
    """A robot begins to roll, as it was told."""
    me = t.confs[bodies + k]
    want = want_of(me)
    if want == 0 or way_of(me) != 0:
        return NOTHING
    if is_blocked(want, neighbour(t, bodies, i, A_LEADER), gap_of(me), neighbour(t, bodies, i, A_FOLLOWER)):
        return NOTHING
    t.made[k] = after_start(me)
    return BEGIN


def halt(t: Tables, bodies: int, k: int, i: int) -> int:
    """A robot stops, as it was told, or since it presses on the one ahead."""
    me = t.confs[bodies + k]
    way = way_of(me)
    if way == 0:
        return NOTHING
    if want_of(me) == way and not (way > 0 and gap_of(me) == PRESSED and neighbour(t, bodies, i, A_LEADER) >= 0):
        return NOTHING
    t.made[k] = after_stop(me)
    return HALT


def enter_zone(t: Tables, bodies: int, k: int, i: int, behind: int) -> int:
    """A robot rolls into the next zone, or comes to the end of its road."""
    agents, geo, made = t.agents, t.geo, t.made
    a = i * AGENT
    me = t.confs[bodies + k]
    way, zone = way_of(me), zone_of(me)
    if way == 0 or (agents[a + A_ZONES] < 2 and agents[a + A_CLOSED]):
        return NOTHING
    at = agents[a + A_ZONE_AT] + zone * (ZONE_NUMBERS + t.fixed[DOCKS])
    if (me & NEW_ZONE and me & TICKS and geo[at]) or (me & HELD_ZONE and geo[at + 1]):
        return NOTHING
    to = next_zone(agents, i, zone, way)
    if to < 0:
        if want_of(me) != way:
            return NOTHING
        made[k] = after_stop(me)
        return HALT
    after = after_zone_entry(me, to)
    leader, follower = neighbour(t, bodies, i, A_LEADER), neighbour(t, bodies, i, A_FOLLOWER)
    if leader >= 0:
        further = gap_after_zone(agents, geo, i, gap_of(me), to, zones_ahead(agents, i, me, leader) - way)
        if further < 0:
            return NOTHING
        after = with_gap(after, further)
    if follower >= 0:
        theirs = gap_of(follower)
        ahead = zones_ahead(agents, behind, follower, me) + way
        nearer = gap_after_zone(agents, geo, behind, theirs, zone_of(follower), ahead)
        if nearer < 0:
            return NOTHING
        if nearer != theirs:
            made[agents[a + A_FOLLOWER]] = after_gap_change(follower, nearer)
    made[k] = after
    return ZONE


def widen_gap(t: Tables, bodies: int, k: int, i: int) -> int:
    """The gap of a robot to the one ahead becomes one class wider."""
    me, leader = t.confs[bodies + k], neighbour(t, bodies, i, A_LEADER)
    gap = gap_of(me)
    if leader < 0 or gap >= t.agents[i * AGENT + A_BEYOND] or not (way_of(leader) > 0 or way_of(me) < 0):
        return NOTHING
    if not is_gap_possible(t.agents, t.geo, i, zone_of(me), zones_ahead(t.agents, i, me, leader), gap + 1):
        return NOTHING
    t.made[k] = after_gap_change(me, gap + 1)
    return WIDER


def narrow_gap(t: Tables, bodies: int, k: int, i: int, approaches: bool) -> int:
    """The gap of a robot to the one ahead becomes one class narrower: it approaches, or the other one backs up."""
    agents, geo, made = t.agents, t.geo, t.made
    me, leader = t.confs[bodies + k], neighbour(t, bodies, i, A_LEADER)
    gap = gap_of(me)
    if leader < 0 or gap > agents[i * AGENT + A_BEYOND] or gap <= PRESSED:
        return NOTHING
    if not is_gap_possible(agents, geo, i, zone_of(me), zones_ahead(agents, i, me, leader), gap - 1):
        return NOTHING
    if approaches:
        at = agents[i * AGENT + A_GAP_AT] + gap * GAP_NUMBERS
        if way_of(me) <= 0 or (me & NEW_GAP and me & TICKS and geo[at]) or (me & HELD_GAP and geo[at + 1]):
            return NOTHING
        after = after_approach(me, gap - 1)
        made[k] = after_stop(after) if gap - 1 == PRESSED else after
    else:
        if way_of(leader) >= 0:
            return NOTHING
        made[k] = after_gap_change(me, gap - 1)
        if gap - 1 == PRESSED:
            made[agents[i * AGENT + A_LEADER]] = after_stop(leader)
    return CLOSER if gap - 1 > TOUCHING else TOUCH
