"""A user edits a graph by hand: clipboard, menus, wrapping, finding, folding — with mouse, keyboard and finger."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.studio.conftest import Studio
from tests.studio.studio_page import place_of
from tests.studio.test_drags import a_test_docks_in_a_slot_and_nests_in_the_hole_of_another

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
TRANSPORT = "transport/transport.krt"


def vertex(studio: Studio, words: str) -> Locator:
    """The first vertex of the graph that says that."""
    return studio.page.locator(".vertex", has_text=words).first


def allow_clipboard(studio: Studio) -> None:
    studio.page.context.grant_permissions(["clipboard-read", "clipboard-write"])


def clipboard(studio: Studio) -> str:
    return str(studio.page.evaluate("navigator.clipboard.readText()"))


def paste(studio: Studio, text: str) -> None:
    """Puts a text on the clipboard, as another program would, and presses the keys."""
    studio.page.evaluate("text => navigator.clipboard.writeText(text)", text)
    studio.page.keyboard.press("Control+v")


def add_two_parts(studio: Studio) -> None:
    """A Wait and a lamp at the beginning of the program in view, in this order."""
    studio.drop("Wait", "arc-start.next")
    studio.expect_code("WAIT(10);")


def copied_parts_are_lll_text_and_paste_into_another_program(studio: Studio) -> None:
    add_two_parts(studio)
    vertex(studio, "Wait").click()
    studio.page.keyboard.press("Control+c")
    assert clipboard(studio) == "WAIT(10);\n"
    studio.at("tab-store-manager-A").click()
    expect(studio.at("code")).not_to_contain_text("WAIT(10);")
    studio.page.get_by_test_id("vertex-start").click()
    studio.page.keyboard.press("Control+v")
    studio.expect_code("WAIT(10);")
    studio.page.keyboard.press("Control+z")
    expect(studio.at("code")).not_to_contain_text("WAIT(10);")


def cut_takes_away_and_paste_puts_back(studio: Studio) -> None:
    studio.at("tab-carrier").click()
    vertex(studio, "Wait").click()
    studio.page.keyboard.press("Control+x")
    expect(studio.at("code")).not_to_contain_text("WAIT(10);")
    studio.page.keyboard.press("Control+v")
    studio.expect_code("WAIT(10);")


def lll_typed_elsewhere_pastes_as_parts(studio: Studio) -> None:
    studio.at("vertex-start").click()
    paste(studio, "# hello\n3*(WAIT(77););")
    studio.expect_code("# hello")
    studio.expect_code("3*( WAIT(77); );")


def pasted_rubbish_is_told_in_a_sentence_and_changes_nothing(studio: Studio, before: str) -> None:
    studio.at("vertex-start").click()
    paste(studio, "Dear all, please find attached")
    expect(studio.at("said")).to_contain_text("no program text")
    paste(studio, "*[Run.IsTrue()](" * 10_000)
    expect(studio.at("said")).to_be_visible()
    studio.expect_whole_code(before)
    expect(studio.at("saved-state")).to_have_text("saved")


@pytest.mark.thorough(
    "web/src/features/canvas/clipboard.test.tsx: copied, cut, pasted, refused; server/test_fragments.py reads the "
    "text; the browser's own clipboard: test_the_graph_is_edited_with_mouse_keys_and_clipboard"
)
def test_parts_are_copied_cut_and_pasted_as_lll_text_and_rubbish_is_refused(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    allow_clipboard(studio)
    before = studio.code()
    copied_parts_are_lll_text_and_paste_into_another_program(studio)
    cut_takes_away_and_paste_puts_back(studio)
    studio.take_back()
    lll_typed_elsewhere_pastes_as_parts(studio)
    studio.take_back()
    # The text follows the graph by way of the server.
    expect(studio.page.locator('[data-testid="code"] .cm-line')).to_have_text(before.split("\n"))
    pasted_rubbish_is_told_in_a_sentence_and_changes_nothing(studio, before)


def right_click_opens_a_menu_that_works_on_what_is_under_it(studio: Studio) -> None:
    add_two_parts(studio)
    vertex(studio, "Wait").click(button="right")
    expect(studio.at("context-menu")).to_be_visible()
    studio.at("menu-context-duplicate").click()
    expect(studio.page.locator(".vertex-name", has_text="Wait")).to_have_count(2)
    vertex(studio, "Wait").click(button="right")
    studio.at("menu-context-delete").click()
    expect(studio.page.locator(".vertex-name", has_text="Wait")).to_have_count(1)
    studio.at("arc-start.next").click(button="right")
    studio.at("menu-context-add").click()
    expect(studio.at("add-find")).to_be_focused()


def the_keyboard_opens_the_menu_of_the_selected_part(studio: Studio) -> None:
    studio.page.keyboard.press("Escape")
    vertex(studio, "Wait").click()
    studio.page.keyboard.press("Shift+F10")
    expect(studio.at("context-menu")).to_be_visible()
    studio.page.keyboard.press("Escape")
    expect(studio.at("context-menu")).to_have_count(0)
    expect(studio.at("canvas")).to_be_focused()
    studio.page.keyboard.press("ContextMenu")
    expect(studio.at("context-menu")).to_be_visible()
    studio.page.keyboard.type("D")
    studio.page.keyboard.press("Enter")
    expect(studio.page.locator(".vertex-name", has_text="Wait")).to_have_count(2)


def a_loop_dropped_on_the_selection_encloses_it_and_unwraps(studio: Studio) -> None:
    add_two_parts(studio)
    before = studio.code()
    vertex(studio, "Wait").click()
    studio.page.locator(".vertex", has_text="While").first.click(modifiers=["Shift"])
    studio.drag(studio.at("part-Repetition"), vertex(studio, "Wait"))
    studio.expect_code("10*(")
    expect(studio.at("code")).to_contain_text(re.compile(r"10\*\(\s*WAIT\(10\);"))
    studio.page.keyboard.press("Shift+W")
    expect(studio.at("code")).not_to_contain_text("10*(")
    studio.expect_whole_code(before)


def w_asks_for_the_part_that_goes_around_the_selection(studio: Studio) -> None:
    vertex(studio, "Wait").click()
    studio.page.keyboard.press("w")
    studio.at("add-find").fill("if")
    expect(studio.at("add-Wait")).to_have_count(0)
    studio.page.keyboard.press("Enter")
    expect(studio.at("code")).to_contain_text(re.compile(r"\]\( WAIT\(10\); \)"))
    studio.page.keyboard.press("Control+z")
    expect(studio.at("code")).not_to_contain_text(re.compile(r"\]\( WAIT\(10\); \)"))


def find_looks_through_all_programs_and_enter_goes_there(studio: Studio) -> None:
    studio.page.keyboard.press("Control+f")
    expect(studio.at("find-input")).to_be_focused()
    studio.page.keyboard.type("no such words")
    # The first keys may be kept until the panel is there, and are pressed one after another then.
    expect(studio.at("find-input")).to_have_value("no such words")
    expect(studio.at("find")).to_contain_text("Nothing says")
    studio.at("find-input").fill("wheel stand")
    expect(studio.at("find-hit-1")).to_contain_text("Wheels Stand still")
    studio.page.keyboard.press("Enter")
    expect(studio.page.locator(".vertex.is-selected", has_text="Stand still")).to_be_in_viewport()
    expect(studio.at("find-input")).to_be_focused()
    studio.at("find-input").fill("while")
    studio.page.keyboard.press("Shift+Enter")
    expect(studio.at("tab-carrier")).to_have_attribute("aria-selected", "false")
    expect(studio.page.locator(".vertex.is-selected", has_text="While")).to_be_in_viewport()
    studio.page.keyboard.press("Enter")
    expect(studio.at("tab-carrier")).to_have_attribute("aria-selected", "true")
    studio.page.keyboard.press("Escape")
    expect(studio.at("find")).to_have_count(0)
    expect(studio.at("canvas")).to_be_focused()


def a_collapsed_body_says_how_much_it_holds_and_glows_for_it(studio: Studio) -> None:
    outer = studio.page.locator(".vertex", has_text="While").first
    name = (outer.get_attribute("data-testid") or "").removeprefix("vertex-")
    studio.at(f"collapse-{name}").click()
    expect(outer).to_contain_text(re.compile(r"\d+ parts"))
    expect(studio.page.locator(".vertex")).to_have_count(1)
    expect(studio.at("saved-state")).to_have_text("saved")
    studio.at("run-button").click()
    expect(studio.page.locator(".vertex.is-active", has_text="parts")).to_be_visible()
    studio.at("stop-button").click()
    outer.click()
    studio.page.keyboard.press("c")
    expect(studio.page.locator(".vertex", has_text="Wheels Drive").first).to_be_visible()


def shift_drag_on_the_void_selects_what_the_box_touches(studio: Studio) -> None:
    canvas = place_of(studio.at("canvas"))
    studio.page.keyboard.down("Shift")
    studio.page.mouse.move(canvas["x"] + 6, canvas["y"] + 6)
    studio.page.mouse.down()
    studio.page.mouse.move(canvas["x"] + canvas["width"] - 8, canvas["y"] + 150, steps=6)
    expect(studio.page.locator(".marquee")).to_be_visible()
    studio.page.mouse.up()
    studio.page.keyboard.up("Shift")
    expect(studio.page.locator(".marquee")).to_have_count(0)
    expect(studio.page.locator(".vertex.is-selected, .bars.is-selected").first).to_be_visible()
    start = place_of(studio.at("vertex-start"))
    assert abs(start["y"] - canvas["y"] - 18) < 8, "the canvas did not move along"


@pytest.mark.thorough(
    "web/src/features/canvas/editing.test.tsx: menus, wrapping, the box; a box and a menu by a real mouse: "
    "test_the_graph_is_edited_with_mouse_keys_and_clipboard"
)
def test_menus_boxes_and_wrapping_work_on_what_is_selected(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    shift_drag_on_the_void_selects_what_the_box_touches(studio)
    studio.page.keyboard.press("Escape")
    a_loop_dropped_on_the_selection_encloses_it_and_unwraps(studio)
    w_asks_for_the_part_that_goes_around_the_selection(studio)
    studio.take_back()
    right_click_opens_a_menu_that_works_on_what_is_under_it(studio)
    the_keyboard_opens_the_menu_of_the_selected_part(studio)


def beside_the_graph(studio: Studio) -> tuple[float, float]:
    """A point near the lower left corner of the canvas."""
    canvas = place_of(studio.at("canvas"))
    return canvas["x"] + 20, canvas["y"] + canvas["height"] - 20


def keys_zoom_to_the_selection_show_the_map_and_follow_the_run(studio: Studio) -> None:
    deep = vertex(studio, "Road ahead free")
    deep.click()
    studio.page.keyboard.press("z")
    expect(studio.page.locator(".zoom-percent")).to_have_text("125 %")
    expect(deep).to_be_in_viewport(ratio=1)
    studio.page.keyboard.press("m")
    expect(studio.at("minimap")).to_be_visible()
    studio.page.keyboard.press("m")
    expect(studio.at("minimap")).to_have_count(0)
    follow = studio.at("follow-button")
    studio.at("run-button").click()
    expect(follow).to_have_attribute("aria-pressed", "true")
    expect(studio.page.locator(".vertex.is-active").first).to_be_in_viewport()
    studio.page.mouse.move(*beside_the_graph(studio))
    studio.page.mouse.wheel(0, 60)
    expect(follow).to_have_attribute("aria-pressed", "false")
    follow.click()
    expect(follow).to_have_attribute("aria-pressed", "true")
    studio.at("stop-button").click()


@pytest.mark.thorough(
    "web/src/features/canvas/find.test.tsx: find, folds and the camera; active.test.tsx: what runs is followed "
    "until the canvas is moved; Pane.test.tsx: by the wheel"
)
def test_keys_zoom_show_the_map_follow_the_run_find_in_all_programs_and_fold(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    a_collapsed_body_says_how_much_it_holds_and_glows_for_it(studio)
    keys_zoom_to_the_selection_show_the_map_and_follow_the_run(studio)
    find_looks_through_all_programs_and_enter_goes_there(studio)


def a_menu_opens_under_the_mouse(studio: Studio) -> None:
    vertex(studio, "Wheels Stand still").click(button="right")
    studio.at("menu-context-duplicate").click()
    expect(studio.page.locator(".vertex-name", has_text="Stand still")).to_have_count(2)


def test_the_graph_is_edited_with_mouse_keys_and_clipboard(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    allow_clipboard(studio)
    shift_drag_on_the_void_selects_what_the_box_touches(studio)
    a_menu_opens_under_the_mouse(studio)
    studio.take_back()
    a_test_docks_in_a_slot_and_nests_in_the_hole_of_another(studio)
    studio.at("part-find").fill("")
    studio.take_back()
    copied_parts_are_lll_text_and_paste_into_another_program(studio)
    lll_typed_elsewhere_pastes_as_parts(studio)
