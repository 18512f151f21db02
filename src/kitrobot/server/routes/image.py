"""The requests for a program as a file to keep: its image, its behaviour tree, and a file that a board takes."""

from __future__ import annotations

from base64 import b64encode

from kitrobot.boards.board_files import make_board_file
from kitrobot.boards.programs import board_program
from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.compiler.target import robot_of
from kitrobot.deploy.firmware.uf2 import firmware_of
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.image.listing import disassemble
from kitrobot.image.model import Image
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.robot import Robot
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.text.sentences import Sentence
from kitrobot.wire.board_file import BoardFileAskShape, BoardFileShape
from kitrobot.wire.files import TextShape
from kitrobot.wire.image import ImageAskShape, ImageShape
from kitrobot.wire.mission import mission_from_shape
from kitrobot.workspace.behaviour_trees import tree_file
from kitrobot.workspace.kit_files import kit_named

image_routes = api_router()


@image_routes.post("/image")
def image(studio: ThisStudio, wanted: ImageAskShape) -> ImageShape:
    """Compiles one program of a mission: its image and the listing of it."""
    _, _, made = _compile(studio, wanted)
    return ImageShape(image=b64encode(made.to_bytes()).decode(), listing=disassemble(made))


@image_routes.post("/tree")
def tree(studio: ThisStudio, wanted: ImageAskShape) -> TextShape:
    """Writes one program of a mission as a behaviour tree."""
    robot, compiled, _ = _compile(studio, wanted)
    data, refused = tree_file(compiled.program, robot, compiled.source, wanted.program)
    if data is None:
        message = Sentence("`{program}` is no behaviour tree: {reason}", wanted.program, refused[0].message)
        raise ProblemsError(message, refused[0].help, tuple(refused))
    return TextShape(text=data.decode())


def _compile(studio: ThisStudio, wanted: ImageAskShape) -> tuple[Robot, CompiledProgram, Image]:
    """One program of a mission, and the robot that it is for.

    Raises:
        ProblemsError: it has mistakes, or its robot is not there.
    """
    opened = studio.open(mission_from_shape(wanted.mission), wanted.path)
    program = opened.program(wanted.program)
    if program.level.is_team:
        robot_of(program, opened.catalogue)  # says that it has none
    compiled = opened.compiled.get(program.name)
    if compiled is None:
        raise ProblemsError(
            Sentence(
                "the robot `{robot}` of `{program}` is not at hand, so there is no image of it",
                program.target,
                program.name,
            ),
            Sentence("put the robot's file beside the mission"),
            opened.diagnostics,
        )
    if compiled.image is None:
        errors = tuple(item for item in compiled.diagnostics if item.is_error)
        raise ProblemsError(
            Sentence("`{program}` has {errors}, so there is no image of it yet", program.name, _counted(len(errors))),
            Sentence("mend what the list of problems shows"),
            errors,
        )
    return robot_of(program, opened.catalogue), compiled, compiled.image


@image_routes.post("/board-file")
def board_file(studio: ThisStudio, wanted: BoardFileAskShape) -> BoardFileShape:
    """Compiles one program of a mission into a file that is copied onto a board's drive."""
    mission = mission_from_shape(wanted.mission)
    opened = studio.open(mission, wanted.path)
    folder = studio.folder.folders_of(wanted.path)[0]
    kit = kit_named(wanted.kit, folder) if wanted.kit else None
    firmware = firmware_of(wanted.firmware, wanted.firmware_name) if wanted.firmware else None
    made = make_board_file(board_program(opened, wanted.program, folder, kit), write_mission(mission), firmware)
    reasons = [Sentence("it is not for {board}: {reason}", board, error.message) for board, error in made.reasons]
    return BoardFileShape(
        file=b64encode(made.data).decode(), ending=made.ending, boards=made.boards, steps=made.steps, reasons=reasons
    )


def _counted(errors: int) -> str:
    return Sentence.counted("{count} error", "{count} errors", errors)
