"""The page's requests: each is a use case of the workspace, with shapes before and after it."""

from __future__ import annotations

from typing import Annotated

from fastapi import Depends, Query, Request, Response

import kitrobot
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.files.embedded_mission import carried_mission, may_carry_mission
from kitrobot.files.folder import revision_of
from kitrobot.live.studio import Studio
from kitrobot.mission.writer import save, write_mission
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.server.routes.fast_json import report_answer
from kitrobot.server.routes.mission_encoding import mission_bytes
from kitrobot.sim.jit.policy import expect_run
from kitrobot.text.collection import collection_paused
from kitrobot.text.forms import name_form
from kitrobot.text.sentences import Sentence
from kitrobot.wire.files import (
    ConflictShape,
    MissionEntryShape,
    MissionFileShape,
    MissionTextShape,
    SavedShape,
    SaveShape,
    SessionShape,
    TextShape,
)
from kitrobot.wire.gallery import RunPreviewShape
from kitrobot.wire.mission import MissionShape, mission_from_shape, mission_shape
from kitrobot.wire.problem import RequestFailureShape, problem_shapes
from kitrobot.wire.report import CheckShape, FirstTeamShape, ReportShape
from kitrobot.wire.world import world_shape
from kitrobot.workspace.first_team import first_team
from kitrobot.workspace.mission_loader import OpenMission, new_mission

_FAILURES: dict[int | str, dict[str, object]] = {
    "4XX": {"model": RequestFailureShape, "description": "Why it could not be done, and a way out."}
}
_CONFLICT: dict[int | str, dict[str, object]] = {
    409: {"model": ConflictShape, "description": "The file is not what it was."},
    **_FAILURES,
}
LONGEST_NAME = 1000


routes = api_router()


async def _body(request: Request) -> bytes:
    """The raw body, whatever its content type."""
    return await request.body()


Name = Annotated[str, Query(max_length=LONGEST_NAME)]


@routes.get("/session")
def session(request: Request, studio: ThisStudio) -> SessionShape:
    """What the page starts with."""
    return SessionShape(
        version=kitrobot.__version__,
        path=studio.first,
        workspace=studio.folder.root.name,
        secret=request.app.state.handshake.secret,
    )


@routes.get("/missions")
def missions(studio: ThisStudio) -> list[MissionEntryShape]:
    """The missions of the folder, and the examples."""
    return studio.gallery.entries(studio)


@routes.get("/missions/preview")
def mission_preview(studio: ThisStudio, path: Name) -> RunPreviewShape:
    """What an example does in its first seconds."""
    return studio.gallery.preview(studio, path)


@routes.get("/mission")
def mission(studio: ThisStudio, path: Name) -> MissionFileShape:
    """A mission opened. One that a picture carries has no file of its own yet: its `path` is ""."""
    data, revision = studio.folder.read(path)
    if may_carry_mission(path):
        data, name = carried_mission(data, path)
        return mission_file(studio, _read(studio, data, name, ""), "", "")
    data, _ = carried_mission(data, path)
    return mission_file(studio, _read(studio, data, path, path), path, revision)


@routes.get("/mission/new")
def mission_new(studio: ThisStudio) -> MissionFileShape:
    """A mission that nobody wrote yet: one program, start and stop, one robot."""
    return mission_file(studio, studio.open(new_mission(), ""), "", "")


@routes.post("/mission/read")
def mission_read(
    studio: ThisStudio, data: Annotated[bytes, Depends(_body)], name: Name = "mission.krt"
) -> MissionFileShape:
    """A mission from the bytes of a file that is not in the folder: a `.krt`, or a picture that holds one."""
    data, name = carried_mission(data, name)
    return mission_file(studio, _read(studio, data, name, ""), "", "")


def _read(studio: Studio, data: bytes, name: str, path: str) -> OpenMission:
    """A file opened, of which there is something to show.

    Raises:
        ProblemsError: it holds no program; the error has the diagnostics.
    """
    opened = studio.read(data, name, path)
    if not any(program.vertices for program in opened.mission.programs):
        message = Sentence("`{name}` is no mission that can be shown: there is no program in it", name)
        raise ProblemsError(message, Sentence("open the `.krt` of a mission"), opened.diagnostics, opened.sources)
    return opened


@routes.put("/mission", responses=_CONFLICT)
def mission_save(studio: ThisStudio, wanted: SaveShape) -> SavedShape:
    """Saves a mission, unless its file is not what the page last saw."""
    made = mission_from_shape(wanted.mission)
    data = mission_bytes(made, wanted.path)
    hold = studio.folder.hold(wanted.path, wanted.revision)
    with hold as path:
        save(path, made)
    return SavedShape(path=wanted.path, revision=revision_of(data), locked=hold.alone)


@routes.post("/mission/text")
def mission_text(wanted: MissionTextShape) -> TextShape:
    """The canonical text of a mission, for a download."""
    return TextShape(text=write_mission(mission_from_shape(wanted.mission)).decode())


@routes.post("/check", response_model=ReportShape)
def check(studio: ThisStudio, wanted: CheckShape) -> Response:
    """Looks a mission through: LLL and three-address code of each program, and every problem."""
    with collection_paused():
        opened = studio.open(mission_from_shape(wanted.mission), wanted.path)
        answer = report_answer(opened.check())
    expect_run(len(opened.mission.team.agents))
    return answer


@routes.post("/mission/team")
def mission_team(studio: ThisStudio, wanted: FirstTeamShape) -> MissionShape:
    """The mission with a first program of the whole team, in which each robot does what it did before."""
    opened = studio.open(mission_from_shape(wanted.mission), wanted.path)
    return mission_shape(first_team(opened, name_form(wanted.name)))


def mission_file(studio: Studio, opened: OpenMission, path: str, revision: str) -> MissionFileShape:
    """An opened mission as the page gets it."""
    studio.world_file(opened.mission.world_href, path)
    # Each check reports the problems of the mission's own world again.
    problems = [item for item in opened.diagnostics if not (item.thing and opened.mission.own_world)]
    # Before the files are read: what changes meanwhile is then news.
    parts = studio.stamp(path)
    catalogue = studio.catalogue_shape(path)
    return MissionFileShape(
        path=path,
        name=opened.name,
        revision=revision,
        mission=mission_shape(opened.mission),
        problems=problem_shapes(problems),
        world=world_shape(opened.world) if opened.world is not None else None,
        catalogue=catalogue,
        parts=parts,
    )
