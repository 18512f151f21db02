"""A new mission begins with pictures: robot, place and first program, and what is chosen moves before it begins."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio
from tests.studio.looks import find_nothing
from tests.studio.test_gallery import IS_DRAWN
from tests.studio.test_parts import ROBOT

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]


def choose(studio: Studio, testid: str) -> None:
    studio.page.locator("label", has=studio.at(testid)).click()


def families(studio: Studio, selector: str) -> set[str]:
    """The fonts that the letters of an element come from."""
    studio.page.evaluate("document.fonts.ready.then(() => true)")
    glass = studio.page.context.new_cdp_session(studio.page)
    glass.send("DOM.enable")
    glass.send("CSS.enable")
    root = glass.send("DOM.getDocument")["root"]["nodeId"]
    node = glass.send("DOM.querySelector", {"nodeId": root, "selector": selector})["nodeId"]
    return {font["familyName"] for font in glass.send("CSS.getPlatformFontsForNode", {"nodeId": node})["fonts"]}


def two_keys_lead_from_nothing_to_a_square_that_is_driven(studio: Studio) -> None:
    studio.page.keyboard.press("Control+Alt+n")
    expect(studio.at("new-starter-draw-square/draw-square.krt")).to_be_checked()
    expect(studio.at("run-button")).to_be_disabled()
    find_nothing(studio, "a new mission")
    expect(studio.at("new-robots-mini-robot")).to_be_focused()
    studio.page.keyboard.press("Enter")
    studio.expect_opened()
    studio.expect_code("4*(")
    expect(studio.at("title")).to_contain_text("my-first-mission.krt")
    studio.full_speed()
    studio.page.keyboard.press("F5")
    studio.wait_until_done()
    assert list(studio.folder.iterdir()) == []


@pytest.mark.thorough("web/src/features/new-mission/choice.test.ts")
def test_what_does_not_fit_gives_way_and_says_so_and_escape_keeps_what_was_open(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    code = studio.code()
    studio.page.keyboard.press("Control+Alt+n")
    choose(studio, "new-robots-microbit")
    expect(studio.at("new-place-desk.world.xml")).to_be_checked()
    expect(studio.at("new-place-empty.world.xml")).to_be_disabled()
    expect(studio.page.locator("label", has=studio.at("new-place-empty.world.xml"))).to_contain_text(
        "Not for this robot"
    )
    expect(studio.at("new-starter-heart/heart.krt")).to_be_checked()
    expect(studio.at("new-starter-draw-square/draw-square.krt")).to_have_count(0)
    choose(studio, "new-robots-carriers")
    expect(studio.page.locator(".new-stage canvas.picture-run")).to_be_visible()
    assert studio.page.locator(".new-stage canvas").evaluate(IS_DRAWN)
    studio.at("new-name").press("Escape")
    expect(studio.at("new-mission")).to_have_count(0)
    assert studio.code() == code


def a_name_that_a_file_has_is_not_taken_by_a_new_mission(studio: Studio) -> None:
    (studio.folder / "my-first-mission.krt").write_text("<kitrobot/>", encoding="utf-8")
    (studio.folder / "Maze.krt").write_text("<kitrobot/>", encoding="utf-8")
    studio.page.keyboard.press("Control+Alt+n")
    expect(studio.at("new-name")).to_have_value("my-first-mission-2")
    studio.at("new-name").fill("maze")
    studio.at("new-begin").click()
    studio.expect_opened()
    expect(studio.at("title")).to_contain_text("maze-2.krt")


def the_robot_and_its_place_are_what_was_chosen(studio: Studio) -> None:
    studio.page.keyboard.press("Control+Alt+n")
    choose(studio, "new-robots-line-follower")
    choose(studio, "new-place-maze.world.xml")
    choose(studio, "new-starter-nothing")
    studio.at("new-name").fill("Łukasz' maze")
    studio.at("new-begin").click()
    studio.expect_opened()
    expect(studio.at("title")).to_contain_text("Łukasz' maze.krt")
    assert families(studio, "[data-testid=title] h1") == {"Inter"}, "Ł comes from the page's own font too"
    expect(studio.at("part-LeftWheel.Forward")).to_be_visible()
    expect(studio.at("first-place")).to_be_visible()


def a_robot_of_the_folder_is_one_to_begin_with(studio: Studio) -> None:
    (studio.folder / "rover.robot.xml").write_text(ROBOT, encoding="utf-8")
    studio.page.keyboard.press("Control+Alt+n")
    card = studio.page.locator("label", has=studio.at("new-robots-rover"))
    expect(card).to_contain_text("Your own robot")
    card.click()
    studio.at("new-begin").click()
    studio.expect_opened()
    expect(studio.at("object-Lamp")).to_be_visible()


def test_a_mission_begins_with_two_keys_and_with_what_was_chosen(open_studio: OpenStudio) -> None:
    studio = open_studio(None)
    two_keys_lead_from_nothing_to_a_square_that_is_driven(studio)
    the_robot_and_its_place_are_what_was_chosen(studio)


@pytest.mark.thorough(
    "web/src/session/mission-path.test.ts: a name that is taken gets a number; tests/server/test_parts.py: a "
    "robot of the folder is in the catalogue, whose robots the sheet shows: web/src/features/new- "
    "mission/choosing.test.ts"
)
def test_a_name_that_is_taken_is_not_used_and_a_robot_of_the_folder_is_one_to_begin_with(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(None)
    a_name_that_a_file_has_is_not_taken_by_a_new_mission(studio)
    a_robot_of_the_folder_is_one_to_begin_with(studio)
