"""How many actions the tasks of a first hour take by mouse, keys and fingers, as `docs/first-hour.md` says."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Locator, expect

from tests.effort import cases
from tests.studio.conftest import Studio
from tests.studio.studio_page import place_of
from tests.studio.test_stage import SEEN

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
PAGE = Path(__file__).parents[2] / "docs" / "first-hour.md"
INK = (0x1B, 0x1F, 0x27)
"""Of a pen whose colour nobody chose, in the light theme."""
DEVICES: dict[str, dict[str, object]] = {
    "mouse": {"viewport": {"width": 1440, "height": 900}},
    "keys": {"viewport": {"width": 1440, "height": 900}},
    "touch": {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True},
}
LEAST = {"mouse": 300, "touch": 200}
"""The least width of the square that was drawn, in px."""
HIDDEN = """(part) => {
    const [box, list] = [part.getBoundingClientRect(), part.closest('.palette-list').getBoundingClientRect()];
    return box.top < list.top - 1 || box.bottom > list.bottom + 1;
}"""
TAB_OF = "(part) => part.closest('.palette-section').id.replace('parts-of-', '')"


def documented() -> dict[str, dict[str, int | None]]:
    """The counts of the table, by task and device; None where a task is not counted."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in PAGE.read_text("utf-8").splitlines()]
    number = re.compile(r"\d+")
    return {
        row[0]: {
            device: int(found[0]) if (found := number.match(cell)) else None
            for device, cell in zip(DEVICES, row[1:], strict=False)
        }
        for row in rows
        if len(row) == 5 and row[0] not in {"Task", "---"}
    }


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


class Doer(Hands):
    """Does a task with one device, and counts each click, drag, tap and key; turning to a tab of parts is one."""

    def __init__(self, studio: Studio, device: str) -> None:
        super().__init__(studio)
        self.device = device

    def press(self, at: Locator | str) -> None:
        if self.device == "touch":
            self.tap(at)
        else:
            self.click(at)

    def add(self, part: str, target: Locator | str, letters: str) -> None:
        """Puts a part there: dragged, tapped onto what is selected, or found by its first letters."""
        if self.device == "keys":
            self.keys("/", *letters, "Enter")
            return
        row = self.studio.at(f"part-{part}")
        if row.evaluate(HIDDEN):
            self.press(f"palette-tab-{row.evaluate(TAB_OF)}")
        if self.device == "touch":
            self.tap(row)
        else:
            self.drop(part, target)

    def begin_nothing(self, robot: str = "mini-robot") -> None:
        """From the sheet of an empty folder to a program without parts."""
        studio = self.studio
        if self.device == "keys":
            expect(studio.at("new-robots-mini-robot")).to_be_focused()
            self.keys("Tab", "Tab", "ArrowUp", "Enter")
        else:
            if robot != "mini-robot":
                self.press(studio.page.locator("label", has=studio.at(f"new-robots-{robot}")))
            self.press(studio.page.locator("label", has=studio.at("new-starter-nothing")))
            self.press("new-begin")
        studio.expect_opened()

    def begin_with(self, part: str, letters: str) -> None:
        """The first part: one of those that an empty program offers; a phone shows the list of parts then."""
        if self.device == "keys":
            self.add(part, "", letters)
        else:
            self.press(f"first-{part}")

    def after_selected(self) -> str:
        """The arc behind the part that was added last."""
        found = self.studio.page.locator(".vertex.is-selected").get_attribute("data-testid") or ""
        return f"arc-{found.removeprefix('vertex-')}.next"

    def run(self) -> None:
        if self.device == "keys":
            self.keys("F5")
        else:
            self.press("run-button")


def in_body(doer: Doer) -> Locator:
    return doer.studio.page.locator('.first-place[data-testid$=".body"]')


def drive_a_square(doer: Doer) -> None:
    doer.begin_nothing()
    if doer.device == "keys":
        doer.add("Pen.PenDown", "", "pe")
    doer.begin_with("Repetition", "re")
    doer.add("Wheel.DriveBy", in_body(doer), "dr")
    doer.add("Motor.LeftBy", doer.after_selected(), "lef")
    doer.studio.expect_code("10*(  Wheel.DriveBy(30);  Motor.LeftBy(90);")
    if doer.device == "mouse":
        doer.add("Pen.PenDown", "arc-start.next", "")
    elif doer.device == "touch":
        # Behind the turn: the first side is drawn in the second round.
        doer.add("Pen.PenDown", "", "")
    doer.run()


def turn_at_walls(doer: Doer) -> None:
    doer.begin_nothing()
    doer.begin_with("Forever", "fore")
    doer.add("Wheel.Advance", in_body(doer), "keep d")
    driving = doer.after_selected()
    if doer.device == "mouse":
        doer.add("Motor.RightBy", driving, "")
        doer.add("Captor.LessThan", driving, "")
    else:
        doer.add("Captor.LessThan", "", "near")
        doer.add("Motor.RightBy", "", "right")
    expect(doer.studio.at("code")).to_contain_text(
        re.compile(r"\*\(\s*Wheel\.Advance\(50\);\s*<Captor\.LessThan\(50\)>.*Motor\.RightBy\(90\)")
    )
    doer.run()


def play_a_tune(doer: Doer) -> None:
    doer.begin_nothing("microbit")
    doer.begin_with("Music.Play", "")
    doer.studio.expect_code("Music.Play(")
    doer.run()


def make_a_world(doer: Doer) -> None:
    """A wall, a ball and a second robot, from a program that is open."""
    studio = doer.studio
    begun = doer.made
    doer.begin_nothing()
    doer.made = begun
    stage = studio.at("world-stage")
    for kind, (x, y) in {"wall": (0.3, 0.4), "ball": (0.6, 0.4), "start": (0.6, 0.7)}.items():
        doer.press(f"arena-add-{kind}" if kind == "wall" else f"world-tool-{kind}")
        expect(studio.at("edit-world")).to_have_count(0)
        box = place_of(stage)
        doer.made += 1
        place = {"x": x * box["width"], "y": y * box["height"]}
        stage.click(position=place)  # type: ignore[arg-type]
    expect(studio.at("world-chosen")).to_be_visible()


TASKS: dict[str, Callable[[Doer], None]] = {
    "A square from nothing": drive_a_square,
    "Turn at every wall, for ever": turn_at_walls,
    "A tune on the micro:bit": play_a_tune,
    "A wall, a ball and a robot": make_a_world,
}
SQUARE, WALLS, TUNE, WORLD = TASKS
USUAL: list[object] = [(SQUARE, "mouse"), (SQUARE, "touch")]
"""With keys: from nothing in `test_new_mission.py` and `test_keys.py`."""
MORE: list[object] = [(SQUARE, "keys"), *((WALLS, device) for device in DEVICES)]
MORE += [(TUNE, "touch"), (TUNE, "mouse"), (WORLD, "mouse")]


def the_square_is_large_at_the_end(studio: Studio, least: int) -> None:
    studio.at("menu-Run").click()
    studio.at("menu-run-as-fast").click()
    studio.wait_until_done()
    expect(studio.at("ending")).to_be_visible()
    studio.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    drawing = studio.page.evaluate(SEEN, [studio.at("arena-canvas").element_handle(), *INK])
    assert drawing["width"] >= least
    assert drawing["inside"]
    assert drawing["height"] == pytest.approx(drawing["width"], rel=0.2)


def a_robot_without_music_says_which_one_has_it(studio: Studio) -> None:
    studio.at("part-find").fill("music")
    expect(studio.at("parts-none")).to_contain_text("micro:bit can do it")


@pytest.mark.parametrize(("task", "device"), cases(USUAL, MORE))
def test_a_task_takes_as_many_actions_as_the_table_says(open_studio: OpenStudio, task: str, device: str) -> None:
    studio = open_studio(None, first_visit=True, pictures=True, **DEVICES[device])
    expect(studio.at("new-starter-draw-square/draw-square.krt")).to_be_checked()
    doer = Doer(studio, device)
    TASKS[task](doer)
    assert doer.made == documented()[task][device]
    if task == SQUARE and device in LEAST:
        the_square_is_large_at_the_end(studio, LEAST[device])
    if task == SQUARE and device == "mouse":
        a_robot_without_music_says_which_one_has_it(studio)
