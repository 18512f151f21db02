"""Each screen of the studio, visited once: no text is cut off, covered or over another, and axe finds nothing.

Each screen on one size, wide or a phone's; in the thorough profile on all sizes, in all languages and themes.
Axe looks at what the screen brought; `test_screens.py` and `test_reach.py` look at more in the thorough profile.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import BrowserContext, Position, expect

from tests.effort import THOROUGH, cases
from tests.studio.clipping import amiss
from tests.studio.conftest import Studio, begin_new
from tests.studio.looks import choose, find_nothing
from tests.studio.test_screens import who_wants_less_motion_gets_none_anywhere
from tests.studio.test_widths import SETTLED

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
TRANSPORT, DRAWING = "transport/transport.krt", "draw-square/draw-square.krt"
CORNER = Position(x=12, y=12)
PHONE = (390, 844)
SIZES = [(1440, 900), PHONE, (1024, 768), (768, 1024)]
ON_A_PHONE = {
    *("new mission", "open", "keys", "help", "check", "team", "templates", "paused"),
    *("a field", "a note", "done", "nothing yet", "the path to learn", "a tutorial"),
}
"""What is looked at on a phone, and not on a wide screen; in the thorough profile everything on each size."""
# Words of the other languages are longer than English ones.
LOOKS: list[object] = [
    ("dark", "fr"),
    ("light", "en"),
    ("dark", "en"),
    ("contrast", "ur"),
    ("light", "fr"),
    ("dark", "ur"),
    ("contrast", "fr"),
]

Screen = tuple[str, tuple[str | Callable[[Studio], None], ...], str, str | None]
ALL, CANVAS, DIALOG, MENU = "", ".canvas-room", "dialog[open]", "[role=menu]"
ELSEWHERE = None
"""Another journey looks there with axe: test_many_runs.py, test_team.py, test_world.py, or the gallery below."""


def find_hits(studio: Studio) -> None:
    studio.at("find-input").fill("a")
    expect(studio.at("find-hit-1")).to_be_visible()


def force_a_sensor(studio: Studio) -> None:
    box = studio.at("watch-Sign").get_by_role("textbox")
    box.fill("1")
    box.press("Enter")
    expect(studio.at("watch-Sign")).to_have_attribute("data-forced", "true")


def mistake_in_the_text(studio: Studio) -> None:
    studio.edit_code()
    studio.page.keyboard.press("Control+End")
    studio.page.keyboard.insert_text("\nWheel.?!")


SCREENS: list[Screen] = [
    ("a mission", (), "canvas", ALL),
    ("a menu", ("menu-Edit",), "menu-edit-find", MENU),
    ("new mission", ("menu-File", "menu-file-new"), "new-name", "[data-testid=new-mission]"),
    ("open", ("menu-File", "menu-file-open"), "open-dialog", ELSEWHERE),
    ("save as", ("menu-File", "menu-file-save-as"), "save-dialog", DIALOG),
    ("pdf", ("menu-File", "menu-file-export-pdf"), "pdf-dialog", DIALOG),
    ("keys", ("menu-Help", "menu-help-shortcuts"), "shortcuts-dialog", DIALOG),
    ("about", ("menu-Help", "menu-help-about"), "about-dialog", DIALOG),
    ("outline", ("menu-View", "menu-view-outline"), "outline", "[data-testid=outline]"),
    ("help", ("menu-View", "menu-view-outline", "key ArrowDown", "key F1"), "part-help", "[data-testid=part-help]"),
    ("problems", ("problems",), "problems", ".bottom-bar"),
    ("check", ("menu-Run", "menu-run-check"), "check", ELSEWHERE),
    ("sweep", ("menu-Run", "menu-run-sweep"), "sweep", ELSEWHERE),
    ("robots", ("menu-Robots", "menu-robots-panel"), "robots", "[data-testid=robots]"),
    ("team", ("menu-Robots", "menu-robots-panel", "menu-Program", "menu-program-team"), "team", ELSEWHERE),
    ("world", ("menu-Program", "menu-program-world"), "world", "[data-testid=world]"),
    ("world, edited", ("edit-world",), "world-tool-wall", ELSEWHERE),
    ("templates", ("world-templates-open",), "template-maze", "[data-testid=world]"),
    ("stage", ("undo", "tab-carrier", "menu-View", "menu-view-stage"), "stage-watched", ".side-arena"),
    ("paused", ("arena-large", "run-button", "pause-button"), "palette-robot", ".head"),
    ("watch", ("watch-button", force_a_sensor), "watch", "[data-testid=watch]"),
    ("a breakpoint", ("vertex-v15", "key b"), "breakpoint-when", ".side-inspector"),
    ("a part of one's own", ("vertex-v11", "key p"), "own-dialog", DIALOG),
]
"""The name of each screen, what is pressed one after the other for it, what is seen then, and where axe looks."""


def open_gallery_at(section: int) -> Callable[[Studio], None]:
    def scroll(studio: Studio) -> None:
        studio.page.keyboard.press("Control+o")
        studio.at("open-dialog").locator(".open-jumps button").nth(section).click()

    return scroll


def ask_for_new(studio: Studio) -> None:
    studio.at("menu-File").click()
    studio.at("menu-file-new").click()
    begin_new(studio.page)


def go_on_without_saving(studio: Studio) -> None:
    ask_for_new(studio)
    studio.at("banner").get_by_role("button").nth(1).click()


TUTORIAL = "menu-help-tutorial-example:tutorials/first-steps/first-steps.tutorial.xml"
EXERCISE = "exercise-card-example:exercises/03-square.exercise.xml"
FIRST_HOUR: list[Screen] = [
    ("a first program", (), "canvas", ALL),
    ("a field", ("vertex-v4", "key 7"), "in-place", CANVAS),
    ("a menu of a part", ("vertex-v4", "key Shift+F10"), "context-menu", MENU),
    ("a note", ("vertex-v4", "key n"), "note-field", CANVAS),
    ("find", ("key Control+f", find_hits), "find-input", CANVAS),
    ("done", (Studio.full_speed, "run-button"), "ending", "[data-testid=ending]"),
    ("a mistake", (mistake_in_the_text,), "code-state", ".side-code"),
    ("a question", ("vertex-v5", "key Delete", ask_for_new), "banner", "[data-testid=banner]"),
    ("nothing yet", (go_on_without_saving,), "first-place", CANVAS),
    ("a part is added", ("vertex-start", "key /"), "add-find", CANVAS),
    ("gallery", (open_gallery_at(1),), "gallery-count", DIALOG),
    ("the path to learn", ("key Alt+l",), "learn-count", DIALOG),
    ("an exercise", ("key Alt+l", EXERCISE), "exercise", "[data-testid=exercise]"),
    ("a tutorial", ("exercise-leave", "menu-Help", TUTORIAL), "tutorial", "[data-testid=tutorial]"),
]
"""The same of what somebody meets first, on a mission that draws."""


@pytest.mark.parametrize("look", cases(LOOKS[:1], LOOKS[1:]), ids=str)
@pytest.mark.parametrize(
    ("mission", "screens"), [(TRANSPORT, SCREENS), (DRAWING, FIRST_HOUR)], ids=["screens", "first hour"]
)
def test_no_text_of_any_screen_is_cut_off_covered_or_over_another_and_axe_finds_nothing(
    open_studio: OpenStudio, look: tuple[str, ...], mission: str, screens: list[Screen]
) -> None:
    studio = open_studio(mission)
    page = studio.page
    who_wants_less_motion_gets_none_anywhere(studio)
    choose(studio, *look)
    found = []
    for screen, presses, seen, new in screens:
        for press in presses:
            if callable(press):
                press(studio)
            elif press.startswith("key "):
                page.keyboard.press(press.removeprefix("key "))
            else:
                studio.at(press).first.click(position=CORNER if press.startswith("vertex-") else None)
        expect(studio.at(seen).first).to_be_visible()
        for width, height in SIZES if THOROUGH else [PHONE if screen in ON_A_PHONE else SIZES[0]]:
            page.set_viewport_size({"width": width, "height": height})
            page.evaluate(SETTLED)
            found += [f"{screen}, {width} px: {one}" for one in amiss(page)]
        page.set_viewport_size({"width": 1440, "height": 900})
        if new is not None:
            find_nothing(studio, screen, within=new)
        page.keyboard.press("Escape")
    assert "\n".join(found) == ""


def test_what_is_cut_off_or_lies_over_another_is_found(context: BrowserContext) -> None:
    page = context.new_page()
    page.set_content(
        """<style>p { position: absolute; margin: 0; font: 16px sans-serif; white-space: nowrap }</style>
        <p style="left: 10px; top: 10px">one</p> <p style="left: 20px; top: 14px">other</p>
        <p style="left: 10px; top: 60px; width: 40px; overflow: hidden">much too long</p>
        <p style="left: 10px; top: 90px; width: 40px; overflow: hidden; text-overflow: ellipsis">long, and told</p>
        <p style="left: 10px; top: 120px; width: 40px; overflow: auto">long, and scrolls</p>
        <p style="left: -30px; top: 150px">outside</p>
        <p style="left: 10px; top: 180px">under it</p> <p style="left: 30px; top: 180px; background: white">above</p>
        <div style="position: absolute; left: 10px; top: 210px; height: 40px; overflow: auto">
        <p style="position: static">scrolls under it</p> <br> <br> <br> </div>
        <p style="left: 10px; top: 210px; background: white">a bar</p>
        <p style="left: 10px; top: 270px">asked</p>
        <p role="dialog" style="left: 10px; top: 270px; background: white">?!</p>"""
    )
    assert amiss(page) == [
        '"much too long" in  is cut off',
        '"outside" in  is out of the window',
        '"under it" in  is covered by ',
        '"one" and "other" in  lie over each other',
    ]
