"""Opening, replacing and locking files that a person names: only those with an end, and without waiting for anybody.

A pipe waits until somebody writes into it, a device has no end: neither is a file of ours, whatever its name is.
"""

from __future__ import annotations

import errno
import os
import stat
import sys
from pathlib import Path
from typing import BinaryIO

from kitrobot.diagnostics.read_files import note_read
from kitrobot.text.forms import name_form
from kitrobot.text.sentences import Sentence

_FLAGS = os.O_RDONLY | sum(getattr(os, name, 0) for name in ("O_BINARY", "O_CLOEXEC", "O_NOCTTY", "O_NONBLOCK"))
_KINDS = (
    (stat.S_ISDIR, errno.EISDIR, Sentence("it is a folder, not a file")),
    (stat.S_ISFIFO, errno.EINVAL, Sentence("it is a pipe, not a file")),
    (stat.S_ISSOCK, errno.EINVAL, Sentence("it is a socket, not a file")),
    (stat.S_ISLNK, errno.ELOOP, Sentence("it is a symbolic link, not a file")),
)
_TAKEN = {errno.EACCES, errno.EAGAIN, errno.EWOULDBLOCK, errno.EDEADLK}
"""What the system answers when somebody has the lock; anything else says that there are no locks to be had."""
_DEVICE = Sentence("it is a device, not a file")


def open_regular(path: Path, *, follow: bool = True) -> BinaryIO:
    """A file for reading. Without `follow` a symbolic link is refused, where the system can tell.

    Raises:
        OSError: it cannot be opened, or is a folder, a pipe, a socket or a device; `strerror` says so.
        ValueError: no file can have that name.
    """
    # Looked at before too: opening some devices does something.
    _look(os.stat(path, follow_symlinks=follow), path)
    handle = os.open(path, _FLAGS if follow else _FLAGS | getattr(os, "O_NOFOLLOW", 0))
    try:
        _look(os.fstat(handle), path)
        note_read(path, handle)
        return os.fdopen(handle, "rb")
    except BaseException:
        os.close(handle)
        raise


def expect_regular(path: Path) -> None:
    """That what lies where a file is to be written is a file, or nothing.

    Whoever may do everything could replace a device of the system; a pipe would wait for somebody who reads it.

    Raises:
        OSError: it is a folder, a pipe, a socket or a device; `strerror` says so.
        ValueError: no file can have that name.
    """
    try:
        state = os.stat(path)
    except FileNotFoundError:
        return
    _look(state, path)


def lock_handle(handle: int) -> bool:
    """Locks an open file for whoever has it open like that; it ends when the file is closed, and with the process.

    Returns: whether it was free.

    Raises:
        OSError: its file system has no locks.
    """
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        if error.errno in _TAKEN:
            return False
        raise
    return True


def _look(state: os.stat_result, path: Path) -> None:
    if stat.S_ISREG(state.st_mode):
        return
    for is_kind, number, sentence in _KINDS:
        if is_kind(state.st_mode):
            raise OSError(number, sentence, str(path))
    raise OSError(errno.EINVAL, _DEVICE, str(path))


def named_file(folder: Path, name: str) -> Path | None:
    """The file of a folder that another file names; None where there is none, also where no system can have one.

    The same name in another form of Unicode is the same file: file systems and archives change the form.
    """
    try:
        path = folder / name
        if path.is_file() or name.isascii():
            return path if path.is_file() else None
        wanted = name_form(path.name)
        return next((one for one in path.parent.iterdir() if name_form(one.name) == wanted and one.is_file()), None)
    except (OSError, ValueError):
        return None
