"""A user finds an example by what it does and opens it, from an empty program and from Open."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.studio.conftest import EXAMPLES, HEIGHT, LOOKS, WIDTH, Studio
from tests.studio.looks import choose, find_nothing

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]

SHEET = "[data-testid='open-dialog']"
MOVING = 'canvas.picture-run[data-moves="true"]'
DRAWS_ON = """async (canvas) => {
    const frame = () => new Promise(requestAnimationFrame);
    const before = canvas.toDataURL();
    for (let tries = 0; tries < 600; tries++) {
        await frame();
        if (canvas.toDataURL() !== before) return true;
    }
    return false;
}"""
IS_DRAWN = """(canvas) => {
    const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    return new Set(new Uint32Array(pixels.buffer)).size > 4;
}"""


def open_gallery(studio: Studio) -> Locator:
    studio.page.keyboard.press("Control+o")
    expect(studio.at("gallery-count")).to_be_visible()
    return studio.at("open-dialog")


def a_new_program_offers_four_examples_with_pictures_of_what_they_do(studio: Studio) -> None:
    studio.new_mission()
    cards = studio.page.locator(".examples .card")
    expect(cards).to_have_count(4)
    expect(cards.locator("canvas.picture-run")).to_have_count(4)
    assert [canvas.evaluate(IS_DRAWN) for canvas in cards.locator("canvas").all()] == [True] * 4
    expect(cards.last).to_contain_text("No box is lost")
    expect(cards.last).to_contain_text("a team of")
    cards.first.click()
    studio.expect_code("Motor.LeftBy(90)")


def an_example_that_gets_the_focus_comes_into_sight_and_stays_there(studio: Studio) -> None:
    studio.page.set_viewport_size({"width": 1280, "height": 720})
    studio.new_mission()
    last = studio.page.locator(".examples .card").last
    last.focus()
    expect(last.locator("canvas")).to_be_attached()
    # A frame for the browser's scrolling, and one for what answers it.
    studio.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    expect(last).to_be_in_viewport(ratio=0.9)
    last.click()
    studio.expect_code("role carrying: carrier")


@pytest.mark.thorough(
    "web/src/features/gallery/Gallery.test.tsx: under an empty program; the journey below opens an example and "
    "its picture is drawn; tests/workspace/test_previews.py"
)
def test_a_new_program_offers_examples_with_pictures_and_one_that_gets_the_focus_comes_into_sight(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio("blink/blink.krt")
    a_new_program_offers_four_examples_with_pictures_of_what_they_do(studio)
    an_example_that_gets_the_focus_comes_into_sight_and_stays_there(studio)


def it_fits_a_phone(studio: Studio, dialog: Locator) -> None:
    studio.page.set_viewport_size({"width": 390, "height": 844})
    expect(dialog.locator(".card").first).to_be_visible()
    assert dialog.evaluate("(sheet) => sheet.scrollWidth <= sheet.clientWidth")
    studio.page.set_viewport_size({"width": WIDTH, "height": HEIGHT})


def test_search_and_arrows_lead_to_an_example_that_runs_to_its_end(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    dialog = open_gallery(studio)
    cards = dialog.locator(".card")
    every = len([path for path in EXAMPLES.glob("*/*.krt") if path.parent.name != "exercises"])
    expect(cards).to_have_count(every)
    find_nothing(studio, "the gallery", within=SHEET)
    it_fits_a_phone(studio, dialog)
    jumps = dialog.locator(".open-jumps button")
    jumps.last.click()
    expect(dialog.locator("h3", has_text="Examples")).to_be_focused()
    expect(dialog.locator("h3", has_text="Examples")).to_be_in_viewport()
    find = studio.at("gallery-find")
    find.press("ArrowDown")
    expect(cards.first).to_be_focused()
    keys = studio.page.keyboard
    keys.press("ArrowRight")
    expect(cards.nth(1)).to_be_focused()
    keys.press("ArrowUp")
    expect(find).to_be_focused()
    find.fill("blinks star")
    expect(cards).to_have_count(1)
    assert cards.locator("canvas").evaluate(IS_DRAWN)
    find.press("Enter")
    expect(studio.at("example-star")).to_be_focused()
    keys.press("Enter")
    expect(dialog).to_have_count(0)
    studio.expect_code("Motor.LeftBy(144)")
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()


@pytest.mark.thorough(
    "web/src/features/gallery/Gallery.test.tsx: a picture moves while it is seen, unless somebody wants it still; "
    "web/src/components/picture-clock.test.ts"
)
def test_pictures_move_while_they_are_seen_until_somebody_wants_them_still(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt", reduced_motion="no-preference")
    dialog = open_gallery(studio)
    card = studio.at("example-square")
    card.scroll_into_view_if_needed()
    picture = card.locator("canvas")
    expect(picture).to_have_attribute("data-moves", "true")
    assert picture.evaluate(DRAWS_ON)
    last = dialog.locator(".card").last
    last.scroll_into_view_if_needed()
    expect(last.locator("canvas")).to_have_attribute("data-moves", "true")
    expect(picture).to_have_attribute("data-moves", "false")
    studio.at("gallery-plays").uncheck()
    expect(dialog.locator(MOVING)).to_have_count(0)
    # Focus scrolls; a card that comes under the mouse would move too.
    studio.page.mouse.move(0, 0)
    last.focus()
    expect(dialog.locator(MOVING)).to_have_count(1)
    # Remembered, and nothing moves for who wants less motion.
    studio.page.keyboard.press("Escape")
    open_gallery(studio)
    expect(studio.at("gallery-plays")).not_to_be_checked()
    studio.at("gallery-plays").check()
    studio.page.keyboard.press("Escape")
    studio.page.emulate_media(reduced_motion="reduce")
    open_gallery(studio)
    card.scroll_into_view_if_needed()
    expect(picture).to_have_attribute("data-moves", "false")
    assert picture.evaluate(IS_DRAWN)


@pytest.mark.thorough("test_search_and_arrows_lead_to_an_example_that_runs_to_its_end, in the light theme")
@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_the_gallery_has_no_barrier_and_fits_a_phone(open_studio: OpenStudio, look: tuple[str, ...]) -> None:
    studio = open_studio("blink/blink.krt")
    choose(studio, *look)
    dialog = open_gallery(studio)
    find_nothing(studio, "the gallery", within=SHEET)
    studio.at("gallery-find").fill("zzz")
    expect(dialog.locator(".card")).to_have_count(0)
    find_nothing(studio, "no example", within=SHEET)
    studio.at("gallery-find").fill("")
    it_fits_a_phone(studio, dialog)
