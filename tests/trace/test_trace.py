"""The trace: what goes in comes out, cut files read up to their last whole chunk, damage is said in a sentence."""

from __future__ import annotations

import contextlib
import json
import struct
import zlib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.trace import (
    Column,
    TickRecord,
    TraceAgent,
    TraceCommand,
    TraceError,
    TraceEvent,
    TraceHeader,
    TraceReader,
    TraceWriter,
)
from kitrobot.trace import file as trace_file
from kitrobot.trace.coding import decode

HEADER = TraceHeader(
    "ab" * 32,
    7,
    "ring",
    20,
    (TraceAgent("carrier-1", "carrier", "carrier"), TraceAgent("loader", "loader", "loader")),
    (Column("carrier-1", "x_mm", 0.1), Column("carrier-1", "load"), Column("", "stock A")),
)


def made(tick: int) -> TickRecord:
    events = [TraceEvent("load", 1, "a box for carrier-1 — è")] if tick % 7 == 0 else []
    commands = [TraceCommand(0, "Wheel", "Advance", (50, -3))] if tick % 5 == 0 else []
    threads = ((0, tick % 3), (1, 4)) if tick % 4 else ()
    return TickRecord(tick, [tick * 37 - 900, tick % 2, -(tick // 100)], [threads, ()], commands, events)


def written(path: Path, ticks: int, finish: bool = True) -> Path:
    with TraceWriter(path, HEADER) as writer:
        for tick in range(ticks):
            writer.record(made(tick))
        if finish:
            writer.finish({"outcome": "done"})
    return path


def test_everything_recorded_is_read_back(tmp_path: Path) -> None:
    with TraceReader(written(tmp_path / "a.krtrace", 1203)) as reader:
        assert reader.header == HEADER
        assert list(reader) == [made(tick) for tick in range(1203)]
        assert not reader.cut
        assert reader.outcome == {"outcome": "done"}
        assert (reader.first_tick, reader.last_tick) == (0, 1202)


def test_a_record_names_its_values_in_their_units() -> None:
    values = made(100).values(HEADER)
    assert values["carrier-1"]["x_mm"] == pytest.approx(280.0)
    assert values[""]["stock A"] == -1


@pytest.mark.parametrize("tick", [0, 1, 499, 500, 501, 999, 1000, 1202])
def test_seeking_finds_every_tick_on_both_sides_of_a_chunk(tmp_path: Path, tick: int) -> None:
    with TraceReader(written(tmp_path / "a.krtrace", 1203)) as reader:
        assert reader.seek(tick) == made(tick)


def test_seeking_beyond_the_end_gives_the_last_tick(tmp_path: Path) -> None:
    with TraceReader(written(tmp_path / "a.krtrace", 10)) as reader:
        assert reader.seek(1000).tick == 9


def test_the_same_records_give_the_same_bytes(tmp_path: Path) -> None:
    first = written(tmp_path / "a.krtrace", 700).read_bytes()
    assert written(tmp_path / "b.krtrace", 700).read_bytes() == first


def test_an_empty_trace_is_read(tmp_path: Path) -> None:
    with TraceReader(written(tmp_path / "a.krtrace", 0)) as reader:
        assert list(reader) == []
        assert reader.last_tick == -1
        with pytest.raises(TraceError, match="holds no ticks"):
            reader.seek(0)


def test_a_file_cut_anywhere_reads_up_to_its_last_whole_chunk(tmp_path: Path) -> None:
    data = written(tmp_path / "a.krtrace", 1203).read_bytes()
    header_end = data.index(b"KRCH")
    path = tmp_path / "cut.krtrace"
    for length in [*range(header_end, len(data), 97), len(data) - 1]:
        path.write_bytes(data[:length])
        with TraceReader(path) as reader:
            ticks = [record.tick for record in reader]
            assert reader.cut
            assert ticks == list(range(len(ticks)))
            assert len(ticks) in (0, 500, 1000, 1203)


def test_a_file_cut_in_its_header_is_refused(tmp_path: Path) -> None:
    data = written(tmp_path / "a.krtrace", 3).read_bytes()
    path = tmp_path / "cut.krtrace"
    for length in range(data.index(b"KRCH")):
        path.write_bytes(data[:length])
        with pytest.raises(TraceError):
            TraceReader(path)


def test_what_was_recorded_before_a_crash_is_on_disk(tmp_path: Path) -> None:
    writer = TraceWriter(tmp_path / "a.krtrace", HEADER)
    for tick in range(1100):
        writer.record(made(tick))
    with TraceReader(tmp_path / "a.krtrace") as reader:
        assert sum(1 for _ in reader) == 1000
        assert reader.cut
    writer.close()


def test_a_flipped_bit_anywhere_is_noticed_or_harmless(tmp_path: Path) -> None:
    data = written(tmp_path / "a.krtrace", 40).read_bytes()
    whole = [made(tick) for tick in range(40)]
    path = tmp_path / "bad.krtrace"
    for index in range(len(data)):
        path.write_bytes(data[:index] + bytes([data[index] ^ 16]) + data[index + 1 :])
        try:
            with TraceReader(path) as reader:
                records = list(reader)
        except TraceError:
            continue
        # Only the length of a chunk that now reaches beyond the file looks like a cut.
        assert records in ([], whole)


def test_a_chunk_that_unpacks_to_more_than_it_says_is_refused(tmp_path: Path) -> None:
    path = written(tmp_path / "a.krtrace", 1)
    data = path.read_bytes()
    packed = zlib.compress(b"\0" * 10_000_000)
    head = struct.pack("<4sIIIIII", b"KRCH", 0, 0, 1, 100, len(packed), zlib.crc32(packed))
    path.write_bytes(data[: data.index(b"KRCH")] + head + packed)
    with TraceReader(path) as reader, pytest.raises(TraceError, match="another length"):
        list(reader)


@given(st.binary(max_size=200))
def test_random_bytes_in_a_chunk_never_escape_as_another_error(data: bytes) -> None:
    with contextlib.suppress(TraceError):
        assert len(list(decode(data, 0, 5, 3, 2))) == 5


def test_another_file_and_another_version_are_refused_by_name(tmp_path: Path) -> None:
    path = tmp_path / "a.krtrace"
    path.write_bytes(b"<kitrobot/>")
    with pytest.raises(TraceError, match="not a KitRobot trace"):
        TraceReader(path)
    path.write_bytes(trace_file.MAGIC + struct.pack("<HII", 99, 0, 0))
    with pytest.raises(TraceError, match="version 99"):
        TraceReader(path)
    text = json.dumps({"mission": "x"}).encode()
    path.write_bytes(trace_file.MAGIC + struct.pack("<HII", 1, len(text), zlib.crc32(text)) + text)
    with pytest.raises(TraceError, match="header"):
        TraceReader(path)
    with pytest.raises(TraceError, match="cannot be read"):
        TraceReader(tmp_path / "none.krtrace")


def test_a_place_that_cannot_be_written_is_refused(tmp_path: Path) -> None:
    with pytest.raises(TraceError, match="cannot be written"):
        TraceWriter(tmp_path / "no" / "a.krtrace", HEADER)


def test_ticks_must_grow_and_records_must_fit_the_header(tmp_path: Path) -> None:
    with TraceWriter(tmp_path / "a.krtrace", HEADER) as writer:
        writer.record(made(5))
        with pytest.raises(TraceError, match="ticks must grow"):
            writer.record(made(5))
        with pytest.raises(TraceError, match="2 numbers"):
            writer.record(TickRecord(6, [1, 2], [(), ()]))
