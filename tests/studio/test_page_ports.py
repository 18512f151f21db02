"""A board at the reader's own computer: the real firmware of the micro:bit behind a port of the page."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from kitrobot.deploy import Line, connect
from tests.boards.qemu import running
from tests.studio.conftest import Studio
from tests.studio.serial_ports import Bridge
from tests.studio.test_robots import expect_robot
from tests.studio.test_watching import another_window

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
DEPLOY_MS = 120_000
"""The emulator may be given little of a busy machine."""
RUNNING = 2
QUIET_S = 1.5
"""Longer than a held robot goes on without a word."""


def expect_stop_when_pulled(bridge: Bridge, address: str, robot: Locator) -> None:
    """Pulls the cable of a robot that runs held: the page says so, and the robot has stopped by itself."""
    bridge.pull()
    expect_robot(robot, phase="lost")
    expect(robot.get_by_test_id("robot-trouble")).to_contain_text("its motors stop within one second")
    line = Line(address)
    line.drain(QUIET_S, DEPLOY_MS / 1000)
    line.close()
    with connect(address) as there:
        assert there.hello.state != RUNNING


@pytest.mark.boards
def test_a_board_at_the_page_is_sent_to_watched_stopped_and_stops_when_its_cable_is_pulled(
    open_studio: OpenStudio,
) -> None:
    with running() as board, Bridge(board.port) as bridge:
        studio = open_studio("heart/heart.krt", bypass_csp=True)
        bridge.give(studio.page)
        studio.page.keyboard.press("Alt+r")
        studio.at("find-board").click()
        robot = studio.at("robot")
        expect(robot.get_by_role("heading")).to_have_text("micro:bit")
        expect(robot.get_by_test_id("robot-at-page")).to_have_text("through this page")

        robot.get_by_test_id("robot-run").click()
        studio.built_of("")
        expect(robot.get_by_test_id("robot-state")).to_have_attribute("data-state", "running", timeout=DEPLOY_MS)
        expect(studio.page.locator(".vertex.is-active").first).to_be_visible()

        # It belongs to this page: another one of the same studio neither sees nor lists it.
        other = another_window(studio)
        other.keyboard.press("Alt+r")
        expect(other.get_by_test_id("robots-empty")).to_be_visible()
        expect(other.get_by_test_id("robot")).to_have_count(0)
        other.close()

        studio.at("team-stop").click()
        expect_robot(robot, state="ready")

        robot.get_by_test_id("robot-run").click()
        expect_robot(robot, state="running")
        expect_stop_when_pulled(bridge, board.address, robot)

        # Chosen again it has the place that it had; a tab that the browser freezes lets it go.
        studio.at("find-board").click()
        robot.get_by_test_id("robot-reconnect").click()
        expect_robot(robot, phase="open")
        studio.page.evaluate("document.dispatchEvent(new Event('freeze'))")
        expect_robot(robot, phase="lost")
        robot.get_by_test_id("robot-reconnect").click()
        expect(robot.get_by_test_id("robot-trouble")).to_contain_text("Choose the board again.")

        # Where the browser cannot reach boards, that is said in the place of the button.
        studio.page.evaluate("Object.defineProperty(navigator, 'serial', { value: undefined })")
        studio.at("robots-close").click()
        studio.page.keyboard.press("Alt+r")
        expect(studio.at("find-board-not")).to_contain_text("Edge and Firefox do; or install KitRobot")
        expect(studio.at("find-board")).to_have_count(0)
