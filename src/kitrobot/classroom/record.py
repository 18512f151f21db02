"""The persistent state of a class: `class.toml` in its folder, which a person can read.

Of secrets it contains digests only; the words by which pupils come back are in plain text, so that a teacher can remind
a pupil. Writing replaces the whole file, so a kill leaves the old or the new one.

A pupil whose lines cannot be read is left out of the class, and the others remain: the lines stay in the file word for
word (`UnreadPupil`) until a person corrects them.
"""

from __future__ import annotations

import contextlib
import os
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from kitrobot.classroom.marks import Mark, mark_lines, marks_of
from kitrobot.classroom.names import clean_code, is_file_name, key_of
from kitrobot.classroom.toml_values import count_of, list_of, text_of, toml_string
from kitrobot.files.disk import FileError, read_bytes, write_atomic
from kitrobot.text.forms import line_feeds
from kitrobot.text.sentences import Sentence

NAME: Final = "class.toml"
USUAL_PLACES: Final = 100
"""Pupils that a class takes until its teacher says otherwise."""
MOST_KEYS: Final = 4
"""Browsers that a pupil can be let in from; the oldest is forgotten when there are more."""
MOST_WORKS: Final = 200
"""Exercises whose file is known; the oldest is forgotten when there are more."""

_HEAD = """# A class of KitRobot. While the class runs this file is written anew: edit it when it does not.
# `word` brings a pupil back from another computer; `keys` are digests of what their browsers keep.
"""


@dataclass
class PupilRecord:
    """A pupil: name, folder, the word to come back with, digests of keys, what they got last, whether to look up,
    whether the hand is up, what the teacher wrote last with its number, a mark for each exercise that was graded, and
    the file that was handed in last for each exercise.
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
    marks: list[Mark] = field(default_factory=list)
    works: dict[str, str] = field(default_factory=dict)

    def hands_in(self, exercise: str, file: str) -> bool:
        """The file is the work for that exercise from now on; False where it was before, or nobody said for which."""
        if not exercise or self.works.get(exercise) == file:
            return False
        # In the order in which they came, so that the oldest is forgotten.
        kept = [one for one in self.works.items() if one[0] != exercise and one[1] != file]
        self.works = dict([*kept, (exercise, file)][-MOST_WORKS:])
        return True

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
        name, code, exercise = (text_of(found, key) for key in ("name", "code", "exercise"))
        record = ClassRecord(
            name or folder.resolve().name,
            clean_code(code),
            exercise,
            found.get("frozen") is True,
            places=count_of(found, "places", USUAL_PLACES),
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
        name = text_of(table, "name")
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
        f"name = {toml_string(record.name)}",
        f"code = {toml_string(record.code)}",
        f"exercise = {toml_string(record.exercise)}",
        f"frozen = {'true' if record.frozen else 'false'}",
        f"places = {record.places}",
    ]
    for pupil in record.pupils:
        keys = ", ".join(toml_string(key) for key in pupil.keys)
        lines += [
            "",
            "[[pupil]]",
            f"name = {toml_string(pupil.name)}",
            f"folder = {toml_string(pupil.folder)}",
            f"word = {toml_string(pupil.word)}",
            f"keys = [{keys}]",
            f"handed = {pupil.handed}",
            f"handed_file = {toml_string(pupil.handed_file)}",
            *(["frozen = true"] if pupil.frozen else []),
            *(["hand = true"] if pupil.hand else []),
            *([f"note = {pupil.note}", f"note_text = {toml_string(pupil.note_text)}"] if pupil.note else []),
            *([f"works = {{ {_pairs(pupil.works)} }}"] if pupil.works else []),
            *mark_lines(pupil.marks),
        ]
    lines += ["", *(one.text.strip("\n") for one in record.unread)]
    path = folder / NAME
    if not path.exists():
        # Words and digests are the teacher's alone; a file that is there keeps its mode.
        with contextlib.suppress(OSError):
            os.close(os.open(path, os.O_WRONLY | os.O_CREAT, 0o600))
    write_atomic(path, ("\n".join(lines) + "\n").encode(errors="surrogateescape"))


def _pairs(works: dict[str, str]) -> str:
    return ", ".join(f"{toml_string(exercise)} = {toml_string(file)}" for exercise, file in works.items())


def _works(table: dict[str, Any]) -> dict[str, str]:
    works = table.get("works", {})
    if not isinstance(works, dict) or not all(isinstance(one, str) and is_file_name(one) for one in works.values()):
        raise ValueError(Sentence("`{key}` makes no sense", "works"))
    return dict(list(works.items())[-MOST_WORKS:])


def _pupil(table: dict[str, Any]) -> PupilRecord:
    name, folder = text_of(table, "name"), text_of(table, "folder")
    if not name or not is_file_name(folder):
        raise ValueError(Sentence("a pupil's folder is missing, or leads out of the class"))
    keys = [str(key) for key in list_of(table, "keys")]
    file = text_of(table, "handed_file")
    if file and not is_file_name(file):
        raise ValueError(Sentence("`{key}` makes no sense", "handed"))
    return PupilRecord(
        name,
        folder,
        clean_code(text_of(table, "word")),
        keys[-MOST_KEYS:],
        count_of(table, "handed", 0),
        file,
        table.get("frozen") is True,
        table.get("hand") is True,
        count_of(table, "note", 0),
        text_of(table, "note_text"),
        marks_of(table),
        _works(table),
    )


def _no_class(path: Path, reason: str) -> FileError:
    return FileError(
        Sentence("`{path}` cannot be used: {reason}", path, reason),
        Sentence("mend it, or move it away: the folders of the pupils stay as they are"),
        path=path,
    )
