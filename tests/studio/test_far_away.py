"""A graph from far away: shapes and colours, no words; it is still selected and still tells of mistakes."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]


def far(studio: Studio) -> Locator:
    """The blocks of the graph, once it is small."""
    canvas = studio.at("canvas")
    expect(canvas).to_have_attribute("data-plain", "false")
    for _ in range(8):
        canvas.press("-")
    expect(canvas).to_have_attribute("data-plain", "true")
    return canvas.locator(".plain")


def far_away_there_are_blocks_and_close_by_there_are_words(studio: Studio) -> None:
    count = studio.page.locator(".canvas-node").count()
    blocks = far(studio)
    expect(blocks).to_have_count(count)
    expect(studio.at("canvas").locator(".chip, .box, .arc-label, .fold")).to_have_count(0)
    assert "".join(blocks.all_inner_texts()).strip() == ""
    studio.at("canvas").press("Control+0")
    expect(studio.at("canvas")).to_have_attribute("data-plain", "false")
    expect(blocks).to_have_count(0)
    expect(studio.page.locator(".vertex-name").first).to_be_visible()


def a_block_is_selected_by_a_click_and_has_a_name_for_screen_readers(studio: Studio) -> None:
    block = far(studio).nth(1)
    assert block.get_attribute("aria-label")
    block.click()
    expect(block).to_have_attribute("aria-current", "true")
    studio.page.keyboard.press("Delete")
    expect(studio.at("saved-state")).not_to_have_text("saved")


def a_mistake_is_seen_from_far_away(studio: Studio) -> None:
    studio.drop("If Then", "arc-start.next")
    expect(studio.page.locator(".trouble").first).to_be_visible()
    far(studio)
    expect(studio.page.locator(".plain-trouble").first).to_be_visible()
    expect(studio.page.locator(".trouble")).to_have_count(0)


@pytest.mark.thorough(
    "web/src/features/canvas/Plain.test.tsx: blocks without words, selected, named, with a sign of trouble; "
    "camera.test.ts: the zoom"
)
def test_far_away_there_are_blocks_that_are_selected_named_and_tell_of_mistakes_and_close_by_words(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio("blink/blink.krt")
    far_away_there_are_blocks_and_close_by_there_are_words(studio)
    a_block_is_selected_by_a_click_and_has_a_name_for_screen_readers(studio)
    studio.take_back()
    studio.at("canvas").press("Control+0")
    a_mistake_is_seen_from_far_away(studio)
