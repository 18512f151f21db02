"""A board in the arena: a person holds its buttons with mouse, finger and keyboard, and sees what it shows."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.effort import cases
from tests.studio.conftest import LOOKS, Studio
from tests.studio.looks import choose, find_nothing

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]


def running(open_studio: OpenStudio, **device: object) -> Studio:
    """Dice that wait for somebody: button B ends the game."""
    studio = open_studio("dice/dice.krt", **device)
    begin(studio)
    return studio


def begin(studio: Studio) -> None:
    studio.at("run-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "running")
    expect(studio.at("hand-ButtonB")).to_be_enabled()


def place_of_button_b(studio: Studio) -> tuple[float, float]:
    """In the page: the desk is 240 mm wide, and the board 160 mm of it, in the middle."""
    canvas = studio.at("arena-canvas").bounding_box()
    assert canvas is not None
    scale = min(canvas["width"] / 240, canvas["height"] / 180)
    unit = scale * 135 / 54
    return canvas["x"] + canvas["width"] / 2 + 24 * unit, canvas["y"] + canvas["height"] / 2 - 4 * unit


def a_button_of_the_board_is_pressed_with_the_mouse_in_the_arena(studio: Studio) -> None:
    studio.page.mouse.move(*place_of_button_b(studio))
    expect(studio.at("arena-canvas")).to_have_css("cursor", "pointer")
    studio.page.mouse.down()
    expect(studio.at("hand-ButtonB")).to_have_attribute("aria-pressed", "true")
    studio.wait_until_done()
    studio.page.mouse.up()


def a_press_on_the_canvas_beside_the_buttons_holds_nothing(studio: Studio) -> None:
    x, y = place_of_button_b(studio)
    studio.page.mouse.move(x, y + 60)
    studio.page.mouse.down()
    studio.page.mouse.up()
    expect(studio.at("hand-ButtonB")).to_have_attribute("aria-pressed", "false")
    expect(studio.at("status")).to_have_attribute("data-status", "running")


def a_button_is_held_with_the_keyboard(studio: Studio, key: str) -> None:
    studio.at("arena-canvas" if key == "b" else "hand-ButtonB").focus()
    studio.page.keyboard.down(key)
    expect(studio.at("hand-ButtonB")).to_have_attribute("aria-pressed", "true")
    studio.page.keyboard.up(key)
    studio.wait_until_done()


@pytest.mark.thorough("web/src/components/scene/boards.test.ts: a short press is held until the program has felt it")
def test_a_finger_that_taps_shortly_is_felt(open_studio: OpenStudio) -> None:
    studio = running(open_studio, has_touch=True)
    studio.at("hand-ButtonB").tap()
    studio.wait_until_done()


def what_a_hand_did_stands_on_the_timeline_and_in_the_watch(studio: Studio) -> None:
    studio.at("watch-button").click()
    expect(studio.at("watch-Shake")).to_be_visible()
    studio.at("hand-Shake").hover()
    studio.page.mouse.down()
    expect(studio.at("watch-Shake")).to_have_attribute("data-forced", "true")
    studio.page.mouse.up()
    expect(studio.at("watch-Shake")).to_have_attribute("data-forced", "false")
    expect(studio.at("hand-Shake")).to_have_attribute("aria-pressed", "false")


def a_press_while_the_run_pauses_waits_for_it(studio: Studio) -> None:
    studio.at("pause-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    studio.at("hand-ButtonB").click()
    expect(studio.at("hand-ButtonB")).to_have_attribute("aria-pressed", "true")
    studio.page.keyboard.press("F5")
    studio.wait_until_done()


def before_a_run_there_is_a_board_and_nothing_to_hold(studio: Studio) -> None:
    expect(studio.at("hand-Shake")).to_be_disabled()
    expect(studio.at("hands")).to_contain_text("Press Run first")


def dice_are_thrown_by_a_shake(studio: Studio) -> None:
    studio.at("arena-canvas").focus()
    studio.page.keyboard.down("s")
    expect(studio.at("arena-summary")).to_contain_text(re.compile(r"[1-6] lights? on"))
    studio.page.keyboard.up("s")


def test_a_board_is_held_in_the_arena_by_mouse_and_keys(open_studio: OpenStudio) -> None:
    studio = open_studio("dice/dice.krt")
    find_nothing(studio, "a board before a run", within=".side-arena")
    begin(studio)
    a_press_on_the_canvas_beside_the_buttons_holds_nothing(studio)
    dice_are_thrown_by_a_shake(studio)
    a_button_of_the_board_is_pressed_with_the_mouse_in_the_arena(studio)


@pytest.mark.thorough(
    "web/src/features/arena/hands.test.tsx and components/scene/boards.test.ts: before a run, by pointers and keys;"
    " drawn buttons and keys of the arena: test_a_board_is_held_in_the_arena_by_mouse_and_keys"
)
def test_a_board_is_held_by_mouse_and_keys_shaken_and_watched_once_it_runs(open_studio: OpenStudio) -> None:
    studio = open_studio("dice/dice.krt")
    before_a_run_there_is_a_board_and_nothing_to_hold(studio)
    find_nothing(studio, "a board before a run")
    begin(studio)
    expect(studio.at("hand-Shake")).to_be_enabled()
    a_press_on_the_canvas_beside_the_buttons_holds_nothing(studio)
    a_press_while_the_run_pauses_waits_for_it(studio)
    for key in cases(["b"], ["Space", "Enter"]):
        begin(studio)
        a_button_is_held_with_the_keyboard(studio, key)
    begin(studio)
    a_button_of_the_board_is_pressed_with_the_mouse_in_the_arena(studio)
    begin(studio)
    what_a_hand_did_stands_on_the_timeline_and_in_the_watch(studio)
    dice_are_thrown_by_a_shake(studio)


@pytest.mark.thorough("web/src/components/scene/boards.test.ts; dice_are_thrown_by_a_shake lights the display in a run")
def test_the_heart_beats_on_the_lights(open_studio: OpenStudio) -> None:
    studio = open_studio("heart/heart.krt")
    studio.at("run-button").click()
    for lights in ("16 lights on", "6 lights on", "16 lights on"):
        expect(studio.at("arena-summary")).to_contain_text(lights)


@pytest.mark.thorough(
    "web/src/model/texts.test.ts: labels are in the reader's language; web/src/components/scene/boards.test.ts"
)
@pytest.mark.parametrize("language", cases(["ur"], ["fr"]))
def test_keys_are_there_in_every_language(open_studio: OpenStudio, language: str) -> None:
    studio = open_studio("reaction/reaction.krt", locale=language)
    names = {"fr": "Bouton A", "ur": "بٹن A"}
    expect(studio.at("hand-ButtonA")).to_contain_text(names[language])


@pytest.mark.thorough("test_a_board_is_held_in_the_arena_by_mouse_and_keys looks with axe")
@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_axe_finds_nothing_on_a_board(open_studio: OpenStudio, look: tuple[str, ...]) -> None:
    studio = open_studio("dice/dice.krt")
    choose(studio, *look)
    find_nothing(studio, "before a run")
    studio.at("run-button").click()
    expect(studio.at("hand-Shake")).to_be_enabled()
    studio.at("hand-Shake").hover()
    studio.page.mouse.down()
    expect(studio.at("hand-Shake")).to_have_attribute("aria-pressed", "true")
    find_nothing(studio, "a button is held")
    studio.page.mouse.up()
