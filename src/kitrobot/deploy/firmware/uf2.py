"""Firmware in UF2 files, and the drives that boards show to take it: a file that is copied there is on the board.

All of a file is checked before the first byte is copied, since a board that is given half a firmware starts nothing. A
drive has `INFO_UF2.TXT`, which names the board.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from kitrobot.deploy.errors import DeployError
from kitrobot.diagnostics.regular import open_regular
from kitrobot.files.uf2_file import LARGEST_BYTES, Uf2Block, Uf2Error, read_uf2
from kitrobot.text.sentences import COMMA, Sentence, Series

INFO = "INFO_UF2.TXT"
SUFFIX = ".uf2"
_MOST_INFO = 4096
_PIECE = 64 * 1024
FAMILIES_OF_CHIPS = {
    0xE48BFF56: "RP2040",
    0xE48BFF59: "RP2350",
    0xE48BFF5A: "RP2350",
    0xE48BFF5B: "RP2350",
    0xBFDD4EEE: "ESP32-S2",
    0xC47E5767: "ESP32-S3",
    0x68ED2B88: "SAMD21",
    0x55114460: "SAMD51",
    0xADA52840: "nRF52840",
    0x621E937A: "nRF52833",
}
"""What a family's number means."""

_CHIPS_OF_BOARDS = (("RPI-RP2", "RP2040"), ("RP2350", "RP2350"))
"""How the board's name begins → its chip."""

_VERSION = re.compile(rb"MicroPython v([0-9]{1,2}\.[0-9]{1,3}(?:\.[0-9]{1,3})?(?:-preview)?)")


class FlashError(DeployError):
    """A firmware is none, or cannot be put on the board."""


@dataclass(frozen=True)
class Firmware:
    """A file of firmware that is whole. `chips`: for which; `micropython`: its version, "" where none was found;
    `blocks`: what goes where in the flash.
    """

    name: str
    data: bytes
    blocks: tuple[Uf2Block, ...]
    chips: tuple[str, ...]
    micropython: str


@dataclass(frozen=True)
class Drive:
    """A drive that takes firmware; `board` as it names itself, `chip` "" where that says nothing."""

    folder: Path
    board: str
    chip: str


def read_firmware(path: Path) -> Firmware:
    """A UF2 file.

    Raises:
        FlashError: it cannot be read, or is not whole.
    """
    try:
        with open_regular(path) as stream:
            data = stream.read(LARGEST_BYTES + 1)
    except OSError as error:
        raise FlashError(
            Sentence("`{path}` cannot be read: {reason}", path, error.strerror or str(error)),
            Sentence("name the UF2 file that you fetched from the maker of the board"),
        ) from None
    return firmware_of(data, path.name)


def firmware_of(data: bytes, name: str) -> Firmware:
    """A UF2 file's bytes.

    Raises:
        FlashError: it is not whole.
    """
    try:
        blocks = read_uf2(data, name).blocks
    except Uf2Error as error:
        raise _refused(name, error.reason) from None
    chips = dict.fromkeys(FAMILIES_OF_CHIPS[one.family] for one in blocks if one.family in FAMILIES_OF_CHIPS)
    version = _VERSION.search(b"".join(one.payload for one in blocks))
    return Firmware(name, data, blocks, tuple(chips), version[1].decode() if version else "")


def _refused(name: str, why: Sentence) -> FlashError:
    return FlashError(
        Sentence("`{file}` is no firmware that can be copied to a board: {reason}", name, why),
        Sentence("fetch it once more from the maker of the board; it is a file that ends in .uf2"),
    )


def drive_at(folder: Path) -> Drive | None:
    """The drive of a board that is at that folder; None where there is none."""
    try:
        with open_regular(folder / INFO) as stream:
            text = stream.read(_MOST_INFO).decode("ascii", errors="replace")
    except OSError:
        return None
    fields = dict(line.partition(":")[::2] for line in text.splitlines() if ":" in line)
    board = fields.get("Board-ID", fields.get("Model", "")).strip()[:80]
    chip = next((chip for begin, chip in _CHIPS_OF_BOARDS if board.startswith(begin)), "")
    return Drive(folder, board, chip)


def drives() -> list[Drive]:
    """The drives of boards that this computer shows now."""
    return [found for folder in sorted(set(_mounted())) if (found := drive_at(folder)) is not None]


def _mounted() -> Iterator[Path]:
    if sys.platform == "win32":
        yield from (Path(f"{letter}:/") for letter in "DEFGHIJKLMNOPQRSTUVWXYZ")
        return
    user = os.environ.get("USER", "")
    for parent in (Path("/Volumes"), Path("/media"), Path("/media", user), Path("/run/media", user), Path("/mnt")):
        try:
            yield from parent.iterdir()
        except OSError:
            continue


def drive_shown(folder: str) -> Drive:
    """The drive of a board at that folder, one of those that this computer shows.

    Raises:
        FlashError: there is none.
    """
    found = next((one for one in drives() if str(one.folder) == folder), None)
    if found is None:
        raise FlashError(
            Sentence("the board’s drive is gone"),
            Sentence("hold its button BOOTSEL (or press RESET twice) while you plug it in again"),
        )
    return found


def chosen_drive(folder: Path | None) -> Drive:
    """The drive at that folder; without one, the only one that there is.

    Raises:
        FlashError: there is none, or there are several.
    """
    way = Sentence("hold the button BOOTSEL (or press RESET twice) while you plug the board in; then it shows a drive")
    if folder is not None:
        found = drive_at(folder)
        if found is None:
            raise FlashError(
                Sentence("`{folder}` is no drive of a board: it has no `{file}`", folder, INFO),
                way,
            )
        return found
    there = drives()
    if len(there) == 1:
        return there[0]
    if not there:
        raise FlashError(Sentence("no board shows a drive that takes firmware"), way)
    names = Series(COMMA, (f"`{one.folder}` ({one.board})" for one in there))
    raise FlashError(Sentence("several boards may be meant: {names}", names), Sentence("choose with --drive"))


def flash(firmware: Firmware, drive: Drive, report: Callable[[int, int], None] = lambda done, total: None) -> None:
    """Copies a firmware to a drive; the board restarts with it. `report`: how many bytes of how many are copied.

    Raises:
        FlashError: it is for another chip, or the drive does not take it.
    """
    if drive.chip and firmware.chips and drive.chip not in firmware.chips:
        raise FlashError(
            Sentence("the firmware is for {chips}, and the board has {chip}", _listed(firmware.chips), drive.chip),
            Sentence("fetch the one for your board"),
        )
    done, total = 0, len(firmware.data)
    try:
        with open(drive.folder / f"FIRMWARE{SUFFIX.upper()}", "wb", buffering=0) as file:
            while done < total:
                done += file.write(firmware.data[done : done + _PIECE])
                report(done, total)
            os.fsync(file.fileno())
    except OSError as error:
        # A board that has all of it restarts, and its drive is gone before the file is closed.
        if done < total:
            raise FlashError(
                Sentence(
                    "after {done} of {total} bytes the board took no more: {reason}",
                    done,
                    total,
                    error.strerror or str(error),
                ),
                Sentence("plug it in once more with its button held, then run the command again"),
            ) from None


def _listed(names: Iterable[str]) -> Series:
    return Series(COMMA, names)
