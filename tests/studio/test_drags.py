"""What a hand drags: splicing, parking, docking, moving with the body, copies — each with the mouse, each undoable."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.studio.conftest import Studio
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
TRANSPORT = "transport/transport.krt"


def vertex(studio: Studio, words: str) -> Locator:
    """The first vertex of the graph that says that."""
    return studio.page.locator(".vertex", has_text=words).first


def name_of(at: Locator) -> str:
    """The vertex's id."""
    return (at.get_attribute("data-testid") or "").removeprefix("vertex-")


def settled(studio: Studio) -> None:
    """Waits until everything stands where it goes: a hand takes what it sees."""
    studio.page.evaluate(
        "Promise.all(document.getAnimations().map(one => one.finished.catch(() => null))).then(() => 0)"
    )


def code_is(studio: Studio, text: str) -> None:
    """Waits until the LLL is exactly that."""
    expect(studio.page.locator('[data-testid="code"] .cm-line')).to_have_text(text.split("\n"))


def fold_first_parallel(studio: Studio) -> None:
    """Makes room: all of the transport's loop is then in view."""
    expect(studio.page.locator(".bars").first).to_be_visible()
    studio.page.locator("[data-testid^=collapse-]").nth(1).click()
    expect(studio.page.locator(".bars")).to_have_count(0)
    settled(studio)


def grip(at: Locator) -> Locator:
    """Where a hand takes a vertex: its icon, for chips and boxes are things of their own."""
    return at.locator(".tile, .vertex-name").first


def arcs_light_up_and_a_drop_on_one_splices_the_part_in(studio: Studio) -> None:
    mouse = studio.page.mouse
    studio.at("part-Wait").scroll_into_view_if_needed()
    part = place_of(studio.at("part-Wait"))
    arc = place_of(studio.at("arc-start.next"))
    mouse.move(part["x"] + 30, part["y"] + 10)
    mouse.down()
    mouse.move(part["x"] + 60, part["y"] + 30, steps=4)
    expect(studio.at("canvas")).to_have_attribute("data-accepts", "arcs")
    mouse.move(arc["x"] + 9, arc["y"] + 9, steps=8)
    expect(studio.page.locator(".arc.is-aimed")).to_have_attribute("data-arc", "start.next")
    mouse.up()
    expect(studio.at("code")).to_contain_text(re.compile(r"WAIT\(10\);\s*# Drive"))


def escape_ends_a_drag_without_a_change(studio: Studio) -> None:
    mouse = studio.page.mouse
    studio.at("part-Wait").scroll_into_view_if_needed()
    part = place_of(studio.at("part-Wait"))
    arc = place_of(studio.at("arc-start.next"))
    mouse.move(part["x"] + 30, part["y"] + 10)
    mouse.down()
    mouse.move(arc["x"] + 9, arc["y"] + 9, steps=8)
    expect(studio.page.locator(".ghost")).to_be_visible()
    studio.page.keyboard.press("Escape")
    expect(studio.page.locator(".ghost")).to_have_count(0)
    mouse.up()
    expect(studio.at("saved-state")).to_have_text("saved")


def a_drop_on_the_void_parks_a_part_and_a_drag_brings_it_in(studio: Studio) -> None:
    before = studio.code()
    studio.at("part-Wait").scroll_into_view_if_needed()
    canvas, part = place_of(studio.at("canvas")), place_of(studio.at("part-Wait"))
    mouse = studio.page.mouse
    mouse.move(part["x"] + 30, part["y"] + 10)
    mouse.down()
    mouse.move(canvas["x"] + 30, canvas["y"] + canvas["height"] - 120, steps=10)
    expect(studio.page.locator(".ghost")).to_contain_text("aside")
    mouse.up()
    parked = studio.page.locator(".vertex.is-parked", has_text="Wait")
    expect(parked).to_be_in_viewport()
    settled(studio)
    assert studio.code() == before, "what is parked is not in the program"
    studio.drag(grip(parked), studio.at("arc-start.next"))
    expect(studio.page.locator(".vertex.is-parked")).to_have_count(0)
    studio.expect_code("WAIT(10);")


def a_test_docks_in_a_slot_and_nests_in_the_hole_of_another(studio: Studio) -> None:
    studio.drop("If Then", "arc-start.next")
    expect(studio.page.locator(".vertex.is-selected")).to_contain_text("If Then")
    name = name_of(studio.page.locator(".vertex.is-selected"))
    choice = studio.at(f"vertex-{name}")
    settled(studio)
    studio.page.get_by_test_id("part-find").fill("and")
    studio.drop("And", f"slot-{name}.condition")
    studio.page.get_by_test_id("part-find").fill("is pressed")
    hole = choice.locator(".hole").first
    expect(hole).to_be_visible()
    settled(studio)
    studio.expect_code("[ & ]();")
    before = studio.code()
    studio.drag(studio.page.locator("[data-testid='part-Cargo.IsPressed']"), hole)
    studio.expect_code("[Cargo.IsPressed() &")
    studio.page.keyboard.press("Control+z")
    expect(choice.locator(".hole")).to_have_count(2)
    code_is(studio, before)


def a_vertex_moves_with_its_body_and_comes_back_with_undo(studio: Studio) -> None:
    before = studio.code()
    choice = vertex(studio, "If Then Else")
    studio.drag(grip(choice), studio.at("arc-start.next"))
    expect(studio.at("code")).to_contain_text(
        re.compile(r"Cargo\.IsPressed[\s\S]*Dock\.Set\(0\)[\s\S]*# Drive to the dock")
    )
    assert studio.code().count("Cargo.IsPressed") == before.count("Cargo.IsPressed")
    studio.page.keyboard.press("Control+z")
    expect(studio.at("undo")).to_be_disabled()
    code_is(studio, before)


def a_drag_with_alt_takes_a_copy(studio: Studio) -> None:
    count = studio.code().count("Dock.Set(0)")
    choice = vertex(studio, "If Then Else")
    studio.page.keyboard.down("Alt")
    studio.drag(grip(choice), studio.at("arc-start.next"))
    studio.page.keyboard.up("Alt")
    expect(studio.page.locator(".vertex", has_text="If Then Else")).to_have_count(2)
    expect(studio.at("code")).to_contain_text(
        re.compile(r"Dock\.Set\(0\)[\s\S]*# Drive to the dock[\s\S]*Dock\.Set\(0\)")
    )
    assert studio.code().count("Dock.Set(0)") == count + 1


def a_vertex_cannot_go_into_its_own_body(studio: Studio) -> None:
    choice = vertex(studio, "If Then Else")
    name = name_of(choice)
    inside = studio.at(f"arc-{name}.then")
    expect(inside).to_be_attached()
    begin, end = place_of(grip(choice)), place_of(inside)
    mouse = studio.page.mouse
    mouse.move(begin["x"] + 8, begin["y"] + 8)
    mouse.down()
    mouse.move(end["x"] + 9, end["y"] + 9, steps=8)
    expect(studio.page.locator(f".arc.is-aimed[data-arc='{name}.then']")).to_have_count(0)
    studio.page.keyboard.press("Escape")
    mouse.up()
    expect(studio.at("saved-state")).to_have_text("saved")


@pytest.mark.thorough(
    "web/src/features/canvas/editing.test.tsx: drags by a pointer are spliced, parked, moved, copied, refused; "
    "docked in slots as they stand on the screen: test_canvas.py"
)
def test_parts_and_vertices_are_dragged_spliced_parked_docked_moved_and_copied(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    escape_ends_a_drag_without_a_change(studio)
    arcs_light_up_and_a_drop_on_one_splices_the_part_in(studio)
    studio.take_back()
    a_test_docks_in_a_slot_and_nests_in_the_hole_of_another(studio)
    studio.at("part-find").fill("")
    studio.take_back()
    fold_first_parallel(studio)
    a_drop_on_the_void_parks_a_part_and_a_drag_brings_it_in(studio)
    studio.take_back()
    settled(studio)
    a_vertex_cannot_go_into_its_own_body(studio)
    a_vertex_moves_with_its_body_and_comes_back_with_undo(studio)
    settled(studio)
    a_drag_with_alt_takes_a_copy(studio)
