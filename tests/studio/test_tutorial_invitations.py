"""Where a newcomer meets the tutorials: in the folder, in an empty program, at the first start."""

from __future__ import annotations

import shutil

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import EXAMPLES
from tests.studio.test_tutorials import BLINK, FIRST, OpenStudio, at_step

pytestmark = pytest.mark.browser


@pytest.mark.thorough("tests/server/test_tutorials.py, a tutorial dropped into the folder appears")
def test_a_tutorial_in_the_folder_appears_and_one_with_a_mistake_says_which(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    text = (EXAMPLES / "tutorials" / "first-steps" / "first-steps.tutorial.xml").read_text(encoding="utf-8")
    mine = text.replace("<label>First steps</label>", "<label>Our class</label>").replace("first-steps.krt", "x.krt")
    shutil.copy(EXAMPLES / "tutorials" / "first-steps" / "first-steps.krt", studio.folder / "x.krt")
    (studio.folder / "mine.tutorial.xml").write_text(mine, encoding="utf-8")
    (studio.folder / "bad.tutorial.xml").write_text(mine.replace("<step>", "<stop>", 1), encoding="utf-8")
    studio.page.keyboard.press("Alt+l")
    bad = studio.at("tutorial-card-bad.tutorial.xml")
    expect(bad).to_contain_text("This tutorial cannot be used:")
    expect(bad).to_contain_text("<stop>")
    studio.at("tutorial-card-mine.tutorial.xml").click()
    at_step(studio, 1)
    expect(studio.at("tutorial")).to_contain_text("Our class")
    studio.at("menu-Help").click()
    expect(studio.at("menu-help-tutorial-mine.tutorial.xml")).to_be_visible()
    expect(studio.at("menu-help-tutorial-bad.tutorial.xml")).to_have_count(0)


@pytest.mark.thorough(
    "web/src/features/learn/learn.test.tsx: under an empty program stand the next ones, and nothing while a "
    "lesson is open"
)
def test_an_empty_program_invites_to_a_tutorial(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    studio.new_mission()
    cards = studio.page.locator(".teaching .learn-card")
    expect(cards).to_have_count(4)
    cards.first.click()
    at_step(studio, 1)
    expect(studio.page.locator(".teaching .learn-card")).to_have_count(0)


@pytest.mark.thorough("web/src/features/tutorial/Welcome.test.tsx")
def test_a_newcomer_is_welcomed_once(open_studio: OpenStudio) -> None:
    studio = open_studio(None)
    welcome = studio.at("welcome")
    expect(welcome).to_contain_text("New here?")
    studio.at("welcome-close").click()
    expect(welcome).to_have_count(0)
    studio.page.reload()
    expect(studio.at("run-button")).to_be_visible()
    studio.at("menu-Help").click()
    expect(studio.at(f"menu-help-tutorial-{FIRST}")).to_be_visible()
    expect(welcome).to_have_count(0)
