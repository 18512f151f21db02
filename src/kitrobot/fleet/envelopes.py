"""What travels between the processes of a fleet: envelopes, each sealed with the key of the team.

An envelope is `KF`, a version, a kind, the run, sender, addressee and a serial number, then its body, then 16 bytes
of keyed BLAKE2b over all of it. Whoever has not the key can neither make nor change one; one of another run is told
apart from them. Repeated envelopes are left to what is in them: all of it is numbered.
"""

from __future__ import annotations

import hmac
import struct
from dataclasses import dataclass
from hashlib import blake2b

from kitrobot.text import Sentence

VERSION = 3
SEAL = 16
MOST_BYTES = 1 << 20
LEAST_KEY, MOST_KEY = 16, 64
"""Bytes of a key."""

MEMBER, ASK, WHOLE, HELLO, WELCOME, BEGIN, FRAME, REPLY, STOP, BYE = range(10)
"""Messages of the protocol (`bundles`); who asks for a replica; a replica; an agent that comes, its answer; the start
of the run; readings of a body, what came of a tick; the emergency stop; the end."""

TEAM_PROCESS, EVERYBODY = 0xFFFF, 0xFFFE
"""Instead of the number of an agent."""

_HEAD = struct.Struct("<2sBBQHHQ")


class EnvelopeError(ValueError):
    """Bytes that are no envelope of this team; its one argument is a `Sentence`."""


@dataclass(frozen=True, slots=True)
class Envelope:
    """A message with its place: `run` is 0 before an agent knows it."""

    kind: int
    run: int
    sender: int
    to: int
    serial: int
    body: bytes


def sealed(envelope: Envelope, key: bytes) -> bytes:
    """The envelope as bytes."""
    head = _HEAD.pack(
        b"KF", VERSION, envelope.kind, envelope.run, envelope.sender, envelope.to, envelope.serial & (2**64 - 1)
    )
    return head + envelope.body + _seal(head + envelope.body, key)


def opened(data: bytes, key: bytes) -> Envelope:
    """The envelope that the bytes are.

    Raises:
        EnvelopeError: they are cut off, too large, of another version, or sealed with another key.
    """
    if len(data) > MOST_BYTES:
        raise EnvelopeError(Sentence("a message of {size} bytes is too large", len(data)))
    if len(data) < _HEAD.size + SEAL or not data.startswith(b"KF"):
        raise EnvelopeError(Sentence("this is no message of a fleet, or it is cut off"))
    _, version, kind, run, sender, to, serial = _HEAD.unpack_from(data)
    if version != VERSION:
        raise EnvelopeError(Sentence("a message of version {other}, this is version {own}", version, VERSION))
    if not hmac.compare_digest(data[-SEAL:], _seal(data[:-SEAL], key)):
        raise EnvelopeError(Sentence("a message was sealed with another key than this team's, or changed on its way"))
    if kind > BYE:
        raise EnvelopeError(Sentence("this is no message of a fleet, or it is cut off"))
    return Envelope(kind, run, sender, to, serial, data[_HEAD.size : -SEAL])


def _seal(data: bytes, key: bytes) -> bytes:
    return blake2b(data, digest_size=SEAL, key=key).digest()
