"""Check: a property is written with completion; what is broken opens its run, which is played up to its moment."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import expect

from kitrobot.server.routes import drawing_check as drawing_check_socket
from tests.patience import PATIENCE_S
from tests.studio.looks import find_nothing
from tests.studio.studio_page import HEIGHT, WIDTH
from tests.verifier.check_fixtures import EXAMPLES
from tests.workspace.test_drawing_check import WAIT

pytestmark = pytest.mark.browser

HOLD_FRAMES = """() => {
    window.heldFrames = [];
    window.soonFrame = window.requestAnimationFrame;
    window.requestAnimationFrame = (draw) => window.heldFrames.push(draw);
}"""
LET_FRAMES_GO = """() => {
    window.requestAnimationFrame = window.soonFrame;
    for (const draw of window.heldFrames) draw(performance.now());
}"""


def greedy_text() -> str:
    """A mission whose loader reaches for boxes that are not there."""
    text = (EXAMPLES / "passing-loop" / "passing-loop.krt").read_text(encoding="utf-8")
    loops = '<vertex id="v1" element="Repetition"><set name="count">3</set>'
    assert loops in text
    return text.replace(loops, loops.replace(">3<", ">9<"))


@pytest.fixture
def greedy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, open_studio) -> str:
    """That mission as an example of its own."""
    path = tmp_path / "made" / "greedy" / "greedy.krt"
    path.parent.mkdir(parents=True)
    path.write_text(greedy_text(), encoding="utf-8")
    monkeypatch.setitem(open_studio.__globals__, "EXAMPLES", tmp_path / "made")
    return "greedy/greedy.krt"


@pytest.mark.thorough(
    "web/src/features/check/CheckPanel.test.tsx: a property is written, a check stopped, answers walked and played;"
    " BrokenRun.test.tsx: why; BothWays.test.tsx: both ways; server/test_verification_socket.py; with a server: "
    "test_many_runs.py"
)
def test_a_property_is_written_and_what_is_broken_is_told_and_played_and_a_check_can_be_stopped(
    open_studio, greedy: str
) -> None:
    studio = open_studio(greedy)
    keys = studio.page.keyboard
    keys.press("Alt+c")
    studio.at("property-add-never").click()
    field = studio.at("property-first-0")
    field.focus()
    # What is drawn late moves no caret: the frames that taking a completion asks for come between two letters.
    studio.page.evaluate(HOLD_FRAMES)
    keys.press("Enter")
    expect(field).to_have_value("any ")
    keys.type("car")
    studio.page.evaluate(LET_FRAMES_GO)
    keys.type("rier-1")
    keys.press("Enter")
    keys.type("Cargo.IsPr")
    keys.press("Enter")
    expect(field).to_have_value("any carrier-1 (Cargo.IsPressed()")
    studio.at("property-name-0").fill("empty")
    expect(studio.at("property-wrong")).to_be_visible(timeout=1000 * PATIENCE_S)
    field.fill("any carrier-1 (Cargo.IsPressed())")
    field.blur()
    expect(studio.at("property-wrong")).to_have_count(0, timeout=1000 * PATIENCE_S)
    expect(studio.at("check-kinds")).to_have_count(0)
    studio.at("check-failures").select_option("1")
    studio.at("check-kinds").select_option("mute")
    # A quarter of the time is for looking in the simulator: a busy machine needs more than usual.
    studio.at("check-seconds").select_option("1800")
    studio.at("check-begin").click()
    expect(studio.at("check-verdict").or_(studio.at("answer-deadlock-lockstep-0")).first).to_be_visible(
        timeout=1000 * PATIENCE_S
    )
    expect(studio.page.get_by_text("1 failure: loses its radio").first).to_be_visible()
    broken = studio.at("answer-empty-storehouse-lockstep-0")
    # Told a while after the model has broken it: a run of the simulator is searched first.
    for answer in (broken, studio.at("answer-empty-lockstep-0")):
        expect(answer).to_have_attribute("data-shape", "broken", timeout=1000 * PATIENCE_S)
    expect(studio.at("answer-empty-swing-lockstep-0")).to_have_attribute("data-shape", "holds")
    studio.at("check-stop").click()
    expect(studio.at("check-begin")).to_be_visible(timeout=1000 * PATIENCE_S)
    broken.focus()
    for key in ("ArrowDown", "ArrowRight", "ArrowLeft", "ArrowUp"):
        keys.press(key)
    expect(broken).to_be_focused()
    keys.press("Enter")
    expect(studio.at("check-seen")).to_have_attribute("data-confirmed", "true")
    expect(studio.at("check-story").locator("li").last).to_contain_text("reaches into the empty storehouse")
    expect(studio.at("check-limits")).to_be_visible()
    expect(studio.at("guilty-sentence")).to_contain_text("reaches into the empty storehouse")
    expect(studio.page.get_by_role("tab", selected=True).locator(".tab-cross")).to_be_visible()
    expect(studio.at("check-why").locator("li").first).to_contain_text("reaches into the empty storehouse")
    expect(studio.page.locator('[data-decided="true"]').first).to_be_attached()
    studio.at("check-other").click()
    both = studio.at("check-both")
    expect(both).to_be_visible(timeout=1000 * PATIENCE_S)
    expect(studio.at("check-steps-play")).to_be_focused()
    find_nothing(studio, "both ways side by side")
    keys.press("End")
    expect(studio.at("check-way-broken")).to_contain_text("reaches into the empty storehouse")
    for width in (1440, 390):
        studio.page.set_viewport_size({"width": width, "height": 900})
        for way in ("broken", "kept"):
            box = studio.at(f"check-way-{way}").locator(".check-way-arena").bounding_box()
            assert box is not None
            assert box["width"] >= min(600, width - 40)
            assert box["height"] >= 170
    studio.page.set_viewport_size({"width": WIDTH, "height": HEIGHT})
    keys.press("Escape")
    expect(both).to_have_count(0)
    expect(studio.at("check-other")).to_be_focused()
    find_nothing(studio, "the check with a run open")
    studio.at("check-run").get_by_role("button").first.click()
    expect(studio.at("check-run")).to_have_count(0)
    expect(studio.page.locator(".guilty-cross")).to_have_count(0)
    broken.click()
    studio.at("check-play").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused", timeout=1000 * PATIENCE_S)
    expect(studio.at("status")).to_contain_text("01:05.6")


@pytest.fixture
def stranded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, open_studio) -> str:
    """A carrier that waits for a sign which its road does not have."""
    path = tmp_path / "made" / "stranded" / "stranded.krt"
    path.parent.mkdir(parents=True)
    path.write_text(WAIT, encoding="utf-8")
    monkeypatch.setattr(drawing_check_socket, "EXPLORE_S", None)  # However busy the machine is.
    monkeypatch.setitem(open_studio.__globals__, "EXAMPLES", tmp_path / "made")
    return "stranded/stranded.krt"


@pytest.mark.thorough("test_many_runs.py: after_an_edit_what_waits_for_ever_is_a_problem_that_a_run_shows")
def test_after_an_edit_what_waits_for_ever_is_among_the_problems_and_a_press_plays_it_until_the_next_edit(
    open_studio, stranded: str
) -> None:
    studio = open_studio(stranded)
    problems = studio.at("problems")
    expect(problems).to_contain_text("0")
    studio.at("vertex-halt").click()
    studio.page.keyboard.press("Delete")
    expect(problems).to_contain_text("2", timeout=1000 * PATIENCE_S)
    expect(studio.at("problem-first")).to_have_attribute("data-severity", "warning")
    problems.click()
    expect(studio.at("problem-1")).to_contain_text("carrier-1 can come to wait here for ever", ignore_case=True)
    expect(studio.at("show-2")).to_have_count(0)
    studio.at("show-1").click()
    expect(studio.at("status")).to_have_attribute("data-status", "paused", timeout=1000 * PATIENCE_S)
    find_nothing(studio, "problems that a run shows")
    studio.page.keyboard.press("Control+z")
    expect(studio.at("problem-first")).to_have_count(0)
