"""Where a MicroPython for the RP2040 and RP2350 keeps its files, by what the firmware says of itself.

Near its beginning a firmware has a header with the addresses of a table; that has the addresses of records. One of
them is MicroPython's own and says where the block device of its files is, so no list of boards is needed. Records that
lie in memory while it runs are found through the table of what is copied there. A MicroPython that shows its files as a
drive has them in FAT, and others in littlefs; its description for USB says that it does. Source: `pico/binary_info` of
the Pico SDK, and `ports/rp2/rp2_flash.c` and `main.c` of MicroPython.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.deploy.errors import FirmwareError
from kitrobot.deploy.firmware.requirements import EVERYWHERE
from kitrobot.deploy.firmware.uf2 import Firmware
from kitrobot.text.sentences import Sentence

FLASH = 0x10000000
"""The first address of the flash."""

SECTOR, PAGE = 4096, 256
"""Bytes that are erased at once, and that are written at once."""

_LARGEST_FLASH = 32 * 1024 * 1024
_SMALLEST_SECTORS = 8
_BEGINNING = 4096
"""Bytes among which the header is looked for."""

_HEADER = struct.Struct("<5I")
_MARKS = 0x7188EBF2, 0xE71AA390
_MOST_RECORDS = 4096
_BLOCK_DEVICE = struct.Struct("<2H3I")
_IS_BLOCK_DEVICE, _OF_MICROPYTHON = 7, int.from_bytes(b"MP", "little")
_USB_DRIVE = re.compile(rb"\x09\x04.\x00\x02\x08\x06\x50", re.DOTALL)
"""The interface of a drive in a description for USB: two endpoints, mass storage, SCSI, bulk only."""


@dataclass(frozen=True)
class FileStorage:
    """The part of the flash with the files: its first address and its bytes, both whole sectors."""

    start: int
    size: int

    @property
    def sectors(self) -> int:
        """How many sectors there are."""
        return self.size // SECTOR


@dataclass(frozen=True)
class FlashContent:
    """What a firmware puts into the flash.

    Args:
        pages: bytes by their addresses, whole pages.
        family: of its chips, as UF2 has it.
        before: whole blocks of its file that stand in front and belong to no chip.
    """

    pages: Mapping[int, bytes]
    family: int
    before: bytes

    def bytes_at(self, address: int, size: int) -> bytes:
        """Those bytes; as far as the firmware has them."""
        first = address - address % PAGE
        found = b"".join(self.pages.get(at, b"") for at in range(first, address + size, PAGE))
        return found[address - first : address - first + size]


def flash_content(firmware: Firmware, families: Mapping[int, str]) -> FlashContent:
    """What goes into the flash of a firmware for one chip of `families`.

    Raises:
        FirmwareError: it is for several chips or none of these, or puts something where no flash is.
    """
    ours = [one for one in firmware.blocks if one.family in families]
    if len({one.family for one in ours}) != 1:
        raise unknown_firmware(firmware)
    pages = {one.address: one.payload for one in ours}
    whole = all(at % PAGE == 0 and len(page) == PAGE for at, page in pages.items())
    if not whole or len(pages) != len(ours) or min(pages) < FLASH or max(pages) >= FLASH + _LARGEST_FLASH:
        raise unknown_firmware(firmware)
    before = b"".join(one.raw for one in firmware.blocks if one.family not in families)
    return FlashContent(pages, ours[0].family, before)


def unknown_firmware(firmware: Firmware) -> FirmwareError:
    """The error of a firmware that does not say where its files are."""
    return FirmwareError(
        Sentence("KitRobot does not know where the firmware `{file}` keeps its files", firmware.name),
        Sentence(
            "fetch MicroPython for a board with an RP2040 or RP2350 from {href}; other boards get their program over "
            "a cable",
            EVERYWHERE,
        ),
    )


def storage_of(firmware: Firmware, content: FlashContent) -> FileStorage:
    """Where a firmware keeps its files.

    Raises:
        FirmwareError: it does not say, or what it says cannot be.
    """
    for address in _records(content):
        record = content.bytes_at(address, _BLOCK_DEVICE.size)
        if len(record) < _BLOCK_DEVICE.size:
            continue
        kind, tag, _, start, size = _BLOCK_DEVICE.unpack(record)
        if (kind, tag) != (_IS_BLOCK_DEVICE, _OF_MICROPYTHON):
            continue
        aligned = start % SECTOR == 0 and size % SECTOR == 0 and size >= _SMALLEST_SECTORS * SECTOR
        if aligned and start >= FLASH and start + size <= FLASH + _LARGEST_FLASH:
            storage = FileStorage(start, size)
            _refuse_other_files(firmware, content, storage)
            return storage
    raise unknown_firmware(firmware)


def _refuse_other_files(firmware: Firmware, content: FlashContent, storage: FileStorage) -> None:
    if _USB_DRIVE.search(b"".join(content.pages[at] for at in sorted(content.pages))):
        raise FirmwareError(
            Sentence("the firmware `{file}` shows its files as a drive, and has them in another form", firmware.name),
            Sentence("send the program over a cable, or take a MicroPython for the board from {href}", EVERYWHERE),
        )
    if any(storage.start <= at < storage.start + storage.size for at in content.pages):
        raise FirmwareError(
            Sentence(
                "the firmware `{file}` brings files of its own along, which a program would replace", firmware.name
            ),
            Sentence("name the MicroPython alone, as it was fetched from its maker"),
        )


def _records(content: FlashContent) -> list[int]:
    """The addresses of records in the flash."""
    begin = min(content.pages)
    text = content.bytes_at(begin, _BEGINNING)
    for at in range(0, len(text) - _HEADER.size + 1, 4):
        first, table, end, copied, last = _HEADER.unpack_from(text, at)
        if (first, last) == _MARKS:
            moved = _moved(content, copied)
            size = min(max(end - table, 0), 4 * _MOST_RECORDS)
            data = content.bytes_at(_in_flash(table, moved), size)
            words = struct.unpack(f"<{len(data) // 4}I", data[: len(data) // 4 * 4])
            return [_in_flash(word, moved) for word in words]
    return []


def _moved(content: FlashContent, table: int) -> list[tuple[int, int, int]]:
    """What is copied into memory: from where in the flash, to where, and up to where there."""
    found: list[tuple[int, int, int]] = []
    while len(found) < _MOST_RECORDS:
        row = content.bytes_at(table, 12)
        table += 12
        if len(row) < 12 or not row[:4].strip(b"\0"):
            break
        found.append(struct.unpack("<3I", row))
    return found


def _in_flash(address: int, moved: list[tuple[int, int, int]]) -> int:
    return next((source + address - to for source, to, end in moved if to <= address < end), address)
