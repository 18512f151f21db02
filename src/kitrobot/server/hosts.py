"""Which hosts are this machine: what it listens on, who asks, and whom a request names."""

from __future__ import annotations

import ipaddress
from collections.abc import Mapping


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
