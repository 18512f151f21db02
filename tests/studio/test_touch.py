"""Fingers instead of a mouse: a tablet and a phone, with real touch events."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import CDPSession, Locator, ViewportSize, expect

from tests.studio.conftest import Studio
from tests.studio.looks import find_nothing
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

TRANSPORT = "transport/transport.krt"
TABLET = ViewportSize(width=1024, height=768)
PHONE = ViewportSize(width=390, height=844)


@pytest.fixture
def open_with_fingers(open_studio: Callable[..., Studio]) -> Callable[[ViewportSize], Studio]:
    """The studio as a device without a mouse shows it."""

    def open_on(size: ViewportSize) -> Studio:
        studio = open_studio(TRANSPORT, viewport=size, has_touch=True, is_mobile=True)
        expect(studio.page.locator(".vertex").first).to_be_visible()
        return studio

    return open_on


class RobotSession:
    """Fingers on the glass, as the browser hears of them."""

    def __init__(self, studio: Studio) -> None:
        self.glass: CDPSession = studio.page.context.new_cdp_session(studio.page)

    def put(self, kind: str, *points: tuple[float, float]) -> None:
        touches: list[dict[str, Any]] = [{"x": x, "y": y, "id": index} for index, (x, y) in enumerate(points)]
        self.glass.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touches})

    def move(self, *strokes: tuple[tuple[float, float], tuple[float, float]], steps: int = 6) -> None:
        """Moves fingers that are down, each along its stroke."""
        for step in range(1, steps + 1):
            share = step / steps
            self.put("touchMove", *((a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share) for a, b in strokes))


def middle(at: Locator) -> tuple[float, float]:
    box = place_of(at)
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def camera(studio: Studio) -> tuple[float, float, float]:
    """x, y and zoom of the canvas."""
    found = studio.page.evaluate(
        "(() => { const m = new DOMMatrix(getComputedStyle(document.querySelector('.canvas-graph')).transform);"
        " return [m.e, m.f, m.a]; })()"
    )
    return found[0], found[1], found[2]


def a_tap_selects_and_a_tap_beside_selects_nothing(studio: Studio) -> None:
    studio.at("vertex-start").tap()
    expect(studio.at("vertex-start")).to_have_attribute("aria-current", "true")
    studio.page.touchscreen.tap(240, 300)
    expect(studio.at("vertex-start")).to_have_attribute("aria-current", "false")


def a_finger_that_rests_opens_the_menu_and_an_entry_is_tapped(studio: Studio) -> None:
    hand = RobotSession(studio)
    loop = studio.page.locator(".vertex", has_text="While").first
    box = place_of(loop)
    hand.put("touchStart", (box["x"] + 60, box["y"] + 22))
    expect(studio.at("context-menu")).to_be_visible()
    hand.put("touchEnd")
    menu = place_of(studio.page.get_by_role("menu"))
    assert menu["x"] >= 0
    assert menu["x"] + menu["width"] <= TABLET["width"]
    studio.at("menu-context-note").tap()
    expect(studio.at("note-field")).to_be_visible()


def a_part_is_dragged_from_the_palette_onto_an_arc(studio: Studio) -> None:
    hand = RobotSession(studio)
    studio.at("part-Wait").scroll_into_view_if_needed()
    begin, end = middle(studio.at("part-Wait")), middle(studio.at("arc-start.next"))
    hand.put("touchStart", begin)
    expect(studio.page.locator(".ghost")).to_be_visible()
    hand.move((begin, end))
    expect(studio.page.locator(".arc.is-aimed")).to_have_count(1)
    hand.put("touchEnd")
    studio.expect_code("WAIT(10);")


def a_tap_on_a_part_adds_it(studio: Studio, name: str) -> None:
    studio.at("vertex-start").tap()
    studio.at("room-palette").tap()
    studio.at("part-Wait").tap()
    expect(studio.page.locator(".vertex-name", has_text=name)).to_be_in_viewport()


def a_swipe_over_parts_scrolls_them_and_drags_none(studio: Studio) -> None:
    hand = RobotSession(studio)
    studio.at("part-Wait").scroll_into_view_if_needed()
    before = studio.page.evaluate("document.querySelector('.palette-list').scrollTop")
    x, y = middle(studio.at("part-Wait"))
    hand.put("touchStart", (x, y))
    hand.move(((x, y), (x + 4, y - 160)), steps=8)
    expect(studio.page.locator(".ghost")).to_have_count(0)
    hand.put("touchEnd")
    studio.page.wait_for_function(f"document.querySelector('.palette-list').scrollTop > {before + 60}")
    expect(studio.at("saved-state")).to_have_text("saved")


KEEP = """(canvas) => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
    window.picture = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    done();
})))"""
OTHER = """(canvas) => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
    const found = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    const other = found.filter((one, at) => Math.abs(one - window.picture[at]) > 16).length;
    done(found.length === window.picture.length ? other / found.length : 1);
})))"""
"""How much of the arena's picture is another one than was kept."""
ROUNDED_EDGES = 0.002
"""Pictures of which less is different are the same."""


def spread(at: tuple[float, float], far: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Two fingers so far apart, around a place."""
    return (at[0] - far / 2, at[1]), (at[0] + far / 2, at[1])


def pinch(studio: Studio, at: tuple[float, float], begin: float, end: float) -> None:
    hand = RobotSession(studio)
    a, b = spread(at, begin), spread(at, end)
    # One after the other, as fingers come.
    hand.put("touchStart", a[0])
    hand.put("touchStart", *a)
    hand.move((a[0], b[0]), (a[1], b[1]))
    hand.put("touchEnd")


def two_fingers_zoom_the_arena_as_its_keys_do(studio: Studio) -> None:
    arena = studio.at("arena-canvas")
    arena.focus()
    arena.press("+")
    arena.press("+")
    arena.evaluate(KEEP)
    arena.press("0")
    assert arena.evaluate(OTHER) >= ROUNDED_EDGES
    pinch(studio, middle(arena), 60, 60 * 1.4 * 1.4)
    assert arena.evaluate(OTHER) < ROUNDED_EDGES


def two_fingers_zoom_the_world_and_move_nothing_in_it(studio: Studio) -> None:
    studio.at("tab-of-world").tap()
    studio.at("edit-world").tap()
    stage = middle(studio.at("world-stage"))
    studio.page.touchscreen.tap(*stage)
    studio.at("world-tool-wall").tap()
    pinch(studio, stage, 60, 120)
    expect(studio.page.locator(".world-chosen")).not_to_contain_text("Wall")


def two_fingers_zoom_and_move_even_on_vertices(studio: Studio) -> None:
    hand = RobotSession(studio)
    x, y = middle(studio.page.locator(".vertex", has_text="While").first)
    before = camera(studio)
    hand.put("touchStart", (x - 40, y), (x + 40, y))
    hand.move(((x - 40, y), (x - 80, y)), ((x + 40, y), (x + 80, y)))
    hand.put("touchEnd")
    zoomed = camera(studio)
    assert zoomed[2] == pytest.approx(2 * before[2], rel=0.05)
    a, b = (x - 30, y), (x + 30, y)
    hand.put("touchStart", a, b)
    hand.move((a, (a[0] + 50, a[1] + 120)), (b, (b[0] + 50, b[1] + 120)))
    hand.put("touchEnd")
    moved = camera(studio)
    assert moved[2] == pytest.approx(zoomed[2], rel=0.01)
    assert moved[0] - zoomed[0] == pytest.approx(50, abs=3)
    assert moved[1] - zoomed[1] == pytest.approx(120, abs=3)
    expect(studio.at("saved-state")).to_have_text("saved")
    expect(studio.page.locator(".ghost")).to_have_count(0)


def one_finger_moves_the_canvas(studio: Studio) -> None:
    hand = RobotSession(studio)
    canvas = place_of(studio.at("canvas"))
    begin = (canvas["x"] + 24, canvas["y"] + 40)
    before = camera(studio)
    hand.put("touchStart", begin)
    hand.move((begin, (begin[0] + 60, begin[1] + 90)))
    hand.put("touchEnd")
    after = camera(studio)
    assert after[1] - before[1] > 60


def test_fingers_select_drag_a_part_move_the_canvas_and_open_a_menu_on_a_tablet(
    open_with_fingers: Callable[[ViewportSize], Studio],
) -> None:
    studio = open_with_fingers(TABLET)
    a_tap_selects_and_a_tap_beside_selects_nothing(studio)
    a_part_is_dragged_from_the_palette_onto_an_arc(studio)
    studio.take_back()
    a_swipe_over_parts_scrolls_them_and_drags_none(studio)
    two_fingers_zoom_the_arena_as_its_keys_do(studio)
    one_finger_moves_the_canvas(studio)
    a_finger_that_rests_opens_the_menu_and_an_entry_is_tapped(studio)
    two_fingers_zoom_the_world_and_move_nothing_in_it(studio)


TOO_SMALL = """() => {
    const px = (style, side) => Math.max(0, -parseFloat(style[side]) || 0);
    const reach = (one) => {
        const box = one.getBoundingClientRect();
        let [w, h] = [box.width, box.height];
        for (const pseudo of ['::before', '::after']) {
            const style = getComputedStyle(one, pseudo);
            if (style.content === 'none' || style.position !== 'absolute') continue;
            w = Math.max(w, box.width + px(style, 'left') + px(style, 'right'));
            h = Math.max(h, box.height + px(style, 'top') + px(style, 'bottom'));
        }
        const label = one.closest('label');
        if (label === null) return [w, h];
        const around = label.getBoundingClientRect();
        return [Math.max(w, around.width), Math.max(h, around.height)];
    };
    // The dot of an arc stands for a line, which is pressed anywhere; a text is not pressed but read.
    const others = '.arc-spot, .cm-editor *, .hole, [role=separator]';
    const pressed = 'button, a[href], input, select, textarea, summary, [role=button], [role=treeitem], '
        + '[role^=menuitem], [role=tab], [role=option]';
    return [...document.querySelectorAll(pressed)]
        .filter(one => one.checkVisibility() && !one.matches(others))
        .map(one => [one.dataset.testid ?? one.className, ...reach(one).map(Math.round)])
        .filter(([, w, h]) => w < 44 || h < 44);
}"""
WIDER = "() => document.documentElement.scrollWidth > innerWidth"


def everything_that_is_pressed_is_44_px(studio: Studio, size: ViewportSize) -> None:
    page = studio.page
    assert page.evaluate(TOO_SMALL) == []
    studio.page.locator(".vertex", has_text="While").first.locator(".vertex-name").tap()
    assert page.evaluate(TOO_SMALL) == [], "inspector"
    for menu in ("File", "View"):
        # The first of them is still open when the next one is pressed.
        studio.at(f"menu-{menu}").tap()
        expect(page.get_by_role("menu", name=menu)).to_be_visible()
        assert page.evaluate(TOO_SMALL) == [], menu
    page.keyboard.press("Escape")
    expect(page.get_by_role("menu")).to_have_count(0)
    page.keyboard.press("Control+f")
    expect(studio.at("find-input")).to_be_focused()
    page.keyboard.type("while")
    expect(studio.at("find-hit-1")).to_be_visible()
    assert page.evaluate(TOO_SMALL) == [], "find"
    page.keyboard.press("Escape")
    studio.at("problems").tap()
    assert page.evaluate(TOO_SMALL) == [], "problems"
    if size is PHONE:
        for room in ("palette", "inspector", "code", "arena"):
            studio.at(f"room-{room}").tap()
            assert page.evaluate(TOO_SMALL) == [], room
    studio.at("menu-Help").tap()
    studio.at("menu-help-shortcuts").tap()
    expect(studio.at("shortcuts-dialog")).to_be_visible()
    assert page.evaluate(TOO_SMALL) == [], "shortcuts"
    page.keyboard.press("Escape")
    expect(studio.at("shortcuts-dialog")).to_have_count(0)


CUT_OFF = """() => [...document.querySelectorAll(
    'button, .palette-name, .vertex-name, .side-head h2, .team-stop, .run-button, h2, .narrow-tabs button'
)].filter(one => one.checkVisibility() && getComputedStyle(one).display !== 'inline'
    && !one.matches('.note-strip, .fold') && one.scrollWidth > one.clientWidth + 1)
  .map(one => `${one.className} ${one.textContent}`)"""


def nothing_is_cut_off_and_stop_is_always_there(studio: Studio, size: ViewportSize, language: str) -> None:
    page = studio.page
    if language == "ur":
        studio.at("menu-View").tap()
        expect(page.get_by_role("menu", name="View")).to_be_visible()
        studio.at("menu-view-ur").tap()
        expect(studio.at("run-button")).to_have_text("چلائیں")
    assert page.evaluate(WIDER) is False
    assert page.evaluate(CUT_OFF) == []
    stop = place_of(studio.at("team-stop"))
    assert stop["x"] >= 0
    assert stop["x"] + stop["width"] <= size["width"]
    run = place_of(studio.at("run-button"))
    assert run["x"] + run["width"] <= stop["x"] or stop["x"] + stop["width"] <= run["x"]
    canvas = place_of(studio.at("canvas"))
    assert canvas["width"] >= 380
    if size is PHONE:
        rooms = {
            "palette": ("part-find", ".parts"),
            "code": ("code", ".side-code"),
            "arena": ("arena-canvas", ".side-arena"),
        }
        for room, (shown, inside) in rooms.items():
            studio.at(f"room-{room}").tap()
            expect(studio.at(shown)).to_be_in_viewport()
            expect(studio.at("canvas")).to_be_in_viewport()
            assert page.evaluate(WIDER) is False, room
            find_nothing(studio, room, within=inside)
        expect(studio.at("arena-large")).to_be_in_viewport(ratio=1)
        studio.at("room-arena").tap()
        expect(studio.at("arena-canvas")).not_to_be_visible()


@pytest.mark.thorough("test_fingers_zoom_run_a_mission_and_add_a_part_on_a_phone_where_all_is_large…, in Urdu")
@pytest.mark.parametrize("language", ["ur", "en"])
@pytest.mark.parametrize("size", [PHONE, TABLET], ids=["phone", "tablet"])
def test_nothing_is_cut_off_stop_is_always_there_and_what_is_pressed_is_44_px(
    open_with_fingers: Callable[[ViewportSize], Studio], size: ViewportSize, language: str
) -> None:
    studio = open_with_fingers(size)
    everything_that_is_pressed_is_44_px(studio, size)
    studio.at("problems").tap()
    nothing_is_cut_off_and_stop_is_always_there(studio, size, language)


def a_mission_runs_on_a_phone(studio: Studio) -> None:
    studio.at("run-button").tap()
    expect(studio.page.locator(".vertex.is-active").first).to_be_attached()
    strip = studio.at("event-strip")
    expect(strip).to_be_in_viewport(ratio=1)
    studio.at("pause-button").tap()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    strip.tap(position={"x": 4, "y": 23})
    expect(strip).to_have_attribute("aria-valuenow", "0")
    # Also while something is asked.
    studio.page.keyboard.press("Control+o")
    expect(studio.at("open-dialog")).to_be_visible()
    studio.at("team-stop").tap()
    expect(studio.at("status")).to_contain_text("Stopped")


def test_fingers_zoom_run_a_mission_and_add_a_part_on_a_phone_where_all_is_large_enough_and_in_view(
    open_with_fingers: Callable[[ViewportSize], Studio],
) -> None:
    studio = open_with_fingers(PHONE)
    two_fingers_zoom_and_move_even_on_vertices(studio)
    expect(studio.at("event-strip")).to_be_hidden()
    a_mission_runs_on_a_phone(studio)
    studio.page.reload()
    expect(studio.page.locator(".vertex").first).to_be_visible()
    everything_that_is_pressed_is_44_px(studio, PHONE)
    studio.at("problems").tap()
    nothing_is_cut_off_and_stop_is_always_there(studio, PHONE, "ur")
    a_tap_on_a_part_adds_it(studio, "ٹھہرو")
