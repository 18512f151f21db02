"""Messages between an agent and the world that has its body: readings there, commands back, in order.

The world sends a `Frame` for each tick, the oldest again and again until it is answered; ticks are made, and answers
taken, in the order of frames. So each tick is made once and each command given once, however many messages are lost or
doubled. Some frames may be on their way at the same time (`WINDOW`), so that a slow network does not slow ticks down.
An answer also sends the world what the log of the team contains, so that the world, which is no member, knows who was
missed.
"""

from __future__ import annotations

from typing import Annotated, TypeVar

import msgspec

from kitrobot.fleet.replica import Effect
from kitrobot.team.records import Number, Numbers, Record
from kitrobot.text.sentences import Sentence

Kind = TypeVar("Kind", bound=Record)

MOST_SLOTS = 32
"""Slots of the log in one answer."""

WINDOW = 32
"""Frames of one robot that may be without an answer."""

Slots = Annotated[tuple[tuple[Effect, ...], ...], msgspec.Meta(max_length=MOST_SLOTS)]
Ticked = tuple[Numbers, Numbers, tuple[Numbers, ...]]
"""The fields of a `sim.TickResult`."""


class FrameError(ValueError):
    """Bytes that are not what was expected; its one argument is a `Sentence`."""


class Frame(Record, frozen=True):
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

    serial: Number
    known: Number
    muted: bool
    down: bool
    inputs: Numbers
    taken: Number = 0
    first: Number = 1


class ReplicaSnapshot(Record, frozen=True):
    """A replica after so many slots, as rows of numbers."""

    slot: Number
    rows: tuple[Numbers, ...]


class Reply(Record, frozen=True):
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

    serial: Number
    epoch: Number
    held: bool = False
    quiet: bool = False
    ticked: Ticked | None = None
    writes: tuple[tuple[Number, Number], ...] = ()
    first: Number = 0
    slots: Slots = ()
    snapshot: ReplicaSnapshot | None = None


def encode_record(record: Record) -> bytes:
    """A frame, an answer or a replica as bytes."""
    return msgspec.json.encode(record)


def decode_record(data: bytes, kind: type[Kind]) -> Kind:
    """The record of that kind that the bytes are.

    Raises:
        FrameError: they are none.
    """
    try:
        return msgspec.json.decode(data, type=kind)
    except (msgspec.DecodeError, RecursionError):
        raise FrameError(Sentence("this is no message between an agent and its body")) from None
