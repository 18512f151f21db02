"""The missions of one folder, and the examples beside them: listed, read, saved; nothing outside can be reached.

The tutorials and exercises of the folder and among the examples are named in the same way.

A mission is named by its path relative to the folder, with `/` between the parts; an example by `example:` and its
path among the examples, and it is read-only. A name is followed through links before it is used, and refused when it
leads out of its folder. A *revision* names a file's content, so that a save which would overwrite what somebody else
wrote meanwhile is noticed. Left to others: what a mission says.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import sys
import threading
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import read_bytes, saving_in, sweep
from kitrobot.files.embedded_mission import may_carry_mission
from kitrobot.files.examples import examples_folder
from kitrobot.files.listing import MissionEntry, entry_of, folders_below, found_below, listed_files
from kitrobot.text.sentences import Sentence
from kitrobot.trace.layout import ENDING as TRACE_ENDING

ENDING = ".krt"
EXERCISE_ENDING = ".exercise.xml"
TUTORIAL_ENDING = ".tutorial.xml"
EXAMPLE = "example:"
HANDED_OUT = "Handed out"
"""The folder of what a class hands out, in its own folder and in that of a pupil's studio."""
RECORDING = "recording:"
"""How the name of a mission that a recording brought along begins; the recording's name follows."""
_LONGEST_BYTES = 255
"""Of one name in UTF-8."""

RENAME = Sentence("give the file another name")

_DEVICES = re.compile(r"(con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])\s*(\..*)?", re.IGNORECASE)
"""What Windows keeps for its devices, whatever ending follows."""
_ON_WINDOWS = re.compile(r"[\\:*?\"<>|\x00-\x1f\x7f]")


class MissionNameError(KitRobotError):
    """A name that leads to no mission of the folder."""


class ReadOnlyError(KitRobotError):
    """An example cannot be written to."""


@dataclass(eq=False)
class ConflictError(KitRobotError):
    """The file is not what it was; `revision` is what it is now ("" when it is gone)."""

    revision: str = ""


class MissionFolder:
    """The missions of `root`. Safe to use from many threads: one save at a time."""

    def __init__(self, root: Path, examples: Path | None = None) -> None:
        self.root = root.resolve()
        self.examples = (examples or examples_folder() or Path(os.devnull)).resolve()
        self.recordings = Path(os.devnull).resolve()
        """Where missions of opened recordings are unpacked, in a folder each."""
        self.in_class = False
        """Whether missions in the folder HANDED_OUT are read-only, as those of a pupil are."""
        self._saving = threading.Lock()

    def missions(self) -> list[MissionEntry]:
        """The missions of the folder by path, then the examples; of very many, the first ones and how many more."""
        # Examples that lie below the folder, as in a checkout, are listed once: as examples.
        own = listed_files(self.root, self.examples, ENDING)
        return own + [entry_of(path, self.examples, EXAMPLE) for path in found_below(self.examples, None, ENDING)]

    def name_of(self, path: Path) -> str:
        """The name of a file in the folder or among the examples.

        Raises:
            MissionNameError: it is in neither.
        """
        real = path.resolve()
        ways = [(self.root, ""), (self.examples, EXAMPLE)]
        if self.root in self.examples.parents:
            ways.reverse()  # as they are listed
        for root, prefix in ways:
            if root in real.parents:
                return prefix + real.relative_to(root).as_posix()
        raise MissionNameError(
            Sentence("`{path}` is not in the folder `{root}`", path, self.root.name), Sentence("open its own folder")
        )

    def tutorials(self) -> list[str]:
        """The names of the tutorials: those among the examples by path, then those of the folder."""
        return self._shipped_and_own(TUTORIAL_ENDING)

    def exercises(self) -> list[str]:
        """The names of the exercises: those among the examples by path, then those of the folder."""
        return self._shipped_and_own(EXERCISE_ENDING)

    def _shipped_and_own(self, ending: str) -> list[str]:
        shipped = found_below(self.examples, None, ending)
        own = found_below(self.root, self.examples, ending)
        return [
            *(EXAMPLE + path.relative_to(self.examples).as_posix() for path in shipped),
            *(path.relative_to(self.root).as_posix() for path in own),
        ]

    def path_of(self, name: str, ending: str = ENDING) -> Path:
        """The file that a name leads to; it need not exist.

        Raises:
            MissionNameError: the name is no name of a mission, or leads out of the folder.
        """
        root, inner = self.root, name
        if name.startswith(EXAMPLE):
            root, inner = self.examples, name.removeprefix(EXAMPLE)
        elif name.startswith(RECORDING):
            root, inner = self.recordings, name.removeprefix(RECORDING)
        pure = PurePosixPath(inner)
        wrong = not inner or pure.is_absolute() or ".." in pure.parts or _ON_WINDOWS.search(inner) or _too_long(pure)
        stem = pure.name[: -len(ending)] if pure.name.lower().endswith(ending) else ""
        if wrong or not stem.strip("."):
            known = {
                ENDING: Sentence("a mission"),
                TUTORIAL_ENDING: Sentence("a tutorial"),
                EXERCISE_ENDING: Sentence("an exercise"),
                TRACE_ENDING: Sentence("a recording"),
            }
            what = known.get(ending, Sentence("a picture"))
            raise MissionNameError(
                Sentence("`{name}` is no name of {what}", name[:80], what),
                Sentence("give a name in this folder that ends with `{ending}`", ending),
            )
        path = root / pure
        # One that is there already can be opened where it can be; a new one would be lost on the way to Windows.
        if any(_DEVICES.fullmatch(part) or part != part.rstrip(". ") for part in pure.parts) and (
            sys.platform == "win32" or not path.exists()
        ):
            raise MissionNameError(
                Sentence("Windows cannot have a file or folder called `{name}`", name[:80]),
                Sentence("choose another name, so that the mission can be opened on any computer"),
            )
        try:
            real = path.resolve()
        except (OSError, RuntimeError):
            raise MissionNameError(Sentence("`{name}` leads nowhere", name[:80]), "") from None
        if root not in real.parents:
            raise MissionNameError(
                Sentence("`{name}` leads out of the folder", name[:80]), Sentence("open the mission's own folder")
            )
        return path

    def folder_of(self, name: str) -> Path:
        """The folder that a mission's own robots, constructors and worlds are in; `root` for a mission without a
        name.
        """
        return self.path_of(name).parent if name else self.root

    def own_folder_of(self, name: str) -> Path:
        """The folder that files for a mission may be put into: its own; `root` for what is read-only."""
        return self.root if name.startswith((EXAMPLE, RECORDING)) else self.folder_of(name)

    def folders_of(self, name: str) -> tuple[Path, ...]:
        """Where robots, constructors and worlds of a mission are looked for; a later folder wins.

        A recording's own come last: they are what was recorded.
        """
        folder, own = self.folder_of(name), self.own_folder_of(name)
        if name.startswith(RECORDING):
            return own, folder
        return (folder,) if folder == own else (folder, own)

    def root_of(self, name: str) -> Path:
        """The folder that a mission's files must not lead out of: ours, or that of the examples."""
        return self.examples if name.startswith(EXAMPLE) else self.root

    def read(self, name: str) -> tuple[bytes, str]:
        """The content of a mission's file, or of a picture, and its revision.

        Raises:
            MissionNameError: the name leads to no mission.
            FileError: the file cannot be read.
        """
        ending = PurePosixPath(name).suffix.lower() if may_carry_mission(name) else ENDING
        data = read_bytes(self.path_of(name, ending))
        return data, revision_of(data)

    def traces(self) -> list[MissionEntry]:
        """The recordings of the folder by path; of very many, the first ones and how many more."""
        return listed_files(self.root, self.examples, TRACE_ENDING)

    def sweep(self) -> int:
        """Removes what killed saves left below the folder, and gives how many files that were."""
        return sum(sweep(folder) for folder in folders_below(self.root, self.examples))

    def hold(self, name: str, revision: str) -> _Hold:
        """For saving: a context in which nobody else saves, entered only when the file still has that revision.

        Raises:
            MissionNameError: the name is no name of a mission.
            ReadOnlyError: it is an example.
            ConflictError: the file is not what it was.
        """
        if name.startswith(EXAMPLE):
            raise ReadOnlyError(
                Sentence("an example cannot be changed"), Sentence("save the mission under a name of your own")
            )
        if name.startswith(RECORDING):
            raise ReadOnlyError(
                Sentence("a recording cannot be changed"), Sentence("save the mission under a name of your own")
            )
        path = self.path_of(name)
        if self.in_class and (self.root / HANDED_OUT).resolve() in path.resolve().parents:
            raise ReadOnlyError(
                Sentence("what was handed out cannot be changed"), Sentence("save the mission under a name of your own")
            )
        return _Hold(self, path, Sentence("a mission `{name}`", name), name, revision)

    def hold_beside(self, name: str, file: str, revision: str) -> _Hold:
        """The same for a file with parts for a mission, such as a robot's, in its `own_folder_of`.

        Raises:
            MissionNameError: the mission's name leads to no mission, or the file's out of its folder.
            ConflictError: the file is not what it was.
        """
        folder = self.own_folder_of(name)
        path = folder / file
        if PurePosixPath(file).name != file or _ON_WINDOWS.search(file) or folder != path.resolve().parent:
            raise MissionNameError(
                Sentence("`{file}` is no name of a file in this folder", file[:80]),
                Sentence("give the file another name"),
            )
        return _Hold(self, path, Sentence("a file `{file}`", file), file, revision)


class _Hold:
    """The lock of a folder around one save. Where the system has none only this process is kept out."""

    def __init__(self, folder: MissionFolder, path: Path, what: str, name: str, revision: str) -> None:
        self._folder = folder
        self._path = path
        self._what = what
        self._name = name
        self._revision = revision
        self._within = contextlib.ExitStack()
        self.alone = False
        """Whether nobody else at all can save meanwhile."""

    def __enter__(self) -> Path:
        with contextlib.ExitStack() as entered:
            entered.enter_context(self._folder._saving)
            self.alone = entered.enter_context(saving_in(self._path))
            now = revision_of(read_bytes(self._path)) if self._path.exists() else ""
            if now != self._revision:
                raise _conflict(self._what, self._name, self._revision, now)
            self._within = entered.pop_all()
        return self._path

    def __exit__(self, *reason: object) -> None:
        self._within.close()


def _too_long(pure: PurePosixPath) -> bool:
    """Whether no system has such a name."""
    return len(str(pure)) > 1000 or any(len(part.encode(errors="replace")) > _LONGEST_BYTES for part in pure.parts)


def revision_of(data: bytes) -> str:
    """The name of a content: the same for the same bytes."""
    return hashlib.sha256(data).hexdigest()[:20]


def _conflict(what: str, name: str, before: str, now: str) -> ConflictError:
    if not before:
        sentence, help = (
            Sentence("there is {what} already", what),
            Sentence("choose another name, or save again to replace it"),
        )
    elif not now:
        sentence, help = (
            Sentence("the file of `{name}` was removed meanwhile", name),
            Sentence("save again to write it anew"),
        )
    else:
        sentence, help = (
            Sentence("the file of `{name}` was changed by somebody else meanwhile", name),
            Sentence("open it again, or save again to replace it"),
        )
    return ConflictError(sentence, help, revision=now)
