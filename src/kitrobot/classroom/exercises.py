"""Exercises of the teacher's own: files of the class's folder, put where the pages of pupils find them.

An exercise that is chosen is copied into `Handed out`, in a folder of its own: the file, the mission that it begins
with, and the XML files beside them (worlds, robots). So pupils and grading have the same one, also while the teacher
goes on writing. Pupils' studios get a copy under the same name, which they read and do not write.
"""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path, PurePosixPath

from kitrobot.classroom.assignments import is_plain, read_files, write_files
from kitrobot.classroom.class_room import ClassError, ClassRoom
from kitrobot.classroom.names import as_file_name
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.exercise.hidden_parts import remove_hidden_parts
from kitrobot.files.folder import EXAMPLE, EXERCISE_ENDING, HANDED_OUT, TUTORIAL_ENDING
from kitrobot.live.studio import Studio
from kitrobot.text.sentences import Sentence


def exercise_label(studio: Studio, name: str) -> str:
    """What an exercise is called in English; "" where it cannot be used."""
    with suppress(KitRobotError):
        return studio.exercises.usable(name)[0].label.get("", "")
    return ""


def is_exercise(studio: Studio, name: str) -> bool:
    """Whether pupils can have an exercise of that name."""
    if not name.startswith((EXAMPLE, f"{HANDED_OUT}/")):
        return False
    with suppress(KitRobotError):
        studio.exercises.usable(name)
        return True
    return False


def hand_out_exercise(room: ClassRoom, studio: Studio, name: str) -> str:
    """Puts an exercise of the folder where pupils find it; gives the name that it has there. One that comes with
    KitRobot, or was handed out before, is there already.

    Raises:
        MissionNameError: it is no name of an exercise.
        LessonUnavailableError: it cannot be used.
        ClassError: it is a pupil's.
        HandedOutError: there is too much beside it.
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
        if is_plain(beside.name) and beside.is_file() and not beside.name.endswith((EXERCISE_ENDING, TUTORIAL_ENDING)):
            files.setdefault(beside.name, beside)
    folder = PurePosixPath(HANDED_OUT) / as_file_name(str(pure)[: -len(EXERCISE_ENDING)].replace("/", " - "))
    write_files(room.folder / folder, read_files(files))
    return str(folder / pure.name)


def files_of_exercise(room: ClassRoom, name: str = "") -> tuple[PurePosixPath, dict[str, bytes]]:
    """The files of an exercise as pupils get them, and the folder that they are in; none where it comes with KitRobot,
    or was never handed out. What is hidden is not in them: grading reads the folder. `name`: "" for that of the class.

    Raises:
        HandedOutError: there is too much.
        FileError: one cannot be read.
    """
    folder = PurePosixPath(name or room.record.exercise).parent
    plain = folder.parent == PurePosixPath(HANDED_OUT) and folder.name != ".." and "\0" not in name
    if not plain or not (room.folder / folder).is_dir():
        return folder, {}
    beside = sorted((room.folder / folder).iterdir())
    files = read_files({path.name: path for path in beside if is_plain(path.name) and path.is_file()})
    for name in [name for name in files if name.endswith(EXERCISE_ENDING)]:
        try:
            files[name] = remove_hidden_parts(files[name], name)
        except ValueError:
            del files[name]
    return folder, files


def copy_exercise(room: ClassRoom, studio: Path) -> None:
    """Puts what is needed of the exercise of the class into a pupil's studio.

    Raises:
        HandedOutError: there is too much.
        FileError: something cannot be read or written.
    """
    folder, files = files_of_exercise(room)
    if files:
        write_files(studio / folder, files)
