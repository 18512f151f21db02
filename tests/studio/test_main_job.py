"""A user opens a mission, presses Run, changes a program, saves it: in the real page, with real drags."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from kitrobot.lll.parse_results import parse
from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
TRANSPORT = "transport/transport.krt"


def active_vertices_glow_for_the_agent_whose_tab_is_open(studio: Studio) -> None:
    studio.at("run-button").click()
    glowing = studio.page.locator(".vertex.is-active")
    expect(glowing.first).to_be_visible()
    studio.at("tab-store-manager-A").click()
    expect(studio.page.locator(".vertex.is-active", has_text="While")).to_be_visible()
    studio.at("stop-button").click()
    expect(studio.at("status")).to_contain_text("Stopped")
    expect(studio.page.locator(".vertex.is-active")).to_have_count(0)


def pause_step_and_resume_count_ticks(studio: Studio) -> None:
    studio.at("run-button").click()
    expect(studio.at("status")).to_contain_text("Running")
    studio.at("pause-button").click()
    expect(studio.at("status")).to_contain_text("Paused")
    clock = studio.at("event-strip").get_by_text(re.compile(r"tick \d+$"))
    before = int((clock.text_content() or "").rpartition(" ")[2])
    studio.at("step-button").click()
    expect(clock).to_have_text(re.compile(rf"tick {before + 1}$"))
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()


def a_part_dropped_on_an_arc_is_set_in_the_inspector_deleted_undone_and_saved(studio: Studio) -> None:
    studio.drop("Wait", "arc-start.next")
    studio.expect_code("WAIT(10);")
    number = studio.at("inspector").locator('input:not([type="range"])').first
    number.fill("0.7 s")
    studio.expect_code("WAIT(7);")
    studio.page.keyboard.press("Enter")
    studio.page.locator(".vertex.is-selected, .vertex:has-text('Wait')").first.click()
    studio.page.keyboard.press("Delete")
    expect(studio.at("code")).not_to_contain_text("WAIT")
    studio.page.keyboard.press("Control+z")
    studio.expect_code("WAIT(7);")
    studio.page.keyboard.press("Control+s")
    expect(studio.at("saved-state")).to_have_text("saved")
    text = (studio.folder / "transport.krt").read_text(encoding="utf-8")
    assert 'element="Wait"' in text
    assert '<set name="duration">7</set>' in text


def the_stock_of_a_is_in_b_after_a_run(studio: Studio) -> None:
    summary = studio.at("arena-summary")
    expect(summary).to_contain_text("12 of 12 delivered")
    expect(summary).to_contain_text("A 0, B 12")
    expect(summary).not_to_contain_text("collision")


def test_a_run_glows_is_paused_and_stepped_and_a_part_is_dropped_set_deleted_undone_and_saved(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(TRANSPORT)
    expect(studio.at("arena-summary")).to_contain_text("A 12, B 0")
    active_vertices_glow_for_the_agent_whose_tab_is_open(studio)
    pause_step_and_resume_count_ticks(studio)
    the_stock_of_a_is_in_b_after_a_run(studio)
    studio.at("tab-carrier").click()
    a_part_dropped_on_an_arc_is_set_in_the_inspector_deleted_undone_and_saved(studio)


def mistakes_appear_in_problems_and_go_when_mended(studio: Studio) -> None:
    expect(studio.at("problems")).to_contain_text("0")
    studio.drop("While", "arc-start.next")
    expect(studio.at("problems")).to_contain_text("1")
    studio.at("problems").click()
    expect(studio.at("problem-1")).to_contain_text("empty")
    studio.at("run-button").click()
    expect(studio.at("status")).not_to_contain_text("Running")
    slot = studio.page.locator(".chip.is-empty").first
    studio.drag(studio.at("part-Run.IsTrue"), slot)
    studio.expect_code("*[Run.IsTrue()]();")
    expect(studio.at("problems")).to_contain_text("0")


def a_new_program_is_drawn_from_nothing(studio: Studio) -> None:
    studio.new_mission()
    expect(studio.at("first-place")).to_be_visible()
    studio.drop("Parallelism", "first-place")
    studio.expect_code("//(")
    code = studio.code()
    assert parse(code).ok


@pytest.mark.thorough(
    "web/src/features/problems/ProblemList.test.tsx and session/fixes.test.ts; tests/studio/test_fixes.py mends "
    "by key and by click; a program from nothing: test_first_hour.py"
)
def test_mistakes_are_mended_and_a_new_program_is_drawn(open_studio: OpenStudio) -> None:
    studio = open_studio(TRANSPORT)
    mistakes_appear_in_problems_and_go_when_mended(studio)
    studio.take_back()
    a_new_program_is_drawn_from_nothing(studio)
