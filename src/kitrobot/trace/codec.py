"""Tick records as bytes and back, for one chunk: the first record whole, each further one as what changed.

A chunk is a run of records that can be read without any other. Whole numbers are varints (seven bits a byte, low first,
the high bit says more follow); signed ones are folded first (0, -1, 1, -2, … → 0, 1, 2, 3, …). A record is

    ticks since the record before · n · n × (columns skipped, change)
    · m · m × (agent, threads, (slot, instruction) each) · commands

where the first record of a chunk is a change from all zeros and no threads. Texts are a length and UTF-8. Events stand
apart, so that all events of a long run are found without unpacking its records; an event is

    (record's tick - chunk's first) · (record's tick - event's) · kind · agent + 1 · text · cause
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kitrobot.text.sentences import Recorded, Sentence
from kitrobot.trace.model import Threads, TickRecord, TraceCommand, TraceError, TraceEvent

MAX_ITEMS = 1_000_000
"""Threads, arguments, commands or changes in one record at most, and the largest number of a thread or instruction:
more can only be damage."""
MOST_BITS = 640
"""Of a number: more than any robot has sensors, whose forcing is one bit each, and little enough for a float."""


_UNFOLDED = tuple((folded >> 1) ^ -(folded & 1) for folded in range(128))


def _put(out: bytearray, number: int) -> None:
    while number > 127:
        out.append(number & 127 | 128)
        number >>= 7
    out.append(number)


def _put_signed(out: bytearray, number: int) -> None:
    _put(out, number << 1 if number >= 0 else (-number << 1) - 1)


def _put_text(out: bytearray, text: str) -> None:
    data = text.encode(errors="replace")
    _put(out, len(data))
    out += data


class Encoder:
    """Packs the records of one chunk after another; `take` gives a chunk's bytes and starts the next."""

    def __init__(self, columns: int, agents: int) -> None:
        self._columns = columns
        self._agents = agents
        self._restart()

    def _restart(self) -> None:
        self._out = bytearray()
        self._events = bytearray()
        self._numbers = [0] * self._columns
        self._active: list[Threads] = [()] * self._agents
        self._tick = 0
        self.first_tick = 0
        self.records = 0

    @property
    def last_tick(self) -> int:
        """The tick of the newest record."""
        return self._tick

    @property
    def size(self) -> int:
        """Bytes of this chunk so far, before they are packed."""
        return len(self._out) + len(self._events)

    def add(self, record: TickRecord) -> None:
        """Packs one record behind the others of this chunk."""
        if len(record.numbers) != self._columns or len(record.active) != self._agents:
            raise TraceError(
                Sentence(
                    "a record has {numbers} numbers and {agents} agents; the header of this trace says "
                    "{wanted_numbers} and {wanted_agents}",
                    len(record.numbers),
                    len(record.active),
                    self._columns,
                    self._agents,
                )
            )
        out = self._out
        if self.records == 0:
            self.first_tick = self._tick = record.tick
        elif record.tick <= self._tick:
            raise TraceError(
                Sentence("tick {tick} comes after tick {before} in a trace; ticks must grow", record.tick, self._tick)
            )
        _put(out, record.tick - self._tick)
        self._put_numbers(record.numbers)
        self._put_active(record.active)
        _put(out, len(record.commands))
        for command in record.commands:
            _put(out, command.agent)
            _put_text(out, command.actuator)
            _put_text(out, command.procedure)
            _put(out, len(command.arguments))
            for argument in command.arguments:
                _put_signed(out, argument)
        for event in record.events:
            _put(self._events, record.tick - self.first_tick)
            _put(self._events, record.tick - event.tick)
            _put_text(self._events, event.kind)
            _put(self._events, event.agent + 1)
            _put_text(self._events, event.text)
            _put_text(self._events, event.cause)
        self._tick = record.tick
        self.records += 1

    def _put_numbers(self, numbers: list[int]) -> None:
        before = self._numbers
        if numbers == before:
            self._out.append(0)
            return
        changed = [index for index, number in enumerate(numbers) if number != before[index]]
        out = self._out
        _put(out, len(changed))
        expected = 0
        for index in changed:
            _put(out, index - expected)
            _put_signed(out, numbers[index] - before[index])
            expected = index + 1
        self._numbers = list(numbers)

    def _put_active(self, active: list[Threads]) -> None:
        before = self._active
        if active == before:
            self._out.append(0)
            return
        changed = [agent for agent, threads in enumerate(active) if threads != before[agent]]
        out = self._out
        _put(out, len(changed))
        for agent in changed:
            _put(out, agent)
            _put(out, len(active[agent]))
            for slot, instruction in active[agent]:
                _put(out, slot)
                _put(out, instruction)
        self._active = list(active)

    def take(self) -> tuple[bytes, bytes]:
        """The bytes of this chunk's records and of its events; the next record starts a new one."""
        data = bytes(self._out), bytes(self._events)
        self._restart()
        return data


class _Bytes:
    """Reads what `_put` wrote; damage is a ValueError or an IndexError, which callers turn into a sentence."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.at = 0

    def number(self) -> int:
        at = self.at
        self.at = at + 1
        value = self.data[at]
        return value if value < 128 else self._longer(value & 127)

    def _longer(self, value: int) -> int:
        """A number of which `value` was the first byte."""
        data, at = self.data, self.at
        shift, byte = 7, 128
        while byte > 127:
            if shift > MOST_BITS:
                raise ValueError(Sentence("a number without end"))
            byte = data[at]
            at += 1
            value |= (byte & 127) << shift
            shift += 7
        self.at = at
        return value

    def signed(self) -> int:
        folded = self.number()
        return (folded >> 1) ^ -(folded & 1)

    def count(self) -> int:
        value = self.number()
        if value > MAX_ITEMS:
            raise ValueError(Sentence("a count beyond all reason"))
        return value

    def add_changes(self, numbers: list[int]) -> None:
        """Adds a record's changes to the numbers: most of a trace, so that the common numbers need no call."""
        count, index = self.count(), 0
        data, at = self.data, self.at
        for _ in range(count):
            skipped, folded = data[at], data[at + 1]
            if skipped | folded < 128:
                at += 2
                change = _UNFOLDED[folded]
            else:
                self.at = at
                skipped, change = self.number(), self.signed()
                at = self.at
            index += skipped
            numbers[index] += change
            index += 1
        self.at = at

    def text(self) -> str:
        length = self.number()
        at = self.at
        self.at = end = at + length
        if end > len(self.data):
            raise ValueError(Sentence("a text longer than its chunk"))
        return self.data[at:end].decode()


def decode(data: bytes, first_tick: int, records: int, columns: int, agents: int) -> Iterator[TickRecord]:
    """The records of one chunk, in order, without their events.

    The lists `numbers` and `active` are the same ones each time, changed in place: a record holds until the next one is
    asked for.

    Raises:
        TraceError: the bytes are not a chunk of this shape.
    """
    source = _Bytes(data)
    numbers = [0] * columns
    active: list[Threads] = [()] * agents
    tick = first_tick
    try:
        for made in range(records):
            later = source.number()
            if (later == 0) != (made == 0):
                raise ValueError("tick")
            tick += later
            source.add_changes(numbers)
            for _ in range(source.count()):
                agent = source.number()
                active[agent] = tuple((source.count(), source.count()) for _ in range(source.count()))
            commands = [
                TraceCommand(
                    _one_of(source.number(), agents),
                    source.text(),
                    source.text(),
                    tuple(source.signed() for _ in range(source.count())),
                )
                for _ in range(source.count())
            ]
            yield TickRecord(tick, numbers, active, commands)
        if source.at != len(data):
            raise ValueError("rest")
    except (IndexError, ValueError) as error:
        raise TraceError(
            Sentence("the trace is damaged after tick {tick}: its records do not make sense", tick)
        ) from error


def decode_events(
    data: bytes, first_tick: int, last_tick: int, agents: int, recorded: Callable[[str], Recorded] = Recorded
) -> Iterator[tuple[int, TraceEvent]]:
    """(tick of its record, event) of one chunk, in order; `recorded` makes the sentence of a text.

    Raises:
        TraceError: the bytes are not the events of such a chunk.
    """
    source = _Bytes(data)
    before = 0
    try:
        while source.at < len(data):
            later, ago = source.number(), source.number()
            tick = first_tick + later
            if not before <= later <= last_tick - first_tick or ago > tick:
                raise ValueError("tick")
            before = later
            kind, agent, text, cause = source.text(), source.number(), source.text(), source.text()
            yield tick, TraceEvent(tick - ago, kind, _one_of(agent, agents + 1) - 1, recorded(text), cause)
    except (IndexError, ValueError) as error:
        raise TraceError(
            Sentence("the trace is damaged after tick {tick}: its events do not make sense", first_tick)
        ) from error


def _one_of(number: int, count: int) -> int:
    if number >= count:
        raise ValueError("agent")
    return number
