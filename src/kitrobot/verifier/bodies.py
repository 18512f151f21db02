"""The packed motion state of one robot on a road (a *body*), and the rest of its state (`Inside`).

A robot on a road is in a zone and at a class of gap to the robot ahead (`roads`). Its wheels stop, drive or brake. It
enters the next zone, or a narrower class of gap, only after a tick of its own in its current one. If that tick lets it
brake, or it was already braking when it arrived, it can leave only a zone (or class of gap) that is shorter than its
braking distance; if it brakes later, it can leave any.

A *body* packs this motion into one number: the direction that its wheels were commanded (`want`) and the one in which
it rolls (`way`), each 1 (forward), -1 (back) or 0 (stopped); the class of the gap to the robot ahead; the zone; five
flags. This module uses only the subset of Python that Numba compiles.
"""

from __future__ import annotations

from typing import NamedTuple

RUNS, STALLED, FAILED = range(3)
"""`Inside.down`: the order of `columns.WELL`, `STALLED` and `FAILED`."""
ANEW = 3
"""What befalls a robot whose program begins anew: it is told to stop."""
LOST = 4
"""What befalls one that is down, and missed: where its program stood makes no difference any more."""


class Inside(NamedTuple):
    """One robot but for its motion.

    Attributes:
        local: the state of its program (see `programs`).
        load: whether a box is on its bed.
        busy: of each of its actuators that take longer: 0, or 1 and the number of the procedure.
        down: RUNS, STALLED (it rolls on and does not tick) or FAILED.
        own: its copies of the shared variables, once it hears nobody; empty as long as it does.
        is_muted: whether it hears nobody.
        is_over: whether its team ended its program, since nobody needs it any more.
        loose: the bits of its actuators that go on although the parallel of a marked action that started them is over
            (see `stops`).
    """

    local: int
    load: int
    busy: tuple[int, ...]
    down: int
    own: tuple[int, ...] = ()
    is_muted: bool = False
    is_over: bool = False
    loose: int = 0


NEW_ZONE = 1 << 4
"""It came into its zone after its last tick."""
NEW_GAP = 1 << 5
"""It came to its class of gap, by its own motion, after its last tick."""
HELD_ZONE = 1 << 6
"""It brakes since it came into its zone, or since before."""
HELD_GAP = 1 << 7
"""The same of its class of gap."""
TICKS = 1 << 8
"""It has ticks: its program goes on, and nothing befell it."""
_GAP, _ZONE = 9, 15
_GAPS = 63
_NEW = NEW_ZONE | NEW_GAP
_HELD = HELD_ZONE | HELD_GAP
MOST_GAPS = _GAPS
"""Classes of gaps at most."""


def body(want: int, way: int, zone: int, gap: int, flags: int) -> int:
    """A body of these."""
    return want + 1 | way + 1 << 2 | flags | gap << _GAP | zone << _ZONE


def want_of(one: int) -> int:
    """The direction that its wheels were told."""
    return (one & 3) - 1


def way_of(one: int) -> int:
    """The direction in which it rolls."""
    return (one >> 2 & 3) - 1


def gap_of(one: int) -> int:
    """The class of the gap ahead."""
    return one >> _GAP & _GAPS


def zone_of(one: int) -> int:
    """The zone."""
    return one >> _ZONE


def told(one: int, want: int) -> int:
    """After its wheels were told a direction, in a tick of its own."""
    was, way = want_of(one), way_of(one)
    if want == was:
        return one
    after = one & ~3 | want + 1
    if way == 0 or want == way:
        return after & ~_HELD
    if was != way:
        return after
    return after & ~_HELD | (one & _NEW) << 2


def ticked(one: int, want: int, ticks: bool) -> int:
    """After a tick of its own that told its wheels a direction (less than -1: nothing); whether it ticks on."""
    after = told(one, want) if want >= -1 else one
    return after & ~(_NEW | TICKS) | (TICKS if ticks else 0)


def begun(one: int) -> int:
    """After it began to roll as it was told."""
    return one & ~(_HELD | 12) | (one & 3) << 2


def halted(one: int) -> int:
    """After it came to stand; what its wheels were told stays."""
    return one & ~(_NEW | _HELD | 12) | 1 << 2


def entered(one: int, zone: int) -> int:
    """After it came into a zone by its own motion."""
    flag = HELD_ZONE if want_of(one) != way_of(one) else NEW_ZONE
    return one & ((1 << _ZONE) - 1) & ~(NEW_ZONE | HELD_ZONE) | zone << _ZONE | flag


def closed_in(one: int, gap: int) -> int:
    """After its own motion brought it to a narrower class of gap."""
    flag = HELD_GAP if want_of(one) != way_of(one) else NEW_GAP
    return one & ~(_GAPS << _GAP | NEW_GAP | HELD_GAP) | gap << _GAP | flag


def at_gap(one: int, gap: int) -> int:
    """After the gap ahead became of another class without its doing."""
    return one & ~(_GAPS << _GAP | NEW_GAP | HELD_GAP) | gap << _GAP


def in_gap(one: int, gap: int) -> int:
    """The same at another class of gap; its flags stay."""
    return one & ~(_GAPS << _GAP) | gap << _GAP


def befallen(one: int, down: int) -> int:
    """After it failed, stalled, runs again or has its program begin `ANEW`."""
    if down == ANEW:
        return told(one, 0)
    after = one & ~TICKS | (TICKS if down == RUNS else 0)
    return after & ~(_HELD | 3) | 1 if down == FAILED else after
