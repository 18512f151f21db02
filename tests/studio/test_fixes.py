"""Problems that have one right answer are mended with one click, or one key."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.effort import cases
from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[..., Studio]


AT_ONCE = """<kitrobot version="1">
  <program name="p" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wheel.Advance"><set name="speed">50</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="p"/>
  </team>
</kitrobot>
"""


def with_a_mistake(studio: Studio, right: str, wrong: str) -> None:
    """The mission's file with a mistake in it, opened again."""
    path = studio.folder / "blink.krt"
    text = path.read_text()
    assert right in text
    path.write_text(text.replace(right, wrong, 1))
    studio.page.reload()
    expect(studio.at("canvas")).to_be_visible()


def a_name_in_the_graph_by_click_and_back(studio: Studio) -> None:
    with_a_mistake(studio, "Light.LightOn", "Light.LihgtOn")
    expect(studio.at("problems")).to_contain_text("1")
    studio.at("problems").click()
    expect(studio.at("problem-1")).to_contain_text("did you mean Light.LightOn", ignore_case=True)
    studio.at("fix-1").click()
    studio.expect_code("Light.LightOn()")
    expect(studio.at("problems")).to_contain_text("0")
    expect(studio.at("fix-1")).to_have_count(0)
    studio.page.keyboard.press("Control+z")
    expect(studio.at("problems")).to_contain_text("1")


def a_slip_in_the_text_by_key(studio: Studio) -> None:
    studio.edit_code()
    studio.page.keyboard.press("Control+End")
    studio.page.keyboard.insert_text("\nLigth.LightOn();")
    expect(studio.at("code-state")).to_contain_text("Ligth")
    studio.page.keyboard.press("F8")
    expect(studio.at("problem-1")).to_contain_text("did you mean Light", ignore_case=True)
    studio.page.keyboard.press("Control+.")
    studio.expect_code("\nLight.LightOn();")
    expect(studio.at("code-state")).to_be_empty()
    expect(studio.page.locator(".vertex", has_text="Lamp On")).to_have_count(2)


def a_program_that_ends_at_once_says_so_whole_and_is_mended(studio: Studio) -> None:
    (studio.folder / "blink.krt").write_text(AT_ONCE)
    studio.page.reload()
    for width in cases([768], [1440, 1024]):
        studio.take_back()
        studio.page.set_viewport_size({"width": width, "height": 900})
        expect(studio.page.locator(".vertex", has_text="driving")).to_have_count(1)
        expect(studio.page.locator(".vertex", has_text="Wait")).to_have_count(0)
        studio.at("run-button").click()
        expect(studio.at("ending").locator("p").first).to_have_text(
            "Done after 0.0 s: the program came to its end at once, without a part that takes time; "
            "robot-1 ended with its motors on."
        )
        whole = studio.at("ending").evaluate("e => e.scrollWidth <= e.clientWidth && e.scrollHeight <= e.clientHeight")
        assert whole
        expect(studio.at("ending")).to_be_in_viewport(ratio=1)
        expect(studio.at("problem-1")).to_contain_text("without a part that takes time")
        studio.at("fix-1").click()
        expect(studio.page.locator(".vertex", has_text="Wait")).to_have_count(1)
        expect(studio.at("fix-1")).to_have_count(0)


@pytest.mark.thorough(
    "web/src/session/fixes.test.ts and features/problems/ProblemList.test.tsx: mended in text and graph, undone; "
    "features/arena/stage/account.test.ts: a program that ends at once; the result whole: test_clipping.py, done"
)
def test_a_slip_a_wrong_name_and_a_program_that_ends_at_once_are_said_and_mended_by_key_and_by_click(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio("blink/blink.krt")
    a_slip_in_the_text_by_key(studio)
    studio.at("canvas").focus()
    studio.take_back()
    a_name_in_the_graph_by_click_and_back(studio)
    a_program_that_ends_at_once_says_so_whole_and_is_mended(studio)
