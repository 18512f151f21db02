"""A pupil of a running class, and the pupil's state. Moments are seconds of one clock."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Annotated, Final, Literal

from annotated_types import MaxLen

from kitrobot.classroom.pupil_status import Turn
from kitrobot.classroom.record import PupilRecord

STUCK_S: Final = 4 * 60
"""Who ran and edited nothing for so long, and is not at the goal, is stuck."""

State = Literal["asks", "stuck", "running", "editing", "done", "away"]


@dataclass(frozen=True)
class GoalReport:
    """A goal of the exercise as the pupil's page judged it; None: not yet."""

    reached: bool | None
    why: Annotated[str, MaxLen(500)] = ""


@dataclass(frozen=True)
class Report:
    """The report of a pupil's page.

    `edits` and `runs` count; another number than before is something that moved. `exercise` is the one whose `goals`
    they are, "" without.
    """

    running: bool = False
    edits: int = 0
    runs: int = 0
    file: str = ""
    exercise: str = ""
    goals: tuple[GoalReport, ...] = ()


@dataclass
class Pupil:
    """One pupil. `moved` is when something moved last, `left` and `asked` when the pupil went and put the
    hand up.
    """

    record: PupilRecord
    folder: str
    pages: int = 0
    report: Report = field(default_factory=Report)
    moved: float | None = None
    left: float | None = None
    asked: float | None = None
    work: str = ""
    """The file that was handed in last, and its revision."""
    revision: str = ""
    kept: float | None = None
    version: int = 0
    """Another one with each picture."""
    turn: Turn = "pupil"
    arena: str = ""
    """The picture of the pupil's run, as its page sent it while the teacher is viewing it."""

    def take_report(self, report: Report, now: float) -> None:
        """Stores the report of the pupil's page."""
        before = self.report
        if self.moved is None or report.running or (report.edits, report.runs) != (before.edits, before.runs):
            self.moved = now
        self.report = report

    def open_page(self, now: float) -> None:
        """Records that a page of the pupil connected."""
        self.pages += 1
        self.moved = now if self.moved is None or self.pages == 1 else self.moved

    def close_page(self, now: float) -> None:
        """Records that a page of the pupil disconnected."""
        self.pages = max(0, self.pages - 1)
        if self.pages == 0:
            self.left = now
            self.report = replace(self.report, running=False)


def met(pupil: Pupil, exercise: str) -> int:
    """How many goals of that exercise are reached."""
    report = pupil.report
    return sum(goal.reached is True for goal in report.goals) if report.exercise == exercise else 0


def state_of(pupil: Pupil, exercise: str, goals: int, now: float) -> tuple[State, float | None]:
    """The state, and for how many seconds; None where nobody asks or it is not known.

    Args:
        pupil: who.
        exercise: the exercise of the class, "" without.
        goals: how many goals it has.
        now: the moment.
    """
    if pupil.pages == 0:
        return "away", None if pupil.left is None else now - pupil.left
    if pupil.asked is not None:
        return "asks", now - pupil.asked
    if pupil.report.running:
        return "running", None
    if goals > 0 and met(pupil, exercise) == goals:
        return "done", None
    still = now - (now if pupil.moved is None else pupil.moved)
    return ("stuck", still) if still >= STUCK_S else ("editing", None)
