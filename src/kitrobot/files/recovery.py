"""The journals of a folder of missions: which page writes which, and which are orphaned because their page ended.

A page that is open is a *tab*; it writes one journal at a time, its *claim*, so two pages never write into one. A claim
ends with its tab, or with this process: it is a lock that the system keeps on a file beside the journal, so a second
KitRobot on the same folder sees it too, and none is left after a kill. A journal that nobody claims is orphaned: the
next tab that opens its mission gets it. Journals are in `.kitrobot/journal` of the folder; those of examples, and all
if the folder cannot be written to or does not support locks, are in the user's state folder. A journal that is damaged
in the middle is moved aside.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import secrets
import threading
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from kitrobot.files.disk import FileError
from kitrobot.files.file_lock import FileLock
from kitrobot.files.folder import EXAMPLE, RECORDING, MissionFolder
from kitrobot.files.journal_file import Journal, JournalError, append_records, read_journal, write_journal
from kitrobot.files.listing import utc_moment
from kitrobot.text.sentences import Sentence
from kitrobot.user_folders import state_folder

ENDING = ".journal"
_NAME = re.compile(r"[0-9a-f]{16}")


@dataclass(frozen=True)
class OrphanedJournal:
    """Unsaved work that was left behind; `modified` is a moment in UTC (ISO 8601).

    `problem` is why this KitRobot cannot open it, "" where it can; nothing else is known of such work.
    """

    journal: str
    path: str
    name: str
    modified: str
    problem: Sentence | str = ""


@dataclass(frozen=True)
class ClaimedJournal:
    """The journal that a tab writes from now on, and what is in it: nothing when `records` is empty."""

    journal: str
    path: str
    name: str
    records: tuple[str, ...]
    damaged: bool


@dataclass(frozen=True)
class TabStatus:
    """What a tab wants to know: its mission, the revision on disk ("" when there is none), how many others have it."""

    path: str
    revision: str
    others: int


@dataclass
class _Tab:
    path: str = ""
    name: str = ""
    journal: str = ""
    lock: FileLock | None = None
    count: int = 0
    stamp: tuple[int, int] | None = None
    revision: str = ""


class Journals:
    """The journals of `folder`. Safe to use from many threads."""

    def __init__(self, folder: MissionFolder, state: Path | None = None) -> None:
        self.folder = folder
        place = hashlib.sha256(str(folder.root).encode(errors="surrogateescape")).hexdigest()[:16]
        self._state = (state or state_folder()) / "journal" / place
        self._own = folder.root / ".kitrobot" / "journal"
        self._tabs: dict[str, _Tab] = {}
        self._lock = threading.RLock()

    def join(self) -> str:
        """A page opened: the name of its tab."""
        tab = secrets.token_hex(8)
        with self._lock:
            self._tabs[tab] = _Tab()
        return tab

    def leave(self, tab: str) -> None:
        """A page is gone; what it wrote stays."""
        with self._lock:
            gone = self._tabs.pop(tab, None)
            if gone is not None:
                _release(gone)

    def orphaned(self) -> list[OrphanedJournal]:
        """Unsaved work that nobody has open, the newest first."""
        with self._lock:
            return [one for file in self._files() if (one := _orphan(file)) is not None]

    def claim(self, tab: str, path: str, journal: str = "") -> ClaimedJournal:
        """The journal for the mission that a tab has opened: the given one if it is free, else one that was left behind
        on that mission, else a new one. A mission without a file gets a new one unless it names one.

        Raises:
            JournalError: there is no such tab.
        """
        with self._lock:
            mine = self._tab(tab)
            if journal and journal == mine.journal:
                mine.path = path
                return ClaimedJournal(journal, path, "", (), False)
            _release(mine)
            mine.path, mine.stamp = path, None
            for file, found in self._free():
                if file.stem == journal or (not journal and path and found.path == path):
                    lock = _taken(file)
                    if lock is None:
                        continue
                    if found.cut:
                        self._mend(file, found)
                    mine.journal, mine.lock, mine.count = file.stem, lock, len(found.records)
                    mine.path, mine.name = found.path, found.name
                    return ClaimedJournal(file.stem, found.path, found.name, found.records, found.damaged)
            mine.journal, mine.count = secrets.token_hex(8), 0
            return ClaimedJournal(mine.journal, path, "", (), False)

    def replace(self, tab: str, journal: Journal) -> int:
        """Puts a whole journal in the place of the tab's; without records there is none any more. Gives its length.

        Raises:
            JournalError: the tab has no journal, or this one is too large.
            FileError: it cannot be written; what was there is still there.
        """
        with self._lock:
            mine = self._tab(tab)
            if not mine.journal:
                raise JournalError(Sentence("this page has no journal yet"), Sentence("load the page again"))
            mine.path, mine.name = journal.path, journal.name
            before = self._file(mine.journal)
            if not journal.records:
                _remove(before)
                _release(mine, forget=False)
                mine.count = 0
                return 0
            file = self._place(journal.path) / f"{mine.journal}{ENDING}"
            if mine.lock is None or mine.lock.path != _lock_of(file):
                lock = _taken(file)
                if lock is None:
                    raise JournalError(
                        Sentence("this journal is written by another page"), Sentence("load the page again")
                    )
                _release(mine, forget=False)
                mine.lock = lock
            length = write_journal(file, journal)
            mine.count = len(journal.records)
            if before is not None and before != file:
                _remove(before)
            return length

    def append(self, tab: str, first: int, records: Sequence[str], unsaved: bool) -> int:
        """Writes records behind those of the tab's journal; gives its length.

        Raises:
            JournalError: they do not follow what is there, a whole journal does; or they are too large.
            FileError: they cannot be written.
        """
        with self._lock:
            mine = self._tab(tab)
            file = self._file(mine.journal)
            if file is None or mine.lock is None or first != mine.count:
                raise JournalError(
                    Sentence("these records do not follow the journal"), Sentence("send the whole journal")
                )
            length = append_records(file, first, Journal(mine.path, mine.name, tuple(records), unsaved))
            mine.count += len(records)
            return length

    def discard(self, journal: str) -> None:
        """Throws away a journal that was left behind; one that somebody writes stays."""
        with self._lock:
            for file in list(self._files()):
                lock = _taken(file) if file.stem == journal else None
                if lock is not None:
                    _remove(file)
                    lock.release()

    def status_of(self, tab: str) -> TabStatus:
        """What is new for a tab. Reads the file only when the disk says that it changed."""
        with self._lock:
            mine = self._tabs.get(tab, _Tab())
            path = mine.path
            others = sum(other.path == path for name, other in self._tabs.items() if name != tab) if path else 0
            before, revision = mine.stamp, mine.revision
        stamp = self._stamp(path)
        if stamp != before:
            try:
                revision = self.folder.read(path)[1] if stamp is not None else ""
            except FileError:
                revision = ""
            with self._lock:
                if mine.path == path:
                    mine.stamp, mine.revision = stamp, revision
        return TabStatus(path, revision if stamp is not None else "", others)

    def _stamp(self, path: str) -> tuple[int, int] | None:
        if not path:
            return None
        try:
            state = self.folder.path_of(path).stat()
        except OSError:
            return None
        return state.st_mtime_ns, state.st_size

    def _tab(self, tab: str) -> _Tab:
        if tab not in self._tabs:
            raise JournalError(Sentence("the studio does not know this page any more"), Sentence("load the page again"))
        return self._tabs[tab]

    def _free(self) -> Iterator[tuple[Path, Journal]]:
        """The journals that can be read and that nobody writes, the newest first."""
        for file in self._files():
            with contextlib.suppress(FileError, JournalError):
                journal = read_journal(file)
                if journal is not None and journal.records:
                    yield file, journal

    def _files(self) -> Iterator[Path]:
        """Those that nobody writes, the newest first."""
        files = [file for place in (self._own, self._state) for file in _files_in(place)]
        for file in sorted(files, key=_age):
            if not FileLock.is_taken(_lock_of(file)):
                yield file

    def _file(self, journal: str) -> Path | None:
        if not _NAME.fullmatch(journal):
            return None
        places = (self._own / f"{journal}{ENDING}", self._state / f"{journal}{ENDING}")
        return next((file for file in places if file.is_file()), None)

    def _place(self, path: str) -> Path:
        """The folder for the journal of a mission; it is made."""
        if not path.startswith((EXAMPLE, RECORDING)):
            with contextlib.suppress(OSError):
                self._own.mkdir(parents=True, exist_ok=True)
                ignore = self._own.parent / ".gitignore"
                if not ignore.exists():
                    ignore.write_text("*\n")
                if FileLock.is_possible(self._own):
                    return self._own
        self._state.mkdir(parents=True, exist_ok=True)
        return self._state

    def _mend(self, file: Path, found: Journal) -> None:
        """Leaves what of a journal is whole; one that was not merely cut is kept under another name."""
        if found.damaged:
            with contextlib.suppress(OSError):
                os.replace(file, file.with_suffix(".damaged"))
        write_journal(file, found)


def _orphan(file: Path) -> OrphanedJournal | None:
    """What is unsaved in a journal; None when nothing is, or nobody can tell."""
    try:
        journal = read_journal(file)
    except JournalError as error:
        return OrphanedJournal(file.stem, "", "", _moment(file), error.message)
    except FileError:
        return None
    if journal is None or not journal.records or not journal.unsaved:
        return None
    return OrphanedJournal(file.stem, journal.path, journal.name, _moment(file))


def _release(tab: _Tab, forget: bool = True) -> None:
    if tab.lock is not None:
        tab.lock.release()
    tab.lock = None
    if forget:
        tab.journal, tab.count = "", 0


def _remove(file: Path | None) -> None:
    if file is not None:
        with contextlib.suppress(OSError):
            file.unlink()


def _taken(file: Path) -> FileLock | None:
    """The lock of a journal; None when somebody has it, or nobody can."""
    try:
        return FileLock.take(_lock_of(file))
    except OSError:
        return None


def _lock_of(file: Path) -> Path:
    return file.with_suffix(".lock")


def _files_in(place: Path) -> list[Path]:
    try:
        return [file for file in place.iterdir() if file.suffix == ENDING and _NAME.fullmatch(file.stem)]
    except OSError:
        return []


def _age(file: Path) -> float:
    try:
        return -file.stat().st_mtime
    except OSError:
        return 0.0


def _moment(file: Path) -> str:
    return utc_moment(-_age(file))
