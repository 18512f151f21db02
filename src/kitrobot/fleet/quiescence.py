"""`QuiescenceDetector`: whether a fleet can still change anything, as its world knows it.

It is stuck when for `QUIESCENT_MS`, and for as many steps as late sensors need, nothing happened, nothing is to come on
schedule or with the end of a lease, and every program only looks again at what stays. Where something moves, sensors
may still see it, so then all programs must wait for others of their team. Where neither is certain, the run ends with
its time, and that is reported.
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.fleet.replica import Replica
from kitrobot.sim.tables.columns import CHANCE, PATIENCE, PLANNED, PLANS, REVIVALS, TICK
from kitrobot.sim.tables.team_columns import T_AT, T_ROLE
from kitrobot.text.sentences import Sentence

QUIESCENT_MS = 10_000
"""A fleet in which nothing stirs for so long is stuck."""


class QuiescenceDetector:
    """Of the run that a replica is part of, from `now` on, ms.

    Attributes:
        is_stuck: whether nothing can change any more.
    """

    def __init__(self, replica: Replica, now: int) -> None:
        self.is_stuck = False
        self._replica = replica
        self._stirred_at = self._acted_at = now
        self._stirred_in = 0
        self._reported_at = -1
        self._slots = 0

    def check(self, now: int, happened: bool, quiet: Sequence[bool | None], expected: int) -> Sentence | None:
        """Looks at the run after a step; returns the sentence to report.

        Args:
            now: ms by the clock of the world.
            happened: whether the step had events.
            quiet: of each robot whether its program changes nothing; None for one that is not there, or has ended.
            expected: revivals that are none on schedule.
        """
        clock = self._replica.state.clock
        slots, self._slots = self._slots, self._replica.slot
        going = [i for i, still in enumerate(quiet) if still is not None]
        acts = happened or slots != self._replica.slot or self._is_to_come(expected) or not all(quiet[i] for i in going)
        if acts:
            self._acted_at = now
        if acts or (self._may_be_seen() and not all(map(self._waits_for_team, going))):
            self._stirred_at, self._stirred_in = now, clock[TICK]
        self.is_stuck = now - self._stirred_at >= QUIESCENT_MS and clock[TICK] - self._stirred_in >= clock[PATIENCE]
        limit = self._replica.simulation.seconds_limit
        if self.is_stuck or now - self._acted_at < QUIESCENT_MS or self._reported_at == self._acted_at or limit is None:
            return None
        self._reported_at = self._acted_at
        return Sentence(
            "all programs wait, but what sensors see may change; the run ends after {seconds} s", f"{limit:g}"
        )

    def _is_to_come(self, expected: int) -> bool:
        """Whether a failure or a revival is on schedule, or somebody has a unit of work whose lease will be over."""
        clock = self._replica.state.clock
        works = self._replica.simulation.mission.team.works
        return (
            clock[REVIVALS] > expected
            or clock[PLANNED] < clock[PLANS]
            or any(works[work].lease for work, _, _ in self._replica.held_units())
        )

    def _may_be_seen(self) -> bool:
        """Whether sensors may see something else, although no program does anything."""
        simulation = self._replica.simulation
        return simulation.state.clock[CHANCE] > 0 or any(agent.busy for agent in simulation.members)

    def _waits_for_team(self, robot: int) -> bool:
        """Whether the one thread of a program that runs waits for others of its team, a role or a unit of work."""
        state, table = self._replica.state, self._replica.state.team.robots
        if not self._replica.is_of_team(robot) or sum(at >= 0 for at in state.machines.threads[robot][::2]) != 1:
            return False
        return table[T_ROLE][robot] < 0 or table[T_AT][robot] >= 0 or any(row[robot] >= 0 for row in state.team.waits)
