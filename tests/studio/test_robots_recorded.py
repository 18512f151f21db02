"""Real robots that are lost or fail in the studio, and their recordings: saved, played, what they say of a fault."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from kitrobot.workspace.traces import open_trace
from tests.boards.host import HostBoard
from tests.studio.conftest import Studio
from tests.studio.looks import find_nothing
from tests.studio.robot_rows import ACTIVE, OpenStudio, connect, expect_robot, run_anew

pytestmark = pytest.mark.browser


def a_lost_link_is_said_and_the_robot_is_greeted_again(studio: Studio, robot: Locator) -> None:
    expect_robot(robot, phase="lost")
    expect(robot.get_by_test_id("robot-trouble")).to_contain_text("motors stop within one second")
    expect(studio.at("status")).to_contain_text("motors stop within one second")
    expect(studio.page.locator(ACTIVE)).to_have_count(0)
    find_nothing(studio, "a lost robot")
    robot.get_by_test_id("robot-reconnect").click()
    expect(robot.get_by_test_id("robot-trouble")).to_contain_text("cannot be opened")
    expect_robot(robot, phase="closed")


@pytest.mark.thorough(
    "test_robots.py: what a lost robot did is played; tests/server/test_robot_recording.py: what was done to it "
    "and a lost link are in the file; web/src/features/debug/events.test.ts: the list"
)
def test_a_run_whose_link_is_lost_is_saved_and_opens_on_the_timeline_with_what_was_done_to_it(
    pulse: OpenStudio, robots: Callable[..., HostBoard]
) -> None:
    studio = pulse()
    board = robots()
    robot = connect(studio, board)
    run_anew(robot)
    robot.get_by_test_id("robot-watch").click()
    value = studio.at("watch-Count").locator("input")
    expect(value).to_have_value(re.compile("^[1-9]"))
    studio.at("watch-ButtonA").get_by_role("combobox").select_option("1")
    expect(studio.at("watch-ButtonA")).to_have_attribute("data-forced", "true")
    expect(value).to_have_value(re.compile("^[1-9][0-9]"))
    # Real robots have no place in the arena while they run either.
    studio.at("robots-close").click()
    expect(studio.at("arena-real")).to_contain_text("do not tell where they are")
    studio.page.keyboard.press("Alt+r")
    board.pull()
    a_lost_link_is_said_and_the_robot_is_greeted_again(studio, robot)
    with studio.page.expect_download() as saving:
        robot.get_by_test_id("robot-save-recording").click()
    assert (
        saving.value.suggested_filename == f"pulse-{board.address.removeprefix('socket://').replace(':', '-')}.krtrace"
    )
    path = studio.folder / "robot.krtrace"
    saving.value.save_as(path)
    with open_trace(path).reader as reader:
        assert [event.kind for _, event in reader.events] == ["outside", "outside", "failure"]
    robot.get_by_test_id("robot-play-recording").click()
    bar = studio.at("recording-bar")
    expect(bar).to_contain_text("a recording of a real robot")
    expect(studio.at("robots")).to_have_count(0)
    expect(studio.at("arena-real")).to_be_visible()
    expect(studio.page.locator(ACTIVE).first).to_be_visible()
    strip = studio.at("event-strip")
    expect(strip.locator('[data-kind="failure"] title')).to_contain_text("is lost")
    # Marks that crowd on the timeline stand apart in the list.
    happened = studio.at("event-list").locator("tbody tr")
    expect(happened).to_have_count(3)
    expect(happened.nth(1)).to_contain_text("held by hand")
    expect(happened.nth(0)).to_have_attribute("data-cause", "link")
    expect(strip).to_have_attribute("aria-disabled", "false")
    strip.focus()
    studio.page.keyboard.press("End")
    expect(studio.page.locator(ACTIVE)).to_have_count(0)
    expect(studio.at("watch-ButtonA")).to_have_attribute("data-forced", "true")
    expect(value).to_have_value(re.compile("^[1-9][0-9]"))
    studio.page.keyboard.press("Home")
    expect(value).to_have_value("0")


@pytest.mark.thorough(
    "web/src/features/robots/RobotPanel.test.tsx: a fault names its place and leads there; "
    "tests/server/test_robot_recording.py: it ends the recording where it happened"
)
def test_a_fault_leads_to_its_vertex_and_so_does_its_recording(
    pulse: OpenStudio, robots: Callable[..., HostBoard]
) -> None:
    studio = pulse(broken=True)
    robot = connect(studio, robots(broken=True))
    fault = robot.get_by_test_id("robot-fault")
    expect(fault).to_contain_text("Fault 1")
    expect(fault).to_contain_text("Display")
    expect(fault).to_contain_text("line 2")
    robot.get_by_test_id("robot-fault-vertex").click()
    expect(studio.page.locator(".vertex.is-selected", has_text="Image")).to_be_visible()
    robot.get_by_test_id("robot-run").click()
    expect(fault).to_contain_text("Fault 1")
    robot.get_by_test_id("robot-play-recording").click()
    expect(studio.at("recording-bar")).to_contain_text("a recording of a real robot")
    strip = studio.at("event-strip")
    if not studio.at("event-list").is_visible():
        studio.at("watch-button").click()
    failure = studio.at("event-list").locator('[data-kind="failure"]')
    expect(failure).to_contain_text("fault 1: a driver failed (Display")
    expect(failure).to_contain_text("vertex v3, line 2")
    strip.focus()
    studio.page.keyboard.press("End")
    expect(studio.page.locator(ACTIVE).filter(has_text="Image")).to_be_visible()
