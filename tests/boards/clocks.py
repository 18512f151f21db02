"""Clocks of boards on this computer: one that goes with that of the wall, and one that goes with the traffic."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Protocol


class Clock(Protocol):
    """What a board takes its time from. `pace`: how fast it goes at most, for that of the wall."""

    pace: float

    def ms(self) -> float:
        """The time, in milliseconds."""

    def heard(self) -> None:
        """A host came, or said something."""

    def left(self) -> None:
        """The host is gone."""


class WallClock:
    """Goes `pace` times as fast as that of the wall, whoever says what."""

    def __init__(self, pace: float = 1.0) -> None:
        self.pace = pace

    def ms(self) -> float:
        return time.monotonic() * 1000 * self.pace

    def heard(self) -> None:
        pass

    def left(self) -> None:
        pass


GRANTED_S = 0.5
"""A board that holds on to its host gives it up after 0.8 s; so much of that passes as on the wall."""
SLOW_PACE = 0.03
"""What is left of it passes so slowly, for on a busy machine a host is silent for seconds."""


class TrafficClock:
    """Goes as that of the wall for a while after each thing that is heard, and slowly when its host says nothing more.

    So nobody waits longer than a board does, and none gives up a host that only has to wait for a processor. Without a
    host it goes as that of the wall.

    Args:
        wall: the clock of the wall, in seconds.
        granted_s: how long it goes as that of the wall.
        slow_pace: how fast it goes from then on.
    """

    pace = 1.0

    def __init__(
        self, wall: Callable[[], float] = time.monotonic, granted_s: float = GRANTED_S, slow_pace: float = SLOW_PACE
    ) -> None:
        self._wall = wall
        self._granted_s, self._slow_pace = granted_s, slow_pace
        self._has_host = False
        self._since = wall()
        self._ms = 0.0

    def ms(self) -> float:
        passed = self._wall() - self._since
        granted = min(passed, self._granted_s) if self._has_host else passed
        return self._ms + 1000 * (granted + (passed - granted) * self._slow_pace)

    def heard(self) -> None:
        self._begin(True)

    def left(self) -> None:
        self._begin(False)

    def _begin(self, has_host: bool) -> None:
        self._ms = self.ms()
        self._since = self._wall()
        self._has_host = has_host
