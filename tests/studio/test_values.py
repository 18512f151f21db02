"""Numbers as people read and type them: on vertices, in their fields, in the inspector, in the hover, in a run."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Route, expect

from tests.studio.conftest import HEIGHT, WIDTH, Studio
from tests.studio.studio_page import place_of

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]
BLINK = "blink/blink.krt"
PROGRAM = "Motor.AbsoluteTurn(25, 50);\nWAIT(10);\nPen.Colour(3);\n<Captor.LessThan(20)>(Wheel.Stop(););\n"


def vertex(studio: Studio, words: str) -> Locator:
    return studio.page.locator(".vertex", has_text=words).first


def written(studio: Studio, text: str) -> None:
    """The program is this text, and the graph shows it."""
    studio.edit_code()
    studio.page.keyboard.press("Control+a")
    studio.page.keyboard.insert_text(text)
    expect(studio.at("code-state")).to_be_empty()
    studio.at("canvas").focus()


def a_value_is_shown_with_its_unit_and_edited_where_it_stands(studio: Studio) -> None:
    keys = studio.page.keyboard
    expect(vertex(studio, "Turn by")).to_contain_text("90°")
    expect(vertex(studio, "Wait")).to_contain_text("1.0 s")
    expect(vertex(studio, "Pen colour")).to_contain_text("blue")
    expect(vertex(studio, "When")).to_contain_text("nearer than 20 cm")
    # A digit is typed over the value of what is selected; the unit may be typed or not.
    vertex(studio, "Turn by").locator(".vertex-name").click()
    keys.type("180")
    expect(studio.at("in-place")).to_be_visible()
    keys.press("Enter")
    expect(studio.at("in-place")).to_have_count(0)
    expect(studio.at("canvas")).to_be_focused()
    studio.expect_code("Motor.AbsoluteTurn(50, 50)")
    # A double click opens the field of that value; Escape leaves it as it was, and no step to undo.
    undo = studio.at("undo").get_attribute("title")
    vertex(studio, "Wait").locator(".box").dblclick()
    field = studio.at("in-place").locator("[data-testid^=field-]")
    expect(field).to_be_focused()
    keys.type("2.5 s")
    studio.expect_code("WAIT(25)")
    keys.press("Escape")
    studio.expect_code("WAIT(10)")
    expect(studio.at("canvas")).to_be_focused()
    expect(studio.at("undo")).to_have_attribute("title", undo or "")
    # Out of range: a dashed border, one sentence, and Enter takes the nearest.
    vertex(studio, "Turn by").locator(".box").first.dblclick()
    keys.type("400")
    expect(studio.at("in-place").get_by_role("alert")).to_have_text("At most 360°. Enter keeps 360°.")
    expect(studio.at("in-place").locator(".field-number")).to_have_css("border-top-style", "dashed")
    keys.press("Enter")
    studio.expect_code("Motor.AbsoluteTurn(100, 50)")
    # The number of a test is edited on its chip.
    vertex(studio, "When").locator(".chip").dblclick()
    keys.type("35")
    keys.press("Enter")
    studio.expect_code("Captor.LessThan(35)")


def what_is_typed_before_the_field_is_there_is_typed_into_it(studio: Studio) -> None:
    keys = studio.page.keyboard
    waiting: list[Route] = []
    studio.page.route(re.compile(r"/InPlace-[^/]*\.js$"), lambda route: waiting.append(route))
    vertex(studio, "Turn by").locator(".vertex-name").click()
    with studio.page.expect_request(re.compile(r"/InPlace-[^/]*\.js$")):
        keys.type("1")
    keys.type("79")
    keys.press("Backspace")
    keys.type("8")
    keys.press("Enter")
    keys.press("ArrowDown")
    waiting.pop().continue_()
    # Enter kept the value, and the key after it was for the graph again.
    studio.expect_code("Motor.AbsoluteTurn(49, 50)")
    expect(studio.at("in-place")).to_have_count(0)
    expect(studio.at("canvas")).to_be_focused()
    expect(studio.at("inspector").locator("h2")).to_have_text("Wait")


def the_inspector_has_the_same_field_with_what_fits_and_the_name_of_lll(studio: Studio) -> None:
    keys = studio.page.keyboard
    vertex(studio, "Turn by").click()
    inspector = studio.at("inspector")
    expect(inspector.locator("h2")).to_have_text("Turn by")
    expect(inspector.locator(".inspector-element")).to_have_text("Motor.AbsoluteTurn")
    expect(inspector).to_contain_text("a quarter turn")
    dial = inspector.get_by_role("slider", name="angle")
    expect(dial).to_have_attribute("aria-valuetext", "90°")
    dial.focus()
    keys.press("ArrowUp")
    studio.expect_code("Motor.AbsoluteTurn(26, 50)")
    keys.press("PageDown")
    studio.expect_code("Motor.AbsoluteTurn(16, 50)")
    keys.press("End")
    studio.expect_code("Motor.AbsoluteTurn(100, 50)")
    keys.press("Home")
    studio.expect_code("Motor.AbsoluteTurn(0, 50)")
    keys.press("Escape")
    expect(studio.at("canvas")).to_be_focused()
    studio.expect_code("Motor.AbsoluteTurn(25, 50)")
    # In the list for a test what the robot feels stands before what joins tests.
    vertex(studio, "When").click(position={"x": 20, "y": 20})
    groups = inspector.locator("select").first.locator("optgroup")
    expect(groups.first).to_have_attribute("label", "Distance sensor")
    expect(groups.last).to_have_attribute("label", "Values")
    vertex(studio, "When").locator(".chip").click()
    ruler = inspector.get_by_role("slider", name="distance")
    expect(ruler).to_have_attribute("aria-valuetext", "20 cm")
    ruler.focus()
    keys.press("PageUp")
    studio.expect_code("Captor.LessThan(30)")
    vertex(studio, "Pen colour").click()
    inspector.get_by_role("radio", name="orange").click()
    studio.expect_code("Pen.Colour(4)")
    expect(vertex(studio, "Pen colour")).to_contain_text("orange")
    keys.press("ArrowRight")
    studio.expect_code("Pen.Colour(5)")
    the_hover_over_a_number_of_the_text_says_what_it_means(studio)
    the_inspector_is_as_tall_as_its_content_and_begins_at_its_top(studio)


def the_hover_over_a_number_of_the_text_says_what_it_means(studio: Studio) -> None:
    studio.at("code").locator(".lll-number", has_text="25").first.hover()
    expect(studio.page.locator(".code-help")).to_contain_text("25 means 90°")
    expect(studio.page.locator(".code-help")).to_contain_text("angle of “Turn by”")


HEIGHTS = """() => ['inspector', 'code', 'arena'].map(name => document.querySelector('.side-' + name))
    .map(one => [one.clientHeight, one.scrollHeight])"""


def the_inspector_is_as_tall_as_its_content_and_begins_at_its_top(studio: Studio) -> None:
    keys, inspector = studio.page.keyboard, studio.page.locator(".side-inspector")
    tall = [height for height, _ in studio.page.evaluate(HEIGHTS)]
    studio.at("canvas").focus()
    keys.press("Escape")
    expect(inspector).to_contain_text("Nothing selected")
    (short, content), code, arena = studio.page.evaluate(HEIGHTS)
    assert short == content < tall[0] - 50
    assert [code[0] - tall[1], arena[0] - tall[2]] == [tall[0] - short, 0], "what it leaves is for the code"
    # Without the room for all of it, it scrolls.
    studio.page.set_viewport_size({"width": 1366, "height": 600})
    vertex(studio, "Turn by").click()
    expect(studio.at("inspector").get_by_role("slider", name="angle")).to_be_attached()
    (height, content), code, arena = studio.page.evaluate(HEIGHTS)
    assert height < content
    assert code[0] >= 120
    assert arena[0] >= 0.42 * (600 - 120) - 1
    inspector.evaluate("(one) => one.scrollTo(0, 99)")
    assert inspector.evaluate("(one) => one.scrollTop") > 0
    vertex(studio, "Wait").click()
    expect(studio.at("inspector").locator("h2")).to_have_text("Wait")
    assert inspector.evaluate("(one) => one.scrollTop") == 0


def chips_show_what_sensors_say_while_a_run_exists_and_can_be_switched(studio: Studio) -> None:
    written(studio, "*([Captor.LessThan(20)](Light.LightOn(););[Light.IsRed()]();WAIT(1););\n")
    near, ground = (studio.page.locator(".vertex", has_text=words) for words in ("nearer than", "Ground is red"))
    expect(near).to_be_visible()
    expect(studio.page.locator(".live-value")).to_have_count(0)
    studio.at("run-button").click()
    live = near.locator(".live-value")
    expect(live).to_have_text(re.compile(r"now \d+ cm"))
    expect(live).to_have_attribute("data-on", "false")
    expect(ground.locator(".live-value")).to_have_text("now none")
    studio.at("watch-button").click()
    expect(studio.at("watch-Captor").get_by_role("textbox")).to_have_value(re.compile(r"\d+ cm"))
    expect(studio.at("watch-Light").get_by_role("textbox")).to_have_value("none")
    # Nothing moves here: the run is over, and goes on when a sensor is held.
    expect(studio.at("status")).to_have_attribute("data-status", "stuck")
    box = studio.at("watch-Captor").get_by_role("textbox")
    box.click()
    place = box.bounding_box()
    box.fill("12 cm")
    studio.page.keyboard.press("Enter")
    expect(live).to_have_text("now 12 cm")
    expect(live).to_have_attribute("data-on", "true")
    expect(studio.at("event-list").locator("tr", has_text="held by hand: 12 cm")).to_have_count(1)
    expect(studio.at("release-Captor")).to_be_visible()
    assert box.bounding_box() == place, "what happened, and the button that lets go, have room already"
    studio.at("menu-View").click()
    studio.at("menu-view-live").click()
    expect(studio.page.locator(".live-value")).to_have_count(0)


COVERED = """() => {
    const place = (one) => [one.textContent, one.getBoundingClientRect()];
    const places = (of) => [...document.querySelectorAll(of)].map(place);
    const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    return places(".arc-label").flatMap(([label, at]) =>
        places(".live-value").filter(([, over]) => meet(at, over)).map(([value]) => `${value} lies over ${label}`));
}"""


@pytest.mark.thorough("tests/studio/test_clipping.py, the screen paused: no text of a run lies over another")
def test_what_a_sensor_says_lies_over_no_label_of_an_arc(open_studio: OpenStudio) -> None:
    studio = open_studio("transport/transport.krt")
    studio.at("run-button").click()
    expect(studio.page.locator(".live-value").first).to_be_visible()
    assert studio.page.locator(".arc-label").count() > 0
    assert studio.page.evaluate(COVERED) == []


def an_empty_body_shows_where_to_drop_and_what_follows_a_new_loop_goes_inside(studio: Studio) -> None:
    written(studio, "")
    keys = studio.page.keyboard
    keys.press("/")
    studio.at("add-find").fill("forever")
    keys.press("Enter")
    place = studio.page.locator("[data-testid^='place-']")
    expect(place).to_contain_text("Drop here what repeats")
    keys.press("/")
    studio.at("add-find").fill("repeat")
    keys.press("Enter")
    studio.expect_code("*(")
    studio.expect_code("10*(")
    place = studio.page.locator("[data-testid^='place-']")
    expect(place).to_have_count(1)
    # The whole frame takes what is dropped.
    frame = place_of(studio.page.locator(".frame-loop").last)
    studio.at("part-Wait").scroll_into_view_if_needed()
    part = place_of(studio.at("part-Wait"))
    mouse = studio.page.mouse
    mouse.move(part["x"] + 30, part["y"] + 10)
    mouse.down()
    mouse.move(part["x"] + 60, part["y"] + 30, steps=3)
    mouse.move(frame["x"] + frame["width"] - 16, frame["y"] + frame["height"] - 12, steps=8)
    expect(place).to_have_class(re.compile("is-aimed"))
    mouse.up()
    studio.expect_code("WAIT(10)")
    expect(place).to_have_count(0)


@pytest.mark.thorough(
    "web/src/features/inspector/values.test.tsx: in place and in the inspector; features/canvas/find.test.tsx: "
    "chips in a run; editing.test.tsx: empty bodies; test_keys_are_kept_for_a_field…: what needs a layout"
)
def test_a_value_is_typed_where_it_stands_and_in_the_inspector_and_chips_show_what_sensors_say(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(BLINK)
    written(studio, PROGRAM)
    expect(vertex(studio, "Turn by")).to_be_visible()
    what_is_typed_before_the_field_is_there_is_typed_into_it(studio)
    studio.page.keyboard.press("Control+z")
    a_value_is_shown_with_its_unit_and_edited_where_it_stands(studio)
    an_empty_body_shows_where_to_drop_and_what_follows_a_new_loop_goes_inside(studio)
    written(studio, PROGRAM)
    the_inspector_has_the_same_field_with_what_fits_and_the_name_of_lll(studio)
    studio.page.set_viewport_size({"width": WIDTH, "height": HEIGHT})
    chips_show_what_sensors_say_while_a_run_exists_and_can_be_switched(studio)


def test_keys_are_kept_for_a_field_and_the_inspector_is_as_tall_as_its_content(open_studio: OpenStudio) -> None:
    studio = open_studio(BLINK)
    written(studio, PROGRAM)
    expect(vertex(studio, "Turn by")).to_be_visible()
    what_is_typed_before_the_field_is_there_is_typed_into_it(studio)
    studio.page.keyboard.press("Control+z")
    vertex(studio, "Turn by").click()
    expect(studio.at("inspector").get_by_role("slider", name="angle")).to_be_attached()
    the_hover_over_a_number_of_the_text_says_what_it_means(studio)
    the_inspector_is_as_tall_as_its_content_and_begins_at_its_top(studio)
