"""What a board starts: the newer line whose program file is whole, and nothing when there is none."""

from __future__ import annotations

import builtins
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import IO, Any

import pytest

from kitrobot.deploy.installation.boot_records import TRIAL, UNTRIED, StartLine, tried_generation
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.onboard_bundle import module_names
from kitrobot.deploy.package.package import Package
from kitrobot_onboard.link import checksum

OLD = b"0003a=1the old program"
NEW = b"0003a=2" + bytes(range(256)) * 3


@pytest.fixture
def flash(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A board's files, with two installations, of which the one in `kr0` is newer."""
    monkeypatch.setitem(
        sys.modules, "micropython", SimpleNamespace(opt_level=lambda level: None, kbd_intr=lambda sign: None)
    )
    monkeypatch.setitem(sys.modules, "utime", SimpleNamespace(sleep_ms=lambda ms: None))
    (tmp_path / "kpold").write_bytes(OLD)
    (tmp_path / "kpnew").write_bytes(NEW)
    (tmp_path / "kr0").write_bytes(StartLine(10, "krnew", "kpnew", checksum(NEW)).to_bytes())
    (tmp_path / "kr1").write_bytes(StartLine(9, "krold", "kpold", checksum(OLD)).to_bytes())
    return tmp_path


def chosen(folder: Path) -> tuple[str, int]:
    """Program and generation, as the board's own `krboot` finds them."""

    def opened(name: str, mode: str = "r") -> IO[Any]:
        return builtins.open(folder / name, mode)

    space: dict[str, Any] = {"open": opened}
    exec(Package().build("machine", {}, COMPILED_LOOP).files["krboot.py"], space)
    return space[module_names().get("program", "program")], space[module_names().get("generation", "generation")]


def test_the_newer_line_counts(flash: Path) -> None:
    assert chosen(flash) == ("kpnew", 10)


def test_with_nothing_there_nothing_is_chosen(flash: Path) -> None:
    for name in ("kr0", "kr1"):
        (flash / name).unlink()
    assert chosen(flash)[0] == ""


@pytest.mark.parametrize("where", [0, 5, 100, 400, -1])
def test_a_damaged_program_file_is_passed_over(flash: Path, where: int) -> None:
    data = bytearray(NEW)
    data[where] ^= 4
    (flash / "kpnew").write_bytes(data)
    assert chosen(flash) == ("kpold", 9)


@pytest.mark.parametrize("end", [0, 3, 64, len(NEW) - 1])
def test_a_cut_program_file_is_passed_over(flash: Path, end: int) -> None:
    (flash / "kpnew").write_bytes(NEW[:end])
    assert chosen(flash) == ("kpold", 9)


def test_a_program_file_that_is_gone_is_passed_over(flash: Path) -> None:
    (flash / "kpnew").unlink()
    assert chosen(flash) == ("kpold", 9)


def test_a_line_that_is_not_whole_is_passed_over(flash: Path) -> None:
    line = (flash / "kr0").read_bytes()
    for end in range(len(line) - 1):
        (flash / "kr0").write_bytes(line[:end])
        assert chosen(flash) == ("kpold", 9), end
    for at in range(len(line) - 1):
        (flash / "kr0").write_bytes(line[:at] + bytes((line[at] ^ 2,)) + line[at + 1 :])
        assert chosen(flash) == ("kpold", 9), at


def test_what_is_on_trial_starts_once_and_the_one_before_from_then_on(flash: Path) -> None:
    (flash / TRIAL).write_bytes(UNTRIED)
    assert chosen(flash) == ("kpnew", 10)
    assert tried_generation((flash / TRIAL).read_bytes()) == 10
    for _ in range(3):
        assert chosen(flash) == ("kpold", 9)
        assert tried_generation((flash / TRIAL).read_bytes()) == 10


def test_what_was_confirmed_starts_again_and_again(flash: Path) -> None:
    (flash / TRIAL).write_bytes(UNTRIED)
    assert chosen(flash) == ("kpnew", 10)
    (flash / TRIAL).unlink()
    for _ in range(3):
        assert chosen(flash) == ("kpnew", 10)
        assert not (flash / TRIAL).exists()


def test_a_first_program_that_was_never_confirmed_leaves_the_prompt_free(flash: Path) -> None:
    (flash / "kr1").unlink()
    (flash / TRIAL).write_bytes(UNTRIED)
    assert chosen(flash)[0] == "kpnew"
    assert chosen(flash)[0] == ""


@pytest.mark.parametrize("left", [b"", b"1", b"10"])
def test_power_that_is_cut_while_a_trial_is_written_down_makes_one_more(flash: Path, left: bytes) -> None:
    (flash / TRIAL).write_bytes(left)
    assert chosen(flash) == ("kpnew", 10)
    assert chosen(flash) == ("kpold", 9)


def test_the_trial_of_a_line_that_never_became_whole_holds_up_no_other(flash: Path) -> None:
    (flash / TRIAL).write_bytes(b"11\n")
    assert chosen(flash) == ("kpnew", 10)
