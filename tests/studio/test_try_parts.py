"""What a robot is built of is asked once, with pictures, and remembered, and its parts are tried by hand."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from kitrobot.workspace.kit_files import kits_at_hand
from tests.boards.modern import ModernBoard
from tests.boards.test_bench import SLOW, UNPLUGGED
from tests.studio.conftest import Studio
from tests.studio.looks import find_nothing

pytestmark = pytest.mark.browser


@pytest.mark.thorough(
    "web/src/features/robots/RobotPanel.test.tsx: the question, each state of a step; tests/server/test_bench.py: "
    "a step runs until another one and tells its value or what is broken; tests/boards/test_bench.py on a board"
)
def test_a_robot_is_built_of_a_kit_and_its_parts_are_tried_by_hand(
    open_studio: Callable[..., Studio], monkeypatch: pytest.MonkeyPatch
) -> None:
    with ModernBoard({"lib/machine.py": UNPLUGGED + SLOW}) as board:
        monkeypatch.setenv("KITROBOT_BOARDS", board.address)
        studio = open_studio("square/square.krt")
        page = studio.page
        page.keyboard.press("Alt+r")
        robot = studio.at("robot")
        kit = robot.get_by_test_id("robot-kit")
        expect(robot).to_contain_text("Not said yet")
        robot.get_by_test_id("robot-try").click()
        cards = studio.at("kit-card")
        expect(cards).to_have_count(1 + len(kits_at_hand()))
        expect(cards.first).to_be_focused()
        expect(cards.and_(page.locator("[data-kit=pico]"))).to_contain_text("Runs")
        expect(cards.and_(page.locator("[data-kit=microbit]"))).to_contain_text("Lacks: Motor and Wheels")
        find_nothing(studio, "what it is built of")
        page.keyboard.press("Escape")
        expect(robot.get_by_test_id("robot-state")).to_have_count(0)
        robot.get_by_test_id("robot-try").click()
        expect(cards.first).to_be_focused()
        for key in ("ArrowDown", "ArrowRight", "ArrowRight"):
            page.keyboard.press(key)
        expect(cards.and_(page.locator("[data-kit=pico]"))).to_be_focused()
        page.keyboard.press("Enter")
        bench = robot.get_by_test_id("bench")
        expect(bench).to_contain_text("Lift the wheels off the ground first.")
        expect(robot.get_by_test_id("robot-micropython")).to_have_text(re.compile(r"MicroPython \d+\.\d+"))
        steps = bench.get_by_test_id("bench-step")

        def step(words: str):
            return steps.filter(has_text=words).first

        forward = step("Wheel.Advance(40)")
        expect(forward).to_contain_text("Both wheels turn forward.")
        forward.get_by_test_id("bench-try").click()
        expect(forward).to_have_attribute("data-going", "true")
        step("Button").get_by_test_id("bench-try").click()
        expect(forward).to_have_attribute("data-going", "false")
        expect(step("Button").get_by_test_id("bench-value")).to_have_text(re.compile("^(released|pressed)$"))
        expect(step("Button").get_by_test_id("bench-slow")).to_contain_text("longer than a tick")
        step("Distance sensor").get_by_test_id("bench-try").click()
        expect(step("Distance sensor").get_by_test_id("bench-failure")).to_contain_text("Distance sensor failed")
        expect(step("Distance sensor").get_by_test_id("bench-failure")).to_contain_text("not plugged in")
        step("Distance sensor").locator("summary").click()
        expect(step("Distance sensor")).to_contain_text("trigger and echo may be swapped")
        find_nothing(studio, "parts that are tried")
        page.keyboard.press("Shift+F5")
        expect(robot.get_by_test_id("robot-state")).to_have_attribute("data-state", "ready")
        bench.get_by_test_id("bench-done").click()
        expect(bench).to_have_count(0)
        # What it is built of is remembered; that the mission's program goes there as ever: server/test_bench.
        page.reload()
        expect(studio.at("code").locator(".cm-line").first).not_to_be_empty()
        page.keyboard.press("Alt+r")
        expect(kit).to_have_attribute("data-kit", "pico")
