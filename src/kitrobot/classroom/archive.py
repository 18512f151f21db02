"""The work of a class as a ZIP file, and as a table in which no cell can start a spreadsheet formula."""

from __future__ import annotations

import csv
import io
import zipfile
from contextlib import suppress
from dataclasses import dataclass
from typing import Final

from kitrobot.classroom.class_room import ClassError, ClassRoom
from kitrobot.classroom.grade_tables import as_cell
from kitrobot.classroom.pupil import Pupil, met
from kitrobot.classroom.submissions import Submission
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import FileError
from kitrobot.live.studio import Studio
from kitrobot.text.sentences import Sentence

MOST_BYTES: Final = 256 * 1024 * 1024
"""Of the files together; more are in the class's folder anyway."""
TABLE: Final = "class.csv"


@dataclass(frozen=True)
class ClassArchive:
    """The ZIP file, and the number of pupils' files in it."""

    data: bytes
    files: int


def build_archive(room: ClassRoom, studio: Studio, folders: list[str] | None) -> ClassArchive:
    """Everything that those pupils, or all, handed in.

    Raises:
        ClassError: it is more than fits.
    """
    out = io.BytesIO()
    taken = files = 0
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for pupil in _chosen(room, folders):
            for work in room.list_submissions(pupil):
                taken += work.bytes
                if taken > MOST_BYTES:
                    raise ClassError(
                        Sentence("there is more than {most} MB", MOST_BYTES // (1024 * 1024)),
                        Sentence("copy the folder `{folder}` instead: everything is in it", room.folder.name),
                    )
                with suppress(FileError):
                    data, _ = room.read_submission(pupil, work.name)
                    archive.writestr(_info(f"{pupil.folder}/{work.name}", work), data)
                    files += 1
        archive.writestr(TABLE, table(room, studio, folders))
    return ClassArchive(out.getvalue(), files)


def _info(name: str, work: Submission) -> zipfile.ZipInfo:
    year, month, day, hour, minute, second = (int(work.modified[a:b]) for a, b in _PLACES)
    # A ZIP file knows the years from 1980 to 2107 only.
    return zipfile.ZipInfo(name, (min(max(1980, year), 2107), month, day, hour, minute, second))


_PLACES: Final = ((0, 4), (5, 7), (8, 10), (11, 13), (14, 16), (17, 19))


def table(room: ClassRoom, studio: Studio, folders: list[str] | None) -> str:
    """A line for each pupil: what was handed in last, and the goals as the pupil's own page judged them. In English."""
    labels = goal_labels(studio, room.record.exercise)
    out = io.StringIO()
    lines = csv.writer(out, lineterminator="\r\n")
    lines.writerow(map(as_cell, ["pupil", "folder", "file", "handed in (UTC)", "exercise", "goals met", "of", *labels]))
    for pupil in _chosen(room, folders):
        lines.writerow(map(as_cell, _line(room, pupil, labels)))
    return "\ufeff" + out.getvalue()


def goal_labels(studio: Studio, exercise: str) -> list[str]:
    """The goals of an exercise in English; none where it cannot be used."""
    if not exercise:
        return []
    with suppress(KitRobotError):
        return [goal.label.get("", "") for goal in studio.exercises.usable(exercise)[0].goals_for(hidden=False)]
    return []


def _line(room: ClassRoom, pupil: Pupil, labels: list[str]) -> list[object]:
    newest = next(iter(room.list_submissions(pupil)), None)
    exercise = room.record.exercise
    ours = pupil.report.goals if exercise and pupil.report.exercise == exercise else ()
    words = {True: "yes", False: "no", None: ""}
    goals = [words[ours[at].reached] if at < len(ours) else "" for at in range(len(labels))]
    return [
        pupil.record.name,
        pupil.folder,
        newest.name if newest else "",
        newest.modified if newest else "",
        exercise,
        met(pupil, exercise) if exercise else "",
        len(labels) or "",
        *goals,
    ]


def _chosen(room: ClassRoom, folders: list[str] | None) -> list[Pupil]:
    return [one for one in list(room.pupils.values()) if folders is None or one.folder in folders]
