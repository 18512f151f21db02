"""The pictures in the documents come from the running product: `make pictures` keeps what these tests take.

Without KITROBOT_PICTURES, and only in the thorough profile, the pictures go to a temporary folder: each scene can be
reached.
"""

from __future__ import annotations

import io
import os
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from PIL import Image
from playwright.sync_api import Browser, Page, expect

from tests.studio.conftest import Studio
from tests.studio.studio_page import place_of
from tests.studio.test_class import SQUARE, Class, add_part, expect_kept

TAKEN = os.environ.get("KITROBOT_PICTURES", "") != ""
pytestmark = [
    pytest.mark.browser,
    *([] if TAKEN else [pytest.mark.thorough("tests/studio/test_canvas.py, test_first_minutes.py")]),
]

OpenStudio = Callable[..., Studio]

SECONDS, TICKS_A_SECOND = 36, 50
"""How much of the run the moving picture shows, a frame a second, before its end."""


@pytest.fixture
def pictures(tmp_path: Path) -> Path:
    """Where pictures go."""
    if TAKEN:
        return Path(__file__).resolve().parents[2] / "docs" / "pictures"
    return tmp_path


def take(page: Page, path: Path) -> None:
    """Takes the whole window, when nothing moves any more."""
    path.parent.mkdir(parents=True, exist_ok=True)
    page.mouse.move(800, 990)
    page.screenshot(path=path, animations="disabled")
    assert path.stat().st_size > 20_000


def run_to_the_end(studio: Studio) -> None:
    """Runs the mission at full speed until it is done."""
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()


def frame(studio: Studio) -> Image.Image:
    """The window as a frame of the moving picture."""
    taken = Image.open(io.BytesIO(studio.page.screenshot(animations="disabled")))
    return taken.convert("RGB").resize((960, 600), Image.Resampling.LANCZOS)


def test_the_first_run_as_a_moving_picture(open_studio: OpenStudio, pictures: Path) -> None:
    """Its frames are moments of a run that has ended, so a slow machine takes the same picture."""
    studio = open_studio("transport/transport.krt", viewport={"width": 1440, "height": 900})
    frames = [frame(studio)]
    run_to_the_end(studio)
    done = frame(studio)
    strip, status = studio.at("event-strip"), studio.at("status")
    strip.press("Home")
    expect(status).to_contain_text("Paused")
    for tick in range(0, SECONDS * TICKS_A_SECOND, TICKS_A_SECOND):
        strip.press("PageUp")
        expect(strip).to_have_attribute("aria-valuenow", str(tick + TICKS_A_SECOND))
        strip.evaluate("strip => strip.blur()")
        frames.append(frame(studio))
    path = pictures / "first-run.webp"
    durations = [1200, *[120] * (len(frames) - 1), 2500]
    frames[0].save(path, save_all=True, append_images=[*frames[1:], done], duration=durations, quality=50, loop=0)
    assert 100_000 < path.stat().st_size < 1_000_000


def test_the_studio_in_the_middle_of_the_transport(open_studio: OpenStudio, pictures: Path) -> None:
    studio = open_studio("transport/transport.krt")
    run_to_the_end(studio)
    # Back to the middle: who pauses a run on the way may come too late.
    strip = studio.at("event-strip")
    handle, box = place_of(studio.at("strip-handle")), place_of(strip)
    studio.page.mouse.move(handle["x"] + handle["width"] / 2, handle["y"] + handle["height"] / 2)
    studio.page.mouse.down()
    studio.page.mouse.move((box["x"] + handle["x"]) / 2, handle["y"] + 6, steps=8)
    studio.page.mouse.up()
    expect(studio.at("status")).to_contain_text("Paused")
    expect(studio.at("arena-summary")).to_contain_text(re.compile("[3-9] of 12 delivered"))
    studio.page.locator(".vertex", has_text="Wheels Drive").first.click()
    expect(studio.at("inspector")).to_contain_text("speed")
    take(studio.page, pictures / "studio.png")


def test_the_first_steps_of_a_pupil(open_studio: OpenStudio, pictures: Path) -> None:
    studio = open_studio("transport/transport.krt")
    studio.at("menu-Help").click()
    studio.at("menu-help-tutorial-example:tutorials/first-steps/first-steps.tutorial.xml").click()
    expect(studio.at("tutorial")).to_have_attribute("data-step", "1")
    expect(studio.at("arena-summary")).to_be_visible()
    take(studio.page, pictures / "first-steps.png")


def test_the_teachers_page_of_a_class(browser: Browser, tmp_path: Path, pictures: Path) -> None:
    school = Class(browser, tmp_path / "Class 5b", tmp_path / "state")
    try:
        teacher = school.page(school.teacher)
        teacher.get_by_test_id("change-exercise").click()
        teacher.locator(f"[data-path='{SQUARE}']").click()
        for name, parts in {"Ada": ("drive", "wait", "stop"), "Bilal": ("drive",), "Chloé": ("turn by",)}.items():
            pupil = school.join(name)
            expect(pupil.get_by_test_id("exercise")).to_be_visible()
            for part in parts:
                add_part(pupil, part)
            expect_kept(pupil)
            nodes = teacher.get_by_test_id(f"card-{name}").locator(".class-picture .picture-node")
            expect(nodes).to_have_count(len(parts))
        pupil.get_by_test_id("class-hand").click()
        expect(teacher.get_by_test_id("card-Chloé")).to_have_attribute("data-state", "asks")
        teacher.set_viewport_size({"width": 1200, "height": 540})
        take(teacher, pictures / "class.png")
    finally:
        school.close()
    assert school.faults == []
