"""The folder of a study: `plan.toml`, and rows as lines of JSON, appended and synced as runs end.

Lines are the truth. Each supervisor appends to a file of its own, `rows.jsonl`, or of a shard `rows-3-of-64.jsonl`, and
holds a lock beside it. A last line that a crash cut off is dropped and its run made again. A row that stands twice is
the same row: it counts once.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from json import JSONDecodeError
from pathlib import Path
from types import TracebackType
from typing import Any

import kitrobot
from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.plan import PLAN_FILE, Plan, read_plan
from kitrobot.files.disk import make_folder, read_text, write_atomic
from kitrobot.files.file_lock import FileLock
from kitrobot.text.json_text import from_json
from kitrobot.text.sentences import Sentence, Word

ROWS = "rows.jsonl"
_PIECE = 1 << 20


def is_study(folder: Path) -> bool:
    """Whether a study is there."""
    return (folder / PLAN_FILE).is_file()


def begin_study(folder: Path, plan: Plan) -> None:
    """Makes the folder of a study; one that is there already must be the very same.

    Raises:
        ExperimentError: the folder holds another study, or cannot be written.
    """
    text = plan.to_toml()
    try:
        if is_study(folder):
            if read_text(folder / PLAN_FILE) != text:
                raise ExperimentError(
                    Sentence("`{folder}` holds another study", folder.name),
                    Sentence("go on with that one (`kitrobot sweep {folder} --resume`), or name a new folder", folder),
                )
            return
        make_folder(folder)
        write_atomic(folder / PLAN_FILE, text.encode())
    except OSError as error:
        raise _unwritable(folder, error) from error


def open_study(folder: Path) -> Plan:
    """The plan of a study.

    Raises:
        ExperimentError: there is none in this folder.
    """
    if not is_study(folder):
        raise ExperimentError(
            Sentence("`{folder}` holds no study", folder.name),
            Sentence("a study is a folder with a plan.toml, which `kitrobot sweep FILE -o FOLDER` makes"),
        )
    return read_plan(read_text(folder / PLAN_FILE), f"{folder.name}/{PLAN_FILE}")


def expect_same_version(plan: Plan) -> None:
    """Refuses to go on with a study of another version: its rows would not be comparable.

    Raises:
        ExperimentError: it is one.
    """
    if plan.version != kitrobot.__version__:
        raise ExperimentError(
            other_version(plan, kitrobot.__version__),
            Sentence("go on with that version, or begin it anew in another folder"),
        )


def other_version(plan: Plan, found: str) -> Sentence:
    """What is said where another version is found than that of a study."""
    return Sentence("this study was begun with KitRobot {version}, this is {ours}", plan.version, found)


def row_files(folder: Path) -> list[Path]:
    """The files of its rows, by name."""
    return sorted(folder.glob("rows*.jsonl"))


def row_lines(folder: Path) -> Iterator[bytes]:
    """All whole lines of a study, each once or more; one that is being written is none yet."""
    for path in row_files(folder):
        for block in row_blocks(path):
            yield from block.splitlines(keepends=True)


def row_blocks(path: Path, begin: int = 0) -> Iterator[bytes]:
    """The whole lines of a file of rows from a byte on, many at a time.

    Raises:
        ExperimentError: it cannot be read.
    """
    try:
        with path.open("rb") as file:
            file.seek(begin)
            begun = b""
            while piece := file.read(_PIECE):
                whole = piece.rfind(b"\n") + 1
                if whole:
                    yield begun + piece[:whole]
                    begun = b""
                begun += piece[whole:]
    except OSError as error:
        message = Sentence("`{path}` cannot be read: {reason}", path.name, Word(error.strerror or error))
        raise ExperimentError(message) from error


def study_rows(folder: Path, plan: Plan) -> Iterator[dict[str, Any]]:
    """The rows of a study, each once, in the order in which they were written.

    Raises:
        ExperimentError: a line is no row of this study.
    """
    seen = bytearray(plan.rows)
    for line in row_lines(folder):
        row = read_row(line, plan, folder)
        if not seen[row["row"]]:
            seen[row["row"]] = 1
            yield row


def read_row(line: bytes, plan: Plan, folder: Path) -> dict[str, Any]:
    """A row from its line.

    Raises:
        ExperimentError: it is no row of this study.
    """
    try:
        row = from_json(line)
        if isinstance(row, dict) and isinstance(row["row"], int) and 0 <= row["row"] < plan.rows:
            return row
    except (JSONDecodeError, KeyError):
        pass
    raise no_row(line, folder)


def no_row(line: bytes, folder: Path) -> ExperimentError:
    """What is said of a line that is no row of its study."""
    shown = line[:60].decode(errors="replace").strip()
    return ExperimentError(
        Sentence("`{folder}` holds a line that is no row of its study: `{line}`", folder.name, shown),
        Sentence("take that line out of its file; the run is then made again"),
    )


def finished_rows(folder: Path, plan: Plan) -> bytearray:
    """A 1 for each row that is there, by its number.

    Raises:
        ExperimentError: a line is no row of this study.
    """
    done = bytearray(plan.rows)
    for line in row_lines(folder):
        row = read_row(line, plan, folder)
        if row.get("id") != plan.row_id(row["row"]):
            raise ExperimentError(
                Sentence("`{folder}` holds rows of another study", folder.name),
                Sentence("keep each study in a folder of its own"),
            )
        done[row["row"]] = 1
    return done


class RowWriter:
    """Appends rows to a file of a study, alone; `with` it.

    Raises:
        ExperimentError: another process is at it, or the disk refuses; what was written stays.
    """

    def __init__(self, folder: Path, name: str = ROWS, sync: Callable[[int], None] = os.fsync) -> None:
        self._folder, self._path, self._sync = folder, folder / name, sync
        try:
            lock = FileLock.take(folder / f"{name}.lock")
        except OSError as error:
            raise _unwritable(folder, error) from error
        if lock is None:
            raise ExperimentError(
                Sentence("`{folder}` is being worked on by another process", folder.name),
                Sentence("wait for it, or share the work out with --shard 1/2 and --shard 2/2"),
            )
        self._lock = lock
        try:
            self._file = os.open(self._path, os.O_RDWR | os.O_CREAT | getattr(os, "O_BINARY", 0), 0o666)
            self._end = _whole_end(self._file)
            os.ftruncate(self._file, self._end)
            os.lseek(self._file, self._end, os.SEEK_SET)
        except OSError as error:
            lock.release()
            raise _unwritable(folder, error) from error

    def write(self, rows: Sequence[bytes]) -> None:
        """Appends rows, all of them or none, and waits until the disk has them."""
        data = b"".join(rows)
        try:
            view = memoryview(data)
            while view:
                view = view[os.write(self._file, view) :]
            self._sync(self._file)
        except OSError as error:
            try:
                os.ftruncate(self._file, self._end)
                os.lseek(self._file, self._end, os.SEEK_SET)
            except OSError:
                pass  # The next one to open it drops a line that is cut off.
            raise _unwritable(self._folder, error) from error
        self._end += len(data)

    def __enter__(self) -> RowWriter:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        os.close(self._file)
        self._lock.release()


def _whole_end(file: int) -> int:
    """Where the last whole line of a file ends."""
    end = os.lseek(file, 0, os.SEEK_END)
    while end > 0:
        begin = max(0, end - _PIECE)
        os.lseek(file, begin, os.SEEK_SET)
        at = os.read(file, end - begin).rfind(b"\n")
        if at >= 0:
            return begin + at + 1
        end = begin
    return 0


def _unwritable(folder: Path, error: OSError) -> ExperimentError:
    return ExperimentError(
        Sentence("the study in `{folder}` cannot be written: {reason}", folder.name, Word(error.strerror or error)),
        Sentence("all rows until then are kept; go on with --resume when there is room"),
    )
