"""The arena as a stage: large by one key, with what robots see and where they were, and how the run ended."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.effort import cases
from tests.studio.conftest import WIDTH, Studio
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
WIDTH_OF = "(one) => one.getBoundingClientRect().width"


def test_one_key_makes_the_arena_large_and_shows_the_robot_that_is_watched(open_studio: OpenStudio) -> None:
    studio = open_studio("square/square.krt", first_visit=True)
    small = studio.at("arena-canvas").evaluate(WIDTH_OF)
    studio.at("canvas").focus()
    studio.page.keyboard.press("f")
    expect(studio.page.locator(".studio")).to_have_attribute("data-stage", "true")
    assert studio.at("arena-canvas").evaluate(WIDTH_OF) > 2 * small
    expect(studio.at("stage-watched")).to_contain_text("Press Run")
    expect(studio.at("arena-large")).to_have_attribute("aria-pressed", "true")
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    expect(studio.at("stage-watched")).to_contain_text(re.compile(r"Distance sensor\s*(≥ )?[\d.]+ cm"))
    # What was switched is remembered, and the result can be put away.
    studio.at("show-rays").click()
    expect(studio.at("show-rays")).to_have_attribute("aria-pressed", "false")
    assert '"rays":false' in studio.page.evaluate("localStorage.getItem('kitrobot.arena')")
    expect(studio.at("ending")).to_be_visible()
    studio.at("ending-close").click()
    expect(studio.at("ending")).to_have_count(0)
    studio.at("arena-large").click()
    expect(studio.page.locator(".studio")).to_have_attribute("data-stage", "false")
    # After a run it has more room than before, without the text.
    assert small < studio.at("arena-canvas").evaluate(WIDTH_OF) == pytest.approx(0.4 * WIDTH, rel=0.02)
    studio.at("arena-show").click()
    expect(studio.at("menu-show-rays")).to_have_attribute("aria-checked", "false")


SEEN = """([canvas, red, green, blue]) => {
    const { width, height } = canvas, { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
    const xs = [], ys = [];
    for (let at = 0; at < data.length; at += 4) {
        if (data[at] !== red || data[at + 1] !== green || data[at + 2] !== blue) continue;
        xs.push((at / 4) % width);
        ys.push(Math.floor(at / 4 / width));
    }
    const place = canvas.getBoundingClientRect(), ratio = width / place.width;
    const at = (list, from, end) => from + list.reduce((a, b) => end(a, b)) / ratio;
    const [left, right] = [Math.min, Math.max].map((end) => at(xs, place.left, end));
    const [top, bottom] = [Math.min, Math.max].map((end) => at(ys, place.top, end));
    const corners = [[left, top], [right, top], [left, bottom], [right, bottom]];
    return { width: right - left, height: bottom - top,
        free: corners.every(([x, y]) => document.elementFromPoint(x, y) === canvas),
        inside: left > place.left && right < place.right - 1 && top > place.top && bottom < place.bottom - 1 };
}"""
"""How large what has a colour is on the arena, whether its corners are free, and whether it is all on the screen."""
ORANGE, LID = (0xE0, 0x7A, 0x1F), (0xF7, 0xA1, 0x54)
"""Of the pen, and of the first robot."""


@pytest.mark.parametrize(("width", "height", "least"), cases([(1440, 900, 300)], [(390, 844, 200)]))
def test_what_the_first_program_draws_is_large_and_free_beside_the_card(
    open_studio: OpenStudio, width: int, height: int, least: int
) -> None:
    studio = open_studio("draw-square/draw-square.krt", first_visit=True, viewport={"width": width, "height": height})
    studio.at("menu-Run").click()
    studio.at("menu-run-as-fast").click()
    studio.at("run-button").click()
    expect(studio.at("ending")).to_contain_text("You drew a closed shape.")
    expect(studio.at("ending")).to_contain_text(re.compile(r"4 sides of \d+ cm, 4 corners of 90°"))
    expect(studio.at("ending")).to_have_attribute("data-tone", "plain")
    expect(studio.at("arena-canvas")).to_be_in_viewport(ratio=1)
    # The camera stands where it stays once the card has its size and what was drawn is there.
    studio.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    canvas = studio.at("arena-canvas").element_handle()
    drawing, robot = (studio.page.evaluate(SEEN, [canvas, *colour]) for colour in (ORANGE, LID))
    assert drawing["width"] >= least
    assert drawing["height"] == pytest.approx(drawing["width"], rel=0.05)
    assert drawing["free"]
    assert drawing["inside"]
    assert robot["inside"]
    if width > 900:
        box = place_of(studio.at("arena"))
        assert box["width"] == pytest.approx(0.4 * width, rel=0.02)
        # The text is one press away, and stays with the next run.
        studio.at("arena-text").click()
        expect(studio.at("code")).to_be_visible()
        studio.at("run-button").click()
        studio.wait_until_done()
        expect(studio.at("code")).to_be_visible()


@pytest.mark.thorough(
    "web/src/features/arena/stage/stage.test.ts; web/src/session/run.test.ts: a run can be gone back in"
)
def test_a_run_that_failed_leads_to_its_cause(open_studio: OpenStudio) -> None:
    studio = open_studio("transport/transport.krt", first_visit=True)
    studio.at("run-button").click()
    expect(studio.at("status")).to_have_attribute("data-status", "running")
    studio.at("pause-button").click()
    studio.at("arena-canvas").focus()
    studio.page.keyboard.press("n")
    studio.page.keyboard.press("Enter")
    studio.at("menu-harm-fail").click()
    expect(studio.at("event-strip").locator('[data-kind="failure"]')).to_have_count(1)
    studio.full_speed()
    studio.at("pause-button").click()
    studio.at("go-to-cause").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused")
    expect(studio.at("ending")).to_have_count(0)
    expect(studio.at("arena-summary")).to_contain_text("failed")


@pytest.mark.thorough("tests/studio/test_clipping.py, the screen stage on 390 px; test_one_key_makes_the_arena_large…")
def test_on_a_phone_the_stage_is_all_there_is_and_a_room_ends_it(open_studio: OpenStudio) -> None:
    studio = open_studio("square/square.krt", first_visit=True, viewport={"width": 390, "height": 844})
    studio.at("room-arena").click()
    # The graph above it is small: tools over it would cover the end of a row. They are back with its place.
    expect(studio.page.locator(".zoom")).to_be_hidden()
    studio.at("arena-large").click()
    expect(studio.page.locator(".studio")).to_have_attribute("data-stage", "true")
    box = place_of(studio.at("arena"))
    assert box["width"] == 390
    assert box["height"] > 400
    studio.at("room-code").click()
    expect(studio.at("canvas")).to_be_visible()
    studio.at("room-code").click()
    expect(studio.page.locator(".zoom")).to_be_visible()
