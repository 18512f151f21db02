"""The teacher's view of a class: the class as a whole, and each pupil's card; messages of what changed."""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Final
from urllib.parse import quote, urlencode

from pydantic import BaseModel

from kitrobot.classroom.admission import Admission
from kitrobot.classroom.class_room import ClassRoom
from kitrobot.classroom.grading_queue import ClassGrader
from kitrobot.classroom.marks import find_mark
from kitrobot.classroom.messages import (
    ClassAskingShape,
    ClassGoalNameShape,
    ClassNewsMessage,
    PupilShape,
    PupilsMessage,
)
from kitrobot.classroom.pupil import Pupil, state_of
from kitrobot.classroom.record import ClassRecord
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.studio import Studio

FOLDER_S: Final = 10.0
"""How often the folder is measured."""


@dataclass(frozen=True)
class JoinAddress:
    """Where pupils join: the address, as a QR code too (rows of 0 and 1), and a sentence about who can reach it."""

    address: str
    qr: tuple[str, ...]
    sentence: str

    def link(self, record: ClassRecord, exercise: str) -> str:
        """The address that opens an exercise for who is in the class, or joins it with the code that it brings along.

        What stands behind `#` is read by the page (`session/exercise-link.ts`) and sent to no server.
        """
        brought = {"exercise": exercise, "class": record.name, "code": record.code}
        # `:` and `/` stand for themselves behind `#`, and the address is easier to read and its QR code smaller.
        words = urlencode({key: word for key, word in brought.items() if word}, safe=":/", quote_via=quote)
        return f"{self.address.removesuffix('/')}/#{words}"


class Overview:
    """The overview of one class."""

    def __init__(
        self, room: ClassRoom, admission: Admission, studio: Studio, grading: ClassGrader, reach: JoinAddress
    ) -> None:
        self._room = room
        self._admission = admission
        self._studio = studio
        self._grading = grading
        self._reach = reach
        self._bytes = 0
        self._measured = -math.inf

    def class_message(self) -> ClassNewsMessage:
        """The message about the class, without its pupils."""
        room, record = self._room, self._room.record
        label, goals = self._exercise()
        asking = [
            ClassAskingShape(asked=asked, folder=folder, name=pupil.record.name)
            for asked, folder in self._admission.pending().items()
            if (pupil := room.pupils.get(folder)) is not None
        ]
        return ClassNewsMessage(
            type="class",
            name=record.name,
            folder=room.folder.name,
            code=record.code,
            address=self._reach.address,
            qr=list(self._reach.qr),
            reach=self._reach.sentence,
            frozen=record.frozen,
            places=record.places,
            exercise=record.exercise,
            exercise_label=label,
            goals=goals,
            asking=asking,
            grading=self._grading.state,
            bytes=self._size(),
        )

    def pupils(self) -> dict[str, PupilShape]:
        """Every card, by folder."""
        now = self._room.clock()
        goals = len(self._exercise()[1])
        with self._room.lock:
            return {one.folder: self._card(one, goals, now) for one in self._room.pupils.values()}

    def pupils_message(self, before: Mapping[str, BaseModel], now: Mapping[str, PupilShape]) -> PupilsMessage:
        """The message of changed cards. A state that only lasts longer is no change: the page counts by itself."""
        changed = [
            card
            for folder, card in now.items()
            if not isinstance(was := before.get(folder), PupilShape)
            or was.model_copy(update={"seconds": card.seconds}) != card
        ]
        kept = self._room.last_kept
        return PupilsMessage(
            type="pupils",
            changed=changed,
            gone=[folder for folder in before if folder not in now],
            kept_s=None if kept is None else round(self._room.clock() - kept, 1),
        )

    def _card(self, pupil: Pupil, goals: int, now: float) -> PupilShape:
        exercise = self._room.record.exercise
        state, seconds = state_of(pupil, exercise, goals, now)
        report = pupil.report
        ours = report.goals if report.exercise == exercise and exercise else ()
        return PupilShape(
            folder=pupil.folder,
            name=pupil.record.name,
            word=pupil.record.word,
            state=state,
            seconds=None if seconds is None else round(seconds),
            running=report.running,
            file=pupil.work or report.file,
            version=pupil.version,
            exercise=report.exercise,
            goals=ours[:goals],
            pages=pupil.pages,
            frozen=self._room.record.frozen or pupil.record.frozen,
            turn=pupil.turn,
            mark=find_mark(pupil.record.marks, exercise),
        )

    def _exercise(self) -> tuple[dict[str, str], list[ClassGoalNameShape]]:
        name = self._room.record.exercise
        if name:
            with suppress(KitRobotError):
                exercise, _ = self._studio.exercises.usable(name)
                goals = exercise.goals_for(hidden=False)
                return dict(exercise.label), [ClassGoalNameShape(label=dict(goal.label)) for goal in goals]
        return {}, []

    def _size(self) -> int:
        now = self._room.clock()
        if now - self._measured >= FOLDER_S:
            self._measured = now
            self._bytes = sum(
                work.bytes for pupil in list(self._room.pupils.values()) for work in self._room.list_submissions(pupil)
            )
        return self._bytes
