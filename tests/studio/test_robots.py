"""Real robots in the studio: greeted, run, watched, interfered with, stopped, lost; by mouse and by keys.

What is said of each state and what each button sends: `web/src/features/robots/RobotPanel.test.tsx`; what comes of it:
`tests/server/test_boards.py` and `test_robot_runs.py`.
"""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.boards.host import HostBoard
from tests.studio.conftest import Studio
from tests.studio.looks import choose, find_nothing
from tests.studio.robot_rows import ACTIVE, OpenStudio, again, connect, expect_robot, run_anew
from tests.studio.test_watching import another_window

pytestmark = pytest.mark.browser


def a_robot_runs_glows_is_watched_and_stopped(studio: Studio, robot: Locator) -> None:
    expect(robot).to_contain_text(re.compile(r"\d.\d{3}.\d{3}.{0,2} bytes free"))
    robot.get_by_test_id("robot-stop").click()
    expect_robot(robot, state="ready")
    expect(studio.page.locator(ACTIVE)).to_have_count(0)
    robot.get_by_test_id("robot-run").click()
    expect_robot(robot, state="running")
    expect(studio.at("status")).to_contain_text("Running on a robot")
    expect(studio.page.locator(ACTIVE).first).to_be_visible()
    expect(studio.at("run-button")).to_be_disabled()
    robot.get_by_test_id("robot-watch").click()
    value = studio.at("watch-Count").locator("input")
    expect(value).to_have_value(re.compile("^[1-9]"))
    value.fill("500")
    studio.page.keyboard.press("Enter")
    expect(value).to_have_value(re.compile("^50[1-9]$"))
    studio.at("watch-ButtonA").get_by_role("combobox").select_option("1")
    expect(studio.at("watch-ButtonA")).to_have_attribute("data-forced", "true")
    studio.at("release-ButtonA").click()
    expect(studio.at("watch-ButtonA")).to_have_attribute("data-forced", "false")
    studio.at("team-stop").click()
    expect_robot(robot, state="ready")
    expect(studio.page.locator(ACTIVE)).to_have_count(0)
    expect(studio.at("status")).to_have_attribute("data-status", "stopped")


def what_is_shown_is_paused_and_follows_the_robot_again(studio: Studio, robot: Locator) -> None:
    robot.get_by_test_id("robot-run").click()
    expect_robot(robot, state="running")
    studio.at("pause-button").click()
    expect(studio.at("behind-bar")).to_contain_text("does not pause them")
    expect_robot(robot, state="running")
    studio.at("follow").click()
    expect(studio.at("behind-bar")).to_have_count(0)


def what_a_lost_robot_did_is_played(studio: Studio, board: HostBoard, robot: Locator) -> None:
    board.pull()
    expect_robot(robot, phase="lost")
    expect(robot.get_by_test_id("robot-trouble")).to_contain_text("motors stop within one second")
    robot.get_by_test_id("robot-play-recording").click()
    expect(studio.at("recording-bar")).to_contain_text("a recording of a real robot")
    expect(studio.at("event-strip").locator('[data-kind="failure"] title')).to_contain_text("is lost")


def test_a_robot_is_run_watched_paused_in_what_is_shown_lost_and_what_it_did_is_played(
    pulse: OpenStudio, robots: Callable[..., HostBoard]
) -> None:
    studio = pulse()
    board = robots()
    robot = connect(studio, board)
    find_nothing(studio, "a robot that runs")
    a_robot_runs_glows_is_watched_and_stopped(studio, robot)
    what_is_shown_is_paused_and_follows_the_robot_again(studio, robot)
    what_a_lost_robot_did_is_played(studio, board, robot)


def what_is_shown_is_paused_and_gone_back_in_and_follows_the_robot_again(studio: Studio, robot: Locator) -> None:
    robot.get_by_test_id("robot-run").click()
    expect_robot(robot, state="running")
    value = studio.at("watch-Count").locator("input")
    expect(value).to_have_value(re.compile("^([2-9]|[1-4][0-9])$"))
    strip = studio.at("event-strip")
    expect(strip).to_have_attribute("aria-disabled", "false")
    expect(studio.at("behind-bar")).to_have_count(0)
    studio.at("pause-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    expect(studio.at("behind-bar")).to_contain_text("does not pause them")
    expect_robot(robot, state="running")
    before = int(strip.get_attribute("aria-valuemax") or 0)
    strip.focus()
    studio.page.keyboard.press("Home")
    expect(value).to_have_value(re.compile("^[01]$"))
    studio.at("step-vertex-button").click()
    expect(strip).not_to_have_attribute("aria-valuenow", "0")
    # It went on meanwhile, and the timeline with it.
    expect(strip).not_to_have_attribute("aria-valuemax", str(before))
    expect_robot(robot, state="running")
    studio.at("follow").click()
    expect(studio.at("behind-bar")).to_have_count(0)
    expect(studio.at("status")).to_contain_text("Running on a robot")
    expect(value).to_have_value(re.compile("^([2-9]|[1-9][0-9])"))


def expect_paused_where_it_waits(studio: Studio, robot: Locator) -> None:
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    expect(studio.at("status")).to_contain_text("visit 1")
    expect(studio.page.locator(ACTIVE).filter(has_text="Wait").last).to_be_visible()
    expect(studio.at("behind-bar")).to_be_visible()
    expect_robot(robot, state="running")


def it_is_shown_as_it_was_at_a_breakpoint_set_while_it_runs_and_while_it_is_stopped(
    studio: Studio, robot: Locator
) -> None:
    wait = studio.page.locator(".vertex", has_text="Wait").last
    run_anew(robot)
    wait.click()
    studio.page.keyboard.press("b")
    expect_paused_where_it_waits(studio, robot)
    studio.page.keyboard.press("b")
    run_anew(robot)
    expect(studio.at("behind-bar")).to_have_count(0)
    expect(studio.at("status")).to_contain_text("Running on a robot")
    robot.get_by_test_id("robot-stop").click()
    expect(studio.at("status")).to_have_attribute("data-status", "stopped")
    wait.click()
    studio.page.keyboard.press("b")
    robot.get_by_test_id("robot-run").click()
    expect_paused_where_it_waits(studio, robot)
    wait.click()
    studio.page.keyboard.press("b")
    studio.at("team-stop").click()
    expect_robot(robot, state="ready")


def a_page_that_goes_away_stops_the_robot_it_held(studio: Studio, board: HostBoard, robot: Locator) -> Locator:
    robot.get_by_test_id("robot-run").click()
    expect_robot(robot, state="running")
    found = again(studio, board)
    found.get_by_test_id("robot-connect").click()
    expect_robot(found, phase="open", state="ready")
    return found


def a_robot_that_runs_on_its_own_goes_on_when_the_page_is_loaded_again(
    studio: Studio, board: HostBoard, robot: Locator
) -> None:
    robot.get_by_test_id("robot-free").click()
    expect(robot).to_contain_text("Running on its own")
    found = again(studio, board)
    found.get_by_test_id("robot-connect").click()
    expect(found).to_contain_text("Running on its own")
    expect(studio.page.locator(ACTIVE).first).to_be_visible()


def another_window_watches_what_the_robot_does(studio: Studio, robot: Locator) -> None:
    run_anew(robot)
    other = another_window(studio)
    other.get_by_test_id("watch-run").click()
    expect(other.get_by_test_id("watching-bar")).to_have_attribute("data-watching", "true")
    expect(other.get_by_test_id("status")).to_contain_text("Running on a robot")
    expect(other.locator(ACTIVE).first).to_be_visible()
    expect(other.get_by_test_id("arena-real")).to_be_visible()
    for control in ("pause-button", "step-back-button"):
        expect(other.get_by_test_id(control)).to_be_disabled()
    other.get_by_test_id("watch-button").click()
    expect(other.get_by_test_id("watch-Count").locator("input")).to_be_disabled()
    robot.get_by_test_id("robot-stop").click()
    for page in (studio.page, other):
        expect(page.get_by_test_id("status")).to_have_attribute("data-status", "stopped")
    robot.get_by_test_id("robot-run").click()
    for page in (studio.page, other):
        expect(page.get_by_test_id("status")).to_have_attribute("data-status", "running")
    robot.get_by_test_id("robot-disconnect").click()
    expect(other.get_by_test_id("status")).to_have_attribute("data-status", "stopped")
    expect(studio.at("status")).to_have_attribute("data-status", "idle")


@pytest.mark.thorough(
    "the test above; tests/server/test_boards.py: held, on its own, of another page; test_robot_runs.py: "
    "breakpoints, going back, another window; what is shown: web/src/features/run/bars.test.tsx, "
    "session/run.test.ts"
)
def test_a_robot_is_run_watched_paused_in_what_is_shown_and_held_by_its_page_or_runs_on_its_own(
    pulse: OpenStudio, robots: Callable[..., HostBoard]
) -> None:
    studio = pulse()
    board = robots()
    robot = connect(studio, board)
    a_robot_runs_glows_is_watched_and_stopped(studio, robot)
    what_is_shown_is_paused_and_gone_back_in_and_follows_the_robot_again(studio, robot)
    it_is_shown_as_it_was_at_a_breakpoint_set_while_it_runs_and_while_it_is_stopped(studio, robot)
    robot = a_page_that_goes_away_stops_the_robot_it_held(studio, board, robot)
    a_robot_that_runs_on_its_own_goes_on_when_the_page_is_loaded_again(studio, board, robot)
    another_window_watches_what_the_robot_does(studio, robot)


def without_a_robot_the_panel_says_how_one_gets_there(studio: Studio) -> None:
    studio.at("run-on-robot").click()
    expect(studio.at("robots-empty")).to_contain_text("Plug a micro:bit")
    studio.at("robots-empty").locator("summary").click()
    expect(studio.at("robots-empty")).to_contain_text("dialout")
    find_nothing(studio, "no robot")
    studio.at("robots-address").fill("not a robot")
    studio.page.keyboard.press("Enter")
    expect(studio.page.get_by_role("alert")).to_contain_text("socket://192.168.4.1:4000")
    studio.at("robots-close").click()
    expect(studio.at("arena")).to_be_visible()


def keys_alone_run_and_stop_every_robot(studio: Studio, both: list[Locator]) -> None:
    studio.page.keyboard.press("Shift+F5")
    for robot in both:
        expect_robot(robot, state="ready")
    studio.page.keyboard.press("Control+F5")
    for robot in both:
        expect_robot(robot, state="running")
    expect(studio.at("watched-agent").locator("option")).to_have_count(2)
    studio.page.keyboard.press("Alt+r")
    expect(studio.at("robots")).to_have_count(0)
    expect(studio.at("arena")).to_be_visible()
    expect(studio.page.locator(ACTIVE).first).to_be_visible()
    studio.page.keyboard.press("Shift+F5")
    expect(studio.at("status")).to_have_attribute("data-status", "stopped")
    studio.page.keyboard.press("Alt+r")
    for robot in both:
        expect_robot(robot, state="ready")


@pytest.mark.thorough(
    "web/src/features/robots/RobotPanel.test.tsx: without a robot, an address that is none, one key runs every "
    "robot; the keys are those of web/src/app/keys.test.ts"
)
def test_a_robot_is_found_by_its_address_and_keys_alone_run_and_stop_every_robot(
    pulse: OpenStudio, robots: Callable[..., HostBoard]
) -> None:
    studio = pulse()
    without_a_robot_the_panel_says_how_one_gets_there(studio)
    both = [connect(studio, robots()) for _ in range(2)]
    find_nothing(studio, "robots that run")
    keys_alone_run_and_stop_every_robot(studio, both)


@pytest.mark.thorough(
    "the tests above and test_robots_recorded.py in the light theme; colours: web/src/theme/tokens.test.ts"
)
@pytest.mark.parametrize("look", [("dark", "ur"), ("contrast", "fr")], ids=str)
@pytest.mark.thorough("the first test of this file in the light theme; colours: web/src/theme/tokens.test.ts")
def test_axe_finds_nothing_on_the_robots(
    pulse: OpenStudio, robots: Callable[..., HostBoard], look: tuple[str, ...]
) -> None:
    studio = pulse()
    choose(studio, *look)
    studio.page.keyboard.press("Alt+r")
    expect(studio.at("robots-empty")).to_be_visible()
    find_nothing(studio, "no robot")
    board = robots()
    robot = connect(studio, board)
    find_nothing(studio, "a robot that runs")
    board.pull()
    expect_robot(robot, phase="lost")
    find_nothing(studio, "a lost robot")
