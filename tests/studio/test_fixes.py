"""Problems that have one right answer are mended with one click, or one key."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]


def with_a_mistake(studio: Studio, right: str, wrong: str) -> None:
    """The mission's file with a mistake in it, opened again."""
    path = studio.folder / "blink.krt"
    text = path.read_text()
    assert right in text
    path.write_text(text.replace(right, wrong, 1))
    studio.page.reload()
    expect(studio.at("canvas")).to_be_visible()


def test_a_name_in_the_graph_by_click_and_back(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
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


def test_a_slip_in_the_text_by_key(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    expect(studio.at("code-editor")).to_have_attribute("data-writable", "true")
    studio.at("code").locator(".cm-content").focus()
    studio.page.keyboard.press("Control+End")
    studio.page.keyboard.insert_text("\nLigth.LightOn();")
    expect(studio.at("code-state")).to_contain_text("Ligth")
    studio.page.keyboard.press("F8")
    expect(studio.at("problem-1")).to_contain_text("did you mean Light", ignore_case=True)
    studio.page.keyboard.press("Control+.")
    studio.expect_code("\nLight.LightOn();")
    expect(studio.at("code-state")).to_be_empty()
    expect(studio.page.locator(".vertex", has_text="LightOn")).to_have_count(2)


def test_a_problem_without_one_right_answer_offers_none(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    with_a_mistake(studio, "Light.LightOn", "Xyzzy.Plugh")
    studio.at("problems").click()
    expect(studio.at("problem-1")).to_be_visible()
    expect(studio.at("fix-1")).to_have_count(0)
    studio.page.keyboard.press("Control+.")
    expect(studio.at("problem-1")).to_be_visible()
