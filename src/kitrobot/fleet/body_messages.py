"""Messages between an agent and the world that has its body: readings there, commands back, in order.

The world sends a `Frame` for each tick, the oldest again and again until it is answered; ticks are made, and answers
taken, in the order of frames. So each tick is made once and each command given once, however many messages are lost or
doubled. Some frames may be on their way at the same time (`WINDOW`), so that a slow network does not slow ticks down.
An answer also sends the world what the log of the team contains, so that the world, which is no member, knows who was
missed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

from kitrobot.fleet.replica import Effect
from kitrobot.sim.host_step import TickResult
from kitrobot.team.changes import AppliedNote, NewView
from kitrobot.team.commands import Seat
from kitrobot.team.tables import View
from kitrobot.text.json_text import from_json, to_json
from kitrobot.text.sentences import Sentence

Decoded = TypeVar("Decoded")

LARGEST = 1 << 53
MOST_SLOTS = 32
"""Slots of the log in one answer."""

WINDOW = 32
"""Frames of one robot that may be without an answer."""

Slots = tuple[tuple[Effect, ...], ...]


class FrameError(ValueError):
    """Bytes that are not what was expected; its one argument is a `Sentence`."""


@dataclass(frozen=True, slots=True)
class Frame:
    """The readings of a tick.

    Attributes:
        serial: its number, from 1 on.
        known: how many slots of the log the world knows.
        muted: whether the robot has lost its radio.
        down: whether its body has failed or stalled, so that no tick is to be made.
        inputs: its sensors and what of its actuators is done, in the order of its cells.
        taken: the number of the last frame of which the body has the commands: what was done before is not yet in
            `inputs` for later ones.
        first: the oldest frame without an answer, with which a new process begins.
    """

    serial: int
    known: int
    muted: bool
    down: bool
    inputs: tuple[int, ...]
    taken: int = 0
    first: int = 1


@dataclass(frozen=True, slots=True)
class ReplicaSnapshot:
    """A replica after so many slots, as rows of numbers."""

    slot: int
    rows: tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True)
class Reply:
    """The answer to a frame.

    Attributes:
        serial: that of the frame.
        epoch: that of the robot in the agent's replica (see `Replica`); commands of an earlier one are void.
        held: whether the robot may not act now, so that its program waits and its body has to stop.
        quiet: whether the tick changed nothing and nothing of it is on its way.
        ticked: what came of the tick; None where there was none.
        writes: shared variables that it wrote, and their values.
        first: the number of the first slot in `slots`.
        slots: the content of the log from there on.
        snapshot: instead of slots that are forgotten.
    """

    serial: int
    epoch: int
    held: bool = False
    quiet: bool = False
    ticked: TickResult | None = None
    writes: tuple[tuple[int, int], ...] = ()
    first: int = 0
    slots: Slots = field(default=())
    snapshot: ReplicaSnapshot | None = None


def encode_frame(frame: Frame) -> bytes:
    """A frame as bytes."""
    return to_json(
        [frame.serial, frame.known, int(frame.muted), int(frame.down), frame.inputs, frame.taken, frame.first]
    )


def decode_frame(data: bytes) -> Frame:
    """The frame that the bytes are.

    Raises:
        FrameError: they are none.
    """

    def build(rows: list[Any]) -> Frame:
        serial, known, muted, down, inputs, taken, first = rows
        return Frame(
            _number(serial),
            _number(known),
            _number(muted) != 0,
            _number(down) != 0,
            _numbers(inputs),
            _number(taken),
            _number(first),
        )

    return _decode(data, build)


def encode_snapshot(snapshot: ReplicaSnapshot) -> bytes:
    """A replica as bytes."""
    return to_json([snapshot.slot, snapshot.rows])


def decode_snapshot(data: bytes) -> ReplicaSnapshot:
    """The replica that the bytes are.

    Raises:
        FrameError: they are none.
    """
    return _decode(data, _snapshot)


def encode_reply(reply: Reply) -> bytes:
    """An answer as bytes."""
    ticked, snapshot = reply.ticked, reply.snapshot
    return to_json(
        [
            reply.serial,
            reply.epoch,
            int(reply.held),
            int(reply.quiet),
            None if ticked is None else [ticked.cells, ticked.threads, ticked.out],
            reply.writes,
            reply.first,
            [[_plain(effect) for effect in slot] for slot in reply.slots],
            None if snapshot is None else [snapshot.slot, snapshot.rows],
        ]
    )


def decode_reply(data: bytes) -> Reply:
    """The answer that the bytes are.

    Raises:
        FrameError: they are none.
    """

    def build(rows: list[Any]) -> Reply:
        serial, epoch, held, quiet, ticked, writes, first, slots, snapshot = rows
        return Reply(
            _number(serial),
            _number(epoch),
            _number(held) != 0,
            _number(quiet) != 0,
            None if ticked is None else _ticked(ticked),
            tuple((_number(variable), _number(value)) for variable, value in writes),
            _number(first),
            tuple(tuple(_effect(one) for one in slot) for slot in slots[:MOST_SLOTS]),
            None if snapshot is None else _snapshot(snapshot),
        )

    return _decode(data, build)


def _decode(data: bytes, build: Callable[[list[Any]], Decoded]) -> Decoded:
    try:
        rows = from_json(data)
        if isinstance(rows, list):
            return build(rows)
    except (ValueError, TypeError, RecursionError):
        pass
    raise FrameError(Sentence("this is no message between an agent and its body"))


def _number(value: object) -> int:
    if type(value) is not int or not -LARGEST <= value <= LARGEST:
        raise ValueError
    return value


def _numbers(value: Sequence[object]) -> tuple[int, ...]:
    if not isinstance(value, list):
        raise ValueError
    return tuple(map(_number, value))


def _ticked(rows: list[Any]) -> TickResult:
    cells, threads, out = rows
    return TickResult(_numbers(cells), _numbers(threads), tuple(map(_numbers, out)))


def _snapshot(rows: list[Any]) -> ReplicaSnapshot:
    slot, table = rows
    return ReplicaSnapshot(_number(slot), tuple(map(_numbers, table)))


def _plain(effect: Effect) -> list[Any]:
    if isinstance(effect, AppliedNote):
        return [0, *effect.seat, *effect.numbers]
    return [1, effect.view.number, *(number for seat in effect.view.seats for number in seat)]


def _effect(numbers: list[Any]) -> Effect:
    kind, first, *rest = _numbers(numbers)
    if kind == 0:
        return AppliedNote(Seat(first, rest[0]), tuple(rest[1:]))
    return NewView(View(first, tuple(Seat(*pair) for pair in zip(rest[::2], rest[1::2], strict=True))))
