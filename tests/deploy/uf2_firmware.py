"""Firmware as MicroPython for the RP2040 and RP2350 is built: what it says of itself where it says it, and no code.

A file of the real one is in no package; tests on it are in `tests/boards/test_pico.py`.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable

from kitrobot.deploy.firmware.uf2 import Firmware, firmware_of
from kitrobot.deploy.uf2_image.file_storage import FLASH, FileStorage

RP2040, RP2350, ABSOLUTE = 0xE48BFF56, 0xE48BFF59, 0xE48BFF57
PICO = FileStorage(FLASH + 0xA0000, 1408 * 1024)
"""`ports/rp2/boards/RPI_PICO/mpconfigboard.h`."""

_TABLE, _RECORDS, _TEXT = 0x1000, 0x1800, 0x2F80
_RAM = 0x20000000


def block(place: int, count: int, payload: bytes = b"", family: int = RP2040, size: int | None = None) -> bytes:
    """One block."""
    head = struct.pack(
        "<8I",
        *(0x0A324655, 0x9E5D5157, 0x2000, FLASH + 256 * place),
        *(len(payload) if size is None else size, place, count, family),
    )
    return head + payload.ljust(476, b"\0") + struct.pack("<I", 0x0AB16F30)


def uf2(content: bytes, family: int = RP2040) -> bytes:
    """A file of that, from the beginning of the flash; one for the RP2350 has a block in front, as the SDK makes it."""
    pieces = [content[at : at + 256].ljust(256, b"\0") for at in range(0, len(content), 256)]
    front = block(0, 2, b"\xef" * 256, ABSOLUTE) if family == RP2350 else b""
    return front + b"".join(block(place, len(pieces), piece, family) for place, piece in enumerate(pieces))


def binary(
    storage: FileStorage = PICO,
    version: str = "1.27.0",
    *,
    size: int = 0x5300,
    in_memory: bool = False,
    records: Iterable[bytes] = (),
) -> bytes:
    """What such a firmware has in the flash. `in_memory`: its table and records are where they are copied to."""
    data = bytearray((bytes(range(251)) * (size // 251 + 1))[:size])

    def put(at: int, found: bytes) -> None:
        data[at : at + len(found)] = found

    base = _RAM - _TABLE if in_memory else FLASH
    own = struct.pack("<2H4IH", 7, int.from_bytes(b"MP", "little"), FLASH + _TEXT, storage.start, storage.size, 0, 3)
    found = [struct.pack("<2H2I", 5, 0x5052, 0x68F465DE, FLASH + size), *records, own]
    places = [_RECORDS + 32 * number for number in range(len(found))]
    moved = struct.pack("<6I", FLASH + _TABLE, _RAM, _RAM + 0x1000, 0, 0, 0) if in_memory else bytes(12)
    put(0x700, moved)
    table = [base + _TABLE, base + _TABLE + 4 * len(found)]
    put(0x1D4, struct.pack("<5I", 0x7188EBF2, *table, FLASH + 0x700, 0xE71AA390))
    put(_TABLE, struct.pack(f"<{len(found)}I", *(base + place for place in places)))
    for place, record in zip(places, found, strict=True):
        put(place, record)
    put(_TEXT, f"MicroPython v{version} on 2026-01-01; Raspberry Pi Pico with RP2040".encode())
    return bytes(data)


def micropython(family: int = RP2040, name: str = "RPI_PICO.uf2", **given: object) -> Firmware:
    """The file of one, read."""
    return firmware_of(uf2(binary(**given), family), name)  # type: ignore[arg-type]
