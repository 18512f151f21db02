"""A board at the static site: the firmware of the micro:bit behind a port of the page, and Python in its worker."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from tests.boards.qemu import running
from tests.sites import made_site
from tests.studio.conftest import EXAMPLES, HEIGHT, WIDTH
from tests.studio.serial_ports import Bridge
from tests.studio.test_page_ports import DEPLOY_MS, expect_stop_when_pulled
from tests.studio.test_robots import expect_robot
from tests.studio.test_site import PATH, FileServer, link, opened

pytestmark = [pytest.mark.browser, pytest.mark.site, pytest.mark.boards]


def test_a_board_is_sent_to_watched_and_stopped_by_python_in_the_page(
    browser: Browser, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    (tmp_path / PATH.strip("/")).parent.mkdir()
    (tmp_path / PATH.strip("/")).symlink_to(made_site(tmp_path_factory.getbasetemp()))
    server = FileServer(tmp_path)
    context = browser.new_context(viewport={"width": WIDTH, "height": HEIGHT}, reduced_motion="reduce", bypass_csp=True)
    context.set_default_timeout(DEPLOY_MS)
    faults: list[str] = []
    context.on("weberror", lambda error: faults.append(str(error.error)))
    page = context.new_page()
    page.on("console", lambda message: faults.append(message.text) if message.type == "error" else None)
    with running() as board, Bridge(board.port) as bridge:
        studio = opened(page, server.address)
        bridge.give(page)
        heart = (EXAMPLES / "heart" / "heart.krt").read_text(encoding="utf-8")
        page.evaluate("hash => location.hash = hash", link(heart, "heart"))
        expect(page).to_have_title(re.compile("heart"))

        # Boards are chosen here; what cannot be there is said.
        page.keyboard.press("Alt+r")
        expect(studio.at("robots-empty")).to_contain_text("Press Find a board, and choose it.")
        expect(studio.at("robots-in-page")).to_contain_text("need KitRobot installed")
        expect(studio.at("robots-address")).to_have_count(0)
        studio.at("find-board").click()
        robot = studio.at("robot")
        expect(robot.get_by_role("heading")).to_have_text("micro:bit")
        expect(robot.get_by_test_id("robot-at-page")).to_have_text("through this page")

        # While a board does not answer, other things are asked and answered; the sending can be broken off.
        robot.get_by_test_id("robot-run").click()
        expect(robot.get_by_role("progressbar")).to_be_visible()
        board.pause()
        page.keyboard.press("Control+o")
        expect(studio.at("open-dialog")).to_contain_text("The crossing")
        page.keyboard.press("Escape")
        expect_robot(robot, phase="sending")
        robot.get_by_test_id("robot-cancel").click()
        board.resume()
        expect(robot.get_by_test_id("robot-trouble")).to_contain_text("The sending was broken off.")

        # It is sent, runs, is watched, and stops.
        robot.get_by_test_id("robot-run").click()
        expect(robot.get_by_test_id("robot-state")).to_have_attribute("data-state", "running", timeout=DEPLOY_MS)
        expect(page.locator(".vertex.is-active").first).to_be_visible()
        studio.at("team-stop").click()
        expect_robot(robot, state="ready")

        # A cable that is pulled is told, and the robot has stopped by itself.
        robot.get_by_test_id("robot-run").click()
        expect_robot(robot, state="running")
        expect_stop_when_pulled(bridge, board.address, robot)

        # Chosen again it goes on; let go, its port is free.
        studio.at("find-board").click()
        robot.get_by_test_id("robot-reconnect").click()
        expect_robot(robot, phase="open")
    assert faults == []
    context.close()
    server.end()
