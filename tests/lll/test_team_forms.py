"""Programs of teams as text: what is read, how it is laid out, what is said of mistakes."""

from __future__ import annotations

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.lll.parse_results import parse, parse_members, parse_team
from kitrobot.lll.printer import print_members, print_program, print_team_program
from kitrobot.lll.tokens import team_name
from kitrobot.lll.tree import (
    Call,
    GroupDeclaration,
    Joint,
    Members,
    Move,
    ParOfSeq,
    ProgramCall,
    RoleDeclaration,
    Seq,
    SeqOfPar,
    Where,
    WorkDeclaration,
)
from kitrobot.lll.walk import nodes
from tests.strategies import Shape, random_team_program, shipped_robots

LAID_OUT = """\
# who
role carriers: carrier 2..5;  # two at least
role spare: "mini robot";
role loaders: loader 3;
group helpers = {carriers, "big one", carrier-2} on failure substitute;
group one = carriers;
work Boxes = 12 lease 30;
work Bags = 3;

# what
SeqOfPar carriers (
  Wheel.Advance(50);
  ParOfSeq {carriers} ( Wheel.Stop(); );
);
Where helpers [Captor.LessThan(20) & Button.IsPressed()](
  PROGRAM drive-to-A;
)!(
  MOVE 2 helpers -> one;  # over
);
*[any {carriers, spare} (A.b() | B.c())]( BREAK; );
"""


def test_a_team_s_program_is_laid_out_like_any_other() -> None:
    for text in (LAID_OUT, LAID_OUT.replace("\n  ", "\n").replace("\n\n", "\n").replace(" (", "(").replace(" = ", "=")):
        parsed = parse_team(text)
        assert parsed.diagnostics == []
        assert print_team_program(parsed.program) == LAID_OUT


def test_declarations_come_in_any_order_and_are_kept_with_their_comments() -> None:
    program = parse_team("# w\nwork Boxes=1;group a={b,c};#g\nrole b:carrier 2;\n# end").program
    assert program.works == [WorkDeclaration("Boxes", 1, above=["w"])]
    assert program.groups == [GroupDeclaration("a", Members(["b", "c"]), after="g")]
    assert program.roles == [RoleDeclaration("b", "carrier", 2, 2)]
    assert program.seq == Seq(below=["end"])


test = Call("A", "b")

FORMS = [
    ("SeqOfPar a ()", SeqOfPar(Members(["a"], braced=False), Seq())),
    ("ParOfSeq {a}()", ParOfSeq(Members(["a"]), Seq())),
    ("ParOfSeq { a , b-2 }()", ParOfSeq(Members(["a", "b-2"]), Seq())),
    ("Where a[A.b()]()", Where(Members(["a"], braced=False), test, Seq())),
    ("Where a[A.b()]()!()", Where(Members(["a"], braced=False), test, Seq(), Seq())),
    ('PROGRAM "to ""A"""', ProgramCall('to "A"')),
    ("MOVE 2 a->b-2", Move(2, "a", "b-2")),
    ("Where.b()", Call("Where", "b")),
    ("PROGRAM . b()", Call("PROGRAM", "b")),
]


@pytest.mark.parametrize(("text", "tree"), FORMS, ids=[row[0] for row in FORMS])
def test_a_form_is_read(text: str, tree: object) -> None:
    parsed = parse_team(text)
    assert parsed.diagnostics == []
    assert parsed.program.seq.items == [tree]


def test_a_joint_condition_is_read_where_a_set_follows() -> None:
    parsed = parse_team("[!(most {a} (A.b())) | any.c() | all x (A.b() & A.b())]()")
    assert parsed.diagnostics == []
    joint = [node for node in nodes(parsed.program.seq) if isinstance(node, Joint)]
    assert [(one.quantifier, one.members) for one in joint] == [
        ("most", Members(["a"])),
        ("all", Members(["x"], braced=False)),
    ]


def test_a_robot_s_objects_may_have_the_words_of_a_team_as_names() -> None:
    words = ("SeqOfPar", "ParOfSeq", "Where", "PROGRAM", "MOVE", "any", "all", "most", "role", "group", "work")
    text = "".join(f"[{word}.is()]( {word}.go(1); );\n" for word in words)
    assert parse(text).diagnostics == []
    assert print_program(parse(text).program) == text
    assert parse_team(text).program.seq == parse(text).program


ONE_ROBOT = [
    "SeqOfPar a ( Wheel.Stop(); );",
    "ParOfSeq {a, b} ( SeqOfPar a (",
    "Where a [x",
    "PROGRAM go",
    "MOVE 1 a -> b; MOVE 1 b -> a;",
    "[any a (A.b())]();",
    "*[A.b() & most {a, (]();",
    "role a: b; group c = {a}; work d = 1;",
    LAID_OUT,
]


@pytest.mark.parametrize("text", ONE_ROBOT)
def test_a_form_in_the_program_of_one_robot_is_one_mistake(text: str) -> None:
    assert [item.code for item in parse(text).diagnostics if item.is_error] == ["team-form"]


def test_a_form_in_the_program_of_one_robot_is_kept_in_its_tree() -> None:
    parsed = parse("Wheel.Stop(); SeqOfPar a ( Wheel.Stop(); ); Wheel.Stop();")
    assert [type(item) for item in parsed.program.items] == [Call, SeqOfPar, Call]
    (said,) = parsed.diagnostics
    assert said.place is not None
    assert (said.place.column, said.place.end_column) == (15, 23)


MISTAKES = [
    ("SeqOfPar ( a.b(); ); c.d();", "expected a name, found `(`"),
    ("SeqOfPar {} (a.b();); c.d();", "expected a name, found `}`"),
    ("SeqOfPar {a b} (a.b();); c.d();", "expected `,` or `}`, found a name `b`"),
    ("Where a (a.b();); c.d();", "expected `[`, found `(`"),
    ("PROGRAM ; c.d();", "expected a name, found `;`"),
    ("MOVE a -> b; c.d();", "expected a number of members, found a name `a`"),
    ("MOVE 1 a b; c.d();", "expected `->`, found a name `b`"),
    ("[any a b.c()](); c.d();", "expected `(`, found a call"),
    ("[any](); c.d();", "expected `.` and a method, found `]`"),
    ("role a carrier; c.d();", "expected `:`, found a name `carrier`"),
    ("role a: carrier 3..2; c.d();", "expected the smaller number first, found 3..2"),
    ("group a = b on fire; c.d();", "expected `failure`, found a name `fire`"),
    ("group a = b on failure wait; c.d();", "expected `drop`, `substitute` or `abort`, found a name `wait`"),
    ("work a-b = 2; c.d();", "expected a name that calls can have, found a name `a-b`"),
    ("work a = 70000; c.d();", "expected a number from 0 to 65535, found 70000"),
    ("c.d(); role a: carrier;", "`role` stands among instructions"),
]


@pytest.mark.parametrize(("text", "said"), MISTAKES, ids=[row[0] for row in MISTAKES])
def test_a_mistake_is_told_once_and_what_follows_is_read(text: str, said: str) -> None:
    parsed = parse_team(text)
    assert [item.message for item in parsed.diagnostics] == [said]
    assert Call("c", "d") in parsed.program.seq.items


@pytest.mark.parametrize("name", ["a", "a-b", "a-2", "WAIT", "a b", "2", "-", '"', 'a"b', "a--b", "a-", "", "é-à"])
def test_any_name_can_be_written(name: str) -> None:
    assert parse_members(team_name(name)) == Members([name], braced=False)
    assert parse_members(print_members(Members([name, "b"]))) == Members([name, "b"])
    assert (team_name(name) == name) == (name in ("a", "a-b", "a-2", "WAIT", "é-à"))


def test_what_is_no_set_is_none() -> None:
    assert [parse_members(text) for text in ("", "a b", "{a", "{a,}", "a,b", "1", "a.b")] == [None] * 7


@given(st.randoms(use_true_random=True))
def test_reading_what_was_printed_gives_the_program_and_its_places(rng: random.Random) -> None:
    program = random_team_program(rng, shipped_robots()["mini-robot"], Shape(comments=True))
    text = print_team_program(program)
    parsed = parse_team(text)
    assert parsed.diagnostics == []
    assert parsed.program == program
    assert print_team_program(parsed.program) == text
    for node in nodes(program):
        if isinstance(node, Members):
            assert parse_members(text[node.start : node.end]) == node
    for read, printed in zip(nodes(parsed.program)[1:], nodes(program)[1:], strict=True):
        if not isinstance(read, Seq):
            assert (read.start, read.end) == (printed.start, printed.end)


@given(st.text(alphabet='{}"a-b,;:=()[].|& \nSeqOfPar Where any role group work MOVE 12->#', max_size=60))
def test_any_text_is_read_without_fail(text: str) -> None:
    for one in (parse_team(text), parse_team(f"role {text}"), parse_team(f"SeqOfPar {text}"), parse(f"any {text}")):
        print_program(one.program) if isinstance(one.program, Seq) else print_team_program(one.program)
