"""What each constructor and each arrangement of arcs becomes in LLL."""

from __future__ import annotations

import pytest

from kitrobot.compiler import compile_lll
from kitrobot.graph import Note
from kitrobot.lll import MAX_NESTING, Call, nodes, parse, print_program
from tests.compiler.graphs import graph, noted, shipped, text_of, told, translated, with_constructors
from tests.lll.frames import at_most_frames

GRAPHS = [
    ("the smallest", ["start > stop"], ""),
    ("an action", ["start > v1:Wheel.Stop > stop"], "Wheel.Stop();"),
    ("two actions", ["start > v1:Wheel.Stop > v2:Door.Open > stop"], "Wheel.Stop(); Door.Open();"),
    ("a setting", ["start > v1:Wheel.Advance speed=7 > stop"], "Wheel.Advance(7);"),
    ("a setting left out", ["start > v1:Wheel.Advance > stop"], "Wheel.Advance(50);"),
    ("two settings", ["start > v1:Motor.AbsoluteTurn speed=1 angle=2 > stop"], "Motor.AbsoluteTurn(2, 1);"),
    (
        "a value in a parameter",
        ["start > v1:Wheel.Advance > stop", "v2:Captor.Value > v1.speed"],
        "Wheel.Advance(Captor.Value());",
    ),
    (
        "a value wins over a setting",
        ["start > v1:Wheel.Advance speed=7 > stop", "v2:Captor.Value > v1.speed"],
        "Wheel.Advance(Captor.Value());",
    ),
    (
        "Repetition",
        ["start > v1:Repetition count=3 > stop", "v1.body > v2:Wheel.Stop > v1.return"],
        "3*( Wheel.Stop(); );",
    ),
    ("an empty body", ["start > v1:Repetition > stop", "v1.body > v1.return"], "10*();"),
    (
        "While",
        ["start > v1:While > stop", "v2:Run.IsTrue > v1.condition", "v1.body > v3:Wheel.Stop > v1.return"],
        "*[Run.IsTrue()]( Wheel.Stop(); );",
    ),
    (
        "If Then",
        ["start > v1:If_Then > stop", "v2:Run.IsTrue > v1.condition", "v1.then > v3:Wheel.Stop > v1.return"],
        "[Run.IsTrue()]( Wheel.Stop(); );",
    ),
    (
        "If Then Else",
        [
            "start > v1:If_Then_Else > stop",
            "v2:Run.IsTrue > v1.condition",
            "v1.then > v1.return",
            "v1.else > v3:Wheel.Stop > v1.return",
        ],
        "[Run.IsTrue()]()!( Wheel.Stop(); );",
    ),
    (
        "When",
        ["start > v1:When > stop", "v2:Run.IsTrue > v1.condition", "v1.body > v3:Wheel.Stop > v1.return"],
        "<Run.IsTrue()>( Wheel.Stop(); );",
    ),
    ("Wait", ["start > v1:Wait time=7 > stop"], "WAIT(7);"),
    ("Break", ["start > v1:Break > stop"], "BREAK;"),
    (
        "And, Or, No",
        [
            "start > v1:When > stop",
            "v1.body > v1.return",
            "v3:And > v1.condition",
            "v2:Run.IsTrue > v3.left",
            "v6:Or > v3.right",
            "v5:No > v6.left",
            "v4:Flag.IsTrue > v5.condition",
            "v7:Button.IsPressed > v6.right",
        ],
        "<Run.IsTrue() & (!(Flag.IsTrue()) | Button.IsPressed())>();",
    ),
    (
        "Parallelism",
        [
            "start > v1:Parallelism > stop",
            "v1.branch.1 > v2:Wheel.Stop > v1.return",
            "v1.branch.2 > v3:Door.Open > v4:Door.Close > v1.return",
        ],
        "//( Wheel.Stop();, Door.Open(); Door.Close(); );",
    ),
    (
        "branches in the order of their numbers",
        [
            "start > v1:Parallelism > stop",
            "v1.branch.10 > v2:Wheel.Stop > v1.return",
            "v1.branch.2 > v3:Door.Open > v1.return",
            "v1.branch.7 > v1.return",
        ],
        "//( Door.Open();, Wheel.Stop(); );",
    ),
    ("a Parallelism of no branch", ["start > v1:Parallelism > stop"], "//();"),
    (
        "Interrupt",
        ["start > v1:Interrupt > stop", "v2:Wheel.Advance speed=5 > v1.action"],
        "°Wheel.Advance(5)°;",
    ),
    ("Forever", ["start > v1:Forever > stop", "v1.body > v2:Wait time=1 > v1.return"], None),
    (
        "Repeat Until",
        ["start > v1:Repeat_Until > stop", "v2:Run.IsTrue > v1.condition", "v1.body > v1.return"],
        "*[!(Run.IsTrue())]();",
    ),
    ("Wait Until", ["start > v1:Wait_Until > stop", "v2:Run.IsTrue > v1.condition"], "<Run.IsTrue()>();"),
    (
        "Unless",
        ["start > v1:Unless > stop", "v2:Run.IsTrue > v1.condition", "v1.then > v3:Wheel.Stop > v1.return"],
        "[!(Run.IsTrue())]( Wheel.Stop(); );",
    ),
    (
        "a body in a body",
        [
            "start > v1:Repetition count=2 > stop",
            "v1.body > v2:Repetition count=3 > v3:Wheel.Stop > v1.return",
            "v2.body > v4:Door.Open > v2.return",
        ],
        "2*( 3*( Door.Open(); ); Wheel.Stop(); );",
    ),
]


@pytest.mark.parametrize(("lines", "text"), [row[1:] for row in GRAPHS], ids=[row[0] for row in GRAPHS])
def test_a_graph_becomes_lll(lines: list[str], text: str | None) -> None:
    slots = {slot.name for slot in shipped().constructors["Wait"].slots}
    lines = [line.replace("time=", f"{slots.pop()}=") if "time=" in line else line for line in lines]
    if text is None:
        text = "*[Fault.IsRaised() | !(Fault.IsRaised())]( WAIT(1); );"
    assert " ".join(text_of(graph(*lines)).split()) == text


def test_every_vertex_leaves_its_id_on_what_it_became() -> None:
    program = graph(
        "start > v1:Repeat_Until > v2:Wheel.Advance > stop",
        "v3:No > v1.condition",
        "v4:Run.IsTrue > v3.condition",
        "v1.body > v5:Interrupt > v1.return",
        "v6:Wheel.Stop > v5.action",
        "v7:Captor.Value > v2.speed",
    )
    tree = translated(program).program
    assert {node.vertex for node in nodes(tree)} - {None} == {f"v{n}" for n in range(1, 8)}
    text = print_program(tree)
    places = {node.vertex: text[node.start : node.end] for node in nodes(tree) if isinstance(node, Call)}
    assert places["v4"] == "Run.IsTrue()"
    assert places["v6"] == "Wheel.Stop()"
    assert places["v7"] == "Captor.Value()"


# ---- constructors of one's own ----------------------------------------------------------------------------

BLINK = """
<constructor name="Blink">
  <number name="times" min="1" max="9" default="3"/>
  <number name="pause" default="5"/>
  <code>{times}*(Light.LightOn(); WAIT({pause}); Light.LightOff(); WAIT({pause}))</code>
</constructor>
"""


def test_a_template_larger_than_one_construct_is_filled() -> None:
    program = graph("start > v1:Blink times=4 pause=2 > v2:Blink > stop")
    text = """\
4*(
  Light.LightOn();
  WAIT(2);
  Light.LightOff();
  WAIT(2);
);
3*(
  Light.LightOn();
  WAIT(5);
  Light.LightOff();
  WAIT(5);
);
"""
    assert text_of(program, with_constructors(BLINK)) == text


def test_a_number_outside_its_slot_s_own_range_is_told() -> None:
    catalogue = with_constructors(BLINK)
    assert told(graph("start > v1:Blink times=9 > stop"), catalogue) == []
    assert told(graph("start > v1:Blink times=10 > stop"), catalogue) == [("not-a-number", ("v1",))]
    assert told(graph("start > v1:Blink times=0 > stop"), catalogue) == [("not-a-number", ("v1",))]


OWN = [
    (
        "several instructions",
        '<constructor name="Own"><number name="n"/><code>Door.Open(); WAIT({n}); Door.Close();</code></constructor>',
        ["start > v1:Own n=3 > v2:Wheel.Stop > stop"],
        "Door.Open(); WAIT(3); Door.Close(); Wheel.Stop();",
    ),
    (
        "a body and what follows it",
        '<constructor name="Own"><number name="n"/><flow name="body"/>'
        "<code>*[Run.IsTrue()]({body}; WAIT({n}))</code></constructor>",
        ["start > v1:Own n=3 > stop", "v1.body > v2:Wheel.Stop > v3:Door.Open > v1.return"],
        "*[Run.IsTrue()]( Wheel.Stop(); Door.Open(); WAIT(3); );",
    ),
    (
        "a body and what stands before it",
        '<constructor name="Own"><flow name="body"/><code>2*(Wheel.Stop(); {body})</code></constructor>',
        ["start > v1:Own > stop", "v1.body > v2:Door.Open > v1.return"],
        "2*( Wheel.Stop(); Door.Open(); );",
    ),
    (
        "a body with nothing around it but instructions",
        '<constructor name="Own"><flow name="body"/><code>Door.Open(); {body}; Door.Close();</code></constructor>',
        ["start > v1:Own > stop", "v1.body > v2:Wheel.Stop > v1.return"],
        "Door.Open(); Wheel.Stop(); Door.Close();",
    ),
    (
        "a repeated body and what follows it in each branch",
        '<constructor name="Own"><flow name="b" repeat="yes" least="2"/><code>//({b}; WAIT(1))</code></constructor>',
        ["start > v1:Own > stop", "v1.b.1 > v2:Wheel.Stop > v1.return", "v1.b.2 > v3:Door.Open > v1.return"],
        "//( Wheel.Stop(); WAIT(1);, Door.Open(); WAIT(1); );",
    ),
    (
        "two bodies as branches",
        '<constructor name="Own"><flow name="a"/><flow name="b"/><code>//({a}, {b}, WAIT(9))</code></constructor>',
        ["start > v1:Own > stop", "v1.a > v2:Wheel.Stop > v1.return", "v1.b > v3:Door.Open > v1.return"],
        "//( Wheel.Stop();, Door.Open();, WAIT(9); );",
    ),
    (
        "numbers as parameters",
        '<constructor name="Own"><number name="a" default="25"/><number name="s" default="9"/>'
        "<code>Motor.AbsoluteTurn({a}, {s})</code></constructor>",
        ["start > v1:Own a=50 > stop"],
        "Motor.AbsoluteTurn(50, 9);",
    ),
    (
        "a value typed in",
        '<constructor name="Own"><value name="s" default="9"/><code>Wheel.Advance({s})</code></constructor>',
        ["start > v1:Own s=8 > stop"],
        "Wheel.Advance(8);",
    ),
    (
        "a value that is read",
        '<constructor name="Own"><value name="s" default="9"/><code>Wheel.Advance({s})</code></constructor>',
        ["start > v1:Own s=8 > stop", "v2:Captor.Value > v1.s"],
        "Wheel.Advance(Captor.Value());",
    ),
    (
        "a condition among tests",
        '<constructor name="Own"><condition name="c"/><flow name="body"/>'
        "<code>[Run.IsTrue() &amp; ({c} | Fault.IsRaised())]({body})!(BREAK)</code></constructor>",
        ["start > v1:Own > stop", "v2:Flag.IsTrue > v1.c", "v1.body > v1.return"],
        "[Run.IsTrue() & (Flag.IsTrue() | Fault.IsRaised())]()!( BREAK; );",
    ),
    (
        "a condition of one's own",
        '<constructor name="Own"><condition name="a"/><condition name="b"/>'
        "<code>({a} | {b}) &amp; !({a2})</code></constructor>".replace("{a2}", "Flag.IsTrue()"),
        [
            "start > v1:When > stop",
            "v1.body > v1.return",
            "v2:Own > v1.condition",
            "v3:Run.IsTrue > v2.a",
            "v4:Button.IsPressed > v2.b",
        ],
        "<(Run.IsTrue() | Button.IsPressed()) & !(Flag.IsTrue())>();",
    ),
    (
        "a marked action of one's own",
        '<constructor name="Own"><action name="a"/><flow name="until"/><code>//({until}, °{a}°)</code></constructor>',
        ["start > v1:Own > stop", "v2:Wheel.Advance > v1.a", "v1.until > v3:Door.Open > v1.return"],
        "//( Door.Open();, °Wheel.Advance(50)°; );",
    ),
]


@pytest.mark.parametrize(("xml", "lines", "text"), [row[1:] for row in OWN], ids=[row[0] for row in OWN])
def test_a_constructor_of_one_s_own_is_filled(xml: str, lines: list[str], text: str) -> None:
    made = text_of(graph(*lines), with_constructors(xml))
    assert " ".join(made.split()) == text
    assert parse(made).diagnostics == []


# ---- notes --------------------------------------------------------------------------------------------------


def test_notes_become_comments_at_their_places() -> None:
    program = noted(
        graph(
            "start > v1:While > v2:Parallelism > stop",
            "v3:Run.IsTrue > v1.condition",
            "v1.body > v4:Wheel.Stop > v1.return",
            "v2.branch.1 > v5:Door.Open > v2.return",
            "v2.branch.2 > v6:Door.Close > v2.return",
        ),
        start=[Note("the beginning")],
        v1=[Note("two\nlines"), Note("in the head", "after"), Note("end of body", "in:body")],
        v3=[Note("about the test")],
        v4=[Note("slowly", "after")],
        v2=[Note("end of branch", "in:branch.2")],
        v6=[Note("closing")],
        stop=[Note("the end")],
    )
    text = """\
# the beginning
# two
# lines
# about the test
*[Run.IsTrue()](
  Wheel.Stop();  # slowly
  # end of body
);  # in the head
//(
  Door.Open();,
  # closing
  Door.Close();
  # end of branch
);
# the end
"""
    assert text_of(program) == text


def test_the_note_of_a_start_before_nothing_is_kept() -> None:
    assert text_of(noted(graph("start > stop"), start=[Note("a")], stop=[Note("b")])) == "# a\n# b\n"


def test_lines_of_a_note_behind_an_instruction_become_one() -> None:
    program = noted(graph("start > v1:Break > stop"), v1=[Note("a\nb", "after"), Note("c", "after")])
    assert text_of(program) == "BREAK;  # a b c\n"


def test_the_note_of_an_empty_branch_goes_above_its_parallel() -> None:
    program = noted(
        graph("start > v1:Parallelism > stop", "v1.branch.1 > v1.return", "v1.branch.2 > v2:Break > v1.return"),
        v1=[Note("nothing yet", "in:branch.1")],
    )
    assert text_of(program) == "# nothing yet\n//(\n  BREAK;\n);\n"


# ---- nesting ------------------------------------------------------------------------------------------------


def nested_loops(depth: int) -> list[str]:
    inner = [f"v{n}.body > v{n + 1}:Repetition count=1 > v{n}.return" for n in range(1, depth)]
    return ["start > v1:Repetition count=1 > stop", *inner, f"v{depth}.body > v{depth}.return"]


def nested_tests(depth: int) -> list[str]:
    inner = [f"v{n + 1}:No > v{n}.condition" for n in range(1, depth)]
    last = f"last:Run.IsTrue > v{depth}.condition"
    return ["start > w:When > stop", "w.body > w.return", "v1:No > w.condition", *inner, last]


def nested_values(depth: int) -> list[str]:
    return ["start > v0:Count.Set > stop", *(f"v{n + 1}:Count.Set > v{n}.value" for n in range(depth))]


def nested_parallels(depth: int) -> list[str]:
    inner = [f"v{n}.branch.1 > v{n + 1}:Parallelism > v{n}.return" for n in range(1, depth)]
    return ["start > v1:Parallelism > stop", *inner]


NESTS = [nested_loops, nested_tests, nested_values, nested_parallels]


@pytest.mark.parametrize("lines", NESTS)
def test_a_graph_at_the_nesting_limit_is_translated_to_a_text_that_reads(lines: object) -> None:
    assert callable(lines)
    program = graph(*lines(MAX_NESTING))
    with at_most_frames(850):  # of the host's 1000; doors, tests and debuggers need some too
        translation = translated(program)
        parsed = parse(print_program(translation.program))
        compile_lll(translation.program, shipped().robots["mini-robot"])
    assert translation.diagnostics == []
    assert parsed.diagnostics == []
    assert parsed.program == translation.program


@pytest.mark.parametrize("lines", NESTS)
@pytest.mark.parametrize("depth", [MAX_NESTING + 1, 5000])
def test_a_graph_beyond_the_nesting_limit_is_told_once(lines: object, depth: int) -> None:
    assert callable(lines)
    program = graph(*lines(depth))
    assert [code for code, _ in told(program)] == ["graph-too-deep"]


def test_templates_do_not_take_a_program_over_the_nesting_limit() -> None:
    deep = "2*(" * 30 + "{body}" + ")" * 30
    catalogue = with_constructors(f'<constructor name="Deep"><flow name="body"/><code>{deep}</code></constructor>')

    def chain(count: int) -> list[str]:
        inner = [f"v{n}.body > v{n + 1}:Deep > v{n}.return" for n in range(1, count)]
        return ["start > v1:Deep > stop", *inner, f"v{count}.body > v{count}.return"]

    assert told(graph(*chain(3)), catalogue) == []
    assert [code for code, _ in told(graph(*chain(4)), catalogue)] == ["graph-too-deep"]
    assert [code for code, _ in told(graph(*chain(90)), catalogue)] == ["graph-too-deep"]


def test_a_long_program_does_not_nest() -> None:
    chain = " > ".join(f"v{n}:Wheel.Stop" for n in range(5000))
    assert text_of(graph(f"start > {chain} > stop")).count("\n") == 5000
