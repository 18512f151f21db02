"""Messages of the protocol in as few envelopes as they fit into: what a member sends at one time travels together.

The body of an envelope of the kind `MEMBER` is a row of parts: how many addressees (0: everybody) and how many bytes
as `<HI`, the addressees as `<H` each, then the message. Messages to single members travel with what goes to everybody
in the same step, if there is such a thing and they are small; a member reads only the parts that are for it.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable

from kitrobot.fleet.envelopes import EVERYBODY, EnvelopeError
from kitrobot.team.codec import encode
from kitrobot.team.messages import EVERYONE, Message, OutgoingMessage
from kitrobot.text.sentences import Sentence

SMALL = 1024
"""Bytes up to which a message to a single member is brought to everybody, instead of alone."""
FULL = 1 << 16
"""Bytes from which on the next message begins another envelope."""

_HEAD = struct.Struct("<HI")


def bundle(sendings: Iterable[OutgoingMessage], run: int) -> list[tuple[int, bytes]]:
    """The addressee, a member or `EVERYBODY`, and the body of each envelope: at most `FULL` bytes and one message."""
    parts: list[tuple[list[int], Message]] = []
    for to, message in sendings:
        members = parts[-1][0] if parts and parts[-1][1] is message else [EVERYONE]
        if {to, EVERYONE}.isdisjoint(members) and to != EVERYONE:
            members.append(to)
        else:
            parts.append(([to], message))
    with_all = any(EVERYONE in members for members, _ in parts)
    full: list[tuple[int, bytes]] = []
    bodies: dict[int, bytes] = {}
    for members, message in parts:
        data = encode(message, run)
        for_all = EVERYONE in members
        together = for_all or (with_all and len(data) <= SMALL)
        for addressee in [EVERYBODY] if together else members:
            body = bodies.pop(addressee, b"")
            if len(body) >= FULL:
                full.append((addressee, body))
                body = b""
            bodies[addressee] = body + _part([] if for_all else members, data)
    return [*full, *bodies.items()]


def _part(to: list[int], data: bytes) -> bytes:
    return _HEAD.pack(len(to), len(data)) + struct.pack(f"<{len(to)}H", *to) + data


def unbundle(body: bytes, me: int) -> list[bytes]:
    """The messages in a body that are for a member.

    Raises:
        EnvelopeError: it is cut off, or is no row of parts.
    """
    found: list[bytes] = []
    at = 0
    try:
        while at < len(body):
            count, size = _HEAD.unpack_from(body, at)
            to = struct.unpack_from(f"<{count}H", body, at + _HEAD.size)
            begin = at + _HEAD.size + 2 * count
            at = begin + size
            if not to or me in to:
                found.append(body[begin:at])
    except struct.error:
        at = -1
    if at != len(body):
        raise EnvelopeError(Sentence("this is no message of a fleet, or it is cut off"))
    return found
