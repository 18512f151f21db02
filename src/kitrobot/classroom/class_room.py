"""A running class: its folder, its pupils, what their pages report and the status that is sent to them.

Its folder holds `class.toml` (record), `log.txt`, a folder for each pupil with what was handed in, and `Handed out`.
A value that is returned to a caller is on the disk by then. Safe to use from many threads. Left to others: letting
pupils in (admission), the actions of the teacher (teacher_actions), HTTP, pictures, evaluation of exercises.
"""

from __future__ import annotations

import hashlib
import hmac
import secrets
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Final

from kitrobot.classroom.gradebook_list import NAME as GRADEBOOK
from kitrobot.classroom.log import NAME as LOG
from kitrobot.classroom.log import Log
from kitrobot.classroom.marks import comments_of
from kitrobot.classroom.names import as_file_name, free_name, key_of, new_code, same_name
from kitrobot.classroom.pupil import Pupil, Report
from kitrobot.classroom.pupil_status import HandIn, PupilStatus
from kitrobot.classroom.rate_limits import RateLimits
from kitrobot.classroom.record import NAME as RECORD
from kitrobot.classroom.record import ClassRecord, PupilRecord, read_record, unread_sentence, write_record
from kitrobot.classroom.submissions import Submission, list_submissions, read_submission, store_submission
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import FileError, read_bytes
from kitrobot.files.file_lock import FileLock
from kitrobot.files.folder import HANDED_OUT, revision_of
from kitrobot.text.sentences import Sentence

MOST_NEWCOMERS: Final = 50
"""New pupils from one address at once; after them one a minute. A class may sit behind one address."""
LOCK: Final = ".class.lock"
SITE: Final = "Site"
"""The folder with a static site, from which pupils' pages get their own Python."""
GRADES_PAGE: Final = "grades.html"
GRADES_TABLE: Final = "grades.csv"
STUDIOS: Final = ".studios"
"""The folder with pupils' studios, where there is no site."""
_RESERVED: Final = (
    HANDED_OUT,
    SITE,
    "grades",
    "class",
    "log",
    RECORD,
    LOG,
    GRADES_PAGE,
    GRADES_TABLE,
    "gradebook",
    GRADEBOOK,
)
"""Names in the folder that are no pupil's: what the class itself writes there."""
_FILES: Final = (".xml", ".krt", ".kri", ".kra", ".lll", ".krtrace", ".html", ".csv", ".toml", ".txt")
"""Endings of files that the class and the teacher's studio read and write there: no pupil's folder has one."""


class ClassError(KitRobotError):
    """Something that this class cannot do."""


class ClassRoom:
    """One class. `clock` gives seconds, as `time.monotonic` does."""

    def __init__(self, folder: Path, clock: Callable[[], float] = time.monotonic) -> None:
        """Opens the class of a folder, or begins one.

        Raises:
            FileError: the folder cannot be used.
            ClassError: it is open in another process.
        """
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self._alone = FileLock.take(folder / LOCK)
        except OSError as error:
            raise FileError(
                Sentence("`{path}` cannot be the folder of a class: {reason}", folder, error.strerror or str(error)),
                Sentence("name a folder that you may write to"),
                path=folder,
            ) from None
        if self._alone is None:
            raise ClassError(
                Sentence("the class of this folder runs already"), Sentence("end it in its terminal first")
            )
        self.folder = folder.resolve()
        self.clock = clock
        self.log = Log(self.folder)
        try:
            self.record = read_record(self.folder) or ClassRecord(self.folder.name, new_code())
        except BaseException:
            self.close()
            raise
        self.pupils = {one.folder: self._pupil(one) for one in self.record.pupils}
        self.looked = ""
        """The folder of the pupil whom the teacher is viewing."""
        self.lock = threading.RLock()
        self._keeping = {one: threading.Lock() for one in self.pupils}
        self._subscribers: list[Callable[[], None]] = []
        self.last_kept: float | None = None
        for one in self.record.unread:
            self.log.write(str(unread_sentence(one)))
        self.newcomers = RateLimits(1 / 60, MOST_NEWCOMERS)
        """New pupils from each address."""
        write_record(self.folder, self.record)

    def close(self) -> None:
        """Another process may open the class."""
        if self._alone is not None:
            self._alone.release()
            self._alone = None

    def _pupil(self, record: PupilRecord) -> Pupil:
        pupil = Pupil(record, record.folder, asked=self.clock() if record.hand else None)
        newest = next(iter(list_submissions(self.folder / record.folder)), None)
        if newest is not None:
            pupil.work = newest.name
            with suppress(FileError):
                pupil.revision = revision_of(read_bytes(self.folder / record.folder / newest.name))
        return pupil

    # -- subscribers

    def subscribe(self, changed: Callable[[], None]) -> Callable[[], None]:
        """Calls back, from any thread, when the status of a pupil changes; returns a function that ends that."""
        with self.lock:
            self._subscribers.append(changed)

        def end() -> None:
            with self.lock, suppress(ValueError):
                self._subscribers.remove(changed)

        return end

    def notify(self, kept: bool = False) -> None:
        """Notifies the subscribers that the status of a pupil changed; `kept`: and writes the record."""
        if kept:
            write_record(self.folder, self.record)
        for changed in list(self._subscribers):
            changed()

    def find_pupil(self, name: str) -> Pupil | None:
        """The pupil of that name, or of one that looks the same."""
        alike = [one for one in self.pupils.values() if same_name(one.record.name, name)]
        # A class of before may have two whose names look the same: each comes back as typed.
        return next((one for one in alike if key_of(one.record.name) == key_of(name)), alike[0] if alike else None)

    def add_pupil(self, name: str, key: str) -> Pupil:
        """A new pupil with a folder; `key` is what a browser keeps, "" for none. For who holds the lock.

        Raises:
            ClassError: the class is full.
        """
        self.expect_place()
        wanted = as_file_name(name)
        files = [wanted] if wanted.lower().endswith(_FILES) else []
        folder = free_name(wanted, [*_RESERVED, *files, *(entry.name for entry in self.folder.iterdir())])
        record = PupilRecord(name, folder, new_code(), [digest(key)] if key else [])
        (self.folder / folder).mkdir()
        self.record.pupils.append(record)
        pupil = self.pupils[folder] = Pupil(record, folder)
        self._keeping[folder] = threading.Lock()
        self.notify(kept=True)
        self.log.write(f"{name} joined" if key else f"{name} was added")
        return pupil

    def expect_place(self) -> None:
        """That there is room for one more. For who holds the lock.

        Raises:
            ClassError: the class is full.
        """
        if len(self.pupils) >= self.record.places:
            raise ClassError(
                Sentence("this class has {most} pupils already", self.record.places),
                Sentence("the teacher can remove some, or make room for more, in the menu *Class*"),
            )

    def let_in(self, pupil: Pupil, how: str) -> str:
        """Another browser of a pupil; gives its key. For who holds the lock."""
        key = secrets.token_urlsafe(24)
        pupil.record.gets(digest(key))
        self.notify(kept=True)
        self.log.write(f"{pupil.record.name} {how}")
        return key

    def pupil_of(self, key: str) -> Pupil | None:
        """The pupil with that key; None when there is none."""
        if not key or len(key) > 200:
            return None
        wanted = digest(key)
        found = None
        with self.lock:
            for pupil in self.pupils.values():
                for one in pupil.record.keys:
                    if hmac.compare_digest(one, wanted):
                        found = pupil
        return found

    # -- pages of pupils

    def open_page(self, pupil: Pupil) -> None:
        """Records that a page of that pupil connected."""
        with self.lock:
            pupil.open_page(self.clock())
            if pupil.pages == 1:
                self.log.write(f"{pupil.record.name} is here")

    def close_page(self, pupil: Pupil) -> None:
        """Records that a page of that pupil disconnected."""
        with self.lock:
            pupil.close_page(self.clock())
            if pupil.pages == 0:
                self.log.write(f"{pupil.record.name} is away")

    def take_report(self, pupil: Pupil, report: Report) -> None:
        """Stores the report of a pupil's page."""
        with self.lock:
            pupil.take_report(report, self.clock())

    def set_hand(self, pupil: Pupil, up: bool) -> None:
        """Raises or lowers the pupil's hand."""
        with self.lock:
            if up != (pupil.asked is not None):
                pupil.asked = self.clock() if up else None
                pupil.record.hand = up
                with suppress(FileError):
                    write_record(self.folder, self.record)
                self.notify()

    def show_arena(self, pupil: Pupil, arena: str) -> None:
        """Stores the picture of a pupil's run; ignored unless the teacher is viewing that pupil."""
        with self.lock:
            if self.looked == pupil.folder:
                pupil.arena = arena

    def give_turn(self, pupil: Pupil, yes: bool) -> None:
        """The pupil grants, refuses or ends the teacher's turn to edit."""
        with self.lock:
            if pupil.turn == "pupil" or (yes and pupil.turn == "teacher"):
                return
            pupil.turn = "teacher" if yes else "pupil"
            self.log.write(f"{pupil.record.name} {'lets the teacher edit' if yes else 'edits alone'}")
            self.notify()

    def status_of(self, pupil: Pupil) -> PupilStatus:
        """The status that is sent to the pupil's page."""
        with self.lock:
            record = pupil.record
            return PupilStatus(
                self.record.name,
                record.name,
                record.word,
                self.record.frozen or record.frozen,
                self.record.exercise,
                record.handed,
                record.handed_file,
                record.note,
                record.note_text,
                self.looked == pupil.folder,
                pupil.asked is not None,
                pupil.turn,
                comments_of(record.marks),
            )

    def hand_in(self, pupil: Pupil, shown: str, data: bytes, base: str, exercise: str = "") -> HandIn:
        """Keeps a mission of that pupil, as the work for that exercise.

        Raises:
            QuotaError: the folder is full.
            FileError: it cannot be written.
        """
        with self._keeping[pupil.folder]:
            fresh = pupil.work
            kept = store_submission(self.folder / pupil.folder, shown, data, base)
        with self.lock:
            pupil.work, pupil.revision = kept.name, kept.revision
            pupil.kept = self.last_kept = self.clock()
            pupil.version += 1
            if pupil.record.hands_in(exercise, kept.name):
                with suppress(FileError):
                    write_record(self.folder, self.record)
        if fresh != kept.name:
            self.log.write(f"{pupil.record.name} handed in {kept.name}")
        return kept

    def list_submissions(self, pupil: Pupil) -> list[Submission]:
        """What the pupil handed in, the newest first."""
        exercises = {file: exercise for exercise, file in pupil.record.works.items()}
        found = list_submissions(self.folder / pupil.folder)
        return [replace(one, exercise=exercises.get(one.name, "")) for one in found]

    def work_for(self, pupil: Pupil, exercise: str) -> str:
        """The file that the pupil handed in for that exercise; where nothing says so the newest one that is for no
        exercise that is known, "" for none.
        """
        found = self.list_submissions(pupil)
        fitting = [one for one in found if one.exercise == exercise] or [one for one in found if not one.exercise]
        return fitting[0].name if fitting else ""

    def read_submission(self, pupil: Pupil, name: str) -> tuple[bytes, str]:
        """One of them, and its revision.

        Raises:
            FileError: there is none of that name.
        """
        return read_submission(self.folder / pupil.folder, name)

    def read_handed(self, pupil: Pupil) -> bytes:
        """The mission that was handed out to the pupil last.

        Raises:
            FileError: there is none.
        """
        return read_submission(self.folder / HANDED_OUT, f"{pupil.record.handed_file}.krt")[0]


def digest(key: str) -> str:
    """The digest of a key, which is stored in place of it."""
    return hashlib.sha256(key.encode(errors="replace")).hexdigest()
