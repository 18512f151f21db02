"""What outlives a class's process: `class.toml` in its folder, which a person can read.

Of secrets it holds digests only; the words by which pupils come back stand there in plain letters, so that a teacher
can tell a forgetful pupil. Writing puts a whole file in the old one's place, so a kill leaves the old or the new one.
"""

from __future__ import annotations

import contextlib
import json
import os
import tomllib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from kitrobot.classroom.names import as_file_name, clean_code, key_of
from kitrobot.files import FileError, read_text, write_atomic
from kitrobot.text import Sentence

NAME: Final = "class.toml"
MOST_KEYS: Final = 4
"""Browsers that a pupil can be let in from; the oldest is forgotten when there are more."""

_HEAD = """# A class of KitRobot. While the class runs this file is written anew: edit it when it does not.
# `word` brings a pupil back from another computer; `keys` are digests of what their browsers keep.
"""


@dataclass
class PupilRecord:
    """A pupil: name, folder, the word to come back with, digests of keys, what they got last, whether to look up."""

    name: str
    folder: str
    word: str
    keys: list[str] = field(default_factory=list)
    handed: int = 0
    handed_file: str = ""
    frozen: bool = False

    def gets(self, key: str) -> None:
        """Another browser of the pupil."""
        self.keys = [*self.keys, key][-MOST_KEYS:]


@dataclass
class ClassRecord:
    """A class. `code` lets pupils in; "" while nobody can join. `frozen` counts for all, those who come later too."""

    name: str
    code: str = ""
    exercise: str = ""
    frozen: bool = False
    pupils: list[PupilRecord] = field(default_factory=list)


def read_record(folder: Path) -> ClassRecord | None:
    """The class of a folder; None where there is none yet.

    Raises:
        FileError: the file cannot be read, or is no class.
    """
    path = folder / NAME
    if not path.exists():
        return None
    try:
        found = tomllib.loads(read_text(path))
        if not found:
            return None  # ended before its first line
        pupils = [_pupil(one) for one in _list(found.get("pupil", []))]
        name, code, exercise = (_text(found, key) for key in ("name", "code", "exercise"))
        record = ClassRecord(
            name or folder.resolve().name, clean_code(code), exercise, found.get("frozen") is True, pupils
        )
    except (tomllib.TOMLDecodeError, ValueError, TypeError, RecursionError) as error:
        raise _no_class(path, str(error)) from None
    for seen in ({key_of(one.name) for one in pupils}, {key_of(one.folder) for one in pupils}):
        if len(seen) < len(pupils):
            raise _no_class(path, Sentence("two pupils have one name or one folder"))
    return record


def write_record(folder: Path, record: ClassRecord) -> None:
    """Puts it in the folder.

    Raises:
        FileError: it cannot be written; the old one is still there.
    """
    lines = [
        _HEAD,
        f"name = {_string(record.name)}",
        f"code = {_string(record.code)}",
        f"exercise = {_string(record.exercise)}",
        f"frozen = {'true' if record.frozen else 'false'}",
    ]
    for pupil in record.pupils:
        keys = ", ".join(_string(key) for key in pupil.keys)
        lines += [
            "",
            "[[pupil]]",
            f"name = {_string(pupil.name)}",
            f"folder = {_string(pupil.folder)}",
            f"word = {_string(pupil.word)}",
            f"keys = [{keys}]",
            f"handed = {pupil.handed}",
            f"handed_file = {_string(pupil.handed_file)}",
            *(["frozen = true"] if pupil.frozen else []),
        ]
    path = folder / NAME
    if not path.exists():
        # Words and digests are the teacher's alone; a file that is there keeps its mode.
        with contextlib.suppress(OSError):
            os.close(os.open(path, os.O_WRONLY | os.O_CREAT, 0o600))
    write_atomic(path, ("\n".join(lines) + "\n").encode(errors="replace"))


def _string(text: str) -> str:
    """A basic string of TOML: JSON's, but for the one sign that JSON lets stand."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _text(table: dict[str, Any], key: str) -> str:
    value = table.get(key, "")
    if not isinstance(value, str):
        raise TypeError(Sentence("`{key}` is no text", key))
    return value


def _list(value: Any) -> list[Any]:
    if not isinstance(value, list):
        raise TypeError(Sentence("`{key}` is no list", "pupil"))
    return value


def _pupil(table: Any) -> PupilRecord:
    if not isinstance(table, dict):
        raise TypeError(Sentence("`{key}` is no list", "pupil"))
    name, folder = _text(table, "name"), _text(table, "folder")
    if not name or as_file_name(folder) != folder:
        raise ValueError(Sentence("a pupil's folder is missing, or leads out of the class"))
    keys = [str(key) for key in _list(table.get("keys", []))]
    handed, file = table.get("handed", 0), _text(table, "handed_file")
    if not isinstance(handed, int) or (file and as_file_name(file) != file):
        raise ValueError(Sentence("`{key}` makes no sense", "handed"))
    return PupilRecord(
        name, folder, clean_code(_text(table, "word")), keys[-MOST_KEYS:], handed, file, table.get("frozen") is True
    )


def _no_class(path: Path, reason: str) -> FileError:
    return FileError(
        Sentence("`{path}` cannot be used: {reason}", path, reason),
        Sentence("mend it, or move it away: the folders of the pupils stay as they are"),
        path=path,
    )
