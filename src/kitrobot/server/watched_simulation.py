"""A simulated run for the page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from kitrobot.diagnostics import Diagnostic
from kitrobot.mission import Mission
from kitrobot.server.watched_run import WatchedRun
from kitrobot.sim import SimulationSource, record_again
from kitrobot.workspace import PreparedRun, advice, parts_of


class WatchedSimulation(WatchedRun):
    """One simulation of a mission.

    Raises:
        ConditionError: the condition of a breakpoint cannot be understood.
    """

    def __init__(self, prepared: PreparedRun) -> None:
        simulation = prepared.simulation
        self._prepared = prepared
        self._run = SimulationSource(simulation)
        super().__init__(self._run, simulation.world, simulation.members, self.mission.breakpoints)

    @property
    def mission(self) -> Mission:
        """What runs."""
        return self._prepared.opened.mission

    @property
    def advice(self) -> list[Diagnostic]:
        """Hints on a run that ended before anything could be seen."""
        return advice(self._prepared.opened, self._run.simulation)

    def record_to(self, path: Path, stop: Callable[[], bool] = lambda: False) -> None:
        """As `WatchedRun.record_to`."""
        record_again(self._run.timeline, self._prepared.again(), path, parts_of(self._prepared.opened), stop)
