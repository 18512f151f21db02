"""What a class and the page of a pupil tell each other, as plain values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Turn = Literal["pupil", "asked", "teacher"]
"""Whose turn it is to edit a pupil's mission: the pupil's, who may be asked for it, or the teacher's."""


@dataclass(frozen=True)
class Handed:
    """A mission that was handed out: its number, which grows, its name, "" for none."""

    number: int = 0
    name: str = ""


@dataclass(frozen=True)
class HandIn:
    """A file as it was kept: its name, which may be another one than was wished, and its revision."""

    name: str
    revision: str


@dataclass(frozen=True)
class Told:
    """What a pupil's page is told.

    Attributes:
        class_name: of the class.
        name: of the pupil.
        word: brings them back from another computer.
        frozen: whether this pupil is to look up.
        exercise: the exercise of the class, "" without.
        handed: the mission that was handed out last.
        note: what the teacher wrote last, and its number.
        looked: whether the teacher looks on.
        hand: whether the hand is up.
        turn: whose turn it is to edit.
    """

    class_name: str
    name: str
    word: str
    frozen: bool
    exercise: str
    handed: Handed
    note: tuple[int, str]
    looked: bool
    hand: bool
    turn: Turn
