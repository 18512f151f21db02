"""Robots that fail, stall, lose their radio and come back: in the arena by mouse, finger and keys, and on schedule."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import expect

from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

TRANSPORT = "transport/transport.krt"
ROBOT = "carrier-1"


STANDS_STILL = """async (canvas) => {
    const frames = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const { width, height } = canvas, pen = canvas.getContext("2d");
    const look = () => new Uint32Array(pen.getImageData(0, 0, width, height).data.buffer);
    const isSame = (one, other) => one.every((colour, at) => colour === other[at]);
    // It draws on its way to the last frame for a moment; then nothing moves any more.
    let [picture, still] = [look(), 0];
    for (let tries = 0; tries < 100 && still < 6; tries++) {
        await frames();
        const next = look();
        if (isSame(picture, next)) still++;
        else if (still > 0) return false;
        picture = next;
    }
    return still === 6;
}"""
"""Whether the arena comes to rest and stays so."""


def start_paused(studio):
    """A run that stands at a moment in which it is going on."""
    studio.at("run-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "running")
    studio.at("pause-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")


def choose(studio, name: str) -> None:
    """Puts the ring on the robot, with the keys of the arena."""
    studio.at("arena-canvas").focus()
    for _ in range(12):
        studio.page.keyboard.press("n")
        if name in studio.at("states-said").inner_text():
            return
    raise AssertionError(f"{name} is not reached")


def middle_of(studio, name: str) -> tuple[float, float]:
    """Where the robot is on the screen: in the middle of the arena, once it is followed."""
    choose(studio, name)
    studio.page.keyboard.press("Shift+F")
    # The arena follows with the next frame.
    studio.page.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    box = place_of(studio.at("arena-canvas"))
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def the_mouse_lets_a_robot_fail_and_come_back(studio, x, y):
    studio.page.mouse.click(x, y, button="right")
    studio.at("menu-harm-fail").click()
    expect(studio.at("arena-summary")).to_contain_text(re.compile(rf"{ROBOT}[^.]*failed"))
    expect(studio.at("states-said")).to_contain_text(f"{ROBOT}: failed")
    expect(studio.at("event-strip").locator('[data-kind="failure"]')).to_have_count(1)
    studio.page.mouse.click(x, y, button="right")
    expect(studio.at("menu-harm-fail")).to_have_attribute("aria-disabled", "true")
    studio.at("menu-harm-revive").click()
    expect(studio.at("states-said")).to_contain_text(f"{ROBOT}: well again")


def keys_do_it_too(studio, robot, item, word):
    choose(studio, robot)
    studio.page.keyboard.press("Enter")
    expect(studio.at("menu-harm-fail")).to_be_visible()
    for _ in range(["fail", "stall", "mute"].index(item)):
        studio.page.keyboard.press("ArrowDown")
    studio.page.keyboard.press("Enter")
    expect(studio.at("states-said")).to_contain_text(f"{robot}: {word}")
    expect(studio.at("arena-canvas")).to_be_focused()


def a_finger_that_rests_opens_the_menu(studio, x, y):
    touch = {"pointerType": "touch", "pointerId": 5, "button": 0, "clientX": x, "clientY": y, "isPrimary": True}
    # A pointer that is made up cannot be captured.
    studio.page.evaluate("HTMLElement.prototype.setPointerCapture = () => undefined")
    studio.at("arena-canvas").dispatch_event("pointerdown", touch)
    expect(studio.at("robot-menu")).to_be_visible()
    studio.at("arena-canvas").dispatch_event("pointerup", touch)
    expect(studio.at("robot-menu")).to_be_visible()
    studio.page.keyboard.press("Escape")
    expect(studio.at("robot-menu")).to_have_count(0)


def without_a_run_the_menu_says_what_is_missing(studio):
    choose(studio, ROBOT)
    studio.page.keyboard.press("Enter")
    expect(studio.at("robot-menu")).to_contain_text("Press Run first")
    expect(studio.at("menu-harm-fail")).to_have_attribute("aria-disabled", "true")


@pytest.mark.thorough(
    "web/src/features/arena/hands.test.tsx: the menu of a robot without and with a run; server/test_failures.py; by"
    " the mouse and a finger: test_a_robot_is_followed_fails_by_hand_and_the_list_says_who_did_it"
)
def test_mouse_keys_and_fingers_let_robots_fail_stall_lose_their_radio_and_come_back_once_there_is_a_run(open_studio):
    studio = open_studio(TRANSPORT)
    without_a_run_the_menu_says_what_is_missing(studio)
    studio.page.keyboard.press("Escape")
    start_paused(studio)
    place = middle_of(studio, ROBOT)
    a_finger_that_rests_opens_the_menu(studio, *place)
    the_mouse_lets_a_robot_fail_and_come_back(studio, *place)
    for number, (item, word) in enumerate((("fail", "failed"), ("stall", "stalled"), ("mute", "without radio")), 1):
        keys_do_it_too(studio, f"carrier-{number}", item, word)


def who_is_followed_stays_in_the_middle_until_the_world_is_dragged(studio):
    # So slowly that it is where the last frame showed it.
    studio.at("speed").press("Home")
    studio.at("run-button").click()
    # Before the run a robot that is dragged is taken to another place.
    expect(studio.at("status")).to_have_attribute("data-status", "running")
    x, y = middle_of(studio, ROBOT)
    for _ in range(3):
        studio.page.mouse.click(x, y, button="right")
        expect(studio.at("robot-menu").get_by_role("menu", name=re.compile(ROBOT))).to_be_visible()
        expect(studio.at("menu-harm-follow")).to_have_attribute("aria-checked", "true")
        studio.page.keyboard.press("Escape")
    studio.page.mouse.move(x, y + 60)
    studio.page.mouse.down()
    studio.page.mouse.move(x + 30, y + 90, steps=4)
    studio.page.mouse.up()
    studio.page.keyboard.press("Enter")
    expect(studio.at("menu-harm-follow")).to_have_attribute("aria-checked", "false")


@pytest.mark.thorough(
    "test_a_robot_is_followed_fails_by_hand_and_the_list_says_who_did_it: it goes on when it comes back"
)
def test_a_run_that_failed_goes_on_when_somebody_comes_back(open_studio):
    studio = open_studio("square/square.krt")
    start_paused(studio)
    studio.at("arena-canvas").focus()
    studio.page.keyboard.press("Enter")
    studio.at("menu-harm-fail").click()
    expect(studio.at("status")).to_have_attribute("data-status", "failed")
    expect(studio.at("status")).to_contain_text("Nobody is left to go on")
    studio.page.keyboard.press("Enter")
    studio.at("menu-harm-revive").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")


def a_schedule_is_edited_undone_shown_and_kept(studio):
    studio.at("tab-of-team").click()
    studio.at("add-failure").click()
    expect(studio.at("failure-agent-0")).to_be_focused()
    studio.at("failure-agent-0").select_option(ROBOT)
    studio.at("failure-kind-0").select_option("stall")
    studio.at("failure-at-0").fill("0.5")
    studio.page.keyboard.press("Enter")
    expect(studio.at("planned-stall")).to_have_count(1)
    studio.page.keyboard.press("Control+z")
    expect(studio.at("failure-at-0")).to_have_value("10")
    studio.page.keyboard.press("Control+y")
    expect(studio.at("failure-at-0")).to_have_value("0.5")
    studio.page.keyboard.press("Control+s")
    expect(studio.at("saved-state")).to_contain_text("saved")
    studio.at("run-button").click()
    expect(studio.at("event-strip").locator('[data-kind="failure"]')).to_have_count(1)
    expect(studio.at("planned-stall")).to_have_count(0)
    studio.at("failure-remove-0").click()
    expect(studio.at("failure-0")).to_have_count(0)


def stop_leaves_every_robot_standing_still(studio, button):
    studio.at("run-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "running")
    studio.at(button).click()
    expect(studio.at("status")).to_have_attribute("data-status", "stopped")
    assert studio.at("arena-canvas").evaluate(STANDS_STILL)


def robots_fail_by_chance_as_often_as_is_wanted(studio):
    expect(studio.at("chance-on")).to_have_count(0)
    field = studio.at("fail-rate")
    for wrong in ("101", "-1", "often"):
        field.fill(wrong)
        expect(field).to_have_attribute("aria-invalid", "true")
    field.fill("100")
    field.press("Enter")
    expect(studio.at("chance-on")).to_contain_text("100 %")
    studio.full_speed()
    studio.at("run-button").click()
    expect(studio.at("status")).to_contain_text("(by chance)")
    expect(studio.at("event-strip").locator('[data-kind="failure"]').first).to_contain_text("(by chance)")
    expect(field).to_be_enabled()
    assert "fail-rate" not in (studio.folder / "transport.krt").read_text()


def the_list_of_what_happened_says_who_brought_it_about_and_leads_there(studio):
    start_paused(studio)
    choose(studio, ROBOT)
    studio.page.keyboard.press("Enter")
    studio.at("menu-harm-mute").click()
    studio.at("watch-button").click()
    row = studio.at("event-list").locator('tr[data-kind="failure"]')
    expect(row).to_have_count(1)
    expect(row).to_contain_text(ROBOT)
    expect(row.locator("td").last).to_have_text("by hand")
    expect(row).not_to_contain_text("(")
    at = studio.at("event-strip").get_attribute("aria-valuenow")
    assert at is not None
    studio.page.keyboard.press("Escape")
    studio.full_speed()
    studio.at("run-button").click()
    expect(studio.at("event-list").locator('tr[data-kind="load"]').first).to_be_visible()
    # Until the run has ended, rows that come move the others away under the pointer.
    expect(studio.at("pause-button")).to_be_disabled()
    studio.at("event-list").locator('tr[data-kind="failure"] button').click()
    expect(studio.at("event-strip")).to_have_attribute("aria-valuenow", at)
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    # A program may have done something in the same tick, which is above it then.
    expect(row).to_have_attribute("data-cause", "person")
    expect(row).to_be_in_viewport()


@pytest.mark.thorough(
    "web/src/features/team/tab.test.tsx and worlds.test.tsx: schedule and chance; features/run/strip.test.tsx: on "
    "the timeline; server/test_failures.py: in runs"
)
def test_a_schedule_and_chance_let_robots_fail(open_studio):
    studio = open_studio(TRANSPORT)
    a_schedule_is_edited_undone_shown_and_kept(studio)
    studio.at("stop-button").click()
    robots_fail_by_chance_as_often_as_is_wanted(studio)


@pytest.mark.thorough(
    "test_a_robot_is_followed_fails_by_hand_and_the_list_says_who_did_it; web/src/features/debug/watch.test.tsx: "
    "the list"
)
def test_stop_leaves_robots_still_one_is_followed_and_the_list_says_who_did_what(open_studio):
    studio = open_studio(TRANSPORT)
    for button in ("stop-button", "team-stop"):
        stop_leaves_every_robot_standing_still(studio, button)
    who_is_followed_stays_in_the_middle_until_the_world_is_dragged(studio)
    studio.page.keyboard.press("Escape")
    studio.at("stop-button").click()
    the_list_of_what_happened_says_who_brought_it_about_and_leads_there(studio)


def what_was_done_by_hand_is_in_the_list(studio):
    studio.at("watch-button").click()
    row = studio.at("event-list").locator('tr[data-kind="failure"]')
    expect(row.locator("td").last).to_have_text("by hand")


def test_a_robot_is_followed_fails_by_hand_and_the_list_says_who_did_it(open_studio):
    studio = open_studio("square/square.krt")
    stop_leaves_every_robot_standing_still(studio, "stop-button")
    start_paused(studio)
    place = middle_of(studio, "robot-1")
    a_finger_that_rests_opens_the_menu(studio, *place)
    studio.page.mouse.click(*place, button="right")
    studio.at("menu-harm-fail").click()
    expect(studio.at("states-said")).to_contain_text("robot-1: failed")
    expect(studio.at("status")).to_have_attribute("data-status", "failed")
    what_was_done_by_hand_is_in_the_list(studio)
    studio.at("arena-canvas").press("Enter")
    studio.at("menu-harm-revive").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
