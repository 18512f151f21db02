"""The requests behind parts of one's own: a selection is saved as one, a part is edited, all are shared as a file."""

from __future__ import annotations

from kitrobot.compiler.graph.own_part import Appearance, PartError, make_part, offer_part
from kitrobot.compiler.graph.selection import SelectionError
from kitrobot.compiler.text.part_text import draw_template, read_part
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.graph.model import Program
from kitrobot.live.studio import Studio
from kitrobot.lll.printer import print_template
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.own_xml import write_constructors
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.text.sentences import Sentence
from kitrobot.wire.catalogue import ConstructorShape
from kitrobot.wire.files import TextShape
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.own_part_draft import (
    LONGEST_PART,
    OfferAnswerShape,
    OfferedShape,
    OfferShape,
    PartAnswerShape,
    PartFileShape,
    PartReadShape,
    PartShape,
    PartTextShape,
    PartWishShape,
    SelectedShape,
)
from kitrobot.wire.own_parts import OwnPartError, own_constructor, raw_constructor
from kitrobot.wire.problem import RequestFailureShape, problem_shapes
from kitrobot.workspace.mission_loader import NoProgramError

MOST_PROBLEMS = 100

own_part_routes = api_router()


@own_part_routes.post("/part/offer")
def part_offer(studio: ThisStudio, wanted: SelectedShape) -> OfferAnswerShape:
    """What a selection offers to be left open when it becomes a part."""
    program, catalogue = _of(studio, wanted)
    try:
        offered = offer_part(program, wanted.vertices, catalogue)
    except SelectionError as error:
        return OfferAnswerShape(offered=None, refused=_refused(error))
    shape = OfferedShape(
        role=offered.role,
        vertices=list(offered.selection.chain),
        offers=[OfferShape.model_validate(one) for one in offered.offers],
        problems=problem_shapes(offered.diagnostics[:MOST_PROBLEMS]),
    )
    return OfferAnswerShape(offered=shape, refused=None)


@own_part_routes.post("/part")
def part(studio: ThisStudio, wanted: PartWishShape) -> PartAnswerShape:
    """Makes the part of a selection, and puts a vertex of it in the selection's place."""
    program, catalogue = _of(studio, wanted)
    look = Appearance(wanted.name, wanted.icon, wanted.colour, wanted.label, wanted.help)
    try:
        made = make_part(program, wanted.vertices, look, wanted.chosen, catalogue)
    except (SelectionError, PartError) as error:
        return PartAnswerShape(part=None, refused=_refused(error))
    template = made.constructor.template
    assert template is not None, "a part that is made has a template"
    shape = PartShape(
        constructor=ConstructorShape.model_validate(made.constructor),
        lll=print_template(template),
        program=made.program,
        vertex=made.vertex,
    )
    return PartAnswerShape(part=shape, refused=None)


@own_part_routes.post("/part/read")
def part_read(studio: ThisStudio, wanted: PartTextShape) -> PartReadShape:
    """Reads a part as it was edited: what became of it, or its mistakes."""
    if len(wanted.constructor.code) > LONGEST_PART:
        raise OwnPartError(
            Sentence(
                "this part has {count} characters, and a part has at most {longest}",
                len(wanted.constructor.code),
                LONGEST_PART,
            ),
            Sentence("make several smaller parts of it"),
        )
    if wanted.constructor.adds is not None:
        raise OwnPartError(
            Sentence(
                "the part `{constructor}` adds a branch to another one, and has no code to read",
                wanted.constructor.name,
            ),
            Sentence("give it code instead"),
        )
    mission = mission_from_shape(wanted.mission)
    catalogue = studio.parts_of(mission, wanted.path)
    robot = catalogue.robot(wanted.robot)
    read = read_part(raw_constructor(wanted.constructor), robot)
    drawing = None if read.constructor is None else draw_template(read.constructor, robot, catalogue)
    return PartReadShape(
        constructor=None if read.constructor is None else ConstructorShape.model_validate(read.constructor),
        lll=read.lll,
        drawing=drawing,
        problems=problem_shapes(read.diagnostics[:MOST_PROBLEMS]),
    )


@own_part_routes.post("/part/file")
def part_file(wanted: PartFileShape) -> TextShape:
    """Parts as a constructors file, for a download."""
    return TextShape(text=write_constructors([own_constructor(one) for one in wanted.constructors]).decode())


def _refused(error: KitRobotError) -> RequestFailureShape:
    """What a person can mend is an answer, no failure."""
    problems = problem_shapes(error.diagnostics[:MOST_PROBLEMS])
    return RequestFailureShape(message=error.message, help=error.help, problems=problems)


def _of(studio: Studio, wanted: SelectedShape) -> tuple[Program, Catalogue]:
    mission = mission_from_shape(wanted.mission)
    program = next((one for one in mission.programs if one.name == wanted.program), None)
    if program is None:
        raise NoProgramError(
            Sentence("the mission holds no program `{program}`", wanted.program), Sentence("load the page again")
        )
    return program, studio.parts_of(mission, wanted.path)
