"""How many ticks are due: simulated time against the wall clock, at any speed.

Representation: an anchor (a moment of the clock and the tick reached then) from which the tick that is due follows by
the speed. Whatever changes the pace (speed, pause, a machine too slow to keep up) sets a new anchor, so a run never
races to make up for time that it could not use. Left to others: running the ticks, waiting.
"""

from __future__ import annotations

from collections.abc import Callable

SLOWEST = 0.1
UNPACED = 0.0
"""The speed that means: as fast as it goes."""

MOST_BEHIND_S = 0.25
"""The longest delay that a run makes up for; time beyond it is dropped."""


class RealtimePacer:
    """Paces one run. `clock` gives seconds and never goes back."""

    def __init__(self, tick_s: float, clock: Callable[[], float], speed: float = 1.0) -> None:
        self._tick_s = tick_s
        self._clock = clock
        self._speed = speed
        self._paused = False
        self._from_time = clock()
        self._from_tick = 0

    @property
    def speed(self) -> float:
        """Times real time, or `UNPACED`."""
        return self._speed

    @property
    def paused(self) -> bool:
        """Whether no tick is ever due."""
        return self._paused

    def set_speed(self, speed: float, tick: int) -> None:
        """From now, where `tick` ticks were run, on: this speed."""
        self._speed = speed
        self._anchor(tick)

    def set_paused(self, paused: bool, tick: int) -> None:
        """Stops or goes on, from now, where `tick` ticks were run."""
        self._paused = paused
        self._anchor(tick)

    def due(self, tick: int) -> int | None:
        """How many ticks to run now that `tick` were run; None when as many as there is time for."""
        if self._paused:
            return 0
        if self._speed == UNPACED:
            return None
        now = self._clock()
        wanted = self._from_tick + int((now - self._from_time) * self._speed / self._tick_s)
        most = max(1, int(MOST_BEHIND_S * self._speed / self._tick_s))
        if wanted - tick > most:
            self._from_time, self._from_tick = now, tick + most
            return most
        return max(0, wanted - tick)

    def wait_s(self, tick: int) -> float | None:
        """Seconds until the next tick is due; None while paused."""
        if self._paused:
            return None
        if self._speed == UNPACED:
            return 0.0
        at = self._from_time + (tick + 1 - self._from_tick) * self._tick_s / self._speed
        return max(0.0, at - self._clock())

    def _anchor(self, tick: int) -> None:
        self._from_time = self._clock()
        self._from_tick = tick


def clamp_speed(wanted: float) -> float:
    """The speed for a requested one: at least `SLOWEST`, except `UNPACED`."""
    return wanted if wanted == UNPACED else max(SLOWEST, wanted)
