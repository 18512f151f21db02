"""Every mistake of a text is reported where it stands, once, and the rest is read."""

from __future__ import annotations

import pytest

from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import Call, Conditional, Event, Repeat, Seq
from tests.lll.expectations import meets_expectations

TEN_MISTAKES = """\
Wheel.Advance(50;                         #! syntax@17 expected `,` or `)` after a parameter, found `;`
Light.LightOn();
Wheel Stop();                             #! syntax@7 expected `.` and a method, found a name `Stop`
[Button.IsPressed()(Light.LightOn(););    #! syntax@20 expected `&`, `|` or `]`, found `(`
*[Captor.LessThan(20) &](Wheel.Stop(););  #! syntax@24 expected a condition, found `]`
70000*(WAIT(1););                         #! number-too-large@1 expected a number from 0 to 65535, found 70000
WAIT(two);                                #! syntax@6 expected a number of time units, found a name `two`
//(
  Door.Open();,
  ° Wheel.Stop();                         #! not-closed@3 this `°` has no partner
);
Door.Close(]);                            #! syntax@12 expected a parameter, found `]`
<Button.IsPressed()> Light.LightOff();    #! syntax@22 expected `(`, found a call
§;                                        #! syntax@1 expected an instruction, found `§`
Wheel.Stop(););                           #! syntax@14 `)` closes or separates nothing here
BREAK.it();                               #! reserved-word@1 `BREAK` is a word of the language
3(Wheel.Stop(););                         #! syntax@2 expected `*` after the number of times, found `(`
[!Button.IsPressed()](Wheel.Stop(););     #! syntax@3 expected `(`, found a call
Light.LightOff();
"""


def test_a_text_full_of_mistakes_tells_each_at_its_place_and_nothing_more() -> None:
    meets_expectations(TEN_MISTAKES, parse(TEN_MISTAKES).diagnostics)


def test_what_is_right_between_mistakes_is_read() -> None:
    calls = [f"{node.object}.{node.method}" for node in parse(TEN_MISTAKES).program.items if isinstance(node, Call)]
    assert [call for call in calls if call.startswith("Light")] == ["Light.LightOn", "Light.LightOff"]
    assert "Wheel.Stop" in calls


MISTAKES = [
    ("an instruction that begins with nothing", "a.b();\n-5;  #! syntax@1 expected an instruction, found `-5`"),
    ("a name alone", "a;  #! syntax@2 expected `.` and a method, found `;`"),
    ("a method alone", ".b();  #! syntax@1 expected an instruction, found `.`"),
    ("an object and a dot", "a.;  #! syntax@3 expected a method's name, found `;`"),
    ("a call without parentheses", "a.b;  #! syntax@4 expected `(`, found `;`"),
    ("two dots", "a.b.c();  #! syntax@3 expected a method's name and its parameters, found a call"),
    ("a comma too many", "a.b(1,);  #! syntax@7 expected a parameter, found `)`"),
    ("a parameter left out", "a.b(,1);  #! syntax@5 expected a parameter, found `,`"),
    ("a negative parameter", "a.b(-1);  #! syntax@5 expected a parameter, found `-1`"),
    ("a decimal parameter", "a.b(1.5);  #! syntax@5 expected a whole number, found `1.5`"),
    ("a mark alone", "°;  #! syntax@2 expected a call, found `;`"),
    ("two marks around nothing", "°°;  #! syntax@2 expected a call, found `°`"),
    ("a mark around a loop", "°2*()°;  #! syntax@2 expected a call, found a number `2`"),
    ("a mark without partner", "°a.b();  #! not-closed@1 this `°` has no partner"),
    ("a loop without brackets", "*a.b();  #! syntax@2 expected `[` or `(` after `*`, found a call"),
    ("a mistake in a loop without end", "*(a.b(; c.d(););  #! syntax@7 expected a parameter, found `;`"),
    ("a loop without end or body", "*;  #! syntax@2 expected `[` or `(` after `*`, found `;`"),
    ("a number alone", "3;  #! syntax@2 expected `*` after the number of times, found `;`"),
    ("a loop without body", "3*;  #! syntax@3 expected `(`, found `;`"),
    ("a while without condition", "*[]();  #! syntax@3 expected a condition, found `]`"),
    ("a while without body", "*[a.b()];  #! syntax@9 expected `(`, found `;`"),
    ("a number as a condition", "[1]();  #! syntax@2 expected a condition, found a number `1`"),
    ("an `&` too many", "[a.b() && c.d()]();  #! syntax@9 expected a condition, found `&`"),
    ("a not without parentheses", "[!a.b()]();  #! syntax@3 expected `(`, found a call"),
    ("an else without a body", "[a.b()]()!;  #! syntax@11 expected `(`, found `;`"),
    ("an else alone", "!(a.b(););  #! syntax@1 expected an instruction, found `!`"),
    ("an event without condition", "<>();  #! syntax@2 expected a condition, found `>`"),
    ("a comma in a body", "2*(a.b();, c.d(););  #! syntax@10 `,` separates branches, and this is not a parallel"),
    (
        "commas in a body",
        "2*(a.b();, c.d();, e.f(););  #! syntax@10 `,` separates branches, and this is not a parallel",
    ),
    ("a comma in the program", "a.b();, c.d();  #! syntax@7 `,` closes or separates nothing here"),
    ("a parallel without branches", "//;  #! syntax@3 expected `(`, found `;`"),
    ("one slash", "/(a.b(););  #! syntax@1 expected an instruction, found `/`"),
    ("a wait without time", "WAIT();  #! syntax@6 expected a number of time units, found `)`"),
    ("a wait for a value", "WAIT(a.b());  #! syntax@6 expected a number of time units, found a call"),
    ("a wait for two numbers", "WAIT(1, 2);  #! syntax@7 expected `)`, found `,`"),
    ("a wait without parentheses", "WAIT 5;  #! syntax@6 expected `(`, found a number `5`"),
    ("parentheses behind BREAK", "BREAK();  #! syntax@6 expected an instruction, found `(`"),
    ("a bracket that was never opened", "a.b());  #! syntax@6 `)` closes or separates nothing here"),
    ("parentheses around instructions", "(a.b(););  #! syntax@1 expected an instruction, found `(`"),
    ("a hole", "{x};  #! hole-in-program@1 `{x}` is a hole"),
    ("a hole for a number", "{x}*();  #! hole-in-program@1 `{x}` is a hole"),
    ("a hole for a parameter", "a.b({x});  #! hole-in-program@5 `{x}` is a hole"),
    ("a brace", "a.b(); }  #! syntax@8 expected an instruction, found `}`"),
    ("a quote", 'a.b("x");  #! syntax@5 expected a parameter, found `"x"`'),
    ("a mistake in the parameters of a test", "[a.b(]();  #! syntax@6 expected a parameter, found `]`"),
    ("a mistake in the parameters of an event's test", "<a.b(1,>();  #! syntax@8 expected a parameter, found `>`"),
    ("a loop without end that is never closed", "*(a.b();  #! not-closed@2 this `(` is never closed"),
    ("a body that is never closed", "2*(a.b();  #! not-closed@3 this `(` is never closed"),
    ("two bodies that are never closed", "2*(a.b();\n3*(c.d();  #! not-closed@3 this `(` is never closed"),
    ("a condition that is never closed", "[a.b()  #! not-closed@1 this `[` is never closed"),
    ("parameters that are never closed", "a.b(c.d()  #! not-closed@4 this `(` is never closed"),
]


@pytest.mark.parametrize("text", [row[1] for row in MISTAKES], ids=[row[0] for row in MISTAKES])
def test_a_mistake_is_told_once_at_its_place(text: str) -> None:
    meets_expectations(text, parse(text).diagnostics)


@pytest.mark.parametrize(
    "text",
    [row[1] for row in MISTAKES if "never closed" not in row[1]],
    ids=[row[0] for row in MISTAKES if "never closed" not in row[1]],
)
def test_what_stands_before_and_behind_a_mistake_is_read(text: str) -> None:
    program = parse(f"first.one();\n{text}\n;last.one();").program
    assert program.items[0] == Call("first", "one")
    last = program.items[-1]
    assert isinstance(last, Call)
    assert (last.object, last.method) == ("last", "one")


def test_a_mistake_in_a_branch_leaves_the_other_branches() -> None:
    parsed = parse("//(a.b();, 3;, c.d(););")
    assert [item.code for item in parsed.diagnostics] == ["syntax"]
    (parallel,) = parsed.program.items
    assert parallel == parse("//(a.b();, c.d(););").program.items[0]


def test_a_mistake_in_a_condition_leaves_its_body() -> None:
    parsed = parse("[a.b() c.d()](e.f(););")
    (node,) = parsed.program.items
    assert isinstance(node, Conditional)
    assert node.then == Seq([Call("e", "f")])


def test_a_mistake_in_parameters_leaves_the_next_instruction() -> None:
    parsed = parse("a.b(1 2); c.d();")
    assert len(parsed.diagnostics) == 1
    assert parsed.program.items[-1] == Call("c", "d")


def test_what_is_cut_off_at_the_end_of_the_text_keeps_what_was_read() -> None:
    parsed = parse("2*(a.b(); 3*(c.d();")
    assert parsed.program == Seq([Repeat(2, Seq([Call("a", "b"), Repeat(3, Seq([Call("c", "d")]))]))])
    assert [item.message for item in parsed.diagnostics] == ["this `(` is never closed"]


@pytest.mark.parametrize(
    "text",
    [
        "[[a.b()](c.d();)](e.f(););",
        "[ [a.b()](c.d();)!(x.y();) ](e.f(););",
        "*[[a.b()](c.d();)](e.f(););",
        "<[a.b()](c.d();)>(e.f(););",
    ],
)
def test_a_conditional_in_a_condition_is_recognised_and_its_test_kept(text: str) -> None:
    parsed = parse(text)
    (mistake,) = parsed.diagnostics
    assert mistake.code == "conditional-as-condition"
    assert mistake.message == "a whole conditional `[…](…)` cannot be a condition"
    assert mistake.help == "write only the test that stands in its [ ]"
    (node,) = parsed.program.items
    assert not isinstance(node, Call)
    assert getattr(node, "condition", None) == Call("a", "b")


def test_a_conditional_is_recognised_beside_other_tests() -> None:
    parsed = parse("[x.y() & [a.b()](c.d();)](e.f(););")
    assert [item.code for item in parsed.diagnostics] == ["conditional-as-condition"]
    place = parsed.diagnostics[0].place
    assert place is not None
    assert (place.column, place.end_column) == (10, 25)


def test_the_end_of_the_text_is_a_place_inside_the_text() -> None:
    parsed = parse("a.b(); c")
    place = parsed.diagnostics[0].place
    assert place is not None
    assert (place.line, place.column, place.end_line, place.end_column) == (1, 9, 1, 9)


def test_the_file_s_name_is_in_every_place() -> None:
    assert {item.place.file for item in parse(TEN_MISTAKES, "mine.lll").diagnostics if item.place} == {"mine.lll"}


def test_an_event_keeps_its_body_when_its_test_cannot_be_read() -> None:
    (node,) = parse("<a.b(>(c.d(););").program.items
    assert isinstance(node, Event)
    assert node.body == Seq([Call("c", "d")])
