"""Making the rows of a study, going on with it, and putting its shards together.

The rows are the same whatever makes them, in whatever order: this process, several, shards, and after any crash.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import compress
from pathlib import Path
from typing import Any

from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.executor import Executor, ThisProcess, Work
from kitrobot.experiments.plan import Plan
from kitrobot.experiments.point_runner import Stop
from kitrobot.experiments.row_columns import keep_columns
from kitrobot.experiments.study_folder import (
    ROWS,
    RowWriter,
    begin_study,
    expect_same_version,
    finished_rows,
    open_study,
    read_row,
    row_lines,
    study_rows,
)
from kitrobot.text.sentences import Sentence

Progress = Callable[[int, int], None]
"""Told how many rows are there, and how many there will be."""

MOST_SHARDS = 100_000
_SYNC_S = 0.5
"""How long rows wait at most for the disk while others come, in seconds."""
_MOST_UNSYNCED = 5000
_SHARD = re.compile(r"(\d{1,6})/(\d{1,6})")


@dataclass(frozen=True)
class Shard:
    """The rows of every `count`-th number, from `number` (1 to `count`) on."""

    number: int = 1
    count: int = 1

    @property
    def file(self) -> str:
        """The file of its rows."""
        return ROWS if self.count == 1 else f"rows-{self.number}-of-{self.count}.jsonl"


def read_shard(text: str) -> Shard:
    """`3/64` as a shard.

    Raises:
        ExperimentError: it is none.
    """
    found = _SHARD.fullmatch(text.strip())
    number, count = (int(found[1]), int(found[2])) if found else (0, 0)
    if not 1 <= number <= count <= MOST_SHARDS:
        raise ExperimentError(Sentence("expected a shard such as 3/64, found `{found}`", text))
    return Shard(number, count)


@dataclass(frozen=True)
class StudyStatus:
    """How far a study is: rows that are there, rows there will be, and how many have each outcome."""

    done: int
    total: int
    outcomes: dict[str, int]


def run_study(
    folder: Path,
    executor: Executor | None = None,
    shard: Shard | None = None,
    progress: Progress | None = None,
    stop: Stop = lambda: False,
    functions: Any = None,
) -> bool:
    """Makes the rows of a study that are not there yet; gives whether all of the shard are.

    Ctrl-C (KeyboardInterrupt) goes on to whoever called; every row that has ended is kept.

    Raises:
        ExperimentError: it is no study or one of another version, somebody is at it, or the disk refuses.
    """
    plan = open_study(folder)
    expect_same_version(plan)
    given = functions or {}
    missing = [name for name in plan.functions if name not in given]
    if missing:
        raise ExperimentError(
            Sentence("the measure `{name}` is a Python function", missing[0]),
            Sentence("go on with this study in Python, by `kitrobot.sweep`"),
        )
    shard = shard if shard is not None else Shard()
    with RowWriter(folder, shard.file) as writer:
        done = finished_rows(folder, plan)
        rows = range(shard.number - 1, plan.rows, shard.count)
        there = sum(done[shard.number - 1 :: shard.count])
        total, left = len(rows), len(rows) - there
        if progress is not None:
            progress(there, total)
        wanted = compress(rows, (not one for one in done[shard.number - 1 :: shard.count]))
        work = Work(plan, wanted, left, {name: given[name] for name in plan.functions})
        for lines in _in_pieces((executor or ThisProcess()).run(work, stop) if left else iter(())):
            writer.write(lines)
            there += len(lines)
            if progress is not None:
                progress(there, total)
        if left:
            keep_columns(folder, plan, shard.file)
    return there == total


def _in_pieces(lines: Iterator[bytes]) -> Iterator[list[bytes]]:
    """Rows in pieces that are worth a wait for the disk; those before a failure too, and then the failure."""
    waiting: list[bytes] = []
    since = time.monotonic()
    try:
        for line in lines:
            waiting.append(line)
            if len(waiting) >= _MOST_UNSYNCED or time.monotonic() - since > _SYNC_S:
                piece, waiting = waiting, []
                yield piece
                since = time.monotonic()
    except GeneratorExit:
        raise
    except BaseException:
        if waiting:
            yield waiting
        raise
    if waiting:
        yield waiting


def study_status(folder: Path) -> StudyStatus:
    """How far a study is.

    Raises:
        ExperimentError: it is none.
    """
    plan = open_study(folder)
    outcomes: dict[str, int] = {}
    for row in study_rows(folder, plan):
        outcomes[row["outcome"]] = outcomes.get(row["outcome"], 0) + 1
    return StudyStatus(sum(outcomes.values()), plan.rows, outcomes)


def merge_studies(folders: Sequence[Path], into: Path) -> int:
    """Puts the rows of folders of one study together; gives how many there are then.

    Raises:
        ExperimentError: they are not of one study, or somebody is at the folder.
    """
    plans = [open_study(folder) for folder in folders]
    for folder, plan in zip(folders, plans, strict=True):
        if plan != plans[0]:
            raise ExperimentError(
                Sentence("`{folder}` and `{other}` are not of one study", folders[0].name, folder.name),
                Sentence("merge only folders with the same plan.toml"),
            )
    begin_study(into, plans[0])
    with RowWriter(into) as writer:
        done = finished_rows(into, plans[0])
        for folder in folders:
            if folder.resolve() != into.resolve():
                for piece in _new_rows(folder, plans[0], done):
                    writer.write(piece)
    return sum(done)


def _new_rows(folder: Path, plan: Plan, done: bytearray) -> Iterator[list[bytes]]:

    finished_rows(folder, plan)
    piece: list[bytes] = []
    for line in row_lines(folder):
        number = read_row(line, plan, folder)["row"]
        if not done[number]:
            done[number] = 1
            piece.append(line)
            if len(piece) >= _MOST_UNSYNCED:
                yield piece
                piece = []
    if piece:
        yield piece
