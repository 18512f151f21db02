"""QEMU and the firmware of the board tests: found, installed where that may be done, else said in one line."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.packaging.test_chromium import add_program
from tools import qemu


@pytest.fixture
def programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The only folder on the PATH, still empty; the firmware is in it as well, when it is anywhere."""
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("KITROBOT_QEMU", raising=False)
    monkeypatch.setenv("KITROBOT_FIRMWARE", str(tmp_path / "firmware.hex"))
    return tmp_path


def test_both_are_found(programs: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program = add_program(programs, "qemu-system-arm")
    firmware = add_program(programs, "firmware.hex", "")
    assert qemu.main([]) == 0
    assert capsys.readouterr().out == f"{program} {firmware}\n"


@pytest.mark.parametrize("one", ["qemu-system-arm", "firmware.hex"])
def test_one_of_them_is_not_enough(programs: Path, one: str, capsys: pytest.CaptureFixture[str]) -> None:
    add_program(programs, one)
    assert qemu.main([]) == 1
    assert capsys.readouterr().out == ""


def test_where_they_may_not_be_installed_one_line_says_what_is_left_out(
    programs: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    add_program(programs, "apt-get")
    monkeypatch.setattr("os.geteuid", lambda: 1000)
    assert qemu.main(["--install"]) == 0
    assert capsys.readouterr().out == (
        "board tests left out: no QEMU with a micro:bit (only root may install it); install qemu-system-arm and"
        " firmware-microbit-micropython\n"
    )


def test_root_installs_both_with_apt(programs: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    said = programs / "said"
    add_program(programs, "apt-get", f'#!/bin/sh\necho "$@" >> {said}\n')
    monkeypatch.setattr("os.geteuid", lambda: 0)
    assert qemu.main(["--install"]) == 0
    assert "qemu-system-arm firmware-microbit-micropython" in said.read_text()
