"""A board at the reader's own computer, behind a port of the page: its MicroPython is sent to, runs, is lost.

Who else sees it: `tests/server/test_page_ports.py`; what the browser refuses: `web/src/features/robots/serial.test.ts`;
where it has no ports: `RobotPanel.test.tsx` beside it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from playwright.sync_api import Locator, expect

from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.line import Line
from tests.boards import qemu
from tests.boards.modern import ModernBoard, onboard_files
from tests.studio.conftest import Studio
from tests.studio.robot_rows import ACTIVE, OpenStudio, expect_robot
from tests.studio.serial_ports import MICROBIT, PICO, Bridge

pytestmark = pytest.mark.browser

DEPLOY_MS = 120_000
"""The emulator may be given little of a busy machine."""
RUNNING = 2
PACE = 3
"""Of the board's clock: a page that a busy computer keeps waiting is in time for a robot that is held."""
QUIET_S = 1.5 * PACE
"""Longer than a held robot goes on without a word."""
DRIVERS = {
    "display": "class Display:\n    def do(self, name, values):\n        pass\n    def stop(self):\n        pass\n",
    "key": "class Key:\n    def read(self):\n        return 0\n",
}
"""Drivers of one's own, beside the mission: a Pico has no such devices."""


def expect_stop_when_pulled(bridge: Bridge, address: str, robot: Locator) -> None:
    """Pulls the cable of a robot that runs held: the page says so, and the robot has stopped by itself."""
    bridge.pull()
    expect_robot(robot, phase="lost")
    expect(robot.get_by_test_id("robot-trouble")).to_contain_text("its motors stop within one second")
    line = Line(address)
    line.drain(QUIET_S, DEPLOY_MS / 1000)
    line.close()
    with connect(address) as there:
        assert there.hello.state != RUNNING


@contextmanager
def pico() -> Iterator[str]:
    """A current MicroPython; its address."""
    with ModernBoard({"lib/machine.py": onboard_files()["machine.py"]}, pace=PACE) as board:
        yield board.address


@contextmanager
def micro_bit() -> Iterator[str]:
    """The firmware of the micro:bit of 2016; its address."""
    with qemu.running() as board:
        yield board.address


def what_is_sent_runs_and_glows(studio: Studio, robot: Locator) -> None:
    # Nobody talks with it yet; with the only robot that there is, the key begins to.
    studio.page.keyboard.press("Control+F5")
    studio.built_of("")
    expect_robot(robot, state="running")
    expect(robot).to_contain_text("bytes free")
    expect(studio.page.locator(ACTIVE).first).to_be_visible()
    robot.get_by_test_id("robot-watch").click()
    expect(studio.at("watch-Count").locator("input")).to_have_value(re.compile("^[1-9]"))


def a_tab_that_the_browser_freezes_lets_it_go(studio: Studio, robot: Locator) -> None:
    # Chosen again it has the place that it had.
    studio.at("find-board").click()
    robot.get_by_test_id("robot-reconnect").click()
    expect_robot(robot, phase="open")
    studio.page.evaluate("document.dispatchEvent(new Event('freeze'))")
    expect_robot(robot, phase="lost")
    robot.get_by_test_id("robot-reconnect").click()
    expect(robot.get_by_test_id("robot-trouble")).to_contain_text("Choose the board again.")


@pytest.mark.parametrize(
    ("board", "vendor", "name", "drivers"),
    [
        pytest.param(pico, PICO, "Raspberry Pi Pico", DRIVERS, id="pico"),
        pytest.param(
            *(micro_bit, MICROBIT, "micro:bit", {}),
            id="micro:bit",
            marks=[
                pytest.mark.boards,
                pytest.mark.thorough("with a Pico above; what is sent to a micro:bit: boards/test_microbit.py"),
            ],
        ),
    ],
)
def test_a_board_at_the_page_is_sent_to_watched_and_stops_when_its_cable_is_pulled(
    pulse: OpenStudio, board, vendor: int, name: str, drivers: dict[str, str]
) -> None:
    with board() as address, Bridge(int(address.rsplit(":", 1)[1]), vendor) as bridge:
        studio = pulse(bypass_csp=True)
        for device, text in drivers.items():
            made = f"{text}\n\ndef make(settings):\n    return {device.capitalize()}()\n"
            (studio.folder / f"{device}.driver.py").write_text(made)
        bridge.give(studio.page)
        studio.page.keyboard.press("Alt+r")
        studio.at("find-board").click()
        robot = studio.at("robot")
        expect(robot.get_by_role("heading")).to_have_text(name)
        expect(robot.get_by_test_id("robot-at-page")).to_have_text("through this page")
        what_is_sent_runs_and_glows(studio, robot)
        expect_stop_when_pulled(bridge, address, robot)
        if board is micro_bit:  # in the thorough profile; without a board: web/src/features/robots/serial.test.ts
            a_tab_that_the_browser_freezes_lets_it_go(studio, robot)
