"""What somebody meets in the first minutes, beside the tasks that `test_first_hour.py` counts."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.effort import cases
from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]

SEEN = """(row) => {
    const [at, list] = [row.getBoundingClientRect(), row.closest('.palette-list').getBoundingClientRect()];
    return at.top >= list.top - 1 && at.bottom <= list.bottom + 1 && at.right <= list.right;
}"""


@pytest.mark.parametrize(("width", "height"), cases([(1024, 768)], [(1440, 900), (768, 1024)]))
def test_the_list_of_parts_is_scrolled_with_the_wheel_and_shows_what_sensors_say_whole(
    open_studio: OpenStudio, width: int, height: int
) -> None:
    studio = open_studio("draw-square/draw-square.krt", viewport={"width": width, "height": height})
    page = studio.page
    if studio.at("room-palette").is_visible():
        studio.at("room-palette").click()
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    box = page.locator(".parts").bounding_box()
    assert box is not None
    sensor = studio.at("object-Captor")
    assert not sensor.evaluate(SEEN)
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] - 40)
    # By hand: what a test scrolls into view goes there also where nobody else can go.
    while not sensor.evaluate(SEEN):
        before = page.locator(".palette-list").evaluate("(one) => one.scrollTop")
        page.mouse.wheel(0, 100)
        page.wait_for_function("(was) => document.querySelector('.palette-list').scrollTop > was", arg=before)
    assert sensor.locator(".palette-live").evaluate(SEEN)


def test_the_whole_program_stays_in_view_when_the_window_is_another_one(open_studio: OpenStudio) -> None:
    studio = open_studio("square/square.krt", viewport={"width": 1440, "height": 900})
    for width, height in ((390, 844), (1024, 768), (1600, 1000)):
        studio.page.set_viewport_size({"width": width, "height": height})
        for vertex in ("start", "v1", "v3", "stop"):
            expect(studio.at(f"vertex-{vertex}")).to_be_in_viewport(ratio=1)
    # The arena's own tools too.
    studio.page.set_viewport_size({"width": 1024, "height": 768})
    expect(studio.at("arena-large")).to_be_in_viewport(ratio=1)


@pytest.mark.thorough("web/src/features/palette/Palette.test.tsx; web/src/model/commands/changeRobot.test.ts")
def test_the_robot_is_changed_above_its_parts_and_undo_gives_back_the_one_before(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    studio.at("palette-robot").click()
    expect(studio.at("menu-robot-mini-robot")).to_have_attribute("aria-checked", "true")
    expect(studio.at("menu-robot-mini-robot").locator(".picture")).to_be_visible()
    studio.at("menu-robot-line-follower").click()
    expect(studio.at("palette-robot")).to_have_text("Line follower")
    expect(studio.at("object-LeftWheel")).to_be_visible()
    expect(studio.at("problems")).to_contain_text("2")
    studio.at("undo").click()
    expect(studio.at("palette-robot")).to_have_text("Mini-robot")
    expect(studio.at("problems")).to_contain_text("0")
