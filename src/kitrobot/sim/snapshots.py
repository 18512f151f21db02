"""Snapshots of runs: the bytes of a state with a mark, the run that they are of, and a sum."""

from __future__ import annotations

import zlib

from kitrobot.sim.setup.limits import SimulationError
from kitrobot.text.sentences import Sentence

SNAPSHOT_VERSION = 7
_MARK = b"KRSNAP\n" + bytes([SNAPSHOT_VERSION])
_IDENTITY = 32


def sealed(body: bytes, identity: bytes) -> bytes:
    """A snapshot with that state, of the run with that identity (32 bytes)."""
    return _MARK + identity + zlib.crc32(body).to_bytes(4, "little") + body


def unsealed(snapshot: bytes, identity: bytes) -> bytes:
    """The state of a snapshot.

    Raises:
        SimulationError: the bytes are damaged, or of another run.
    """
    at = len(_MARK) + _IDENTITY + 4
    body = snapshot[at:]
    if snapshot[: len(_MARK)] != _MARK or zlib.crc32(body).to_bytes(4, "little") != snapshot[at - 4 : at]:
        raise damaged()
    if snapshot[len(_MARK) : at - 4] != identity:
        raise SimulationError(
            Sentence("this snapshot is of another run"),
            Sentence("its mission, world, programs, seed or time limit were others"),
        )
    return body


def damaged() -> SimulationError:
    """What is said of bytes that are no snapshot."""
    return SimulationError(Sentence("this is not a whole snapshot of a run"), Sentence("take one with `snapshot()`"))
