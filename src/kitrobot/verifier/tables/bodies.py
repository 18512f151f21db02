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
"""A fault code: the robot's program restarts, and the robot is commanded to stop."""
LOST = 4
"""A fault code: a robot that is down is missed; the position of its program no longer matters."""


class Inside(NamedTuple):
    """The state of one robot except its motion.

    Attributes:
        local: the state of its program (see `programs`).
        load: whether a box is on its bed.
        busy: for each actuator that takes longer, 0, or 1 plus the number of the procedure.
        down: RUNS, STALLED (it rolls on and does not tick) or FAILED.
        own: its own copies of the shared variables once it hears nobody; empty until then.
        is_muted: whether it hears nobody.
        is_over: whether its team ended its program because nobody needs it any more.
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
"""It has ticks: its program runs, and it has no fault."""
_GAP, _ZONE = 9, 15
_GAPS = 63
_NEW = NEW_ZONE | NEW_GAP
_HELD = HELD_ZONE | HELD_GAP
MOST_GAPS = _GAPS
"""Classes of gaps at most."""


def body(want: int, way: int, zone: int, gap: int, flags: int) -> int:
    """Packs a body."""
    return want + 1 | way + 1 << 2 | flags | gap << _GAP | zone << _ZONE


def want_of(one: int) -> int:
    """The direction that its wheels were commanded."""
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


def with_command(one: int, want: int) -> int:
    """The body after its wheels were commanded a direction, in a tick of its own."""
    was, way = want_of(one), way_of(one)
    if want == was:
        return one
    after = one & ~3 | want + 1
    if way == 0 or want == way:
        return after & ~_HELD
    if was != way:
        return after
    return after & ~_HELD | (one & _NEW) << 2


def after_tick(one: int, want: int, ticks: bool) -> int:
    """The body after a tick of its own.

    `want` is the direction that the tick commanded (less than -1: none); `ticks` is whether the robot has more ticks.
    """
    after = with_command(one, want) if want >= -1 else one
    return after & ~(_NEW | TICKS) | (TICKS if ticks else 0)


def after_start(one: int) -> int:
    """The body after it began to roll as commanded."""
    return one & ~(_HELD | 12) | (one & 3) << 2


def after_stop(one: int) -> int:
    """The body after it came to stand; the command of its wheels remains."""
    return one & ~(_NEW | _HELD | 12) | 1 << 2


def after_zone_entry(one: int, zone: int) -> int:
    """The body after it entered a zone by its own motion."""
    flag = HELD_ZONE if want_of(one) != way_of(one) else NEW_ZONE
    return one & ((1 << _ZONE) - 1) & ~(NEW_ZONE | HELD_ZONE) | zone << _ZONE | flag


def after_approach(one: int, gap: int) -> int:
    """The body after its own motion narrowed the gap to this class."""
    flag = HELD_GAP if want_of(one) != way_of(one) else NEW_GAP
    return one & ~(_GAPS << _GAP | NEW_GAP | HELD_GAP) | gap << _GAP | flag


def after_gap_change(one: int, gap: int) -> int:
    """The body after another robot changed the gap ahead to this class."""
    return one & ~(_GAPS << _GAP | NEW_GAP | HELD_GAP) | gap << _GAP


def with_gap(one: int, gap: int) -> int:
    """The body with another class of gap; its flags remain."""
    return one & ~(_GAPS << _GAP) | gap << _GAP


def after_fault(one: int, down: int) -> int:
    """The body after it failed, stalled, runs again or its program restarted (`ANEW`)."""
    if down == ANEW:
        return with_command(one, 0)
    after = one & ~TICKS | (TICKS if down == RUNS else 0)
    return after & ~(_HELD | 3) | 1 if down == FAILED else after
