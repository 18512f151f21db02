"""Variables as a person makes them: from the palette, by mouse and by keys, in any script, and undone."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio
from tests.studio.looks import choose, find_nothing
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
SQUARE = "square/square.krt"
TRANSPORT = "transport/transport.krt"


def make(studio: Studio, name: str, **fields: str) -> None:
    """Fills the form of a new variable in and sends it off."""
    expect(studio.at("variable-form")).to_be_visible()
    studio.at("variable-name").fill(name)
    for field, value in fields.items():
        studio.at(f"variable-{field}").fill(value)
    studio.page.keyboard.press("Enter")


def row(studio: Studio, name: str):
    """The row of a variable in the palette."""
    return studio.page.locator(f'[data-row="object variable {name}"]')


def save(studio: Studio, file: str) -> str:
    """Saves and gives what is in the file."""
    studio.page.keyboard.press("Control+s")
    expect(studio.at("saved-state")).to_have_text("saved")
    return (studio.folder / file).read_text(encoding="utf-8")


def forgive_refusals(studio: Studio) -> None:
    """The browser tells of each request that the server refused, as it was meant to."""
    studio.page.evaluate("0")  # what the page had to say before has come by then
    studio.faults[:] = [fault for fault in studio.faults if "(Conflict)" not in fault and "(Unprocessable" not in fault]


def a_variable_is_made_used_renamed_everywhere_changed_and_undone(studio: Studio) -> None:
    before = (studio.folder / "square.krt").read_text(encoding="utf-8")
    studio.at("new-variable").click()
    make(studio, "Trips", max="9", initial="2")
    expect(studio.at("variable-form")).to_be_hidden()
    expect(row(studio, "Trips")).to_be_visible()
    studio.page.locator('[data-testid^="part-Trips."]').first.click()
    studio.expect_code("Trips.")
    saved = save(studio, "square.krt")
    assert '<variable robot="mini-robot" name="Trips" min="0" max="9" initial="2"/>' in saved

    row(studio, "Trips").focus()
    studio.page.keyboard.press("F2")
    studio.at("variable-rename").fill("Runden")
    studio.page.keyboard.press("Enter")
    studio.expect_code("Runden.")
    expect(row(studio, "Runden")).to_be_focused()

    row(studio, "Runden").click(button="right")
    studio.at("menu-variable-edit").click()
    expect(studio.at("variable-max")).to_have_value("9")
    studio.at("variable-max").fill("500")
    studio.at("variable-shared").check()
    studio.at("variable-keep").click()
    expect(studio.at("variable-form")).to_be_hidden()
    saved = save(studio, "square.krt")
    assert 'name="Runden" min="0" max="500" initial="2" shared="yes"' in saved

    studio.at("canvas").focus()
    for _ in range(4):
        studio.page.keyboard.press("Control+z")
    expect(row(studio, "Trips")).to_have_count(0)
    assert save(studio, "square.krt") == before


def a_variable_that_is_used_is_removed_only_after_a_question_that_shows_where(studio: Studio) -> None:
    studio.page.keyboard.press("Alt+v")
    make(studio, "Trips")
    studio.page.locator('[data-testid^="part-Trips."]').first.click()
    studio.expect_code("Trips.")
    row(studio, "Trips").focus()
    studio.page.keyboard.press("Delete")
    banner = studio.at("banner")
    expect(banner).to_contain_text("Trips is used: 1 time in")
    studio.page.get_by_role("button", name=re.compile("^Show in")).click()
    expect(studio.page.locator(".vertex.is-selected").first).to_be_visible()
    expect(banner).to_be_visible()
    banner.get_by_role("button", name="Remove").click()
    expect(row(studio, "Trips")).to_have_count(0)
    expect(studio.at("problems")).not_to_contain_text("Problems0")
    studio.at("canvas").focus()
    studio.page.keyboard.press("Control+z")
    expect(row(studio, "Trips")).to_be_visible()
    studio.expect_code("Trips.")


def an_unused_variable_goes_at_once(studio: Studio) -> None:
    studio.at("new-variable").focus()
    studio.page.keyboard.press("Enter")
    make(studio, "Trips")
    row(studio, "Trips").focus()
    studio.page.keyboard.press("Delete")
    expect(row(studio, "Trips")).to_have_count(0)
    expect(studio.at("new-variable")).to_be_focused()


def what_cannot_be_is_said_at_the_field_and_nothing_is_made(studio: Studio) -> None:
    studio.at("new-variable").click()
    for name, says in (("", "no name yet"), ("Captor", "is a sensor of the robot"), ("two words", "cannot be called")):
        make(studio, name)
        expect(studio.at("variable-why")).to_contain_text(says)
    make(studio, "Trips", min="9", max="3")
    expect(studio.at("variable-why")).to_contain_text("holds no number")
    make(studio, "Trips", min="x")
    expect(studio.at("variable-why")).to_contain_text("whole numbers")
    find_nothing(studio, "the form of a variable")
    studio.page.keyboard.press("Escape")
    expect(studio.at("variable-form")).to_be_hidden()
    expect(studio.at("new-variable")).to_be_focused()
    expect(row(studio, "Trips")).to_have_count(0)
    forgive_refusals(studio)


def a_variable_of_the_robots_own_file_says_where_it_is(studio: Studio) -> None:
    row(studio, "Count").dblclick()
    expect(studio.at("banner")).to_contain_text("mini-robot.robot.xml")
    expect(studio.at("variable-rename")).to_have_count(0)
    forgive_refusals(studio)


@pytest.mark.thorough(
    "tests/server/test_parts.py: names are of any script; web/src/features/palette/variables.test.tsx"
)
def test_a_variable_is_made_while_adding_and_in_urdu(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE)
    choose(studio, "ur")
    studio.at("canvas").focus()
    studio.page.keyboard.press("/")
    studio.at("add-find").fill("چکر_گنتی")
    studio.at("add-new-variable").click()
    expect(studio.at("variable-name")).to_have_value("چکر_گنتی")
    find_nothing(studio, "the form in Urdu")
    studio.page.keyboard.press("Enter")
    expect(row(studio, "چکر_گنتی")).to_be_visible()
    studio.page.locator('[data-testid^="part-چکر_گنتی."]').first.click()
    studio.expect_code("چکر_گنتی.")


def an_open_text_with_a_mistake_follows_a_new_name(studio: Studio) -> None:
    expect(row(studio, "Trips")).to_be_visible()
    studio.edit_code()
    studio.page.keyboard.press("Control+End")
    studio.page.keyboard.insert_text("\nTrips.Set(3); [Trips.")
    studio.expect_code("[Trips.")
    row(studio, "Trips").dblclick()
    studio.at("variable-rename").fill("Laps")
    studio.page.keyboard.press("Enter")
    studio.expect_code("[Laps.")
    expect(studio.at("code")).not_to_contain_text("Trips")


def a_finger_that_rests_opens_the_menu(studio: Studio) -> None:
    box = place_of(row(studio, "Count"))
    at = {"clientX": box["x"] + 40, "clientY": box["y"] + 10, "pointerType": "touch", "bubbles": True}
    row(studio, "Count").dispatch_event("pointerdown", at)
    expect(studio.at("variable-menu")).to_be_visible()
    find_nothing(studio, "the menu of a variable")
    studio.page.keyboard.press("Escape")
    expect(studio.at("variable-menu")).to_be_hidden()


@pytest.mark.thorough(
    "web/src/features/palette/variables.test.tsx: unused, refused, by a finger, of the robot's file; "
    "server/test_parts.py: which are refused and with what words"
)
def test_an_unused_one_goes_a_wrong_one_is_refused_and_one_of_the_robots_file_has_a_menu(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(SQUARE)
    an_unused_variable_goes_at_once(studio)
    what_cannot_be_is_said_at_the_field_and_nothing_is_made(studio)
    a_finger_that_rests_opens_the_menu(studio)
    a_variable_of_the_robots_own_file_says_where_it_is(studio)


@pytest.mark.thorough(
    "web/src/features/palette/variables.test.tsx: made, used, renamed, changed, removed, undone; "
    "session/typing.test.ts: a text follows a new name; with a server: test_palette.py"
)
def test_a_variable_is_made_used_renamed_changed_undone_and_removed_after_a_question(open_studio: OpenStudio) -> None:
    studio = open_studio(SQUARE)
    a_variable_is_made_used_renamed_everywhere_changed_and_undone(studio)
    a_variable_that_is_used_is_removed_only_after_a_question_that_shows_where(studio)
    an_open_text_with_a_mistake_follows_a_new_name(studio)
