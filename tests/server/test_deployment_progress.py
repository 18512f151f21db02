"""Sending a program to a robot: how far it is, breaking it off, a refusal."""

from __future__ import annotations

import itertools
import time

import pytest

from kitrobot.deploy.errors import ForeignError, FullError
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.robot_gateway import SerialGateway
from kitrobot.live.robot_registry import RobotRegistry
from kitrobot.text.sentences import Sentence
from tests.boards.host import PULSER, host_board, write_pulse


class SlowSending(SerialGateway):
    """Real links whose sending goes on until it is broken off, or is refused in the way that is asked for."""

    def __init__(self, error: KitRobotError | None = None) -> None:
        self.error = error
        self.asked: list[tuple[bool, bool]] = []

    def deploy(self, address, program, progress, replace, fresh) -> None:
        self.asked.append((replace, fresh))
        if self.error is not None:
            raise self.error
        for done in itertools.count():
            progress("send", min(done, 1000), 1000)
            time.sleep(0.001)


def test_a_sending_tells_how_far_it_is_and_is_broken_off(visit, app, robot) -> None:
    app.state.studio.boards = RobotRegistry(SlowSending())
    with visit() as page, visit() as other:
        page.give("send", robot.address, then="held")
        page.until("board", lambda said: said["progress"] is not None and said["progress"]["done"] > 0)
        other.send("cancel", robot.address)
        assert other.until("refused")["address"] == robot.address
        page.send("cancel", robot.address)
        said = page.board(phase="closed", progress=None)
        assert "broken off" in said["message"]
        assert "still has the program" in said["help"]


def test_stop_breaks_a_sending_off_too(visit, app, robot) -> None:
    app.state.studio.boards = RobotRegistry(SlowSending())
    with visit() as page, visit() as other:
        page.give("send", robot.address, then="held")
        page.board(phase="sending")
        other.send("stop", "")
        page.board(phase="closed")


def test_a_page_that_goes_away_during_a_sending_leaves_nothing_behind(visit, app, robot) -> None:
    app.state.studio.boards = room = RobotRegistry(SlowSending())
    with visit() as page:
        page.give("send", robot.address, then="held")
        page.board(phase="sending")
    with visit() as page:
        page.give("connect", robot.address)
        assert page.board(phase="open", holder=page.you)["program"] == "pulse"
    assert room is app.state.studio.boards


@pytest.mark.parametrize(
    ("error", "way"), [(ForeignError(Sentence("no")), "replace"), (FullError(Sentence("no")), "fresh")]
)
def test_a_refused_sending_says_how_it_can_be_asked_for_again(visit, app, robot, error, way) -> None:
    links = SlowSending(error)
    app.state.studio.boards = RobotRegistry(links)
    with visit() as page:
        page.give("send", robot.address, then="ready")
        assert page.until("board", lambda said: said["message"])["way"] == way
        page.give("send", robot.address, then="ready", **{way: True})
        page.until("board", lambda said: len(links.asked) == 2 and said["phase"] == "closed" and said["way"] == way)
    assert links.asked == [(False, False), (way == "replace", way == "fresh")]


def test_what_a_program_shares_with_its_team_is_told_once_it_was_sent(visit, app, folder, monkeypatch) -> None:
    shared = PULSER.replace('name="Count" type="integer"', 'name="Count" shared="yes" type="integer"')
    monkeypatch.setattr("tests.boards.host.PULSER", shared)

    class Sent(SerialGateway):
        def deploy(self, address, program, progress, replace, fresh) -> None:
            """It has it already."""

    app.state.studio.boards = RobotRegistry(Sent())
    write_pulse(folder)
    with host_board(folder / "pulse.krt", "pulse", waits=True) as robot, visit() as page:
        page.give("send", robot.address, then="held")
        said = page.until("board", lambda said: "shared" in said["message"])
        assert "line 3, vertex `v4`" in said["message"]
        assert said["help"]
        assert (said["phase"], said["state"]) == ("open", "running")
