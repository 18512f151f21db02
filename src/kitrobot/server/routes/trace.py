"""The requests behind recordings: opened from the folder or from what the page sends, and a run recorded to keep."""

from __future__ import annotations

import shutil
from pathlib import Path, PurePosixPath
from typing import Annotated

from fastapi import BackgroundTasks, Query, Request
from fastapi.responses import FileResponse

from kitrobot.files.disk import FileError, read_bytes
from kitrobot.files.folder import RECORDING, revision_of
from kitrobot.judges.judgement import Judgement
from kitrobot.live.background import run_in_background
from kitrobot.live.recordings import RecordingError
from kitrobot.live.studio import Studio
from kitrobot.live.watched_run import WatchedRun
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.server.routes.missions import LONGEST_NAME, mission_file
from kitrobot.server.routes.request_cancellation import run_until_disconnect
from kitrobot.text.sentences import Sentence
from kitrobot.trace.layout import ENDING
from kitrobot.wire.judgement import JudgementShape, judgement_shape
from kitrobot.wire.recording import RecordingEntryShape, RecordingShape
from kitrobot.workspace.traces import is_trace

trace_routes = api_router()


Name = Annotated[str, Query(max_length=LONGEST_NAME)]


@trace_routes.get("/traces")
def traces(studio: ThisStudio) -> list[RecordingEntryShape]:
    """The recordings of the folder."""
    return [
        RecordingEntryShape(path=one.path, name=one.name, modified=one.modified, problem=one.problem)
        for one in studio.folder.traces()
    ]


@trace_routes.get("/trace")
def trace(studio: ThisStudio, path: Name) -> RecordingShape:
    """A recording of the folder, opened."""
    file = studio.folder.path_of(path, ENDING)
    if not file.is_file():
        raise FileError(Sentence("there is no file `{path}`", path), "", path=file)
    return open_recording(studio, file)


@trace_routes.post("/trace")
async def trace_read(studio: ThisStudio, request: Request, name: Name = f"recording{ENDING}") -> RecordingShape:
    """A recording that is not in the folder, from its bytes; they go to the disk as they come."""
    shown = PurePosixPath(name.replace("\\", "/")).name[-100:]
    path = await run_in_background(studio.recordings.new_file, shown if is_trace(shown) else f"recording{ENDING}")
    try:
        with path.open("wb") as file:
            async for piece in request.stream():
                file.write(piece)
        return await run_in_background(open_recording, studio, path)
    except BaseException:
        shutil.rmtree(path.parent, ignore_errors=True)
        raise


@trace_routes.get("/run/trace", response_class=FileResponse)
async def run_trace(studio: ThisStudio, request: Request, run: Name, after: BackgroundTasks) -> FileResponse:
    """The whole past of a run that is on, or at its end, as a recording."""
    watch = _watch_of(studio, run)
    path = await _record(studio, request, watch)
    after.add_task(shutil.rmtree, path.parent, ignore_errors=True)
    return FileResponse(path, media_type="application/octet-stream", background=after)


@trace_routes.get("/run/judgements")
async def run_judgements(studio: ThisStudio, request: Request, run: Name) -> list[JudgementShape]:
    """What the mission's own properties are in all of a run so far, whatever was done to it."""
    watch = _watch_of(studio, run)
    if watch.mission is not None and not watch.mission.properties:
        return []
    path = await _record(studio, request, watch)
    try:
        return [judgement_shape(one) for one in await run_in_background(_judge, path)]
    finally:
        shutil.rmtree(path.parent, ignore_errors=True)


def _judge(path: Path) -> list[Judgement]:
    # What it needs is read when it is asked first.
    from kitrobot.judges.recording_judge import judge_recording

    return judge_recording(path, ready=False)


def _watch_of(studio: Studio, run: str) -> WatchedRun:
    watch = studio.watches.get(run)
    if watch is None:
        raise RecordingError(
            Sentence("there is no such run any more"), Sentence("a run can be saved until another one begins")
        )
    return watch


async def _record(studio: Studio, request: Request, watch: WatchedRun) -> Path:
    """A file with all of a run so far, in a folder of its own, which the caller removes."""
    path = await run_in_background(studio.recordings.new_file, f"run{ENDING}")
    try:
        async with studio.saving:
            await run_until_disconnect(request, lambda stop: watch.record_to(path, stop.is_set))
    except BaseException:
        shutil.rmtree(path.parent, ignore_errors=True)
        raise
    return path


def open_recording(studio: Studio, file: Path) -> RecordingShape:
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
