"""An experiment: a number is marked in the graph, runs are made, a dot is played; all of it is there after a reload."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from kitrobot.experiments.study import Study
from tests.patience import PATIENCE_S
from tests.studio.looks import find_nothing

pytestmark = pytest.mark.browser


@pytest.mark.thorough(
    "test_many_runs.py with a smaller mission; web/src/features/experiment/ExperimentPanel.test.tsx: it is all "
    "there again when the page was loaded again, by keys; server/test_experiment_routes.py"
)
def test_a_dot_of_an_experiment_is_a_run_that_plays(open_studio):
    studio = open_studio("transport/transport.krt")
    page = studio.page
    studio.at("menu-Run").click()
    studio.at("menu-run-experiment").click()
    studio.at("experiment-address").fill("agents.carrier")
    studio.at("experiment-vary").click()
    studio.at("values-agents.carrier").fill("2,3")
    studio.at("experiment-seeds").fill("1-2")
    studio.at("experiment-seconds").fill("30")
    expect(studio.at("experiment-begin")).to_have_text("Do 4 runs", timeout=1000 * PATIENCE_S)
    studio.at("experiment-begin").click()
    expect(studio.at("experiment-done")).to_have_text("4 of 4 runs", timeout=1000 * PATIENCE_S)
    expect(page.locator(".experiment-dot")).to_have_count(4)
    expect(studio.at("experiment-begin")).to_be_visible()
    find_nothing(studio, "the experiment")

    studio.full_speed()
    studio.at("point-0").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    expect(studio.at("run-2")).to_be_visible()
    studio.at("run-2").focus()
    page.keyboard.press("End")
    page.keyboard.press("Enter")
    played = page.locator('.experiment-run[data-played="true"]')
    expect(played).to_have_count(1)
    expect(studio.at("status")).to_have_attribute("data-status", "time", timeout=1000 * PATIENCE_S)
    assert len(Study(studio.folder / "transport-study").rows) == 4

    page.reload()
    studio.at("menu-Run").click()
    studio.at("menu-run-experiment").click()
    expect(studio.at("experiment-done")).to_have_text("4 of 4 runs", timeout=1000 * PATIENCE_S)
