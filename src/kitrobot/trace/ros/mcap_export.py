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
import math
from collections.abc import Callable, Iterable, Sequence
from itertools import compress
from operator import ne
from typing import Any, Final

from kitrobot.primitives.image_name import ImageName
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import POSE_WORDS, TEAM, Threads, TickRecord, TraceError, TraceEvent, TraceHeader
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.ros.cdr import CdrLayout, encode_text, encode_texts
from kitrobot.trace.ros.mcap_writer import McapWriter
from kitrobot.trace.ros.schemas import INFO, WARN, schema_text
from kitrobot.trace.ros.topics import distinct_parts, topic_part

FRAME: Final = "map"
_POSE: Final = POSE_WORDS[:3]
_GRAVE: Final = frozenset(("collision", "failure", "outside"))
"""Kinds of events that are warnings in `/rosout`."""
_OUR_TOPICS: Final = ("team", "tf", "events", "rosout")
_MOST_STANDINGS: Final = 10_000
_TOLD_TICKS: Final = 500
"""Ticks between two reports of progress: drawing a bar takes as long as writing some."""
_LEVEL: Final = 1
"""Of zstd: the fastest; 3 makes files a twentieth smaller."""

Progress = Callable[[int, int], None]
"""Told the tick that is written, and the last one."""


def mcap_bytes(reader: TraceReader, progress: Progress | None = None) -> bytes:
    """All ticks of a recording as an MCAP file; of one that is cut, those that are there.

    Raises:
        TraceError: the package `mcap` is not there, or the recording is damaged.
    """
    try:
        from zstandard import ZstdCompressor
    except ImportError as error:
        raise TraceError(
            Sentence("an MCAP file needs the package `{package}`", "zstandard"),
            Sentence("install it: {command}", "`pip install kitrobot[ros]`"),
        ) from error
    writer = McapWriter("ros2", "kitrobot", ZstdCompressor(level=_LEVEL).compress)
    export = _Export(writer, reader.header)
    for record in reader.walk(0):
        export.write(record)
        if progress is not None and record.tick % _TOLD_TICKS == 0:
            progress(record.tick, reader.last_tick)
    export.write_attachments(reader.outcome)
    return writer.finish()


class _Topics:
    """The channels of a file: each is made when its first message is written."""

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
        # A robot may be called like a topic of ours.
        parts = distinct_parts([*_OUR_TOPICS, *(agent.name for agent in header.agents)])
        self._parts = {agent.name: parts[agent.name] for agent in header.agents}
        self._robots = [self._parts[agent.name] for agent in header.agents]
        columns = {(column.owner, column.name): place for place, column in enumerate(header.columns)}
        placed = [agent.name for agent in header.agents if agent.name not in header.unplaced]
        self._pose_places = [tuple(columns[name, word] for word in _POSE) for name in placed]
        self._scales = [column.scale for column in header.columns]
        self._values = [
            (column.scale, self._topic(column.owner, column.name))
            if column.name not in _POSE or column.owner == TEAM
            else None
            for column in header.columns
        ]
        """Of each column the scale and the topic; None for places."""
        self._channels = [0] * len(header.columns)
        """Of each column its channel, once it has one."""
        self._tf = _transforms([self._parts[name] for name in placed])
        self._numbers: list[int] = []
        self._placed: list[int] = []
        self._rotations: dict[float, tuple[float, float]] = {}
        self._standings: dict[tuple[ImageName, Threads], bytes] = {}
        """Messages that say where threads stand."""
        self._active: list[Threads] = [()] * len(header.agents)

    def _topic(self, owner: str, name: str) -> str:
        robot = "team" if owner == TEAM else self._parts[owner]
        return "/".join(["", robot, *(topic_part(word) for word in name.split(" ", 1))])

    def write(self, record: TickRecord) -> None:
        """Writes what is new in a record."""
        nanoseconds = record.tick * self._header.tick_ms * 1_000_000
        if record.numbers != self._numbers:
            self._write_poses(record.numbers, nanoseconds)
            self._write_values(record.numbers, nanoseconds)
            self._numbers = list(record.numbers)
        if record.active != self._active:
            self._write_active(record, nanoseconds)
            self._active = list(record.active)
        for command in record.commands:
            texts = (command.actuator, command.procedure)
            data = encode_texts(_stamp(nanoseconds), texts, command.arguments)
            self._topics.write(
                f"/{self._robots[command.agent]}/command", "kitrobot_msgs/msg/Command", nanoseconds, data
            )
        for event in record.events:
            self._write_event(event, nanoseconds)

    def _write_poses(self, numbers: Sequence[int], nanoseconds: int) -> None:
        placed = [numbers[place] for places in self._pose_places for place in places]
        if placed == self._placed:
            return
        self._placed = placed
        stamp = _stamp(nanoseconds)
        transforms: list[float] = []
        scales = self._scales
        for x, y, heading in self._pose_places:
            at_x, at_y = numbers[x] * scales[x] / 1000, numbers[y] * scales[y] / 1000
            transforms += (*stamp, at_x, at_y, 0.0, 0.0, 0.0, *self._rotation(numbers[heading] * scales[heading]))
        self._topics.write("/tf", "tf2_msgs/msg/TFMessage", nanoseconds, self._tf.encode(transforms))

    def _rotation(self, heading: float) -> tuple[float, float]:
        """The last two numbers of the quaternion of a turn about z, in radians; the first two are 0."""
        found = self._rotations.get(heading)
        if found is None:
            found = self._rotations[heading] = (math.sin(heading / 2), math.cos(heading / 2))
        return found

    def _write_values(self, numbers: Sequence[int], nanoseconds: int) -> None:
        places: Iterable[int] = range(len(numbers))
        if self._numbers:
            places = compress(places, map(ne, numbers, self._numbers))
        messages = []
        for place in places:
            value = self._values[place]
            if value is not None:
                channel = self._channels[place] or self._channel(place, value[1])
                messages.append((channel, numbers[place] * value[0]))
        if messages:
            self._writer.add_numbers(nanoseconds, messages)

    def _channel(self, place: int, topic: str) -> int:
        channel = self._channels[place] = self._topics.channel(topic, "std_msgs/msg/Float64")
        return channel

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
        stamp = _stamp(nanoseconds)
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


def _stamp(nanoseconds: int) -> tuple[int, int]:
    return divmod(nanoseconds, 1_000_000_000)


def _transforms(robots: Sequence[str]) -> CdrLayout:
    """Where the robots are as a `TFMessage`; of each x, y, z and a quaternion."""
    transforms = CdrLayout().length(len(robots))
    for robot in robots:
        transforms.numbers("iI").text(FRAME).text(robot).numbers("d" * 7)
    return transforms
