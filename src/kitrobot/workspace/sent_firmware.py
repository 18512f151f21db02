"""Which MicroPython the boards have that something was sent to from here, in the user's state folder.

A board that runs does not say it, and asking at its prompt would stop it. So what it said when it was last sent to is
kept, by its address, and holds as long as what is on it is what was sent then.
"""

from __future__ import annotations

from contextlib import suppress

from kitrobot.deploy import Deployed, Hello
from kitrobot.files import FileError
from kitrobot.workspace.json_store import read_map, write_map

_NAME = "firmware"
_KEPT = 200
"""Boards that are remembered; the oldest go."""


def keep_firmware(address: str, done: Deployed) -> None:
    """Keeps what a board said when it was sent to, where that can be."""
    if not done.micropython:
        return
    found = read_map(_NAME)
    found.pop(address, None)
    found[address] = {"program": done.program, "generation": done.generation, "micropython": done.micropython}
    with suppress(FileError):
        write_map(_NAME, found, _KEPT)


def kept_firmware(address: str, hello: Hello) -> str:
    """The version of MicroPython on the board there; "" when it is not known."""
    known = read_map(_NAME).get(address)
    if not isinstance(known, dict) or (known.get("program"), known.get("generation")) != (
        hello.program,
        hello.generation,
    ):
        return ""
    return str(known.get("micropython", ""))[:20]
