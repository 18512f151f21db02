"""The persistent state of a class: `class.toml` in its folder, which a person can read.

Of secrets it contains digests only; the words by which pupils come back are in plain text, so that a teacher can remind
a pupil. Writing replaces the whole file, so a kill leaves the old or the new one.

A pupil whose lines cannot be read is left out of the class, and the others remain: the lines stay in the file word for
word (`UnreadPupil`) until a person corrects them.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from kitrobot.classroom.names import clean_code, is_file_name, key_of
from kitrobot.files.disk import FileError, read_bytes, write_atomic
from kitrobot.text.forms import line_feeds
from kitrobot.text.sentences import Sentence

NAME: Final = "class.toml"
USUAL_PLACES: Final = 100
"""Pupils that a class takes until its teacher says otherwise."""
MOST_KEYS: Final = 4
"""Browsers that a pupil can be let in from; the oldest is forgotten when there are more."""

_HEAD = """# A class of KitRobot. While the class runs this file is written anew: edit it when it does not.
# `word` brings a pupil back from another computer; `keys` are digests of what their browsers keep.
"""


@dataclass
class PupilRecord:
    """A pupil: name, folder, the word to come back with, digests of keys, what they got last, whether to look up,
    whether the hand is up, and what the teacher wrote last with its number.
    """

    name: str
    folder: str
    word: str
    keys: list[str] = field(default_factory=list)
    handed: int = 0
    handed_file: str = ""
    frozen: bool = False
    hand: bool = False
    note: int = 0
    note_text: str = ""

    def gets(self, key: str) -> None:
        """Another browser of the pupil."""
        self.keys = [*self.keys, key][-MOST_KEYS:]


@dataclass(frozen=True)
class UnreadPupil:
    """The lines of a pupil that cannot be read, the number of the first one, from 1, and why; `name` as far as it is
    known.
    """

    text: str
    line: int
    name: str
    reason: str


@dataclass
class ClassRecord:
    """A class. `code` lets pupils in; "" while nobody can join. `frozen` counts for all, those who come later too.
    There is room for as many pupils as `places`.
    """

    name: str
    code: str = ""
    exercise: str = ""
    frozen: bool = False
    pupils: list[PupilRecord] = field(default_factory=list)
    places: int = USUAL_PLACES
    unread: list[UnreadPupil] = field(default_factory=list)


_PUPIL = re.compile(r"^[ \t]*\[\[[ \t]*pupil[ \t]*\]\]", re.MULTILINE)


def read_record(folder: Path) -> ClassRecord | None:
    """The class of a folder; None where there is none yet.

    Raises:
        FileError: the file cannot be read, or is no class.
    """
    path = folder / NAME
    if not path.exists():
        return None
    # A pupil's lines in another encoding are that pupil's loss alone: they stay as they are.
    text = line_feeds(read_bytes(path).decode("utf-8-sig", "surrogateescape"))
    starts = [found.start() for found in _PUPIL.finditer(text)]
    head, *parts = (text[a:b] for a, b in zip([0, *starts], [*starts, len(text)], strict=True))
    try:
        found = tomllib.loads(head)
        if not found and not parts:
            return None  # ended before its first line
        if "pupil" in found:
            raise TypeError(Sentence("`{key}` is no list", "pupil"))
        name, code, exercise = (_text(found, key) for key in ("name", "code", "exercise"))
        record = ClassRecord(
            name or folder.resolve().name,
            clean_code(code),
            exercise,
            found.get("frozen") is True,
            places=_count(found, "places", USUAL_PLACES),
        )
    except (tomllib.TOMLDecodeError, ValueError, TypeError, RecursionError) as error:
        raise _no_class(path, _reason(error)) from None
    for start, part in zip(starts, parts, strict=True):
        _read_pupil(record, part, text.count("\n", 0, start) + 1)
    return record


def unread_sentence(one: UnreadPupil) -> Sentence:
    """What the teacher is to know of a pupil who was left out."""
    if not one.name:
        return Sentence(
            "a pupil is not in the class: from line {line} on `{file}` makes no sense ({reason}); mend it while"
            " the class is closed",
            one.line,
            NAME,
            one.reason,
        )
    return Sentence(
        "`{name}` is not in the class: from line {line} on `{file}` makes no sense ({reason}); mend it while the"
        " class is closed",
        one.name,
        one.line,
        NAME,
        one.reason,
    )


def _read_pupil(record: ClassRecord, text: str, line: int) -> None:
    """Adds the pupil of those lines to the record, or the lines where they cannot be read."""
    name = ""
    try:
        text.encode()
        table = tomllib.loads(text)["pupil"][0]
        name = _text(table, "name")
        pupil = _pupil(table)
        folders = {key_of(one.folder) for one in record.pupils}
        if any(one.name == name for one in record.pupils) or key_of(pupil.folder) in folders:
            raise ValueError(Sentence("two pupils have one name or one folder"))
    except UnicodeEncodeError:
        record.unread.append(UnreadPupil(text, line, name, Sentence("it is not text in UTF-8")))
    except (tomllib.TOMLDecodeError, ValueError, TypeError, RecursionError) as error:
        record.unread.append(UnreadPupil(text, line, name, _reason(error)))
    else:
        record.pupils.append(pupil)


def _reason(error: Exception) -> str:
    """The sentence that an error was raised with, or the reader's own words."""
    return error.args[0] if error.args and isinstance(error.args[0], Sentence) else str(error)


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
        f"places = {record.places}",
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
            *(["hand = true"] if pupil.hand else []),
            *([f"note = {pupil.note}", f"note_text = {_string(pupil.note_text)}"] if pupil.note else []),
        ]
    lines += ["", *(one.text.strip("\n") for one in record.unread)]
    path = folder / NAME
    if not path.exists():
        # Words and digests are the teacher's alone; a file that is there keeps its mode.
        with contextlib.suppress(OSError):
            os.close(os.open(path, os.O_WRONLY | os.O_CREAT, 0o600))
    write_atomic(path, ("\n".join(lines) + "\n").encode(errors="surrogateescape"))


def _string(text: str) -> str:
    """A basic string of TOML: JSON's, but for the one sign that JSON lets stand."""
    text = text.encode(errors="replace").decode()
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


def _pupil(table: dict[str, Any]) -> PupilRecord:
    name, folder = _text(table, "name"), _text(table, "folder")
    if not name or not is_file_name(folder):
        raise ValueError(Sentence("a pupil's folder is missing, or leads out of the class"))
    keys = [str(key) for key in _list(table.get("keys", []))]
    file = _text(table, "handed_file")
    if file and not is_file_name(file):
        raise ValueError(Sentence("`{key}` makes no sense", "handed"))
    return PupilRecord(
        name,
        folder,
        clean_code(_text(table, "word")),
        keys[-MOST_KEYS:],
        _count(table, "handed", 0),
        file,
        table.get("frozen") is True,
        table.get("hand") is True,
        _count(table, "note", 0),
        _text(table, "note_text"),
    )


def _count(table: dict[str, Any], key: str, usual: int) -> int:
    found = table.get(key, usual)
    if not isinstance(found, int) or isinstance(found, bool) or found < 0:
        raise ValueError(Sentence("`{key}` makes no sense", key))
    return found


def _no_class(path: Path, reason: str) -> FileError:
    return FileError(
        Sentence("`{path}` cannot be used: {reason}", path, reason),
        Sentence("mend it, or move it away: the folders of the pupils stay as they are"),
        path=path,
    )
