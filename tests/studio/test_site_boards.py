"""Boards at the static site, thorough profile: micro:bit and Pico behind ports of the page, Python in its worker."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from kitrobot.workspace.traces import open_trace
from tests.boards.modern import ModernBoard
from tests.boards.qemu import running
from tests.boards.test_bench import UNPLUGGED
from tests.studio.robot_rows import expect_robot
from tests.studio.serial_ports import PICO, Bridge
from tests.studio.sites import FileServer, Visit, example, follow_link, opened
from tests.studio.test_page_ports import DEPLOY_MS, expect_stop_when_pulled

pytestmark = [
    pytest.mark.browser,
    pytest.mark.site,
    pytest.mark.boards,
    pytest.mark.thorough(
        "test_page_ports.py: a board at a page of the installed studio; the site: test_site.py, without a board; bytes "
        "to and from its Python: web/src/site/worker-line.test.ts; answers meanwhile: server/test_in_page_server.py"
    ),
]


def test_boards_are_sent_to_watched_stopped_and_tried_by_python_in_the_page(
    server: FileServer,
    visit: Callable[..., Visit],
    tmp_path: Path,
) -> None:
    with (
        running() as board,
        Bridge(board.port) as bridge,
        ModernBoard({"lib/machine.py": UNPLUGGED}, pace=3) as other,
        Bridge(int(other.address.rsplit(":", 1)[1]), PICO) as other_bridge,
    ):
        page = visit(bypass_csp=True).context.new_page()
        studio = opened(page, server.address)
        bridge.give(page, other_bridge)
        follow_link(studio, example("heart"), "heart")

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
        studio.built_of("")
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

        # A second board beside it is built otherwise, has another program, and a sensor of it is held.
        follow_link(studio, example("dice"), "dice")
        robot.get_by_test_id("robot-run").click()
        expect_robot(robot, state="running")
        # Held, it would stop where Python in the page is busy with the other one for longer than 0.8 s.
        robot.get_by_test_id("robot-free").click()
        expect(robot.get_by_test_id("robot-state")).to_contain_text("on its own")
        follow_link(studio, example("blink"), "blink")
        studio.at("find-board").click()
        expect(studio.at("robot")).to_have_count(2)
        second = page.get_by_role("listitem", name="Raspberry Pi Pico")
        first = page.get_by_role("listitem", name="micro:bit")
        second.get_by_test_id("robot-kit").click()
        studio.built_of("pico")
        second.get_by_test_id("robot-run").click()
        expect_robot(second, state="running")
        second.get_by_test_id("robot-watch").click()
        studio.at("watch-Button").get_by_role("combobox").select_option("0")
        expect(studio.at("watch-Button")).to_have_attribute("data-forced", "true")
        expect_robot(first, state="running")

        # STOP is for both; what the second did was recorded, and its parts are tried by hand.
        studio.at("team-stop").click()
        expect_robot(first, state="ready")
        expect_robot(second, state="ready")
        with page.expect_download() as saving:
            second.get_by_test_id("robot-save-recording").click()
        recording = tmp_path / "second.krtrace"
        saving.value.save_as(recording)
        with open_trace(recording).reader as reader:
            told = [event.text for _, event in reader.events]
        assert [text for text in told if "held by hand" in text]
        second.get_by_test_id("robot-try").click()
        steps = second.get_by_test_id("bench").get_by_test_id("bench-step")
        forward = steps.filter(has_text="Wheel.Advance(40)").first
        forward.get_by_test_id("bench-try").click()
        expect(forward).to_have_attribute("data-going", "true")
        ranger = steps.filter(has_text="Distance sensor").first
        ranger.get_by_test_id("bench-try").click()
        expect(forward).to_have_attribute("data-going", "false")
        expect(ranger.get_by_test_id("bench-failure")).to_contain_text("not plugged in")
