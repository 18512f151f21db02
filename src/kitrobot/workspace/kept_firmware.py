"""Which MicroPython the boards have that something was sent to from here, in the user's state folder.

A board that runs does not say it, and asking at its prompt would stop it. So what it said when it was last sent to is
kept, by its address, and holds as long as what is on it is what was sent then.
"""

from __future__ import annotations

import json
from contextlib import suppress
from typing import Any

from kitrobot.deploy import Deployed, Hello
from kitrobot.files import FileError, state_folder, write_atomic

_KEPT = 200
"""Boards that are remembered; the oldest go."""

_MOST_BYTES = 200_000


def keep_firmware(address: str, done: Deployed) -> None:
    """Keeps what a board said when it was sent to, where that can be."""
    if not done.micropython:
        return
    found = _kept()
    found.pop(address, None)
    found[address] = {"program": done.program, "generation": done.generation, "micropython": done.micropython}
    while len(found) > _KEPT:
        found.pop(next(iter(found)))
    folder = state_folder() / "boards"
    with suppress(OSError, FileError):
        folder.mkdir(parents=True, exist_ok=True)
        write_atomic(_path(), json.dumps(found).encode())


def kept_firmware(address: str, hello: Hello) -> str:
    """The version of MicroPython on the board there; "" when it is not known."""
    known = _kept().get(address)
    if not isinstance(known, dict) or (known.get("program"), known.get("generation")) != (
        hello.program,
        hello.generation,
    ):
        return ""
    return str(known.get("micropython", ""))[:20]


def _path() -> Any:
    return state_folder() / "boards" / "firmware"


def _kept() -> dict[str, Any]:
    try:
        with open(_path(), "rb") as file:
            found = json.loads(file.read(_MOST_BYTES))
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}
