"""Traces that were crafted to harm or damaged: each is refused in a sentence."""

from __future__ import annotations

import contextlib
import json
import struct
import zlib
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.trace import layout
from kitrobot.trace.codec import decode, decode_events
from kitrobot.trace.header import header_to_json
from kitrobot.trace.model import TraceError
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.writer import TraceWriter
from tests.trace.test_trace import HEADER


def crafted(path: Path, header: bytes, *chunks: bytes, raw: int | None = None) -> Path:
    """A trace of that header's text, and of those chunks."""
    packed = zlib.compress(header)
    head = struct.pack("<HIII", 2, len(header) if raw is None else raw, len(packed), zlib.crc32(packed))
    path.write_bytes(layout.MAGIC + head + packed + b"".join(chunks))
    return path


def chunk(ticks: tuple[int, int], records: int, body: bytes, events: bytes = b"", raw: int | None = None) -> bytes:
    packed = zlib.compress(body), zlib.compress(events)
    plain = bytes(len(body) if raw is None else raw), events
    return layout.chunk_head(ticks, records, plain, packed) + packed[0] + packed[1]


TEXT = layout.as_json(header_to_json(HEADER))


def test_a_chunk_that_unpacks_to_more_than_it_says_is_refused(tmp_path: Path) -> None:
    bomb = chunk((0, 0), 1, b"\0" * 50_000_000, raw=100)
    with (
        TraceReader(crafted(tmp_path / "a.krtrace", TEXT, bomb)) as reader,
        pytest.raises(TraceError, match="another length"),
    ):
        list(reader)


@pytest.mark.parametrize(
    "bad",
    [
        chunk((0, 600), 501, b""),
        chunk((0, 4), 6, b""),
        chunk((5, 4), 1, b""),
        chunk((0, 0), 0, b""),
        chunk((0, 0), 1, b"")[:-30] + b"x" * 30,
        b"KRCH" + b"\xff" * 40,
        b"KRXX" + b"\0" * 60,
        b"KREN" + b"\xff" * 60,
        b"KREN" + struct.pack("<II", 2, zlib.crc32(b"[]")) + b"[]",
        b"KREN" + struct.pack("<II", 60_000, zlib.crc32(b"[" * 60_000)) + b"[" * 60_000,
    ],
)
def test_a_chunk_that_makes_no_sense_is_refused(tmp_path: Path, bad: bytes) -> None:
    with pytest.raises(TraceError), TraceReader(crafted(tmp_path / "a.krtrace", TEXT, bad)) as reader:
        list(reader)


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"\0\1\7\1\0\0",  # a number beyond the columns
        b"\0\0\1\x09\0\0",  # nobody of that number
        b"\0\0\0\1\2\0\0\0",  # a command of nobody
        b"\0\0\0\0\0",  # more than its records
        b"\1\0\0\0",  # not its first tick
        b"\0\1\0" + b"\xff" * 200 + b"\0\0",  # a number without end
        b"\0\xff\xff\xff\xff\x7f",  # a count beyond all reason
    ],
)
def test_records_that_make_no_sense_are_refused(tmp_path: Path, body: bytes) -> None:
    with (
        TraceReader(crafted(tmp_path / "a.krtrace", TEXT, chunk((0, 0), 1, body))) as reader,
        pytest.raises(TraceError),
    ):
        list(reader)


@pytest.mark.parametrize(
    "events", [b"\5\0\0\0\0\0", b"\0\1\0\0\0\0", b"\0\0\0\3\0\0", b"\0\0\5ab", b"\0\0\1\xff\0\0\0"]
)
def test_events_that_make_no_sense_are_refused(tmp_path: Path, events: bytes) -> None:
    path = crafted(tmp_path / "a.krtrace", TEXT, chunk((0, 0), 1, b"\0\0\0\0", events))
    with TraceReader(path) as reader, pytest.raises(TraceError):
        assert reader.events


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("tick_ms", 0),
        ("tick_ms", 10**9),
        ("tick_ms", "20"),
        ("seed", -1),
        ("seed", 1.5),
        ("agents", [["a", "p", "r", "robot", 1, 0], ["a", "p", "r", "robot", 1, 0]]),
        ("agents", 3),
        ("agents", [["a"]]),
        ("agents", [["a", "p", "r", "robot", 1, 7]]),
        ("agents", [["a", "p", "r", "robot", 1, -1]]),
        ("agents", [["", "p", "r", "robot", 1, 0]]),
        ("agents", [["\ud800", "p", "r", "robot", 1, 0]]),
        ("layouts", []),
        ("layouts", [["x_mm"]]),
        ("team", [["x_mm", float("nan")]]),
        ("team", [["x_mm", float("inf")]]),
        ("team", [["x_mm", 0]]),
        ("vertices", []),
        ("vertices", {"p": "v1"}),
        ("vertices", {"p": [1]}),
        ("parts", [["a"]]),
        ("mission", None),
        ("total", True),
    ],
)
def test_a_header_with_a_wrong_value_is_refused(tmp_path: Path, name: str, value: object) -> None:
    text = json.dumps({**header_to_json(HEADER), name: value}).encode()
    with pytest.raises(TraceError, match="header"):
        TraceReader(crafted(tmp_path / "a.krtrace", text))


@pytest.mark.parametrize("text", [b"", b"[]", b"3", b"[" * 100_000, b"\xff", b"1" * 9999, b'{"mission":"x"}'])
def test_a_header_that_is_none_is_refused(tmp_path: Path, text: bytes) -> None:
    with pytest.raises(TraceError, match="header"):
        TraceReader(crafted(tmp_path / "a.krtrace", text))


def test_a_header_of_very_many_lists_is_refused_before_it_fills_the_memory(tmp_path: Path) -> None:
    with pytest.raises(TraceError, match="header"):
        TraceReader(crafted(tmp_path / "a.krtrace", b"[" + b"[]," * 3_000_000 + b"[]]"))


def test_very_many_numbers_by_few_words_are_refused(tmp_path: Path) -> None:
    rows = [[f"a{n}", "p", "r", "robot", 1, 0] for n in range(5000)]
    layouts = [[[f"x{n}", 1] for n in range(1000)]]
    text = json.dumps({**header_to_json(HEADER), "agents": rows, "layouts": layouts}).encode()
    with pytest.raises(TraceError, match="header"):
        TraceReader(crafted(tmp_path / "a.krtrace", text))


def test_numbers_out_of_the_order_of_agents_are_not_written(tmp_path: Path) -> None:
    header = replace(HEADER, columns=HEADER.columns[::-1])
    with pytest.raises(TraceError, match="order"):
        TraceWriter(tmp_path / "a.krtrace", header)


@pytest.mark.parametrize("raw", [5, 2**32 - 1])
def test_a_header_that_unpacks_to_more_than_it_says_or_to_too_much_is_refused(tmp_path: Path, raw: int) -> None:
    with pytest.raises(TraceError, match="header"):
        TraceReader(crafted(tmp_path / "a.krtrace", b"\0" * 20_000_000, raw=raw))


@given(st.binary(max_size=200))
def test_random_bytes_in_a_chunk_never_escape_as_another_error(data: bytes) -> None:
    with contextlib.suppress(TraceError):
        assert len(list(decode(data, 0, 5, 3, 2))) == 5
    with contextlib.suppress(TraceError):
        assert all(0 <= tick <= 4 for tick, _ in decode_events(data, 0, 4, 2))
