"""The world in the studio: drawn, moved, measured, wrong, undone, kept; by mouse and by keyboard."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import LOOKS, Studio
from tests.studio.looks import choose as choose_look
from tests.studio.looks import find_nothing
from tests.studio.studio_page import place_of
from tests.studio.test_undo import press_until_nothing_is_left, save

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
BRAKE = "brake/brake.krt"
TRANSPORT = "transport/transport.krt"
MARGIN_PX = 40


def edit(studio: Studio) -> None:
    """Opens the world and copies it into the mission."""
    studio.at("tab-of-world").click()
    studio.at("edit-world").click()
    expect(studio.at("world-tool-wall")).to_be_visible()


def spot(studio: Studio, x_mm: float, y_mm: float, size: tuple[float, float]) -> tuple[float, float]:
    """Where a place of the world is on the screen while all of it is in view."""
    box = place_of(studio.at("world-stage"))
    scale = min((box["width"] - 2 * MARGIN_PX) / size[0], (box["height"] - 2 * MARGIN_PX) / size[1])
    left = box["x"] + (box["width"] - size[0] * scale) / 2
    bottom = box["y"] + (box["height"] + size[1] * scale) / 2
    return left + x_mm * scale, bottom - y_mm * scale


def drag(studio: Studio, begin: tuple[float, float], end: tuple[float, float]) -> None:
    mouse = studio.page.mouse
    mouse.move(*begin)
    mouse.down()
    mouse.move((begin[0] + end[0]) / 2, (begin[1] + end[1]) / 2, steps=4)
    mouse.move(*end, steps=6)
    mouse.up()


ROOM, RING = (4000.0, 2500.0), (1200.0, 840.0)


def number(studio: Studio, name: str) -> float:
    return float(studio.at(f"world-{name}").input_value())


def type_number(studio: Studio, name: str, value: float | str) -> None:
    studio.at(f"world-{name}").fill(str(value))
    studio.page.keyboard.press("Enter")


def place_of_robot(studio: Studio) -> int:
    """x of the one robot, from the arena's words."""
    found = re.findall(r"\d[\d,.\u202f]*", studio.at("arena-summary").inner_text().replace("robot-1", ""))
    return int(re.sub(r"\D", "", found[0]))


def a_wall_is_drawn_and_the_robot_stops_at_it(studio: Studio) -> None:
    edit(studio)
    assert place_of(studio.at("world"))["width"] > 1590, "the world has the whole page"
    find_nothing(studio, "the world", within="[data-testid=world]")
    studio.at("world-tool-wall").click()
    drag(studio, spot(studio, 3003, 902, ROOM), spot(studio, 2997, 1601, ROOM))
    assert [number(studio, name) for name in ("x1", "y1", "x2", "y2")] == [3000, 900, 3000, 1600]
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    expect(studio.at("arena-summary")).to_contain_text(re.compile("2[,\u202f.]?[6-9]\\d\\d"))
    assert 2600 < place_of_robot(studio) < 3000
    expect(studio.at("arena-summary")).not_to_contain_text("collision")


def a_dock_is_moved_along_its_road_and_the_boxes_still_arrive(studio: Studio) -> None:
    edit(studio)
    studio.at("thing-dock-1").click()
    before = number(studio, "at_mm")
    drag(studio, spot(studio, 850, 420, RING), spot(studio, 900, 432, RING))
    after = number(studio, "at_mm")
    assert -20 < after - before < -5
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    expect(studio.at("arena-summary")).to_contain_text("12 of 12 delivered")


def a_road_that_cannot_be_drawn_is_told_at_the_road(studio: Studio) -> None:
    edit(studio)
    studio.at("thing-road-0").click()
    type_number(studio, "corner-1-radius", 5000)
    expect(studio.at("wrong-road-0")).to_be_attached()
    expect(studio.at("world-chosen")).to_contain_text("there is no room for this radius")
    expect(studio.at("thing-road-0")).to_have_attribute("aria-label", re.compile("no room for this radius"))
    studio.at("tab-carrier").click()
    studio.page.keyboard.press("F8")
    expect(studio.at("world-chosen")).to_contain_text("there is no room for this radius")
    expect(studio.at("thing-road-0")).to_have_attribute("aria-selected", "true")
    studio.page.keyboard.press("F8")
    find_nothing(studio, "a problem of the world")
    studio.at("world-stage").focus()
    studio.page.keyboard.press("Control+z")
    expect(studio.at("wrong-road-0")).not_to_be_attached()
    expect(studio.at("problems")).to_contain_text("0")


@pytest.mark.thorough(
    "web/src/features/world/world.test.tsx: what is wrong is told at its thing; session/problem-walk.test.ts: F8 "
    "leads there; server/test_own_world.py: why a road cannot be drawn"
)
def test_a_road_that_cannot_be_drawn_is_told_at_the_road(open_studio: OpenStudio) -> None:
    a_road_that_cannot_be_drawn_is_told_at_the_road(open_studio(TRANSPORT))


@pytest.mark.thorough("web/src/model/world/world.test.ts: things go where they are moved, docks along their road")
def test_a_dock_is_moved_along_its_road_and_the_boxes_still_arrive(open_studio: OpenStudio) -> None:
    a_dock_is_moved_along_its_road_and_the_boxes_still_arrive(open_studio(TRANSPORT))


@pytest.mark.thorough("web/src/model/world/world.test.ts; web/src/features/world/world.test.tsx: told at its thing")
def test_a_road_with_a_hole_in_a_file_is_told_at_the_road_and_mended(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    edit(studio)
    studio.page.keyboard.press("Control+s")
    expect(studio.page.locator("body")).not_to_contain_text("not saved")
    path = studio.folder / "transport.krt"
    text = path.read_text()
    assert 'to="150"' in text
    (studio.folder / "hole.krt").write_text(text.replace('to="150"', 'to="120"'))
    studio.page.keyboard.press("Control+o")
    studio.at("open-dialog").locator('[data-path="hole.krt"]').click()
    studio.at("tab-of-world").click()
    expect(studio.at("wrong-road-0")).to_be_attached()
    studio.at("thing-road-0").click()
    expect(studio.at("world-chosen")).to_contain_text("a gap of 30 mm")
    type_number(studio, "sections", 5)
    type_number(studio, "sections", 6)
    drag_cut = place_of(studio.page.locator('[data-testid="grip-cut:1"]'))
    middle = (drag_cut["x"] + drag_cut["width"] / 2, drag_cut["y"] + drag_cut["height"] / 2)
    drag(studio, middle, (middle[0], middle[1] - 6))
    expect(studio.at("wrong-road-0")).not_to_be_attached()


@pytest.mark.thorough("web/src/session/journal.test.ts, web/src/model/everything.test.ts; tests/studio/test_journal.py")
def test_the_journal_keeps_the_world(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    edit(studio)
    # The change before it may still be on its way.
    with studio.page.expect_response(
        lambda answer: answer.url.endswith("/api/journal") and "1500" in (answer.request.post_data or "")
    ):
        type_number(studio, "width_mm", 1500)
    studio.page.reload()
    expect(studio.page.locator('[data-testid="code"] .cm-line').first).not_to_be_empty()
    studio.at("tab-of-world").click()
    expect(studio.at("world-width_mm")).to_have_value("1500")


@pytest.mark.thorough(
    "web/src/model/everything.test.ts and web/src/model/world/world.test.ts; by keys: features/world/world.test.tsx"
)
def test_everything_is_undone_to_the_bytes_of_the_file(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    written = (studio.folder / "transport.krt").read_bytes()
    keys = studio.page.keyboard
    edit(studio)
    for kind in ("wall", "floor", "line", "road", "storehouse", "dock", "start", "box", "ball", "zone"):
        studio.at(f"world-tool-{kind}").click()
        drag(studio, spot(studio, 400, 300, RING), spot(studio, 640, 520, RING))
        expect(studio.at(f"world-tool-{kind}")).to_have_attribute("aria-pressed", "false")
        expect(studio.at("world-chosen")).to_be_visible()
    studio.at("thing-road-0").click()
    drag(studio, spot(studio, 850, 702.5, RING), spot(studio, 900, 760, RING))
    type_number(studio, "corner-2-radius", 100)
    studio.at("world-corner-1-add").click()
    type_number(studio, "sections", 8)
    studio.at("world-closed").click()
    studio.at("thing-storehouse-0").click()
    studio.at("world-thing-name").fill("Magazine")
    keys.press("Enter")
    expect(studio.at("thing-storehouse-0")).to_contain_text("Magazine")
    studio.at("world-stage").focus()
    for key in ("ArrowUp", "Shift+ArrowLeft", "Control+d", "Delete"):
        keys.press(key)
    drag(studio, spot(studio, 60, 500, RING), spot(studio, 100, 540, RING))
    studio.at("world-delete").click()
    expect(studio.at("world-width_mm")).to_be_visible()
    type_number(studio, "width_mm", 1500)
    studio.at("world-stage").focus()
    changed = save(studio)
    assert b"<world version" in changed
    steps = press_until_nothing_is_left(studio, "Control+z", "Undo")
    assert steps > 15
    assert save(studio) == written
    assert press_until_nothing_is_left(studio, "Control+y", "Redo") == steps
    assert save(studio) == changed


@pytest.mark.thorough("web/src/features/world/world.test.tsx: by the keyboard, and by its numbers")
def test_the_keyboard_is_enough(open_studio: OpenStudio) -> None:
    studio = open_studio(BRAKE)
    keys = studio.page.keyboard
    keys.press("Alt+w")
    studio.at("edit-world").press("Enter")
    expect(studio.at("edit-world")).not_to_be_attached()
    expect(studio.at("world-stage")).to_be_visible()
    studio.at("world-tool-wall").press("Enter")
    expect(studio.at("thing-wall-4")).to_have_attribute("aria-selected", "true")
    assert [number(studio, name) for name in ("x1", "y1", "x2", "y2")] == [1850, 1250, 2150, 1250]
    studio.at("thing-wall-4").focus()
    keys.press("ArrowUp")
    expect(studio.at("thing-wall-3")).to_be_focused()
    keys.press("ArrowDown")
    expect(studio.at("thing-wall-4")).to_be_focused()
    expect(studio.at("thing-wall-4")).to_have_attribute("aria-selected", "true")
    studio.at("thing-wall-4").press("Enter")
    expect(studio.at("world-stage")).to_be_focused()
    for key in ("ArrowUp", "Shift+ArrowUp", "ArrowRight"):
        keys.press(key)
    assert [number(studio, name) for name in ("x1", "y1")] == [1851, 1261]
    keys.press("Control+d")
    expect(studio.at("thing-wall-5")).to_have_attribute("aria-selected", "true")
    keys.press("Delete")
    expect(studio.at("thing-wall-5")).not_to_be_attached()
    keys.press("Shift+n")
    keys.press("Control+z")
    expect(studio.at("thing-wall-5")).to_be_attached()
    keys.press("Escape")
    expect(studio.at("world-width_mm")).to_be_visible()
    studio.at("world-tool-start").press("Enter")
    studio.at("world-heading").focus()
    keys.press("ArrowUp")
    assert number(studio, "heading") == 5


def alt_is_free_of_the_grid_and_ends_hold(studio: Studio) -> None:
    edit(studio)
    keys = studio.page.keyboard
    studio.at("world-tool-wall").click()
    drag(studio, spot(studio, 1000, 1000, ROOM), spot(studio, 1500, 1000, ROOM))
    keys.down("Alt")
    begin, end = spot(studio, 1500, 1000, ROOM), spot(studio, 1514, 1227, ROOM)
    drag(studio, begin, end)
    keys.up("Alt")
    assert number(studio, "x2") % 10 != 0 or number(studio, "y2") % 10 != 0
    x2, y2 = number(studio, "x2"), number(studio, "y2")
    studio.at("world-tool-line").click()
    drag(studio, spot(studio, x2 + 12, y2 - 9, ROOM), spot(studio, 2500, 2000, ROOM))
    assert (number(studio, "corner-0-x"), number(studio, "corner-0-y")) == (x2, y2)


def a_robot_dragged_in_the_arena_starts_there(studio: Studio) -> None:
    expect(studio.at("arena-summary")).to_contain_text(re.compile("2[,\u202f]?000"))
    box = place_of(studio.at("arena-canvas"))
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    drag(studio, middle, (middle[0] - 120, middle[1]))
    expect(studio.page.get_by_text("is part of this mission now", exact=False).first).to_be_visible()
    expect(studio.at("arena-summary")).not_to_contain_text(re.compile("2[,\u202f]?000"))
    assert place_of_robot(studio) < 1700
    assert place_of_robot(studio) % 10 == 0
    studio.at("tab-of-world").click()
    studio.at("thing-start-0").click()
    assert number(studio, "x_mm") == place_of_robot(studio)
    studio.at("world-stage").focus()
    studio.page.keyboard.press("Control+z")
    expect(studio.at("edit-world")).to_be_visible()
    expect(studio.at("arena-summary")).to_contain_text(re.compile("2[,\u202f]?000"))


def the_world_becomes_a_file_and_the_mission_uses_it(studio: Studio) -> None:
    edit(studio)
    studio.at("world-tool-storehouse").click()
    drag(studio, spot(studio, 500, 500, ROOM), spot(studio, 900, 1000, ROOM))
    studio.at("save-world").click()
    studio.at("world-file").fill("mine")
    studio.at("world-file-save").click()
    studio.page.get_by_role("button", name="Use this file").click()
    expect(studio.at("edit-world")).to_be_visible()
    expect(studio.at("world")).to_contain_text("mine.world.xml")
    assert '<storehouse name="A" x="500" y="500"' in (studio.folder / "mine.world.xml").read_text()
    studio.page.keyboard.press("Control+s")
    expect(studio.page.locator("body")).not_to_contain_text("not saved")
    assert '<world href="mine.world.xml"/>' in (studio.folder / "brake.krt").read_text()


@pytest.mark.thorough("web/src/model/world/world.test.ts: a point goes to the grid, or to an end that is near")
def test_alt_is_free_of_the_grid_and_ends_hold(open_studio: OpenStudio) -> None:
    alt_is_free_of_the_grid_and_ends_hold(open_studio(BRAKE))


def test_a_robot_is_dragged_a_wall_is_drawn_and_met_and_the_world_becomes_a_file(open_studio: OpenStudio) -> None:
    studio = open_studio(BRAKE)
    a_robot_dragged_in_the_arena_starts_there(studio)
    a_wall_is_drawn_and_the_robot_stops_at_it(studio)
    studio.take_back()
    the_world_becomes_a_file_and_the_mission_uses_it(studio)


@pytest.mark.thorough("a_wall_is_drawn_and_the_robot_stops_at_it looks at the world with axe; test_clipping.py too")
@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_axe_finds_nothing_in_the_world(open_studio: OpenStudio, look: tuple[str, ...]) -> None:
    studio = open_studio(TRANSPORT)
    choose_look(studio, *look)
    studio.at("tab-of-world").click()
    expect(studio.at("edit-world")).to_be_visible()
    find_nothing(studio, "the world of a file")
    edit(studio)
    find_nothing(studio, "the world")
    for thing in ("road-0", "storehouse-0", "dock-0", "start-0"):
        studio.at(f"thing-{thing}").click()
        find_nothing(studio, thing)
    type_number(studio, "at_mm", 90000)
    expect(studio.at("wrong-start-0")).to_be_attached()
    find_nothing(studio, "a problem")
    studio.at("save-world").click()
    find_nothing(studio, "saving")
