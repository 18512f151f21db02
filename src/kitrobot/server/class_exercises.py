"""Exercises of the teacher's own: files of the class's folder, put where the pages of pupils find them.

An exercise that is chosen is copied into `Handed out`, in a folder of its own: the file, the mission that it begins
with, and the XML files beside them (worlds, robots). So pupils and grading have the same one, also while the teacher
goes on writing. Pupils' studios get a copy under the same name, which they read and do not write.
"""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path, PurePosixPath
from typing import Final

from kitrobot.classroom import HANDED_OUT, ClassError, ClassRoom
from kitrobot.classroom.names import as_file_name
from kitrobot.files import (
    EXAMPLE,
    EXERCISE_ENDING,
    TUTORIAL_ENDING,
    FileError,
    read_bytes,
    write_atomic,
)
from kitrobot.server.studio import Studio
from kitrobot.text import Sentence

MOST_FILES: Final = 50
MOST_BYTES: Final = 4 * 1024 * 1024
"""Of all files of one exercise: each pupil's studio gets them."""


def hand_out_exercise(room: ClassRoom, studio: Studio, name: str) -> str:
    """Puts an exercise of the folder where pupils find it; gives the name that it has there. One that comes with
    KitRobot, or was handed out before, is there already.

    Raises:
        MissionNameError: it is no name of an exercise.
        LessonGoneError: it cannot be used.
        ClassError: it is a pupil's, or there is too much beside it.
        FileError: it cannot be read or written.
    """
    exercise, start = studio.exercises.usable(name)
    pure = PurePosixPath(name)
    if name.startswith(EXAMPLE) or pure.parts[0] == HANDED_OUT:
        return name
    if pure.parts[0] in room.pupils and len(pure.parts) > 1:
        raise ClassError(
            Sentence("this exercise lies in the folder of a pupil"), Sentence("put it into the folder of the class")
        )
    path = studio.folder.path_of(name, EXERCISE_ENDING)
    files = {pure.name: path, exercise.start: studio.folder.path_of(start)}
    for beside in sorted(path.parent.glob("*.xml")):
        if not beside.name.endswith((EXERCISE_ENDING, TUTORIAL_ENDING)):
            files.setdefault(beside.name, beside)
    folder = PurePosixPath(HANDED_OUT) / as_file_name(str(pure)[: -len(EXERCISE_ENDING)].replace("/", " - "))
    _write(room.folder / folder, _contents(files))
    return str(folder / pure.name)


def copy_exercise(room: ClassRoom, studio: Path) -> None:
    """Puts what is needed of the exercise of the class into a pupil's studio."""
    folder = PurePosixPath(room.record.exercise).parent
    if folder.parent == PurePosixPath(HANDED_OUT) and folder.name != ".." and (room.folder / folder).is_dir():
        found = {path.name: path for path in (room.folder / folder).iterdir() if path.is_file()}
        _write(studio / folder, _contents(found))


def _contents(files: dict[str, Path]) -> dict[str, bytes]:
    found = {name: read_bytes(path) for name, path in files.items()}
    if len(found) > MOST_FILES or sum(map(len, found.values())) > MOST_BYTES:
        raise ClassError(
            Sentence(
                "there are more than {files} files or {most} MB beside this exercise", MOST_FILES, MOST_BYTES >> 20
            ),
            Sentence("put it into a folder of its own"),
        )
    return found


def _write(folder: Path, files: dict[str, bytes]) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(
            Sentence("`{path}` cannot be made: {reason}", folder.name, error.strerror or str(error)), "", path=folder
        ) from None
    for name, data in files.items():
        with suppress(FileError):
            if read_bytes(folder / name) == data:
                continue
        write_atomic(folder / name, data)
