"""Two windows on one mission: what runs in the one is watched in the other.

What each is told: `tests/server/test_broadcast.py`; what is offered, and what cannot be pressed meanwhile:
`web/src/features/run/bars.test.tsx`.
"""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.browser

TRANSPORT = "transport/transport.krt"


def another_window(studio):
    """The same studio in a second window."""
    page = studio.page.context.new_page()
    page.on("pageerror", lambda error: studio.faults.append(str(error)))
    page.on("console", lambda message: studio.faults.append(message.text) if message.type == "error" else None)
    page.goto(studio.page.url)
    expect(page.get_by_test_id("canvas")).to_be_visible()
    return page


def status_is(page, status: str) -> None:
    expect(page.get_by_test_id("status")).to_have_attribute("data-status", status)


def watched(studio):
    """A second window that watches the run of the first one, which goes so slowly that it does not end meanwhile."""
    studio.at("speed").press("Home")
    studio.at("run-button").click()
    status_is(studio.page, "running")
    other = another_window(studio)
    watch_again(studio, other)
    return other


def watch_again(studio, other) -> None:
    """The second window watches what the first one runs."""
    if studio.at("status").get_attribute("data-status") != "running":
        studio.at("run-button").click()
        status_is(studio.page, "running")
    other.get_by_test_id("watch-run").click()
    expect(other.get_by_test_id("watching-bar")).to_have_attribute("data-watching", "true")
    status_is(other, "running")


def a_run_is_offered_to_the_other_window_and_watched_there(studio, other):
    expect(studio.at("watching-bar")).to_have_count(0)
    studio.at("pause-button").click()
    status_is(studio.page, "paused")
    status_is(other, "paused")
    for window in (studio.page, other):
        expect(window.get_by_test_id("arena-summary")).to_contain_text("carrier-1")
    said = studio.at("event-strip").get_attribute("aria-valuenow")
    assert said is not None
    expect(other.get_by_test_id("event-strip")).to_have_attribute("aria-valuenow", said)
    for control in ("run-button", "pause-button", "step-button", "step-back-button", "speed"):
        expect(other.get_by_test_id(control)).to_be_disabled()
    expect(other.get_by_test_id("event-strip")).to_have_attribute("aria-disabled", "true")
    studio.at("step-button").click()
    expect(other.get_by_test_id("event-strip")).to_have_attribute("aria-valuenow", str(int(said) + 1))


def who_watches_leaves_and_the_run_goes_on(studio, other):
    other.get_by_test_id("team-stop").click()
    status_is(other, "idle")
    expect(other.get_by_test_id("watching-bar")).to_have_attribute("data-watching", "false")
    status_is(studio.page, "running")
    other.get_by_test_id("watch-run").click()
    status_is(other, "running")
    other.get_by_test_id("watch-leave").click()
    status_is(other, "idle")


def the_end_of_the_run_is_seen_and_the_offer_goes_away(studio, other):
    studio.at("team-stop").click()
    status_is(other, "stopped")
    other.get_by_test_id("watch-leave").click()
    expect(other.get_by_test_id("watching-bar")).to_have_count(0)
    other.get_by_test_id("run-button").click()
    status_is(other, "running")


def the_run_is_over_when_its_window_is_closed(studio, other):
    studio.page.close()
    expect(other.get_by_test_id("banner")).to_contain_text("is gone, and the run with it")
    status_is(other, "stopped")


def a_window_with_another_state_of_the_mission_is_told_so(studio, other):
    studio.page.locator(".vertex .vertex-name").first.click()
    studio.page.keyboard.press("/")
    studio.at("add-find").fill("wait")
    studio.page.keyboard.press("Enter")
    expect(studio.at("undo")).to_be_enabled()
    watch_again(studio, other)
    expect(other.get_by_test_id("watching-bar")).to_contain_text("is not what is open here")
    studio.at("team-stop").click()
    status_is(other, "stopped")
    other.get_by_test_id("watch-leave").click()
    studio.take_back()


def test_a_run_is_watched_in_another_window_which_shows_the_same_and_is_over_with_its_own(open_studio):
    studio = open_studio(TRANSPORT)
    other = watched(studio)
    a_run_is_offered_to_the_other_window_and_watched_there(studio, other)
    the_run_is_over_when_its_window_is_closed(studio, other)


@pytest.mark.thorough(
    "the test above; web/src/features/run/bars.test.tsx: offered, another mission, left; session/run.test.ts: it "
    "is left with STOP, and over when the page that steers is gone; tests/server/test_broadcast.py"
)
def test_a_run_is_offered_to_another_window_watched_left_and_over_with_its_window(open_studio):
    studio = open_studio(TRANSPORT)
    expect(studio.at("watching-bar")).to_have_count(0)
    other = watched(studio)
    a_run_is_offered_to_the_other_window_and_watched_there(studio, other)
    studio.at("run-button").click()
    status_is(other, "running")
    who_watches_leaves_and_the_run_goes_on(studio, other)
    other.get_by_test_id("watch-run").click()
    status_is(other, "running")
    the_end_of_the_run_is_seen_and_the_offer_goes_away(studio, other)
    other.get_by_test_id("team-stop").click()
    a_window_with_another_state_of_the_mission_is_told_so(studio, other)
    watch_again(studio, other)
    the_run_is_over_when_its_window_is_closed(studio, other)
