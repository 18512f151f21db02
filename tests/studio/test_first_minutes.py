"""How many clicks, keys or taps lead from nothing to a square that is driven and drawn, with no help read."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, expect

from tests.effort import cases
from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]

SQUARE = "Pen.PenDown();10*(  Wheel.DriveBy(30);  Motor.LeftBy(90););"


class Hands:
    """Does what a user does, and counts it: a click, a tap, a drag, a key are one each."""

    def __init__(self, studio: Studio) -> None:
        self.studio = studio
        self.made = 0

    def click(self, at: Locator | str) -> None:
        self.made += 1
        self._at(at).click()

    def tap(self, at: Locator | str) -> None:
        self.made += 1
        self._at(at).tap()

    def drop(self, part: str, target: Locator | str) -> None:
        self.made += 1
        self.studio.drag(self.studio.at(f"part-{part}"), self._at(target))

    def keys(self, *keys: str) -> None:
        for key in keys:
            self.made += 1
            self.studio.page.keyboard.press(key)

    def _at(self, at: Locator | str) -> Locator:
        return self.studio.at(at) if isinstance(at, str) else at


def new_sheet(open_studio: OpenStudio, **device: object) -> Studio:
    """An empty folder, with the sheet that it begins with."""
    studio = open_studio(None, **device)
    studio.page.reload()
    expect(studio.at("new-starter-draw-square/draw-square.krt")).to_be_checked()
    if not device:
        expect(studio.at("new-robots-mini-robot")).to_be_focused()
    return studio


def expect_square(studio: Studio) -> None:
    """The program is there and is run to its end, and what its pen left is as high as it is wide."""
    studio.expect_code(SQUARE)
    # The slider has no room on a phone.
    studio.at("menu-Run").click()
    studio.at("menu-run-as-fast").click()
    studio.wait_until_done()
    studio.at("arena-show").click()
    with studio.page.expect_download() as drawing:
        studio.at("menu-drawing").click()
    lines = re.findall(r'<path d="([^"]+)"', drawing.value.path().read_text(encoding="utf-8"))
    numbers = [float(number) for number in re.findall(r"[\d.]+", " ".join(lines))]
    width, height = (max(axis) - min(axis) for axis in (numbers[::2], numbers[1::2]))
    assert width > 100
    assert height == pytest.approx(width, rel=0.2)


def test_seven_clicks_and_drags_are_enough(open_studio: OpenStudio) -> None:
    studio = new_sheet(open_studio)
    hands = Hands(studio)
    hands.click(studio.page.locator("label", has=studio.at("new-starter-nothing")))
    hands.click("new-begin")
    studio.expect_opened()
    hands.drop("Repetition", "first-place")
    hands.drop("Pen.PenDown", "arc-start.next")
    hands.drop("Wheel.DriveBy", studio.page.locator('.first-place[data-testid$=".body"]'))
    drive = studio.page.locator(".vertex.is-selected").get_attribute("data-testid") or ""
    hands.drop("Motor.LeftBy", f"arc-{drive.removeprefix('vertex-')}.next")
    hands.click("run-button")
    expect_square(studio)
    assert hands.made <= 7


def test_twenty_two_keys_are_enough(open_studio: OpenStudio) -> None:
    studio = new_sheet(open_studio)
    hands = Hands(studio)
    hands.keys("Tab", "Tab", "ArrowUp", "Enter")
    studio.expect_opened()
    for letters in ("pe", "re", "dr", "lef"):
        hands.keys("/", *letters, "Enter")
    hands.keys("F5")
    expect_square(studio)
    assert hands.made <= 22


def test_eight_taps_on_a_phone_are_enough(open_studio: OpenStudio) -> None:
    studio = new_sheet(open_studio, viewport={"width": 390, "height": 800}, has_touch=True, is_mobile=True)
    hands = Hands(studio)
    hands.tap(studio.page.locator("label", has=studio.at("new-starter-nothing")))
    hands.tap("new-begin")
    studio.expect_opened()
    hands.tap("room-palette")
    for part in ("Pen.PenDown", "Repetition", "Wheel.DriveBy", "Motor.LeftBy"):
        hands.tap(f"part-{part}")
    hands.tap("run-button")
    expect_square(studio)
    assert hands.made <= 8


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
