"""What a pupil got for each exercise: points as grading found them last, and the teacher's comment.

A mark is kept in the pupil's lines of `class.toml`, as `[[pupil.mark]]`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

from kitrobot.classroom.toml_values import count_of, list_of, text_of, toml_string
from kitrobot.text.sentences import Sentence

LONGEST_COMMENT: Final = 500
"""Characters of a comment."""
MOST_MARKS: Final = 200
"""Exercises of one pupil; the oldest is forgotten when there are more."""


@dataclass(frozen=True)
class Mark:
    """A mark of one exercise.

    Attributes:
        exercise: the name of the exercise in the class.
        label: what it is called, in English.
        points: what was earned, from 0 to `of`; None before it is graded, and where the work cannot be judged.
        of: the points of all its goals; 0 while it is not known.
        comment: what the teacher wrote, on one line; "" for nothing.
    """

    exercise: str
    label: str
    points: int | None = None
    of: int = 0
    comment: str = ""


def find_mark(marks: Sequence[Mark], exercise: str) -> Mark | None:
    """The mark of that exercise."""
    return next((one for one in marks if one.exercise == exercise), None)


def put_mark(marks: Sequence[Mark], mark: Mark) -> list[Mark]:
    """The marks with this one in the place of that of the same exercise, or at the end."""
    if find_mark(marks, mark.exercise) is None:
        return [*marks, mark][-MOST_MARKS:]
    return [mark if one.exercise == mark.exercise else one for one in marks]


def comments_of(marks: Sequence[Mark]) -> dict[str, str]:
    """The comments that there are, by the names of their exercises."""
    return {one.exercise: one.comment for one in marks if one.comment}


def mark_lines(marks: Sequence[Mark]) -> list[str]:
    """The lines of TOML for the marks of a pupil."""
    lines: list[str] = []
    for one in marks:
        lines += ["[[pupil.mark]]", f"exercise = {toml_string(one.exercise)}", f"label = {toml_string(one.label)}"]
        lines += [] if one.points is None else [f"points = {one.points}"]
        lines += [f"of = {one.of}"]
        lines += [f"comment = {toml_string(one.comment)}"] if one.comment else []
    return lines


def marks_of(table: dict[str, Any]) -> list[Mark]:
    """The marks of a pupil's table.

    Raises:
        ValueError: a mark makes no sense.
        TypeError: a value is of another kind.
    """
    made: list[Mark] = []
    for one in list_of(table, "mark"):
        exercise = text_of(one, "exercise") if isinstance(one, dict) else ""
        if not exercise:
            raise ValueError(Sentence("`{key}` makes no sense", "mark"))
        points = count_of(one, "points", 0) if "points" in one else None
        comment = " ".join(text_of(one, "comment").split())[:LONGEST_COMMENT]
        made = put_mark(made, Mark(exercise, text_of(one, "label"), points, count_of(one, "of", 0), comment))
    return made
