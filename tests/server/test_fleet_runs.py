"""A team of processes in the studio: started, told like every run, stopped, and what goes wrong with it."""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from kitrobot.boards.teams import agent_program
from kitrobot.deploy.errors import ForeignError
from kitrobot.live.robot_gateway import SerialGateway
from kitrobot.text.sentences import Sentence
from kitrobot.trace.reader import TraceReader
from kitrobot.workspace.mission_loader import open_mission
from tests.boards.host import board_with
from tests.boards.proxy import Proxy
from tests.fleet.short_convoy import NAMES, write_short_convoy
from tests.fleet.test_processes import is_there
from tests.patience import PATIENCE_S
from tests.server.conftest import HOST, SOCKET, TOKEN, TestClient
from tests.server.pages import ADDRESS, Page, RunPage

PATH = "convoy.krt"


class TeamPage(Page):
    """A page that has the convoy open."""

    def ask(self, kind: str, **more: Any) -> None:
        self.socket.send_text(json.dumps({"type": kind, "mission": self.mission, "path": PATH, **more}))

    def team(self, wanted: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        """The next message of the team for which `wanted` holds."""
        return self.until("team", wanted)

    @contextlib.contextmanager
    def fleet(self, boards: Any = (), **more: Any) -> Iterator[RunPage]:
        """Starts the team as a run. `boards`: their addresses by agents, or what stands in their place."""
        with self.client.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}") as socket:
            run = RunPage(socket)
            wanted = boards
            if isinstance(boards, dict):
                wanted = [{"agent": agent, "address": address} for agent, address in boards.items()]
            request = {"mission": self.mission, "path": PATH, "holder": self.you, "speed": 1, "seed": 1}
            run.send(**{"type": "fleet", **request, "boards": wanted, **more})
            yield run


@pytest.fixture
def convoy(folder: Path) -> Path:
    """The short convoy in the studio's folder."""
    return write_short_convoy(folder)


@pytest.fixture
def visit(app, convoy: Path) -> Iterator[Callable[..., Any]]:
    """Opens a page of this studio on the convoy, here or on the machine of an address."""
    team = app.state.studio.boards.team
    team.pace = 4.0
    with ExitStack() as stack:
        clients: dict[str, TestClient] = {}

        @contextlib.contextmanager
        def visit(host: str = "127.0.0.1") -> Iterator[TeamPage]:
            if host not in clients:
                made = TestClient(app, base_url=HOST, headers={"X-KitRobot-Token": TOKEN}, client=(host, 50000))
                if clients:
                    # A studio has one event loop, whoever visits it.
                    made.portal = next(iter(clients.values())).portal
                clients[host] = made if clients else stack.enter_context(made)
            mission = clients[host].get(f"/api/mission?path={PATH}").json()["mission"]
            with clients[host].websocket_connect(ADDRESS) as socket:
                yield TeamPage(socket, mission, clients[host])

        yield visit
    team.end()


def processes(app: Any) -> dict[str, int]:
    """The processes of agents, by name."""
    fleet = app.state.studio.boards.team._fleet
    return {name: one.pid for name, one in fleet.agents.processes.items()}


def ended(app: Any, pids: dict[str, int]) -> bool:
    """Whether the team has ended, and nothing of it is left."""
    app.state.studio.boards.team.end()
    return not any(map(is_there, pids.values())) and not app.state.studio.boards.team.addresses


@pytest.mark.slow
def test_it_is_a_run_like_any_other_and_goes_on_without_an_agent_that_is_killed(visit, app, tmp_path: Path) -> None:
    team = app.state.studio.boards.team
    # Only the killed agent is silent for so long, on a busy machine too.
    team.lease_ms = 4000
    with ExitStack() as stack:
        page, other, away = (stack.enter_context(visit(*host)) for host in ((), (), ("192.168.1.7",)))
        demand = {"name": "far", "form": "never", "first": "any robot-1 (Captor.GreaterThan(0))"}
        page.mission["properties"] = [demand]
        run = stack.enter_context(page.fleet())
        begun = run.until("started")
        assert [agent["name"] for agent in begun["agents"]] == NAMES
        assert all(agent["placed"] for agent in begun["agents"])
        assert (begun["fleet"], begun["recording"], begun["abilities"]) == (True, False, ["seek", "step"])
        page.team(lambda said: said["phase"] == "running" and {one["state"] for one in said["agents"]} == {"there"})
        # A property that breaks is an event while the run goes on.
        while not any("property far is broken" in event["text"] for event in run.until("tick")["events"]):
            pass
        with other.fleet() as second:
            assert "runs a team already" in second.until("error", ended=True)["message"]
        other.ask("team-send", boards=[{"agent": "robot-1", "address": "socket://127.0.0.1:1"}])
        assert "runs a team already" in other.until("refused", lambda said: said["address"] == "team")["message"]
        with away.fleet() as refused:
            assert "another machine" in refused.until("error", ended=True)["message"]
        with away.client.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}") as line:
            watcher = RunPage(line)
            watcher.send(type="watch", run=begun["run"], mission=page.mission)
            assert (shown := watcher.until("started"))["watching"]
            assert shown["fleet"]
            assert not shown["another"]
            watcher.send(type="stop")
            assert "steers it" in watcher.until("error")["message"]
        run.report(lambda said: bool(said["active"]), "robot-1")
        run.send(type="force", agent="robot-1", sensor="Bumper", value=1)
        assert "process of its own" in run.until("error")["message"]
        pids = processes(app)
        os.kill(pids["robot-2"], signal.SIGKILL)
        page.team(lambda said: said["agents"][1]["state"] == "ended" and "status -9" in said["agents"][1]["message"])
        run.send(type="pause")
        at = run.until("state", status="paused")["tick"]
        while run.until("tick", tick=at)["latest"] < at + 50:
            pass
        run.send(type="seek", tick=0)
        assert run.until("state", tick=0)["status"] == "paused"
        run.send(type="resume", latest=True)
        assert run.until("state", status="running")["tick"] >= at + 50
        while (told := run.until("state"))["status"] in ("running", "paused"):
            pass
        assert told["sentence"].startswith("Done after")
        answer = page.client.get("/api/run/trace", params={"run": begun["run"]})
        path = tmp_path / "run.krtrace"
        path.write_bytes(answer.content)
        with TraceReader(path) as recorded:
            texts = [event.text for _, event in recorded.events]
            assert (recorded.outcome["outcome"], recorded.header.real, recorded.cut) == ("done", False, False)
        assert "takes over for robot-2" in texts
        assert texts.count("the property far is broken") == 1
        assert "is missed by its team" in texts
        page.team(lambda said: said["phase"] == "idle")
        run.send(type="seek", tick=5)
        assert run.until("state", tick=5)["status"] == "paused"
        assert ended(app, pids)


@pytest.mark.slow
def test_no_agent_outlives_its_page_that_is_gone_while_they_still_come(visit, app) -> None:
    with visit() as page:
        with page.fleet() as run:
            run.until("started")
            page.team(lambda said: said["phase"] in ("starting", "running"))
        page.team(lambda said: said["phase"] in ("stopping", "idle"))
        assert ended(app, {})
        assert app.state.studio.runs == 0


@pytest.mark.slow
def test_a_pulled_cable_and_a_board_of_another_program_are_told_beside_their_agents_and_stop_reaches_all(
    visit, convoy, app
) -> None:
    once, often = (f'<set name="count">{count}</set>' for count in (1, 1000))
    # However late the stop comes, the team is still at it.
    convoy.write_text(convoy.read_text("utf-8").replace(once, often), "utf-8")
    opened = open_mission(convoy)
    with ExitStack() as stack:
        boards = {
            name: stack.enter_context(board_with(agent_program(opened, name).file.to_bytes()))
            for name in ("robot-2", "robot-4")
        }
        cable = stack.enter_context(Proxy(int(boards["robot-2"].address.rpartition(":")[2]), cut_after=90))
        page, other = stack.enter_context(visit()), stack.enter_context(visit())
        with page.fleet({"robot-2": cable.address, "robot-4": boards["robot-4"].address}) as run:
            page.team(lambda said: said["phase"] == "running")
            page.send("connect", cable.address, mission=page.mission, path=PATH, program="convoy")
            assert "The team has" in page.until("refused")["message"]
            lost = page.team(lambda said: said["agents"][1]["failed"])
            # On a slow machine the board misses its link before the agent misses the line.
            assert re.search("the line to|the link was lost", lost["agents"][1]["message"].lower())
            events: list[dict[str, Any]] = []
            while not any("takes over for robot-2" in event["text"].lower() for event in events):
                events += run.until("tick")["events"]
            stop_of_another_window_reaches_every_agent(page, other, run, app)
        for program in page.mission["programs"]:
            for vertex in program["vertices"]:
                for name, value in vertex["settings"].items():
                    if value == "10":
                        vertex["settings"][name] = "11"
        with page.fleet({"robot-4": boards["robot-4"].address}) as run:
            failed = run.until("state", status="failed")
            assert failed["sentence"].startswith("Robot-4: the board on")
            told = page.team(lambda said: said["phase"] == "idle" and said["failed"])
            assert "press Send to all" in told["agents"][2]["help"].replace("Press", "press")
        assert ended(app, {})


def stop_of_another_window_reaches_every_agent(page: TeamPage, other: TeamPage, run: RunPage, app: Any) -> None:
    pids = processes(app)
    other.send("stop", "")
    assert run.until("state", status="stopped")
    # Only the newest state is told: that all stand still may come with the end.
    said = page.team(lambda said: said["phase"] == "idle" and said["stopped_ms"] is not None)
    assert f"stood still within {said['stopped_ms']} ms" in said["message"]
    assert ended(app, pids)


class Sending(SerialGateway):
    """Robots that take every program but one, which is somebody else's."""

    def __init__(self) -> None:
        self.sent: list[str] = []
        self.goes_on = threading.Event()
        self.goes_on.set()

    def deploy(self, address: str, program: Any, progress: Any, replace: bool, fresh: bool) -> None:
        progress("send", 10, 20)
        self.goes_on.wait(PATIENCE_S)
        progress("send", 20, 20)
        if address.endswith(":2") and not replace:
            raise ForeignError(
                Sentence("holds a main.py that is not KitRobot's"), Sentence("save it, or take --replace")
            )
        self.sent.append(address)


def test_programs_are_sent_to_all_boards_or_it_is_told_why_not(visit, app) -> None:
    room = app.state.studio.boards
    links = room.links = Sending()
    links.goes_on.clear()
    two = [{"agent": "robot-1", "address": "socket://h:1"}, {"agent": "robot-2", "address": "socket://h:2"}]
    with visit() as page:
        page.ask("team-send", boards=two)
        page.team(lambda said: any((one["progress"] or {}).get("total") == 20 for one in said["agents"]))
        links.goes_on.set()
        said = page.team(lambda said: said["phase"] == "idle" and said["failed"])
        assert said["message"] == "No robot of the team is started, since this failed: robot-2."
        assert "is already on the boards of these, where it waits: robot-1" in said["help"]
        assert [(one["state"], one["way"]) for one in said["agents"][:2]] == [("sent", ""), ("idle", "replace")]
        assert "press Replace it" in said["agents"][1]["help"]
        page.ask("team-send", boards=[two[0], {**two[1], "way": "replace"}])
        said = page.team(lambda said: said["phase"] == "idle" and not said["failed"])
        assert said["message"] == "All boards have their programs."
        assert sorted(links.sent) == ["socket://h:1", "socket://h:1", "socket://h:2"]
        links.goes_on.clear()
        page.ask("team-send", boards=two)
        page.team(lambda said: said["phase"] == "sending" and said["agents"][0]["progress"] is not None)
        page.ask("team-send", boards=two)
        assert "sending to a team already" in page.until("refused")["message"]
        page.ask("team-cancel")
        page.ask("team-send", boards=two)
        page.until("refused")
        links.goes_on.set()
        assert page.team(lambda said: said["phase"] == "idle")["message"] == "The sending was broken off."
        for boards, words in (
            ([], "no agent of this team has a board"),
            ([{"agent": "robot-9", "address": "socket://h:1"}], "no agent `robot-9`"),
            ([two[0], {**two[1], "address": "socket://h:1"}], "both given the board"),
            ([{**two[0], "address": "/etc/passwd"}], "there is no robot at"),
            ([{"agent": 3}], "not understood"),
            ([two[0]] * 65, "not understood"),
        ):
            page.ask("team-send", boards=boards)
            assert words in page.until("refused")["message"].replace("No agent", "no agent").replace("There", "there")
        page.mission["programs"][0]["arcs"] = []
        page.ask("team-send", boards=two)
        said = page.team(lambda said: said["phase"] == "idle" and said["failed"])
        assert said["message"].startswith("Nothing was sent, since this failed: robot-1")
        assert not room.team.addresses


def test_a_team_that_cannot_be_started_is_told_in_a_sentence(visit, app, monkeypatch) -> None:
    with visit() as page:
        for boards, words in (
            ({"robot-9": "socket://h:1"}, "no agent `robot-9`"),
            ({"robot-1": "file:///etc/passwd"}, "no robot at"),
        ):
            with page.fleet(boards) as run:
                assert words in run.until("error", ended=True)["message"]
        for odd in ("x", [{"agent": "robot-1"}], None):
            with page.fleet(odd) as run:
                assert "not understood" in run.until("error")["message"]
        whole = page.mission["programs"][0]["arcs"]
        page.mission["programs"][0]["arcs"] = []
        with page.fleet() as run:
            assert run.until("problems")["problems"]
        page.mission["programs"][0]["arcs"] = whole
        monkeypatch.setattr("kitrobot.live.run_sources.find_spec", lambda name: None)
        with page.fleet() as run:
            assert "eclipse-zenoh" in run.until("error", ended=True)["message"]
    assert ended(app, {})
