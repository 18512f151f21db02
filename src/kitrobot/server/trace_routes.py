"""The requests behind recordings: opened from the folder or from what the page sends, and a run recorded to keep."""

from __future__ import annotations

import shutil
from asyncio import to_thread
from pathlib import Path, PurePosixPath
from typing import Annotated

from fastapi import APIRouter, BackgroundTasks, Depends, Query, Request
from fastapi.responses import FileResponse

from kitrobot.server.json_bodies import JsonRoute
from kitrobot.server.playing import Player
from kitrobot.server.recordings import RecordingError
from kitrobot.server.routes import LONGEST_NAME, mission_file
from kitrobot.server.sentences import spoken
from kitrobot.server.shapes import FailureShape, RecordingEntryShape, RecordingShape
from kitrobot.server.studio import Studio
from kitrobot.trace import ENDING
from kitrobot.workspace import FileError, is_trace, revision_of
from kitrobot.workspace.files import read_bytes
from kitrobot.workspace.folder import RECORDING

trace_routes = APIRouter(
    prefix="/api",
    route_class=JsonRoute,
    responses={"4XX": {"model": FailureShape, "description": "Why it could not be done, and a way out."}},
)


def _studio(request: Request) -> Studio:
    studio = request.app.state.studio
    assert isinstance(studio, Studio)
    return studio


StudioOf = Annotated[Studio, Depends(_studio)]
Name = Annotated[str, Query(max_length=LONGEST_NAME)]


@trace_routes.get("/traces")
def traces(studio: StudioOf) -> list[RecordingEntryShape]:
    """The recordings of the folder."""
    return [
        RecordingEntryShape(path=one.path, name=one.name, modified=one.modified, problem=spoken(one.problem))
        for one in studio.folder.traces()
    ]


@trace_routes.get("/trace")
def trace(studio: StudioOf, path: Name) -> RecordingShape:
    """A recording of the folder, opened."""
    file = studio.folder.path_of(path, ENDING)
    if not file.is_file():
        raise FileError(f"there is no file `{path}`", "", path=file)
    return _opened(studio, file)


@trace_routes.post("/trace")
async def trace_read(studio: StudioOf, request: Request, name: Name = f"recording{ENDING}") -> RecordingShape:
    """A recording that is not in the folder, from its bytes; they go to the disk as they come."""
    shown = PurePosixPath(name.replace("\\", "/")).name[-100:]
    path = await to_thread(studio.recordings.new_file, shown if is_trace(shown) else f"recording{ENDING}")
    try:
        with path.open("wb") as file:
            async for piece in request.stream():
                file.write(piece)
        return await to_thread(_opened, studio, path)
    except BaseException:
        shutil.rmtree(path.parent, ignore_errors=True)
        raise


@trace_routes.get("/run/trace", response_class=FileResponse)
def run_trace(studio: StudioOf, run: Name, after: BackgroundTasks) -> FileResponse:
    """The whole past of a run that is on, or stands at its end, as a recording."""
    watch = studio.watches.get(run)
    if watch is None:
        raise RecordingError("there is no such run any more", "a run can be saved until another one begins")
    path = studio.recordings.new_file(f"run{ENDING}")
    after.add_task(shutil.rmtree, path.parent, ignore_errors=True)
    if isinstance(watch, Player):
        shutil.copyfile(watch.path, path)
    else:
        with studio.saving:
            watch.record_to(path)
    return FileResponse(path, media_type="application/octet-stream", background=after)


def _opened(studio: Studio, file: Path) -> RecordingShape:
    """Opens a recording, with its mission from the folder that it was unpacked to."""
    name, mission, trace = studio.recordings.add(file)
    with trace.reader as reader:
        path = f"{RECORDING}{name}/{mission.name}"
        data = read_bytes(mission)
        return RecordingShape(
            recording=name,
            seed=reader.header.seed,
            fail_rate=reader.header.fail_rate,
            cut=reader.cut,
            real=reader.header.real,
            file=mission_file(studio, studio.read(data, path, path), path, revision_of(data)),
        )
