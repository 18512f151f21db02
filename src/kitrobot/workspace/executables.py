"""What `exec` runs: an image, its robot and the script of inputs, from files of any form."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from kitrobot.compiler.compilation import compile_program, compile_text
from kitrobot.compiler.target import robot_of
from kitrobot.diagnostics.model import Diagnostic, KitRobotError, Source
from kitrobot.files.disk import read_text
from kitrobot.files.embedded_mission import may_carry_mission
from kitrobot.files.program_formats import Form, form_of
from kitrobot.image.machine import Machine
from kitrobot.image.model import Image
from kitrobot.primitives.robot import Robot
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.images import read_image
from kitrobot.workspace.inputs import Inputs, read_inputs
from kitrobot.workspace.mission_loader import open_mission, retarget
from kitrobot.workspace.robots import find_robot
from kitrobot.workspace.team_programs import for_kind

FORMS = (Form.TEXT, Form.IMAGE, Form.MISSION)


class NoRobotError(KitRobotError):
    """Nothing says which robot the program is for."""


@dataclass(frozen=True)
class Executable:
    """A program ready to be executed: `image` or `inputs` is None when `diagnostics` holds an error of theirs."""

    robot: Robot
    image: Image | None
    inputs: Inputs | None
    diagnostics: tuple[Diagnostic, ...]
    sources: tuple[Source, ...]


@dataclass(frozen=True)
class _LoadedProgram:
    robot: Robot
    image: Image | None
    diagnostics: list[Diagnostic]
    sources: tuple[Source, ...] = ()


def load_executable(
    path: Path, *, robot: str | None = None, program: str | None = None, inputs: Path | None = None
) -> Executable:
    """Loads a program of any form, and the inputs scripted for it.

    Args:
        path: a `.lll`, `.kri` or `.krt`, or a picture that carries a mission.
        robot: the robot's name or file; needed unless a mission names it.
        program: which program of a mission with several.
        inputs: a table of inputs (CSV); None for none.

    Raises:
        KitRobotError: a file cannot be read, the robot or program is not there, the image is damaged or not for the
        robot.
    """
    form = Form.MISSION if may_carry_mission(path.name) else form_of(path, FORMS)
    if form is Form.MISSION:
        loaded = _mission(path, robot, program)
    elif robot is None:
        raise NoRobotError(
            Sentence("`{path}` does not say which robot it is for", path),
            Sentence("name the robot with --robot, a name or a `.robot.xml`"),
        )
    elif form is Form.TEXT:
        loaded = _text(path, find_robot(robot, path.parent))
    else:
        loaded = _image(path, find_robot(robot, path.parent))
    script, found, sources = _inputs(inputs, loaded.robot)
    return Executable(loaded.robot, loaded.image, script, (*loaded.diagnostics, *found), (*loaded.sources, *sources))


def _mission(path: Path, robot: str | None, name: str | None) -> _LoadedProgram:
    opened = open_mission(path)
    program = opened.program(name)
    if program.level.is_team and robot is not None:
        made = for_kind(opened, program, robot)
        found = [*opened.diagnostics, *opened.placed(made.diagnostics)]
        sound = made.compiled is not None and not any(item.is_error for item in opened.diagnostics)
        image = made.compiled.image if sound and made.compiled is not None else None
        return _LoadedProgram(made.robot, image, found, opened.sources)
    if robot is not None:
        retarget(opened, find_robot(robot, path.parent))
    runs = robot_of(program, opened.catalogue)
    compiled = compile_program(program, opened.catalogue)
    found = opened.placed([*opened.diagnostics, *compiled.diagnostics])
    image = None if any(item.is_error for item in opened.diagnostics) else compiled.image
    return _LoadedProgram(runs, image, found, opened.sources)


def _text(path: Path, robot: Robot) -> _LoadedProgram:
    source = Source(str(path), read_text(path))
    compiled = compile_text(source.text, robot, source.name)
    return _LoadedProgram(robot, compiled.image, compiled.diagnostics, (source,))


def _image(path: Path, robot: Robot) -> _LoadedProgram:
    image = read_image(path)
    Machine(image, robot)  # refuses an image for another robot, and one that cannot be run safely
    return _LoadedProgram(robot, image, [])


def _inputs(path: Path | None, robot: Robot) -> tuple[Inputs | None, list[Diagnostic], tuple[Source, ...]]:
    if path is None:
        return Inputs(), [], ()
    source = Source(str(path), read_text(path))
    inputs, found = read_inputs(source.text, source.name, robot)
    wrong = any(item.is_error for item in found)
    return (None if wrong else inputs), found, (source,)
