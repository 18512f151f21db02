"""The simple view, which a new user begins with; and the page for eyes that need other colours or larger letters."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, ViewportSize, expect

from tests.effort import cases
from tests.studio.conftest import Studio
from tests.studio.studio_page import place_of
from tests.studio.test_touch import RobotSession, middle

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
SQUARE, CONVOY = "draw-square/draw-square.krt", "convoy/convoy.krt"
DETAILS = ("seed", "step-button", "step-back-button", "code-tab-listing", "tab-of-team")


def switch(studio: Studio) -> None:
    """View, Simple."""
    studio.at("menu-View").click()
    studio.at("menu-view-simple").click()


def test_a_new_user_sees_no_details_until_the_switch_says_so(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE, first_visit=True)
    for detail in DETAILS:
        expect(studio.at(detail)).to_have_count(0)
    switch(studio)
    for detail in DETAILS:
        expect(studio.at(detail)).to_have_count(1)


@pytest.mark.thorough(
    "the test above; web/src/session/simple-view.test.ts: by one switch each, remembered; "
    "app/AddProgram.test.tsx; features/run/bars.test.tsx: the timeline; app/Shortcuts.test.tsx: lines are found "
    "by other words"
)
def test_menus_keys_and_the_timeline_have_no_details_until_the_switch_says_so(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE, first_visit=True)
    studio.at("add-program").click()
    expect(studio.page.get_by_role("menu")).to_contain_text("Mini-robot")
    expect(studio.at("menu-add-team-program")).to_have_count(0)
    studio.page.keyboard.press("Escape")
    studio.at("menu-Run").click()
    expect(studio.at("menu-run-run")).to_be_visible()
    expect(studio.at("menu-run-check")).to_have_count(0)
    studio.page.keyboard.press("Escape")
    # The list of keys has the switch, by the words of somebody who looks for what is not there.
    studio.page.keyboard.press("?")
    studio.page.get_by_role("dialog").get_by_role("searchbox").fill("expert")
    expect(studio.page.get_by_role("dialog")).to_contain_text("Simple")
    studio.page.keyboard.press("Escape")
    studio.page.keyboard.press("Escape")
    switch(studio)
    studio.page.reload()
    expect(studio.at("tab-of-team")).to_be_visible()
    # The moment on the timeline has its tick, or not.
    studio.at("run-button").click()
    studio.at("pause-button").click()
    strip = studio.at("event-strip")
    expect(strip).to_have_attribute("aria-valuetext", re.compile("tick"))
    switch(studio)
    expect(strip).to_have_attribute("aria-valuetext", re.compile(r"^[\d:.]+$"))


@pytest.mark.thorough("web/src/session/simple-view.test.ts: each need shows everything, and it is said once")
def test_a_mission_with_a_need_shows_everything_and_says_why(open_studio: OpenStudio) -> None:
    studio = open_studio(CONVOY, first_visit=True)
    expect(studio.at("banner")).to_contain_text("so everything is shown")
    for detail in DETAILS:
        expect(studio.at(detail)).to_have_count(1)
    studio.at("menu-View").click()
    expect(studio.at("menu-view-simple")).to_have_attribute("aria-disabled", "true")


GROUNDS = """() => {
    const style = (selector, pseudo) => getComputedStyle(document.querySelector(selector), pseudo);
    const differ = (on, off) => style(on).backgroundColor !== style(off).backgroundColor;
    const track = style('[data-testid=speed]', '::-webkit-slider-runnable-track');
    return {
        'a border around Run': parseFloat(style('.run-button').borderTopWidth) >= 2,
        'a border around STOP': parseFloat(style('.team-stop').borderTopWidth) >= 2,
        'the tab that is open': differ('.tab[aria-selected=true]', '.tab[aria-selected=false]'),
        'the tab of the parts': differ('.palette-tab[aria-current=true]', '.palette-tab:not([aria-current=true])'),
        'what is on in the zoom': differ('.zoom [aria-pressed=true]', '.zoom button:not([aria-pressed=true])'),
        'the track of the timeline': style('.strip-track').stroke !== 'none',
        'words on ink': style('.run-button').color !== style('.run-button').backgroundColor,
        'the track of the speed': style('[data-testid=speed]').forcedColorAdjust === 'none',
        'a vertex on its ground': style('.vertex .outline-body').fill !== style('.vertex').color,
    };
}"""


def test_forced_colours_keep_borders_tracks_and_what_is_chosen(open_studio: OpenStudio) -> None:
    page = open_studio(SQUARE).page
    for dark in (False, True):
        page.emulate_media(forced_colors="active", color_scheme="dark" if dark else "light")
        kept = page.evaluate(GROUNDS)
        assert [what for what, there in kept.items() if not there] == [], "dark" if dark else "light"


def box_of(page: Page, selector: str) -> tuple[float, float]:
    box = place_of(page.locator(selector))
    return box["width"], box["height"]


def test_graph_and_stage_take_turns_at_200_percent(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE, viewport={"width": 720, "height": 450}, first_visit=True)
    page = studio.page
    width, height = box_of(page, ".canvas")
    assert width >= 600
    assert height >= 200
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    width, height = box_of(page, ".arena-frame")
    assert width >= 600
    assert height >= 240
    expect(studio.at("canvas")).not_to_be_visible()
    studio.at("room-arena").click()
    expect(studio.at("canvas")).to_be_visible()
    # A room stands beside the graph.
    studio.at("room-palette").click()
    parts, graph = place_of(page.locator(".parts")), place_of(page.locator(".canvas"))
    assert graph["x"] + graph["width"] <= parts["x"] + 1
    assert graph["width"] >= 300
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


OUTSIDE = """() => [...document.querySelectorAll(
    '[role=menu], [role=listbox], dialog[open], [role=dialog], .in-place, .adding, .find')]
    .filter((one) => one.checkVisibility())
    .map((one) => [one.id || one.className, one.getBoundingClientRect()])
    .filter(([, { left, top, right, bottom }]) => left < -0.5 || top < -0.5 || right > innerWidth + 0.5
        || bottom > innerHeight + 0.5)
    .map(([name, { left, top, right, bottom }]) => `${name}: ${[left, top, right, bottom].map(Math.round)}`)"""


SIZES = [ViewportSize(width=390, height=844), ViewportSize(width=720, height=450)]
"""Windows that are narrow and low, by turns; in the thorough profile each for everything that opens."""


@pytest.mark.parametrize("turn", cases([0], [1]))
def test_nothing_that_opens_leaves_the_window(open_studio: OpenStudio, turn: int) -> None:
    studio = open_studio(SQUARE, viewport=SIZES[turn])
    page = studio.page
    found: list[str] = []

    def look(what: str) -> None:
        nonlocal turn
        page.wait_for_function("document.getAnimations().every((one) => one.playState !== 'running')")
        found.extend(f"{what}: {one}" for one in page.evaluate(OUTSIDE))
        page.keyboard.press("Escape")
        turn += 1
        page.set_viewport_size(SIZES[turn % 2])

    for title in page.locator(".menubar-title").all():
        if title.is_visible():
            title.click()
            expect(page.get_by_role("menu").first).to_be_visible()
            look(title.inner_text())
    studio.at("add-program").click()
    expect(page.get_by_role("menu").first).to_be_visible()
    look("a new program")
    last = page.locator(".vertex").last
    last.scroll_into_view_if_needed()
    last.click(button="right", position={"x": 6, "y": 6}, force=True)
    expect(studio.at("context-menu")).to_be_visible()
    look("a part's menu")
    last.click(position={"x": 6, "y": 6}, force=True)
    for key, opened in (("/", ".adding"), ("4", ".in-place"), ("Control+f", ".find")):
        last.focus()
        page.keyboard.press(key)
        expect(page.locator(opened).first).to_be_visible()
        look(key)
    for entry, shown in (("file-open", "open-dialog"), ("file-save-as", "save-name")):
        studio.at("menu-File").click()
        studio.at(f"menu-{entry}").click()
        expect(studio.at(shown)).to_be_visible()
        look(entry)
    assert found == []


@pytest.mark.thorough(
    "web/src/session/drag.test.ts: what is let go over the parts is thrown away; a finger "
    "drags a part: tests/studio/test_touch.py"
)
def test_a_finger_throws_a_part_away_on_the_parts(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE, viewport={"width": 1024, "height": 768}, has_touch=True, is_mobile=True)
    hand = RobotSession(studio)
    turn = studio.page.locator(".vertex", has_text="Turn left")
    begin, end = middle(turn.locator(".tile")), middle(studio.at("part-find"))
    hand.put("touchStart", begin)
    hand.move((begin, (begin[0] - 30, begin[1])))
    expect(studio.at("parts-bin")).to_contain_text("throw away")
    # Its own arc is no place for it; those around it are.
    mine = (turn.get_attribute("data-testid") or "").removeprefix("vertex-")
    expect(studio.page.locator(f'.arc[data-arc^="{mine}."]').first).to_have_class(re.compile("is-own"))
    hand.move(((begin[0] - 30, begin[1]), end))
    expect(studio.at("parts-bin")).to_have_attribute("data-away", "true")
    hand.put("touchEnd")
    expect(turn).to_have_count(0)
    expect(studio.at("parts-bin")).to_have_count(0)
    studio.take_back()
    expect(turn).to_have_count(1)
