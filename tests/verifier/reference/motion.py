"""How robots on one road move: the events of the world that are possible for three neighbours.

An event changes one robot, or two: a robot that goes on changes the gap to the one ahead and the gap of the one behind.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum
from functools import lru_cache

from kitrobot.verifier.tables import roads
from kitrobot.verifier.tables.roads import PRESSED, TOUCHING, Gaps, Track, Zones
from tests.verifier.reference.bodies import Body


class Move(IntEnum):
    """What happens to a robot that is on a road; the numbers are none of those of `events.EventKind`."""

    BEGIN = 1
    HALT = 2
    ZONE = 3
    CLOSER = 4
    TOUCH = 5
    WIDER = 6


def around_of(track: Track) -> int:
    """The class of gap where the robot ahead is in the same zone and yet a whole road ahead."""
    return track.gaps.beyond + 1


def ahead_of(track: Track, me: Body, leader: Body) -> int:
    """How many zones ahead the leader is."""
    if me.zone == leader.zone:
        return len(track.zones) if me.gap == around_of(track) else 0
    return (leader.zone - me.zone) % len(track.zones)


@lru_cache(100_000)
def possible(zones: Zones, gaps: Gaps, zone: int, ahead: int) -> tuple[bool, ...]:
    """`roads.possible`, kept."""
    return roads.possible(zones, gaps, zone, ahead)


def gap_in(track: Track, gap: int, zone: int, ahead: int) -> int:
    """The class of gap after a zone changed: the same, or the one with a lap between; -1 where it cannot be."""
    if ahead < 0 or ahead > len(track.zones):
        return -1
    if track.zones.closed and ahead == len(track.zones):
        is_possible = gap >= track.gaps.beyond and possible(track.zones, track.gaps, zone, ahead)[-1]
        return around_of(track) if is_possible else -1
    gap = min(gap, track.gaps.beyond)
    return gap if possible(track.zones, track.gaps, zone, ahead)[gap] else -1


@dataclass(frozen=True, slots=True)
class Moved:
    """An event of the world for one robot: what it is, and the robots after it (None: unchanged)."""

    move: Move
    me: Body
    leader: Body | None = None
    follower: Body | None = None


def moves(
    me: Body, leader: Body | None, follower: Body | None, track: Track, behind: Track | None, is_pair: bool
) -> Iterator[Moved]:
    """What can happen to a robot next, between a leader (ahead) and a follower (behind), where there are such.

    Args:
        me: the robot.
        leader: the robot ahead on the same road.
        follower: the one behind, whose leader `me` is.
        track: the robot's road.
        behind: the follower's.
        is_pair: leader and follower are the same robot.
    """
    if me.want and me.way == 0 and not _is_blocked(me, leader, follower):
        yield Moved(Move.BEGIN, me.begun())
    if me.way and (me.want != me.way or (me.way > 0 and me.gap == PRESSED and leader is not None)):
        yield Moved(Move.HALT, me.halted())
    if me.way and (len(track.zones) > 1 or not track.zones.closed):
        yield from _into_next_zone(me, leader, follower, track, behind, is_pair)
    if leader is not None and me.gap < around_of(track):
        yield from _other_gap(me, leader, track)


def _is_blocked(me: Body, leader: Body | None, follower: Body | None) -> bool:
    """Whether it presses on a robot that stands in the direction that its wheels were told."""
    if me.want > 0:
        return leader is not None and me.gap == PRESSED and leader.way <= 0
    return follower is not None and follower.gap == PRESSED and follower.way >= 0


def _into_next_zone(
    me: Body, leader: Body | None, follower: Body | None, track: Track, behind: Track | None, is_pair: bool
) -> Iterator[Moved]:
    zones = track.zones
    size = zones.size(me.zone)
    if me.new_zone and me.ticks and size > track.tick_mm:
        return
    if me.held_zone and size > track.braking_mm:
        return
    zone = zones.next(me.zone, me.way)
    if zone < 0:
        if me.want == me.way:
            yield Moved(Move.HALT, me.halted())
        return
    after = me.entered(zone)
    if leader is not None:
        gap = gap_in(track, me.gap, zone, ahead_of(track, me, leader) - me.way)
        if gap < 0:
            return
        after = after._replace(gap=gap)
    if follower is None or behind is None:
        yield Moved(Move.ZONE, after)
        return
    theirs = gap_in(behind, follower.gap, follower.zone, ahead_of(behind, follower, me) + me.way)
    if theirs < 0:
        return
    other = follower if theirs == follower.gap else follower.at_gap(theirs)
    yield Moved(Move.ZONE, after, other if is_pair else None, None if is_pair else other)


def _other_gap(me: Body, leader: Body, track: Track) -> Iterator[Moved]:
    ahead = ahead_of(track, me, leader)
    can = possible(track.zones, track.gaps, me.zone, ahead)
    if me.gap > PRESSED and can[me.gap - 1]:
        gap = me.gap - 1
        move = Move.CLOSER if gap > TOUCHING else Move.TOUCH
        low, high = track.gaps.limits(me.gap)
        free = not (me.new_gap and me.ticks and high - low > track.tick_mm)
        if me.way > 0 and free and not (me.held_gap and high - low > track.braking_mm):
            after = me.closed_in(gap)
            yield Moved(move, after.halted() if gap == PRESSED else after)
        if leader.way < 0:
            yield Moved(move, me.at_gap(gap), leader.halted() if gap == PRESSED else leader)
    if me.gap < track.gaps.beyond and can[me.gap + 1] and (leader.way > 0 or me.way < 0):
        yield Moved(Move.WIDER, me.at_gap(me.gap + 1))
