"""Of every text on the screens of the studio: nothing is cut off, none lies over another.

Each screen on one size, wide and narrow by turns; in the thorough profile on all sizes, in all languages and themes.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.effort import THOROUGH, cases
from tests.studio.clipping import amiss
from tests.studio.conftest import Studio
from tests.studio.test_reach import choose
from tests.studio.test_widths import SETTLED

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
TRANSPORT = "transport/transport.krt"
SIZES = [(1440, 900), (390, 844), (1024, 768), (768, 1024)]
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

SCREENS: list[tuple[str, tuple[str, ...], str]] = [
    ("a mission", (), "canvas"),
    ("new mission", ("menu-File", "menu-file-new"), "new-name"),
    ("open", ("menu-File", "menu-file-open"), "open-dialog"),
    ("save as", ("menu-File", "menu-file-save-as"), "save-dialog"),
    ("keys", ("menu-Help", "menu-help-shortcuts"), "shortcuts-dialog"),
    ("about", ("menu-Help", "menu-help-about"), "about-dialog"),
    ("outline", ("menu-View", "menu-view-outline"), "outline"),
    ("problems", ("problems",), "problems"),
    ("check", ("menu-Run", "menu-run-check"), "check"),
    ("sweep", ("menu-Run", "menu-run-sweep"), "sweep"),
    ("robots", ("menu-Robots", "menu-robots-panel"), "robots"),
    ("team", ("menu-Program", "menu-program-team"), "team"),
    ("world", ("menu-Program", "menu-program-world"), "world"),
    ("stage", ("tab-carrier", "menu-View", "menu-view-stage"), "stage-watched"),
    ("paused", ("run-button", "pause-button"), "status"),
]
"""The name of each screen, what is pressed one after the other for it, and what is seen then."""


@pytest.mark.parametrize("look", cases(LOOKS[:1], LOOKS[1:]), ids=str)
def test_no_text_of_any_screen_is_cut_off_or_lies_over_another(open_studio: OpenStudio, look: tuple[str, ...]) -> None:
    studio = open_studio(TRANSPORT)
    page = studio.page
    choose(studio, *look)
    found = []
    for turn, (screen, presses, seen) in enumerate(SCREENS):
        for press in presses:
            studio.at(press).click()
        expect(studio.at(seen).first).to_be_visible()
        for width, height in SIZES if THOROUGH else SIZES[turn % 2 : turn % 2 + 1]:
            page.set_viewport_size({"width": width, "height": height})
            page.evaluate(SETTLED)
            found += [f"{screen}, {width} px: {one}" for one in amiss(page)]
        page.set_viewport_size({"width": 1440, "height": 900})
        page.keyboard.press("Escape")
    assert "\n".join(found) == ""


def test_what_is_cut_off_or_lies_over_another_is_found(open_studio: OpenStudio) -> None:
    page = open_studio(TRANSPORT).page
    page.set_content(
        """<style>p { position: absolute; margin: 0; font: 16px sans-serif; white-space: nowrap }</style>
        <p style="left: 10px; top: 10px">one</p> <p style="left: 20px; top: 14px">other</p>
        <p style="left: 10px; top: 60px; width: 40px; overflow: hidden">much too long</p>
        <p style="left: 10px; top: 90px; width: 40px; overflow: hidden; text-overflow: ellipsis">long, and told</p>
        <p style="left: 10px; top: 120px; width: 40px; overflow: auto">long, and scrolls</p>
        <p style="left: -30px; top: 150px">outside</p>
        <p style="left: 10px; top: 180px">under</p> <p style="left: 10px; top: 180px; background: white">above it</p>"""
    )
    assert amiss(page) == [
        '"much too long" in  is cut off',
        '"outside" in  is out of the window',
        '"one" and "other" in  lie over each other',
    ]
