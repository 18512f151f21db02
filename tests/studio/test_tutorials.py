"""A newcomer goes through each tutorial as a person would: with mouse and keyboard, wrong ways, undo, and a break."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import LOOKS, Studio
from tests.studio.looks import choose, find_nothing
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
BLINK = "blink/blink.krt"
PANEL = "[data-testid='tutorial']"
FIRST = "example:tutorials/first-steps/first-steps.tutorial.xml"


def begin(studio: Studio, name: str) -> None:
    """Begins a tutorial from the menu Help."""
    studio.at("menu-Help").click()
    studio.at(f"menu-help-tutorial-example:tutorials/{name}/{name}.tutorial.xml").click()
    at_step(studio, 1)


def at_step(studio: Studio, number: int) -> None:
    """Waits until the panel shows that step."""
    expect(studio.at("tutorial")).to_have_attribute("data-step", str(number))


def done(studio: Studio, *numbers: int) -> None:
    """Waits until these steps are done, and no others."""
    expect(studio.page.locator('.tutorial-dot[data-state="done"]')).to_have_count(len(numbers))
    for number in numbers:
        expect(studio.at(f"tutorial-step-{number}")).to_have_attribute("data-state", "done")


def run(studio: Studio) -> None:
    """Presses Run."""
    studio.at("run-button").click()


def set_field(studio: Studio, field: str, value: str) -> None:
    """Types into a field of the inspector."""
    studio.at(f"field-{field}").fill(value)


def first_steps_until_run(studio: Studio) -> None:
    """The first two steps with the mouse."""
    studio.drop("Pen.PenDown", "first-place")
    at_step(studio, 2)
    studio.drop("Wheel.DriveBy", "arc-v1.next")
    at_step(studio, 3)


def the_hint_shows_the_part_that_is_meant_and_lies_over_nothing(studio: Studio) -> None:
    expect(studio.at("part-Pen.PenDown")).to_have_css("outline-style", "dashed")
    studio.at("tutorial-show").click()
    expect(studio.at("tutorial-hint")).to_contain_text("press /, type Pen down")
    find_nothing(studio, "the hint", within=PANEL)
    canvas, panel = place_of(studio.at("canvas")), place_of(studio.at("tutorial"))
    assert panel["y"] + panel["height"] <= canvas["y"] + 1


def test_first_steps_draw_a_square_with_seven_actions_of_the_mouse(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    begin(studio, "first-steps")
    the_hint_shows_the_part_that_is_meant_and_lies_over_nothing(studio)
    studio.full_speed()
    # An action each: to drop a part, to type a number, to run.
    first_steps_until_run(studio)
    expect(studio.at("tutorial-said")).to_contain_text("Done: Drive 30 cm. Step 3: Run it.")
    run(studio)
    at_step(studio, 4)
    studio.drop("Repetition", "vertex-v2")
    at_step(studio, 5)
    set_field(studio, "v3.count", "4")
    at_step(studio, 6)
    studio.drop("Motor.LeftBy", "arc-v2.next")
    at_step(studio, 7)
    done(studio, 1, 2, 3, 4, 5, 6)
    run(studio)
    expect(studio.at("tutorial-end")).to_contain_text("That was First steps. Well done!")
    done(studio, *range(1, 8))


@pytest.mark.thorough(
    "test_first_steps_draw_a_square_with_seven_actions_of_the_mouse; with keys: test_keys.py and test_new_mission.py"
)
def test_first_steps_by_keyboard_alone_in_urdu(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    choose(studio, "ur")
    keys = studio.page.keyboard
    studio.at("menu-Help").focus()
    keys.press("Enter")
    expect(studio.at(f"menu-help-tutorial-{FIRST}")).to_be_focused()
    keys.press("Enter")
    at_step(studio, 1)
    panel = studio.at("tutorial")
    expect(panel).to_be_focused()
    expect(panel).to_contain_text("قلم نیچے کریں")
    # Names of parts stand there as the palette has them.
    expect(panel).not_to_contain_text("{")
    expect(panel.locator("p").first).to_contain_text(
        studio.page.locator('[data-row="object actuator Pen"]').inner_text()
    )

    def add(part: str) -> None:
        keys.press("/")
        studio.at("add-find").fill(part)
        keys.press("Enter")

    studio.at("canvas").focus()
    keys.press("ArrowDown")
    add("Pen.PenDown")
    at_step(studio, 2)
    studio.at("canvas").focus()
    add("Wheel.DriveBy")
    at_step(studio, 3)
    studio.full_speed()
    keys.press("F5")
    at_step(studio, 4)
    studio.at("canvas").focus()
    keys.press("w")
    studio.at("add-find").fill("Repetition")
    keys.press("Enter")
    at_step(studio, 5)
    studio.at("tutorial-show").focus()
    keys.press("Enter")
    studio.at("tutorial-go-vertex-Repetition").focus()
    keys.press("Enter")
    expect(studio.at("field-v3.count")).to_be_focused()
    keys.press("Control+a")
    keys.type("4")
    at_step(studio, 6)
    keys.press("Enter")
    studio.at("canvas").focus()
    keys.press("ArrowDown")
    add("Motor.LeftBy")
    at_step(studio, 7)
    keys.press("F5")
    expect(studio.at("tutorial-end")).to_be_visible()
    done(studio, *range(1, 8))


@pytest.mark.thorough(
    "tests/tutorial/test_shipped.py: each step of sensing, and a wrong way; web/src/features/tutorial/Panel.test.tsx: "
    "what is undone is open again; progress.test.ts: what was run, was run"
)
def test_sensing_with_a_wrong_way_and_undo(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    begin(studio, "sensing")
    studio.drop("While", "first-place")
    at_step(studio, 2)
    studio.drop("Captor.GreaterThan", "slot-v1.condition")
    at_step(studio, 3)
    # A wrong way: the robot would begin to drive after the loop.
    studio.drop("Wheel.Advance", "arc-v1.next")
    studio.expect_code("Wheel.Advance(50);")
    done(studio, 1, 2)
    at_step(studio, 3)
    studio.page.keyboard.press("Control+z")
    studio.drop("Wheel.Advance", "arc-v1.body")
    at_step(studio, 4)
    studio.drop("Wheel.Stop", "arc-v1.next")
    at_step(studio, 5)
    studio.full_speed()
    run(studio)
    at_step(studio, 6)
    # What is undone is not done any more; what was run, was run.
    studio.page.keyboard.press("Control+z")
    done(studio, 1, 2, 3, 5)
    expect(studio.at("tutorial-undone")).to_have_text("Step 4 is open again")
    at_step(studio, 6)
    studio.page.keyboard.press("Control+y")
    done(studio, 1, 2, 3, 4, 5)
    stop = studio.page.locator('.vertex[aria-label*="Stand still"]').first.get_attribute("data-testid") or ""
    studio.drop("Motor.AbsoluteTurn", f"arc-{stop.removeprefix('vertex-')}.next")
    at_step(studio, 7)
    turn = studio.page.locator('.vertex[aria-label*="Turn by"]').get_attribute("data-testid") or ""
    studio.drop("If Then", f"arc-{turn.removeprefix('vertex-')}.next")
    choice = (studio.page.locator('.vertex[aria-label*="If Then"]').get_attribute("data-testid") or "")[7:]
    studio.drop("Captor.GreaterThan", f"slot-{choice}.condition")
    studio.drop("Light.LightOn", f"arc-{choice}.then")
    at_step(studio, 8)
    run(studio)
    expect(studio.at("tutorial-end")).to_be_visible()
    done(studio, *range(1, 9))


@pytest.mark.thorough(
    "tests/tutorial/test_shipped.py: each step of together; by mouse: test_first_steps_draw_a_square…, test_main_job.py"
)
def test_together_with_two_branches_and_two_programs(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    begin(studio, "together")
    studio.drop("Parallelism", "first-place")
    at_step(studio, 2)
    studio.drop("Wheel.Advance", "arc-v1.branch.2")
    studio.drop("Wait", "arc-v2.next")
    at_step(studio, 3)
    studio.drop("Light.LightOn", "arc-v1.branch.1")
    at_step(studio, 4)
    studio.drop("Wheel.Stop", "arc-v1.next")
    at_step(studio, 5)
    studio.full_speed()
    run(studio)
    at_step(studio, 6)
    studio.at("add-program").click()
    studio.at("menu-add-mini-robot").click()
    expect(studio.at("tab-program-1")).to_be_visible()
    studio.drop("Wheel.Advance", "first-place")
    at_step(studio, 7)
    studio.drop("Wait", "arc-v1.next")
    done(studio, *range(1, 7))
    studio.drop("Wheel.Stop", "arc-v2.next")
    at_step(studio, 8)
    run(studio)
    expect(studio.at("tutorial-end")).to_be_visible()
    done(studio, *range(1, 9))


@pytest.mark.thorough(
    "web/src/features/tutorial/state.test.ts: it jumps over what was done before its time; "
    "tests/server/test_tutorials.py: another right way; more than asked: tests/tutorial/test_matching.py"
)
def test_later_steps_first_another_right_way_and_more_than_was_asked(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    begin(studio, "first-steps")
    studio.edit_code()
    studio.page.keyboard.press("Control+a")
    studio.page.keyboard.insert_text(
        "Pen.PenDown(); 2*(2*(Wheel.Advance(20); WAIT(5); Wheel.Stop(); Motor.AbsoluteTurn(24, 80)));"
    )
    # All but the corner and the runs: the shown step is done, and the next open one comes.
    at_step(studio, 3)
    done(studio, 1, 2, 4, 5)
    studio.full_speed()
    run(studio)
    done(studio, 1, 2, 3, 4, 5)
    at_step(studio, 6)


def hints_come_when_asked_for_and_lead_to_what_is_meant(studio: Studio) -> None:
    part = studio.at("part-Pen.PenDown")
    expect(part).to_have_css("outline-style", "dashed")
    expect(studio.at("tutorial-hint")).to_have_count(0)
    studio.at("tutorial-show").click()
    expect(studio.at("tutorial-hint")).to_contain_text("press /, type Pen down")
    studio.at("tutorial-go-part-Pen.PenDown").click()
    expect(part).to_be_focused()
    expect(part).to_have_css("outline-style", "dashed")
    studio.page.keyboard.press("Enter")
    at_step(studio, 2)
    expect(studio.at("tutorial-hint")).to_have_count(0)
    expect(part).not_to_have_css("outline-style", "dashed")
    canvas, panel = place_of(studio.at("canvas")), place_of(studio.at("tutorial"))
    assert panel["y"] + panel["height"] <= canvas["y"] + 1


@pytest.mark.thorough(
    "web/src/features/tutorial: Panel.test.tsx gives the hint, points.test.ts leads to what is meant, "
    "state.test.ts skips, goes back, and takes up again; the hint on the page: the test above"
)
def test_hints_lead_to_what_is_meant_and_steps_are_skipped_left_and_taken_up_again(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    begin(studio, "first-steps")
    hints_come_when_asked_for_and_lead_to_what_is_meant(studio)
    studio.at("tutorial-next").click()
    at_step(studio, 3)
    expect(studio.at("tutorial-step-2")).to_have_attribute("data-state", "skipped")
    studio.at("tutorial-back").click()
    studio.at("tutorial-back").click()
    at_step(studio, 1)
    expect(studio.at("tutorial")).to_contain_text("This step is done.")
    studio.at("tutorial-step-2").click()
    # Loaded again in the middle: everything is as it was.
    expect(studio.at("saved-state")).to_have_text("not saved")
    with studio.page.expect_response(
        lambda answer: "journal" in answer.url and answer.ok and "Add Drive" in (answer.request.post_data or "")
    ):
        studio.drop("Wheel.DriveBy", "arc-v1.next")
    at_step(studio, 3)
    studio.page.reload()
    at_step(studio, 3)
    studio.expect_code("Wheel.DriveBy(30);")
    done(studio, 1, 2)
    # Left and taken up again: the same step, and the same program.
    studio.at("tutorial-leave").click()
    expect(studio.at("tutorial")).to_have_count(0)
    studio.page.reload()
    studio.expect_code("Wheel.DriveBy(30);")
    studio.at("menu-Help").click()
    studio.at(f"menu-help-tutorial-{FIRST}").click()
    at_step(studio, 3)
    studio.expect_code("Wheel.DriveBy(30);")
    done(studio, 1, 2)


@pytest.mark.thorough("web/src/features/tutorial/state.test.ts, what was done is there with the file it was saved to")
def test_what_was_saved_elsewhere_is_where_it_goes_on(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    begin(studio, "first-steps")
    studio.drop("Pen.PenDown", "first-place")
    at_step(studio, 2)
    studio.page.keyboard.press("Control+Shift+s")
    studio.page.locator('[data-testid="save-dialog"] input').first.fill("mine.krt")
    studio.page.keyboard.press("Enter")
    expect(studio.at("save-dialog")).to_have_count(0)
    studio.page.keyboard.press("Control+o")
    studio.page.locator('[data-path="blink.krt"]').click()
    studio.expect_code("Light.LightOn()")
    expect(studio.at("tutorial")).to_have_count(0)
    studio.page.keyboard.press("Alt+l")
    card = studio.at(f"tutorial-card-{FIRST}")
    expect(card).to_contain_text("step 2 of 7")
    card.click()
    at_step(studio, 2)
    studio.expect_code("Pen.PenDown();")
    expect(studio.page.locator(".title")).to_contain_text("mine.krt")
    done(studio, 1)


@pytest.mark.thorough(
    "test_first_steps_draw_a_square_with_seven_actions_of_the_mouse looks at a step and its hint with axe; the path to "
    "learn: test_exercises.py; colours: web/src/theme/tokens.test.ts; its place: tests/studio/test_clipping.py"
)
@pytest.mark.parametrize("look", LOOKS, ids=str)
def test_axe_finds_nothing_and_nothing_overlaps(open_studio: OpenStudio, look: tuple[str, ...]) -> None:
    studio = open_studio(None)
    choose(studio, *look)
    find_nothing(studio, "the welcome", within="main")
    studio.page.keyboard.press("Alt+l")
    expect(studio.at(f"tutorial-card-{FIRST}")).to_be_visible()
    find_nothing(studio, "the path to learn", within="[data-testid='learn-sheet']")
    studio.at(f"tutorial-card-{FIRST}").click()
    at_step(studio, 1)
    find_nothing(studio, "the first step", within=PANEL)
    studio.at("tutorial-show").click()
    find_nothing(studio, "the hint", within=PANEL)
    for _ in range(7):
        studio.at("tutorial-next").click()
    find_nothing(studio, "the end", within=PANEL)
    panel, leave = place_of(studio.at("tutorial")), place_of(studio.at("tutorial-leave"))
    at_left = leave["x"] - panel["x"] < panel["width"] / 2
    assert at_left is ("ur" in look)
