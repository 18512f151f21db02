"""The requests of the teacher's page: everything that is done with all pupils or with one.

The door lets nobody but the teacher come as far as here.
"""

from __future__ import annotations

from typing import Annotated

from fastapi import Depends, Query, Request, Response

from kitrobot.classroom.admission import Admission
from kitrobot.classroom.archive import ClassArchive, build_archive, table
from kitrobot.classroom.class_room import ClassError
from kitrobot.classroom.exercises import exercise_label, hand_out_exercise
from kitrobot.classroom.gradebook_list import keep_gradebook_list, match_pupils, read_gradebook_list
from kitrobot.classroom.gradebook_tables import Gradebook, marks_as_csv
from kitrobot.classroom.grading_queue import ClassGrader
from kitrobot.classroom.messages import (
    ClassPictureShape,
    TeacherAddShape,
    TeacherAnswerShape,
    TeacherCodeShape,
    TeacherCommentShape,
    TeacherExerciseShape,
    TeacherFreezeShape,
    TeacherGradebookShape,
    TeacherGradeShape,
    TeacherHandedOutShape,
    TeacherHandOutShape,
    TeacherLinkShape,
    TeacherLogShape,
    TeacherMarksShape,
    TeacherNoteShape,
    TeacherPlacesShape,
    TeacherPupilShape,
    TeacherTurnShape,
)
from kitrobot.classroom.overview import JoinAddress
from kitrobot.classroom.pictures import ClassPictures
from kitrobot.classroom.pupil import Pupil
from kitrobot.classroom.teacher_actions import TeacherActions
from kitrobot.files.embedded_mission import carried_mission
from kitrobot.server.classroom.pupil_routes import ThisRoom, room_of
from kitrobot.server.classroom.qr_codes import qr_rows
from kitrobot.server.classroom.studios import PupilStudios
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.text.sentences import Sentence

teacher_routes = api_router("/api/class/teacher")


def _actions(request: Request) -> TeacherActions:
    return TeacherActions(room_of(request))


def _grading(request: Request) -> ClassGrader:
    grading = request.app.state.grading
    assert isinstance(grading, ClassGrader)
    return grading


ThisActions = Annotated[TeacherActions, Depends(_actions)]
TheGrading = Annotated[ClassGrader, Depends(_grading)]
Folder = Annotated[str, Query(max_length=300)]
Folders = Annotated[list[str] | None, Query(max_length=1000)]


def _one(room: ThisRoom, folder: str) -> Pupil:
    """A pupil.

    Raises:
        ClassError: there is none of that folder.
    """
    pupil = room.pupils.get(folder)
    if pupil is None:
        raise ClassError(Sentence("this pupil is not in the class any more"), "")
    return pupil


@teacher_routes.get("/picture", responses={200: {"model": ClassPictureShape}})
def picture(room: ThisRoom, request: Request, folder: Folder) -> Response:
    """What a card's picture is drawn from; 204 where there is nothing to draw."""
    pictures = request.app.state.pictures
    assert isinstance(pictures, ClassPictures)
    found = pictures.of(_one(room, folder))
    return Response(status_code=204) if found is None else Response(found, media_type="application/json")


@teacher_routes.post("/code")
def code(actions: ThisActions, wanted: TeacherCodeShape) -> bool:
    """A new code, or none: then nobody can join."""
    actions.set_code(wanted.on)
    return wanted.on


@teacher_routes.post("/freeze")
def freeze(actions: ThisActions, wanted: TeacherFreezeShape) -> bool:
    """Those pupils, or everybody, are to look up, or go on."""
    actions.set_frozen(wanted.on, wanted.folders)
    return wanted.on


@teacher_routes.post("/exercise")
def exercise(
    actions: ThisActions, room: ThisRoom, studio: ThisStudio, request: Request, wanted: TeacherExerciseShape
) -> bool:
    """Chooses the exercise of the class: one that comes with KitRobot, or one of the folder, which is handed out."""
    name = wanted.exercise
    if name:
        name = hand_out_exercise(room, studio, name)
    actions.set_exercise(name)
    studios = request.app.state.studios
    if isinstance(studios, PupilStudios):
        studios.take_exercise()
    return True


@teacher_routes.post("/link")
def link(room: ThisRoom, studio: ThisStudio, request: Request, wanted: TeacherExerciseShape) -> TeacherLinkShape:
    """An address that opens an exercise for a pupil, whichever the class has; one of the folder is handed out."""
    reach = request.app.state.reach
    assert isinstance(reach, JoinAddress)
    address = reach.link(room.record, hand_out_exercise(room, studio, wanted.exercise))
    return TeacherLinkShape(address=address, qr=qr_rows(address))


@teacher_routes.post("/hand-out")
def hand_out(actions: ThisActions, studio: ThisStudio, wanted: TeacherHandOutShape) -> TeacherHandedOutShape:
    """Gives a mission of the folder or of the examples to pupils; what cannot be opened is not handed out."""
    data, _ = studio.folder.read(wanted.path)
    data, name = carried_mission(data, wanted.path)
    opened = studio.read(data, name, wanted.path)
    if not opened.mission.programs:
        raise ClassError(Sentence("there is no program in `{name}`", name), "")
    name, pupils = actions.hand_out(name, data, wanted.to)
    return TeacherHandedOutShape(name=name, pupils=pupils)


@teacher_routes.post("/note")
def note(actions: ThisActions, room: ThisRoom, wanted: TeacherNoteShape) -> bool:
    """Writes a few words to one pupil."""
    actions.send_note(_one(room, wanted.folder), wanted.text)
    return True


@teacher_routes.post("/comment")
def comment(actions: ThisActions, room: ThisRoom, studio: ThisStudio, wanted: TeacherCommentShape) -> bool:
    """Writes a line on a pupil's work of an exercise."""
    label = exercise_label(studio, wanted.exercise)
    actions.comment(_one(room, wanted.folder), wanted.exercise, label, wanted.text)
    return True


@teacher_routes.post("/hand-down")
def hand_down(room: ThisRoom, wanted: TeacherPupilShape) -> bool:
    """The teacher was there."""
    room.set_hand(_one(room, wanted.folder), up=False)
    return True


@teacher_routes.post("/turn")
def turn(actions: ThisActions, room: ThisRoom, wanted: TeacherTurnShape) -> bool:
    """Asks a pupil to let the teacher edit; or gives the mission back."""
    pupil = _one(room, wanted.folder)
    if wanted.ask:
        actions.request_turn(pupil)
    else:
        actions.return_turn(pupil)
    return wanted.ask


@teacher_routes.post("/add")
def add(actions: ThisActions, wanted: TeacherAddShape) -> TeacherPupilShape:
    """A pupil who comes later, with the word."""
    return TeacherPupilShape(folder=actions.add(wanted.name).folder)


@teacher_routes.post("/remove")
def remove(actions: ThisActions, room: ThisRoom, wanted: TeacherPupilShape) -> bool:
    """Nobody comes in as this pupil any more; the folder stays."""
    actions.remove(_one(room, wanted.folder))
    return True


@teacher_routes.post("/remove-idle")
def remove_idle(actions: ThisActions) -> int:
    """Takes those out of the class who came in, handed nothing in and are not here; gives how many."""
    return actions.remove_idle()


@teacher_routes.post("/places")
def places(actions: ThisActions, wanted: TeacherPlacesShape) -> int:
    """The class takes so many pupils from now on."""
    actions.set_places(wanted.places)
    return wanted.places


@teacher_routes.post("/answer")
def answer(request: Request, wanted: TeacherAnswerShape) -> bool:
    """Lets somebody in who asks for it, or does not."""
    admission = request.app.state.admission
    assert isinstance(admission, Admission)
    admission.answer(wanted.asked, wanted.yes)
    return wanted.yes


@teacher_routes.get("/log")
def log(room: ThisRoom) -> TeacherLogShape:
    """What happened in this process."""
    return TeacherLogShape(lines=room.log.last())


@teacher_routes.get("/collect", response_class=Response)
def collected(room: ThisRoom, studio: ThisStudio, folder: Folders = None) -> Response:
    """Everything that those pupils, or all, handed in, and a table of it: a ZIP file."""
    made: ClassArchive = build_archive(room, studio, folder)
    return Response(made.data, media_type="application/zip", headers={"x-kitrobot-files": str(made.files)})


@teacher_routes.get("/table", response_class=Response)
def class_table(room: ThisRoom, studio: ThisStudio) -> Response:
    """The table alone, for a spreadsheet."""
    return Response(table(room, studio, None).encode(), media_type="text/csv; charset=utf-8")


@teacher_routes.post("/grade")
def grade(grading: TheGrading, wanted: TeacherGradeShape) -> int:
    """Begins to grade what was handed in last, with the exercise of the class; gives how many."""
    return grading.begin(wanted.folders)


@teacher_routes.get("/grades", response_class=Response)
def grades(grading: TheGrading) -> Response:
    """The page that grading wrote last."""
    return Response(grading.page(), media_type="text/html; charset=utf-8")


async def _body(request: Request) -> bytes:
    return await request.body()


@teacher_routes.put("/gradebook")
def gradebook(room: ThisRoom, data: Annotated[bytes, Depends(_body)]) -> TeacherGradebookShape:
    """Keeps the list of pupils that a gradebook exports, for the marks."""
    listed = keep_gradebook_list(room.folder, data)
    names = [pupil.name for pupil in room.record.pupils]
    lines = match_pupils(names, listed)
    unlisted = [name for name, line in zip(names, lines, strict=True) if line is None]
    return TeacherGradebookShape(pupils=len(listed), unlisted=unlisted)


@teacher_routes.get("/marks")
def marks(room: ThisRoom, gradebook: Gradebook) -> TeacherMarksShape:
    """The marks of all pupils as CSV, in the form of that gradebook."""
    listed = read_gradebook_list(room.folder)
    with room.lock:
        made = marks_as_csv(gradebook, room.record.pupils, listed)
    return TeacherMarksShape(
        name=f"marks-{gradebook}.csv",
        text=made.data.decode(),
        exercises=made.exercises,
        listed=bool(listed),
        unlisted=list(made.unlisted),
    )
