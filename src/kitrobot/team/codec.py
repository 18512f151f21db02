"""Messages as bytes: JSON lists `[version, run, [kind, field, …]]`, read by the types of the fields and nothing else.

`run` is a number that all members of one run share, so that an earlier run is not heard. Reading never fails with
anything but `MessageError`, whatever the bytes are: cut off, too large, of another version, of wrong types.
"""

from __future__ import annotations

import msgspec

from kitrobot.team.messages import Message
from kitrobot.text.sentences import Sentence

VERSION = 3
MOST_BYTES = 1 << 18


class MessageError(ValueError):
    """Bytes that are no message of this run; its one argument is a `Sentence`."""


class _Head(msgspec.Struct, array_like=True):
    """Of a message of any version: what else is in it is not read."""

    version: int
    run: int
    message: msgspec.Raw


_HEAD = msgspec.json.Decoder(_Head)
_MESSAGE: msgspec.json.Decoder[Message] = msgspec.json.Decoder(Message)


def encode(message: Message, run: int) -> bytes:
    """The message as bytes, at most `MOST_BYTES` for any message that a member sends."""
    return msgspec.json.encode((VERSION, run, message))


def decode(data: bytes, run: int) -> Message:
    """The message that the bytes stand for.

    Raises:
        MessageError: they are no message of this version and run.
    """
    if len(data) > MOST_BYTES:
        raise MessageError(Sentence("a message of {size} bytes is too large", len(data)))
    try:
        head = _HEAD.decode(data)
        if head.version != VERSION:
            raise MessageError(Sentence("a message of version {other}, this is version {own}", head.version, VERSION))
        if head.run != run:
            raise MessageError(Sentence("a message of another run"))
        return _MESSAGE.decode(head.message)
    except (msgspec.DecodeError, RecursionError):
        raise MessageError(Sentence("this is no message of a team")) from None
