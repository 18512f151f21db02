"""An edit sends only what changed, and whatever the server knows or not, page and server mean the same program."""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, Request, Route, expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
BLINK = "blink/blink.krt"
ABOUT_MISSIONS = "**/api/{check,text}"


def writing(page: Page) -> None:
    """The code editor is ready, the caret at its very end."""
    expect(page.get_by_test_id("code-editor")).to_have_attribute("data-writable", "true")
    page.get_by_test_id("code").locator(".cm-content").focus()
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


def program_in(request: Request) -> dict[str, object]:
    sent: dict[str, object] = json.loads(request.post_data or "")["mission"]["programs"][0]
    return sent


def a_key_and_an_edit_of_the_graph_send_what_changed(studio: Studio) -> None:
    page = studio.page
    waits = numbers(page).all_inner_texts()
    writing(page)
    with page.expect_request(ABOUT_MISSIONS) as typed:
        page.keyboard.insert_text("\nWAIT(7);")
    assert program_in(typed.value)["of"]
    assert all(isinstance(row, list) for row in program_in(typed.value)["vertices"])  # type: ignore[attr-defined]
    expect_waits(page, [*waits, seconds(7)])
    page.locator(".vertex", has_text="Wait").last.click()
    with page.expect_request(ABOUT_MISSIONS) as erased:
        page.keyboard.press("Delete")
    assert all(isinstance(row, list) for row in program_in(erased.value)["vertices"])  # type: ignore[attr-defined]
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


def a_server_that_forgot_is_sent_everything(studio: Studio) -> None:
    page = studio.page
    waits = numbers(page).all_inner_texts()
    names: list[object] = []

    def forgetting(route: Route) -> None:
        """The first name that is sent is one that the server does not know."""
        sent = json.loads(route.request.post_data or "")
        program = sent["mission"]["programs"][0]
        names.append(program.get("of"))
        if len(names) == 1:
            program["of"] = "nobody-1"
        route.continue_(post_data=json.dumps(sent))

    page.route(ABOUT_MISSIONS, forgetting)
    writing(page)
    page.keyboard.insert_text("\nWAIT(7);")
    expect_waits(page, [*waits, seconds(7)])
    studio.expect_code("WAIT(7);")
    assert names[0]
    assert names[1] is None
    # The browser notes the refusal; the page does not.
    assert [fault for fault in studio.faults if "410" not in fault] == []
    studio.faults.clear()
    page.keyboard.insert_text("\nWAIT(8);")
    expect_waits(page, [*waits, seconds(7), seconds(8)])
    assert names[2]
    page.unroute(ABOUT_MISSIONS)


def test_an_edit_sends_what_changed_and_to_a_server_that_forgot_everything(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    expect(studio.at("problems")).to_have_attribute("aria-busy", "false")
    a_key_and_an_edit_of_the_graph_send_what_changed(studio)
    keys_that_follow_each_other_faster_than_answers_come_end_as_they_were_typed(studio)
    a_server_that_forgot_is_sent_everything(studio)


@pytest.mark.thorough(
    "server/test_mission_delta.py::test_two_windows_that_edit_the_same_program_are_each_answered_for_their_own"
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
