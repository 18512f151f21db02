"""Notes on the canvas, the lane of a Break, and the bar that says for whom it waits."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.studio.conftest import Studio
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
TRANSPORT = "transport/transport.krt"


def vertex(studio: Studio, words: str) -> Locator:
    """The first vertex of the graph that says that."""
    return studio.page.locator(".vertex", has_text=words).first


def name_of(at: Locator) -> str:
    """The vertex's id."""
    return (at.get_attribute("data-testid") or "").removeprefix("vertex-")


def n_writes_a_note_that_stands_on_the_vertex_and_in_the_text(studio: Studio) -> None:
    keys = studio.page.keyboard
    stop = vertex(studio, "Wheels Stand still")
    name = name_of(stop)
    stop.click()
    keys.press("n")
    expect(studio.at("note-field")).to_be_focused()
    keys.type("Stand still")
    keys.press("Shift+Enter")
    keys.type("until the road is free")
    keys.press("Enter")
    expect(studio.at("canvas")).to_be_focused()
    strip = studio.at(f"note-{name}")
    expect(strip).to_contain_text("Stand still")
    expect(strip).to_contain_text("+1 line")
    studio.expect_code("# Stand still")
    studio.expect_code("# until the road is free")
    above, below = place_of(strip), place_of(stop)
    assert abs(above["y"] + above["height"] - below["y"]) < 2, "it stands on its vertex"
    keys.press("Control+z")
    expect(strip).to_have_count(0)
    expect(studio.at("code")).not_to_contain_text("Stand still")
    keys.press("Control+y")
    expect(strip).to_be_visible()


def a_note_is_edited_where_it_stands_and_escape_leaves_it_as_it_was(studio: Studio) -> None:
    keys = studio.page.keyboard
    strip = studio.page.locator(".note-strip").first
    expect(strip).to_contain_text("Drive to the dock")
    strip.click()
    expect(studio.at("note-field")).to_have_value("Drive to the dock. Stop for a carrier ahead.")
    keys.type(" Forgotten")
    keys.press("Escape")
    expect(studio.at("saved-state")).to_have_text("saved")
    strip.click()
    studio.at("note-field").fill("Kept by a click elsewhere")
    vertex(studio, "Wheels Stand still").click()
    studio.expect_code("# Kept by a click elsewhere")
    strip.click()
    studio.at("note-field").fill("")
    keys.press("Enter")
    expect(studio.at("code")).not_to_contain_text("Kept by a click")


def the_menu_writes_and_removes_a_note(studio: Studio) -> None:
    stop = vertex(studio, "Wheels Stand still")
    name = name_of(stop)
    stop.click(button="right")
    expect(studio.at("menu-context-unnote")).to_have_count(0)
    studio.at("menu-context-note").click()
    # Playwright gives letters of other scripts to the field that has the focus, without keys.
    expect(studio.at("note-field")).to_be_focused()
    studio.page.keyboard.type("یہاں رکو")
    studio.page.keyboard.press("Enter")
    strip = studio.at(f"note-{name}")
    expect(strip).to_contain_text("یہاں رکو")
    assert strip.evaluate("one => getComputedStyle(one).direction") == "rtl", "its own script decides"
    stop.click(button="right")
    studio.at("menu-context-unnote").click()
    expect(strip).to_have_count(0)


def what_was_typed_is_kept_when_another_program_is_opened(studio: Studio) -> None:
    vertex(studio, "Wheels Stand still").click()
    studio.page.keyboard.press("n")
    studio.page.keyboard.type("Half a thought")
    studio.at("tab-loader").click()
    studio.at("tab-carrier").click()
    studio.expect_code("# Half a thought")


def a_break_has_a_lane_to_the_exit_of_its_loop(studio: Studio) -> None:
    keys = studio.page.keyboard
    vertex(studio, "Road ahead free").click()
    for part in ("if then else", "break"):
        keys.press("/")
        studio.at("add-find").fill(part)
        keys.press("Enter")
    loop = studio.page.locator(".vertex", has_text="Break")
    expect(loop).to_have_count(1)
    lane = studio.at(f"leap-{name_of(loop)}")
    expect(lane).to_contain_text("out")
    studio.expect_code("BREAK;")
    # What comes after it is drawn as never taken.
    expect(studio.page.locator(".arc.is-dead")).to_have_count(1)
    keys.press("Control+z")
    expect(lane).to_have_count(0)


def the_second_bar_says_for_whom_it_waits(studio: Studio) -> None:
    studio.at("run-button").click()
    waits = studio.page.locator(".bar-waits").first
    expect(waits).to_have_text(re.compile(r"^0\s*waits for\s*1$"))


@pytest.mark.thorough(
    "web/src/features/canvas/notes.test.tsx and find.test.tsx: notes, and for whom a bar waits; "
    "model/layout/layout.test.ts: the lane of a Break; that a note is seen and axe: test_clipping.py, the screen a "
    "note"
)
def test_a_note_is_written_edited_and_removed_where_it_stands_a_break_has_a_lane_and_a_bar_says_for_whom_it_waits(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(TRANSPORT)
    a_note_is_edited_where_it_stands_and_escape_leaves_it_as_it_was(studio)
    studio.take_back()
    n_writes_a_note_that_stands_on_the_vertex_and_in_the_text(studio)
    studio.take_back()
    the_menu_writes_and_removes_a_note(studio)
    what_was_typed_is_kept_when_another_program_is_opened(studio)
    studio.take_back()
    a_break_has_a_lane_to_the_exit_of_its_loop(studio)
    studio.take_back()
    the_second_bar_says_for_whom_it_waits(studio)
