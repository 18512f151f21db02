"""A run is paused where it is wanted, taken back, watched and interfered with, by mouse and keys."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
PAUSED = re.compile("^paused$")


def started(open_studio: OpenStudio, example: str = "blink/blink.krt") -> Studio:
    """A run on its way, with a breakpoint where the lamp goes on."""
    studio = open_studio(example)
    light = studio.page.locator(".vertex", has_text="Lamp On")
    light.click()
    studio.page.keyboard.press("b")
    expect(studio.page.locator(".breakpoint")).to_have_count(1)
    studio.at("run-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", PAUSED)
    return studio


def tick(studio: Studio) -> int:
    return int(studio.at("event-strip").get_attribute("aria-valuenow") or "-1")


def expect_tick(studio: Studio, wanted: int) -> None:
    expect(studio.at("event-strip")).to_have_attribute("aria-valuenow", str(wanted))


def it_pauses_at_a_breakpoint_again_and_again(studio: Studio) -> None:
    expect(studio.at("status")).to_contain_text("visit 1")
    expect(studio.page.locator('.breakpoint[data-reached="true"]')).to_have_count(1)
    for visit in (2, 3):
        studio.page.keyboard.press("F5")
        expect(studio.at("status")).to_contain_text(f"visit {visit}")


def it_goes_on_without_a_breakpoint(studio: Studio) -> None:
    studio.page.locator(".vertex", has_text="Lamp On").click()
    studio.page.keyboard.press("b")
    expect(studio.page.locator(".breakpoint")).to_have_count(0)
    studio.full_speed()
    studio.page.keyboard.press("F5")
    studio.wait_until_done()


def the_breakpoint_is_kept_in_the_mission_and_undone(studio: Studio) -> None:
    studio.page.locator(".vertex", has_text="Lamp On").click()
    studio.at("breakpoint-switch").click()
    expect(studio.page.locator(".breakpoint")).to_have_count(1)
    studio.at("breakpoint-hits").fill("2")
    studio.at("breakpoint-when").fill("Run.IsTrue()")
    studio.page.keyboard.press("Enter")
    studio.page.keyboard.press("Control+s")
    expect(studio.page.locator(".breakpoint")).to_have_attribute("data-more", "true")
    text = saved(studio)
    assert '<breakpoint program="blink" vertex="v8" when="Run.IsTrue()" hits="2"/>' in text
    studio.page.locator(".vertex", has_text="Lamp On").click()
    for _ in range(3):
        studio.page.keyboard.press("Control+z")
    expect(studio.page.locator(".breakpoint")).to_have_count(0)
    expect(studio.at("tab-blink")).to_have_attribute("aria-selected", "true")


def saved(studio: Studio) -> str:
    """The mission's file, once it is saved."""
    studio.page.wait_for_function("() => document.title !== '' && !document.title.startsWith('•')")
    return (studio.folder / "blink.krt").read_text()


def steps_back_and_on_lead_to_the_same_place(studio: Studio) -> None:
    at = tick(studio)
    for back in range(1, 4):
        studio.page.keyboard.press("F9")
        expect_tick(studio, at - back)
    for on in range(2, -1, -1):
        studio.page.keyboard.press("F10")
        expect_tick(studio, at - on)
    studio.at("step-vertex-button").click()
    expect(studio.at("event-strip")).not_to_have_attribute("aria-valuenow", str(at))
    studio.at("step-back-button").click()


def the_handle_of_the_timeline_goes_anywhere_and_on(studio: Studio) -> None:
    latest = tick(studio)
    strip = studio.at("event-strip")
    strip.focus()
    studio.page.keyboard.press("Home")
    expect_tick(studio, 0)
    studio.page.keyboard.press("ArrowRight")
    expect_tick(studio, 1)
    studio.page.keyboard.press("PageUp")
    expect_tick(studio, 51)
    studio.page.keyboard.press("End")
    expect_tick(studio, latest)
    handle, box = place_of(studio.at("strip-handle")), place_of(strip)
    mouse = studio.page.mouse
    mouse.move(handle["x"] + handle["width"] / 2, handle["y"] + handle["height"] / 2)
    mouse.down()
    mouse.move(box["x"] + 22, handle["y"] + 6, steps=8)
    mouse.up()
    # The 22 pixels from the strip's begin are a tick of the first half, however long the run was.
    expect(strip).to_have_attribute("aria-valuenow", re.compile(rf"^({'|'.join(map(str, range(latest // 2)))})$"))
    expect(strip).to_have_attribute("aria-valuemax", str(latest))
    expect(studio.at("status")).to_have_attribute("data-status", PAUSED)


def test_a_run_pauses_at_breakpoints_is_stepped_dragged_and_begins_another_future(open_studio: OpenStudio) -> None:
    studio = started(open_studio)
    expect(studio.page.locator('.breakpoint[data-reached="true"]')).to_have_count(1)
    for visit in (2, 3):
        studio.page.keyboard.press("F5")
        expect(studio.at("status")).to_contain_text(f"visit {visit}")
    the_handle_of_the_timeline_goes_anywhere_and_on(studio)
    studio.at("event-strip").focus()
    studio.page.keyboard.press("End")
    studio.at("watch-button").click()
    count = studio.at("watch-Count").get_by_role("textbox")
    count.click()
    count.fill("42")
    studio.page.keyboard.press("Enter")
    expect(count).to_have_value("42")
    what_is_done_in_the_past_begins_another_future(studio)


@pytest.mark.thorough(
    "test_a_run_pauses_at_breakpoints_is_stepped_dragged_and_begins_another_future; "
    "web/src/features/run/strip.test.tsx: keys of the timeline; server/test_debugging.py: pauses, steps and goes "
    "back"
)
def test_a_run_pauses_at_a_breakpoint_is_stepped_back_and_on_and_led_anywhere_on_its_timeline(
    open_studio: OpenStudio,
) -> None:
    studio = started(open_studio)
    it_pauses_at_a_breakpoint_again_and_again(studio)
    the_handle_of_the_timeline_goes_anywhere_and_on(studio)
    studio.at("event-strip").focus()
    studio.page.keyboard.press("End")
    expect_tick(studio, int(studio.at("event-strip").get_attribute("aria-valuemax") or "-1"))
    steps_back_and_on_lead_to_the_same_place(studio)
    it_goes_on_without_a_breakpoint(studio)


def variables_are_set_and_sensors_forced_from_the_watch(studio: Studio) -> None:
    count = studio.at("watch-Count").get_by_role("textbox")
    expect(count).to_have_value("0")
    count.click()
    count.fill("42")
    studio.page.keyboard.press("Enter")
    expect(count).to_have_value("42")
    captor = studio.at("watch-Captor")
    captor.get_by_role("textbox").click()
    captor.get_by_role("textbox").fill("7")
    studio.page.keyboard.press("Enter")
    expect(captor).to_have_attribute("data-forced", "true")
    studio.page.keyboard.press("F10")
    expect(captor.get_by_role("textbox")).to_have_value("7 cm")
    studio.at("release-Captor").click()
    expect(captor).to_have_attribute("data-forced", "false")
    studio.page.keyboard.press("F10")
    expect(captor.get_by_role("textbox")).to_have_value("100 cm")
    expect(captor.locator(".watch-line")).to_have_attribute("d", re.compile("^M"))


def a_number_out_of_range_is_not_taken(studio: Studio) -> None:
    count = studio.at("watch-Count").get_by_role("textbox")
    for wrong in ("1000", "-1", "many", "1.5", ""):
        count.click()
        count.fill(wrong)
        studio.page.keyboard.press("Enter")
        expect(count).to_have_value("0")


def what_is_done_in_the_past_begins_another_future(studio: Studio) -> None:
    latest = tick(studio)
    studio.page.keyboard.press("F9")
    expect_tick(studio, latest - 1)
    flag = studio.at("watch-Flag").get_by_role("combobox")
    flag.select_option("1")
    expect(studio.at("event-strip")).to_have_attribute("aria-valuemax", str(latest - 1))
    expect(flag).to_have_value("1")


@pytest.mark.thorough(
    "web/src/features/debug/watch.test.tsx: set, forced, let go, not taken; server/test_debugging.py: in a run; "
    "another future: test_a_run_pauses_at_breakpoints_is_stepped_dragged_and_begins_another_future"
)
def test_the_watch_sets_variables_forces_sensors_takes_no_number_out_of_range_and_begins_another_future(
    open_studio: OpenStudio,
) -> None:
    studio = started(open_studio)
    studio.at("watch-button").click()
    a_number_out_of_range_is_not_taken(studio)
    variables_are_set_and_sensors_forced_from_the_watch(studio)
    what_is_done_in_the_past_begins_another_future(studio)


def a_condition_that_is_none_is_said(studio: Studio) -> None:
    studio.page.locator(".vertex", has_text="Lamp On").click()
    studio.at("breakpoint-switch").click()
    studio.at("breakpoint-when").fill("Count.")
    studio.page.keyboard.press("Enter")
    studio.at("run-button").click()
    expect(studio.page.get_by_role("alert").first).to_contain_text("no condition")


@pytest.mark.thorough(
    "web/src/features/inspector/values.test.tsx: set by B and by its fields, undone; in the file: "
    "tests/forms/test_pairs.py; what is no condition: server/test_debugging.py"
)
def test_a_breakpoint_is_kept_in_the_mission_and_undone_and_says_what_is_no_condition(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    the_breakpoint_is_kept_in_the_mission_and_undone(studio)
    a_condition_that_is_none_is_said(studio)
