"""Real robots over the socket: greeted, run, watched, interfered with, stopped; and what goes wrong with them."""

from __future__ import annotations

import json
import time

import pytest

from kitrobot.deploy.firmware.ports import BOARDS_VARIABLE
from kitrobot.deploy.line.board import Hello
from kitrobot.deploy.line.news import News
from kitrobot.live.robot_gateway import SerialGateway
from kitrobot.live.robot_registry import RobotRegistry
from tests.boards.host import host_board, write_pulse


def test_a_robot_says_what_it_has(visit, robot) -> None:
    with visit() as page:
        page.give("connect", robot.address)
        said = page.board(phase="open")
        assert (said["state"], said["held"], said["program"]) == ("running", False, "pulse")
        assert (said["generation"], said["package"]) == (1, "c0ffee00")
        assert said["free"] > 100_000
        assert said["name"] == robot.address.removeprefix("socket://")
        assert said["holder"] == page.you


def test_a_held_run_goes_on_while_the_page_is_there_and_ends_with_it(visit, robot) -> None:
    with visit() as page:
        page.give("connect", robot.address)
        page.board(phase="open")
        page.send("start", robot.address, held=True)
        page.board(state="running", held=True)
        # Longer than the robot waits without hearing anything: 40 ticks of 20 ms are 0.8 seconds.
        with page.run(robot.address) as run:
            run.report(lambda said: said["values"]["Count"] >= 3)
        with page.run(robot.address) as run:
            assert run.until("state")["status"] == "running"
    with visit() as page:
        page.give("connect", robot.address)
        assert page.board(phase="open", holder=page.you)["state"] == "ready"


def test_a_free_run_goes_on_without_the_page(visit, robot) -> None:
    with visit() as page:
        page.give("connect", robot.address)
        page.send("start", robot.address, held=False)
        page.board(state="running", held=False)
    with visit() as page:
        page.give("connect", robot.address)
        assert page.board(phase="open", holder=page.you)["state"] == "running"


def test_a_robot_that_is_pulled_out_says_so_and_that_its_motors_stop(visit, robot) -> None:
    with visit() as page:
        page.give("connect", robot.address)
        page.send("start", robot.address, held=True)
        page.board(state="running", held=True)
        robot.pull()
        said = page.board(phase="lost")
        assert "motors stop within one second" in said["message"]
        assert "Reconnect" in said["help"]
        page.give("connect", robot.address)
        page.board(phase="closed")


def test_a_fault_is_told_with_its_vertex_and_line(visit, folder) -> None:
    mission = write_pulse(folder, broken=True)
    with host_board(mission, "pulse") as robot, visit(broken=True) as page:
        # It ran at power-on and stopped by itself before anybody came.
        page.give("connect", robot.address)
        early = page.until("board", lambda said: said["fault"] is not None)
        page.send("start", robot.address, held=True)
        late = page.until("board", lambda said: said["fault"] is not None)
        for said in (early, late):
            fault = said["fault"]
            assert (said["phase"], said["state"], said["held"]) == ("open", "fault", False)
            assert (fault["number"], fault["program"], fault["vertex"], fault["line"]) == (1, "pulse", "v3", 2)
            assert "on fire" in fault["text"]


def test_another_page_sees_the_robot_and_may_only_stop_it(visit, robot) -> None:
    with visit() as page, visit() as other:
        page.give("connect", robot.address)
        page.send("start", robot.address, held=True)
        page.board(state="running", held=True)
        seen = other.board(state="running", held=True)
        assert seen["holder"] == page.you != other.you
        other.send("start", robot.address, held=False)
        refused = other.until("refused")
        assert (refused["address"], "Another page" in refused["message"]) == (robot.address, True)
        other.send("stop", "")
        assert page.board(state="ready")["held"] is False


def test_a_robot_is_let_go(visit, robot) -> None:
    with visit() as page, visit() as other:
        page.give("connect", robot.address)
        page.board(phase="open")
        page.send("forget", robot.address)
        assert page.until("gone")["address"] == robot.address
        other.give("connect", robot.address)
        other.board(phase="open", holder=other.you)


def test_nobody_there_is_told_in_words(visit, robot) -> None:
    robot.pull()
    with visit() as page:
        page.give("connect", robot.address)
        said = page.until("board", lambda said: said["message"])
        assert (said["phase"], said["state"]) == ("closed", "none")
        assert "cannot be opened" in said["message"]
        assert said["help"]


@pytest.mark.parametrize(
    "address",
    ["/etc/passwd", "spy:///dev/null?file=/tmp/x", "file:///etc/passwd", "loop://", "COM99", "alt:///dev/ttyS0"],
)
def test_only_listed_ports_and_the_network_are_opened(visit, address) -> None:
    with visit() as page:
        page.give("connect", address)
        refused = page.until("refused")
        assert "there is no robot at" in refused["message"].lower()
        assert refused["address"] == address


def test_a_visitor_from_elsewhere_does_not_reach_the_ports(visit, app) -> None:
    with visit("192.168.1.7") as page:
        assert (page.first["type"], page.first["address"]) == ("refused", "")
        assert "another machine" in page.first["message"]
        assert page.socket.receive()["type"] == "websocket.close"
    app.state.studio.boards_for_visitors = True
    with visit("192.168.1.7") as page:
        assert page.you


def test_what_is_no_request_is_refused_and_does_no_harm(visit) -> None:
    with visit() as page:
        for text in ("", "{", '{"type": "start"}', '{"type": "jump", "address": "a"}', "[" * 5000):
            page.socket.send_text(text)
            assert "not understood" in page.until("refused")["message"]
        for kind in ("cancel", "forget", "identify"):
            page.send(kind, "socket://127.0.0.1:1")
            assert page.until("refused")["address"] == "socket://127.0.0.1:1"
        page.send("stop", "")


def test_a_program_with_mistakes_is_not_sent_and_its_problems_are_told(visit, robot) -> None:
    with visit() as page:
        broken = json.loads(json.dumps(page.mission))
        broken["programs"][0]["vertices"][4]["settings"]["value"] = "x"
        page.send("send", robot.address, mission=broken, path="pulse.krt", program="pulse", then="held")
        refused = page.until("refused")
        assert [problem["vertices"] for problem in refused["problems"]] == [["v4"]]
        assert "`pulse`" in refused["message"]


@pytest.mark.parametrize(("kit", "says"), [("pico", "lacks what the program uses"), ("../x", "no kit named")])
def test_a_program_is_not_sent_to_a_kit_that_lacks_its_parts_or_is_not_there(visit, robot, kit, says) -> None:
    with visit() as page:
        page.send("send", robot.address, mission=page.mission, path="pulse.krt", program="pulse", kit=kit, then="held")
        assert says in page.until("refused")["message"]


def test_what_failed_is_said_in_the_readers_language(visit) -> None:
    with visit(language="fr") as page:
        page.give("connect", "COM99")
        assert page.until("refused")["message"].startswith("Il n'y a pas de robot")


def test_ports_that_come_and_go_are_told_while_they_are_looked_at(visit, monkeypatch) -> None:
    monkeypatch.delenv(BOARDS_VARIABLE, raising=False)
    with visit() as page:
        page.socket.send_text('{"type": "look", "on": true}')
        page.until("ports")
        monkeypatch.setenv(BOARDS_VARIABLE, "socket://127.0.0.1:5")
        plugged = page.until("ports", lambda said: said["ports"])
        assert plugged["ports"][-1]["address"] == "socket://127.0.0.1:5"
        monkeypatch.delenv(BOARDS_VARIABLE)
        page.until("ports", lambda said: len(said["ports"]) == len(plugged["ports"]) - 1)


class Flickering:
    """A robot that loses its power for a moment, soon after it was started, and then runs by itself."""

    def __init__(self) -> None:
        self.tick = 0
        self.state = 1
        self.stopped = 0

    def greet(self) -> Hello:
        return Hello(1, self.state, 0, 2000, self.tick, 0, 1, "c0ffee00", "-")

    look = greet

    def start(self, held: bool = False) -> None:
        self.tick, self.state = 100, 2

    def stop(self) -> None:
        self.state, self.stopped = 1, self.stopped + 1

    def news(self, timeout: float) -> News:
        time.sleep(0.01)
        told = News(self.tick, {}, {})
        # The light goes out and on once it has told something of its run.
        self.tick = 1 if self.tick == 100 else self.tick + 1
        return told

    def last_fault(self) -> None:
        return None

    def close(self) -> None:
        pass


def test_a_held_robot_that_began_anew_by_itself_is_stopped(visit, app, monkeypatch) -> None:
    monkeypatch.setattr("kitrobot.robots.session.LOOK_S", 0.0)
    board = Flickering()

    class RobotGateway(SerialGateway):
        def connect(self, address):
            return board

    app.state.studio.boards = RobotRegistry(RobotGateway())
    with visit() as page:
        page.give("connect", "socket://127.0.0.1:1")
        page.send("start", "socket://127.0.0.1:1", held=True)
        said = page.until("board", lambda said: "began anew" in said["message"])
        assert (said["state"], said["held"], board.stopped) == ("ready", False, 1)
