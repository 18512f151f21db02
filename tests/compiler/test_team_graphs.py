"""Programs of teams as graphs: text and graph are the same program, whatever is edited on either side."""

from __future__ import annotations

import copy
import random

from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.graph.own_part import Appearance, ChosenSlot, make_part
from kitrobot.compiler.target import print_for
from kitrobot.compiler.text.accepted_forms import normalise
from kitrobot.compiler.text.lll_to_graph import lll_to_graph, redraw
from kitrobot.compiler.text.part_text import draw_template
from kitrobot.compiler.text.preserve_ids import Before
from kitrobot.compiler.text.text_edit import follow_text
from kitrobot.graph.model import Program, empty_program
from kitrobot.lll.parse_results import parse_team
from kitrobot.lll.printer import print_team_program
from kitrobot.lll.tree import Seq, TeamProgram
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.constructors import SlotKind
from kitrobot.primitives.crew import Crew, CrewProgram
from kitrobot.primitives.levels import Level
from tests.strategies import Shape, random_team_program

DECLARED = parse_team(
    "role carriers: carrier 3; group all = carriers; work Boxes = 12; work Boîtes = 3 lease 9;"
).program
CREW = Crew(
    (("carrier-1", "carrier"),),
    (CrewProgram("drive", "carrier"), CrewProgram("load", "loader")),
    *(tuple(DECLARED.roles), tuple(DECLARED.groups), tuple(DECLARED.works)),
)


def parts() -> Catalogue:
    return load_catalogue().extended([], [], CREW)


PARTS = parts()
TARGET = PARTS.teams[Level.SOCIAL]


def drawn(text: str, keep: Program | None = None) -> Program:
    parsed = parse_team(text)
    assert parsed.diagnostics == []
    return lll_to_graph(parsed.program.seq, TARGET, PARTS, "haul", keep)


def written(program: Program) -> str:
    translation = graph_to_lll(program, PARTS)
    assert translation.diagnostics == []
    return print_team_program(TeamProgram(seq=translation.program))


FORMS = """\
SeqOfPar carriers (
  Wheel.Advance(50);
  Boxes.Take();
);
ParOfSeq {carriers, "big one"} ( Wheel.Stop(); );
Where carriers [Collision.IsPressed()]( PROGRAM to-A; );
Where all [Boxes.IsEmpty()](
  WAIT(1);
)!(
  MOVE 2 all -> carriers;
);
*[any carriers (Collision.IsPressed())]( WAIT(Boîtes.Left()); );
"""


def test_each_form_is_a_vertex_of_its_own_constructor() -> None:
    text = FORMS.replace("WAIT(Boîtes.Left())", "Boîtes.Done()")
    program = drawn(text)
    assert (program.target, program.level) == ("", Level.SOCIAL)
    elements = [vertex.element for vertex in program.vertices]
    for element in ("SeqOfPar", "ParOfSeq", "Where", "Where Else", "Program", "Move", "Any"):
        assert element in elements
    settings = {vertex.element: vertex.settings for vertex in program.vertices}
    assert settings["ParOfSeq"] == {"members": '{carriers, "big one"}'}
    assert settings["Program"] == {"name": "to-A"}
    assert settings["Move"] == {"count": "2", "source": "all", "target": "carriers"}
    assert written(program) == text


def test_the_target_of_a_team_knows_what_all_its_robots_have_and_its_work() -> None:
    assert [name for name in ("Wheel", "Crane", "Boxes", "Fault") if any(name == call[0] for call in TARGET.calls)]
    loader, carrier = PARTS.robots["loader"], PARTS.robots["carrier"]
    assert set(TARGET.calls) >= set(loader.calls) | set(carrier.calls)
    assert {method for name, method in TARGET.calls if name == "Boxes"} == {"Take", "Done", "IsEmpty", "Left"}


def test_a_team_without_robots_is_of_all_robots_at_hand() -> None:
    bare = load_catalogue()
    assert set(bare.teams[Level.GROUP].calls) >= set(bare.robots["mini-robot"].calls)


def test_what_speaks_of_more_robots_than_the_program_is_reported_at_its_vertex() -> None:
    program = drawn("SeqOfPar carriers (); MOVE 1 a -> b;")
    told = []
    for level, target in ((Level.SOCIAL, ""), (Level.GROUP, ""), (Level.AGENT, "carrier")):
        program.level, program.target = level, target
        told.append([(item.code, item.vertices) for item in graph_to_lll(program, PARTS).diagnostics])
    assert told == [[], [("wrong-level", ("v2",))], [("wrong-level", ("v1",)), ("wrong-level", ("v2",))]]


def test_a_slot_for_a_set_or_a_name_says_what_is_wrong_with_it() -> None:
    program = drawn("SeqOfPar carriers (); PROGRAM x;")
    program.vertices[1].settings["members"] = "a b"
    program.vertices[2].settings["name"] = " "
    assert [(item.code, item.vertices) for item in graph_to_lll(program, PARTS).diagnostics] == [
        ("not-a-set", ("v1",)),
        ("empty-slot", ("v2",)),
    ]


def test_an_edited_text_keeps_the_vertices_of_what_is_still_there() -> None:
    program = drawn(
        "SeqOfPar carriers ( Wheel.Stop(); ); PROGRAM drive; [all carriers (Collision.IsPressed())]( WAIT(1); );"
    )
    before = graph_to_lll(program, PARTS)
    text = print_for(before.program, TARGET, CREW)
    assert text.startswith("role carriers: carrier 3;\n")
    edited = text.replace("SeqOfPar carriers", "SeqOfPar {carriers, all}").replace("PROGRAM drive", "PROGRAM load")
    edited = edited.replace("[all", "[most")
    followed = follow_text(before, edited.replace("Boxes = 12", "Boxes = 13"), PARTS)
    assert followed.program is not None
    assert followed.team is not None
    assert [work.units for work in followed.team.works] == [13, 3]
    ids = {vertex.element: vertex.id for vertex in program.vertices}
    now = {vertex.element: vertex.id for vertex in followed.program.vertices}
    for element in ("SeqOfPar", "Program", "If", "Wheel.Stop"):
        assert now.get(element) == ids.get(element)
    assert followed.program.level is Level.SOCIAL
    again = graph_to_lll(followed.program, PARTS)
    assert print_for(again.program, TARGET, CREW) == edited


def test_a_text_with_a_mistake_of_a_team_leaves_the_graph_as_it_is() -> None:
    program = drawn("SeqOfPar carriers ( Wheel.Stop(); );")
    before = graph_to_lll(program, PARTS)
    text = print_for(before.program, TARGET, CREW)
    followed = follow_text(before, text.replace("SeqOfPar carriers", "SeqOfPar cariers"), PARTS)
    assert followed.program is None
    assert [(item.code, item.vertices) for item in followed.diagnostics] == [("team-unknown-member", ("v1",))]
    declared = text.replace("role carriers", "role porters").replace("= carriers", "= porters")
    followed = follow_text(before, declared.replace("SeqOfPar carriers", "SeqOfPar porters"), PARTS)
    assert followed.program is not None


def test_a_form_typed_into_the_program_of_one_robot_is_a_mistake_and_its_graph_stays() -> None:
    before = graph_to_lll(empty_program("mine", "carrier"), PARTS)
    followed = follow_text(before, "SeqOfPar a ( Wheel.Stop(); );", PARTS)
    assert followed.program is None
    assert [item.code for item in followed.diagnostics] == ["team-form"]


def test_a_piece_of_a_team_s_program_becomes_a_part_of_its_level() -> None:
    program = drawn("SeqOfPar carriers ( PROGRAM drive; ); [any carriers (Collision.IsPressed())]( Wheel.Stop(); );")
    look = Appearance("Go on", colour="team")
    part = make_part(
        program, ["v1"], look, [ChosenSlot("v1", "members", "who"), ChosenSlot("v2", "name", "what")], PARTS
    )
    made = part.constructor
    assert (made.code, made.level) == ("SeqOfPar {who} ( PROGRAM {what}; );", Level.SOCIAL)
    assert {slot.name: (slot.kind, slot.default) for slot in made.slots} == {
        "who": (SlotKind.TEXT, "carriers"),
        "what": (SlotKind.TEXT, "drive"),
    }
    template = draw_template(made, TARGET, PARTS)
    settings = {vertex.element: vertex.settings for vertex in template.vertices}
    assert settings["SeqOfPar"] == {"members": "{who}"}
    assert settings["Program"] == {"name": "{what}"}
    parts = PARTS.extended([made], [])
    again = lll_to_graph(parse_team("SeqOfPar all ( PROGRAM load; );").program.seq, TARGET, parts, "p")
    assert [(vertex.element, vertex.settings) for vertex in again.vertices][1] == (
        "Go on",
        {"who": "all", "what": "load"},
    )
    stop = next(vertex.id for vertex in program.vertices if vertex.element == "Wheel.Stop")
    lone = make_part(program, [stop], look, [], PARTS)
    assert lone.constructor.level is Level.AGENT


def random_one(rng: random.Random, instructions: int = 25) -> TeamProgram:
    """A team's program in the forms that are written today."""
    program = random_team_program(rng, TARGET, Shape(instructions=instructions, comments=True))
    normalise(program.seq, PARTS)
    return program


@given(st.randoms(use_true_random=True))
def test_a_text_becomes_a_graph_and_the_graph_the_text(rng: random.Random) -> None:
    program = random_one(rng)
    text = print_team_program(program)
    graph = lll_to_graph(copy.deepcopy(program.seq), TARGET, PARTS, "haul")
    translation = graph_to_lll(graph, PARTS)
    assert translation.diagnostics == []
    crew = Crew(roles=tuple(program.roles), groups=tuple(program.groups), works=tuple(program.works))
    assert print_for(translation.program, TARGET, crew) == text
    assert drawn(text, graph) == graph
    assert all(node.vertex for node in nodes(translation.program) if not isinstance(node, Seq))


@given(st.randoms(use_true_random=True))
def test_an_edited_text_becomes_a_graph_that_says_the_same(rng: random.Random) -> None:
    old, new = (random_one(rng, 12) for _ in range(2))
    if rng.random() < 0.7:
        new = copy.deepcopy(old)
        for body in rng.sample([node for node in nodes(new.seq) if isinstance(node, Seq)], 1):
            if body.items:
                body.items.insert(0, body.items.pop(rng.randrange(len(body.items))))
    before = Before(graph_to_lll(lll_to_graph(old.seq, TARGET, PARTS, "haul"), PARTS))
    text = print_team_program(new)
    program, translation = redraw(parse_team(text).program.seq, TARGET, PARTS, "haul", before)
    assert (program.level, program.target) == (Level.SOCIAL, "")
    assert translation.diagnostics == []
    assert graph_to_lll(program, PARTS).program == parse_team(text).program.seq
