"""Everyone can work here: in each language, one of them mirrored, by keyboard alone, and axe finds nothing."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Response, expect

from tests.studio.conftest import LOOKS, Studio
from tests.studio.looks import AXE, CUT_OFF, choose, find_nothing
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
TRANSPORT = "transport/transport.krt"


@pytest.fixture(autouse=True)
def needs_axe() -> None:
    if not AXE.is_file():
        pytest.fail("the page's tools are not installed; run `make install`")


@pytest.mark.thorough(
    "test_clipping.py: axe looks at each screen, menus and sheets among them, in one theme and language"
)
@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_axe_finds_nothing_on_menus_sheets_and_the_empty_program(
    open_studio: OpenStudio, look: tuple[str, ...]
) -> None:
    studio = open_studio(TRANSPORT)
    choose(studio, *look)
    keys = studio.page.keyboard
    for menu in ("File", "Edit", "View", "Program", "Run", "Help"):
        studio.at(f"menu-{menu}").click()
        find_nothing(studio, menu, within=".menu")
        keys.press("Escape")
    for press, shown in (("?", "shortcuts-dialog"), ("Control+o", "open-dialog"), ("Control+Shift+s", "save-dialog")):
        studio.at("canvas").focus()
        keys.press(press)
        expect(studio.at(shown)).to_be_visible()
        find_nothing(studio, shown, within=f"[data-testid='{shown}']")
        keys.press("Escape")
    about_names_what_is_inside_and_leads_to_the_licences(studio)
    keys.press("F4")
    expect(studio.at("outline")).to_be_visible()
    find_nothing(studio, "outline", within="[data-testid='outline']")
    keys.press("ArrowDown")
    keys.press("F1")
    expect(studio.at("part-help")).to_be_visible()
    find_nothing(studio, "help", within="[data-testid='part-help']")
    keys.press("Escape")
    studio.at("problems").click()
    find_nothing(studio, "problems", within=".bottom-bar")
    studio.new_mission()
    expect(studio.at("first-place")).to_be_visible()
    find_nothing(studio, "empty program", within="[data-testid='canvas']")


def about_names_what_is_inside_and_leads_to_the_licences(studio: Studio) -> None:
    studio.at("menu-Help").click()
    studio.at("menu-help-about").click()
    about = studio.at("about-dialog")
    expect(about).to_contain_text("Apache")
    find_nothing(studio, "about", within="[data-testid='about-dialog']")
    with studio.page.expect_popup() as opened:
        about.locator("a[href$='licenses.md']").click()
    assert "@codemirror/view" in opened.value.content()
    assert opened.value.url.endswith("/licenses.md")
    opened.value.close()
    studio.page.keyboard.press("Escape")


WIDER = "() => document.documentElement.scrollWidth > document.documentElement.clientWidth"


def left(studio: Studio, testid: str) -> float:
    return place_of(studio.at(testid))["x"]


def urdu_mirrors_the_page_and_cuts_nothing_off(studio: Studio) -> None:
    assert left(studio, "part-While") < left(studio, "canvas") < left(studio, "arena")
    choose(studio, "ur")
    html = studio.page.locator("html")
    expect(html).to_have_attribute("dir", "rtl")
    expect(html).to_have_attribute("lang", "ur")
    expect(studio.at("run-button")).to_have_text("چلائیں")
    for width, height in ((1600, 1000), (1366, 768)):
        studio.page.set_viewport_size({"width": width, "height": height})
        assert left(studio, "part-While") > left(studio, "canvas") > left(studio, "arena")
        assert left(studio, "undo") > left(studio, "run-button") > left(studio, "team-stop")
        assert studio.page.evaluate(WIDER) is False
        assert studio.page.evaluate(CUT_OFF) == []
    direction = "one => getComputedStyle(one).direction"
    assert studio.page.locator('[data-testid="code"] .cm-content').evaluate(direction) == "ltr"
    start, stop = place_of(studio.at("vertex-start")), place_of(studio.page.locator(".vertex").first)
    assert start["y"] < stop["y"], "the program still goes down"


def a_menu_and_arrow_keys_follow_the_mirrored_page(studio: Studio) -> None:
    studio.at("menu-File").focus()
    studio.page.keyboard.press("ArrowLeft")
    expect(studio.at("menu-Edit")).to_be_focused()
    studio.at("speed").focus()
    studio.page.keyboard.press("ArrowLeft")
    expect(studio.at("speed")).to_have_attribute("aria-valuetext", "2×")


def test_urdu_mirrors_the_page_its_menus_and_arrow_keys_and_cuts_nothing_off(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    a_system_that_wants_more_contrast_gets_it(studio)
    urdu_mirrors_the_page_and_cuts_nothing_off(studio)
    a_menu_and_arrow_keys_follow_the_mirrored_page(studio)


def language_and_theme_are_remembered(studio: Studio) -> None:
    choose(studio, "fr", "contrast")
    expect(studio.at("run-button")).to_have_text("Lancer")
    studio.page.reload()
    expect(studio.at("run-button")).to_have_text("Lancer")
    expect(studio.page.locator("html")).to_have_attribute("data-theme", "contrast")


def a_system_that_wants_more_contrast_gets_it(studio: Studio) -> None:
    studio.page.emulate_media(contrast="more")
    expect(studio.page.locator("html")).to_have_attribute("data-theme", "contrast")


def another_language_keeps_the_document_and_its_history(studio: Studio) -> None:
    studio.drop("Wait", "arc-start.next")
    choose(studio, "fr")
    expect(studio.at("undo")).to_be_enabled()
    studio.at("undo").click()
    expect(studio.at("undo")).to_be_disabled()


def what_is_done_in_another_language_is_kept_in_the_journal(studio: Studio) -> None:
    def is_work_kept(answer: Response) -> bool:
        """Whether it answers a journal with work in it: what was undone before may still be on its way."""
        sent = answer.request.post_data_json if answer.request.method != "GET" else None
        return answer.url.partition("?")[0].endswith("/api/journal") and bool(sent and sent["unsaved"])

    with studio.page.expect_response(is_work_kept) as kept:
        studio.drop("Wait", "arc-start.next")
    assert kept.value.ok
    studio.page.reload()
    expect(studio.at("undo")).to_be_enabled()
    studio.expect_code("WAIT(10);")
    studio.at("undo").click()


def test_language_theme_and_work_are_there_after_another_language_and_a_reload(open_studio: OpenStudio) -> None:
    studio = open_studio("square/square.krt")
    choose(studio, "fr", "contrast")
    what_is_done_in_another_language_is_kept_in_the_journal(studio)
    expect(studio.at("run-button")).to_have_text("Lancer")
    expect(studio.page.locator("html")).to_have_attribute("data-theme", "contrast")


@pytest.mark.thorough(
    "test_language_theme_and_work_are_there_after_another_language_and_a_reload; a history that another language "
    "keeps: web/src/model/everything.test.ts, the document knows no language"
)
def test_another_language_keeps_the_document_with_its_history_and_is_remembered_with_the_theme(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(TRANSPORT)
    another_language_keeps_the_document_and_its_history(studio)
    what_is_done_in_another_language_is_kept_in_the_journal(studio)
    language_and_theme_are_remembered(studio)


def the_outline_walks_the_program_and_deletes_with_the_keyboard_alone(studio: Studio) -> None:
    keys = studio.page.keyboard
    keys.press("F4")
    rows = studio.at("outline").get_by_role("treeitem")
    expect(rows.first).to_be_focused()
    keys.press("ArrowDown")
    expect(rows.nth(1)).to_be_focused()
    expect(rows.nth(1)).to_have_attribute("aria-selected", "true")
    keys.press("ArrowRight")
    expect(rows.nth(2)).to_be_focused()
    expect(rows.nth(2)).to_have_attribute("aria-level", "2")
    keys.press("ArrowLeft")
    keys.press("Delete")
    expect(studio.at("announcer")).not_to_be_empty()
    keys.press("Control+z")
    expect(studio.at("announcer")).to_contain_text("Undone")
    keys.press("Escape")
    expect(studio.at("outline")).to_have_count(0)
    expect(studio.at("canvas")).to_be_focused()


def f1_explains_the_part_that_has_the_focus_with_its_range(studio: Studio) -> None:
    studio.at("part-Wheel.Advance").focus()
    studio.page.keyboard.press("F1")
    expect(studio.at("part-help")).to_contain_text("Starts driving forward")
    expect(studio.at("part-help")).to_contain_text("from 0 % to 100 %")
    studio.page.keyboard.press("Escape")
    expect(studio.at("part-help")).to_have_count(0)
    expect(studio.at("part-Wheel.Advance")).to_be_focused()


def the_empty_program_fits_a_small_window(studio: Studio) -> None:
    studio.page.set_viewport_size({"width": 1366, "height": 768})
    studio.new_mission()
    card, canvas = place_of(studio.page.locator(".teaching")), place_of(studio.at("canvas"))
    assert card["x"] >= canvas["x"]
    assert card["x"] + card["width"] <= canvas["x"] + canvas["width"]


@pytest.mark.thorough(
    "web/src/app/reach.test.tsx: F1 and the outline; more contrast: test_urdu_mirrors_the_page…; the empty program:"
    " test_clipping.py, the screen nothing yet"
)
def test_the_outline_and_f1_help_by_keys_and_more_contrast_are_there_and_a_small_window_is_enough(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(TRANSPORT)
    f1_explains_the_part_that_has_the_focus_with_its_range(studio)
    the_outline_walks_the_program_and_deletes_with_the_keyboard_alone(studio)
    a_system_that_wants_more_contrast_gets_it(studio)
    the_empty_program_fits_a_small_window(studio)
