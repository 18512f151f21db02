"""A class on the wire: coming in, what a pupil's page says and is told, what the teacher sees and asks for."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from kitrobot.classroom.grading_queue import GradingState
from kitrobot.classroom.marks import LONGEST_COMMENT, Mark
from kitrobot.classroom.pupil import GoalReport, State
from kitrobot.classroom.pupil_status import Turn
from kitrobot.wire.mission import MissionShape, ProgramValue
from kitrobot.wire.sentences import Clause
from kitrobot.wire.values import View, WireFields
from kitrobot.wire.world import WorldShape

MOST_GOALS = 100
MOST_PLACES = 1000
Name = Annotated[str, Field(max_length=1000)]
Code = Annotated[str, Field(max_length=100)]
Count = Annotated[int, Field(ge=0, le=2**53)]
Folder = Annotated[str, Field(max_length=300)]


# -- coming in


class ClassShape(BaseModel):
    """What anybody may know of a class: its name, and whether a code lets new pupils in."""

    name: str
    joining: bool


class JoinShape(BaseModel):
    """The code of the class and the pupil's name; `word` from another computer."""

    code: Code
    name: Name
    word: Code = ""


class JoinedShape(BaseModel):
    """In, with the key that every later request brings along; or there is a pupil of that name already."""

    state: Literal["in", "taken"]
    key: str = ""
    name: str = ""
    word: str = ""


class ClassAskShape(BaseModel):
    """The code, and as whom the teacher shall let somebody in."""

    code: Code
    name: Name


class AdmissionRequestShape(BaseModel):
    """The name of a question to the teacher."""

    asked: Code


class ClassAnsweredShape(BaseModel):
    """The answer: not yet, in with the key, or no."""

    state: Literal["waiting", "in", "no"]
    key: str = ""


# -- a pupil's page


class ClassHandInShape(BaseModel):
    """A mission to be kept: `name` is what the page calls it, `base` what was kept under that name before, or "";
    `exercise` the one that it is for, "" for none.
    """

    name: Name
    base: Annotated[str, Field(max_length=64)] = ""
    exercise: Name = ""
    mission: MissionShape


class ReportMessage(BaseModel):
    """What the page says of itself. `edits` and `runs` count: another number is something that moved."""

    type: Literal["report"]
    running: bool
    edits: Count
    runs: Count
    file: Name
    exercise: Name
    goals: Annotated[tuple[GoalReport, ...], Field(max_length=MOST_GOALS)]


class HandMessage(BaseModel):
    """The pupil asks for help, or does not any more."""

    type: Literal["hand"]
    up: bool


Length = Annotated[float, Field(ge=-1e9, le=1e9, allow_inf_nan=False)]


class ClassArenaShape(BaseModel):
    """What a pupil's page shows of its run: the world, where each robot is (mm, mm, rad), the way of the first of them,
    and the time of the run.
    """

    running: bool
    seconds: Length
    world: WorldShape
    poses: Annotated[list[tuple[Length, Length, Length]], Field(max_length=50)]
    way: Annotated[list[tuple[Length, Length]], Field(max_length=400)]


class ShowArenaMessage(BaseModel):
    """The run that the page shows, told while the teacher looks on."""

    type: Literal["arena"]
    arena: ClassArenaShape


class TurnMessage(BaseModel):
    """The pupil lets the teacher edit; or does not, or not any more."""

    type: Literal["turn"]
    yes: bool


class PupilNewsMessage(BaseModel):
    """What the pupil's page is to know. `handed` and `note` count: a higher number is a new one. `turn`: who edits, or
    that the teacher asks to. `comments`: what the teacher wrote on exercises, by their names.
    """

    type: Literal["pupil"]
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


# -- the teacher's page


class PupilShape(BaseModel):
    """A pupil as the overview shows them; `seconds` is how long the state lasts, where that counts.

    `version` is another one with each picture, 0 while there is none; `frozen`: this pupil is to look up, alone or with
    everybody; `mark`: of the exercise of the class.
    """

    folder: str
    name: str
    word: str
    state: State
    seconds: float | None
    running: bool
    file: str
    version: int
    exercise: str
    goals: tuple[GoalReport, ...]
    pages: int
    frozen: bool
    turn: Turn
    mark: Annotated[Mark, WireFields()] | None


class ClassGoalNameShape(BaseModel):
    """A goal of the exercise of the class, by language."""

    label: dict[str, str]


class ClassAskingShape(BaseModel):
    """Somebody asks to be let in as that pupil."""

    asked: str
    folder: str
    name: str


class ClassNewsMessage(BaseModel):
    """The class as a whole; each time something of it changed. `kept_s`: how long ago work came in last."""

    type: Literal["class"]
    name: str
    folder: str
    code: str
    address: str
    qr: list[str]
    reach: Clause
    frozen: bool
    places: int
    exercise: str
    exercise_label: dict[str, str]
    goals: list[ClassGoalNameShape]
    asking: list[ClassAskingShape]
    grading: Annotated[GradingState, WireFields()] | None
    bytes: int


class PupilsMessage(BaseModel):
    """Pupils that changed since the last message, and who is gone; `kept_s`: seconds since work came in last."""

    type: Literal["pupils"]
    changed: list[PupilShape]
    gone: list[str]
    kept_s: float | None


class ArenaMessage(BaseModel):
    """What the page of the pupil whom the teacher looks on shows of its run; null for none."""

    type: Literal["arena"]
    folder: str
    arena: ClassArenaShape | None


class LookMessage(BaseModel):
    """The teacher looks on, or at nobody."""

    type: Literal["look"]
    folder: Folder


class ClassPictureShape(View):
    """What a card's picture is drawn from: the first program that an agent runs."""

    version: int
    program: ProgramValue


class TeacherCodeShape(BaseModel):
    """A new code, or none."""

    on: bool


class TeacherFreezeShape(BaseModel):
    """Those pupils are to look up, or go on; null: everybody."""

    on: bool
    folders: Annotated[list[Folder], Field(max_length=1000)] | None = None


class TeacherExerciseShape(BaseModel):
    """The exercise of the class from now on, "" for none."""

    exercise: Name


class TeacherLinkShape(BaseModel):
    """The address that opens an exercise in this class, and its QR code: rows of 0 and 1."""

    address: str
    qr: tuple[str, ...]


class TeacherHandOutShape(BaseModel):
    """A mission of the class's folder or of the examples for those pupils; null: for all."""

    path: Name
    to: Annotated[list[Folder], Field(max_length=1000)] | None = None


class TeacherHandedOutShape(BaseModel):
    """The name it has, and how many got it."""

    name: str
    pupils: int


class TeacherNoteShape(BaseModel):
    """A few words for one pupil."""

    folder: Folder
    text: Annotated[str, Field(max_length=500)]


class TeacherCommentShape(BaseModel):
    """What the teacher writes on a pupil's work of that exercise, "" to take it back."""

    folder: Folder
    exercise: Name
    text: Annotated[str, Field(max_length=LONGEST_COMMENT)]


class TeacherPupilShape(BaseModel):
    """One pupil."""

    folder: Folder


class TeacherTurnShape(BaseModel):
    """Asks a pupil to let the teacher edit; or gives the mission back."""

    folder: Folder
    ask: bool


class TeacherAddShape(BaseModel):
    """A pupil who comes later."""

    name: Name


class TeacherPlacesShape(BaseModel):
    """How many pupils the class takes."""

    places: Annotated[int, Field(ge=1, le=MOST_PLACES)]


class TeacherAnswerShape(BaseModel):
    """The teacher's answer to who asks to be let in."""

    asked: Code
    yes: bool


class TeacherGradeShape(BaseModel):
    """Whose work is to be graded with the exercise of the class; null: everybody's."""

    folders: Annotated[list[Folder], Field(max_length=1000)] | None = None


class TeacherMarksShape(BaseModel):
    """The marks as CSV: the name of the file and its text, how many exercises, and whom the gradebook's list lacks.

    `listed`: there is such a list.
    """

    name: str
    text: str
    exercises: int
    listed: bool
    unlisted: list[str]


class TeacherGradebookShape(BaseModel):
    """The list of a gradebook as it was kept: how many pupils it has, and which of the class it lacks."""

    pupils: int
    unlisted: list[str]


class TeacherLogShape(BaseModel):
    """The last lines of the log, the newest first."""

    lines: list[str]


PUPIL_REQUEST_MODELS: tuple[type[BaseModel], ...] = (
    ReportMessage,
    HandMessage,
    TurnMessage,
    ShowArenaMessage,
    LookMessage,
)
PUPIL_MESSAGE_MODELS: tuple[type[BaseModel], ...] = (PupilNewsMessage, ClassNewsMessage, PupilsMessage, ArenaMessage)
