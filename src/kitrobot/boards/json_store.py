"""Small JSON objects about boards, one file each in the user's state folder; the oldest entries are dropped."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from kitrobot.files.disk import make_folder, write_atomic
from kitrobot.user_folders import state_folder

_MOST_BYTES = 200_000


def read_entries(name: str) -> dict[str, Any]:
    """The entries of the file; {} if it is missing or damaged."""
    try:
        with open(_path(name), "rb") as file:
            found = json.loads(file.read(_MOST_BYTES))
    except (OSError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def write_entries(name: str, found: Mapping[str, Any], most: int) -> None:
    """Stores the last `most` entries, fewer if they would take more than the `_MOST_BYTES` that are read back.

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
