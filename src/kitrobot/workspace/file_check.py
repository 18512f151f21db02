"""Every problem of a file of any kind: missions, LLL texts, images, listings, and XML of robots, kits, constructors,
worlds, tutorials, exercises, behaviour trees.

The kind follows from the ending or, for XML, from the first element. A file that cannot be read is a problem like the
others, so the check of many files continues after it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from kitrobot.compiler.compilation import compile_text
from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Place, Severity, Source, rule
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.diagnostics.regular import named_file
from kitrobot.exercise.exercise_xml import read_exercise
from kitrobot.files.disk import FileError, decode, read_bytes
from kitrobot.files.examples import find_mission
from kitrobot.lll.parse_results import parse_any
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.kit_xml import KIT_SUFFIX, read_kit
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.text.sentences import Sentence
from kitrobot.tutorial.tutorial_xml import read_tutorial
from kitrobot.workspace.images import read_image, read_listing, why_unsafe
from kitrobot.workspace.kit_files import wiring_problems
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.property_check import goal_problems
from kitrobot.workspace.robot_devices import robot_problems
from kitrobot.world.xml_reader import read_world

UNKNOWN_KIND = rule(
    "file-unknown-kind",
    Severity.ERROR,
    "A file is of no kind that is known here",
    "Known are `.krt`, `.lll`, `.kri`, `.kra`, files with a mission inside (`.svg`, `.png`, `.pdf`, `.hex`, `.uf2`),"
    " and XML whose first element is <robot>, <board>, <constructors>, <world>, <tutorial>, <exercise>, <kitrobot>, or"
    " <root> of a behaviour tree.",
)
TREE_ELEMENT = "root"
"""The first element of a file of behaviour trees."""
UNUSABLE = rule(
    "image-unusable",
    Severity.ERROR,
    "An image or a listing cannot be used",
    "An image is refused when it is damaged, of another format version, or could leave its arrays or never end a tick.",
)

# Atomic groups: a hostile file must not make the search for its first element slow.
_FIRST_ELEMENT = re.compile(
    r"(?:\s|(?><\?.*?\?>)|(?><!--.*?-->)|(?><!DOCTYPE[^>\[]*(?:\[.*?\])?\s*>))*+<([A-Za-z][\w.-]*)", re.DOTALL
)
_BEGINNING = 100_000
"""Characters among which the first element is looked for."""

_READERS = ("robot", "board", "world", "constructors", "tutorial", "exercise")
_LINE = re.compile(r"^.*?:([0-9]+): (.*)$", re.DOTALL)


@dataclass(frozen=True)
class FileReport:
    """A file looked through: its problems, the texts they point into, and what was not looked at (`notes`)."""

    path: Path
    diagnostics: tuple[Diagnostic, ...]
    sources: tuple[Source, ...] = ()
    notes: tuple[str, ...] = ()


def first_element(text: str) -> str:
    """The name of the first element of an XML text, "" when there is none near its beginning."""
    first = _FIRST_ELEMENT.match(text[:_BEGINNING])
    return first.group(1) if first else ""


def check_file(path: Path, robot: Robot | None = None) -> FileReport:
    """Looks a file through; `robot` is the one that an LLL text is for. Never raises because of the file."""
    try:
        return _check(path, robot)
    except FileError as error:
        return FileReport(path, (error.as_diagnostic(),))
    except ProblemsError as error:
        return FileReport(path, error.diagnostics, error.sources)


def _check(path: Path, robot: Robot | None) -> FileReport:
    path = find_mission(path)
    match path.suffix.lower():
        case ".krt" | ".svg" | ".png" | ".pdf" | ".hex" | ".uf2":
            return _mission(path)
        case ".lll":
            return _text(path, robot)
        case ".kri" | ".kra":
            return _image(path)
        case ".xml":
            return _xml(path, robot)
    ending = Sentence("the ending `{suffix}`", path.suffix) if path.suffix else Sentence("no ending")
    read_bytes(path)
    return FileReport(
        path,
        (UNKNOWN_KIND(Sentence("`{path}` has {ending}, so its kind is not known", path, ending), Place(str(path))),),
    )


def _mission(path: Path) -> FileReport:
    report = open_mission(path).check()
    return FileReport(path, report.problems, report.sources)


def _text(path: Path, robot: Robot | None) -> FileReport:
    source = Source(str(path), decode(read_bytes(path), path))
    if robot is not None:
        return FileReport(path, tuple(compile_text(source.text, robot, source.name).diagnostics), (source,))
    return FileReport(path, tuple(parse_any(source.text, source.name).diagnostics), (source,), (_syntax_only(path),))


def _tree(
    data: bytes, name: str, robot: Robot | None
) -> tuple[tuple[Diagnostic, ...], tuple[Source, ...], tuple[str, ...]]:
    from kitrobot.workspace.behaviour_trees import tree_problems

    found, sources = tree_problems(data, name, robot)
    return tuple(found), sources, (_syntax_only(name),) if robot is None else ()


def _syntax_only(name: object) -> Sentence:
    return Sentence("{path}: only the syntax was checked; what its names mean depends on the robot (--robot)", name)


def _image(path: Path) -> FileReport:
    name = str(path)
    if path.suffix.lower() == ".kri":
        try:
            unsafe = why_unsafe(read_image(path))
        except FileError as error:
            raise _not_an_image(error, path) from None
        sources: tuple[Source, ...] = ()
    else:
        sources = (Source(name, decode(read_bytes(path), path)),)
        try:
            unsafe = why_unsafe(read_listing(path))
        except KitRobotError as error:
            if isinstance(error, FileError):
                raise
            return FileReport(path, (_in_listing(error, name),), sources)
    found = (UNUSABLE(unsafe.message, Place(name), help=unsafe.help),) if unsafe is not None else ()
    return FileReport(path, found, sources)


def _not_an_image(error: FileError, path: Path) -> FileError | ProblemsError:
    """A damaged image as a problem of its own kind; a file that could not be read stays that."""
    prefix = f"`{path}`: "
    if not error.message.startswith(prefix):
        return error
    found = UNUSABLE(Sentence(error.message.removeprefix(prefix)), Place(str(path)), help=error.help)
    return ProblemsError(error.message, error.help, (found,))


def _in_listing(error: KitRobotError, name: str) -> Diagnostic:
    """The assembler's sentence as a diagnostic; it begins with FILE:LINE."""
    match = _LINE.match(error.message)
    line, sentence = (int(match[1]), match[2]) if match else (1, error.message)
    return UNUSABLE(Sentence(sentence), Place(name, line, 1, line + 1, 1), help=error.help)


def _among_others(path: Path, found: list[Diagnostic]) -> list[Diagnostic]:
    """What is wrong with constructors only together with all the others at hand: a branch of nothing, say."""
    problems = load_catalogue([path.parent]).problems
    return [item for item in problems if item.place and item.place.file == str(path) and item not in found]


def _xml(path: Path, robot: Robot | None) -> FileReport:
    data, name = read_bytes(path), str(path)
    source = Source(name, data.decode("utf-8-sig", errors="replace"))
    first = _FIRST_ELEMENT.match(source.text[:_BEGINNING])
    kind = first.group(1) if first else ""
    lower = path.name.lower()
    if kind == "kitrobot":
        return _mission(path)
    if kind == TREE_ELEMENT:
        return FileReport(path, *_tree(data, name, robot))
    found: list[Diagnostic]
    # A name such as `x.robot.xml` promises a kind; its reader says best what stands there instead.
    if kind == "robot" or (kind not in _READERS and lower.endswith(".robot.xml")):
        described, found = read_robot(data, name)
        found += robot_problems(described, path.parent) if described is not None else []
    elif kind == "board" or (kind not in _READERS and lower.endswith(KIT_SUFFIX)):
        kit, found = read_kit(data, name)
        found += wiring_problems(kit, path.parent) if kit is not None else []
    elif kind == "world" or (kind not in _READERS and lower.endswith(".world.xml")):
        _, found = read_world(data, name)
    elif kind == "tutorial" or (kind not in _READERS and lower.endswith(".tutorial.xml")):
        _, found = read_tutorial(data, name)
    elif kind == "exercise" or (kind not in _READERS and lower.endswith(".exercise.xml")):
        exercise, found = read_exercise(data, name)
        start = named_file(path.parent, exercise.start) if exercise is not None else None
        if exercise is not None and start is not None:
            opened = open_mission(start)
            found += goal_problems(exercise, opened.mission, opened.catalogue)
    elif kind == "constructors" or first is None or lower.endswith("constructors.xml"):
        _, found = read_constructors(data, name)
        found += _among_others(path, found)
    else:
        message = Sentence(
            "expected <robot>, <board>, <constructors>, <world>, <tutorial>, <exercise> or <kitrobot>, found <{kind}>",
            kind[:40],
        )
        found = [UNKNOWN_KIND(message, source.place(first.start(1), first.end(1)))]
    return FileReport(path, tuple(found), (source,))
