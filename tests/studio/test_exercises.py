"""An exercise in the studio: opened from the gallery, judged after a run and on demand; what went wrong is played."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.patience import PATIENCE_S
from tests.studio.looks import find_nothing

pytestmark = pytest.mark.browser
JAM = "exercise-card-example:exercises/12-no-jam.exercise.xml"

STOPPED_AT_ONCE = """async () => {
  document.querySelector("[data-testid=exercise-judge]").click();
  await new Promise((after) => setTimeout(after));
  document.querySelector("[data-testid=exercise-stop]").click();
}"""


@pytest.mark.thorough(
    "web/src/features/exercise/Panel.test.tsx: goals, stopping, and what went wrong is played; "
    "tests/server/test_exercises.py and tests/exercises: what is judged; the journey below judges a run"
)
def test_an_exercise_is_opened_judged_and_what_went_wrong_is_watched(open_studio) -> None:
    studio = open_studio("transport/transport.krt")
    page = studio.page
    page.keyboard.press("Alt+l")
    studio.at(JAM).scroll_into_view_if_needed()
    shot(page, "gallery")
    studio.at(JAM).click()
    expect(studio.at("exercise")).to_be_focused()
    expect(studio.at("exercise-count")).to_have_text("0 of 5 goals")
    shot(page, "open")
    page.evaluate(STOPPED_AT_ONCE)
    expect(studio.at("exercise-basis")).to_contain_text("stopped", timeout=1000 * PATIENCE_S)
    expect(studio.at("exercise-goal-4")).to_have_attribute("data-state", "open")
    studio.at("exercise-judge").click()
    expect(studio.at("exercise-basis")).to_have_text("Judged in 2 runs.", timeout=1000 * PATIENCE_S)
    expect(studio.at("exercise-goal-1")).to_have_attribute("data-state", "reached")
    second = studio.at("exercise-goal-2")
    expect(second).to_have_attribute("data-state", "missed")
    expect(second).to_contain_text("touches carrier-1")
    shot(page, "judged")
    find_nothing(studio, "an exercise that is judged")
    studio.full_speed()
    second.get_by_role("button", name="Watch what went wrong: at 2.0 s").click()
    expect(studio.at("status")).to_have_attribute("data-status", "done", timeout=1000 * PATIENCE_S)
    # What was judged already is not judged once more when its run has been watched.
    expect(studio.at("exercise-basis")).to_have_text("Judged in 2 runs.")
    page.keyboard.press("F5")
    expect(studio.at("exercise-basis")).to_contain_text("After the run with seed 1", timeout=1000 * PATIENCE_S)
    studio.at("exercise-leave").click()
    expect(studio.at("exercise")).to_have_count(0)


def test_the_path_leads_from_one_lesson_to_the_next(open_studio) -> None:
    studio = open_studio("blink/blink.krt")
    page = studio.page
    page.keyboard.press("Alt+l")
    expect(studio.at("learn-count")).to_have_text("0 of 23 done")
    shot(page, "path")
    studio.at("exercise-card-example:exercises/01-first-drive.exercise.xml").click()
    expect(studio.at("exercise")).to_be_focused()
    studio.edit_code()
    page.keyboard.press("Control+a")
    page.keyboard.insert_text("Wheel.DriveBy(80);")
    studio.expect_code("Wheel.DriveBy(80);")
    page.keyboard.press("Escape")
    page.keyboard.press("F5")
    expect(studio.at("ending-next")).to_have_text("Next: Round the corner", timeout=1000 * PATIENCE_S)
    expect(studio.at("team-stop")).to_have_attribute("data-on", "false")
    expect(studio.at("exercise-next")).to_have_text("Next: Round the corner")
    shot(page, "solved")
    find_nothing(studio, "an exercise that is solved")
    studio.at("exercise-next").press("Enter")
    # What was edited is kept without a question, and comes back with its exercise.
    expect(studio.at("exercise")).to_contain_text("First over the green field")
    expect(studio.at("banner")).to_have_count(0)
    page.keyboard.press("Alt+l")
    expect(studio.at("learn-count")).to_have_text("1 of 23 done")
    shot(page, "ticked")
    studio.at("exercise-card-example:exercises/01-first-drive.exercise.xml").click()
    studio.expect_code("Wheel.DriveBy(80);")


def shot(page: Page, name: str) -> None:
    """A picture to look at, where somebody wants some."""
    folder = os.environ.get("KITROBOT_SCREENS")
    if not folder:
        return
    before = page.viewport_size
    for width, height in ((1440, 900), (390, 800)):
        page.set_viewport_size({"width": width, "height": height})
        page.screenshot(path=Path(folder) / f"{name}-{width}.png")
    assert before is not None
    page.set_viewport_size(before)
