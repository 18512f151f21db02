"""However an edit is made, and however fast edits follow each other, page and server mean the same program."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
BLINK = "blink/blink.krt"


def writing(page: Page) -> None:
    """The code editor is ready, the caret at its very end."""
    page.get_by_test_id("code").locator(".cm-content").focus()
    expect(page.get_by_test_id("code-editor")).to_have_attribute("data-writable", "true")
    page.keyboard.press("Control+End")


def numbers(page: Page) -> Locator:
    """The durations in the graph's Waits, in its order."""
    return page.locator(".vertex", has_text="Wait").locator(".box strong")


def seconds(duration: int) -> str:
    """How the graph shows it."""
    return f"{duration / 10:.1f} s"


def expect_waits(page: Page, durations: list[str]) -> None:
    """The graph has these Waits (in seconds), in this order, and the server has said all there is to say."""
    expect(numbers(page)).to_have_text(durations)
    expect(page.get_by_test_id("problems")).to_have_attribute("aria-busy", "false")


def a_key_and_an_edit_of_the_graph_mean_the_same(studio: Studio) -> None:
    page = studio.page
    waits = numbers(page).all_inner_texts()
    writing(page)
    page.keyboard.insert_text("\nWAIT(7);")
    expect_waits(page, [*waits, seconds(7)])
    page.locator(".vertex", has_text="Wait").last.click()
    page.keyboard.press("Delete")
    expect_waits(page, waits)
    page.keyboard.press("Control+z")
    expect_waits(page, [*waits, seconds(7)])
    studio.expect_code("WAIT(7);")


def keys_that_follow_each_other_faster_than_answers_come_end_as_they_were_typed(studio: Studio) -> None:
    page = studio.page
    waits = numbers(page).all_inner_texts()
    writing(page)
    page.keyboard.insert_text("\nWAIT(1);")
    for key in ("ArrowLeft", "ArrowLeft"):
        page.keyboard.press(key)
    for digit in "2345":
        page.keyboard.press(digit)
    expect_waits(page, [*waits, seconds(12345)])
    page.keyboard.press("Backspace")
    page.keyboard.press("Backspace")
    expect_waits(page, [*waits, seconds(123)])
    studio.expect_code("WAIT(123);")


def test_an_edit_of_the_text_and_one_of_the_graph_mean_the_same_program(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    expect(studio.at("problems")).to_have_attribute("aria-busy", "false")
    a_key_and_an_edit_of_the_graph_mean_the_same(studio)
    keys_that_follow_each_other_faster_than_answers_come_end_as_they_were_typed(studio)


@pytest.mark.thorough(
    "server/test_caches.py::test_two_windows_that_edit_the_same_program_are_each_answered_for_their_own"
)
def test_two_windows_edit_the_same_mission_each_in_its_own_way(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    one = studio.page
    expect(one.get_by_test_id("problems")).to_have_attribute("aria-busy", "false")
    waits = numbers(one).all_inner_texts()
    other = one.context.new_page()
    other.goto(one.url)
    for page in (one, other):
        page.bring_to_front()
        writing(page)
    for number in range(1, 4):
        for page, durations in ((one, range(10, 10 + number)), (other, range(20, 20 + number))):
            page.bring_to_front()
            page.keyboard.insert_text(f"\nWAIT({durations[-1]});")
            expect_waits(page, [*waits, *map(seconds, durations)])
