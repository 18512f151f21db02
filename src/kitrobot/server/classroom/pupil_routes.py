"""The requests of pupils to their class: joining, handing in, getting assignments.

The gateway (`class_gateway`) has checked the key and put the pupil into the request's state.
"""

from __future__ import annotations

from typing import Annotated

from fastapi import Depends, Query, Request, Response
from starlette.requests import HTTPConnection

from kitrobot.classroom.admission import Admission, AdmissionRefusedError, NameTakenError
from kitrobot.classroom.assignments import pack
from kitrobot.classroom.class_room import ClassRoom
from kitrobot.classroom.exercises import files_of_exercise, is_exercise
from kitrobot.classroom.messages import (
    AdmissionRequestShape,
    ClassAnsweredShape,
    ClassAskShape,
    ClassHandInShape,
    ClassShape,
    JoinedShape,
    JoinShape,
)
from kitrobot.classroom.pictures import ClassPictures
from kitrobot.classroom.pupil import Pupil
from kitrobot.classroom.pupil_status import HandIn
from kitrobot.classroom.submissions import Submission
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.server.routes.mission_encoding import mission_bytes
from kitrobot.text.sentences import Sentence
from kitrobot.wire.mission import mission_from_shape

class_routes = api_router("/api/class")


def room_of(connection: HTTPConnection) -> ClassRoom:
    """The class of a request or a socket."""
    room = connection.app.state.room
    assert isinstance(room, ClassRoom)
    return room


def pupil_of(connection: HTTPConnection) -> Pupil:
    """The pupil who sent a request.

    Raises:
        AdmissionRefusedError: no pupil sent it.
    """
    pupil = connection.scope.get("state", {}).get("class_pupil")
    if not isinstance(pupil, Pupil):
        raise AdmissionRefusedError(Sentence("you are not in this class"), Sentence("join it with the code"))
    return pupil


def _admission(request: Request) -> Admission:
    admission = request.app.state.admission
    assert isinstance(admission, Admission)
    return admission


def _pictures(request: Request) -> ClassPictures:
    pictures = request.app.state.pictures
    assert isinstance(pictures, ClassPictures)
    return pictures


def _from(request: Request) -> str:
    return request.client.host if request.client is not None else ""


ThisRoom = Annotated[ClassRoom, Depends(room_of)]
ThisPupil = Annotated[Pupil, Depends(pupil_of)]
Door = Annotated[Admission, Depends(_admission)]
From = Annotated[str, Depends(_from)]
Name = Annotated[str, Query(max_length=1000)]


@class_routes.get("")
def class_(room: ThisRoom) -> ClassShape:
    """What anybody may know of the class."""
    return ClassShape(name=room.record.name, joining=room.record.code != "")


@class_routes.post("/join")
def join(admission: Door, who: From, wanted: JoinShape) -> JoinedShape:
    """Lets a pupil in."""
    try:
        pupil, key = admission.join(wanted.code, wanted.name, wanted.word, who)
    except NameTakenError:
        return JoinedShape(state="taken")
    return JoinedShape(state="in", key=key, name=pupil.record.name, word=pupil.record.word)


@class_routes.post("/ask")
def ask(admission: Door, who: From, wanted: ClassAskShape) -> AdmissionRequestShape:
    """Asks the teacher to let somebody in as a pupil that there is."""
    return AdmissionRequestShape(asked=admission.request(wanted.code, wanted.name, who))


@class_routes.post("/asked")
def asked(admission: Door, wanted: AdmissionRequestShape) -> ClassAnsweredShape:
    """The teacher's answer to that."""
    yes, _, key = admission.take_answer(wanted.asked)
    if yes is None:
        return ClassAnsweredShape(state="waiting")
    return ClassAnsweredShape(state="in" if yes and key else "no", key=key)


@class_routes.put("/work")
def hand_in(room: ThisRoom, pupil: ThisPupil, studio: ThisStudio, request: Request, wanted: ClassHandInShape) -> HandIn:
    """Keeps a mission; once this is answered it is on the disk. One that would not open for the teacher is refused."""
    data = mission_bytes(mission_from_shape(wanted.mission), wanted.name)
    exercise = wanted.exercise
    if exercise not in pupil.record.works and not is_exercise(studio, exercise):
        exercise = ""
    kept = room.hand_in(pupil, wanted.name, data, wanted.base, exercise)
    _pictures(request).take(pupil, wanted.mission)
    return kept


@class_routes.get("/work")
def work(room: ThisRoom, pupil: ThisPupil) -> list[Submission]:
    """What was handed in, the newest first."""
    return room.list_submissions(pupil)


@class_routes.get("/work/file", response_class=Response)
def work_file(room: ThisRoom, pupil: ThisPupil, name: Name) -> Response:
    """One of them as it is on the disk; its revision is the ETag."""
    data, revision = room.read_submission(pupil, name)
    return Response(data, media_type="application/octet-stream", headers={"etag": f'"{revision}"'})


@class_routes.get("/exercise", response_class=Response)
def exercise(room: ThisRoom, pupil: ThisPupil, name: Name = "") -> Response:
    """The files of an exercise that was handed out as a ZIP file, for the studio of the page; nothing (204) where it
    comes with KitRobot. Without a name it is that of the class.
    """
    _, files = files_of_exercise(room, name)
    return Response(pack(files), media_type="application/zip") if files else Response(status_code=204)


@class_routes.get("/handed", response_class=Response)
def handed(room: ThisRoom, pupil: ThisPupil) -> Response:
    """The mission that was handed out last."""
    return Response(room.read_handed(pupil), media_type="application/octet-stream")
