"""Real robots in the studio: greeted, run, watched, interfered with, stopped, lost; by mouse and by keys."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from playwright.sync_api import Locator, expect

from tests.boards.host import SEEN_PACE, HostBoard, host_board, write_pulse
from tests.boards.modern import ModernBoard, onboard_files
from tests.boards.qemu import running
from tests.studio.conftest import LOOKS, Studio
from tests.studio.test_reach import AXE, choose, find_nothing
from tests.studio.test_watching import another_window

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
ACTIVE = ".vertex.is-active"


@pytest.fixture
def pulse(open_studio: OpenStudio, tmp_path: Path) -> Callable[..., Studio]:
    """Opens the studio on the mission `pulse`, with its robot; `broken` as in `write_pulse`."""

    def opened(broken: bool = False, **device: object) -> Studio:
        source = tmp_path / "source"
        source.mkdir()
        # An absolute path stays what it is when it is joined to the folder of the examples.
        return open_studio(str(write_pulse(source, broken)), **device)

    return opened


@pytest.fixture
def robots(tmp_path: Path) -> Iterator[Callable[..., HostBoard]]:
    """Starts robots on the network that have `pulse`."""
    with ExitStack() as stack:

        def robot(broken: bool = False) -> HostBoard:
            folder = tmp_path / "robots"
            folder.mkdir(exist_ok=True)
            return stack.enter_context(host_board(write_pulse(folder, broken), "pulse", SEEN_PACE))

        yield robot


def connect(studio: Studio, robot: HostBoard) -> Locator:
    """Greets a robot on the network; its place in the panel."""
    if not studio.at("robots").is_visible():
        studio.page.keyboard.press("Alt+r")
    studio.at("robots-address").fill(robot.address)
    studio.page.keyboard.press("Enter")
    found = studio.page.locator(f'[data-testid="robot"][data-address="{robot.address}"]')
    expect_robot(found, phase="open")
    return found


def again(studio: Studio, robot: HostBoard) -> Locator:
    """Loads the page again and opens the panel; the robot's place there."""
    studio.page.reload()
    expect(studio.page.locator('[data-testid="code"] .cm-line').first).not_to_be_empty()
    studio.page.keyboard.press("Alt+r")
    return studio.page.locator(f'[data-testid="robot"][data-address="{robot.address}"]')


def expect_robot(robot: Locator, **states: str) -> None:
    for name, value in states.items():
        expect(robot.get_by_test_id("robot-state")).to_have_attribute(f"data-{name}", value)


def run_anew(robot: Locator) -> None:
    robot.get_by_test_id("robot-stop").click()
    expect_robot(robot, state="ready")
    robot.get_by_test_id("robot-run").click()
    expect_robot(robot, state="running")


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


def what_is_shown_is_paused_and_gone_back_in_and_follows_the_robot_again(studio: Studio, robot: Locator) -> None:
    robot.get_by_test_id("robot-run").click()
    expect_robot(robot, state="running")
    value = studio.at("watch-Count").locator("input")
    expect(value).to_have_value(re.compile("^([4-9]|[1-4][0-9])$"))
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
    expect(value).to_have_value(re.compile("^([4-9]|[1-9][0-9])"))


def test_it_is_shown_as_it_was_at_a_breakpoint(pulse: OpenStudio, robots: Callable[..., HostBoard]) -> None:
    studio = pulse()
    robot = connect(studio, robots())
    studio.page.locator(".vertex", has_text="Wait").last.click()
    studio.page.keyboard.press("b")
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    expect(studio.at("status")).to_contain_text("visit 1")
    expect(studio.page.locator(ACTIVE).filter(has_text="Wait").last).to_be_visible()
    expect(studio.at("behind-bar")).to_be_visible()
    expect_robot(robot, state="running")
    studio.at("team-stop").click()
    expect_robot(robot, state="ready")


def test_another_window_watches_what_the_robot_does(pulse: OpenStudio, robots: Callable[..., HostBoard]) -> None:
    studio = pulse()
    robot = connect(studio, robots())
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


def test_keys_alone_run_and_stop_every_robot(pulse: OpenStudio, robots: Callable[..., HostBoard]) -> None:
    studio = pulse()
    both = [connect(studio, robots()) for _ in range(2)]
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


def test_a_lost_link_is_said_and_the_robot_is_greeted_again(
    pulse: OpenStudio, robots: Callable[..., HostBoard]
) -> None:
    studio = pulse()
    board = robots()
    robot = connect(studio, board)
    run_anew(robot)
    board.pull()
    expect_robot(robot, phase="lost")
    expect(robot.get_by_test_id("robot-trouble")).to_contain_text("motors stop within one second")
    expect(studio.at("status")).to_contain_text("motors stop within one second")
    expect(studio.page.locator(ACTIVE)).to_have_count(0)
    robot.get_by_test_id("robot-reconnect").click()
    expect(robot.get_by_test_id("robot-trouble")).to_contain_text("cannot be opened")
    expect_robot(robot, phase="closed")


def test_a_fault_leads_to_its_vertex_and_says_its_line(pulse: OpenStudio, robots: Callable[..., HostBoard]) -> None:
    studio = pulse(broken=True)
    robot = connect(studio, robots(broken=True))
    fault = robot.get_by_test_id("robot-fault")
    expect(fault).to_contain_text("Fault 1")
    expect(fault).to_contain_text("Display")
    expect(fault).to_contain_text("line 2")
    robot.get_by_test_id("robot-fault-vertex").click()
    expect(studio.page.locator(".vertex.is-selected", has_text="Image")).to_be_visible()


def a_robot_that_runs_on_its_own_goes_on_when_the_page_is_loaded_again(
    studio: Studio, board: HostBoard, robot: Locator
) -> None:
    robot.get_by_test_id("robot-free").click()
    expect(robot).to_contain_text("Running on its own")
    found = again(studio, board)
    found.get_by_test_id("robot-connect").click()
    expect(found).to_contain_text("Running on its own")
    expect(studio.page.locator(ACTIVE).first).to_be_visible()


def test_a_robot_is_run_watched_paused_in_what_is_shown_and_held_by_its_page_or_runs_on_its_own(
    pulse: OpenStudio, robots: Callable[..., HostBoard]
) -> None:
    studio = pulse()
    board = robots()
    robot = connect(studio, board)
    a_robot_runs_glows_is_watched_and_stopped(studio, robot)
    what_is_shown_is_paused_and_gone_back_in_and_follows_the_robot_again(studio, robot)
    robot = a_page_that_goes_away_stops_the_robot_it_held(studio, board, robot)
    a_robot_that_runs_on_its_own_goes_on_when_the_page_is_loaded_again(studio, board, robot)


def a_page_that_goes_away_stops_the_robot_it_held(studio: Studio, board: HostBoard, robot: Locator) -> Locator:
    run_anew(robot)
    found = again(studio, board)
    found.get_by_test_id("robot-connect").click()
    expect_robot(found, phase="open", state="ready")
    return found


def test_without_a_robot_the_panel_says_how_one_gets_there(pulse: OpenStudio) -> None:
    studio = pulse()
    studio.at("run-on-robot").click()
    expect(studio.at("robots-empty")).to_contain_text("Plug a micro:bit")
    studio.at("robots-empty").locator("summary").click()
    expect(studio.at("robots-empty")).to_contain_text("dialout")
    studio.at("robots-address").fill("not a robot")
    studio.page.keyboard.press("Enter")
    expect(studio.page.get_by_role("alert")).to_contain_text("socket://192.168.4.1:4000")
    studio.at("robots-close").click()
    expect(studio.at("arena")).to_be_visible()


@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_axe_finds_nothing_on_the_robots(
    pulse: OpenStudio, robots: Callable[..., HostBoard], look: tuple[str, ...]
) -> None:
    if not AXE.is_file():
        pytest.fail("the page's tools are not installed; run `make install`")
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


DRIVERS = {
    "display": "class Display:\n    def do(self, name, values):\n        pass\n    def stop(self):\n        pass\n",
    "key": "class Key:\n    def read(self):\n        return 0\n",
}
"""Drivers of one's own, beside the mission: no board without hardware has them."""


def test_a_program_is_sent_to_a_current_micropython_runs_there_and_is_stopped(
    pulse: OpenStudio, monkeypatch: pytest.MonkeyPatch
) -> None:
    with ModernBoard({"lib/machine.py": onboard_files()["machine.py"]}) as board:
        monkeypatch.setenv("KITROBOT_BOARDS", board.address)
        studio = pulse()
        for name, text in DRIVERS.items():
            made = f"{text}\n\ndef make(settings):\n    return {name.capitalize()}()\n"
            (studio.folder / f"{name}.driver.py").write_text(made)
        studio.page.keyboard.press("Alt+r")
        robot = studio.at("robot")
        expect(robot).to_have_count(1)
        # Nobody talks with it yet; with the only robot that there is, the key begins to.
        studio.page.keyboard.press("Control+F5")
        studio.built_of("")
        runs_and_stops(studio, robot)
        board.process.kill()
        expect_robot(robot, phase="lost")
        expect(robot.get_by_test_id("robot-trouble")).to_contain_text("is lost")


def runs_and_stops(studio: Studio, robot: Locator) -> None:
    """Waits until what was sent runs, sees it glow and count, and stops it."""
    expect(robot.get_by_test_id("robot-state")).to_have_attribute("data-state", "running")
    expect(robot).to_contain_text("bytes free")
    expect(studio.page.locator(ACTIVE).first).to_be_visible()
    robot.get_by_test_id("robot-watch").click()
    expect(studio.at("watch-Count").locator("input")).to_have_value(re.compile("^[1-9]"))
    studio.at("team-stop").click()
    expect_robot(robot, state="ready")


@pytest.mark.boards
def test_a_program_runs_on_a_micro_bit_of_2016_and_its_parts_glow(
    pulse: OpenStudio, monkeypatch: pytest.MonkeyPatch
) -> None:
    with running() as board:
        monkeypatch.setenv("KITROBOT_BOARDS", board.address)
        studio = pulse()
        studio.page.keyboard.press("Alt+r")
        robot = studio.at("robot")
        robot.get_by_test_id("robot-run").click()
        studio.built_of("")
        expect_robot(robot, state="running")
        expect(studio.page.locator(ACTIVE).first).to_be_visible()
        robot.get_by_test_id("robot-stop").click()
        expect_robot(robot, state="ready")
