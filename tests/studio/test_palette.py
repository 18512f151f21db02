"""The palette in the page: tabs that lead to their parts, words that find them, and what another robot can do."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.effort import cases
from tests.studio.robot_rows import OpenStudio
from tests.studio.studio_page import Studio
from tests.studio.test_own_parts import choose, row, save_part
from tests.studio.test_variables import make

NEAR_TOP = """(section) => {
    const list = section.closest('.palette-list');
    const [box, at] = [list.getBoundingClientRect(), section.getBoundingClientRect()];
    const isLast = list.scrollTop + list.clientHeight >= list.scrollHeight - 1;
    return isLast || Math.abs(at.top - box.top) < 4;
}"""


def tabs_lead_to_their_parts_and_nothing_is_closed(studio: Studio) -> None:
    tabs = studio.page.locator(".palette-tab")
    names = ["Move", "Sense", "Draw", "Actions", "Loops", "Choices", "Together", "Values"]
    expect(tabs).to_have_text(names)
    for name in ("Loops", "Move", "Draw"):
        studio.at(f"palette-tab-{name}").click()
        assert studio.page.locator(f"#parts-of-{name}").evaluate(NEAR_TOP)
    expect(studio.at("palette-tab-Draw")).to_have_attribute("aria-current", "true")
    move = studio.page.locator("#parts-of-Move .palette-name")
    first = ["Drive", "Drive back", "Turn right", "Turn left"]
    assert move.all_inner_texts()[:4] == first
    expect(studio.at("part-Wheel.DriveBy")).to_contain_text("30")
    expect(studio.at("part-Flag.IsTrue")).to_be_attached()


def words_of_the_xml_find_parts_and_enter_adds_the_best(studio: Studio) -> None:
    find = studio.at("part-find")
    for word, part in (("wall", "Captor.LessThan"), ("blink", "Light.LightOn"), ("always", "Forever")):
        find.fill(word)
        expect(studio.at(f"part-{part}")).to_be_visible()
        expect(studio.page.locator(".palette-tabs")).to_have_count(0)
    find.fill("left")
    find.press("Enter")
    studio.expect_code("Motor.LeftBy(")
    find.press("Escape")
    expect(studio.page.locator(".palette-tabs")).to_be_visible()


def what_this_robot_cannot_do_is_told_of_those_that_can(studio: Studio) -> None:
    studio.at("part-find").fill("music")
    expect(studio.at("parts-none")).to_contain_text("micro:bit can do it: Play note · Play melody")
    studio.at("part-find").fill("xyzzy")
    expect(studio.at("parts-none")).to_contain_text("No part is called")
    expect(studio.at("parts-none")).not_to_contain_text("can do it")
    studio.at("part-find").fill("")


def a_variable_is_made_and_used(studio: Studio) -> None:
    studio.at("new-variable").click()
    make(studio, "Trips", max="9")
    studio.page.locator('[data-testid^="part-Trips."]').first.click()
    studio.expect_code("Trips.")


def a_selection_becomes_a_part_that_is_used_and_shared(studio: Studio) -> None:
    studio.page.locator(".vertex", has_text="Repeat").first.click(position={"x": 12, "y": 12})
    studio.page.keyboard.press("p")
    save_part(studio, "Mine")
    expect(row(studio, "Mine")).to_be_visible()
    before = studio.code()
    row(studio, "Mine").click()
    expect(studio.page.locator(".vertex", has_text="Mine")).to_have_count(2)
    expect(studio.at("code")).not_to_have_text(before)
    with studio.page.expect_download() as download:
        choose(studio, "Mine", "Download my parts")
    assert '<constructor name="Mine"' in download.value.path().read_text()


def test_the_palette_finds_parts_and_makes_variables_and_parts(open_studio: OpenStudio) -> None:
    studio = open_studio("square/square.krt")
    tabs_lead_to_their_parts_and_nothing_is_closed(studio)
    words_of_the_xml_find_parts_and_enter_adds_the_best(studio)
    what_this_robot_cannot_do_is_told_of_those_that_can(studio)
    a_variable_is_made_and_used(studio)
    a_selection_becomes_a_part_that_is_used_and_shared(studio)


@pytest.mark.parametrize(("language", "word", "other"), cases([("ur", "موسیقی", "دھن")], [("fr", "musique", "Jouer")]))
def test_words_are_those_of_the_reader(open_studio: OpenStudio, language: str, word: str, other: str) -> None:
    studio = open_studio("square/square.krt", locale=language)
    studio.at("part-find").fill("gauche" if language == "fr" else "بائیں")
    expect(studio.at("part-Motor.LeftBy")).to_be_visible()
    studio.at("part-find").fill(word)
    expect(studio.at("parts-none")).to_contain_text(other)
