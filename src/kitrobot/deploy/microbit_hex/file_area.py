"""The file system of MicroPython for the micro:bit, as bytes of flash.

It consists of pieces of 128 bytes, numbered from 1. The first byte of a piece is 254 for the start of a file, else the
number of the piece before it; the last one is the number of the next, or 255. A file's first piece goes on with where
its last one ends, the length of its name, and the name. The last page of the area is spare; its first byte says so.
Source: `microbitfs.c` of MicroPython for the micro:bit, the same for both boards.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.deploy.errors import FirmwareError, FullError
from kitrobot.deploy.microbit_2016.flash_code import CHUNK
from kitrobot.text.sentences import Sentence

_START, _UNUSED, _SPARE = 0xFE, 0xFF, 0xFD
_DATA = CHUNK - 2
_MOST = 252
"""Pieces that have a number."""

_REGISTERS = 0x100010C0
_REGISTERS_MARK = 0x17EEB07C
_END_2016 = 0x40000
_TABLE = struct.Struct("<IHHHHI")
_TABLE_MARKS = 0x597F30FE, 0xC1B1D79D
_ROW = struct.Struct("<BBHIQ")
_FILES_ROW = 3


@dataclass(frozen=True)
class FileArea:
    """Where the file system is: its first address, that of its spare page, and the bytes of a page."""

    start: int
    spare: int
    page: int

    @property
    def room(self) -> int:
        """How many pieces there are."""
        return (self.spare - self.start) // CHUNK


def area_of_firmware(memory: Mapping[int, bytes]) -> FileArea:
    """Where a MicroPython has its files: in a board of 2016 its registers say it, in a V2 a table behind its code.

    Raises:
        FirmwareError: it is no MicroPython for a micro:bit.
    """
    for start, content in memory.items():
        if start <= _REGISTERS < start + len(content) - 16:
            mark, _, page, _, pages = struct.unpack_from("<IIIHH", content, _REGISTERS - start)
            if mark == _REGISTERS_MARK and page == 10:
                # The page behind the spare one is the compass's.
                return _area(pages << page, _END_2016 - (1 << page), 1 << page)
        at = content.find(struct.pack("<I", _TABLE_MARKS[0]))
        if at >= 0 and at + _TABLE.size <= len(content):
            _, _, _, rows, page, last = _TABLE.unpack_from(content, at)
            if last == _TABLE_MARKS[1] and rows * _ROW.size <= at and page == 12:
                for number in range(1, rows + 1):
                    row, _, first, size, _ = _ROW.unpack_from(content, at - number * _ROW.size)
                    if row == _FILES_ROW:
                        return _area(first << page, (first << page) + size, 1 << page)
    raise FirmwareError(
        Sentence("the MicroPython for the micro:bit that is installed here is none that KitRobot knows"),
        Sentence("install `micropython-microbit-fs` anew, in a version that KitRobot asks for"),
    )


def _area(start: int, end: int, page: int) -> FileArea:
    return FileArea(max(start, end - _MOST * CHUNK), end - page, page)


def build_area(area: FileArea, files: Mapping[str, bytes], block: bytes = b"") -> bytes:
    """All bytes of the area, with the spare page.

    Args:
        area: where it will be.
        files: by their names.
        block: whole pieces that belong to no file, in front.

    Raises:
        FullError: there is no room for all.
    """
    needed = len(block) // CHUNK + sum(pieces_of_file(name, content) for name, content in files.items())
    if needed > area.room:
        raise FullError(
            Sentence(
                "the program takes {needed} bytes of the board's flash, which has {free}; nothing was written",
                needed * CHUNK,
                area.room * CHUNK,
            ),
            Sentence("make the program smaller, or use fewer devices in it"),
        )
    data = bytearray(b"\xff") * (area.spare + area.page - area.start)
    data[: len(block)] = block
    data[area.spare - area.start] = _SPARE
    place = 1 + len(block) // CHUNK
    for name, content in files.items():
        count = pieces_of_file(name, content)
        _put_file(data, name.encode(), content, place, count)
        place += count
    return bytes(data)


def pieces_of_file(name: str, content: bytes) -> int:
    """How many pieces a file has; one that fills its last piece has an empty one behind it."""
    return (2 + len(name.encode()) + len(content)) // _DATA + 1


def _put_file(data: bytearray, name: bytes, content: bytes, first: int, count: int) -> None:
    text = bytes(((2 + len(name) + len(content)) % _DATA, len(name))) + name + content
    for place in range(first, first + count):
        at = (place - 1) * CHUNK
        piece = text[:_DATA].ljust(_DATA, b"\xff")
        text = text[_DATA:]
        before = _START if place == first else place - 1
        after = _UNUSED if place == first + count - 1 else place + 1
        data[at : at + CHUNK] = bytes((before, *piece, after))
