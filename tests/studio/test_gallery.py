"""A user finds an example by its picture and opens it, from an empty program and from Open."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import EXAMPLES, Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]


def test_a_new_program_offers_four_examples_with_pictures_drawn_from_them(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    studio.new_mission()
    cards = studio.page.locator(".examples .card")
    expect(cards).to_have_count(4)
    expect(cards.locator("svg.picture")).to_have_count(4)
    expect(cards.last).to_contain_text("No box is lost")
    expect(cards.last.locator(".picture-road")).to_have_count(1)
    expect(cards.last.locator(".picture-box")).to_have_count(12)
    expect(cards.first.locator('.picture-node[data-colour="action"]')).to_have_count(2)
    cards.first.click()
    studio.expect_code("Captor.GreaterThan(8)")


def test_an_example_that_gets_the_focus_comes_into_sight_and_stays_there(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt", viewport={"width": 1280, "height": 720})
    studio.new_mission()
    last = studio.page.locator(".examples .card").last
    expect(last.locator("svg.picture")).to_be_attached()
    last.focus()
    # A frame for the browser's scrolling, and one for what answers it.
    studio.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    expect(last).to_be_in_viewport(ratio=0.9)
    last.click()
    studio.expect_code("role carrying: carrier")


def test_open_shows_every_example_and_the_keyboard_opens_one_that_runs_to_its_end(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    studio.page.keyboard.press("Control+o")
    dialog = studio.at("open-dialog")
    missions = [path for path in EXAMPLES.glob("*/*.krt") if path.parent.name != "exercises"]
    expect(dialog.locator(".card")).to_have_count(len(missions))
    card = studio.at("example-star")
    expect(card).to_contain_text("three blinks at each point")
    card.focus()
    studio.page.keyboard.press("Enter")
    expect(dialog).to_have_count(0)
    studio.expect_code("Motor.AbsoluteTurn(40, 50)")
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()


def test_a_card_shows_coloured_floor_and_robots_where_they_start_and_its_mission_runs_there(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio("blink/blink.krt")
    studio.page.keyboard.press("Control+o")
    card = studio.at("example-line-follower")
    expect(card.locator(".picture-floor")).to_have_count(4)
    # At the start “line”, which its agent names, not at the one of the agent's own name.
    expect(card.locator(".picture-world g[transform^='translate(700 1350)']")).to_have_count(1)
    expect(studio.at("example-sumo").locator(".picture-robot")).to_have_count(2)
    card.click()
    studio.expect_code("RightEye.IsBlue()")
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
