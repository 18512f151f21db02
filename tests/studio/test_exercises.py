"""An exercise in the studio: opened from the gallery, judged after a run and on demand, and what went wrong is played."""

from __future__ import annotations

import os
from pathlib import Path

from playwright.sync_api import expect

from tests.studio.conftest import OpenStudio


def test_a_child_opens_an_exercise_runs_it_has_it_judged_and_watches_what_went_wrong(open_studio: OpenStudio) -> None:
    page = open_studio("blink").page
    page.keyboard.press("Control+o")
    page.get_by_test_id("exercise-card-example:exercises/12-no-jam.exercise.xml").click()
    panel = page.get_by_test_id("exercise")
    expect(panel).to_be_visible()
    expect(panel).to_be_focused()
    expect(page.get_by_test_id("exercise-count")).to_have_text("0 of 5 goals")
    shot(page, "open")
    page.get_by_test_id("exercise-judge").click()
    first, second = page.get_by_test_id("exercise-goal-1"), page.get_by_test_id("exercise-goal-2")
    expect(page.get_by_test_id("exercise-basis")).to_have_text("Judged in 2 runs.")
    expect(first).to_have_attribute("data-state", "reached")
    expect(second).to_have_attribute("data-state", "missed")
    expect(second).to_contain_text("touches carrier-1")
    shot(page, "judged")
    second.get_by_role("button", name="Watch what went wrong: at 2.0 s").click()
    expect(page.get_by_test_id("stop-button")).to_be_enabled()
    shot(page, "plays")
    page.get_by_test_id("exercise-leave").click()
    expect(panel).to_have_count(0)


def shot(page, name: str) -> None:
    folder = os.environ.get("SHOTS")
    if folder:
        for width, height in ((1440, 900), (390, 800)):
            page.set_viewport_size({"width": width, "height": height})
            page.screenshot(path=Path(folder) / f"{name}-{width}.png")
        page.set_viewport_size({"width": 1600, "height": 1000})
