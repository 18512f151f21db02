"""The requests about parts: the files beside a mission as they are now, files that a person adds, new variables."""

from __future__ import annotations

from typing import Annotated, Literal, cast

from fastapi import Depends, Query, Request

from kitrobot.boards.board_files import file_of_kit
from kitrobot.boards.kit_pictures import body_picture
from kitrobot.boards.kits import absent_parts, program_on_kits
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.robot import Category, Robot, ValueType
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.text.sentences import Sentence, Series
from kitrobot.translation.reader_language import translate
from kitrobot.wire.files import ConflictShape, TextShape
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.own_parts import OwnVariableShape, own_variable
from kitrobot.wire.own_world import OwnWorldShape, own_world, own_world_shape
from kitrobot.wire.part_files import (
    AbsentPartShape,
    KitEntryShape,
    KitFitAskShape,
    KitFitShape,
    LackingShape,
    PartsDifferenceShape,
    PartsFileShape,
    PartsShape,
    PlanShape,
    TemplateShape,
    VariableAskShape,
    WorldEntryShape,
    WorldFileShape,
)
from kitrobot.wire.problem import problem_shapes
from kitrobot.wire.world import world_shape
from kitrobot.workspace.imported_files import add_parts, part_differences
from kitrobot.workspace.kit_files import kits_at_hand
from kitrobot.workspace.variables import WantedVariable, make_variable
from kitrobot.workspace.worlds import FoundWorld, read_world_file, worlds_at_hand
from kitrobot.world.maze import MOST_SEED
from kitrobot.world.template import TEMPLATES
from kitrobot.world.xml_writer import write_world

LONGEST_NAME = 1000

parts_routes = api_router(more={409: {"model": ConflictShape, "description": "There is another file of that name."}})


async def _body(request: Request) -> bytes:
    return await request.body()


Name = Annotated[str, Query(max_length=LONGEST_NAME)]


@parts_routes.get("/catalogue")
def catalogue(studio: ThisStudio, path: Name) -> PartsShape:
    """The robots and constructors of the files around a mission, as they are now."""
    stamp = studio.stamp(path)
    return PartsShape(stamp=stamp, catalogue=studio.catalogue_shape(path))


@parts_routes.get("/world")
def world(studio: ThisStudio, path: Name, href: Name) -> WorldFileShape:
    """A world of a mission, as its file is now."""
    file = studio.world_file(href, path)
    found = read_world_file(file)[0] if file is not None else None
    return WorldFileShape(world=world_shape(found) if found is not None else None)


@parts_routes.get("/world/plan")
def world_plan(studio: ThisStudio, path: Name, href: Name) -> PlanShape:
    """What a world of a mission is made of, to be changed in the mission."""
    file = studio.world_file(href, path)
    if file is None:
        return PlanShape(world=None, problems=[])
    found, problems = read_world_file(file)
    sound = found is not None and not any(problem.is_error for problem in problems)
    return PlanShape(world=own_world_shape(found) if found and sound else None, problems=problem_shapes(problems))


@parts_routes.get("/world/templates")
def world_templates(seed: Annotated[int, Query(ge=0, le=MOST_SEED)] = 0) -> list[TemplateShape]:
    """Worlds to begin with; the maze is made from the seed."""
    return [TemplateShape(name=name, world=own_world_shape(make(seed))) for name, make in TEMPLATES.items()]


@parts_routes.post("/world/text")
def world_text(wanted: OwnWorldShape) -> TextShape:
    """The file of a mission's own world."""
    return TextShape(text=write_world(own_world(wanted)).decode())


@parts_routes.get("/worlds")
def worlds(studio: ThisStudio, path: Name) -> list[WorldEntryShape]:
    """The worlds that a mission can take place in."""
    return [_world(found) for found in worlds_at_hand(studio.folder.folders_of(path)[::-1])]


@parts_routes.get("/kits")
def kits(studio: ThisStudio, path: Name) -> list[KitEntryShape]:
    """The kits that a robot can be built of, by their names."""
    found = kits_at_hand(studio.folder.folders_of(path)[0])
    robots = studio.catalogue(path).robots
    return [
        KitEntryShape(
            name=name,
            label=dict(kit.label),
            help=dict(kit.help),
            micropython=kit.micropython,
            firmware=kit.firmware,
            file=file_of_kit(kit),
            picture=body_picture(kit),
            absent={name: _absent(robot, kit) for name, robot in robots.items()},
        )
        for name, kit in sorted(found.items())
    ]


def _absent(robot: Robot, kit: Kit) -> list[AbsentPartShape]:
    found = [(part.category, part.name) for part in absent_parts(robot, kit)]
    return [
        AbsentPartShape(category="actuator" if category is Category.ACTUATOR else "sensor", name=name)
        for category, name in found
    ]


@parts_routes.post("/kits/fit")
def kits_fit(studio: ThisStudio, wanted: KitFitAskShape) -> list[KitFitShape]:
    """Whether a program of a mission runs on its robot's own board, and on each of the kits."""
    opened = studio.open(mission_from_shape(wanted.mission), wanted.path)
    folder = studio.folder.folders_of(wanted.path)[0]
    fits = program_on_kits(opened, wanted.program, kits_at_hand(folder).values(), folder)
    return [
        KitFitShape(
            kit=fit.kit,
            missing=[LackingShape(part=part.name, label=dict(part.label)) for part in fit.missing],
            problem=_why_not(fit.problem) if fit.problem is not None else "",
        )
        for fit in fits
    ]


def _why_not(problem: KitRobotError) -> str:
    """Why a program cannot be sent: of one with errors the first of them."""
    first = next((item for item in problem.diagnostics if item.is_error), None)
    return Series(Sentence(": "), (problem.message, first.message)) if first is not None else problem.message


@parts_routes.post("/parts")
def parts(
    studio: ThisStudio, data: Annotated[bytes, Depends(_body)], path: Name, file: Name, over: Name = ""
) -> PartsFileShape:
    """Puts a file with a robot, a kit, constructors or a world beside a mission."""
    added = add_parts(studio.folder, path, file, data, over)
    kind = cast('Literal["robot", "board", "constructors", "world"]', added.kind)
    return PartsFileShape(file=added.file, kind=kind, names=list(added.names), known=added.known)


@parts_routes.post("/parts/difference")
def parts_difference(
    studio: ThisStudio, data: Annotated[bytes, Depends(_body)], path: Name, file: Name
) -> PartsDifferenceShape:
    """What is different in a kit's file from the one of its name beside a mission, a sentence each."""
    found = (translate(words) for words in part_differences(studio.folder, path, file, data))
    return PartsDifferenceShape(changes=[words[:1].upper() + words[1:] for words in found])


@parts_routes.post("/variable")
def variable(studio: ThisStudio, wanted: VariableAskShape) -> OwnVariableShape:
    """A variable with everything that the page needs of it, or why it cannot be."""
    own = [own_variable(one) for one in wanted.variables]
    asked = WantedVariable(wanted.name, ValueType(wanted.type), wanted.min, wanted.max, wanted.initial, wanted.shared)
    made = make_variable(studio.catalogue(wanted.path), own, wanted.robot, asked, wanted.was)
    return OwnVariableShape.model_validate(made)


def _world(found: FoundWorld) -> WorldEntryShape:
    world = found.world
    return WorldEntryShape(
        href=found.href,
        shipped=found.shipped,
        label=dict(world.label) if world is not None else {},
        help=dict(world.help) if world is not None else {},
        world=world_shape(world) if world is not None else None,
        problems=problem_shapes(found.problems),
    )
