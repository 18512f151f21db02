"""Files below a folder as they are listed: the first ones by path, and what is not listed is said.

A folder may be somebody's whole home: a listing looks at so many entries, goes so deep, and shows so many files.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from kitrobot.diagnostics.regular import open_regular
from kitrobot.text.sentences import Sentence, Word

DEEPEST = 5
MOST_LISTED = 500
MOST_LOOKED_AT = 20_000
"""Entries of folders that a listing looks at."""
NAME_NO_TEXT = Sentence("its name is not text in UTF-8")


@dataclass(frozen=True)
class MissionEntry:
    """A mission of the folder, or an example; `modified` is a moment in UTC (ISO 8601), `problem` why it cannot be
    opened, "" where nothing is known against it.
    """

    path: str
    name: str
    title: str
    example: bool
    modified: str
    problem: str = ""


def listed_files(root: Path, without: Path | None, ending: str) -> list[MissionEntry]:
    """The first files below a folder by path; behind them an entry without a path says what is not listed."""
    left_out: list[Path] = []
    paths = _by_path(_walk(root, without, ending, left_out), root)
    entries = [entry_of(path, root, "") for path in paths[:MOST_LISTED]]
    more = len(paths) - len(entries)
    if more > 0:
        problem = Sentence.counted(
            "{count} more file is not listed: open the folder that it is in",
            "{count} more files are not listed: open the folder that they are in, or put fewer into one",
            more,
        )
    elif left_out:
        problem = Sentence(
            "here is very much, so folders from `{folder}` on were not looked through: open the one that you want",
            name_as_text(left_out[0].relative_to(root).as_posix()),
        )
    else:
        return entries
    return [*entries, MissionEntry("", "…", "", False, utc_moment(0), problem)]


def found_below(root: Path, without: Path | None, ending: str) -> list[Path]:
    """The first files below a folder by path."""
    return _by_path(_walk(root, without, ending), root)[:MOST_LISTED]


def _by_path(found: Iterable[Path], root: Path) -> list[Path]:
    return sorted(found, key=lambda path: path.relative_to(root).as_posix().casefold())


def _walk(root: Path, without: Path | None, ending: str, left_out: list[Path] | None = None) -> Iterator[Path]:
    for folder, files in _bounded_walk(root, without, left_out):
        yield from (folder / name for name in files if name.lower().endswith(ending) and not name.startswith("."))


def folders_below(root: Path, without: Path | None) -> list[Path]:
    """The folders that are looked through, and that of the journals."""
    return [folder for folder, _ in _bounded_walk(root, without)] + [root / ".kitrobot" / "journal"]


def _bounded_walk(
    root: Path, without: Path | None, left_out: list[Path] | None = None
) -> Iterator[tuple[Path, list[str]]]:
    """Each folder that missions are looked for in, and its files; `left_out` gets those of too many."""
    looked_at = 0
    for folder, folders, files in os.walk(root):
        looked_at += len(folders) + len(files)
        depth = len(Path(folder).relative_to(root).parts)
        inner = [name for name in folders if not name.startswith(".") and name != "node_modules"]
        folders[:] = sorted(name for name in inner if Path(folder, name) != without and depth < DEEPEST)
        if looked_at > MOST_LOOKED_AT:
            if left_out is not None:
                left_out += [Path(folder, name) for name in folders]
            folders[:] = []
        yield Path(folder), files


def name_as_text(name: str) -> str:
    """A file's name as text; what in it is no UTF-8 is replaced."""
    return os.fsencode(name).decode(errors="replace")


def _problem(path: Path, root: Path) -> str:
    """Why a file of the folder cannot be opened; "" where nothing is known against it."""
    try:
        path.name.encode()
        path.relative_to(root).as_posix().encode()
        if root not in path.resolve().parents:
            return Sentence("it is a link that leads out of the folder")
        open_regular(path).close()
    except UnicodeEncodeError:
        return NAME_NO_TEXT
    except (OSError, RuntimeError) as error:
        reason = getattr(error, "strerror", None)
        return Word(reason.lower()) if reason else Sentence("it leads nowhere")
    return ""


def utc_moment(seconds: float) -> str:
    """A file's time as a moment in UTC (ISO 8601); the nearest one that a calendar has, of the years 1 to 9999."""
    try:
        return datetime.fromtimestamp(seconds, UTC).isoformat(timespec="seconds")
    except (OverflowError, ValueError, OSError):
        return (datetime.max if seconds > 0 else datetime.min).replace(tzinfo=UTC).isoformat(timespec="seconds")


def entry_of(path: Path, root: Path, prefix: str) -> MissionEntry:
    """A file of a folder as it is listed; `prefix` stands before its path."""
    stem = name_as_text(path.stem)
    words = stem.replace("-", " ").replace("_", " ").strip()
    try:
        seconds = path.stat().st_mtime
    except OSError:
        seconds = 0.0
    modified = utc_moment(seconds)
    name = prefix + name_as_text(path.relative_to(root).as_posix())
    title = words[:1].upper() + words[1:]
    return MissionEntry(name, stem, title, bool(prefix), modified, _problem(path, root))
