"""A studio in a process of its own, and a mission of one Wait whose duration is edited."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from playwright.sync_api import BrowserContext, Page, expect

from tests.patience import PATIENCE_S
from tests.studio.studio_page import Studio

MISSION = """<kitrobot version="1">
  <program name="blink" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wait"><set name="duration">{}</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="blink"/>
  </team>
</kitrobot>
"""
Start = Callable[..., "Server"]


class Server:
    """A studio's process and its address."""

    def __init__(self, target: Path, state: Path) -> None:
        command = [sys.executable, "-m", "kitrobot", "studio", str(target), "--no-browser", "--port", "0"]
        self.process = subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            env={**os.environ, "KITROBOT_STATE": str(state)},
        )
        assert self.process.stdout is not None
        found = re.search(r"http://\S+", self.process.stdout.readline())
        assert found is not None
        self.address = found.group(0)

    def open(self, context: BrowserContext) -> Page:
        """A new tab of the studio."""
        page = context.new_page()
        page.goto(self.address)
        expect(page.get_by_test_id("canvas")).to_be_visible()
        return page

    def kill(self) -> None:
        """Ends it as a power cut would."""
        self.process.kill()
        self.process.wait(PATIENCE_S)
        assert self.process.stdout is not None
        self.process.stdout.close()


def another_tab(studio: Studio) -> Page:
    """A new tab on the same studio."""
    page = studio.page.context.new_page()
    page.goto(studio.address)
    expect(page.get_by_test_id("canvas")).to_be_visible()
    return page


def wait_for(page: Page, value: int) -> None:
    """Sets the duration of the one Wait, in tenths of a second."""
    page.locator(".vertex", has_text="Wait").first.click()
    page.get_by_test_id("inspector").locator('input:not([type="range"])').first.fill(f"{value / 10} s")
    page.keyboard.press("Enter")
    expect(page.get_by_test_id("code")).to_contain_text(f"WAIT({value})")


def expect_wait(page: Page, value: int) -> None:
    expect(page.get_by_test_id("code")).to_contain_text(f"WAIT({value})")


def edit_and_keep(page: Page, value: int) -> None:
    with page.expect_response(re.compile("/api/journal$")):
        wait_for(page, value)
