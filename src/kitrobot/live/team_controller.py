"""The team of one studio: which agents have boards, sending to all of them, and the fleet that runs.

There is one at a time: while programs are sent, or a fleet runs or ends, nobody begins another, and the boards in it
are nobody else's. The status that pages see is one value that is replaced as a whole (`status`); threads change it, and
the server's event loop sends it. Not here: the fleet itself (watched_fleet), single robots (robot_registry).
"""

from __future__ import annotations

import asyncio
import contextlib
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Protocol, get_args

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.background import run_in_background
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence
from kitrobot.wire.board import (
    BoardProgressShape,
    BoardStep,
    BoardWay,
    TeamAgentShape,
    TeamAgentState,
    TeamBoardShape,
    TeamMessage,
)

if TYPE_CHECKING:
    from kitrobot.live.robot_gateway import RobotGateway
    from kitrobot.robots.program import BoardProgram
    from kitrobot.workspace.mission_loader import OpenMission

STEPS: tuple[BoardStep, ...] = get_args(BoardStep)
END_WITHIN_S = 8.0
"""How long a fleet that was stopped may take until all its processes have ended."""
TEAM = "team"
"""The address of what is refused to a team."""


class TeamBusyError(KitRobotError):
    """The studio has a team already."""


class _CancelledError(Exception):
    """The sending was broken off by the person."""


@dataclass(frozen=True)
class AgentStatus:
    """The status of an agent; as `TeamAgentShape`."""

    name: str
    address: str = ""
    state: TeamAgentState = "idle"
    progress: BoardProgressShape | None = None
    message: str = ""
    help: str = ""
    way: BoardWay = ""
    failed: bool = False


@dataclass(frozen=True)
class TeamStatus:
    """The status of the team; as `TeamMessage`."""

    phase: Literal["idle", "sending", "starting", "running", "stopping"] = "idle"
    path: str = ""
    agents: tuple[AgentStatus, ...] = ()
    message: str = ""
    help: str = ""
    failed: bool = False
    stopped_ms: int | None = None


class TeamHost(Protocol):
    """Where a team is: the robots of a studio, as far as a team needs them."""

    links: RobotGateway
    in_page: bool

    def notify_team_changed(self) -> None:
        """Sends all pages the status of the team."""

    async def release_board(self, holder: str, address: str) -> None:
        """Releases the robot at an address from any page."""


class Fleet(Protocol):
    """A team that runs as processes."""

    def stop(self) -> None:
        """The emergency stop, from any thread."""

    def wait(self, within_s: float) -> None:
        """Waits until it has ended, but not for ever."""


class TeamController:
    """The team of a studio.

    `pace`: of its world against real time; `lease_ms`: how long an agent may be silent.
    """

    def __init__(self, host: TeamHost) -> None:
        self.pace = 1.0
        self.lease_ms = 1000
        self.status = TeamStatus()
        self.addresses: frozenset[str] = frozenset()
        """Boards that belong to the team now."""
        self._host = host
        self._lock = threading.Lock()
        self._claimed = False
        self._cancelled = False
        self._fleet: Fleet | None = None
        self._loop: asyncio.AbstractEventLoop | None = None

    # -- the status that pages see

    def text(self) -> str:
        """The status of the team, encoded in the reader's language."""
        now = self.status
        return TeamMessage(
            phase=now.phase,
            path=now.path,
            agents=[TeamAgentShape(**vars(one)) for one in now.agents],
            message=now.message,
            help=now.help,
            failed=now.failed,
            stopped_ms=now.stopped_ms,
        ).model_dump_json()

    def update(self, **changes: Any) -> None:
        """Changes the status of the team; from any thread."""
        self._change(lambda now: replace(now, **changes))

    def update_agent(self, name: str, **changes: Any) -> None:
        """Changes the status of an agent; from any thread."""
        self._change(
            lambda now: replace(
                now, agents=tuple(replace(one, **changes) if one.name == name else one for one in now.agents)
            )
        )

    def report_agent(self, name: str, sentence: str, ended: bool = False) -> None:
        """Shows a sentence of a fleet's log about an agent, or that its process has ended; from any thread.

        Once an agent has failed or ended, its message stays.
        """

        def updated(one: AgentStatus) -> AgentStatus:
            settled = one.failed or one.state == "ended"
            return replace(one, message=one.message if settled else sentence, state="ended" if ended else one.state)

        self._change(
            lambda now: replace(now, agents=tuple(updated(one) if one.name == name else one for one in now.agents))
        )

    def _change(self, change: Callable[[TeamStatus], TeamStatus]) -> None:
        with self._lock:
            before, self.status = self.status, change(self.status)
        self._notify_if_changed(before)

    def _notify_if_changed(self, before: TeamStatus) -> None:
        if self._loop is not None and self.status != before:
            with contextlib.suppress(RuntimeError):  # the studio has ended meanwhile
                self._loop.call_soon_threadsafe(self._host.notify_team_changed)

    # -- claiming and releasing

    async def claim(
        self, holder: str, opened: OpenMission, path: str, wanted: Sequence[TeamBoardShape]
    ) -> Mapping[str, str]:
        """Takes the studio's team for a page, and the boards of its agents from whoever let them go or holds them here.

        Returns:
            The addresses of agents with boards.

        Raises:
            KitRobotError: the studio has a team already, there is no such agent or board, or another page has a board.
        """
        from kitrobot.boards.teams import check_boards

        if self._host.in_page:
            raise TeamBusyError(
                Sentence("a team as processes cannot run in a page"),
                Sentence("run it as a simulation here, or install KitRobot on this computer"),
            )
        if self._claimed and self._fleet is not None and self.status.phase == "stopping":
            # Its page is gone; a page that was loaded again asks before all is done.
            await run_in_background(self._fleet.wait, END_WITHIN_S)
        if self._claimed:
            doing = self.status.phase
            raise TeamBusyError(
                Sentence("this studio is sending to a team already")
                if doing == "sending"
                else Sentence("this studio runs a team already"),
                Sentence("wait for it, or break it off")
                if doing == "sending"
                else Sentence("stop it first: STOP reaches it from every window of this studio"),
            )
        self._claimed, self._cancelled = True, False
        self._loop = asyncio.get_running_loop()
        try:
            names = [agent.name for agent in opened.mission.team.agents]
            boards = check_boards(((one.agent, one.address) for one in wanted), names)
            for address in boards.values():
                await self._host.release_board(holder, address)
            self.addresses = frozenset(boards.values())
        except BaseException:
            self._claimed = False
            raise
        agents = tuple(AgentStatus(name, boards.get(name, "")) for name in names)
        self.update(**vars(TeamStatus(path=path, agents=agents)))
        return boards

    def release(self, **changes: Any) -> None:
        """Releases the team, with these changes of its status; from any thread."""
        with self._lock:
            before = self.status
            agents = tuple(
                one if one.state in ("ended", "sent") else replace(one, state="idle") for one in before.agents
            )
            self.status = replace(before, phase="idle", agents=agents, **changes)
            self.addresses = frozenset()
            self._fleet = None
            # A page that is notified may claim the team at once.
            self._claimed = False
        self._notify_if_changed(before)

    # -- sending

    async def send(
        self, holder: str, opened: OpenMission, path: str, wanted: Sequence[TeamBoardShape], folder: Path
    ) -> None:
        """Begins to send the programs of agents to their boards, all at once; `folder`: where drivers may lie.

        Raises:
            KitRobotError: as `claim`, or no agent has a board.
        """
        if not wanted:
            raise TeamBusyError(
                Sentence("no agent of this team has a board"), Sentence("choose one for an agent, then send")
            )
        boards = await self.claim(holder, opened, path, wanted)
        ways = {one.agent: one.way for one in wanted}
        self.update(phase="sending")
        for name in boards:
            self.update_agent(name, state="sending")
        threading.Thread(
            target=self._send, args=(opened, boards, ways, folder), name="sends to a team", daemon=True
        ).start()

    def cancel(self) -> None:
        """Cancels sending."""
        self._cancelled = True

    def _send(self, opened: OpenMission, boards: Mapping[str, str], ways: Mapping[str, BoardWay], folder: Path) -> None:
        result: dict[str, Any] = {}
        try:
            programs = self._programs(opened, boards, folder)
            if len(programs) == len(boards):
                with ThreadPoolExecutor(len(boards)) as threads:
                    list(
                        threads.map(lambda name: self._send_to(name, boards[name], programs[name], ways[name]), boards)
                    )
            result = self._sending_result(sent=len(programs) == len(boards))
        finally:
            self.release(**result)

    def _programs(self, opened: OpenMission, boards: Mapping[str, str], folder: Path) -> dict[str, BoardProgram]:
        from kitrobot.boards.teams import agent_program

        found = {}
        for name in boards:
            try:
                found[name] = agent_program(opened, name, folder)
            except KitRobotError as error:
                self._fail(name, error)
        return found

    def _send_to(self, name: str, address: str, program: BoardProgram, way: BoardWay) -> None:
        def progress(step: str, done: int, total: int) -> None:
            if self._cancelled:
                raise _CancelledError
            if step in STEPS:
                self.update_agent(name, progress=BoardProgressShape(step=step, done=done, total=total))

        try:
            self._host.links.deploy(address, program, progress, way == "replace", way == "fresh")
        except _CancelledError:
            kept = Sentence("the robot still has the program that it had")
            self.update_agent(
                name, state="idle", progress=None, message=Sentence("the sending was broken off"), help=kept
            )
        except (KitRobotError, OSError) as error:
            self._fail(name, error)
        else:
            self.update_agent(name, state="sent", progress=None, message="", help="", failed=False)

    def _fail(self, name: str, error: KitRobotError | OSError) -> None:
        from kitrobot.live.robot_status import no_answer_error, recovery_hint

        said = error if isinstance(error, KitRobotError) else no_answer_error(name)
        self.update_agent(
            name,
            state="idle",
            progress=None,
            message=said.message,
            help=recovery_hint(said),
            way=self._host.links.way(said),
            failed=True,
        )

    def _sending_result(self, sent: bool) -> dict[str, Any]:
        agents = [one for one in self.status.agents if one.address]
        failed = [one.name for one in agents if one.failed]
        if failed:
            return {
                "failed": True,
                "message": Sentence("no robot of the team is started, since this failed: {names}", listed(failed))
                if sent
                else Sentence("nothing was sent, since this failed: {names}", listed(failed)),
                "help": Sentence(
                    "mend what stands beside it, then send again; the new program is already on the boards of these,"
                    " where it waits: {names}",
                    listed(has),
                )
                if (has := [one.name for one in agents if one.state == "sent"])
                else Sentence("what each says stands beside it; mend that, then send again"),
            }
        if any(one.state != "sent" for one in agents):
            return {"message": Sentence("the sending was broken off"), "help": ""}
        return {"message": Sentence("all boards have their programs"), "help": ""}

    # -- the fleet

    def runs(self, fleet: Fleet) -> None:
        """Makes this fleet the team until it has ended."""
        self._fleet = fleet
        self.update(phase="starting")
        for one in self.status.agents:
            self.update_agent(one.name, state="starting")

    def stop(self) -> None:
        """The emergency stop, from any page; it also cancels sending."""
        self._cancelled = True
        if self._fleet is not None:
            self._fleet.stop()

    def end(self) -> None:
        """Ends the team with the studio."""
        fleet = self._fleet
        if fleet is not None:
            fleet.stop()
            fleet.wait(END_WITHIN_S)
