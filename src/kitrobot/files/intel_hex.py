"""Hex files of the micro:bit: Intel Hex, and its superset *universal hex* with a section for each kind of board.

A line is a record: `:`, how many bytes, an address, a kind, the bytes, a sum. A section begins with an address and the
number of its board, is filled up to 512 bytes, and ends; the data of boards after that of 2016 have a kind of their
own, which older boards skip. Records of the kind *other* are skipped by every board: a mission travels in them.
Source: the micro:bit foundation's specification of universal hex, 0.4.0. A file comes from anywhere: its size is
bounded, and every record's sum is checked. Left to others: what the bytes mean.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

LARGEST_HEX_BYTES = 16 * 1024 * 1024
"""Of a file; those of both boards have 2 million."""

PLAIN = 0
"""In the place of a board's number: a file without sections."""

_DATA, _END, _SEGMENT, _UPPER = 0, 1, 2, 4
_BOARD, _BOARD_END, _PADDING, _CUSTOM, _OTHER = 10, 11, 12, 13, 14
_FIRST_BOARDS = (0x9900, 0x9901)
"""Boards of 2016, whose data are ordinary records."""

_MARK = b"\xc0\xde"
_ALIGNED = 512
_RECORD = 32
"""Bytes of a record, at most: what the micro:bit's interface takes."""

_BARE = 12
"""Letters of a record without data, with its line end."""


class HexError(KitRobotError):
    """A hex file is damaged, or none."""


@dataclass(frozen=True)
class HexFile:
    """What is in a hex file.

    Attributes:
        boards: the memory of each board by its number, as runs of bytes by their addresses.
        other: what boards skip.
    """

    boards: Mapping[int, Mapping[int, bytes]] = field(default_factory=dict)
    other: bytes = b""


def read_hex(data: bytes, name: str) -> HexFile:
    """A hex file's bytes.

    Raises:
        HexError: it is damaged, cut off or none; the message says where.
    """
    if len(data) > LARGEST_HEX_BYTES:
        raise _damaged(name, Sentence("it has more than {most} bytes", LARGEST_HEX_BYTES))
    boards: dict[int, dict[int, bytearray]] = {}
    board, upper, end = PLAIN, 0, -1
    run = bytearray()
    other = bytearray()
    has_end = False
    for kind, low, content in _records(data, name):
        has_end = kind == _END
        if kind in (_DATA, _CUSTOM):
            at = upper + low
            if at != end:
                run = boards.setdefault(board, {}).setdefault(at, bytearray())
            run += content
            end = at + len(content)
        elif kind in (_UPPER, _SEGMENT):
            upper = int.from_bytes(content) << (16 if kind == _UPPER else 4)
        elif kind == _BOARD:
            board, end = int.from_bytes(content[:2]), -1
        elif kind == _OTHER:
            other += content
    if not has_end:
        raise _damaged(name, Sentence("it is cut off: its last line is missing"))
    made = {number: {at: bytes(piece) for at, piece in runs.items()} for number, runs in boards.items()}
    return HexFile(made, bytes(other))


def write_hex(file: HexFile) -> bytes:
    """A universal hex of these boards, in their order; the *other* bytes are in the last section."""
    sections = []
    for place, (board, runs) in enumerate(file.boards.items(), 1):
        sections.append(_section(board, runs, file.other if place == len(file.boards) else b""))
    return "".join([*sections, _record(_END)]).encode()


def _records(data: bytes, name: str) -> Iterator[tuple[int, int, bytes]]:
    """Kind, address and bytes of each record."""
    for number, line in enumerate(data.splitlines(), 1):
        if not line.strip():
            continue
        try:
            record = bytes.fromhex(line[1:].decode("ascii"))
        except ValueError:
            record = b""
        if line[:1] != b":" or len(record) < 5 or record[0] != len(record) - 5 or sum(record) & 0xFF:
            raise _damaged(name, Sentence("its line {number} is not whole", number))
        yield record[3], int.from_bytes(record[1:3]), record[4:-1]


def _damaged(name: str, why: Sentence) -> HexError:
    return HexError(
        Sentence("`{file}` is no hex file of a micro:bit that is whole: {reason}", name, why),
        Sentence("get the file once more, or make it again from the mission"),
    )


def _section(board: int, runs: Mapping[int, bytes], other: bytes) -> str:
    kind = _DATA if board in _FIRST_BOARDS else _CUSTOM
    first = next(iter(runs), 0)
    upper = first >> 16
    lines = [_record(_UPPER, 0, upper.to_bytes(2)), _record(_BOARD, 0, board.to_bytes(2) + _MARK)]
    for start, content in runs.items():
        at = start
        while at < start + len(content):
            if at >> 16 != upper:
                upper = at >> 16
                lines.append(_record(_UPPER, 0, upper.to_bytes(2)))
            size = _RECORD - at % _RECORD
            lines.append(_record(kind, at & 0xFFFF, content[at - start : at - start + size]))
            at += size
    lines += [_record(_OTHER, 0, other[at : at + _RECORD]) for at in range(0, len(other), _RECORD)]
    left = -(sum(map(len, lines)) + _BARE) % _ALIGNED
    while left > 2 * _RECORD:
        size = min(_RECORD, (left - _BARE) // 2)
        lines.append(_record(_PADDING, 0, b"\xff" * size))
        left -= _BARE + 2 * size
    return "".join([*lines, _record(_BOARD_END, 0, b"\xff" * (left // 2))])


def _record(kind: int, at: int = 0, content: bytes = b"") -> str:
    record = bytes((len(content), at >> 8, at & 0xFF, kind)) + content
    return f":{record.hex()}{-sum(record) & 0xFF:02x}\n".upper()
