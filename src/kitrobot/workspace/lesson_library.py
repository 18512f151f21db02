"""Tutorials and exercises: files that begin with a mission beside them; those shipped with KitRobot, and those of the
mission folder.

A lesson is identified by its file's name in the folder, like a mission. A lesson with mistakes is listed too, with its
diagnostics, so that its author sees them. Files are read again only when they changed.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import Generic, Protocol, TypeVar

from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Place, Rule
from kitrobot.files.disk import UNREADABLE, FileError, read_bytes
from kitrobot.files.folder import EXAMPLE, RENAME, MissionFolder
from kitrobot.files.listing import NAME_NO_TEXT, name_as_text
from kitrobot.text.sentences import Sentence
from kitrobot.xml.lessons import LAST

MOST_CACHED = 200
"""Parsed lessons of one kind that are cached."""


class LessonUnavailableError(KitRobotError):
    """A lesson that was there is there no more, or has a mistake now."""


class Lesson(Protocol):
    """What begins with a mission; `start` is its file in the same folder."""

    @property
    def start(self) -> str:
        """The `.krt` beside it."""

    @property
    def order(self) -> int:
        """Its place on the path to learn, 0 to `LAST`."""


L = TypeVar("L", bound=Lesson)


@dataclass(frozen=True)
class FoundLesson(Generic[L]):
    """A lesson of that name; None in place of it when it has a mistake. `start` is the name of its mission."""

    name: str
    lesson: L | None
    start: str
    problems: tuple[Diagnostic, ...]


_Stamp = tuple[int, int]


@dataclass(frozen=True)
class LessonKind(Generic[L]):
    """One kind: the ending of its files, how they are read, the rule and sentence for one without its mission, and the
    sentence for one that can be used no more.
    """

    ending: str
    read: Callable[[bytes, str], tuple[L | None, list[Diagnostic]]]
    names: Callable[[MissionFolder], list[str]]
    no_start: Rule
    no_start_words: Callable[[str], Sentence]
    gone: Sentence


class LessonLibrary(Generic[L]):
    """The lessons of one kind in a folder. Safe to use from many threads: what two read at once is the same."""

    def __init__(self, folder: MissionFolder, kind: LessonKind[L]) -> None:
        self._folder = folder
        self._kind = kind
        self._cache: dict[str, tuple[_Stamp, FoundLesson[L]]] = {}

    def all(self) -> list[FoundLesson[L]]:
        """Every one: those that come with KitRobot, then those of the folder; both in their order, then by path."""
        return sorted((self._listed(name) for name in self._kind.names(self._folder)), key=_place)

    def _listed(self, name: str) -> FoundLesson[L]:
        """One of the list: what cannot be used says why, and the others are there all the same."""
        try:
            name.encode()
            return self.found(name)
        except UnicodeEncodeError:
            name = name_as_text(name)
            return _broken(name, [UNREADABLE(NAME_NO_TEXT, Place(name), help=RENAME)])
        except KitRobotError as error:
            return _broken(name, [UNREADABLE(error.message, Place(name), help=error.help)])

    def starts(self) -> set[str]:
        """The names of the missions that one begins with."""
        return {found.start for found in self.all() if found.start}

    def found(self, name: str) -> FoundLesson[L]:
        """The one of that name, with what is wrong with it.

        Raises:
            MissionNameError: the name is no name of such a file, or leads out of the folder.
        """
        path = self._folder.path_of(name, self._kind.ending)
        try:
            state = os.stat(path)
            stamp = (state.st_mtime_ns, state.st_size)
            cached = self._cache.get(name)
            if cached is not None and cached[0] == stamp:
                return self._with_start(cached[1])
            lesson, problems = self._kind.read(read_bytes(path), name)
        except (FileError, OSError) as error:
            why = error.message if isinstance(error, FileError) else Sentence("the file `{name}` cannot be read", name)
            return _broken(name, [UNREADABLE(why, Place(name))])
        start = str(PurePosixPath(name).parent / lesson.start) if lesson is not None else ""
        found = FoundLesson(name, lesson, start, tuple(problems))
        if len(self._cache) >= MOST_CACHED:
            self._cache.clear()
        self._cache[name] = (stamp, found)
        return self._with_start(found)

    def usable(self, name: str) -> tuple[L, str]:
        """The one of that name, to be used, and the name of its mission.

        Raises:
            MissionNameError: as `found`.
            LessonUnavailableError: it is there no more, or has a mistake.
        """
        found = self.found(name)
        if found.lesson is None:
            raise LessonUnavailableError(self._kind.gone, Sentence("look at its file, or leave it"), found.problems)
        return found.lesson, found.start

    def _with_start(self, found: FoundLesson[L]) -> FoundLesson[L]:
        """The same; without its mission it cannot begin, and says so."""
        if found.lesson is None:
            return found
        try:
            there = self._folder.path_of(found.start).is_file()
        except KitRobotError:
            there = False
        if there:
            return found
        words = self._kind.no_start_words(found.lesson.start)
        help = Sentence("put the mission that it begins with there")
        problem = self._kind.no_start(words, Place(found.name), help=help)
        return _broken(found.name, [*found.problems, problem])


def _place(found: FoundLesson[L]) -> tuple[bool, int, str]:
    return not found.name.startswith(EXAMPLE), found.lesson.order if found.lesson is not None else LAST, found.name


def _broken(name: str, problems: Sequence[Diagnostic]) -> FoundLesson[L]:
    return FoundLesson(name, None, "", tuple(problems))
