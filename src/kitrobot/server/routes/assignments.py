"""`PUT /api/handed-out`: the class puts the files of one exercise into a pupil's studio."""

from __future__ import annotations

from typing import Annotated

from fastapi import Query, Request

from kitrobot.classroom.assignments import unpack, write_files
from kitrobot.files.folder import EXERCISE_ENDING, HANDED_OUT, ReadOnlyError
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.text.sentences import Sentence

handed_out_routes = api_router()


@handed_out_routes.put("/handed-out")
async def handed_out(studio: ThisStudio, request: Request, exercise: Annotated[str, Query(max_length=1000)]) -> bool:
    """Puts the files of an exercise where the class has them; only the studio of a pupil takes them."""
    path = studio.folder.path_of(exercise, EXERCISE_ENDING)
    if not studio.folder.in_class or path.parent.parent != studio.folder.root / HANDED_OUT:
        raise ReadOnlyError(Sentence("nothing is handed out in this studio"), "")
    write_files(path.parent, unpack(await request.body()))
    return True
