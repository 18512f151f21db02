"""The static site from a plain file server, under a path: nothing but files is asked for, and Python runs in the page.

One visit with two starts of Python, because a page with Python in it takes seconds to begin; the second start has no
server any more, a mission in its address, and a board behind a port of the page. When a mission is drawn before Python
is there, and when not: `web/src/site/first.test.ts`. More of it is tried in the thorough profile (`test_site_whole`,
`test_site_boards`). Building the folder has tests of its own (`tests/workspace/test_site.py`), the same Python without
a page (`tests/server/test_in_page_server.py`), and so have the sentences of each state, storage and links
(`web/src/site`).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.boards.modern import ModernBoard, onboard_files
from tests.studio.conftest import IS_OPEN, Studio
from tests.studio.robot_rows import expect_robot
from tests.studio.serial_ports import PICO, Bridge
from tests.studio.sites import BLINK, MEMORY, FileServer, Visit, example, follow_link, link

pytestmark = [pytest.mark.browser, pytest.mark.site]


TAKES_OVER_MS = 400_000
"""Chromium lets a service worker take over when the one before has nothing to do; after five minutes at the latest."""


def the_first_mission_is_edited_before_python_is_there_and_goes_on(page: Page, server: FileServer) -> Studio:
    studio = Studio(page, Path(), [])
    server.gate.clear()
    try:
        page.goto(server.address)
        nodes = page.locator(".canvas-node")
        expect(nodes).to_have_count(19)
        expect(studio.at("site")).to_contain_text("You can build already")
        studio.drop("Wait", "arc-start.next")
        expect(nodes).to_have_count(20)
        # The page is left before Python is there, and has it when it is opened again.
        page.reload()
        expect(nodes).to_have_count(20)
        studio.drop("Wait", "arc-start.next")
        expect(nodes).to_have_count(21)
        page.keyboard.press("Control+z")
        expect(nodes).to_have_count(20)
    finally:
        server.gate.set()
    page.wait_for_function(IS_OPEN)
    studio.expect_code("WAIT(10);")
    expect(studio.at("saved-state")).to_have_text("not saved")
    page.keyboard.press("Control+z")
    expect(nodes).to_have_count(19)
    expect(studio.at("saved-state")).to_have_text("example")
    return studio


def a_mission_runs_is_edited_and_saved_under_a_name_of_its_own(studio: Studio) -> None:
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    studio.drop("Wait", "arc-start.next")
    studio.expect_code("WAIT(10);")
    studio.page.keyboard.press("Control+s")
    studio.at("save-name").fill("mine")
    studio.at("save-name").press("Enter")
    expect(studio.at("saved-state")).to_have_text("saved")


def a_new_version_is_offered(studio: Studio, server: FileServer) -> None:
    studio.page.evaluate("navigator.serviceWorker.ready.then(() => null)")
    worker = server.folder / "service-worker.js"
    worker.write_text(worker.read_text().replace('const VERSION = "', 'const VERSION = "newer-'))
    studio.page.evaluate("navigator.serviceWorker.ready.then((found) => found.update()).then(() => null)")
    expect(studio.at("site")).to_contain_text("There is a new version")


def a_second_tab_waits_and_goes_on_once_the_first_goes_to_the_new_version(studio: Studio, address: str) -> Studio:
    first = studio.page
    second = first.context.new_page()
    # Only here: in the first tab Python began under the policy of the site. A board's stand-in is at another address.
    first.context.new_cdp_session(second).send("Page.setBypassCSP", {"enabled": True})
    second.goto(f"{address}#{link(BLINK, 'linked')}")
    expect(second.get_by_test_id("site")).to_contain_text("open in another tab")
    second.wait_for_load_state("networkidle")
    with first.expect_navigation(timeout=TAKES_OVER_MS):
        studio.at("site").get_by_role("button").click()
    second.wait_for_function(IS_OPEN)
    expect(first.get_by_test_id("site")).to_contain_text("open in another tab")
    assert "newer-" in second.evaluate("caches.keys().then((names) => names.join())")
    first.close()
    expect(second).to_have_title(re.compile("linked"))
    return Studio(second, Path(), [])


def a_board_is_chosen_sent_to_glows_and_is_stopped(studio: Studio, bridge: Bridge) -> None:
    bridge.give(studio.page)
    studio.page.keyboard.press("Alt+r")
    expect(studio.at("robots-empty")).to_contain_text("Press Find a board, and choose it.")
    expect(studio.at("robots-in-page")).to_contain_text("teams of several boards, need KitRobot installed")
    expect(studio.at("robots-address")).to_have_count(0)
    studio.at("find-board").click()
    robot = studio.at("robot")
    expect(robot.get_by_role("heading")).to_have_text("Raspberry Pi Pico")
    robot.get_by_test_id("robot-run").click()
    studio.built_of("pico")
    expect_robot(robot, state="running")
    # Held, it would stop where Python in the page is busy for longer than 0.8 s.
    robot.get_by_test_id("robot-free").click()
    expect(studio.page.locator(".vertex.is-active").first).to_be_visible()
    studio.at("team-stop").click()
    expect_robot(robot, state="ready")
    bridge.pull()
    expect_robot(robot, phase="lost")


def test_a_site_opens_a_link_keeps_what_is_saved_works_without_its_server_and_sends_to_a_board(
    server: FileServer, visit: Callable[..., Visit]
) -> None:
    made = visit()
    studio = the_first_mission_is_edited_before_python_is_there_and_goes_on(made.context.new_page(), server)
    follow_link(studio, BLINK, "linked")
    studio.expect_code("WAIT(17);")
    a_mission_runs_is_edited_and_saved_under_a_name_of_its_own(studio)
    # Python's memory of this start is kept, and the next one goes on from it.
    studio.page.wait_for_function(f"async () => await {MEMORY} !== ''")
    a_new_version_is_offered(studio, server)
    server.end()
    studio = a_second_tab_waits_and_goes_on_once_the_first_goes_to_the_new_version(studio, server.address)
    studio.page.keyboard.press("Control+o")
    studio.at("open-dialog").locator('[data-path="mine.krt"]').click()
    expect(studio.page).to_have_title(re.compile("mine"))
    studio.expect_code("WAIT(10);")
    studio.page.evaluate("location.hash = 'mission=AAAA&name=x'")
    expect(studio.at("banner")).to_contain_text("The mission in this link is damaged.")
    follow_link(studio, example("blink"), "blink")
    with (
        ModernBoard({"lib/machine.py": onboard_files()["machine.py"]}, pace=3) as board,
        Bridge(int(board.address.rsplit(":", 1)[1]), PICO) as bridge,
    ):
        a_board_is_chosen_sent_to_glows_and_is_stopped(studio, bridge)
    assert made.warned == []
