"""Which hosts are this machine: what it listens on, who asks, and whom a request names."""

from __future__ import annotations

import ipaddress
import socket
import struct
import sys
from collections.abc import Mapping
from contextlib import suppress
from typing import Final

_ADDRESS_OF_INTERFACE: Final = 0x8915
"""`SIOCGIFADDR` of Linux."""


def host_number(host: str) -> str:
    """A host without the brackets of IPv6; `localhost` as its number."""
    return "127.0.0.1" if host == "localhost" else host.strip("[]")


def is_loopback(host: str) -> bool:
    """Whether a host, by name or number, is this machine as only this machine reaches it."""
    try:
        return ipaddress.ip_address(host_number(host)).is_loopback
    except ValueError:
        return False


def named_host(headers: Mapping[str, str]) -> str:
    """The host that a request names, without its port; "" where that is none."""
    host = headers.get("host", "").lower()
    name, _, port = host.rpartition(":") if not host.endswith("]") and ":" in host else (host, "", "")
    return "" if port and not port.isdecimal() else name


def machine_names() -> tuple[str, ...]:
    """The names under which others in the network reach this machine, in small letters: its own, and that of mDNS."""
    name = socket.gethostname().lower()
    names = (name, f"{name.split('.')[0]}.local")
    usable = name.isascii() and 0 < len(name) < 128 and name not in ("localhost", "localhost.localdomain")
    return tuple(dict.fromkeys(names)) if usable else ()


def machine_addresses() -> tuple[str, ...]:
    """The addresses of this machine by IPv4 that others can reach, sorted. (Those of IPv6 change each day.)"""
    found = set()
    with suppress(OSError):
        found = {str(one[4][0]) for one in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)}
    if sys.platform == "linux":
        import fcntl

        # There the name of the machine leads to loopback only.
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
            for _, interface in socket.if_nameindex():
                with suppress(OSError):  # it has no address
                    request = struct.pack("256s", interface.encode()[:15])
                    answer = fcntl.ioctl(asked.fileno(), _ADDRESS_OF_INTERFACE, request)
                    found.add(socket.inet_ntoa(answer[20:24]))
    numbers = sorted(map(ipaddress.IPv4Address, found))
    return tuple(str(one) for one in numbers if not one.is_loopback and not one.is_unspecified)
