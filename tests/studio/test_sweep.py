"""The map of failures: asked for, walked by keys, played; what is played ends as its field says."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.patience import PATIENCE_S
from tests.studio.looks import find_nothing

pytestmark = pytest.mark.browser


@pytest.mark.thorough(
    "test_many_runs.py with a smaller mission; web/src/features/sweep/SweepPanel.test.tsx: asked, walked by keys, "
    "played; server/test_sweep_socket.py"
)
def test_a_field_of_the_map_is_played_and_ends_as_it_says(open_studio):
    studio = open_studio("transport/transport.krt")
    studio.at("menu-Run").click()
    studio.at("menu-run-sweep").click()
    expect(studio.at("sweep-begin")).to_have_text("Do 175 runs")
    studio.at("sweep-moments").select_option("10")
    studio.at("sweep-seconds").fill("0")
    expect(studio.at("sweep-begin")).to_be_disabled()
    studio.at("sweep-seconds").fill("40")
    studio.at("sweep-begin").click()
    expect(studio.at("sweep-map")).to_be_visible(timeout=1000 * PATIENCE_S)
    expect(studio.page.locator("td.sweep-field")).to_have_count(70)
    expect(studio.at("sweep-count-stuck")).to_be_visible()
    find_nothing(studio, "the map of failures")

    studio.full_speed()
    first = studio.at("field-0-0")
    first.focus()
    for key in ("ArrowRight", "ArrowDown", "ArrowUp", "ArrowLeft", "End", "Home"):
        studio.page.keyboard.press(key)
    expect(first).to_be_focused()
    studio.page.keyboard.press("Enter")
    expect(first).to_have_attribute("data-played", "true")
    ending = first.get_attribute("data-ending")
    expect(studio.at("status")).to_have_attribute("data-status", str(ending))
    expect(studio.at("edited-since")).to_have_count(0)
    sentence = studio.at("status").locator(".run-status-words").inner_text()
    expect(studio.at("sweep-chosen")).to_contain_text(sentence)
