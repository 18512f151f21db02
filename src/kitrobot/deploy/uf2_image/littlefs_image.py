"""A new file system for MicroPython in flash: littlefs, version 2.0, whose only folder holds all files.

The first two sectors are the root folder, twice, of which the one with the larger number counts: whatever was in them
before is gone. A folder is a log of entries: a tag of 32 bits, written as its difference (XOR) from the one before, and
its data; a sum closes the log. A file's sectors are linked from the last to the first. Version 2.0 is read by every
MicroPython; later ones go on with it. Source: `SPEC.md` of littlefs. Tests read it with the library itself.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator, Mapping

from kitrobot.deploy.errors import FullError
from kitrobot.deploy.uf2_image.file_storage import PAGE, SECTOR, FileStorage
from kitrobot.text.sentences import Sentence

_VERSION = 0x00020000
_LARGEST_NAME, _LARGEST_FILE, _LARGEST_ATTRIBUTE = 255, 0x7FFFFFFF, 1022
_NAME, _SUPER_NAME, _INLINE, _LINKED, _SUM = 0x001, 0x0FF, 0x201, 0x202, 0x500
_NO_FILE = 0x3FF
_ROOT = 2
"""Sectors of the root folder."""

_SMALL = 64
"""Bytes that a file may have to lie in the folder itself: what is in the memory of each driver at once."""

_ERASED = b"\xff"


def build_littlefs(storage: FileStorage, files: Mapping[str, bytes]) -> dict[int, bytes]:
    """The sectors of a file system with these files, by their numbers; those that are not used are not among them.

    Raises:
        FullError: there is no room for all.
    """
    sectors: dict[int, bytes] = {}
    entries = [(_SUPER_NAME, 0, b"littlefs"), (_INLINE, 0, _superblock(storage))]
    for number, (name, content) in enumerate(sorted((name.encode(), content) for name, content in files.items()), 1):
        entries.append((_NAME, number, name))
        if len(content) <= _SMALL:
            entries.append((_INLINE, number, content))
        else:
            first = _ROOT + len(sectors)
            sectors |= {first + place: piece for place, piece in enumerate(_linked(content, first))}
            entries.append((_LINKED, number, struct.pack("<2I", _ROOT + len(sectors) - 1, len(content))))
    root = [_folder(revision, entries) for revision in (1, 2)]
    if _ROOT + len(sectors) > storage.sectors or len(root[0]) > SECTOR:
        raise FullError(
            Sentence(
                "the program takes {needed} bytes of the board's flash, which has {free}; nothing was written",
                (_ROOT + len(sectors)) * SECTOR,
                storage.size,
            ),
            Sentence("make the program smaller, or use fewer devices in it"),
        )
    return {number: piece.ljust(SECTOR, _ERASED) for number, piece in {**dict(enumerate(root)), **sectors}.items()}


def _superblock(storage: FileStorage) -> bytes:
    limits = (_LARGEST_NAME, _LARGEST_FILE, _LARGEST_ATTRIBUTE)
    return struct.pack("<6I", _VERSION, SECTOR, storage.sectors, *limits)


def _linked(content: bytes, first: int) -> Iterator[bytes]:
    """The sectors of a file, which lie one after another: number n is linked to number n - 2 to the power of k for
    each k for which that power divides n.
    """
    place = 0
    while content:
        steps = [1 << power for power in range((place & -place).bit_length())]
        links = struct.pack(f"<{len(steps)}I", *(first + place - step for step in steps))
        room = SECTOR - len(links)
        yield links + content[:room]
        content = content[room:]
        place += 1


def _folder(revision: int, entries: list[tuple[int, int, bytes]]) -> bytes:
    data = bytearray(struct.pack("<I", revision))
    before = 0xFFFFFFFF
    for kind, number, content in entries:
        tag = kind << 20 | number << 10 | len(content)
        data += struct.pack(">I", tag ^ before) + content
        before = tag
    # The sum is padded to whole pages, where a driver goes on writing.
    end = -(-(len(data) + 8) // PAGE) * PAGE
    tag = _SUM << 20 | _NO_FILE << 10 | end - len(data) - 4
    data += struct.pack(">I", tag ^ before)
    data += struct.pack("<I", zlib.crc32(data) ^ 0xFFFFFFFF)
    return bytes(data.ljust(end, _ERASED))
