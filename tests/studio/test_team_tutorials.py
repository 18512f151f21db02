"""The tutorials about teams, gone through with mouse and keys; with a step skipped and gone back to."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio
from tests.studio.test_failure_lab import choose
from tests.studio.test_tutorials import BLINK, OpenStudio, at_step, begin, done, run

pytestmark = pytest.mark.browser


def write_parofseq(studio: Studio) -> None:
    """Types the whole program anew, each robot on its own."""
    studio.edit_code()
    studio.page.keyboard.press("Control+a")
    studio.page.keyboard.insert_text(
        "role driver: mini-robot 3; group crew = driver; ParOfSeq crew "
        "(*[Captor.GreaterThan(40)](Wheel.Advance(60); WAIT(2); Wheel.Stop();); Light.LightOn(););"
    )


def let_fail(studio: Studio, robot: str) -> None:
    """Lets a robot fail with the keys of the arena, once the run is on."""
    expect(studio.at("status")).to_have_attribute("data-status", "running")
    choose(studio, robot)
    studio.page.keyboard.press("Enter")
    studio.at("menu-harm-fail").click()


@pytest.mark.thorough(
    "tests/server/test_tutorials.py: a team's program is held against a tutorial; "
    "web/src/features/tutorial/step-watch.test.ts: a member waits; by hand: test_first_steps_draw_a_square…"
)
def test_together_step_by_step(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    begin(studio, "together-in-step")
    expect(studio.page.locator(".vertex", has_text="Together, line by line").first).to_have_css(
        "outline-style", "dashed"
    )
    run(studio)
    expect(studio.at("meeting").first).to_contain_text("of 3 are here")
    at_step(studio, 2)
    studio.full_speed()
    studio.wait_until_done()
    studio.drop("Light.LightOn", "arc-v2.next")
    at_step(studio, 3)
    run(studio)
    at_step(studio, 4)
    write_parofseq(studio)
    at_step(studio, 5)
    run(studio)
    at_step(studio, 6)
    studio.at("tutorial-show").click()
    studio.at("tutorial-go-button-projection").click()
    expect(studio.at("code-tab-projection")).to_be_focused()
    studio.page.keyboard.press("Enter")
    expect(studio.at("tutorial-end")).to_contain_text("Well done!")
    done(studio, *range(1, 7))


@pytest.mark.thorough(
    "tests/server/test_tutorials.py: the rule of a group and the spare robots are held against a tutorial; "
    "web/src/features/tutorial/step-watch.test.ts: one that failed, was replaced, was dropped; state.test.ts: "
    "skipped and back; by hand: test_failure_lab.py"
)
def test_when_one_fails(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    begin(studio, "when-one-fails")
    side = studio.at("side-team")
    expect(side).to_have_css("outline-style", "dashed")
    side.click()
    expect(studio.page.locator("label", has=studio.at("failure-crew-substitute"))).to_have_css(
        "outline-style", "dashed"
    )
    studio.at("failure-crew-substitute").check()
    at_step(studio, 2)
    studio.at("tutorial-next").click()
    at_step(studio, 3)
    studio.at("tutorial-back").click()
    at_step(studio, 2)
    studio.at("tab-of-team").click()
    studio.at("add-agent").click()
    at_step(studio, 3)
    run(studio)
    let_fail(studio, "robot-2")
    at_step(studio, 4)
    studio.at("members-button").click()
    expect(studio.at("member-row-robot-4")).to_contain_text("for robot-2")
    at_step(studio, 5)
    studio.at("stop-button").click()
    studio.at("failure-crew-drop").check()
    # The first step stays done, though its rule is another one now.
    done(studio, 1, 2, 3, 4)
    run(studio)
    let_fail(studio, "robot-1")
    at_step(studio, 6)
    studio.at("stop-button").click()
    studio.at("failure-crew-abort").check()
    run(studio)
    let_fail(studio, "robot-1")
    expect(studio.at("tutorial-end")).to_contain_text("Well done!")
    done(studio, *range(1, 7))
