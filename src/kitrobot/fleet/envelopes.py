"""What travels between the processes of a fleet: envelopes, each sealed with the key of the team.

An envelope is `KF`, a version, a kind, the run, sender, addressee, a serial number and the process, then its body, then
16 bytes of keyed BLAKE2b over all of it. Whoever has not the key can neither make nor change one. What was recorded of
another run is of no use: the team draws a number for each run, an agent's process one for itself, and the first answer
to an agent has both (`transport`). Repeated envelopes of one run are left to what is in them: all of it is numbered.
"""

from __future__ import annotations

import hmac
import struct
from dataclasses import dataclass
from hashlib import blake2b

from kitrobot.text.sentences import Sentence

VERSION = 5
SEAL = 16
MOST_BYTES = 1 << 20

MEMBER, SNAPSHOT_REQUEST, SNAPSHOT, HELLO, WELCOME, BEGIN, FRAME, REPLY, STOP, BYE = range(10)
"""Messages of the protocol (`bundles`); a request for a replica; a replica; an agent that comes, its answer; the start
of the run; readings of a body, what came of a tick; the emergency stop; the end."""

TEAM_PROCESS, EVERYBODY = 0xFFFF, 0xFFFE
"""Instead of the number of an agent."""

_HEAD = struct.Struct("<2sBBQHHQQ")
_SENDER = struct.Struct("<12xH")
"""The place of the sender, in this version and in those before."""


class EnvelopeError(ValueError):
    """Bytes that are no envelope of this team; its first argument is a `Sentence`."""


class VersionError(EnvelopeError):
    """An envelope of another version; its second argument is the sender that it names, which nothing proves."""


@dataclass(frozen=True, slots=True)
class Envelope:
    """A message with its place.

    Attributes:
        run: the number of the run; 0 before an agent knows it.
        process: the number of the agent's process that it is from, or for; 0: from the team to all.
    """

    kind: int
    run: int
    sender: int
    to: int
    serial: int
    body: bytes
    process: int = 0


def seal(envelope: Envelope, key: bytes) -> bytes:
    """The envelope as bytes."""
    head = _HEAD.pack(
        b"KF",
        VERSION,
        envelope.kind,
        envelope.run,
        envelope.sender,
        envelope.to,
        envelope.serial & (2**64 - 1),
        envelope.process,
    )
    return head + envelope.body + _seal(head + envelope.body, key)


def unseal(data: bytes, key: bytes) -> Envelope:
    """The envelope that the bytes are.

    Raises:
        EnvelopeError: they are cut off, too large, of another version, or sealed with another key.
    """
    if len(data) > MOST_BYTES:
        raise EnvelopeError(Sentence("a message of {size} bytes is too large", len(data)))
    if len(data) < _SENDER.size + SEAL or not data.startswith(b"KF"):
        raise EnvelopeError(Sentence("this is no message of a fleet, or it is cut off"))
    if data[2] != VERSION:
        why = Sentence("a message of version {other}, this is version {own}", data[2], VERSION)
        raise VersionError(why, *_SENDER.unpack_from(data))
    if len(data) < _HEAD.size + SEAL:
        raise EnvelopeError(Sentence("this is no message of a fleet, or it is cut off"))
    _, _, kind, run, sender, to, serial, process = _HEAD.unpack_from(data)
    if not hmac.compare_digest(data[-SEAL:], _seal(data[:-SEAL], key)):
        raise EnvelopeError(Sentence("a message was sealed with another key than this team's, or changed on its way"))
    if kind > BYE:
        raise EnvelopeError(Sentence("this is no message of a fleet, or it is cut off"))
    return Envelope(kind, run, sender, to, serial, data[_HEAD.size : -SEAL], process)


def _seal(data: bytes, key: bytes) -> bytes:
    return blake2b(data, digest_size=SEAL, key=key).digest()
