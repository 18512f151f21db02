"""The meaning of a property on one run, tick by tick: the one place in which runs, recordings and teams are judged.

An automaton is told at each tick which of the conditions hold (`AskedProperty.conditions`, in their order). It knows at
each tick whether the property is broken, kept whatever comes, or open, and since when something is waited for. It is
plain numbers, so it can be copied and sent.

Tick 0 is the beginning: what is stored before the first tick, and what is read first (`run_conditions`).
A condition *comes* in a tick in which it holds and did not hold in the tick before; in tick 0 if it holds then.
Seconds are counted in ticks: of a deadline the last tick that is not late, of a duration the first one that is enough.
A run that ends stays as it is: what holds in its last tick holds on, and what is waited for then never comes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from enum import Enum

from kitrobot.mission.property_forms import AskedProperty, Form, VisitOrder

_ROUNDING = 1e-9
"""Of a tick: seconds are decimal numbers."""


class PropertyState(Enum):
    """How a property stands after a tick; only OPEN changes."""

    OPEN = "open"
    KEPT = "kept"
    BROKEN = "broken"


@dataclass(slots=True)
class PropertyAutomaton:
    """A property while a run goes by.

    Attributes:
        asked: the property.
        tick_ms: simulated time of a tick, in ms.
        standing: how it stands.
        waits_since: the tick since which something is waited for; -1 for nothing.
        decided_at: the tick in which `standing` stopped being OPEN; -1 before.
        came_up: whether what it is about came; of the forms that expect something from the beginning, always.
    """

    asked: AskedProperty
    tick_ms: float
    standing: PropertyState = PropertyState.OPEN
    waits_since: int = -1
    decided_at: int = -1
    came_up: bool = field(init=False)
    _count: int = 0
    _visited: set[int] = field(default_factory=set)
    _last: list[int] = field(default_factory=list)
    _before: tuple[bool, ...] = ()

    def __post_init__(self) -> None:
        size = len(self.asked.conditions)
        self._before = (False,) * size
        self._last = [0] * size
        self.came_up = self._subjects == 0
        if self.asked.form in (Form.EVENTUALLY, Form.AGAIN, Form.VISIT):
            self.waits_since = 0

    @property
    def _subjects(self) -> int:
        """How many of its first conditions are what it is about; 0 of what is expected from the beginning."""
        match self.asked.form:
            case Form.AFTER | Form.STAYS | Form.HOLDS | Form.AT_MOST:
                return 1
            case Form.BEFORE:
                return 2
            case Form.NEVER if self.asked.second:
                return 2
        return 0

    @property
    def deadline(self) -> int | None:
        """Ticks in which what is expected comes; None for any number."""
        seconds = self.asked.seconds
        return math.floor(seconds * 1000 / self.tick_ms + _ROUNDING) if seconds else None

    def read(self, tick: int, truths: Sequence[bool]) -> PropertyState:
        """Takes in one tick; ticks ascend, and the first one is 0.

        Args:
            tick: its number.
            truths: which of the conditions hold.
        """
        if self.standing is PropertyState.OPEN:
            now = tuple(truths)
            self.came_up = self.came_up or any(now[: self._subjects])
            comes = tuple(one and not was for one, was in zip(now, self._before, strict=True))
            self.standing = _STEPS[self.asked.form](self, tick, now, comes)
            self._before = now
            if self.standing is not PropertyState.OPEN:
                self.decided_at = tick
                if self.standing is PropertyState.KEPT:
                    self.waits_since = -1
        return self.standing

    def is_broken_by_end(self) -> bool:
        """Whether a run that ends here, and stays as it is, breaks it."""
        return self.standing is PropertyState.BROKEN or (self.standing is PropertyState.OPEN and self.waits_since >= 0)

    def _is_late(self, tick: int, since: int) -> bool:
        deadline = self.deadline
        return deadline is not None and since >= 0 and tick - since > deadline

    def _never(self, tick: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> PropertyState:
        return _broken_if(all(now))

    def _eventually(self, tick: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> PropertyState:
        if self._is_late(tick, 0):
            return PropertyState.BROKEN
        return PropertyState.KEPT if now[0] else PropertyState.OPEN

    def _after(self, tick: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> PropertyState:
        # What comes in a tick that is too late comes too late, though nothing is waited for then.
        if self._is_late(tick, self.waits_since):
            return PropertyState.BROKEN
        if now[1]:
            self.waits_since = -1
        elif now[0] and self.waits_since < 0:
            self.waits_since = tick
        return PropertyState.OPEN

    def _stays(self, tick: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> PropertyState:
        first, second = self._before
        return _broken_if(first and not second and not any(now))

    def _holds(self, tick: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> PropertyState:
        if comes[0]:
            self._count = tick
        enough = math.ceil(self.asked.seconds * 1000 / self.tick_ms - _ROUNDING)
        return _broken_if(self._before[0] and not now[0] and tick - self._count < enough)

    def _at_most(self, tick: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> PropertyState:
        self._count += comes[0]
        return _broken_if(self._count > self.asked.times)

    def _before_other(self, tick: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> PropertyState:
        return PropertyState.KEPT if now[0] else _broken_if(now[1])

    def _again(self, tick: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> PropertyState:
        if any(self._is_late(tick, last) for last in self._last):
            return PropertyState.BROKEN
        self._last = [tick if one else last for one, last in zip(now, self._last, strict=True)]
        missing = [last for one, last in zip(now, self._last, strict=True) if not one]
        self.waits_since = min(missing, default=-1)
        return PropertyState.OPEN

    def _visit(self, tick: int, now: tuple[bool, ...], comes: tuple[bool, ...]) -> PropertyState:
        if len(self._visited) < len(now) and self._is_late(tick, 0):
            return PropertyState.BROKEN
        match self.asked.order:
            case VisitOrder.ANY:
                self._visited.update(at for at, one in enumerate(now) if one)
            case VisitOrder.GIVEN:
                following = visit_in_order(len(self._visited), now)
                if following < 0:
                    return PropertyState.BROKEN
                self._visited = set(range(following))
            case VisitOrder.TURN:
                following, visits = visit_in_turn(self._count, comes)
                if following < 0:
                    return PropertyState.BROKEN
                self._visited.update((self._count + step) % len(now) for step in range(visits))
                self._count = following
        if len(self._visited) < len(now):
            return PropertyState.OPEN
        self.waits_since = -1
        return PropertyState.OPEN if self.asked.order is VisitOrder.TURN else PropertyState.KEPT


def visit_in_order(visited: int, now: Sequence[bool]) -> int:
    """How many conditions have come in their order after a tick; -1 if one held before its turn.

    Args:
        visited: how many had come before.
        now: which hold.
    """
    while visited < len(now) and now[visited]:
        visited += 1
    return -1 if any(now[visited:]) else visited


def visit_in_turn(following: int, comes: Sequence[bool]) -> tuple[int, int]:
    """The condition that is to come next after a tick, -1 if another one came; and how many came.

    Args:
        following: the condition that was to come next.
        comes: which come in this tick.
    """
    visits = 0
    while visits < len(comes) and comes[following]:
        following, visits = (following + 1) % len(comes), visits + 1
    return (following if visits == sum(comes) else -1), visits


def _broken_if(broken: bool) -> PropertyState:
    return PropertyState.BROKEN if broken else PropertyState.OPEN


_Step = Callable[[PropertyAutomaton, int, tuple[bool, ...], tuple[bool, ...]], PropertyState]
_STEPS: dict[Form, _Step] = {
    Form.NEVER: PropertyAutomaton._never,
    Form.EVENTUALLY: PropertyAutomaton._eventually,
    Form.AFTER: PropertyAutomaton._after,
    Form.STAYS: PropertyAutomaton._stays,
    Form.HOLDS: PropertyAutomaton._holds,
    Form.AT_MOST: PropertyAutomaton._at_most,
    Form.BEFORE: PropertyAutomaton._before_other,
    Form.AGAIN: PropertyAutomaton._again,
    Form.VISIT: PropertyAutomaton._visit,
}
