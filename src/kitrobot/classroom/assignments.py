"""What a class handed out, in a pupil's studio: the files of one exercise, read there and never written over.

Between a class and a page that Python runs in they travel as one ZIP file.
"""

from __future__ import annotations

import io
import zipfile
import zlib
from contextlib import suppress
from pathlib import Path, PurePosixPath
from typing import Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import FileError, make_folder, read_bytes, write_atomic
from kitrobot.text.sentences import Sentence

MOST_FILES: Final = 50
MOST_BYTES: Final = 4 * 1024 * 1024
"""Of all files of one exercise: each pupil's studio gets them."""


class AssignmentError(KitRobotError):
    """The files cannot be handed out, or are none that were."""


def read_files(files: dict[str, Path]) -> dict[str, bytes]:
    """The bytes of files, by name.

    Raises:
        HandedOutError: there is too much.
        FileError: one cannot be read.
    """
    found = {name: read_bytes(path) for name, path in files.items()}
    if len(found) > MOST_FILES or sum(map(len, found.values())) > MOST_BYTES:
        raise AssignmentError(
            Sentence(
                "there are more than {files} files or {most} MB beside this exercise", MOST_FILES, MOST_BYTES >> 20
            ),
            Sentence("put it into a folder of its own"),
        )
    return found


def write_files(folder: Path, files: dict[str, bytes]) -> None:
    """Puts files into a folder, which is made; one that is the same is left.

    Raises:
        FileError: one cannot be written.
    """
    make_folder(folder)
    for name, data in files.items():
        with suppress(FileError):
            if read_bytes(folder / name) == data:
                continue
        write_atomic(folder / name, data)


def pack(files: dict[str, bytes]) -> bytes:
    """The files as one ZIP file."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            # Without the time: a small machine's clock may be before 1980, which a ZIP file cannot hold.
            archive.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)
    return made.getvalue()


def unpack(data: bytes) -> dict[str, bytes]:
    """The files of a ZIP file that `pack` made.

    Raises:
        HandedOutError: it is no ZIP file, there is too much in it, or something that is no file beside an exercise.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            entries = archive.infolist()
            # An entry's announced size is not trusted: it is read up to the limit.
            if len(entries) > MOST_FILES or sum(one.file_size for one in entries) > MOST_BYTES:
                raise _assignment_error()
            return {_plain(one.filename): archive.read(one) for one in entries}
    except (zipfile.BadZipFile, zlib.error, ValueError, NotImplementedError, RuntimeError, EOFError, OSError):
        raise _assignment_error() from None


def is_plain(name: str) -> bool:
    """Whether a file of that name can be handed out: every page takes it, and it leads nowhere else."""
    return PurePosixPath(name).name == name and "\\" not in name and ":" not in name and not name.startswith(".")


def _plain(name: str) -> str:
    if not is_plain(name):
        raise _assignment_error()
    return name


def _assignment_error() -> AssignmentError:
    return AssignmentError(
        Sentence("these are not the files of an exercise that a class handed out"), Sentence("ask your teacher")
    )
