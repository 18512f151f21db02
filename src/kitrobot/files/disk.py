"""Files on disk: read whole or refused with a sentence, written whole or not at all.

Every way a file can fail (missing, a folder, not ours to read, too large, not UTF-8) becomes a `FileError` that names
the file and a way out. A write goes to a temporary file beside its place and is moved there, so a reader, or a power
cut, finds the old content or the new one. Who replaces a file holds its folder's lock (`saving_in`), so between a look
at the old content and the write nobody else replaces it. Left to others: what the bytes mean.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Place, Severity, rule
from kitrobot.diagnostics.read_files import expect_output
from kitrobot.diagnostics.regular import expect_regular, open_regular
from kitrobot.files.file_lock import FileLock
from kitrobot.files.folder_quota import expect_room, expect_room_for_folder
from kitrobot.text.forms import line_feeds, no_text, older_copy
from kitrobot.text.sentences import Help, Sentence, Word

LARGEST_FILE_BYTES = 64 * 1024 * 1024
"""More than any mission, world or image; a device or a film given by mistake is refused instead of filling memory."""
LOCK_NAME = ".kitrobot.lock"
"""The file in each folder that is locked while one of its files is replaced."""
LONGEST_WAIT_S = 10.0
"""How long a save waits for others; one save takes some milliseconds."""
_ENDING = ".kitrobot-part"
_TEMPORARY = re.compile(rf"\..{{1,50}}\.[a-z0-9_]{{8}}{re.escape(_ENDING)}~?", re.DOTALL)
"""The names of what is being written."""

_TOO_LONG = (errno.ENAMETOOLONG, errno.ENOENT, errno.EINVAL)
"""What systems say of a name that is too long, in a folder that is there."""

UNREADABLE = rule(
    "file-unreadable",
    Severity.ERROR,
    "A file could not be read",
    "The file is missing, is a folder, may not be read, is too large, or is not text in UTF-8. The other files that"
    " were named in the same command are still looked at.",
)


@dataclass(eq=False)
class FileError(KitRobotError):
    """A file could not be read or written; `place` is where in it, when that is known."""

    path: Path = Path()
    place: Place | None = None

    def as_diagnostic(self) -> Diagnostic:
        """The same as a diagnostic, for commands that look at many files."""
        return UNREADABLE(self.message, self.place or Place(str(self.path)), help=self.help)


def read_bytes(path: Path) -> bytes:
    """The content of a file.

    Raises:
        FileError: there is no such file, it is a folder, a pipe or a device, may not be read, or is larger than
            `LARGEST_FILE_BYTES`.
    """
    try:
        if path.is_dir():
            raise _unreadable(path, Sentence("`{path}` is a folder, not a file", path), Sentence("name a file in it"))
        with open_regular(path) as stream:
            data = stream.read(LARGEST_FILE_BYTES + 1)
    except FileNotFoundError:
        raise _unreadable(path, Sentence("there is no file `{path}`", path), suggest_similar_name(path)) from None
    except (OSError, ValueError) as error:
        raise _unreadable(path, Sentence("`{path}` could not be read: {reason}", path, _reason(error)), "") from None
    if len(data) > LARGEST_FILE_BYTES:
        limit = LARGEST_FILE_BYTES // (1024 * 1024)
        raise _unreadable(
            path,
            Sentence("`{path}` is larger than {limit} MB", path, limit),
            Sentence("no file of KitRobot is that large"),
        )
    return data


def read_text(path: Path) -> str:
    """The content of a text file in UTF-8, with or without a byte order mark.

    Raises:
        FileError: as for `read_bytes`, and when the bytes are not UTF-8 (the place is the first wrong byte).
    """
    return decode(read_bytes(path), path)


def decode(data: bytes, path: Path) -> str:
    """Bytes of a file as text, whose lines end with a line feed.

    Raises:
        FileError: they are not UTF-8, or nothing but zero bytes.
    """
    if data and not data.strip(b"\0"):
        raise FileError(no_text(len(data)), older_copy(path), path=path, place=Place(str(path), 1, 1, 1, 1))
    try:
        return line_feeds(data.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        before = line_feeds(data[: error.start].decode("utf-8", errors="replace"))
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        place = Place(str(path), line, column, line, column + 1)
        byte = data[error.start]
        message = Sentence(
            "`{path}` is not text in UTF-8: byte {byte} in line {line}, column {column}",
            path,
            f"{byte:#04x}",
            line,
            column,
        )
        raise FileError(message, Sentence("save the file with the encoding UTF-8"), path=path, place=place) from None


def make_folder(folder: Path) -> None:
    """Makes a folder, and those above it that are missing.

    Raises:
        FileError: it cannot be made.
        QuotaError: there is no room for it.
    """
    expect_room_for_folder(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(
            Sentence("the folder `{folder}` could not be made: {reason}", folder, error.strerror or str(error)),
            path=folder,
        ) from None


def write_atomic(path: Path, data: bytes, before: bytes | None = None) -> None:
    """Writes a whole file or leaves the old one as it was; a link is followed, the file's mode is kept.

    Args:
        path: the file.
        data: all of it.
        before: what it must still hold, if that matters.

    Raises:
        FileError: the folder is missing or may not be written to, the disk is full, or somebody changed the file.
        OutputPlaceError: it is a file that this command has read, and `before` is not said.
    """
    with saving_in(path):
        if before is not None:
            expect_unchanged(path, before)
        replace_file(path, data, over_input=before is not None)


def replace_file(path: Path, data: bytes, *, over_input: bool = False) -> None:
    """`write_atomic` for who holds the folder's lock already; `over_input` as for `replace_whole`.

    Raises:
        FileError: the folder is missing or may not be written to, or the disk is full.
        OutputPlaceError: it is a file that this command has read.
    """
    try:
        replace_whole(path, data, over_input=over_input)
    except FileNotFoundError:
        raise _unreadable(
            path, Sentence("there is no folder `{folder}`", path.parent), Sentence("make the folder first")
        ) from None
    except (OSError, ValueError) as error:
        raise _unreadable(path, Sentence("`{path}` could not be written: {reason}", path, _reason(error)), "") from None


def replace_whole(path: Path, data: bytes, *, keep_old: bool = False, over_input: bool = False) -> None:
    """Puts a new file in the place of an old one, for who holds the folder's lock; a link is followed.

    The bytes are on the disk before the old file is gone. The new one has the old one's mode. With `keep_old` what was
    there before stays with a `~` behind its name, but where that name is too long for the file system. With
    `over_input` it may be a file that this command has read.

    Raises:
        OutputPlaceError: it is a file that this command has read.
        OSError: the operating system refused; the old file is untouched.
        ValueError: the path is none.
        QuotaError: there is no room for it.
    """
    # Not before: most who read files write none.
    import tempfile

    if not over_input:
        expect_output(path)
    target = Path(os.path.realpath(path))
    expect_regular(target)
    if keep_old and target.exists():
        expect_output(target.with_name(target.name + "~"))
    expect_room(target, len(data), keep_old=keep_old)
    handle, name = tempfile.mkstemp(prefix=f".{target.name[:50]}.", suffix=_ENDING, dir=target.parent)
    fresh, copy = Path(name), Path(name + "~")
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())
        if target.exists():
            shutil.copymode(target, fresh)
            if keep_old:
                shutil.copy2(target, copy)
                try:
                    os.replace(copy, target.with_name(target.name + "~"))
                except OSError as error:
                    if error.errno not in _TOO_LONG:
                        raise
                    copy.unlink()
        else:
            fresh.chmod(_new_file_mode())
        os.replace(fresh, target)
    except BaseException:
        for left in (fresh, copy):
            with contextlib.suppress(OSError):
                left.unlink()
        raise
    _settle(target.parent)


def _settle(folder: Path) -> None:
    """Makes sure the folder itself is on the disk, where the system lets us."""
    if os.name != "posix":
        return
    with contextlib.suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def expect_unchanged(path: Path, before: bytes) -> None:
    """That a file still holds what was read; for who holds its folder's lock.

    Raises:
        FileError: it holds something else, or cannot be read any more.
    """
    if read_bytes(path) != before:
        raise _unreadable(
            path, Sentence("`{path}` was changed by somebody else meanwhile", path), Sentence("do the same again")
        )


@contextlib.contextmanager
def saving_in(path: Path) -> Iterator[bool]:
    """A context in which no other thread and no other KitRobot replaces files in the folder of `path`.

    Gives False where that cannot be had: no file can be made there, or the file system has no locks.

    Raises:
        FileError: somebody else has been saving there for longer than `LONGEST_WAIT_S`.
    """
    try:
        lock = FileLock.wait(_lock_for(path), LONGEST_WAIT_S)
    except (OSError, ValueError):
        yield False  # what cannot be written says so itself
        return
    if lock is None:
        message = Sentence("`{path}` cannot be written now: another KitRobot is saving in the same folder", path)
        raise _unreadable(path, message, Sentence("try again; if that does not help, end the other KitRobot"))
    try:
        yield True
    finally:
        lock.release()


def sweep(folder: Path) -> int:
    """Removes what killed saves left in a folder, and gives how many files that were.

    Only files with the names of our unfinished writes, and only while nobody of us writes in that folder.
    """
    removed = 0
    with contextlib.suppress(OSError):
        left = [entry for entry in folder.iterdir() if _TEMPORARY.fullmatch(entry.name)]
        lock = FileLock.take(folder / LOCK_NAME) if left else None
        if lock is not None:
            for entry in left:
                with contextlib.suppress(OSError):
                    entry.unlink()
                    removed += 1
            lock.release()
    return removed


def _lock_for(path: Path) -> Path:
    return Path(os.path.realpath(path)).parent / LOCK_NAME


def same_file(one: Path, other: Path) -> bool:
    """Whether two paths lead to one file, by whatever links."""
    try:
        return one.samefile(other)
    except OSError:
        return os.path.realpath(one) == os.path.realpath(other)


def _new_file_mode() -> int:
    mask = os.umask(0o077)
    os.umask(mask)
    return 0o666 & ~mask


def _unreadable(path: Path, message: Sentence, help: Help) -> FileError:
    return FileError(message, help, path=path)


def _reason(error: Exception) -> str:
    reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
    return Word(reason[:1].lower() + reason[1:])


def suggest_similar_name(path: Path) -> Help:
    """The nearest name in the folder, as a help sentence; empty when nothing is near."""
    from difflib import get_close_matches

    try:
        names = [entry.name for entry in path.parent.iterdir()]
    except OSError:
        return ""
    near = get_close_matches(path.name, names, n=1)
    return Sentence("did you mean `{near}`?", path.parent / near[0]) if near else ""
