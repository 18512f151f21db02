"""A person writes LLL and the graph follows; a person draws and the text follows: in the real page, with real keys."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.effort import cases
from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
TRANSPORT = "transport/transport.krt"
VERTICES = ".canvas-node"


def editor(studio: Studio) -> Page:
    """The page, its code editor ready to be written in, the caret at its very end."""
    studio.edit_code()
    studio.page.keyboard.press("Control+End")
    return studio.page


def opened(open_studio: OpenStudio, example: str = "blink/blink.krt") -> tuple[Studio, str]:
    """The studio on an example, and its text once it is there."""
    studio = open_studio(example)
    studio.expect_code("*[Run.IsTrue()](")
    return studio, studio.code()


def empty(open_studio: OpenStudio) -> Studio:
    """The studio on a new mission."""
    studio = open_studio(None)
    studio.new_mission()
    expect(studio.at("first-place")).to_be_visible()
    return studio


def replace_all(studio: Studio, text: str) -> None:
    """Pastes over everything, as a person would."""
    page = editor(studio)
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(text)


def expect_vertices(studio: Studio, name: str, count: int) -> None:
    expect(studio.page.locator(".vertex", has_text=name)).to_have_count(count)


def take_first(studio: Studio, text: str) -> None:
    """Presses Enter on the first option, once the list is old enough to take it for an answer (75 ms)."""
    studio.page.evaluate("() => new Promise((ready) => setTimeout(ready, 100))")
    studio.page.keyboard.press("Enter")
    studio.expect_code(text)


def leave(studio: Studio) -> None:
    """Puts the focus elsewhere."""
    studio.at("code-tab-lll").focus()


def expect_text(studio: Studio, text: str) -> None:
    expect(studio.at("code").locator(".cm-content")).to_have_text(re.compile(text))


def an_instruction_that_is_typed_appears_as_a_vertex_and_undo_takes_both_back(studio: Studio, before: str) -> None:
    page = editor(studio)
    page.keyboard.insert_text("\n  WAIT( 7 )")
    expect_vertices(studio, "Wait", len(re.findall("WAIT", before)) + 1)
    assert studio.code().endswith("  WAIT( 7 )"), "the text stays as it was typed"
    page.keyboard.press("Control+z")
    expect_vertices(studio, "Wait", len(re.findall("WAIT", before)))
    studio.expect_whole_code(before)
    page.keyboard.press("Control+y")
    expect_vertices(studio, "Wait", len(re.findall("WAIT", before)) + 1)
    leave(studio)
    expect_text(studio, r"WAIT\(7\);$")


@pytest.mark.thorough("web/src/session/typing.test.ts: typing becomes one command a burst, which undo takes back")
def test_a_burst_of_typing_is_one_step_of_undo(open_studio: OpenStudio) -> None:
    studio = empty(open_studio)
    # The page's clock stands still: on a slow machine there is a pause between any two letters.
    studio.page.evaluate("Date.now = ((now) => () => now)(Date.now())")
    editor(studio).keyboard.type("Light.LightOn();Light.LightOff();", delay=20)
    expect_vertices(studio, "Lamp", 2)
    leave(studio)
    studio.at("menu-Edit").click()
    expect(studio.page.get_by_text("Edit text").first).to_be_visible()
    studio.page.keyboard.press("Escape")
    studio.page.keyboard.press("Control+z")
    expect_vertices(studio, "Lamp", 0)


def a_mistake_is_marked_on_both_sides_and_the_graph_stays(studio: Studio) -> None:
    expect(studio.at("problems")).to_contain_text("0")
    before = studio.page.locator(VERTICES).count()
    page = editor(studio)
    page.keyboard.insert_text("\nLight.Lighton(")
    expect(studio.at("code-state")).to_contain_text("The graph shows the last text without mistakes.")
    expect(studio.at("code").locator(".cm-lintRange-error").first).to_be_visible()
    expect(studio.at("problems")).not_to_contain_text("0")
    assert studio.page.locator(VERTICES).count() == before
    leave(studio)
    assert studio.code().endswith("Light.Lighton("), "what is unfinished stays when the editor is left"
    editor(studio)
    for _ in range(len("Lighton(")):
        page.keyboard.press("Backspace")
    page.keyboard.insert_text("LightOff();")
    expect(studio.at("code-state")).to_be_empty()
    expect(studio.at("code").locator(".cm-lintRange-error")).to_have_count(0)
    expect(studio.at("problems")).to_contain_text("0")
    expect(studio.page.locator(VERTICES)).to_have_count(before + 1)


def a_mistake_inside_an_instruction_is_marked_on_its_vertex(studio: Studio) -> None:
    replace_all(studio, "Light.LightOn();")
    expect_vertices(studio, "Lamp", 1)
    page = editor(studio)
    for _ in range(len("On();")):
        page.keyboard.press("Backspace")
    page.keyboard.insert_text("Up();")
    expect(studio.at("code-state")).to_contain_text("LightUp")
    expect(studio.page.locator('.trouble[data-severity="error"]')).to_have_count(1)


def undo_of_unfinished_text_goes_back_to_the_last_text_without_mistakes(studio: Studio) -> None:
    before = studio.code()
    page = editor(studio)
    page.keyboard.insert_text(" [[[")
    expect(studio.at("code-state")).to_contain_text("The graph shows")
    page.keyboard.press("Control+z")
    expect(studio.at("code-state")).to_be_empty()
    studio.expect_whole_code(before)
    expect(studio.at("saved-state")).to_have_text("saved")


def an_edit_of_the_text_leaves_the_selected_vertex_selected(studio: Studio) -> None:
    studio.page.locator(".vertex", has_text="Wait").first.click()
    expect(studio.page.locator(".vertex.is-selected")).to_have_count(1)
    page = editor(studio)
    page.keyboard.press("Control+Home")
    page.keyboard.insert_text("Light.LightOff();\n")
    studio.expect_code("Light.LightOff();")
    expect(studio.page.locator(".vertex.is-selected", has_text="Wait")).to_have_count(1)


def an_edit_of_the_graph_changes_the_text_and_the_other_way_round(studio: Studio) -> None:
    studio.drop("Wait", "arc-start.next")
    studio.expect_code("WAIT(10);")
    replace_all(studio, "Light.LightOn();")
    expect_vertices(studio, "Wait", 0)
    leave(studio)
    studio.page.keyboard.press("Control+z")
    studio.expect_code("WAIT(10);")


@pytest.mark.thorough("web/src/session/typing.test.ts; server/test_text.py")
def test_graph_and_text_follow_each_other_and_the_selection_stays(open_studio: OpenStudio) -> None:
    studio, _ = opened(open_studio)
    an_edit_of_the_graph_changes_the_text_and_the_other_way_round(studio)
    studio.take_back()
    an_edit_of_the_text_leaves_the_selected_vertex_selected(studio)


def a_program_is_written_with_completion_and_keys_alone(studio: Studio) -> None:
    page = editor(studio)
    options = page.locator(".cm-tooltip-autocomplete li")
    page.keyboard.type("Whe")
    expect(options.first).to_contain_text("Wheel")
    take_first(studio, "Wheel.")
    page.keyboard.type("Adv")
    expect(options.first).to_contain_text("Advance")
    take_first(studio, "Wheel.Advance(")
    page.keyboard.type("33")
    expect_vertices(studio, "Keep driving", 1)
    studio.expect_code("Wheel.Advance(33);")


@pytest.mark.thorough("web/src/components/text/team-completion.test.ts; test_a_new_program_is_typed_with_completion…")
def test_a_block_of_a_team_is_written_with_completion(open_studio: OpenStudio) -> None:
    studio = open_studio("convoy/convoy.krt")
    studio.expect_code("SeqOfPar convoy (")
    page = editor(studio)
    options = page.locator(".cm-tooltip-autocomplete li")
    page.keyboard.insert_text("\nParOfSeq ")
    page.keyboard.type("fol")
    expect(options.first).to_contain_text("follower")
    take_first(studio, "ParOfSeq follower")
    page.keyboard.insert_text(" (")
    page.keyboard.press("Control+Space")
    expect(options.filter(has_text="SeqOfPar")).to_have_count(1)
    page.keyboard.press("Escape")
    page.keyboard.type("WAI")
    expect(options.first).to_contain_text("Wait")
    take_first(studio, "ParOfSeq follower (WAIT(")


def hover_shows_the_help_of_the_xml_and_outlines_the_vertex(studio: Studio) -> None:
    replace_all(studio, "Wheel.Advance(33);")
    expect_vertices(studio, "Keep driving", 1)
    box = studio.at("code").locator(".lll-action", has_text="Advance").first
    box.hover()
    expect(studio.page.locator(".code-help")).to_contain_text("0…100")
    assert studio.page.evaluate("document.adoptedStyleSheets.some(one => one.cssRules.length === 1)")
    studio.page.locator(".vertex", has_text="Keep driving").hover()
    expect(studio.at("code").locator(".line-pointed")).to_contain_text("Wheel.Advance")


def test_a_new_program_is_typed_with_completion_marked_and_explained(
    open_studio: OpenStudio,
) -> None:
    studio = empty(open_studio)
    a_program_is_written_with_completion_and_keys_alone(studio)
    hover_shows_the_help_of_the_xml_and_outlines_the_vertex(studio)
    a_mistake_inside_an_instruction_is_marked_on_its_vertex(studio)


RUBBISH = {
    "marks": "]]]) ;; °°° <html>\x07 \u202e 💥 ((",
    "deep": "1*(" * 10_000,
    "file": "// \\\n%PDF-1.7 \0\0",
}


def rubbish_gets_a_sentence_and_leaves_the_document_alone(studio: Studio, text: str) -> None:
    before = studio.code()
    count = studio.page.locator(VERTICES).count()
    replace_all(studio, text)
    expect(studio.at("code-state")).to_contain_text("The graph shows the last text without mistakes.")
    said = studio.at("code-state").text_content() or ""
    assert len(said) > len("The graph shows the last text without mistakes.") + 10
    assert studio.page.locator(VERTICES).count() == count
    expect(studio.at("saved-state")).to_have_text("saved")
    studio.page.keyboard.press("Control+z")
    expect(studio.at("code-state")).to_be_empty()
    studio.expect_whole_code(before)


def the_three_address_code_follows_while_it_is_shown(studio: Studio) -> None:
    studio.at("code-tab-listing").click()
    shown = studio.at("code").locator(".cm-content")
    expect(shown).to_contain_text("END")
    before = shown.inner_text()
    studio.drop("Wait", "arc-start.next")
    expect(shown).not_to_have_text(before)
    expect(shown).to_contain_text("END")
    studio.at("code-tab-lll").click()
    studio.expect_code("WAIT(10);")


@pytest.mark.thorough(
    "web/src/session/typing.test.ts: typed, with mistakes, undone; features/code/code.test.ts and listing.test.tsx;"
    " server/test_text.py: rubbish too; with a server: "
    "test_a_new_program_is_typed_with_completion_marked_and_explained"
)
def test_graph_and_text_follow_each_other_with_mistakes_and_without(open_studio: OpenStudio) -> None:
    studio, before = opened(open_studio)
    an_instruction_that_is_typed_appears_as_a_vertex_and_undo_takes_both_back(studio, before)
    a_mistake_is_marked_on_both_sides_and_the_graph_stays(studio)
    an_edit_of_the_text_leaves_the_selected_vertex_selected(studio)
    leave(studio)
    studio.take_back()
    studio.expect_whole_code(before)
    for text in cases([RUBBISH["marks"]], [RUBBISH["deep"], RUBBISH["file"]]):
        rubbish_gets_a_sentence_and_leaves_the_document_alone(studio, text)
    undo_of_unfinished_text_goes_back_to_the_last_text_without_mistakes(studio)
    leave(studio)
    studio.take_back()
    the_three_address_code_follows_while_it_is_shown(studio)
