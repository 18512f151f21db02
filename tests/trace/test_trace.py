"""The trace: what goes in comes out, cut files read up to their last whole chunk, damage is said in a sentence."""

from __future__ import annotations

import struct
import sys
import tempfile
import zlib
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.primitives.image_name import ImageName
from kitrobot.trace import layout
from kitrobot.trace import (
    reader as trace_reader,
)
from kitrobot.trace.model import (
    PERSON,
    Column,
    TickRecord,
    TraceAgent,
    TraceCommand,
    TraceError,
    TraceEvent,
    TraceHeader,
    TracePart,
)
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.writer import TraceWriter

HEADER = TraceHeader(
    "<kitrobot/>",
    7,
    "<world/>",
    20,
    (TraceAgent("carrier-1", "carrier", "carrier", "carrier", 1), TraceAgent("loader", "loader", "loader")),
    (Column("carrier-1", "x_mm", 0.1), Column("carrier-1", "load"), Column("", "stock A")),
    {ImageName("carrier"): ("v1", None, "v2"), ImageName("loader"): ()},
    (TracePart("odd.robot.xml", "<robot name='é'/>"),),
    12,
)


def made(tick: int) -> TickRecord:
    events = [TraceEvent(max(tick - 1, 0), "load", 1, "a box for carrier-1 — è")] if tick % 7 == 0 else []
    events += [TraceEvent(tick, "outside", -1, "by hand", PERSON)] if tick % 11 == 0 else []
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


TEXTS = st.text(st.characters(codec="utf-8"), max_size=20)
ROWS = st.lists(
    st.tuples(
        st.integers(1, 2**31),
        st.lists(st.integers(-(2**62), 2**62), min_size=3, max_size=3),
        st.lists(st.lists(st.tuples(st.integers(0, 300), st.integers(0, 70_000)), max_size=3), min_size=2, max_size=2),
        st.lists(st.builds(TraceCommand, st.integers(0, 1), TEXTS, TEXTS, st.lists(st.integers(-9, 2**40)).map(tuple))),
        st.lists(st.builds(TraceEvent, st.just(0), TEXTS, st.integers(-1, 1), TEXTS)),
    ),
    max_size=8,
)


@given(ROWS, st.booleans())
def test_whatever_was_recorded_is_read_back(rows: list, settled: bool) -> None:
    tick, records = -1, []
    for later, values, threads, commands, events in rows:
        tick += later
        events = [replace(event, tick=tick - tick // 3 * (len(event.text) % 4)) for event in events]
        records.append(TickRecord(tick, values, [tuple(one) for one in threads], commands, events))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.krtrace"
        with TraceWriter(path, HEADER) as writer:
            for record in records:
                writer.record(record)
                if settled:
                    writer.settle()
        with TraceReader(path) as reader:
            assert [trace_reader.kept(record) for record in reader] == records
            assert not reader.cut


@pytest.mark.skipif(sys.platform == "win32", reason="no two writers are kept apart there")
def test_a_second_run_does_not_write_into_the_recording_of_another(tmp_path: Path) -> None:
    path = tmp_path / "a.krtrace"
    with TraceWriter(path, HEADER) as writer:
        writer.record(made(0))
        writer.settle()
        with pytest.raises(TraceError, match="being written by another run"):
            TraceWriter(path, HEADER)
    with TraceReader(path) as reader:
        assert list(reader) == [made(0)]
    written(path, 3)
    with TraceReader(path) as reader:
        assert list(reader) == [made(tick) for tick in range(3)]


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
        assert records == whole


def test_another_file_and_another_version_are_refused_by_name(tmp_path: Path) -> None:
    path = tmp_path / "a.krtrace"
    path.write_bytes(b"<kitrobot/>")
    with pytest.raises(TraceError, match="not a KitRobot trace"):
        TraceReader(path)
    path.write_bytes(layout.MAGIC + struct.pack("<HII", 99, 0, 0))
    with pytest.raises(TraceError, match="format 99"):
        TraceReader(path)
    path.write_bytes(layout.MAGIC + struct.pack("<HII", 1, 2, zlib.crc32(b"{}")) + b"{}")
    with pytest.raises(TraceError, match="older KitRobot") as old:
        TraceReader(path)
    assert "record the run once more" in old.value.help
    with pytest.raises(TraceError, match="cannot be read"):
        TraceReader(tmp_path / "none.krtrace")
    with pytest.raises(TraceError, match="cannot be read"):
        TraceReader(tmp_path)


@pytest.mark.parametrize("tick", [0, 1, 499, 500, 999, 1202])
def test_walking_on_and_back_from_any_tick(tmp_path: Path, tick: int) -> None:
    with TraceReader(written(tmp_path / "a.krtrace", 1203)) as reader:
        assert [trace_reader.kept(record) for record in reader.walk(tick)] == [made(at) for at in range(tick, 1203)]
        assert list(reader.walk_back(tick)) == [made(at) for at in range(tick - 1, -1, -1)]


def test_all_events_are_known_without_unpacking_the_records(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = written(tmp_path / "a.krtrace", 1203)
    monkeypatch.setattr(trace_reader, "decode", None)
    with TraceReader(path) as reader:
        assert reader.events == [(tick, event) for tick in range(1203) for event in made(tick).events]


def test_of_very_many_events_the_last_ones_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trace_reader, "MOST_EVENTS", 10)
    with TraceReader(written(tmp_path / "a.krtrace", 1203)) as reader:
        assert reader.events == [(tick, event) for tick in range(1203) for event in made(tick).events][-10:]


def test_a_team_of_many_fills_a_chunk_by_its_size(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(layout, "CHUNK_BYTES", 50)
    with TraceReader(written(tmp_path / "a.krtrace", 100)) as reader:
        assert list(reader) == [made(tick) for tick in range(100)]
        assert len(reader._chunks) > 10


def test_ticks_may_be_missing(tmp_path: Path) -> None:
    with TraceWriter(tmp_path / "a.krtrace", HEADER) as writer:
        for tick in (3, 4, 9):
            writer.record(made(tick))
    with TraceReader(tmp_path / "a.krtrace") as reader:
        assert [reader.seek(tick).tick for tick in (0, 3, 5, 8, 9, 10)] == [3, 3, 4, 4, 9, 9]
        assert reader.seek(8) == made(4)


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
