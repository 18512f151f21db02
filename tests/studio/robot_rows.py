"""Robots in the studio's panel, as tests find and run them there."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from playwright.sync_api import Locator, expect

from tests.boards.host import HostBoard, write_pulse
from tests.studio.studio_page import Studio

OpenStudio = Callable[..., Studio]
ACTIVE = ".vertex.is-active"


def write_quick_pulse(folder: Path, broken: bool = False) -> Path:
    """The mission `pulse` with short waits, for its robots go at a tenth of their pace; and its robot, as files."""
    mission = write_pulse(folder, broken)
    mission.write_text(mission.read_text().replace('<set name="duration">3</set>', '<set name="duration">1</set>'))
    return mission


def connect(studio: Studio, robot: HostBoard) -> Locator:
    """Greets a robot on the network; its place in the panel."""
    if not studio.at("robots").is_visible():
        studio.page.keyboard.press("Alt+r")
    studio.at("robots-address").fill(robot.address)
    studio.page.keyboard.press("Enter")
    found = studio.page.locator(f'[data-testid="robot"][data-address="{robot.address}"]')
    expect_robot(found, phase="open")
    return found


def again(studio: Studio, robot: HostBoard) -> Locator:
    """Loads the page again and opens the panel; the robot's place there."""
    studio.page.reload()
    expect(studio.page.locator('[data-testid="code"] .cm-line').first).not_to_be_empty()
    studio.page.keyboard.press("Alt+r")
    return studio.page.locator(f'[data-testid="robot"][data-address="{robot.address}"]')


def expect_robot(robot: Locator, **states: str) -> None:
    """Waits for states of a robot: each look of `expect` would describe the whole page, and sending takes many."""
    for name, value in states.items():
        robot.locator(f'[data-testid="robot-state"][data-{name}="{value}"]').wait_for()


def run_anew(robot: Locator) -> None:
    robot.get_by_test_id("robot-stop").click()
    expect_robot(robot, state="ready")
    robot.get_by_test_id("robot-run").click()
    expect_robot(robot, state="running")
