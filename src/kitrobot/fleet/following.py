"""`Following`: brings a replica up to the log that its member, or the world, hears of, slot by slot.

What was decided while its member was away for long is not told slot by slot: then another's replica is adopted, and the
slots behind it, which wait here meanwhile, are taken in.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

from kitrobot.fleet.bodies import Whole
from kitrobot.fleet.replica import Effect, Replica
from kitrobot.sim import Event
from kitrobot.sim.state import Shared

KEPT = 512
"""Slots that are kept for the world and whoever asks."""


class Following:
    """A replica and the slots that are known behind it. `adopted`: whether another's was taken over last."""

    def __init__(self, replica: Replica, shared: Shared) -> None:
        self.replica = replica
        self.adopted = False
        self._shared = shared
        self._ahead: dict[int, tuple[Effect, ...]] = {}
        self._known = replica.slot
        self._kept: deque[tuple[Effect, ...]] = deque(maxlen=KEPT)

    def cells_of(self, robot: int) -> list[tuple[int, int]]:
        """The shared variables of a robot, each with its cell."""
        shared = self._shared
        span = range(shared.mine_first[robot], shared.mine_first[robot + 1])
        return [(shared.mine[k], shared.mine_cell[k]) for k in span]

    @property
    def is_whole(self) -> bool:
        """Whether the replica has all slots that are known of."""
        return self.replica.slot >= self._known

    def decided(self, slot: int, effects: tuple[Effect, ...]) -> None:
        """What a slot says became known."""
        self._known = max(self._known, slot + 1)
        if slot >= self.replica.slot and len(self._ahead) < KEPT:
            self._ahead[slot] = effects

    def skipped(self, slot: int) -> None:
        """Slots before this one are known to be decided, but not what they say."""
        self._known = max(self._known, slot)

    def adopt(self, whole: Whole) -> bool:
        """Takes another's replica over, if it knows more."""
        if whole.slot <= self.replica.slot or not self.replica.unpack(whole.slot, whole.rows):
            return False
        self.adopted = True
        self._kept.clear()
        self._known = max(self._known, whole.slot)
        return True

    def take_in(self, seen: Callable[[Effect], None]) -> list[Event]:
        """Takes in the slots that follow; gives what is told of them. `seen` is called with each effect."""
        told: list[Event] = []
        while self.replica.slot in self._ahead:
            slot = self.replica.slot
            effects = self._ahead.pop(slot)
            told += self.replica.apply(slot, effects)
            self._kept.append(effects)
            for effect in effects:
                seen(effect)
        self._ahead = {slot: effects for slot, effects in self._ahead.items() if slot > self.replica.slot}
        return told

    def since(self, slot: int, most: int) -> tuple[int, tuple[tuple[Effect, ...], ...]]:
        """Up to so many slots from one on, and the number of the first; -1 where that is forgotten."""
        oldest = self.replica.slot - len(self._kept)
        if slot < oldest:
            return -1 if self.is_whole else oldest, ()
        kept = list(self._kept)[slot - oldest : slot - oldest + most]
        return slot, tuple(kept)
