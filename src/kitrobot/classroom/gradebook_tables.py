"""The marks of a class as CSV, in the form that a gradebook imports.

- Moodle (Grades → Import → CSV file) finds a pupil by one column, and takes points and feedback from columns that the
  teacher assigns. A cell of that column is never empty: Moodle would give such a line's points to the pupil before.
- Canvas (Grades → Import) wants the columns `Student`, `ID`, `SIS User ID`, `SIS Login ID` and `Section` in this order,
  and a second line with the points of each assignment. It takes no comments.
- A plain sheet, also for Google Classroom, which imports no marks.

UTF-8 with a byte order mark, which spreadsheets need and both gradebooks skip. No cell can begin as a formula.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Literal, get_args

from kitrobot.classroom.grade_tables import as_cell
from kitrobot.classroom.gradebook_list import ListedPupil, match_pupils
from kitrobot.classroom.marks import Mark, find_mark
from kitrobot.classroom.record import PupilRecord

Gradebook = Literal["moodle", "canvas", "sheet"]
GRADEBOOKS: Final[tuple[Gradebook, ...]] = get_args(Gradebook)
_IDENTITIES: Final = (("email", "Email address"), ("username", "Username"), ("number", "ID number"))


@dataclass(frozen=True)
class MarksTable:
    """The CSV file of a class's marks.

    Attributes:
        text: the file, with its byte order mark.
        exercises: how many exercises it has.
        unlisted: pupils of the class whom the gradebook's list does not have, or has more than once.
    """

    text: str
    exercises: int
    unlisted: tuple[str, ...]

    @property
    def data(self) -> bytes:
        """The file's bytes."""
        return self.text.encode(errors="replace")


@dataclass(frozen=True)
class _Exercise:
    name: str
    title: str
    of: int


@dataclass(frozen=True)
class _Row:
    pupil: PupilRecord
    listed: ListedPupil | None
    marks: tuple[Mark | None, ...]

    @property
    def name(self) -> str:
        return self.pupil.name if self.listed is None else self.listed.name

    def value(self, key: str) -> str:
        return "" if self.listed is None else self.listed.values.get(key, "")


def marks_as_csv(gradebook: Gradebook, pupils: Sequence[PupilRecord], listed: Sequence[ListedPupil]) -> MarksTable:
    """A line for each pupil of the class, and for each exercise a column of points.

    Args:
        gradebook: the form.
        pupils: those of the class.
        listed: the gradebook's own list, empty where there is none.
    """
    exercises = _exercises(pupils)
    found = match_pupils([one.name for one in pupils], listed)
    rows = [
        _Row(one, line, tuple(find_mark(one.marks, exercise.name) for exercise in exercises))
        for one, line in zip(pupils, found, strict=True)
    ]
    out = io.StringIO()
    lines = csv.writer(out, lineterminator="\r\n")
    make = {"moodle": _moodle, "canvas": _canvas, "sheet": _sheet}[gradebook]
    lines.writerows(make(exercises, rows))
    unlisted = tuple(row.pupil.name for row in rows if row.listed is None) if listed else ()
    return MarksTable("\ufeff" + out.getvalue(), len(exercises), unlisted)


def _exercises(pupils: Sequence[PupilRecord]) -> list[_Exercise]:
    """The exercises that there are marks of, in the order in which they first come; no two have one title."""
    # A comment on work that is not graded yet knows no maximum.
    known: dict[str, tuple[str, int]] = {}
    for pupil in pupils:
        for mark in pupil.marks:
            label, of = known.get(mark.exercise, ("", 0))
            known[mark.exercise] = (mark.label or label, max(of, mark.of))
    made: list[_Exercise] = []
    for name, (label, of) in known.items():
        title = " ".join((label or name).split())
        taken = {one.title.casefold() for one in made}
        made.append(_Exercise(name, f"{title} [{name}]" if title.casefold() in taken else title, of))
    return made


def _titled(exercise: _Exercise) -> str:
    return f"{exercise.title} (max {exercise.of})" if exercise.of else exercise.title


def _points(mark: Mark | None, none: str) -> object:
    return none if mark is None or mark.points is None else mark.points


def _comment(mark: Mark | None) -> object:
    return as_cell("" if mark is None else mark.comment)


def _moodle(exercises: Sequence[_Exercise], rows: Sequence[_Row]) -> list[list[object]]:
    listed = [row for row in rows if row.listed is not None]
    usable = (one for one in _IDENTITIES if listed and all(row.value(one[0]) for row in listed))
    key, title = next(usable, _IDENTITIES[0])
    head: list[object] = [title, "Full name"]
    for one in exercises:
        head += [as_cell(_titled(one)), as_cell(f"{one.title} (Feedback)")]
    made = [head]
    for row in rows:
        line: list[object] = [as_cell(row.value(key) or f"? {row.pupil.name}"), as_cell(row.name)]
        for mark in row.marks:
            line += [_points(mark, "-"), _comment(mark)]
        made.append(line)
    return made


def _canvas(exercises: Sequence[_Exercise], rows: Sequence[_Row]) -> list[list[object]]:
    keys = ("id", "sis_user", "sis_login", "section")
    titles = [as_cell(one.title) for one in exercises]
    head: list[object] = ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", *titles]
    possible: list[object] = ["    Points Possible", "", "", "", "", *(one.of or "" for one in exercises)]
    lines = [
        [as_cell(row.name), *(as_cell(row.value(key)) for key in keys), *(_points(mark, "") for mark in row.marks)]
        for row in rows
    ]
    return [head, possible, *lines]


def _sheet(exercises: Sequence[_Exercise], rows: Sequence[_Row]) -> list[list[object]]:
    known = [(key, title) for key, title in _IDENTITIES if any(row.value(key) for row in rows)]
    head: list[object] = ["Name", *(title for _, title in known)]
    for one in exercises:
        head += [as_cell(_titled(one)), as_cell(f"{one.title} (comment)")]
    made = [head]
    for row in rows:
        line: list[object] = [as_cell(row.name), *(as_cell(row.value(key)) for key, _ in known)]
        for mark in row.marks:
            line += [_points(mark, ""), _comment(mark)]
        made.append(line)
    return made
