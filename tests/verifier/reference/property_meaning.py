"""What properties mean, written down plainly: for all ticks, there is a tick. No state, no automaton.

A trace is a list of ticks, each with what holds in it; its first tick is tick 0, the beginning. A run that ends stays
as it is.
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.mission.property_forms import AskedProperty, Form, VisitOrder

Trace = Sequence[tuple[bool, ...]]


def is_broken_so_far(one: AskedProperty, trace: Trace, tick_ms: int) -> bool:
    """Whether these ticks break it, whatever comes."""
    ticks = range(len(trace))

    def now(t: int, which: int = 0) -> bool:
        return trace[t][which]

    def comes(t: int, which: int = 0) -> bool:
        return now(t, which) and (t == 0 or not now(t - 1, which))

    def seconds_between(first: int, second: int) -> float:
        return (second - first) * tick_ms / 1000

    def is_late(first: int, second: int) -> bool:
        return one.seconds > 0 and seconds_between(first, second) > one.seconds + 1e-9

    def missed(which: int, t: int) -> bool:
        """Whether the condition did not hold up to a tick that is too late."""
        return is_late(0, t) and not any(now(u, which) for u in ticks if u < t and not is_late(0, u))

    size = len(one.conditions)
    match one.form:
        case Form.NEVER:
            return any(all(now(t, which) for which in range(size)) for t in ticks)
        case Form.EVENTUALLY:
            return any(missed(0, t) for t in ticks)
        case Form.AFTER:
            return any(
                now(t) and is_late(t, u) and not any(now(v, 1) for v in ticks if t <= v and not is_late(t, v))
                for t in ticks
                for u in ticks
                if u > t
            )
        case Form.STAYS:
            return any(
                now(t) and not now(t, 1) and not now(t + 1) and not now(t + 1, 1) for t in ticks if t + 1 in ticks
            )
        case Form.HOLDS:
            return any(
                comes(t) and not now(u) and seconds_between(t, u) < one.seconds - 1e-9
                for t in ticks
                for u in ticks
                if u > t
            )
        case Form.AT_MOST:
            return sum(comes(t) for t in ticks) > one.times
        case Form.BEFORE:
            return any(now(t, 1) and not any(now(u) for u in ticks if u <= t) for t in ticks)
        case Form.AGAIN:
            return any(
                is_late(t, u) and not any(now(v, which) for v in ticks if t < v <= u - 1)
                for which in range(size)
                for t in ticks
                for u in ticks
                if u > t and (t == 0 or now(t, which))
            )
        case Form.VISIT:
            if any(missed(which, t) for which in range(size) for t in ticks):
                return True
            if one.order is VisitOrder.GIVEN:
                return any(
                    now(t, later) and not any(now(u, earlier) for u in ticks if u <= t)
                    for earlier in range(size)
                    for later in range(earlier + 1, size)
                    for t in ticks
                )
            return one.order is VisitOrder.TURN and not _is_in_turn(
                [[which for which in range(size) if comes(t, which)] for t in ticks], size
            )


def _is_in_turn(coming: Sequence[Sequence[int]], size: int) -> bool:
    """Whether what comes, tick by tick, can be put in turn; the order within a tick is free."""
    order: list[int] = []
    for found in coming:
        following = [(len(order) + step) % size for step in range(len(found))]
        if sorted(following) != sorted(found):
            return False
        order += following
    return True


def is_broken_by_end(one: AskedProperty, trace: Trace, tick_ms: int) -> bool:
    """Whether a run that ends with these ticks, and stays so for ever, breaks it."""
    if is_broken_so_far(one, trace, tick_ms):
        return True
    size = len(one.conditions)
    match one.form:
        case Form.EVENTUALLY:
            return not any(now[0] for now in trace)
        case Form.AFTER:
            return any(now[0] and not any(later[1] for later in trace[t:]) for t, now in enumerate(trace))
        case Form.AGAIN:
            return not trace or not all(trace[-1])
        case Form.VISIT:
            return not all(any(now[which] for now in trace) for which in range(size))
        case _:
            return False
