"""Conversion of a program from one form into another, by the endings of the files' names.

    .krt → .lll .kri .kra .xml      .lll → .krt .kri .kra .xml      .xml → .krt .lll .kri .kra
    .kri → .kra                     .kra → .kri

An `.xml` is a behaviour tree.

A picture of the studio that carries a mission (.svg, .png, .pdf) converts to whatever a `.krt` converts to, and to the
`.krt` itself; only the studio makes pictures.

Going down, every pass of the compiler runs and reports; nothing is written when one finds an error that the target form
cannot express. An image has no names, so it cannot be converted back to a program. The file that is read is never
written to.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from kitrobot.compiler.compilation import compile_program, compile_text
from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.program.checker import check
from kitrobot.compiler.program.team_check import check_program
from kitrobot.compiler.target import print_for, robot_of, target_of
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Place, Severity, Source, rule
from kitrobot.diagnostics.read_files import expect_output
from kitrobot.files.disk import read_text, saving_in, write_atomic
from kitrobot.files.embedded_mission import is_picture, may_carry_mission
from kitrobot.files.program_formats import Form, form_of
from kitrobot.graph.model import Program
from kitrobot.image.listing import disassemble
from kitrobot.image.model import Image
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tokens import is_name
from kitrobot.mission.model import Mission
from kitrobot.mission.writer import save
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Robot
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.behaviour_trees import open_tree, tree_file
from kitrobot.workspace.images import read_image, read_listing, why_unsafe
from kitrobot.workspace.mission_loader import OpenMission, mission_of, open_mission, retarget
from kitrobot.workspace.robots import find_robot
from kitrobot.workspace.team_programs import for_kind

UNSAFE = rule(
    "image-unsafe",
    Severity.WARNING,
    "No host would run this image",
    "An image is looked through before any host runs it. This one could leave its arrays or never end a tick.",
)
ROBOT_ELSEWHERE = rule(
    "robot-elsewhere",
    Severity.WARNING,
    "The mission names a robot that is not beside it",
    "A mission finds its robots among those that come with KitRobot, the user's own, and those in its own folder. Put"
    " the robot's file into the mission's folder.",
)

_NO_NAMES = {
    Form.IMAGE: "An image keeps no names, so it cannot be turned into",
    Form.LISTING: "A listing of an image keeps no names, so it cannot be turned into",
}


class ConversionError(KitRobotError):
    """There is no way from the one form to the other."""


@dataclass(frozen=True)
class ConversionResult:
    """What became of a conversion: whether the file was written, and what there is to say, with the texts it points
    into.
    """

    target: Path
    written: bool
    diagnostics: tuple[Diagnostic, ...] = ()
    sources: tuple[Source, ...] = ()


@dataclass(frozen=True)
class _ConvertedProgram:
    """The bytes of the new form, or a mission; None when there are errors."""

    data: bytes | None
    diagnostics: list[Diagnostic]
    sources: tuple[Source, ...] = ()
    mission: Mission | None = None


def convert(source: Path, target: Path, *, program: str | None = None, robot: str | None = None) -> ConversionResult:
    """Turns the program in `source` into the form that the name of `target` tells, and writes it there.

    Args:
        source: the file to read; a picture that carries a mission is read as that mission.
        target: the file to write.
        program: which program of a mission with several; or what to call the one that is made for a mission. A mission
            that is taken out of a picture keeps them all.
        robot: the robot's name or file; needed for an LLL text and a tree, and in place of the mission's own otherwise.
            Of a program of a team, the kind of robot for which it is wanted.

    Raises:
        FormError: an ending that is not known.
        ConversionError: there is no way between these forms, or they are the same file.
        KitRobotError: a file cannot be read or written, a robot or program is not there.
    """
    if is_picture(target.name):
        raise ConversionError(
            Sentence("`{target}` would be a picture, and pictures are drawn by the studio", target),
            Sentence("open the mission in the studio and choose Export in the menu File"),
        )
    if may_carry_mission(target.name):
        brought = " --firmware MICROPYTHON.uf2" if target.suffix.lower() == ".uf2" else ""
        raise ConversionError(
            Sentence(
                "`{target}` would be a file for a board, and that needs to know what the robot is built of", target
            ),
            Sentence("make it with {command}", f"`kitrobot deploy {source} --file {target}{brought}`"),
        )
    carried = may_carry_mission(source.name)
    form, wanted = Form.MISSION if carried else form_of(source), form_of(target)
    if form is wanted and not carried:
        raise ConversionError(
            Sentence("`{source}` and `{target}` are both {form}", source, target, form.words),
            Sentence("give B another ending: {ways}", _ways(form)),
        )
    if form is not wanted and wanted not in _WAYS[form]:
        raise ConversionError(
            Sentence(f"{_NO_NAMES[form]} {_article(wanted)}"),
            Sentence(
                "convert the `.krt` or `.lll` that it was made from; `{form}` goes to {ways}", form.value, _ways(form)
            ),
        )
    expect_output(target, source)
    if form is wanted:
        made = _out_of_picture(source)
    elif form is Form.MISSION:
        made = _from_mission(source, wanted, program, robot)
    elif form in (Form.TEXT, Form.TREE):
        made = _from_text(source, target, wanted, program, robot)
    else:
        made = _from_image(source, form)
    if made.mission is not None:
        with saving_in(target):
            save(target, made.mission)
    elif made.data is not None:
        write_atomic(target, made.data)
    written = made.mission is not None or made.data is not None
    return ConversionResult(target, written, tuple(made.diagnostics), made.sources)


def _out_of_picture(source: Path) -> _ConvertedProgram:
    """The mission as it is, mistakes and all: a picture must not be the only place that has it."""
    opened = open_mission(source)
    return _ConvertedProgram(None, list(opened.diagnostics), opened.sources, opened.mission)


def _from_mission(source: Path, wanted: Form, name: str | None, robot: str | None) -> _ConvertedProgram:
    opened = open_mission(source)
    found = list(opened.diagnostics)
    if any(item.is_error for item in found):
        return _ConvertedProgram(None, found, opened.sources)
    program = opened.program(name)
    if program.level.is_team and wanted is Form.TREE:
        raise ConversionError(
            Sentence("`{program}` is the program of a team, and a behaviour tree is that of one robot", program.name),
            Sentence("choose the program of one robot"),
        )
    if program.level.is_team and robot is not None:
        return _for_kind(opened, program, robot, wanted)
    if robot is not None:
        retarget(opened, find_robot(robot, source.parent))
    if wanted is Form.TEXT:
        target, translation = target_of(program, opened.catalogue), graph_to_lll(program, opened.catalogue)
        text = Source(f"{program.name}.lll", print_for(translation.program, target, opened.catalogue.crew))
        found += translation.diagnostics
        found += check_program(translation.program, target, opened.catalogue.crew, text, program.name)
        data = text.text.encode() if translation.ok else None
    elif wanted is Form.TREE:
        kind = robot_of(program, opened.catalogue)
        compiled = compile_program(program, opened.catalogue)
        found += compiled.diagnostics
        data, refused = tree_file(compiled.program, kind, compiled.source, program.name) if compiled.ok else (None, [])
        found += refused
    else:
        robot_of(program, opened.catalogue)
        compiled = compile_program(program, opened.catalogue)
        found += compiled.diagnostics
        data = _image_data(compiled.image, wanted)
    return _ConvertedProgram(data, opened.placed(found), opened.sources)


def _for_kind(opened: OpenMission, program: Program, robot: str, wanted: Form) -> _ConvertedProgram:
    """What a team's program is for a kind of robot."""
    made = for_kind(opened, program, robot)
    found = [*opened.diagnostics, *opened.placed(made.diagnostics)]
    if made.compiled is None:
        return _ConvertedProgram(None, found, opened.sources)
    if wanted is Form.TEXT:
        return _ConvertedProgram(made.compiled.source.text.encode(), found, opened.sources)
    return _ConvertedProgram(_image_data(made.compiled.image, wanted), found, opened.sources)


def _from_text(source: Path, target: Path, wanted: Form, name: str | None, word: str | None) -> _ConvertedProgram:
    """What an LLL text or a behaviour tree becomes."""
    is_tree = form_of(source) is Form.TREE
    if word is None:
        silent = Sentence("a behaviour tree") if is_tree else Sentence("an LLL text")
        raise ConversionError(
            Sentence("{form} does not say which robot it is for", silent),
            Sentence("name the robot with --robot, a name or a `.robot.xml`"),
        )
    robot = find_robot(word, source.parent)
    if is_tree:
        read = open_tree(source, robot)
        text, found, sources = read.text, read.diagnostics, read.sources
        if text is None:
            return _ConvertedProgram(None, found, sources)
    else:
        text, found = Source(str(source), read_text(source)), []
        sources = (text,)
    if wanted in (Form.IMAGE, Form.LISTING):
        compiled = compile_text(text.text, robot, text.name)
        return _ConvertedProgram(_image_data(compiled.image, wanted), found + compiled.diagnostics, sources)
    parsed = parse(text.text, text.name)
    found += parsed.diagnostics + check(parsed.program, robot, text)
    if any(item.is_error for item in found):
        return _ConvertedProgram(None, found, sources)
    name = name or _program_name(target)
    if wanted is Form.TEXT:
        return _ConvertedProgram(text.text.encode(), found, sources)
    if wanted is Form.TREE:
        data, refused = tree_file(parsed.program, robot, text, name)
        return _ConvertedProgram(data, found + refused, sources)
    catalogue = load_catalogue([source.parent])
    program = lll_to_graph(parsed.program, robot, catalogue, name)
    return _ConvertedProgram(None, found + _robot_elsewhere(robot, target), sources, mission_of(program))


def _from_image(source: Path, form: Form) -> _ConvertedProgram:
    if form is Form.IMAGE:
        return _ConvertedProgram(disassemble(read_image(source)).encode(), [])
    image = read_listing(source)
    unsafe = why_unsafe(image)
    found = [UNSAFE(unsafe.message, Place(str(source)))] if unsafe is not None else []
    return _ConvertedProgram(image.to_bytes(), found)


def _image_data(image: Image | None, wanted: Form) -> bytes | None:
    if image is None:
        return None
    return image.to_bytes() if wanted is Form.IMAGE else disassemble(image).encode()


def _robot_elsewhere(robot: Robot, target: Path) -> list[Diagnostic]:
    known = load_catalogue([target.parent]).robots.get(robot.name)
    if known is not None and known.fingerprint == robot.fingerprint:
        return []
    return [
        ROBOT_ELSEWHERE(
            Sentence("`{target}` needs the robot `{robot}`, which is not beside it", target, robot.name),
            Place(str(target)),
        )
    ]


def _program_name(target: Path) -> str:
    return target.stem if is_name(target.stem.replace("-", "_")) else "program-1"


_WAYS = {
    Form.MISSION: (Form.TEXT, Form.IMAGE, Form.LISTING, Form.TREE),
    Form.TEXT: (Form.MISSION, Form.IMAGE, Form.LISTING, Form.TREE),
    Form.TREE: (Form.MISSION, Form.TEXT, Form.IMAGE, Form.LISTING),
    Form.IMAGE: (Form.LISTING,),
    Form.LISTING: (Form.IMAGE,),
}


def _ways(form: Form) -> str:
    return ", ".join(f"`{way.value}`" for way in _WAYS[form])


def _article(form: Form) -> str:
    return Sentence("an {form} (`.lll`)", form.words) if form is Form.TEXT else f"a {form.words} (`{form.value}`)"
