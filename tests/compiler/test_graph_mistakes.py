"""What can be wrong with a graph: each is told with its vertices and arcs, and the rest is translated."""

from __future__ import annotations

import pytest

from kitrobot.compiler.compilation import compile_program
from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.graph.model import Arc, Program, Vertex
from tests.compiler.graphs import graph, lines_of, shipped, told, translated

MISTAKES = [
    # start and stop
    ("no start", ["stop:Stop"], [("start-stop", ())], ""),
    ("no stop", ["start:Start > v1:Wheel.Stop"], [("start-stop", ()), ("slot-not-closed", ("v1",))], "Wheel.Stop();"),
    (
        "two starts",
        ["start:Start > stop:Stop", "other:Start > v1:Wheel.Stop"],
        [("start-stop", ("start", "other")), ("parked", ("other",))],
        "",
    ),
    (
        "two stops",
        ["start:Start > v1:Wheel.Stop > stop:Stop", "other:Stop"],
        [("start-stop", ("stop", "other")), ("parked", ("other",))],
        "Wheel.Stop();",
    ),
    ("no vertices at all", [], [("start-stop", ()), ("start-stop", ())], ""),
    # ids and arcs
    (
        "an unknown constructor as a condition",
        ["start > v1:While > stop", "v1.body > v1.return", "v2:Perhaps > v1.condition"],
        [("unknown-element", ("v2",))],
        "*[]();",
    ),
    (
        "an id used twice",
        ["start > v1:Wheel.Stop > stop", "v1:Door.Open"],
        [("same-id", ("v1",))],
        "Wheel.Stop();",
    ),
    ("an arc to nowhere", ["start > v1:Wheel.Stop > stop", "v1 > v9"], [("dangling-arc", ())], "Wheel.Stop();"),
    ("an arc from nowhere", ["start > stop", "v9 > stop"], [("dangling-arc", ())], ""),
    (
        "an arc from a port that is not there",
        ["start > v1:Wheel.Stop > stop", "v1.body > stop"],
        [("dangling-arc", ("v1",))],
        "Wheel.Stop();",
    ),
    (
        "an arc to a port that is not there",
        ["start > v1:Wheel.Stop > stop", "v2:Captor.Value > v1.speed"],
        [("dangling-arc", ("v1",)), ("parked", ("v2",))],
        "Wheel.Stop();",
    ),
    (
        "an arc into start",
        ["start > v1:Wheel.Stop > start"],
        [("dangling-arc", ("start",)), ("slot-not-closed", ("v1",))],
        "Wheel.Stop();",
    ),
    ("an arc out of stop", ["start > stop > v1:Wheel.Stop"], [("dangling-arc", ("stop",)), ("parked", ("v1",))], ""),
    (
        "a return of what has no bodies",
        ["start > v1:Wait > v1.return"],
        [("dangling-arc", ("v1",)), ("slot-not-closed", ("v1",))],
        "WAIT(10);",
    ),
    (
        "a branch whose number is no number",
        ["start > v1:Parallelism > stop", "v1.branch.x > v1.return"],
        [("dangling-arc", ("v1",))],
        "//();",
    ),
    (
        "a branch without number",
        ["start > v1:Parallelism > stop", "v1.branch > v1.return"],
        [("dangling-arc", ("v1",))],
        "//();",
    ),
    (
        "a number on a slot that is not repeated",
        ["start > v1:Repetition > stop", "v1.body > v1.return", "v1.body.1 > v1.return"],
        [("dangling-arc", ("v1",))],
        "10*();",
    ),
    (
        "two arcs out of one port",
        ["start > v1:Wheel.Stop > stop", "start > v2:Door.Open > stop"],
        [("two-arcs", ("start",)), ("parked", ("v2",))],
        "Wheel.Stop();",
    ),
    (
        "two tests in one slot",
        [
            "start > v1:When > stop",
            "v1.body > v1.return",
            "v2:Run.IsTrue > v1.condition",
            "v3:Flag.IsTrue > v1.condition",
        ],
        [("two-arcs", ("v3",)), ("parked", ("v3",))],
        "<Run.IsTrue()>();",
    ),
    # ways that do not close
    ("a program that never ends", ["start > v1:Wheel.Stop"], [("slot-not-closed", ("v1",))], "Wheel.Stop();"),
    ("a start that leads nowhere", ["start:Start", "stop:Stop"], [("slot-not-closed", ("start",))], ""),
    ("a body that is not there", ["start > v1:Repetition > stop"], [("slot-not-closed", ("v1",))], "10*();"),
    (
        "a body that does not come back",
        ["start > v1:Repetition > v3:Door.Open > stop", "v1.body > v2:Wheel.Stop"],
        [("slot-not-closed", ("v2",))],
        "10*( Wheel.Stop(); ); Door.Open();",
    ),
    (
        "a body that goes to stop",
        ["start > v1:Repetition > v3:Door.Open > stop", "v1.body > v2:Wheel.Stop > stop"],
        [("slot-not-closed", ("v2",))],
        "10*( Wheel.Stop(); ); Door.Open();",
    ),
    # wrong ways
    (
        "a body that comes back to another",
        [
            "start > v1:Repetition > v2:Repetition > stop",
            "v1.body > v3:Wheel.Stop > v2.return",
            "v2.body > v2.return",
        ],
        [("wrong-way", ("v3", "v2"))],
        "10*( Wheel.Stop(); ); 10*();",
    ),
    (
        "an inner body that comes back to the outer one",
        ["start > v1:Repetition > stop", "v1.body > v2:Repetition > v1.return", "v2.body > v3:Wheel.Stop > v1.return"],
        [("wrong-way", ("v3", "v1"))],
        "10*( 10*( Wheel.Stop(); ); );",
    ),
    (
        "a return of what it is not inside of",
        ["start > v1:Wheel.Stop > v2.return", "v2:Repetition > stop", "v2.body > v2.return"],
        [("wrong-way", ("v1", "v2")), ("parked", ("v2",))],
        "Wheel.Stop();",
    ),
    (
        "an arc into the middle of a body",
        ["start > v1:Repetition > v2", "v1.body > v2:Wheel.Stop > v3:Door.Open > v1.return"],
        [("wrong-way", ("v1", "v2"))],
        "10*( Wheel.Stop(); Door.Open(); );",
    ),
    (
        "an arc into the body of one that was passed",
        ["start > v1:Repetition > v4:Light.LightOn > v2", "v1.body > v2:Wheel.Stop > v1.return"],
        [("wrong-way", ("v4", "v2"))],
        "10*( Wheel.Stop(); ); Light.LightOn();",
    ),
    (
        "a loop made of arcs",
        ["start > v1:Wheel.Stop > v2:Door.Open > v1"],
        [("wrong-way", ("v2", "v1"))],
        "Wheel.Stop(); Door.Open();",
    ),
    ("a loop on itself", ["start > v1:Wheel.Stop > v1"], [("wrong-way", ("v1", "v1"))], "Wheel.Stop();"),
    (
        "two branches that meet",
        [
            "start > v1:Parallelism > stop",
            "v1.branch.1 > v2:Wheel.Stop > v4:Light.LightOn > v1.return",
            "v1.branch.2 > v3:Door.Open > v4",
        ],
        [("wrong-way", ("v3", "v4"))],
        "//( Wheel.Stop(); Light.LightOn();, Door.Open(); );",
    ),
    (
        "one that stands in the flow and fills a slot",
        ["start > v1:Wheel.Advance > v2:Count.Set > stop", "v3:Captor.Value > v1.speed", "v3 > v2.value"],
        [("two-arcs", ("v3",))],
        "Wheel.Advance(Captor.Value()); Count.Set(0);",
    ),
    (
        "a flow that ends in a slot",
        ["start > v1:Captor.Value > v2.speed", "v2:Wheel.Advance > stop"],
        [("wrong-way", ("v1", "v2")), ("parked", ("v2",))],
        "Captor.Value();",
    ),
    (
        "a test that fills its own slot",
        ["start > v1:When > stop", "v1.body > v1.return", "v2:No > v1.condition", "v3:Run.IsTrue > v3.value"],
        [("dangling-arc", ("v3",)), ("empty-slot", ("v2",)), ("parked", ("v3",))],
        "<!()>();",
    ),
    # slots
    (
        "an empty condition",
        ["start > v1:While > v2:Wheel.Stop > stop", "v1.body > v1.return"],
        [("empty-slot", ("v1",))],
        "*[](); Wheel.Stop();",
    ),
    ("an empty action", ["start > v1:Interrupt > stop"], [("empty-slot", ("v1",))], "°°;"),
    (
        "half of a joined test",
        ["start > v1:When > stop", "v1.body > v1.return", "v2:And > v1.condition", "v3:Run.IsTrue > v2.left"],
        [("empty-slot", ("v2",))],
        "<Run.IsTrue() & >();",
    ),
    # numbers
    *(
        (
            f"the number `{text}`",
            [f"start > v1:Wheel.Advance speed={text} > stop"],
            [("not-a-number", ("v1",))],
            "Wheel.Advance(0);",
        )
        for text in ("-1", "1.5", "", "abc", "٣", "65536", "9" * 50, "²", "0x1")
    ),
    (
        "a number of times that is none",
        ["start > v1:Repetition count=many > stop", "v1.body > v1.return"],
        [("not-a-number", ("v1",))],
        "0*();",
    ),
    (
        "a setting of no parameter",
        ["start > v1:Wheel.Advance sped=5 > stop"],
        [("not-a-number", ("v1",))],
        "Wheel.Advance(50);",
    ),
    # places
    (
        "a condition in the flow",
        ["start > v1:And > v2:Wheel.Stop > stop"],
        [("wrong-place", ("v1",))],
        "Wheel.Stop();",
    ),
    ("a Branch in the flow", ["start > v1:Branch > v2:Wheel.Stop > stop"], [("wrong-place", ("v1",))], "Wheel.Stop();"),
    (
        "a loop as a condition",
        ["start > v1:When > stop", "v1.body > v1.return", "v2:Repetition > v1.condition"],
        [("wrong-place", ("v2",))],
        "<>();",
    ),
    (
        "a joined test as a number",
        ["start > v1:Wheel.Advance > stop", "v2:And > v1.speed"],
        [("wrong-place", ("v2",))],
        "Wheel.Advance();",
    ),
    # unknown elements
    (
        "an unknown call",
        ["start > v1:Gripper.Grab force=5 > v2:Wheel.Stop > stop"],
        [("unknown-element", ("v1",))],
        "Gripper.Grab(5); Wheel.Stop();",
    ),
    (
        "an unknown constructor",
        ["start > v1:Blink > v2:Wheel.Stop > stop"],
        [("unknown-element", ("v1",))],
        "; Wheel.Stop();",
    ),
    (
        "an unknown constructor keeps what hangs on it",
        [
            "start > v1:Twinkle > v2:Wheel.Stop > stop",
            "v1.body > v3:Light.LightOn > v4:Light.LightOff > v1.return",
            "v5:Run.IsTrue > v1.condition",
        ],
        [("unknown-element", ("v1",))],
        "; Wheel.Stop();",
    ),
    (
        "an unknown element that is parked",
        ["start > stop", "v1:Gripper.Grab"],
        [("unknown-element", ("v1",)), ("parked", ("v1",))],
        "",
    ),
    # parked
    ("a parked vertex", ["start > stop", "v1:Wheel.Stop"], [("parked", ("v1",))], ""),
    ("a parked chain is told once", ["start > stop", "v1:Wheel.Stop > v2:Door.Open"], [("parked", ("v1",))], ""),
    (
        "a parked constructor with all that is in it",
        ["start > stop", "v2:Run.IsTrue > v1.condition", "v1:While", "v1.body > v3:Wheel.Stop > v1.return"],
        [("parked", ("v1",))],
        "",
    ),
    (
        "two parked pieces",
        ["start > stop", "v1:Wheel.Stop", "v2:Door.Open"],
        [("parked", ("v1",)), ("parked", ("v2",))],
        "",
    ),
    ("a parked ring is told once", ["start > stop", "v1:Wheel.Stop > v2:Door.Open > v1"], [("parked", ("v1",))], ""),
    (
        "tests that fill each other",
        ["start > stop", "v1:No > v2.condition", "v2:No > v1.condition"],
        [("parked", ("v1",))],
        "",
    ),
    (
        "a chain that leads into the program",
        ["start > v1:Wheel.Stop > stop", "v2:Door.Open > v1"],
        [("parked", ("v2",))],
        "Wheel.Stop();",
    ),
]


@pytest.mark.parametrize(
    ("lines", "diagnostics", "text"), [row[1:] for row in MISTAKES], ids=[row[0] for row in MISTAKES]
)
def test_a_mistake_is_told_and_the_rest_translated(
    lines: list[str], diagnostics: list[tuple[str, tuple[str, ...]]], text: str
) -> None:
    own_ends = not lines or any(":Start" in line or ":Stop" in line for line in lines)
    program = graph(*lines, ends=not own_ends)
    assert sorted(told(program)) == sorted(diagnostics)
    assert lines_of(program) == text


@pytest.mark.parametrize("lines", [row[1] for row in MISTAKES], ids=[row[0] for row in MISTAKES])
def test_a_graph_with_mistakes_never_makes_an_image_unless_they_are_hints(lines: list[str]) -> None:
    own_ends = not lines or any(":Start" in line or ":Stop" in line for line in lines)
    compiled = compile_program(graph(*lines, ends=not own_ends), shipped())
    assert compiled.ok == all(not item.is_error for item in compiled.diagnostics)
    assert all(item.program == "p" for item in compiled.diagnostics)
    assert len({(item.message, item.vertices) for item in compiled.diagnostics}) == len(compiled.diagnostics)


def test_an_unknown_call_is_told_once_when_its_program_is_compiled() -> None:
    program = graph("start > v1:Whel.Stop > v2:Wheel.Stopp > stop")
    compiled = compile_program(program, shipped())
    assert [(item.code, item.help) for item in compiled.diagnostics] == [
        ("unknown-element", "did you mean Wheel.Stop?"),
        ("unknown-element", "did you mean Wheel.Stop?"),
    ]


def test_an_unknown_constructor_comes_with_the_nearest_name() -> None:
    (mistake,) = translated(graph("start > v1:Repetitions > stop")).diagnostics
    assert mistake.help == "did you mean Repetition?"
    assert mistake.message == "`Repetitions` is not in the constructors' XML"


def test_what_is_wrong_with_the_meaning_of_a_graph_names_its_vertices() -> None:
    program = graph(
        "start > v1:Wheel.Advance speed=101 > v2:When > stop", "v3:Count.Value > v2.condition", "v2.body > v2.return"
    )
    compiled = compile_program(program, shipped())
    assert [(item.code, item.vertices) for item in compiled.diagnostics] == [
        ("out-of-range", ("v1",)),
        ("value-for-test", ("v3",)),
    ]


def test_a_program_for_a_robot_that_is_not_there_is_refused() -> None:
    with pytest.raises(KitRobotError, match="there is no robot named mini-robt") as caught:
        graph_to_lll(graph("start > stop", robot="mini-robt"), shipped())
    assert caught.value.help == "did you mean mini-robot?"


def test_many_mistakes_are_all_told() -> None:
    program = graph(
        "start > v1:Wheel.Advance speed=x > v2:While > v3:Gripper.Grab > v4:And > v5:Interrupt > stop",
        "v2.body > v6:Door.Open > stop",
        "v7:Wheel.Stop",
        "v9 > v1",
    )
    program.vertices.append(Vertex("v1", "Door.Close"))
    codes = sorted(code for code, _ in told(program))
    assert codes == [
        "dangling-arc",
        "empty-slot",
        "empty-slot",
        "not-a-number",
        "parked",
        "same-id",
        "slot-not-closed",
        "unknown-element",
        "wrong-place",
    ]


@pytest.mark.parametrize("port", ["next", "in", "return", "", "branch.0", "branch.99999", "branch.1.1", "x" * 1000])
@pytest.mark.parametrize(
    "element", ["Start", "Stop", "While", "Parallelism", "Wheel.Stop", "Nothing", "", ".", "a.", ".b"]
)
def test_odd_ports_and_elements_are_told_and_never_raise(port: str, element: str) -> None:
    program = Program("p", "mini-robot", [Vertex("start", "Start"), Vertex("stop", "Stop"), Vertex("v", element)])
    program.arcs = [Arc("start", "v"), Arc("v", "stop"), Arc("v", "v", port, "return"), Arc("v", "v", "next", port)]
    compiled = compile_program(program, shipped())
    assert not compiled.ok
