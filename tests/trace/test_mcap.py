"""A recording as an MCAP file, read by `rosbags`, which knows ROS 2 and nothing of KitRobot."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Iterator
from dataclasses import replace
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mcap.reader import NonSeekingReader, make_reader
from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from zstandard import ZstdCompressor

from kitrobot.primitives.image_name import ImageName
from kitrobot.trace.model import (
    PERSON,
    Column,
    TickRecord,
    TraceAgent,
    TraceCommand,
    TraceError,
    TraceEvent,
    TraceHeader,
)
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.ros.cdr import CdrLayout, encode_text, encode_texts
from kitrobot.trace.ros.mcap_export import mcap_bytes
from kitrobot.trace.ros.mcap_writer import McapWriter
from kitrobot.trace.ros.topics import distinct_parts, topic_part
from kitrobot.trace.writer import TraceWriter

TICK_MS = 20
NAMES = ("carrier 1", "روبوٹ", "1st", "carrier-1", "team")


def header(unplaced: frozenset[str] = frozenset()) -> TraceHeader:
    columns = []
    for name in NAMES:
        if name not in unplaced:
            columns += [Column(name, "x_mm", 0.1), Column(name, "y_mm", 0.1), Column(name, "heading_rad", 0.001)]
            columns += [Column(name, "load"), Column(name, "flags")]
        columns += [Column(name, "input Far away", 0.5)]
    agents = tuple(TraceAgent(name, "go", "mini-robot") for name in NAMES)
    vertices = {ImageName("go"): ("v1", None, "v2")}
    return TraceHeader("<kitrobot/>", 7, "<world/>", TICK_MS, agents, (*columns, Column("", "stock A")), vertices)


def recording(path: Path, head: TraceHeader, ticks: int, finish: bool = True) -> Path:
    with TraceWriter(path, head) as writer:
        for tick in range(ticks):
            numbers = [(place * 100 + tick) * (-1) ** place for place in range(len(head.columns))]
            active: list[Any] = [((0, tick % 3),)] * len(NAMES)
            commands = [TraceCommand(1, "Wheel", "Advance", (50, -3))] if tick == 5 else []
            events = [TraceEvent(tick, "failure", 0, "fails — è", PERSON)] if tick == 7 else []
            events += [TraceEvent(tick, "end", -1, "all is done")] if tick == 9 else []
            writer.record(TickRecord(tick, numbers, active, commands, events))
        if finish:
            writer.finish({"outcome": "done"})
    return path


def messages(path: Path, topic: str) -> Iterator[tuple[int, Any]]:
    """The messages of a topic, with their times in ns."""
    with AnyReader([path]) as bag:
        wanted = [one for one in bag.connections if one.topic == topic]
        for connection, time, data in bag.messages(wanted) if wanted else ():
            yield time, bag.deserialize(data, connection.msgtype)


def exported(source: Path) -> Path:
    target = source.with_suffix(".mcap")
    with TraceReader(source) as reader:
        target.write_bytes(mcap_bytes(reader))
    return target


@pytest.fixture
def bag(tmp_path: Path) -> Path:
    return exported(recording(tmp_path / "a.krtrace", header(), 12))


def test_where_each_robot_is_stands_in_metres_and_quaternions(bag: Path) -> None:
    found = list(messages(bag, "/tf"))
    assert [time for time, _ in found] == [tick * TICK_MS * 1_000_000 for tick in range(12)]
    time, last = found[-1]
    robots = [one.child_frame_id for one in last.transforms]
    assert robots == ["carrier_1", "_", "_1st", "carrier_1_2", "team_2"]
    for place, transform in enumerate(last.transforms):
        x, y, heading = ((n * 100 + 11) * (-1) ** n for n in range(6 * place, 6 * place + 3))
        assert transform.header.frame_id == "map"
        stamp = transform.header.stamp
        assert stamp.sec * 1_000_000_000 + stamp.nanosec == time
        at, turned = transform.transform.translation, transform.transform.rotation
        assert (at.x, at.y, at.z) == pytest.approx((x / 10_000, y / 10_000, 0))
        assert 2 * math.atan2(turned.z, turned.w) % math.tau == pytest.approx(heading / 1000 % math.tau)


def test_values_threads_commands_and_events_are_there_when_they_come(bag: Path) -> None:
    values = list(messages(bag, "/carrier_1/input/Far_away"))
    assert [value.data for _, value in values] == [-0.5 * (500 + tick) for tick in range(12)]
    assert len(list(messages(bag, "/team/stock/A"))) == 12
    assert [text.data for _, text in messages(bag, "/carrier_1/active")][:3] == ["go/v1", "", "go/v2"]
    ((time, command),) = messages(bag, "/_/command")
    assert (time, command.actuator, command.procedure) == (5 * TICK_MS * 1_000_000, "Wheel", "Advance")
    assert command.arguments.tolist() == [50, -3]
    told = [(one.kind, one.agent, one.cause, one.text) for _, one in messages(bag, "/events")]
    assert told == [("failure", "carrier 1", "person", "fails — è"), ("end", "", "program", "all is done")]
    logged = [(one.level, one.name, one.msg) for _, one in messages(bag, "/rosout")]
    assert logged == [(30, "carrier 1", "failure: fails — è"), (20, "team", "end: all is done")]


def test_what_holds_for_the_whole_run_is_beside_the_messages(bag: Path) -> None:
    with bag.open("rb") as file:
        reader = make_reader(file)
        found = {one.name: one.data for one in reader.iter_attachments()}
        (facts,) = [one.metadata for one in reader.iter_metadata()]
    assert found == {"mission.krt": b"<kitrobot/>", "world.xml": b"<world/>"}
    assert json.loads(facts["seed"]) == 7
    assert json.loads(facts["outcome"]) == {"outcome": "done"}
    assert json.loads(facts["robots"])["روبوٹ"] == "_"


def test_the_same_recording_gives_the_same_bytes_and_what_does_not_change_is_said_once(tmp_path: Path) -> None:
    head = header()
    source = tmp_path / "still.krtrace"
    with TraceWriter(source, head) as writer:
        for tick in range(50):
            writer.record(TickRecord(tick, [1] * len(head.columns), [()] * len(NAMES)))
        writer.finish({})
    bag = exported(source)
    assert len(list(messages(bag, "/tf"))) == 1
    assert len(list(messages(bag, "/carrier_1/load"))) == 1
    assert exported(source).read_bytes() == bag.read_bytes()


def test_what_becomes_messages_together_leaves_no_trace(tmp_path: Path) -> None:
    source = recording(tmp_path / "long.krtrace", header(), 3000)
    bag = exported(source)
    summary = make_reader(BytesIO(bag.read_bytes())).get_summary()
    assert summary is not None
    assert len(summary.chunk_indexes) > 1
    step = TICK_MS * 1_000_000
    assert [time for time, _ in messages(bag, "/tf")] == [tick * step for tick in range(3000)]
    loads = [(time, value.data) for time, value in messages(bag, "/_1st/load")]
    assert loads == [(tick * step, -(1500.0 + tick)) for tick in range(3000)]


def test_a_real_robot_has_no_place_and_a_cut_recording_goes_as_far_as_it_goes(tmp_path: Path) -> None:
    bag = exported(recording(tmp_path / "real.krtrace", header(frozenset(NAMES)), 3))
    assert list(messages(bag, "/tf")) == []
    assert len(list(messages(bag, "/carrier_1/input/Far_away"))) == 3
    whole = recording(tmp_path / "whole.krtrace", header(), 1203)
    cut = tmp_path / "cut.krtrace"
    cut.write_bytes(whole.read_bytes()[:-200])
    assert 500 <= len(list(messages(exported(cut), "/tf"))) < 1203


@given(st.lists(st.text(max_size=8), unique=True, max_size=8))
def test_names_of_topics_are_distinct_and_what_ros_takes(names: list[str]) -> None:
    parts = distinct_parts(names)
    assert len(set(parts.values())) == len(names)
    for part in parts.values():
        assert part.isascii()
        assert not part[0].isdigit()
        assert part.replace("_", "a").isalnum()
    assert all(topic_part(topic_part(name)) == topic_part(name) for name in names)


@given(
    st.lists(st.integers(-(2**31), 2**31 - 1), max_size=5),
    st.lists(st.text(st.characters(codec="utf-8", exclude_characters="\0"), max_size=9), min_size=2, max_size=2),
)
def test_cdr_is_what_rosbags_writes(whole: list[int], texts: list[str]) -> None:
    store = get_typestore(Stores.ROS2_JAZZY)
    store.register(get_types_from_msg("int32 sec\nuint32 nanosec\nstring a\nstring b\nint32[] more\n", "x/msg/X"))
    kind = store.types["x/msg/X"]
    theirs = store.serialize_cdr(kind(3, 4, *texts, numpy.array(whole, "int32")), "x/msg/X")
    assert encode_texts((3, 4), tuple(texts), tuple(whole)) == bytes(theirs)
    string = store.types["std_msgs/msg/String"]
    assert encode_text(texts[0]) == bytes(store.serialize_cdr(string(texts[0]), "std_msgs/msg/String"))


def test_a_layout_wants_its_numbers() -> None:
    layout = CdrLayout().numbers("Bd")
    assert layout.encode((1, 2.0)) == b"\0\1\0\0\1" + bytes(7) + struct.pack("<d", 2.0)
    with pytest.raises(ValueError, match="shorter"):
        layout.encode((1,))
    with pytest.raises(ValueError, match="shorter"):
        layout.encode_rows(numpy.zeros((4, 1)))
    with pytest.raises(struct.error):
        layout.encode((300, 2.0))


@given(st.lists(st.tuples(st.integers(0, 2**31 - 1), st.floats(width=64), st.integers(0, 255)), max_size=4))
def test_many_messages_are_the_same_as_each_alone(rows: list[tuple[int, float, int]]) -> None:
    layout = CdrLayout().numbers("i").text("map").numbers("dB")
    many = layout.encode_rows(numpy.array(rows, float).reshape(-1, 3))
    assert [row.tobytes() for row in many] == [layout.encode(row) for row in rows]


def test_other_readers_find_the_index(bag: Path) -> None:
    summary = make_reader(BytesIO(bag.read_bytes())).get_summary()
    assert summary is not None
    assert summary.statistics is not None
    assert summary.statistics.attachment_count == 2


def test_a_file_of_several_chunks_is_read_by_its_indexes() -> None:
    writer = McapWriter("ros2", "kitrobot", ZstdCompressor(level=1).compress)
    schema = writer.add_schema("std_msgs/msg/String", "ros2msg", "string data\n")
    channels = [writer.add_channel(topic, "cdr", schema) for topic in ("/a", "/b")]
    data = [encode_text(f"{tick} " + "x" * 50_000) for tick in range(100)]
    for tick, one in enumerate(data):
        writer.add_message(channels[tick % 2], tick * 1000, one)
        if tick % 20 == 19:
            writer.end_chunk()
    writer.add_attachment("a.txt", "text/plain", b"hello")
    reader = make_reader(BytesIO(writer.finish()), validate_crcs=True)
    summary = reader.get_summary()
    assert summary is not None
    assert summary.statistics is not None
    assert summary.statistics.chunk_count == len(summary.chunk_indexes) == 5
    assert summary.statistics.channel_message_counts == dict.fromkeys(channels, 50)
    assert (summary.statistics.message_start_time, summary.statistics.message_end_time) == (0, 99_000)
    assert [one.data for _, _, one in reader.iter_messages()] == data
    later = [one.data for _, _, one in reader.iter_messages(topics=["/b"], starting_at=60_000, ending_before=90_000)]
    assert later == data[61:90:2]
    assert [one.data for one in reader.iter_attachments()] == [b"hello"]


def test_a_chunk_has_its_messages_in_the_order_of_their_times() -> None:
    writer = McapWriter("ros2", "kitrobot", ZstdCompressor(level=1).compress)
    schema = writer.add_schema("std_msgs/msg/Float64", "ros2msg", "float64 data\n")
    channels = numpy.array([writer.add_channel(topic, "cdr", schema) for topic in ("/a", "/b", "/c")])
    layout = CdrLayout().numbers("d")
    writer.add_message(3, 4, layout.encode((0.5,)))
    times = numpy.array([1, 1, 4, 9])
    writer.add_messages(channels[[0, 1, 0, 1]], times, layout.encode_rows(numpy.array([[1.0], [2.0], [3.0], [4.0]])))
    writer.add_messages(3, numpy.array([0, 5]), layout.encode_rows(numpy.array([[5.0], [6.0]])))
    file = writer.finish()
    found = [
        (channel.topic, message.log_time, message.publish_time, struct.unpack("<4xd", message.data)[0])
        for _, channel, message in NonSeekingReader(BytesIO(file), validate_crcs=True).iter_messages(
            log_time_order=False
        )
    ]
    assert found == [
        ("/c", 0, 0, 5.0),
        ("/a", 1, 1, 1.0),
        ("/b", 1, 1, 2.0),
        ("/c", 4, 4, 0.5),
        ("/a", 4, 4, 3.0),
        ("/c", 5, 5, 6.0),
        ("/b", 9, 9, 4.0),
    ]
    later = make_reader(BytesIO(file), validate_crcs=True).iter_messages(topics=["/b"])
    assert [message.log_time for _, _, message in later] == [1, 9]


@pytest.mark.parametrize(("ticks", "argument"), [((1,), 2**31), ((1,), -(2**40)), ((2**32 - 1,), 5)])
def test_numbers_that_ros_has_not_are_damage(tmp_path: Path, ticks: tuple[int, ...], argument: int) -> None:
    source = tmp_path / "large.krtrace"
    head = replace(header(), tick_ms=60_000)
    with TraceWriter(source, head) as writer:
        for tick in ticks:
            commands = [TraceCommand(1, "Wheel", "Advance", (argument,))]
            writer.record(TickRecord(tick, [1] * len(head.columns), [()] * len(NAMES), commands))
        writer.finish({})
    with pytest.raises(TraceError, match=f"damaged after tick {ticks[0]}: its records do not make sense"):
        exported(source)


def test_a_file_without_messages_is_whole() -> None:
    reader = make_reader(
        BytesIO(McapWriter("ros2", "kitrobot", ZstdCompressor().compress).finish()), validate_crcs=True
    )
    summary = reader.get_summary()
    assert summary is not None
    assert list(reader.iter_messages()) == []
