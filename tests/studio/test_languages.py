"""Who reads French or Urdu meets no English: not on a screen, not in a tooltip, not in what the server says."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.effort import THOROUGH, cases
from tests.studio.conftest import EXAMPLES, Studio
from tests.studio.looks import CUT_OFF, choose

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]

MISTAKES = """<kitrobot version="1">
  <program name="main" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="While"/>
    <vertex id="v2" element="Wait"><set name="duration">many</set></vertex>
    <vertex id="v3" element="Wheel.Advance"><set name="speed">500</set></vertex>
    <vertex id="v4" element="Wheel.Fly"/>
    <vertex id="v5" element="Rocket"/>
    <vertex id="v6" element="Break"/>
    <vertex id="v7" element="Wheel.Stop"/>
    <vertex id="v8" element="If Then"/>
    <vertex id="v9" element="Captor.Value"/>
    <vertex id="v10" element="Door.Open"><set name="width">3</set></vertex>
    <vertex id="v11" element="Interrupt"/>
    <vertex id="v12" element="Light.LightOn"/>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" out="body" to="v2"/>
    <arc from="v2" to="v1" at="return"/>
    <arc from="v1" to="v3"/>
    <arc from="v3" to="v4"/>
    <arc from="v4" to="v5"/>
    <arc from="v5" to="v8"/>
    <arc from="v9" to="v8" at="condition"/>
    <arc from="v8" out="then" to="v10"/>
    <arc from="v10" to="v8" at="return"/>
    <arc from="v8" to="v11"/>
    <arc from="v11" to="v6"/>
    <arc from="v6" to="v7"/>
    <arc from="v7" to="stop"/>
    <arc from="v7" to="ghost"/>
  </program>
  <program name="other" robot="nobody">
    <vertex id="start" element="Start"/>
  </program>
  <team>
    <agent name="robot-1" program="main"/>
    <agent name="robot-2" program="gone"/>
    <goal storehouse="Z" stock="3"/>
  </team>
  <odd/>
</kitrobot>
"""

# Left out: code, the text of programs, words of the mission itself, the name of the library that draws.
SAID = """() => {
    const names = `code, kbd, .cm-editor, .note-words, .note-strip, [data-testid="team-title"],
        [data-testid="team-help"], script, style`;
    const found = [];
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) {
        const around = texts.currentNode.parentElement;
        if (around !== null && around.closest(names) === null) found.push(texts.currentNode.textContent.trim());
    }
    const attributes = ['aria-label', 'title', 'placeholder', 'aria-valuetext', 'alt'];
    for (const attribute of attributes)
        for (const one of document.querySelectorAll(`[${attribute}]`))
            if (one.closest(names) === null) found.push(one.getAttribute(attribute));
    return [...new Set([document.title, ...found])].filter((text) => text !== '');
}"""
ENGLISH = {
    # Two Latin words in a row: names are one word here.
    "ur": re.compile(r"[A-Za-z]{2,} [a-z]{2,}"),
    "fr": re.compile(
        r"\b(the|of|is|are|and|with|this|that|it|its|from|for|has|was|which|what|cannot|found|expected|your|you|"
        r"add|delete|open|close|show|select|nothing|number|loaded|true|false|forward)\b",
        re.IGNORECASE,
    ),
}
QUOTED = re.compile(r"`[^`]*`|“[^”]*”|\w+\.\w+")
"""Code where a screen cannot set it apart, words of the mission, names of methods and files."""

each_language = pytest.mark.parametrize("language", cases(["ur"], ["fr"]))
"""In Urdu a word of English is known by its letters; that no French word is missing is held by the page's own tests."""


def meets_no_english(studio: Studio, language: str, screen: str) -> None:
    said = studio.page.evaluate(SAID)
    assert len(said) > 20, screen
    english = [text for text in said if ENGLISH[language].search(QUOTED.sub("", text))]
    assert english == [], screen


def menus_sheets_palette_inspector_outline_and_help(studio: Studio, language: str) -> None:
    keys = studio.page.keyboard
    meets_no_english(studio, language, "the mission")
    assert studio.page.evaluate(CUT_OFF) == []
    for vertex in range(0, 12, 2 if THOROUGH else 5):
        studio.page.locator(".vertex").nth(vertex).click()
        meets_no_english(studio, language, f"the inspector of vertex {vertex}")
    keys.press("F1")
    expect(studio.at("part-help")).to_be_visible()
    meets_no_english(studio, language, "help for a part")
    keys.press("Escape")
    for menu in ("File", "Edit", "View", "Program", "Run", "Help"):
        studio.at(f"menu-{menu}").click()
        meets_no_english(studio, language, menu)
        keys.press("Escape")
    for press, shown in (("?", "shortcuts-dialog"), ("Control+o", "open-dialog"), ("Control+Shift+s", "save-dialog")):
        studio.at("canvas").focus()
        keys.press(press)
        expect(studio.at(shown)).to_be_visible()
        meets_no_english(studio, language, shown)
        keys.press("Escape")
    studio.at("canvas").focus()
    keys.press("F4")
    expect(studio.at("outline")).to_be_visible()
    meets_no_english(studio, language, "outline")
    keys.press("Escape")
    studio.new_mission()
    expect(studio.at("first-place")).to_be_visible()
    meets_no_english(studio, language, "a new program")


def help_for_every_part_of_the_palette(studio: Studio, language: str) -> None:
    page = studio.page
    parts = page.locator('[data-testid^="part-"]:not(input)')
    seen = set()
    for index in range(parts.count()):
        parts.nth(index).focus()
        page.keyboard.press("F1")
        expect(studio.at("part-help")).to_be_visible()
        seen.add(studio.at("part-help").inner_text())
        meets_no_english(studio, language, f"help {index}")
        page.keyboard.press("Escape")
        expect(studio.at("part-help")).to_have_count(0)
    assert len(seen) > 15


def a_dozen_mistakes_with_their_helps(studio: Studio, language: str) -> None:
    (studio.folder / "mistakes.krt").write_text(MISTAKES, encoding="utf-8")
    studio.page.keyboard.press("Control+o")
    studio.at("open-dialog").get_by_text("mistakes.krt").first.click()
    expect(studio.at("title")).to_contain_text("mistakes.krt")
    if studio.at("problems").get_attribute("aria-expanded") == "false":
        studio.at("problems").click()
    rows = studio.page.locator(".problem")
    expect(rows.nth(12)).to_be_visible()
    assert rows.locator(".problem-help").count() >= 12
    meets_no_english(studio, language, "the list of problems")
    wanted = "vitesse de Wheel.Advance" if language == "fr" else "میں رفتار: 0 سے 100 تک کا عدد چاہیے"
    expect(rows.filter(has_text=re.compile(wanted, re.IGNORECASE))).to_have_count(1)


@pytest.mark.thorough(
    "tests/server/test_languages.py: a problem and its help follow the header; a_dozen_mistakes_with_their_helps"
)
def test_problems_follow_the_language_that_is_chosen(open_studio: OpenStudio) -> None:
    studio = open_studio("square/square.krt")
    studio.drop("While", "arc-start.next")
    studio.at("problems").click()
    first = studio.page.locator(".problem").first
    for language, words in (("en", "is empty"), ("fr", "est vide"), ("ur", "خالی ہے"), ("en", "is empty")):
        choose(studio, language)
        if studio.at("problems").get_attribute("aria-expanded") == "false":
            studio.at("problems").click()
        expect(first).to_contain_text(words)


@pytest.mark.thorough(
    "tests/server/test_languages.py: differences and failures are told in the language; web/src/i18n/words.test.ts"
)
@each_language
def test_the_difference_from_the_file_and_a_refusal(open_studio: OpenStudio, language: str) -> None:
    studio = open_studio("square/square.krt")
    choose(studio, language)
    studio.drop("Wait", "arc-start.next")
    expect(studio.at("undo")).to_be_enabled()
    file = studio.folder / "square.krt"
    file.write_text((EXAMPLES / "stripes" / "stripes.krt").read_text(encoding="utf-8"), encoding="utf-8")
    shown = {"fr": "Montrer la différence", "ur": "فرق دکھائیں"}[language]
    studio.page.keyboard.press("Control+s")
    studio.at("banner").get_by_role("button", name=shown).click()
    expect(studio.at("differences").locator("li").nth(2)).to_be_visible()
    meets_no_english(studio, language, "the difference")
    studio.page.keyboard.press("Escape")
    (studio.folder / "broken.krt").write_text('<kitrobot version="1"><program', encoding="utf-8")
    studio.page.reload()
    studio.at("canvas").focus()
    studio.page.keyboard.press("Control+o")
    studio.at("open-dialog").get_by_text("broken.krt").first.click()
    expect(studio.page.locator(".banner").first).to_be_visible()
    meets_no_english(studio, language, "a file that cannot be opened")
    # The browser's console tells of both refusals too.
    studio.faults[:] = [fault for fault in studio.faults if "(Conflict)" not in fault and "(Unprocessable" not in fault]


def how_a_run_ends(studio: Studio, language: str) -> None:
    studio.full_speed()
    studio.at("run-button").click()
    ended = {"fr": "Fini en", "ur": "سیکنڈ میں مکمل"}[language]
    expect(studio.at("status")).to_contain_text(ended)
    meets_no_english(studio, language, "the end of a run")


def the_team(studio: Studio, language: str) -> None:
    studio.at("tab-of-team").click()
    expect(studio.at("team")).to_be_visible()
    meets_no_english(studio, language, "the team")
    studio.at("tab-carrier").click()


def a_tutorial(studio: Studio, language: str) -> None:
    studio.page.keyboard.press("Alt+l")
    studio.page.locator('[data-testid^="tutorial-card-"]').first.click()
    expect(studio.at("tutorial")).to_be_visible()
    meets_no_english(studio, language, "the first step of a tutorial")
    studio.at("tutorial-show").click()
    meets_no_english(studio, language, "its hint")


@each_language
def test_the_mission_a_menu_an_inspector_and_a_dozen_mistakes(open_studio: OpenStudio, language: str) -> None:
    studio = open_studio("transport/transport.krt")
    choose(studio, language)
    meets_no_english(studio, language, "the mission")
    assert studio.page.evaluate(CUT_OFF) == []
    studio.page.locator(".vertex").nth(5).click()
    meets_no_english(studio, language, "the inspector")
    studio.at("menu-File").click()
    meets_no_english(studio, language, "File")
    studio.page.keyboard.press("Escape")
    a_dozen_mistakes_with_their_helps(studio, language)


@pytest.mark.thorough(
    "the test above; no sentence is without its translations: tests/translation and web/src/i18n/words.test.ts; "
    "each screen in French: tests/studio/test_clipping.py"
)
@each_language
@pytest.mark.thorough(
    "the test above; tests/translation and web/src/i18n/words.test.ts: each sentence has its translations; no "
    "drawing has words of its own: kitrobot/spoken-words in web/eslint.config.js"
)
def test_menus_sheets_palette_inspector_outline_help_team_a_dozen_mistakes_and_a_tutorial(
    open_studio: OpenStudio, language: str
) -> None:
    studio = open_studio("transport/transport.krt")
    choose(studio, language)
    the_team(studio, language)
    menus_sheets_palette_inspector_outline_and_help(studio, language)
    a_dozen_mistakes_with_their_helps(studio, language)
    a_tutorial(studio, language)


@pytest.mark.thorough("tests/server/test_languages.py: how a run ends; web/src/i18n/words.test.ts")
@each_language
def test_help_for_every_part_and_how_a_run_ends(open_studio: OpenStudio, language: str) -> None:
    studio = open_studio("square/square.krt")
    choose(studio, language)
    help_for_every_part_of_the_palette(studio, language)
    how_a_run_ends(studio, language)
