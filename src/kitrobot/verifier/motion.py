"""How robots on one road move: the events of the world that are possible for three neighbours.

An event changes one robot, or two: a robot that goes on changes the gap to the one ahead and the gap of the one behind.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum

from kitrobot.verifier.bodies import Body
from kitrobot.verifier.roads import PRESSED, TOUCHING, Gaps, Zones, possible


class Move(IntEnum):
    """What happens to a robot that is on a road; the numbers are none of those of `events.What`."""

    BEGIN = 1
    HALT = 2
    ZONE = 3
    CLOSER = 4
    TOUCH = 5
    WIDER = 6


@dataclass(frozen=True)
class Track:
    """One robot's road.

    Attributes:
        zones: the zones of its road.
        gaps: the classes of the gap to the robot ahead.
        braking_mm: how far it rolls at most from a reading that lets it brake until it stands.
        tick_mm: how far it rolls at most from one tick of its own to the next.
    """

    zones: Zones
    gaps: Gaps
    braking_mm: float
    tick_mm: float

    @property
    def around(self) -> int:
        """The class of gap where the robot ahead is in the same zone and yet a whole road ahead."""
        return self.gaps.beyond + 1

    def ahead(self, me: Body, leader: Body) -> int:
        """How many zones ahead the leader is."""
        if me.zone == leader.zone:
            return len(self.zones) if me.gap == self.around else 0
        return (leader.zone - me.zone) % len(self.zones)

    def gap_in(self, gap: int, zone: int, ahead: int) -> int:
        """The class of gap after a zone changed: the same, or the one with a lap between; -1 where it cannot be."""
        if ahead < 0 or ahead > len(self.zones):
            return -1
        if self.zones.closed and ahead == len(self.zones):
            return self.around if gap >= self.gaps.beyond and possible(self.zones, self.gaps, zone, ahead)[-1] else -1
        gap = min(gap, self.gaps.beyond)
        return gap if possible(self.zones, self.gaps, zone, ahead)[gap] else -1


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
    if me.way and len(track.zones) > 1:
        yield from _into_next_zone(me, leader, follower, track, behind, is_pair)
    if leader is not None and me.gap < track.around:
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
        gap = track.gap_in(me.gap, zone, track.ahead(me, leader) - me.way)
        if gap < 0:
            return
        after = after._replace(gap=gap)
    if follower is None or behind is None:
        yield Moved(Move.ZONE, after)
        return
    theirs = behind.gap_in(follower.gap, follower.zone, behind.ahead(follower, me) + me.way)
    if theirs < 0:
        return
    other = follower if theirs == follower.gap else follower.at_gap(theirs)
    yield Moved(Move.ZONE, after, other if is_pair else None, None if is_pair else other)


def _other_gap(me: Body, leader: Body, track: Track) -> Iterator[Moved]:
    ahead = track.ahead(me, leader)
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
