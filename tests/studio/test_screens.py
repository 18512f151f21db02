"""axe-core on every screen of the studio, in each theme and in Urdu; and what is said aloud."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import LOOKS, Studio
from tests.studio.looks import AXE, choose, find_nothing

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
TRANSPORT = "transport/transport.krt"
CANVAS, CODE = "[data-testid='canvas']", "[data-testid='code']"
WATCH, ARENA = "[data-testid='watch']", ".side-arena"


@pytest.fixture(autouse=True)
def needs_axe() -> None:
    if not AXE.is_file():
        pytest.fail("the page's tools are not installed; run `make install`")


def select(studio: Studio, testid: str) -> None:
    """Clicks a vertex until it is selected: a theme or a language that comes in just then takes a click away."""
    at = studio.at(testid)
    for _ in range(6):
        at.click()
        try:
            expect(at).to_have_class(re.compile("is-selected"), timeout=5000)
        except AssertionError:
            continue
        return
    raise AssertionError(f"{testid} was not selected")


def axe_finds_nothing_during_a_run(studio: Studio) -> None:
    find_nothing(studio, "the transport mission")
    studio.at("run-button").click()
    expect(studio.page.locator(".vertex.is-active").first).to_be_visible()
    studio.at("pause-button").click()
    find_nothing(studio, "paused")
    studio.at("stop-button").click()


def axe_finds_nothing_on_the_tools_of_the_canvas(studio: Studio) -> None:
    keys = studio.page.keyboard
    studio.page.locator(".vertex").first.click()
    find_nothing(studio, "a part selected")
    keys.press("Shift+F10")
    expect(studio.at("context-menu")).to_be_visible()
    find_nothing(studio, "context menu", within="[data-testid='context-menu']")
    keys.press("Escape")
    keys.press("n")
    expect(studio.at("note-field")).to_be_focused()
    find_nothing(studio, "a note being written", within=CANVAS)
    keys.press("Escape")
    keys.press("/")
    expect(studio.at("add-find")).to_be_focused()
    find_nothing(studio, "type to add", within=CANVAS)
    keys.type("break")
    keys.press("Enter")
    expect(studio.page.locator(".leap")).to_have_count(1)
    expect(studio.page.locator(".vertex.is-selected", has=studio.page.locator(".vertex-name"))).to_be_in_viewport()
    find_nothing(studio, "a Break", within=CANVAS)
    keys.press("Control+f")
    expect(studio.at("find-input")).to_be_focused()
    find_nothing(studio, "find", within=".find")
    keys.type("while")
    expect(studio.at("find-hit-1")).to_be_visible()
    find_nothing(studio, "find with hits", within=".find")
    keys.press("Escape")
    keys.press("m")
    keys.press("a")
    find_nothing(studio, "small map, a selected arc", within=CANVAS)
    studio.at("add-program").click()
    find_nothing(studio, "menu of robots", within=".menu")
    keys.press("Escape")
    keys.press("F2")
    expect(studio.at("tab-name-field")).to_be_focused()
    find_nothing(studio, "a tab being renamed", within=".tabs")


def axe_finds_nothing_on_problems_and_on_text_with_a_mistake(studio: Studio) -> None:
    keys = studio.page.keyboard
    select(studio, "vertex-start")
    keys.press("/")
    expect(studio.at("add-find")).to_be_focused()
    keys.type("while")
    keys.press("Enter")
    expect(studio.page.locator(".trouble").first).to_be_visible()
    keys.press("F8")
    expect(studio.page.locator("#problem-list")).to_be_visible()
    find_nothing(studio, "problems", within="#problem-list")
    studio.edit_code()
    keys.press("Control+End")
    keys.type("\nWheel.")
    expect(studio.page.locator(".cm-tooltip-autocomplete")).to_be_visible()
    find_nothing(studio, "completion", within=CODE)
    keys.press("Escape")
    keys.type("?!")
    find_nothing(studio, "a mistake in the text", within=CODE)
    studio.at("code-tab-listing").click()
    find_nothing(studio, "three-address code", within=".side-code")


@pytest.mark.thorough(
    "test_clipping.py: axe looks at each screen, a part, a menu, a note, find, a mistake and a run among them"
)
@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_axe_finds_nothing_on_the_tools_of_the_canvas_problems_a_mistake_and_a_run(
    open_studio: OpenStudio, look: tuple[str, ...]
) -> None:
    studio = open_studio(TRANSPORT)
    choose(studio, *look)
    axe_finds_nothing_during_a_run(studio)
    axe_finds_nothing_on_the_tools_of_the_canvas(studio)
    studio.page.keyboard.press("Escape")
    studio.take_back()
    axe_finds_nothing_on_problems_and_on_text_with_a_mistake(studio)


@pytest.mark.thorough("test_touch.py: axe looks at the phone and at each of its rooms, in Urdu")
@pytest.mark.parametrize("look", LOOKS, ids=str)
@pytest.mark.parametrize("size", [(390, 844), (1024, 768)], ids=str)
def test_axe_finds_nothing_on_small_screens(
    open_studio: OpenStudio, look: tuple[str, ...], size: tuple[int, int]
) -> None:
    studio = open_studio(TRANSPORT, viewport={"width": size[0], "height": size[1]}, has_touch=True, is_mobile=True)
    choose(studio, *look)
    find_nothing(studio, "main")
    if size[0] < 720:
        for room in ("palette", "inspector", "code", "arena"):
            studio.at(f"room-{room}").click()
            find_nothing(studio, room)


def a_breakpoint_and_the_watch(studio: Studio) -> None:
    keys = studio.page.keyboard
    light = studio.page.locator(".vertex", has_text="Lamp On")
    light.click()
    keys.press("b")
    expect(studio.at("breakpoint-when")).to_be_visible()
    find_nothing(studio, "a breakpoint", within=".side-inspector")
    studio.at("watch-button").click()
    expect(studio.at("watch")).to_be_visible()
    find_nothing(studio, "a watch without a run", within=WATCH)
    studio.at("run-button").click()
    expect(studio.at("status")).to_contain_text("visit 1")
    captor = studio.at("watch-Captor")
    captor.get_by_role("textbox").fill("7")
    keys.press("Enter")
    expect(captor).to_have_attribute("data-forced", "true")
    find_nothing(studio, "the watch of a run", within=WATCH)
    studio.at("watch-button").click()
    light.click()
    keys.press("b")


def the_stage_and_the_result(studio: Studio) -> None:
    keys = studio.page.keyboard
    studio.at("canvas").focus()
    keys.press("f")
    expect(studio.at("stage-watched")).to_be_visible()
    find_nothing(studio, "the stage", within=ARENA)
    studio.full_speed()
    keys.press("F5")
    studio.wait_until_done()
    expect(studio.at("ending")).to_be_visible()
    find_nothing(studio, "the result of a run", within="[data-testid='ending']")
    studio.at("arena-large").click()


def a_merge(studio: Studio) -> None:
    mission = studio.folder / "blink.krt"
    written = mission.read_text()
    assert '<set name="duration">30</set>' in written
    studio.page.locator(".vertex", has_text="3.0 s").locator(".box").dblclick()
    studio.page.keyboard.type("2")
    studio.page.keyboard.press("Enter")
    studio.expect_code("WAIT(20)")
    mission.write_text(written.replace('"duration">30<', '"duration">44<'))
    studio.page.keyboard.press("Control+s")
    studio.at("banner").get_by_role("button", name="Show the difference").click()
    expect(studio.at("differences")).to_be_visible()
    find_nothing(studio, "the difference from the file", within="[data-testid='differences']")
    studio.at("merge").click()
    expect(studio.at("conflicts")).to_be_visible()
    find_nothing(studio, "a merge", within="[data-testid='conflicts']")
    studio.page.keyboard.press("Escape")
    # The browser itself reports each save that was refused.
    studio.faults[:] = [fault for fault in studio.faults if "409" not in fault]


def the_printed_sheet(studio: Studio) -> None:
    studio.page.evaluate("window.dispatchEvent(new Event('beforeprint'))")
    studio.page.emulate_media(media="print")
    expect(studio.at("print-sheet")).to_be_visible()
    find_nothing(studio, "the printed sheet", within="[data-testid='print-sheet']")


@pytest.mark.thorough(
    "test_clipping.py: axe looks at a breakpoint, the watch, the stage and the result; the printed sheet: "
    "test_files_out.py; differences and a merge: web/src/app/DifferenceSheet.test.tsx"
)
def test_axe_finds_nothing_on_a_breakpoint_the_watch_the_stage_a_merge_and_the_printed_sheet(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio("blink/blink.krt")
    studio.page.keyboard.press("f")
    expect(studio.at("stage-watched")).to_contain_text("Press Run")
    find_nothing(studio, "the stage without a run")
    studio.page.keyboard.press("f")
    a_breakpoint_and_the_watch(studio)
    the_stage_and_the_result(studio)
    a_merge(studio)
    the_printed_sheet(studio)


def what_happens_is_said(studio: Studio) -> None:
    keys = studio.page.keyboard
    said = studio.at("announcer")
    studio.at("part-Wait").click()
    expect(said).to_contain_text("Add Wait")
    keys.press("Control+z")
    expect(said).to_contain_text("Undone: Add Wait")
    keys.press("Control+y")
    expect(said).to_contain_text("Done again: Add Wait")
    studio.page.locator(".vertex", has_text="Wheels Stand still").first.click()
    here = studio.at("canvas").get_attribute("aria-activedescendant")
    expect(studio.page.locator(f"#{here}")).to_have_attribute("aria-label", re.compile("Wheels Stand still"))
    keys.press("a")
    expect(said).to_contain_text("Arc after Wheels Stand still")
    keys.press("ArrowUp")
    keys.press("Shift+ArrowDown")
    expect(said).to_contain_text("2 parts selected")
    keys.press("Delete")
    expect(said).to_contain_text("Delete")
    keys.press("Control+z")
    keys.press("Control+f")
    expect(studio.at("find-input")).to_be_focused()
    keys.type("wheel stop")
    expect(studio.at("find-hit-1")).to_be_visible()
    keys.press("Enter")
    expect(said).to_contain_text("Selected: Wheels Stand still")
    keys.press("Escape")
    status = studio.at("status").get_by_role("status")
    studio.at("run-button").click()
    expect(status).to_contain_text("Running")
    studio.at("pause-button").click()
    expect(status).to_contain_text("Paused")
    studio.at("stop-button").click()
    expect(status).to_contain_text("Stopped")


def who_wants_less_motion_gets_none_anywhere(studio: Studio) -> None:
    moving = """() => [...document.querySelectorAll('*')].filter(one => {
        const style = getComputedStyle(one);
        const long = (times) => times.split(',').some(time => parseFloat(time) > 0.001);
        return long(style.transitionDuration) || (style.animationName !== 'none' && long(style.animationDuration));
    }).map(one => one.className.baseVal ?? one.className)"""
    assert studio.page.evaluate(moving) == []
    studio.page.locator(".vertex").first.click()
    studio.page.keyboard.press("z")
    assert studio.page.evaluate("document.getAnimations().length") == 0


@pytest.mark.thorough(
    "web/src/app/reach.test.tsx: what happens is said; less motion: test_clipping.py, the first screen"
)
def test_what_happens_is_said_and_who_wants_less_motion_gets_none(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT, reduced_motion="reduce")
    who_wants_less_motion_gets_none_anywhere(studio)
    what_happens_is_said(studio)
