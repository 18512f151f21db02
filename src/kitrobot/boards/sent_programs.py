"""The names and embedded files of programs that were sent to robots from here, in the user's state folder.

They are stored under the name that the program has on the robot, so that `kitrobot watch` and `kitrobot log` know them
later without the mission.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import asdict, replace
from typing import Any

from kitrobot.files.disk import FileError, write_atomic
from kitrobot.robots.names import NAME_ON_ROBOT, BoardNames
from kitrobot.robots.program import BoardProgram
from kitrobot.robots.recording_context import RecordingContext
from kitrobot.robots.session import InstalledProgram
from kitrobot.trace.model import TracePart
from kitrobot.user_folders import state_folder

_MOST_PROGRAMS = 200
"""Programs whose names are stored; the oldest are dropped."""

_ENDING = ".carried"
_MOST_BYTES = 20_000_000
"""Largest embedded data of one program: more is no mission that a board runs."""


def load_sent_program(called: str) -> InstalledProgram | None:
    """What was kept of a program, by what a robot calls it; None when it was not sent from here."""
    names = load_names(called)
    return InstalledProgram(names, load_recording_context(called)) if names is not None else None


def store_sent_program(program: BoardProgram, called: Iterable[str]) -> None:
    """Stores the names of a program and what recordings of it embed; `called`: its names on robots."""
    names = tuple(called)
    if names:
        store_names(program.names, names)
        store_recording_context(program.recording_context, names)


def store_names(names: BoardNames, called: Iterable[str]) -> None:
    """Stores the names of a program, unless the folder cannot be written; `called`: its names on robots."""
    folder = state_folder() / "boards"
    text = json.dumps(asdict(replace(names, made_of=None)), ensure_ascii=False)
    with suppress(OSError, FileError):
        folder.mkdir(parents=True, exist_ok=True)
        for one in called:
            write_atomic(folder / f"{one}.json", text.encode())
        old = sorted(folder.glob("*.json"), key=lambda path: path.stat().st_mtime, reverse=True)
        for path in old[_MOST_PROGRAMS:]:
            path.unlink(missing_ok=True)


def load_names(called: str) -> BoardNames | None:
    """The stored names of a program, by its name on the robot; None when it was not sent from here."""
    if not NAME_ON_ROBOT.fullmatch(called):
        return None
    try:
        found = json.loads((state_folder() / "boards" / f"{called}.json").read_text(encoding="utf-8"))
        return BoardNames(
            str(found["program"]),
            str(found["robot"]),
            int(found["tick_ms"]),
            {str(name): int(cell) for name, cell in found["sensors"].items()},
            {str(name): int(cell) for name, cell in found["variables"].items()},
            tuple(map(str, found["actuators"])),
            tuple(map(int, found["arguments"])),
            tuple((vertex, int(line), str(text)) for vertex, line, text in found["places"]),
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None


def store_recording_context(carried: RecordingContext | None, called: Iterable[str]) -> None:
    """Keeps it for later, where that can be, beside the names; `called`: what robots call the program."""
    folder = state_folder() / "boards"
    text = json.dumps(asdict(carried), ensure_ascii=False) if carried is not None else ""
    with suppress(OSError, FileError):
        for one in called:
            path = folder / f"{one}{_ENDING}"
            if text and len(text) <= _MOST_BYTES:
                write_atomic(path, text.encode())
            else:
                # The last program sent counts, even if it came from no mission.
                path.unlink(missing_ok=True)
        for path in folder.glob(f"*{_ENDING}"):
            if not path.with_suffix(".json").exists():
                path.unlink(missing_ok=True)


def load_recording_context(called: str) -> RecordingContext | None:
    """What was kept of a program, by what a robot calls it; None when nothing was."""
    if not NAME_ON_ROBOT.fullmatch(called):
        return None
    try:
        path = state_folder() / "boards" / f"{called}{_ENDING}"
        found: Any = json.loads(path.read_text(encoding="utf-8"))
        return RecordingContext(
            str(found["mission"]),
            str(found["world"]),
            tuple(TracePart(str(part["file"]), str(part["text"])) for part in found["parts"]),
            tuple(map(str, found["cells"])),
            tuple(map(int, found["first"])),
            {
                int(number): (str(actuator), str(procedure), tuple(map(int, arguments)))
                for number, (actuator, procedure, arguments) in found["calls"].items()
            },
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None
