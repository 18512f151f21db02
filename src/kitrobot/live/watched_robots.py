"""Real robots as a run for the page: shown and steered like a simulation, though they go on whatever is shown of them.

It follows the robots until it is held: paused, gone back in, or at a breakpoint, as far as what they send shows who
came where. From there it goes on at its pace, so nothing that they did is missed, or follows them again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from kitrobot.live.robot_worker import RobotWorker
from kitrobot.live.watched_recording import WatchedRecords
from kitrobot.mission.model import Mission
from kitrobot.robots.records import RecordedBoard
from kitrobot.robots.run import RobotsRun
from kitrobot.robots.session import NotConnectedError
from kitrobot.robots.state import Change, ChangeKind
from kitrobot.text.sentences import Sentence
from kitrobot.trace.writer import TraceWriter
from kitrobot.workspace.mission_loader import OpenMission


class WatchedRobots(WatchedRecords):
    """Robots by their names in the run, with the mission that their programs are of. `changed` is called from any
    thread when one of them did something.

    Raises:
        KitRobotError: what a robot has is not of that mission, or its world cannot be read.
    """

    def __init__(self, robots: Mapping[str, RobotWorker], opened: OpenMission, changed: Callable[[], None]) -> None:
        boards, world = [], opened.world
        for name, worker in robots.items():
            known = worker.session.known
            if known is None or known.recording_context is None or world is None:
                raise NotConnectedError(
                    Sentence("the robot has another program than the one that is open here"),
                    Sentence("send this one first"),
                )
            boards.append(RecordedBoard(name, known.names, known.recording_context))
        assert world is not None, "there is a robot"
        self._opened = opened
        self._changed = changed
        self._sessions = [worker.session for worker in robots.values()]
        self._robots_run = RobotsRun(boards, self._sessions, controls=list(robots.values()))
        try:
            super().__init__(self._robots_run, world, opened)
        except BaseException:
            self._robots_run.close()
            raise
        self.follows = True
        self._beginnings = self._robots_run.beginnings
        for session in self._sessions:
            session.subscribe(self._robot_changed)

    def _robot_changed(self, change: Change) -> None:
        if change.kind is not ChangeKind.QUIET:
            self._changed()

    @property
    def real(self) -> bool:
        """Real robots go on at their own pace."""
        return True

    @property
    def mission(self) -> Mission:
        """What runs."""
        return self._opened.mission

    def follow(self) -> Iterator[None]:
        """Shows what the robots do now."""
        yield from super().follow()
        self.follows = True

    def has_restarted(self) -> bool:
        """As `WatchedRun.has_restarted`; it follows the robots again."""
        before, self._beginnings = self._beginnings, self._robots_run.beginnings
        if before == self._beginnings:
            return False
        self.follows = True
        self._after_seek()
        return True

    def record_to(self, path: Path, stop: Callable[[], bool] = lambda: False) -> None:
        """Writes the stored part of its past."""
        with TraceWriter(path, self._robots_run.header) as writer:
            records = self._robots_run.records()
            for record in records:
                writer.record(record)
            outcome, sentence = self._robots_run.ending
            ticks = records[-1].tick
            writer.finish({"outcome": outcome, "sentence": sentence, "ticks": ticks, "delivered": 0, "collisions": 0})

    def close(self) -> None:
        """Ends the subscription; the robots go on."""
        for session in self._sessions:
            session.unsubscribe(self._robot_changed)
        super().close()
