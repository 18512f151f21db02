"""A team of processes for the page: started in a thread, shown like a simulated run, and ended with the page.

The agents are processes; the world of their bodies and what watches over them is a thread here (`fleet.TeamProcess`).
A studio that is killed takes its agents along: they read an input that ends with it. What they read besides is laid out
in a temporary folder, since the page may have changes that no file has; it goes when the run is over and nobody looks
at it.
"""

from __future__ import annotations

import logging
import os
import tempfile
import threading
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.fleet.identity import identity_of
from kitrobot.fleet.processes import Agents
from kitrobot.fleet.run_source import FleetSource
from kitrobot.fleet.status_reports import StatusReport
from kitrobot.fleet.team_process import FleetCallbacks, FleetRun
from kitrobot.fleet.transport import Network
from kitrobot.judges.fleet_watch import FleetWatch
from kitrobot.live.robot_status import recovery_hint
from kitrobot.live.team_controller import TeamController
from kitrobot.live.watched_recording import WatchedRecords
from kitrobot.mission.model import Mission
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence
from kitrobot.trace.layout import ENDING
from kitrobot.workspace.fleets import FleetPlan, files_for_agents, free_endpoint, run_fleet
from kitrobot.workspace.mission_run import PreparedRun
from kitrobot.workspace.traces import parts_of

BOARD_LEASE_MS = 2000
"""How long silence is borne at least where a board is in the team: a small one is slow."""

_log = logging.getLogger("kitrobot.server")


class FleetThread:
    """A fleet from its start to its end. `changed` is called from its thread at each step.

    Raises:
        TraceError: its run cannot be recorded.
        JudgeError: a robot of it is not known.
    """

    def __init__(
        self,
        room: TeamController,
        prepared: PreparedRun,
        boards: Mapping[str, str],
        drivers: Path,
        changed: Callable[[], None],
    ) -> None:
        self._team = room
        self._prepared = prepared
        self._boards = boards
        self._drivers = drivers if boards else None
        self._changed = changed
        self._pressed = threading.Event()
        self._closed = threading.Event()
        self._over = threading.Event()
        self._folder = tempfile.TemporaryDirectory(prefix="kitrobot-", ignore_cleanup_errors=True)
        self._cleaning = threading.Lock()
        self.agents = Agents(self._on_agent_report)
        try:
            trace = Path(self._folder.name) / f"run{ENDING}"
            self.source = FleetSource(prepared.simulation, trace, parts_of(prepared.opened), self.stop)
            if prepared.opened.mission.properties:
                watch = FleetWatch(self.source.header, prepared.opened, (), self._on_broken)
                self.source.on_record = watch.after_step
        except BaseException:
            self._folder.cleanup()
            raise
        self._thread = threading.Thread(target=self._run, name="team", daemon=True)

    def start(self) -> None:
        """Starts it."""
        self._team.runs(self)
        self._thread.start()

    def stop(self) -> None:
        """The emergency stop, from any thread; everything ends then."""
        self._pressed.set()
        if self._thread.is_alive():
            self._team.update(phase="stopping")

    def wait(self, within_s: float) -> None:
        """Waits until it has ended, but not for ever."""
        if self._thread.is_alive():
            self._thread.join(within_s)

    def close(self) -> None:
        """No page shows it any more."""
        self._closed.set()
        self._clean()

    def _clean(self) -> None:
        with self._cleaning:
            if self._closed.is_set() and self._over.is_set():
                self._folder.cleanup()

    # -- its thread

    def _run(self) -> None:
        outcome, sentence = "failed", ""
        try:
            with self.agents:
                run = self._start_fleet()
                outcome, sentence = run.outcome, run.sentence
                self._report_end(run)
                self.source.finish(outcome, sentence)
                self._changed()
        except KitRobotError as error:
            sentence = self._start_failure(error)
            self._team.update(message=sentence, help=recovery_hint(error), failed=True)
        except Exception as error:
            debugging = bool(os.environ.get("KITROBOT_DEBUG"))
            _log.error("a team broke: %s: %s", type(error).__name__, error, exc_info=debugging)
            sentence = Sentence("something went wrong inside KitRobot")
            self._team.update(message=sentence, help=Sentence("the run has ended; please report it"), failed=True)
        finally:
            if not self.source.has_ended:
                self.source.finish("stopped" if self._pressed.is_set() else outcome, sentence)
            self._team.release()
            self._over.set()
            self._clean()
            self._changed()

    def _start_fleet(self) -> FleetRun:
        prepared = self._prepared
        simulation = prepared.simulation
        folder = Path(self._folder.name) / "mission"
        folder.mkdir()
        file = files_for_agents(prepared.opened, self.source.header, folder, self._drivers)
        names = [agent.name for agent in simulation.members]
        network = Network(identity_of(simulation), (free_endpoint(),))
        lease = max(self._team.lease_ms, BOARD_LEASE_MS if self._boards else 0)
        plan = FleetPlan(file, names, network, None, self._boards, lease, self._team.pace)
        told = FleetCallbacks(
            self._on_log_line,
            self._pressed.is_set,
            lambda now: self._on_step(),
            self._on_agent_joined,
            self._on_agent_ended,
        )
        return run_fleet(simulation, plan, self.agents, told)

    def _on_step(self) -> None:
        self.source.step()
        if self._team.status.phase == "starting":
            self._team.update(phase="running", message="")
        self._changed()

    def _on_agent_joined(self, name: str) -> None:
        self._team.update_agent(name, state="there")

    def _on_log_line(self, name: str, sentence: str) -> None:
        """A line of the team's log."""
        if name:
            self._team.report_agent(name, sentence)
        else:
            self._team.update(message=sentence)

    def _on_broken(self, sentence: Sentence) -> None:
        """A property of the mission is broken: it is an event of the run, and the status of the team."""
        self._team.update(message=sentence)

    def _on_agent_report(self, name: str, told: StatusReport) -> None:
        """A report of an agent, in a thread of its own."""
        if told.failed:
            self._team.update_agent(name, message=told.sentence, help=_help(told), failed=True)
        else:
            self._team.report_agent(name, told.sentence)

    def _on_agent_ended(self, name: str, sentence: str) -> None:
        """An agent's process has ended, and all its reports were read."""
        self._team.report_agent(name, sentence, ended=True)

    # -- the result

    def _start_failure(self, error: KitRobotError) -> str:
        """Why the run did not begin: the agents' own reports, if there are any."""
        failed = [one for one in self._team.status.agents if one.failed]
        if not failed:
            return error.message
        if len(failed) == 1:
            return Sentence("{agent}: {why}", failed[0].name, failed[0].message)
        return Sentence("the team was not started, since this failed: {names}", listed(one.name for one in failed))

    def _report_end(self, run: FleetRun) -> None:
        if run.outcome != "stopped":
            self._team.update(message=run.sentence, help="", failed=False)
            return
        silent = [
            one.name for one in self._team.status.agents if one.state != "ended" and one.name not in run.stopped_ms
        ]
        ms = max(run.stopped_ms.values(), default=None)
        if silent or ms is None:
            message: str = Sentence("stopped; these did not say that they stand still: {names}", listed(silent))
        else:
            message = Sentence("stopped: all robots stood still within {ms} ms", ms)
        self._team.update(message=message if silent or ms is not None else run.sentence, help="", stopped_ms=ms)


class WatchedFleet(WatchedRecords):
    """A fleet as the page sees it; it follows the fleet until it is held, as `WatchedRobots` does. Closing it stops the
    fleet.
    """

    fleet = True

    def __init__(self, running: FleetThread, prepared: PreparedRun, mission: Mission) -> None:
        self._running = running
        self._mission = mission
        super().__init__(running.source, prepared.simulation.world, prepared.opened)
        self.follows = True

    @property
    def real(self) -> bool:
        """It goes on by itself until it has ended."""
        return not self._running.source.has_ended

    @property
    def mission(self) -> Mission:
        """What runs, as the page has it."""
        return self._mission

    def follow(self) -> Iterator[None]:
        """Shows what the team does now."""
        yield from super().follow()
        self.follows = True

    def record_to(self, path: Path, stop: Callable[[], bool] = lambda: False) -> None:
        """As `FleetSource.record_to`."""
        self._running.source.record_to(path)

    def close(self) -> None:
        """Stops the fleet, which ends in a thread of its own."""
        super().close()
        self._running.close()


def _help(report: StatusReport) -> str:
    """What to do about an agent that could not take part, for somebody with buttons and not a terminal."""
    if "`kitrobot " not in report.help:
        return report.help
    return Sentence("press Send to all, then start the team again")
