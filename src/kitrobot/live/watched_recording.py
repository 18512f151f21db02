"""Runs that consist of records: a recording for the page, shown and steered like a live run.

They pause at breakpoints as far as the records show who came where (recorded_agents).
"""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterable
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.watched_run import WatchedRun
from kitrobot.mission.trial import Breakpoint
from kitrobot.text.sentences import Sentence
from kitrobot.trace.source import RecordingSource, RunSource
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.recorded_agents import recorded_agents, select_testable
from kitrobot.workspace.traces import OpenTrace
from kitrobot.world.model import World


class ReplayError(KitRobotError):
    """Something that cannot be done to a recording."""


class WatchedRecords(WatchedRun):
    """A run of which only records exist; breakpoints need `opened`, its mission with its robots."""

    def __init__(self, source: RunSource, world: World, opened: OpenMission | None) -> None:
        self._robots = {} if opened is None else opened.catalogue.robots
        self._works = [] if opened is None else opened.mission.team.works
        programs = {} if opened is None else opened.images
        self._recorded = recorded_agents(source.header, self._robots, programs, self._works)
        super().__init__(source, world, self._recorded)

    def _observe(self) -> None:
        record = self._source.record()
        for agent in self._recorded:
            agent.update(record)

    def pause_at(self, breakpoints: Iterable[Breakpoint]) -> None:
        """These are the breakpoints from now on; visits are counted anew.

        Raises:
            ConditionError: a condition cannot be understood.
            ReplayError: a condition cannot be tested here; its breakpoint pauses at each visit.
        """
        sensible, all_of_them = select_testable(breakpoints, self._source.header, self._robots, self._works)
        super().pause_at(sensible)
        if not all_of_them:
            raise ReplayError(
                Sentence(
                    "a condition of a breakpoint cannot be tested in this recording: its robot is not known as it was"
                ),
                Sentence("the recording pauses there at every visit"),
            )


class WatchedRecording(WatchedRecords):
    """Plays one recording, and closes its file when it is closed. `opened`: the mission in the recording.

    Raises:
        TraceError: the recording is damaged.
    """

    recording = True

    def __init__(self, trace: OpenTrace, opened: OpenMission | None = None) -> None:
        self._reader = trace.reader
        super().__init__(RecordingSource(self._reader), trace.world, opened)

    def record_to(self, path: Path, stop: Callable[[], bool] = lambda: False) -> None:
        """Copies the recording."""
        shutil.copyfile(self._reader.path, path)
