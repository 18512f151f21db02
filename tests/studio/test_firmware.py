"""MicroPython in the panel of robots: what a kit needs, and a file copied to a board that shows a drive."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from kitrobot.deploy.firmware import uf2
from tests.deploy.test_firmware import INFO, whole
from tests.deploy.uf2_firmware import RP2350
from tests.studio.conftest import Studio
from tests.studio.looks import find_nothing
from tests.studio.test_variables import forgive_refusals

pytestmark = pytest.mark.browser


@pytest.mark.thorough(
    "web/src/features/robots/RobotPanel.test.tsx and Firmware.test.tsx; tests/server/test_firmware.py: a drive is "
    "listed and takes a file"
)
def test_a_file_is_copied_to_a_board_and_the_kit_says_what_it_needs(
    open_studio: Callable[..., Studio], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folders: list[Path] = []
    monkeypatch.setattr(uf2, "_mounted", lambda: iter(folders))
    studio = open_studio("square/square.krt")
    studio.page.keyboard.press("Alt+r")
    studio.at("robots-address").fill("socket://127.0.0.1:1")
    studio.page.keyboard.press("Enter")
    studio.at("robot-kit").click()
    studio.built_of("xrp")
    expect(studio.at("robot-need")).to_contain_text("Needs MicroPython 1.25 or later.")
    expect(studio.at("robot-need").get_by_role("link")).to_have_attribute(
        "href", "https://micropython.org/download/SPARKFUN_XRP_CONTROLLER/"
    )
    studio.at("robot-kit").click()
    studio.built_of("maqueen")
    expect(studio.at("robot-need")).to_have_count(0)
    studio.at("firmware-open").click()
    expect(studio.at("firmware-none")).to_be_visible()
    find_nothing(studio, "no drive")
    drive = tmp_path / "RPI-RP2"
    drive.mkdir()
    (drive / "INFO_UF2.TXT").write_text(INFO, encoding="ascii")
    folders.append(drive)
    studio.at("firmware-look").click()
    expect(studio.at("firmware-drive")).to_have_text("RPI-RP2 · RP2040")
    expect(studio.at("firmware-copy")).to_be_disabled()
    for name, data in (("wrong.uf2", whole(RP2350)), ("pico.uf2", whole())):
        (tmp_path / name).write_bytes(data)
    studio.at("firmware-file").set_input_files(tmp_path / "wrong.uf2")
    studio.at("firmware-copy").click()
    expect(studio.at("firmware-trouble")).to_contain_text("is for RP2350, and the board has RP2040")
    studio.at("firmware-file").set_input_files(tmp_path / "pico.uf2")
    studio.at("firmware-copy").click()
    expect(studio.at("firmware-done")).to_contain_text("MicroPython 1.27.0 is on the board")
    assert (drive / "FIRMWARE.UF2").read_bytes() == whole()
    find_nothing(studio, "copied")
    forgive_refusals(studio)
