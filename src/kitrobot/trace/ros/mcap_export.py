"""A recording as an MCAP file of ROS 2 messages, which Foxglove, PlotJuggler and `rosbag2` open.

| topic | type | when |
|---|---|---|
| `/tf` | `tf2_msgs/msg/TFMessage` | a robot moved: from `map` to each robot, in m |
| `/ROBOT/load`, `/ROBOT/input/NAME`, …, `/team/…` | `std_msgs/msg/Float64` | the number changed |
| `/ROBOT/active` | `std_msgs/msg/String` | its threads stand at other vertices: `PROGRAM/VERTEX …` |
| `/ROBOT/command` | `kitrobot_msgs/msg/Command` | a device took a command |
| `/events`, `/rosout` | `kitrobot_msgs/msg/Event`, `rcl_interfaces/msg/Log` | something happened |

Time begins at 0 with the run. The mission and the world are attachments; seed, step, outcome and the names of the
robots are the metadata `kitrobot`. The same recording gives the same bytes.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Callable
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray
from zstandard import ZstdCompressor

from kitrobot.primitives.image_name import ImageName
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import POSE_WORDS, TEAM, Threads, TickRecord, TraceError, TraceEvent, TraceHeader
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.ros.cdr import CdrLayout, encode_text, encode_texts
from kitrobot.trace.ros.mcap_writer import McapWriter
from kitrobot.trace.ros.messages import split_time, transforms, turn_of
from kitrobot.trace.ros.schemas import INFO, WARN, schema_text
from kitrobot.trace.ros.topics import robot_parts, topic_part

_POSE: Final = POSE_WORDS[:3]
_GRAVE: Final = frozenset(("collision", "failure", "outside"))
"""Kinds of events that are warnings in `/rosout`."""
_MOST_STANDINGS: Final = 10_000
_TOLD_TICKS: Final = 500
"""Ticks between two reports of progress: drawing a bar takes as long as writing some."""
_CHUNK_BYTES: Final = 1 << 19
"""Of the numbers and other messages that become a chunk of one to some MB."""
_LEVEL: Final = 1
"""Of zstd: the fastest; 3 makes files a twentieth smaller."""
_LONGEST_MS: Final = 1000 << 31
"""Time that ROS 2 does not reach: its seconds are int32."""

Progress = Callable[[int, int], None]
"""Told the tick that is written, and the last one."""


def mcap_bytes(reader: TraceReader, progress: Progress | None = None) -> bytes:
    """All ticks of a recording as an MCAP file; of one that is cut, those that are there.

    Raises:
        TraceError: the recording is damaged.
    """
    if reader.last_tick * reader.header.tick_ms >= _LONGEST_MS:
        raise _damaged(reader.last_tick)
    writer = McapWriter("ros2", "kitrobot", ZstdCompressor(level=_LEVEL).compress)
    export = _Export(writer, reader.header)
    for record in reader.walk(0):
        try:
            export.write(record)
        except struct.error as error:
            raise _damaged(record.tick) from error
        if progress is not None and record.tick % _TOLD_TICKS == 0:
            progress(record.tick, reader.last_tick)
    export.end_chunk()
    export.write_attachments(reader.outcome)
    return writer.finish()


def _damaged(tick: int) -> TraceError:
    return TraceError(Sentence("the trace is damaged after tick {tick}: its records do not make sense", tick))


class _Topics:
    """The channels of a file: each is made when it is first asked for."""

    def __init__(self, writer: McapWriter) -> None:
        self._writer = writer
        self._schemas: dict[str, int] = {}
        self._channels: dict[str, int] = {}

    def channel(self, topic: str, kind: str) -> int:
        """The channel of a topic whose messages are of that type."""
        channel = self._channels.get(topic)
        if channel is None:
            schema = self._schemas.get(kind)
            if schema is None:
                schema = self._writer.add_schema(kind, "ros2msg", schema_text(kind))
                self._schemas[kind] = schema
            channel = self._writer.add_channel(topic, "cdr", schema)
            self._channels[topic] = channel
        return channel

    def write(self, topic: str, kind: str, nanoseconds: int, data: bytes) -> None:
        """Writes a message."""
        self._writer.add_message(self.channel(topic, kind), nanoseconds, data)


class _Export:
    """One recording on its way into a file."""

    def __init__(self, writer: McapWriter, header: TraceHeader) -> None:
        self._writer, self._header = writer, header
        self._topics = _Topics(writer)
        parts = robot_parts(agent.name for agent in header.agents)
        self._parts = {agent.name: parts[agent.name] for agent in header.agents}
        self._robots = [self._parts[agent.name] for agent in header.agents]
        self._scales = np.array([column.scale for column in header.columns])
        places = {(column.owner, column.name): place for place, column in enumerate(header.columns)}
        placed = [agent.name for agent in header.agents if agent.name not in header.unplaced]
        self._poses = np.array([[places[name, word] for word in _POSE] for name in placed], int).reshape(-1, 3)
        """Of each robot that has a place the columns of x, y and heading."""
        self._tf = transforms([self._parts[name] for name in placed])
        values = [at for at, column in enumerate(header.columns) if column.owner == TEAM or column.name not in _POSE]
        self._values = np.array(values, int)
        """The other columns, and of each the channel."""
        topics = [self._topic(header.columns[at].owner, header.columns[at].name) for at in values]
        self._channels = np.array([self._topics.channel(topic, "std_msgs/msg/Float64") for topic in topics], int)
        self._float = CdrLayout().numbers("d")
        self._numbers: list[int] = []
        self._before = np.full((1, len(header.columns)), np.nan)
        """The numbers before those that wait."""
        self._row = struct.Struct(f"{len(header.columns)}d")
        self._waiting = bytearray()
        """Rows of the numbers of ticks at which one changed."""
        self._times: list[int] = []
        """Of those ticks, in ns."""
        self._standings: dict[tuple[ImageName, Threads], bytes] = {}
        """Messages that say where threads stand."""
        self._active: list[Threads] = [()] * len(header.agents)

    def _topic(self, owner: str, name: str) -> str:
        robot = "team" if owner == TEAM else self._parts[owner]
        return "/".join(["", robot, *(topic_part(word) for word in name.split(" ", 1))])

    def write(self, record: TickRecord) -> None:
        """Writes what is new in a record."""
        nanoseconds = record.tick * self._header.tick_ms * 1_000_000
        stamp = split_time(nanoseconds)
        if record.numbers != self._numbers:
            self._waiting += self._row.pack(*record.numbers)
            self._times.append(nanoseconds)
            self._numbers = list(record.numbers)
        if record.active != self._active:
            self._write_active(record, nanoseconds)
            self._active = list(record.active)
        for command in record.commands:
            topic = f"/{self._robots[command.agent]}/command"
            data = encode_texts(stamp, (command.actuator, command.procedure), command.arguments)
            self._topics.write(topic, "kitrobot_msgs/msg/Command", nanoseconds, data)
        for event in record.events:
            self._write_event(event, nanoseconds)
        if len(self._waiting) + self._writer.chunk_bytes >= _CHUNK_BYTES:
            self.end_chunk()

    def end_chunk(self) -> None:
        """Writes the messages of the numbers that wait, and ends a chunk: NumPy is fast with some hundred ticks."""
        if self._times:
            numbers = np.concatenate([self._before, np.frombuffer(self._waiting).reshape(len(self._times), -1)])
            times = np.array(self._times, np.uint64)
            changed = numbers[1:] != numbers[:-1]
            numbers, self._before = numbers[1:] * self._scales, numbers[-1:]
            moved = changed[:, self._poses].any((1, 2))
            if moved.any():
                self._write_poses(numbers[moved][:, self._poses], times[moved])
            self._write_values(numbers[:, self._values], changed[:, self._values], times)
            self._waiting, self._times = bytearray(), []
        self._writer.end_chunk()

    def _write_poses(self, poses: NDArray[Any], times: NDArray[Any]) -> None:
        """Writes where the robots are; `poses` has a tick in each row, with x, y (mm) and heading (rad) of each."""
        numbers = np.zeros((*poses.shape[:2], 9))
        seconds, nanoseconds = np.divmod(times, 1_000_000_000)
        numbers[..., 0], numbers[..., 1] = seconds[:, None], nanoseconds[:, None]
        numbers[..., 2:4] = poses[..., :2] / 1000
        # The sines of NumPy are others on other processors.
        headings, which = np.unique(poses[..., 2], return_inverse=True)
        turns = np.array([turn_of(heading) for heading in headings.tolist()])
        numbers[..., 7:] = turns[which.reshape(poses.shape[:2])]
        channel = self._topics.channel("/tf", "tf2_msgs/msg/TFMessage")
        self._writer.add_messages(channel, times, self._tf.encode_rows(numbers.reshape(len(poses), -1)))

    def _write_values(self, values: NDArray[Any], changed: NDArray[Any], times: NDArray[Any]) -> None:
        """Writes the values that changed; each row has a tick."""
        ticks, places = np.nonzero(changed)
        data = self._float.encode_rows(values[ticks, places][:, None])
        self._writer.add_messages(self._channels[places], times[ticks], data)

    def _write_active(self, record: TickRecord, nanoseconds: int) -> None:
        for robot, agent, threads, before in zip(
            self._robots, self._header.agents, record.active, self._active, strict=True
        ):
            if threads == before:
                continue
            image = self._header.image_name(agent)
            data = self._standings.get((image, threads))
            if data is None:
                places = self._header.places.get(image, ())
                at = (places[instruction] for _, instruction in threads if instruction < len(places))
                data = encode_text(" ".join("/".join(place) for place in at if place is not None))
                if len(self._standings) < _MOST_STANDINGS:
                    self._standings[image, threads] = data
            self._topics.write(f"/{robot}/active", "std_msgs/msg/String", nanoseconds, data)

    def _write_event(self, event: TraceEvent, nanoseconds: int) -> None:
        stamp = split_time(nanoseconds)
        name = "" if event.agent < 0 else self._header.agents[event.agent].name
        texts = (event.kind, name, event.cause, str(event.text))
        self._topics.write("/events", "kitrobot_msgs/msg/Event", nanoseconds, encode_texts(stamp, texts))
        level = WARN if event.kind in _GRAVE else INFO
        log = CdrLayout().numbers("iIB").text(name or "team").text(f"{event.kind}: {event.text}")
        log.text("").text("").numbers("I")
        self._topics.write("/rosout", "rcl_interfaces/msg/Log", nanoseconds, log.encode((*stamp, level, 0)))

    def write_attachments(self, outcome: dict[str, Any]) -> None:
        """Writes what holds for the whole run."""
        header = self._header
        for name, text in (("mission.krt", header.mission), ("world.xml", header.world)):
            self._writer.add_attachment(name, "application/xml", text.encode())
        facts = {"seed": header.seed, "tick_ms": header.tick_ms, "outcome": outcome, "robots": dict(self._parts)}
        self._writer.add_metadata(
            "kitrobot", {name: json.dumps(fact, ensure_ascii=False, sort_keys=True) for name, fact in facts.items()}
        )
