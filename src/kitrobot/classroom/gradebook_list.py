"""The list of pupils that a gradebook exports as CSV, and which of its lines is which pupil of the class.

It is `gradebook.csv` in the class's folder, as Moodle, Canvas or Google Classroom wrote it: the teacher's page keeps it
there, or the teacher puts it there by hand. Columns are found by their names in each language of KitRobot, which the
catalogues have under `column`; commas, semicolons and tabs part them. Nothing else of it is used.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kitrobot.classroom.names import key_of
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import read_bytes, write_atomic
from kitrobot.text.sentences import Sentence
from kitrobot.translation.catalogue import catalogue
from kitrobot.translation.languages import TRANSLATED

NAME: Final = "gradebook.csv"
MOST_BYTES: Final = 4 * 1024 * 1024
_COLUMNS: Final = {
    "student": ("Student", "Full name", "Name", "Pupil"),
    "first": ("First name", "Firstname"),
    "last": ("Last name", "Lastname", "Surname"),
    "email": ("Email address", "Email", "E-mail"),
    "username": ("Username",),
    "number": ("ID number",),
    "id": ("ID",),
    "sis_user": ("SIS User ID",),
    "sis_login": ("SIS Login ID",),
    "section": ("Section",),
}
"""What a column holds, by the names that it has in gradebooks in English (`_in_each_language`)."""
_NO_PUPIL: Final = ("Points Possible", "Student, Test")
"""How lines begin that are of nobody."""
_ZIP: Final = b"PK\x03\x04"
"""How an .xlsx and an .ods file begin."""


class GradebookListError(KitRobotError):
    """A list of a gradebook that cannot be used."""


@dataclass(frozen=True)
class ListedPupil:
    """A line of the list: the name as the gradebook has it, and its other columns by what they hold."""

    name: str
    values: dict[str, str]

    def names(self) -> set[str]:
        """The ways in which the name is written in full, as they are compared."""
        first, last = self.values.get("first", ""), self.values.get("last", "")
        ways = [self.name, f"{first} {last}", f"{last} {first}"]
        if "," in self.name:
            behind, before = (part.strip() for part in self.name.split(",", 1))
            ways.append(f"{before} {behind}")
        return {_plain(way) for way in ways if way.strip()}

    def first_name(self) -> str:
        """The first name alone, as it is compared."""
        first = self.values.get("first", "") or self.name.split(",", 1)[-1]
        words = _plain(first).split()
        return words[0] if words else ""


def _plain(name: str) -> str:
    return key_of(" ".join(name.split()))


def read_gradebook_list(folder: Path) -> list[ListedPupil]:
    """The list in the class's folder; empty where there is none.

    Raises:
        FileError: it cannot be read.
        GradebookListError: it is no list of pupils.
    """
    path = folder / NAME
    return parse_gradebook_list(read_bytes(path)) if path.exists() else []


def keep_gradebook_list(folder: Path, data: bytes) -> list[ListedPupil]:
    """Puts a list into the class's folder, in place of the one that was there; one that is none changes nothing.

    Raises:
        GradebookListError: it is no list of pupils, or has none.
        FileError: it cannot be written.
    """
    help = Sentence("choose the CSV file that your gradebook exports")
    if data.startswith(_ZIP):
        raise GradebookListError(Sentence("this file is a spreadsheet, and the list is a CSV file"), help)
    try:
        listed = parse_gradebook_list(data)
    except GradebookListError as error:
        raise GradebookListError(error.message, help) from None
    if not listed:
        raise GradebookListError(Sentence("this list has no pupils, only the names of its columns"), help)
    path = folder / NAME
    write_atomic(path, data)
    with suppress(OSError):
        # It names pupils, perhaps with their e-mail.
        path.chmod(0o600)
    return listed


def parse_gradebook_list(data: bytes) -> list[ListedPupil]:
    """The pupils of a CSV file.

    Raises:
        GradebookListError: it has no column of names, is too large, or is no CSV file.
    """
    if len(data) > MOST_BYTES:
        raise _no_list(Sentence("it is larger than {most} kB", MOST_BYTES // 1024))
    text = data.decode("utf-8-sig", "replace")
    head = text.split("\n", 1)[0]
    parts_at = max(",;\t", key=head.count)
    try:
        rows = list(csv.reader(io.StringIO(text, newline=""), delimiter=parts_at))
    except csv.Error as error:
        raise _no_list(str(error)) from None
    columns = _columns(rows[0]) if rows else {}
    if "student" not in columns and not {"first", "last"} & columns.keys():
        raise _no_list(Sentence("its first line names no column with the names of pupils"))
    nobody = tuple(_in_each_language(_NO_PUPIL))
    found: list[ListedPupil] = []
    for row in rows[1:]:
        values = {key: " ".join(row[at].split()) for key, at in columns.items() if at < len(row)}
        parts = (values.get("first", ""), values.get("last", ""))
        name = values.get("student", "") or " ".join(part for part in parts if part)
        if name and not _plain(name).startswith(nobody):
            found.append(ListedPupil(name, values))
    return found


def _in_each_language(words: Sequence[str]) -> set[str]:
    """English words and what the catalogues have for them, as they are compared; `|` parts several for one."""
    known = (catalogue(language).word("column", word) or "" for language in TRANSLATED for word in words)
    return {_plain(one) for text in (*words, *known) for one in text.split("|") if one.strip()}


def _columns(head: Sequence[str]) -> dict[str, int]:
    names = [_plain(one.replace("\u2019", "'")) for one in head]
    found: dict[str, int] = {}
    for key, called in _COLUMNS.items():
        wanted = _in_each_language(called)
        at = next((at for at, name in enumerate(names) if name in wanted), None)
        if at is not None:
            found[key] = at
    return found


def match_pupils(names: Sequence[str], listed: Sequence[ListedPupil]) -> list[ListedPupil | None]:
    """For each name of the class its line of the list; None where there is none, or more than one would do.

    A full name goes before a first name alone, which counts only where one pupil of the list and one of the class that
    is left has it.
    """
    claims = [_claim(_plain(name), [one.names() for one in listed]) for name in names]
    free = [at for at in range(len(listed)) if at not in claims]
    firsts = [listed[at].first_name() for at in free]
    for place, name in enumerate(names):
        key = _plain(name)
        if claims[place] is None and firsts.count(key) == 1:
            claims[place] = free[firsts.index(key)]
    return [listed[at] if at is not None and claims.count(at) == 1 else None for at in claims]


def _claim(name: str, listed: Sequence[set[str]]) -> int | None:
    places = [at for at, ways in enumerate(listed) if name in ways]
    return places[0] if len(places) == 1 else None


def _no_list(reason: str) -> GradebookListError:
    return GradebookListError(
        Sentence("`{path}` cannot be used: {reason}", NAME, reason),
        Sentence("put the CSV file there that your gradebook exports, or take it away"),
    )
