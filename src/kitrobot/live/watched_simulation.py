"""A simulated run for the page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.live.watched_run import WatchedRun
from kitrobot.mission.model import Mission
from kitrobot.sim.recorder import record_again
from kitrobot.sim.source import SimulationSource
from kitrobot.workspace.mission_run import PreparedRun
from kitrobot.workspace.run_hints import advice
from kitrobot.workspace.traces import parts_of


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
