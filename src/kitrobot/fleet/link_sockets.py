"""The TCP sockets of Zenoh's links: closing one never waits, and one that reaches nobody ends by itself.

Zenoh opens each TCP connection with `SO_LINGER` of 10 s. So `close` of one whose other end is out of reach waits 10 s,
in one of the two threads that read everything that comes: a process whose peer was cut off heard nobody for 10 s. And
a thread that writes into such a connection waits until the kernel gives it up, which takes a quarter of an hour. Zenoh
has no settings for either, so they are set on the sockets, as soon as it says that there is a new link. Where a
process cannot list its files (Windows), nothing is set.
"""

from __future__ import annotations

import os
import socket
import struct

GIVEN_UP_MS = 8000
"""How long the kernel repeats what nobody confirms; shorter than the 10 s after which Zenoh closes a silent link."""

_FILES = "/dev/fd"
_LINGER = struct.Struct("ii")


def set_up_links() -> int:
    """Sets up the sockets of this process that wait for so long when they are closed; gives how many there were."""
    try:
        files = [int(name) for name in os.listdir(_FILES)]
    except OSError:
        return 0
    return sum(map(_set_up, files))


def _set_up(file: int) -> bool:
    """Sets one up, if it is such a socket. It stays Zenoh's: nothing is copied or closed here."""
    try:
        found = socket.socket(fileno=file)
    except OSError:
        return False
    try:
        if found.type != socket.SOCK_STREAM or found.family not in (socket.AF_INET, socket.AF_INET6):
            return False
        lingers, _ = _LINGER.unpack(found.getsockopt(socket.SOL_SOCKET, socket.SO_LINGER, _LINGER.size))
        if not lingers:
            return False
        found.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, _LINGER.pack(0, 0))
        if hasattr(socket, "TCP_USER_TIMEOUT"):
            found.setsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT, GIVEN_UP_MS)
        return True
    except OSError:
        return False
    finally:
        found.detach()
