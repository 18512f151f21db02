"""Firmware: UF2 files and the drives that take them, and the least version of a kit."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from kitrobot.deploy.errors import BoardError, FirmwareError
from kitrobot.deploy.firmware.requirements import FirmwareRequirements
from kitrobot.deploy.firmware.uf2 import (
    Drive,
    FlashError,
    chosen_drive,
    drive_at,
    firmware_of,
    flash,
    read_firmware,
)
from kitrobot.files.uf2_file import BLOCK, LARGEST_BYTES
from tests.deploy.uf2_firmware import ABSOLUTE, RP2040, RP2350, block

INFO = "UF2 Bootloader v3.0\nModel: Raspberry Pi RP2\nBoard-ID: RPI-RP2\n"


def whole(family: int = RP2040, text: bytes = b"MicroPython v1.27.0 on 2026-01-01") -> bytes:
    pieces = [b"\0" * 250 + text[:6], text[6:].ljust(256, b"\0"), b"\1" * 256]
    return b"".join(block(place, 3, piece, family) for place, piece in enumerate(pieces))


def test_a_firmware_says_its_chip_and_its_version_which_may_lie_across_blocks() -> None:
    found = firmware_of(whole(), "a.uf2")
    assert (found.chips, found.micropython) == (("RP2040",), "1.27.0")
    assert firmware_of(whole(text=b"something"), "a.uf2").micropython == ""
    with_absolute = block(0, 2, family=ABSOLUTE) + whole(RP2350)
    assert firmware_of(with_absolute, "a.uf2").chips == ("RP2350",)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda data: b"", "does not begin as"),
        (lambda data: b"PK\3\4" + data, "does not begin as"),
        (lambda data: data[:-1], "cut off in its block 3"),
        (lambda data: data[:BLOCK], "2 of its 3 blocks are missing"),
        (lambda data: data[BLOCK:], "1 of its 3 blocks are missing"),
        (lambda data: data[: BLOCK + 4] + b"\0" + data[BLOCK + 5 :], "block 2 is damaged"),
        (lambda data: data[: 2 * BLOCK - 1] + b"\7" + data[2 * BLOCK :], "block 2 is damaged"),
        (lambda data: data + data[:BLOCK], "block 4 does not fit"),
        (lambda data: data + block(3, 9), "block 4 does not fit"),
        (lambda data: block(3, 3) + data, "block 1 says what cannot be"),
        (lambda data: block(0, 3, size=477) + data[BLOCK:], "block 1 says what cannot be"),
    ],
)
def test_a_file_that_is_not_whole_is_refused_with_its_place(change: Callable[[bytes], bytes], says: str) -> None:
    with pytest.raises(FlashError) as refused:
        firmware_of(change(whole()), "a.uf2")
    assert says in refused.value.message
    assert refused.value.help


def test_a_file_that_is_too_large_missing_or_a_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FlashError, match="more than"):
        firmware_of(b"\0" * (LARGEST_BYTES + 1), "a.uf2")
    for path in (tmp_path / "none.uf2", tmp_path):
        with pytest.raises(FlashError, match="cannot be read"):
            read_firmware(path)


def test_a_drive_is_a_folder_that_says_its_board_and_takes_what_is_for_its_chip(tmp_path: Path) -> None:
    assert drive_at(tmp_path) is None
    with pytest.raises(FlashError, match="no drive of a board"):
        chosen_drive(tmp_path)
    (tmp_path / "INFO_UF2.TXT").write_text(INFO)
    drive = chosen_drive(tmp_path)
    assert drive == Drive(tmp_path, "RPI-RP2", "RP2040")
    told: list[tuple[int, int]] = []
    flash(firmware_of(whole(), "a.uf2"), drive, lambda done, total: told.append((done, total)))
    assert (tmp_path / "FIRMWARE.UF2").read_bytes() == whole()
    assert told[-1] == (len(whole()), len(whole()))
    with pytest.raises(FlashError, match="for RP2350, and the board has RP2040"):
        flash(firmware_of(whole(RP2350), "a.uf2"), drive)


def test_a_drive_that_says_nothing_useful_takes_any_firmware_and_one_that_breaks_is_told(tmp_path: Path) -> None:
    (tmp_path / "INFO_UF2.TXT").write_bytes(b"\xff\0no colon here\n")
    drive = chosen_drive(tmp_path)
    assert (drive.board, drive.chip) == ("", "")
    flash(firmware_of(whole(RP2350), "a.uf2"), drive)
    with pytest.raises(FlashError, match="after 0 of 1536 bytes"):
        flash(firmware_of(whole(), "a.uf2"), Drive(tmp_path / "gone", "", ""))


@pytest.mark.parametrize(
    ("has", "least"),
    [
        ("1.20.0", "1.20"),
        ("1.29.0", "1.20"),
        ("1.20.1", "1.20.1"),
        ("1.24.10", "1.24.9"),
        ("2.0.0", "1.20.1"),
        ("1.25.0", "1.25.0-preview"),
        ("1.25.1-preview", "1.25"),
        ("1.9.2", ""),
    ],
)
def test_a_board_with_the_least_version_or_a_later_one_is_taken(has: str, least: str) -> None:
    FirmwareRequirements("k", least).refuse_older(has)


@pytest.mark.parametrize(
    ("has", "least"),
    [
        ("1.19.1", "1.20"),
        ("1.9.2", "1.20"),
        ("1.24.0", "1.24.1"),
        ("1.25.0-preview", "1.25"),
        ("1.20.0", "2.0"),
    ],
)
def test_a_board_with_an_older_version_is_refused_with_the_way_to_a_newer_one(has: str, least: str) -> None:
    with pytest.raises(BoardError) as refused:
        FirmwareRequirements("k", least, "https://example.org/firmware").refuse_older(has)
    assert f"MicroPython {has}" in refused.value.message
    assert "https://example.org/firmware" in refused.value.help


@pytest.mark.parametrize(
    ("kit", "platform", "words"),
    [
        (
            FirmwareRequirements("pico", "1.20", "", "machine", "rp2040"),
            "microbit",
            "is for a board such as the Raspberry Pi Pico",
        ),
        (FirmwareRequirements("pico", "1.20", "", "machine", "rp2350"), "esp32", "this board is an ESP32"),
        (FirmwareRequirements("cutebot", "", "", "microbit"), "rp2", "is for a micro:bit"),
        (
            FirmwareRequirements("own", "", "", "machine"),
            "microbit",
            "is for another kind of board, and this board is a micro:bit",
        ),
        (FirmwareRequirements("pico", "1.20", "", "machine", "rp2040"), "rp2", ""),
        (FirmwareRequirements("cutebot", "", "", "microbit"), "microbit", ""),
        (FirmwareRequirements("own", "", "", "machine"), "esp32", ""),
        (FirmwareRequirements("pico", "1.20", "", "machine", "rp2040"), "webassembly", ""),
    ],
)
def test_a_kit_of_another_kind_of_board_is_refused_before_its_firmware_is_looked_at(
    kit: FirmwareRequirements, platform: str, words: str
) -> None:
    if not words:
        return kit.refuse_other_board(platform)
    with pytest.raises(FirmwareError) as error:
        kit.refuse_other_board(platform)
    assert words in error.value.message
    assert "--board" in error.value.help
