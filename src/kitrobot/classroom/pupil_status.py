"""The messages between a class and the page of a pupil, as plain values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Turn = Literal["pupil", "asked", "teacher"]
"""Whose turn it is to edit a pupil's mission: the pupil's, who may be asked for it, or the teacher's."""


@dataclass(frozen=True)
class HandIn:
    """A stored submission: its name, which may differ from the requested one, and its revision."""

    name: str
    revision: str


@dataclass(frozen=True)
class PupilStatus:
    """The status of a pupil, which is sent to the pupil's page.

    Attributes:
        class_name: of the class.
        name: of the pupil.
        word: lets them join again from another computer.
        frozen: whether the pupil's screen is frozen.
        exercise: the exercise of the class, "" without.
        handed, handed_name: the mission that was handed out last: its number, which grows, and its name, "" for none.
        note, note_text: the number of the teacher's last note, and its text.
        looked: whether the teacher is viewing the pupil's work.
        hand: whether the pupil's hand is raised.
        turn: whose turn it is to edit.
        comments: what the teacher wrote on exercises, by their names.
    """

    class_name: str
    name: str
    word: str
    frozen: bool
    exercise: str
    handed: int
    handed_name: str
    note: int
    note_text: str
    looked: bool
    hand: bool
    turn: Turn
    comments: dict[str, str]
