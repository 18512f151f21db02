"""Grading a class with its exercise: what each pupil handed in for it, beside the class, one piece after another.

It writes `grades.html` and `grades.csv` into the class's folder, and keeps each pupil's points as a mark; goals that
pupils' own pages report do not count.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kitrobot.classroom.class_room import GRADES_PAGE, GRADES_TABLE, ClassError, ClassRoom
from kitrobot.classroom.grade_tables import as_csv, as_html
from kitrobot.classroom.grades import Grade
from kitrobot.classroom.grading import grade
from kitrobot.classroom.marks import Mark, find_mark, put_mark
from kitrobot.classroom.pupil import Pupil
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import FileError, read_bytes, write_atomic
from kitrobot.files.folder import EXERCISE_ENDING
from kitrobot.live.studio import Studio
from kitrobot.text.sentences import Sentence

JOBS: Final = 1
"""The class goes on meanwhile."""

_log = logging.getLogger("kitrobot.server")


@dataclass(frozen=True)
class GradingState:
    """How far grading is; `page` names what it wrote, "" until then."""

    done: int
    total: int
    page: str = ""


class ClassGrader:
    """Grading of one class: one at a time."""

    def __init__(self, room: ClassRoom, studio: Studio) -> None:
        self._room = room
        self._studio = studio
        self._stop = threading.Event()
        self._lock = threading.Lock()
        self._thread: threading.Thread | None = None
        self.state: GradingState | None = None

    def begin(self, folders: Sequence[str] | None) -> int:
        """Starts grading; returns the number of submissions.

        Raises:
            ClassError: there is nothing to grade, or grading is on.
        """
        exercise = self._room.record.exercise
        if not exercise:
            raise ClassError(Sentence("the class has no exercise"), Sentence("choose one first"))
        self._studio.exercises.usable(exercise)
        path = self._studio.folder.path_of(exercise, EXERCISE_ENDING)
        pupils = {
            str(self._room.folder / pupil.folder / work): pupil
            for pupil in list(self._room.pupils.values())
            if (folders is None or pupil.folder in folders) and (work := self._room.work_for(pupil, exercise))
        }
        if not pupils:
            raise ClassError(Sentence("nobody has handed anything in yet"), "")
        with self._lock:
            if self._thread is not None and self._thread.is_alive():
                raise ClassError(Sentence("grading is on already"), "")
            self._stop = threading.Event()
            self.state = GradingState(0, len(pupils))
            self._thread = threading.Thread(
                target=self._run, args=(pupils, exercise, path), name="grading", daemon=True
            )
            self._thread.start()
        return len(pupils)

    def end(self) -> None:
        """Cancels grading."""
        self._stop.set()
        self.wait(10)

    def wait(self, within_s: float) -> None:
        """Waits until grading is over, at most `within_s` seconds."""
        if self._thread is not None:
            self._thread.join(within_s)

    def page(self) -> bytes:
        """The page of grades that was written last.

        Raises:
            FileError: there is none.
        """
        return read_bytes(self._room.folder / GRADES_PAGE)

    def _run(self, pupils: dict[str, Pupil], name: str, exercise: Path) -> None:
        made: list[Grade] = []
        marks: list[tuple[Pupil, Grade]] = []
        try:
            for one in grade([Path(path) for path in pupils], exercise, JOBS, stop=self._stop):
                marks.append((pupils[one.submission], one))
                made.append(replace(one, submission=pupils[one.submission].record.name))
                self.state = GradingState(len(made), len(pupils))
            if self._stop.is_set() and len(made) < len(pupils):
                return
            made.sort(key=lambda one: one.submission)
            write_atomic(self._room.folder / GRADES_TABLE, as_csv(made).encode(errors="replace"))
            write_atomic(self._room.folder / GRADES_PAGE, as_html(made).encode(errors="replace"))
            self._keep_marks(name, marks)
            self.state = GradingState(len(made), len(pupils), GRADES_PAGE)
            self._room.log.write(f"{len(made)} were graded: {GRADES_PAGE}")
        except (KitRobotError, FileError, OSError) as error:
            _log.warning("grading ended: %s", error)
            self._room.log.write(f"grading ended: {error}")
            self.state = None

    def _keep_marks(self, exercise: str, grades: Sequence[tuple[Pupil, Grade]]) -> None:
        """Keeps the points beside those of other exercises; a comment on the exercise stays."""
        with self._room.lock:
            for pupil, one in grades:
                before = find_mark(pupil.record.marks, exercise) or Mark(exercise, exercise)
                label = one.exercise.get("en") or before.label
                judged = one.problem is None
                mark = replace(before, label=label, points=one.points if judged else None, of=one.of or before.of)
                pupil.record.marks = put_mark(pupil.record.marks, mark)
            self._room.notify(kept=True)
