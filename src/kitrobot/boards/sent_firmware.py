"""The MicroPython version of each board that received a program from here, stored in the user's state folder.

A running board does not report its version, and asking at its prompt would stop it. So the version reported while
sending is stored by the board's address. It is valid as long as the board holds the program that was sent then.
"""

from __future__ import annotations

from contextlib import suppress

from kitrobot.boards.json_store import read_entries, write_entries
from kitrobot.deploy.installation.deployment import DeployResult
from kitrobot.deploy.line.board import Hello
from kitrobot.files.disk import FileError

_NAME = "firmware"
_MOST_BOARDS = 200
"""Boards that are stored; the oldest are dropped."""


def store_firmware_version(address: str, done: DeployResult) -> None:
    """Stores the version that a board reported while a program was sent; does nothing if it reported none."""
    if not done.micropython:
        return
    found = read_entries(_NAME)
    found.pop(address, None)
    found[address] = {"program": done.program, "generation": done.generation, "micropython": done.micropython}
    with suppress(FileError):
        write_entries(_NAME, found, _MOST_BOARDS)


def load_firmware_version(address: str, hello: Hello) -> str:
    """The MicroPython version of the board at that address; "" when it is not known."""
    known = read_entries(_NAME).get(address)
    if not isinstance(known, dict) or (known.get("program"), known.get("generation")) != (
        hello.program,
        hello.generation,
    ):
        return ""
    return str(known.get("micropython", ""))[:20]
