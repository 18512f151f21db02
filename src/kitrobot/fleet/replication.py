"""`LogReplication`: brings a replica up to date with the log, slot by slot, at a member or at the world.

Slots that were decided during a long absence of the member are not sent one by one: another's replica is adopted,
and the slots behind it, which wait here meanwhile, are applied.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

from kitrobot.fleet.body_messages import ReplicaSnapshot
from kitrobot.fleet.replica import Effect, Replica
from kitrobot.sim.event_text import Event
from kitrobot.sim.tables.state import SharedVariables

MOST_RECENT_SLOTS = 512
"""Slots that are stored for the world and for members that request them."""


class LogReplication:
    """A replica and the slots that are known behind it. `adopted`: whether another's was taken over last."""

    def __init__(self, replica: Replica, shared: SharedVariables) -> None:
        self.replica = replica
        self.adopted = False
        self._shared = shared
        self._ahead: dict[int, tuple[Effect, ...]] = {}
        self._known = replica.slot
        self._recent: deque[tuple[Effect, ...]] = deque(maxlen=MOST_RECENT_SLOTS)

    def shared_cells(self, robot: int) -> list[tuple[int, int]]:
        """The shared variables of a robot, each with its cell."""
        shared = self._shared
        span = range(shared.mine_first[robot], shared.mine_first[robot + 1])
        return [(shared.mine[k], shared.mine_cell[k]) for k in span]

    @property
    def is_complete(self) -> bool:
        """Whether the replica has all slots that are known of."""
        return self.replica.slot >= self._known

    def add_slot(self, slot: int, effects: tuple[Effect, ...]) -> None:
        """Adds the effects of a decided slot."""
        self._known = max(self._known, slot + 1)
        if slot >= self.replica.slot and len(self._ahead) < MOST_RECENT_SLOTS:
            self._ahead[slot] = effects

    def skip_to(self, slot: int) -> None:
        """Skips to a slot: those before it are decided, but their content is unknown."""
        self._known = max(self._known, slot)

    def adopt(self, snapshot: ReplicaSnapshot) -> bool:
        """Takes another's replica over, if it knows more."""
        if snapshot.slot <= self.replica.slot or not self.replica.unpack(snapshot.slot, snapshot.rows):
            return False
        self.adopted = True
        self._recent.clear()
        self._known = max(self._known, snapshot.slot)
        return True

    def apply_known(self, seen: Callable[[Effect], None]) -> list[Event]:
        """Applies the slots that follow; returns their events. `seen` is called with each effect."""
        events: list[Event] = []
        while self.replica.slot in self._ahead:
            slot = self.replica.slot
            effects = self._ahead.pop(slot)
            events += self.replica.apply(slot, effects)
            self._recent.append(effects)
            for effect in effects:
                seen(effect)
        self._ahead = {slot: effects for slot, effects in self._ahead.items() if slot > self.replica.slot}
        return events

    def slots_since(self, slot: int, most: int) -> tuple[int, tuple[tuple[Effect, ...], ...]]:
        """Up to so many slots from one on, and the number of the first; -1 where that is forgotten."""
        oldest = self.replica.slot - len(self._recent)
        if slot < oldest:
            return -1 if self.is_complete else oldest, ()
        recent = list(self._recent)[slot - oldest : slot - oldest + most]
        return slot, tuple(recent)
