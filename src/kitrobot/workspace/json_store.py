"""Small JSON objects about boards in the user's state folder, each in a file of its own; the oldest entries go."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from kitrobot.files import make_folder, write_atomic
from kitrobot.user_folders import state_folder

_MOST_BYTES = 200_000


def read_map(name: str) -> dict[str, Any]:
    """What is kept there; nothing where it is missing or damaged."""
    try:
        with open(_path(name), "rb") as file:
            found = json.loads(file.read(_MOST_BYTES))
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def write_map(name: str, found: Mapping[str, Any], most: int) -> None:
    """Keeps the last `most` entries, as far as they are no larger than what is read.

    Raises:
        FileError: it cannot be written.
    """
    path = _path(name)
    make_folder(path.parent)
    entries = [*found.items()][-most:]
    data = _bytes(entries)
    while len(data) > _MOST_BYTES:
        entries = entries[len(entries) // 10 + 1 :]
        data = _bytes(entries)
    write_atomic(path, data)


def _bytes(entries: list[tuple[str, Any]]) -> bytes:
    return json.dumps(dict(entries), ensure_ascii=False, indent=1).encode(errors="replace")


def _path(name: str) -> Path:
    return state_folder() / "boards" / name
