"""Files that a user puts beside a mission: a robot, a kit, constructors, a world.

An imported file must be readable as XML of its kind; mistakes inside it are reported when it is read there, with file
and line, and can be corrected there. A file that cannot be read at all, or is of another kind, is refused and nothing
changes.
"""

from __future__ import annotations

import unicodedata
from contextlib import suppress
from dataclasses import dataclass
from pathlib import PurePosixPath

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import read_bytes, replace_file
from kitrobot.files.folder import ConflictError, MissionFolder, MissionNameError, revision_of
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.kit_xml import KIT_SUFFIX, read_kit
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.text.sentences import Help, Sentence
from kitrobot.versions.kits import kit_differences
from kitrobot.workspace.file_check import first_element
from kitrobot.world.xml_reader import read_world

LARGEST_PARTS_BYTES = 4 * 1024 * 1024
"""Far more than any robot; a film given by mistake is refused."""

_ENDINGS = {"robot": ".robot.xml", "board": KIT_SUFFIX, "constructors": ".xml", "world": ".world.xml"}
_UNREADABLE = ("xml-not-well-formed", "xml-encoding", "xml-forbidden", "xml-too-deep", "xml-too-large")
_OTHER_KINDS: dict[str, tuple[Sentence, Help]] = {
    "kitrobot": (Sentence("a mission"), Sentence("give its name the ending .krt and open it")),
    "tutorial": (Sentence("a tutorial"), ""),
    "root": (Sentence("a behaviour tree"), Sentence("make a mission of it with {command}", "`kitrobot convert`")),
}


class PartsFileError(KitRobotError):
    """A file holds no parts that can be taken in."""


@dataclass(frozen=True)
class AddedParts:
    """What came in: the file's name, what it is, the names in it, and whether the same file was there already."""

    file: str
    kind: str
    names: tuple[str, ...]
    known: bool


def add_parts(folder: MissionFolder, mission: str, file: str, data: bytes, over: str = "") -> AddedParts:
    """Puts a file into the folder where a mission's parts are looked for.

    Args:
        folder: the missions.
        mission: the name of the mission, "" for a new one; the parts of an example go into the folder of missions.
        file: the file's name.
        data: what is in it.
        over: the revision of the file that may be replaced, "" when none may.

    Raises:
        PartsFileError: it holds no robot, kit, constructors or world, or cannot be read.
        MissionNameError: it has a name that no file may have.
        ConflictError: there is a file of that name with something else in it.
        FileError: it could not be written.
    """
    shown = PurePosixPath(unicodedata.normalize("NFC", file)).name.strip()
    if not shown.removesuffix(".xml").strip("."):
        raise MissionNameError(Sentence("`{name}` is no name of a file", shown), Sentence("give the file another name"))
    if len(data) > LARGEST_PARTS_BYTES:
        limit = LARGEST_PARTS_BYTES // (1024 * 1024)
        raise PartsFileError(
            Sentence("`{path}` is larger than {limit} MB", shown[:80], limit),
            Sentence("no file of robots or worlds is that large"),
        )
    kind, names = _kind_and_names(shown, data)
    wanted = _wanted(shown, kind)
    hold = folder.hold_beside(mission, wanted, over)
    try:
        with hold as path:
            replace_file(path, data)
    except ConflictError as error:
        if error.revision != revision_of(data):
            raise
        return AddedParts(wanted, kind, names, True)
    return AddedParts(wanted, kind, names, False)


def part_differences(folder: MissionFolder, mission: str, file: str, data: bytes) -> list[str]:
    """What is different in a file of parts from the one of its name that is there, where both are kits; else nothing.

    Args:
        folder: the missions.
        mission: the name of the mission, "" for a new one.
        file: the file's name.
        data: what is in it.

    Raises:
        PartsFileError: it cannot be read.
    """
    shown = PurePosixPath(unicodedata.normalize("NFC", file)).name.strip()
    if len(data) > LARGEST_PARTS_BYTES or _kind_and_names(shown, data)[0] != "board":
        return []
    wanted = _wanted(shown, "board")
    with suppress(KitRobotError):
        there, _ = read_kit(read_bytes(folder.own_folder_of(mission) / wanted), wanted)
        found, _ = read_kit(data, wanted)
        if there is not None and found is not None:
            return [words for _, words in kit_differences(there, found)]
    return []


def _wanted(shown: str, kind: str) -> str:
    """The name that a file gets, by which its parts are found."""
    wanted = shown if shown.lower().endswith(".xml") else f"{shown}.xml"
    if kind != "constructors" and not wanted.lower().endswith(_ENDINGS[kind]):
        wanted = wanted[: -len(".xml")] + _ENDINGS[kind]
    return wanted


def _kind_and_names(file: str, data: bytes) -> tuple[str, tuple[str, ...]]:
    """The kind of a file and the names that it brings along."""
    kind = first_element(data.decode("utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig", "replace"))
    names: list[str] = []
    if kind == "robot":
        robot, problems = read_robot(data, file)
        names = [robot.name] if robot is not None else []
    elif kind == "board":
        kit, problems = read_kit(data, file)
        names = [kit.name] if kit is not None else []
    elif kind == "world":
        world, problems = read_world(data, file)
        names = [world.name] if world is not None else []
    elif kind == "constructors":
        groups, problems = read_constructors(data, file)
        names = [constructor.name for group in groups for constructor in group.constructors]
    else:
        raise _refusal(file, kind)
    for problem in problems:
        if problem.code in _UNREADABLE:
            raise PartsFileError(
                Sentence("`{path}` cannot be read: {reason}", file[:80], problem.message), problem.help, (problem,)
            )
    return kind, tuple(names)


def _refusal(file: str, kind: str) -> PartsFileError:
    if kind in _OTHER_KINDS:
        words, help = _OTHER_KINDS[kind]
        return PartsFileError(Sentence("`{file}` is {kind}", file[:80], words), help)
    found = Sentence("begins with <{element}>", kind[:40]) if kind else Sentence("is no XML")
    return PartsFileError(
        Sentence("`{file}` {found}, so it holds no parts", file[:80], found),
        Sentence("files of parts begin with <robot>, <board>, <constructors> or <world>"),
    )
