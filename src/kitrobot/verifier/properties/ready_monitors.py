"""Monitors of a run of the simulator: check, step by step, ready properties that its events do not decide."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import deepcopy
from typing import Any, Protocol

from kitrobot.sim.physics.docks import carrier_in
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.sim.tables import team_columns as tc
from kitrobot.trace.source import ENDED
from kitrobot.verifier.model.absence import gave_up
from kitrobot.verifier.model.stops import stops_in

ENDS_IN_VAIN = ("stuck", "time")
"""The outcomes of a run in which nothing more came."""
LONG_ENOUGH = 2
"""A run whose time is up shows that something is waited for in vain if it was for one part of so many of its time."""


class RunMonitor(Protocol):
    """Monitors a run of the simulator for a violation of a property."""

    @property
    def is_kept(self) -> bool:
        """Whether nothing that may come breaks it."""

    @property
    def is_decided_at_beginning(self) -> bool:
        """Whether it was decided before the first step, by what was true then."""

    @property
    def is_vacuous(self) -> bool:
        """Whether what the property is about did not come yet."""

    def after_step(self) -> bool:
        """Whether the step that was just made broke it."""

    def at_end(self, outcome: str) -> bool:
        """Whether the run broke it if it ends here with this outcome."""

    def memory(self) -> Any:
        """What it remembers of the run so far, as a copy."""

    def remember(self, memory: Any) -> None:
        """Goes back to what `memory` gave, as the run goes back to its state then."""


class _InvariantMonitor:
    """Reports a violation when a condition holds once; `own` are the lists in which the condition remembers."""

    is_kept = False
    is_decided_at_beginning = False
    is_vacuous = False

    def __init__(self, test: Callable[[], bool], *own: list[Any]) -> None:
        self._test = test
        self._own = own

    def after_step(self) -> bool:
        return self._test()

    def at_end(self, outcome: str) -> bool:
        return False

    def memory(self) -> Any:
        return deepcopy(self._own)

    def remember(self, memory: Any) -> None:
        for mine, kept in zip(self._own, deepcopy(memory), strict=True):
            mine[:] = kept


class _WaitMonitor:
    """Reports a violation when a condition holds up to the end of the run, long enough, and the run ends with one of
    these outcomes.
    """

    is_kept = False
    is_decided_at_beginning = False
    is_vacuous = False

    def __init__(self, run: Simulation, test: Callable[[], bool], outcomes: Sequence[str] = ENDED) -> None:
        self._run = run
        self._test = test
        self._outcomes = outcomes
        self._since = -1

    def after_step(self) -> bool:
        if not self._test():
            self._since = -1
        elif self._since < 0:
            self._since = self._run.tick
        return False

    def at_end(self, outcome: str) -> bool:
        is_in_vain = self._since >= 0 and outcome in self._outcomes
        return is_in_vain and waited_long_enough(outcome, self._run.tick, self._since)

    def memory(self) -> Any:
        return self._since

    def remember(self, memory: Any) -> None:
        self._since = memory


def waited_long_enough(outcome: str, tick: int, since: int) -> bool:
    """Whether a run that ended at a tick shows that what was waited for since another one would never have come."""
    return outcome != "time" or LONG_ENOUGH * (tick - since) >= tick


def loss_monitor(run: Simulation) -> RunMonitor:
    """Monitors for a box without room, or a unit of work whose robot ended its program without doing it."""

    def is_lost() -> bool:
        state = run.state
        ints, team = state.robots.ints, state.team
        rows = list(zip(ints[c.DOWN], ints[c.ENDED], strict=True))
        if any(origin < 0 for origin in ints[c.ORIGIN]):
            return True
        return any(
            one == tc.HAS_UNIT and not lease and ended and down != c.FAILED
            for holds, lease in zip(team.holds, team.works[tc.W_LEASE], strict=False)
            for one, (down, ended) in zip(holds, rows, strict=False)
        )

    return _InvariantMonitor(is_lost)


def meeting_monitor(run: Simulation, name: str) -> RunMonitor:
    """Monitors whether an agent waits for its team up to the end."""
    robot = [agent.name for agent in run.members].index(name)

    def waits() -> bool:
        ints, team = run.state.robots.ints, run.state.team
        is_waiting = team.robots[tc.T_AT][robot] >= 0 and team.robots[tc.T_ROLE][robot] >= 0
        return bool(is_waiting and ints[c.DOWN][robot] == c.WELL and not gave_up(team))

    return _WaitMonitor(run, waits)


def service_monitor(run: Simulation, name: str, docks: Sequence[int]) -> RunMonitor:
    """Monitors whether a carrier stands in one of these docks up to the end of a run that is stuck or out of time."""
    robot = [agent.name for agent in run.members].index(name)

    def is_in_dock() -> bool:
        state = run.state
        ints = state.robots.ints
        return (
            not ints[c.ENDED][robot]
            and ints[c.DOWN][robot] != c.FAILED
            and any(carrier_in(dock, state.robots, state.roads, state.docks) == robot for dock in docks)
        )

    return _WaitMonitor(run, is_in_dock, ENDS_IN_VAIN)


def loose_action_monitor(run: Simulation) -> RunMonitor:
    """Monitors whether a program has ended and an action that it marked goes on.

    The run is before its first step.
    """
    # A marked action may begin and end in one tick: nothing is armed before it or after it, but its instruction ran.
    run.watch_programs()
    before = [list(agent.machine.pars) for agent in run.members]
    loose = [0] * len(run.members)

    def goes_on() -> bool:
        found = False
        for i, agent in enumerate(run.members):
            stopped, left = stops_in(before[i], agent.machine)
            loose[i] = loose[i] & ~stopped | left
            before[i] = list(agent.machine.pars)
            found = found or (loose[i] > 0 and agent.ended and run.state.robots.ints[c.DOWN][i] != c.FAILED)
        return found

    return _InvariantMonitor(goes_on, before, loose)
