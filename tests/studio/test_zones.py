"""The world on the whole page with boxes and zones, things moved in the arena itself, and the drawing as a file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from kitrobot.cli.app import main
from tests.effort import cases
from tests.studio.conftest import EXAMPLES, Studio
from tests.studio.studio_page import place_of
from tests.studio.test_world import ROOM, drag, edit, number, spot, type_number

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]


@pytest.mark.thorough(
    "web/src/features/world/world.test.tsx: zones, boxes and templates; the whole page, drawn by the mouse and gone"
    " in a run: test_world.py"
)
def test_the_world_fills_the_page_takes_zones_and_boxes_and_gives_way_to_a_run(open_studio: OpenStudio) -> None:
    studio = open_studio("brake/brake.krt")
    page = studio.page
    edit(studio)
    for room in ("code", "arena"):
        expect(studio.at(room)).not_to_be_visible()
    expect(page.locator(".parts-frame")).not_to_be_visible()
    box = place_of(studio.at("world"))
    assert box["width"] > 1590
    # A zone is drawn, becomes loud and a rectangle, and is dragged by its grip.
    studio.at("world-tool-zone").click()
    drag(studio, spot(studio, 1000, 1000, ROOM), spot(studio, 1400, 1400, ROOM))
    assert [number(studio, name) for name in ("x_mm", "y_mm", "radius_mm", "value")] == [1200, 1200, 200, 35]
    type_number(studio, "value", 80)
    studio.at("world-zone-kind").select_option("loud")
    drag(studio, spot(studio, 1400, 1200, ROOM), spot(studio, 1500, 1200, ROOM))
    assert number(studio, "radius_mm") == 300
    studio.at("world-shape").select_option("rectangle")
    assert [number(studio, name) for name in ("width_mm", "height_mm")] == [600, 600]
    # A box by the keyboard alone, in the middle, then a step to the right.
    studio.at("world-tool-box").focus()
    page.keyboard.press("Enter")
    expect(studio.at("thing-box-0")).to_have_attribute("aria-selected", "true")
    studio.at("world-stage").focus()
    page.keyboard.press("Shift+ArrowRight")
    assert number(studio, "x_mm") == 2010
    type_number(studio, "mass", 900)
    for _ in range(3):
        page.keyboard.press("Escape")
        studio.at("world-stage").focus()
        page.keyboard.press("Control+z")
    expect(studio.at("thing-box-0")).to_have_count(0)
    expect(studio.at("thing-zone-0")).to_have_count(1)
    # A template takes the place of all of it, and undo brings it back.
    studio.at("world-templates-open").click()
    type_number(studio, "maze-seed", 5)
    studio.at("template-maze").click()
    expect(studio.at("thing-zone-0")).to_have_count(0)
    expect(studio.at("thing-floor-0")).to_have_count(1)
    studio.at("world-stage").focus()
    page.keyboard.press("Control+z")
    expect(studio.at("thing-zone-0")).to_have_count(1)
    studio.at("run-button").click()
    expect(studio.at("arena")).to_be_visible()
    expect(studio.at("world")).to_have_count(0)


def in_arena(studio: Studio, x_mm: float, y_mm: float) -> tuple[float, float]:
    """Where a place of the world of `tidy-up` is on the screen, as the arena shows all of it."""
    box = place_of(studio.at("arena-canvas"))
    width, height, margin = 2200, 1200, 26
    scale = min((box["width"] - 2 * margin) / width, (box["height"] - 2 * margin) / height)
    left = box["x"] + (box["width"] - width * scale) / 2
    bottom = box["y"] + (box["height"] + height * scale) / 2
    return left + x_mm * scale, bottom - y_mm * scale


def saved(studio: Studio) -> str:
    studio.page.keyboard.press("Control+s")
    expect(studio.page.locator("body")).not_to_contain_text("not saved")
    return (studio.folder / "tidy-up.krt").read_text(encoding="utf-8")


@pytest.mark.thorough(
    "tests/studio/test_world.py::a_robot_dragged_in_the_arena_starts_there; web/src/model/world/world.test.ts"
)
def test_a_box_is_dragged_in_the_arena_before_a_run_and_moved_from_the_keyboard(open_studio: OpenStudio) -> None:
    studio = open_studio("tidy-up/tidy-up.krt")
    page = studio.page
    canvas = studio.at("arena-canvas")
    canvas.focus()
    expect(studio.at("arena-placing")).to_have_attribute("data-ready", "true")
    page.keyboard.press("m")
    expect(studio.at("states-said")).to_contain_text("robot-1 taken")
    page.keyboard.press("m")
    expect(studio.at("states-said")).to_contain_text("Box 1 taken")
    expect(studio.at("arena-taken")).to_be_attached()
    drag(studio, in_arena(studio, 700, 610), in_arena(studio, 700, 1000))
    expect(studio.at("banner")).to_contain_text("part of this mission now")
    assert '<box x="700" y="1000" ' in saved(studio)
    # What was dragged is taken: the arrows go on with it.
    canvas.focus()
    page.keyboard.press("Shift+ArrowLeft")
    page.keyboard.press("ArrowUp")
    assert '<box x="690" y="1001" ' in saved(studio)
    page.keyboard.press("Escape")
    expect(studio.at("arena-taken")).to_have_count(0)
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    assert '<world href="tidy-up.world.xml"/>' in saved(studio)


def test_what_the_pens_drew_is_saved_as_the_command_line_writes_it(open_studio: OpenStudio, tmp_path: Path) -> None:
    studio = open_studio("flower/flower.krt")
    studio.full_speed()
    studio.at("arena-show").click()
    expect(studio.at("menu-drawing")).to_be_disabled()
    studio.page.keyboard.press("Escape")
    studio.at("run-button").click()
    studio.wait_until_done()
    for entry, options in cases([("drawing-floor", ["--floor"])], [("drawing", list[str]())]):
        studio.at("arena-show").click()
        with studio.page.expect_download() as download:
            studio.at(f"menu-{entry}").click()
        wanted = tmp_path / f"{entry}.svg"
        command = ["run", str(EXAMPLES / "flower" / "flower.krt"), "--drawing", str(wanted), *options]
        with pytest.raises(SystemExit, match="0"):
            main(command)
        assert download.value.path().read_text(encoding="utf-8") == wanted.read_text(encoding="utf-8")
