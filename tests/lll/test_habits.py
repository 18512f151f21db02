"""What people write who know another language is told once, where it stands, with what LLL has in its place."""

from __future__ import annotations

import pytest

from kitrobot.compiler.compilation import compile_text
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import Call
from kitrobot.primitives.catalogue import load_catalogue

HABITS = [
    ("[Captor < 20](Wheel.Stop(););", 9, "Captor.LessThan(20)"),
    ("[Captor.Value() < 20](Wheel.Stop(););", 17, "Captor.LessThan(20)"),
    ("[Captor == 20](Wheel.Stop(););", 9, "Captor.EqualTo(20)"),
    ("[Captor.Value() >= 20](Wheel.Stop(););", 17, "!(Captor.LessThan(20))"),
    ("[Captor.Value() != 20](Wheel.Stop(););", 17, "!(Captor.EqualTo(20))"),
    ("<Captor > 20>(Wheel.Stop(););", 9, "Captor.GreaterThan(20)"),
    ("<Captor.Value() > 20>(Wheel.Stop(););", 17, "Captor.GreaterThan(20)"),
    ("Count = Count + 1", 7, "Count.Add(1)"),
    ("Count=Count-2", 6, "Count.Sub(2)"),
    ("Count = 5", 7, "Count.Set(5)"),
    ("Count := 5", 7, "Count.Set(5)"),
    ("Count++", 6, "Count.Add(1)"),
    ("Count += 3", 7, "Count.Add(3)"),
    ("Count -= 3", 7, "Count.Sub(3)"),
    ("Flag.Set(true)", 10, "1 for true"),
    ("Flag.Set(False)", 10, "0 for false"),
    ("3 * Wheel.Stop()", 5, "( … )"),
    ("3x(Wheel.Stop(););", 2, "3*( … )"),
    ("repeat 3 (WAIT(1););", 1, "3*( … )"),
    ("for (i = 0; i < 3; i++) { Wheel.Stop(); }", 1, "3*( … )"),
    ("for i in range(3):\n  Wheel.Stop()", 1, "3*( … )"),
    ("while (true) {}", 1, "*( … )"),
    ("while True:\n  Wheel.Stop()", 1, "*( … )"),
    ("while (Button.IsPressed()) { Wheel.Stop(); WAIT(1); }", 1, "*[test]( … )"),
    ("*[true](WAIT(1););", 3, "*( … )"),
    ("*[1](WAIT(1););", 3, "*( … )"),
    ("*[](WAIT(1););", 3, "*( … )"),
    ("loop { Wheel.Stop(); }", 1, "*( … )"),
    ("if (Button.IsPressed()) { Wheel.Stop(); }", 1, "[test]( … )"),
    ("if (Button.IsPressed()) { Wheel.Stop(); } else { WAIT(1); }", 1, "[test]( … )!( … )"),
    ("if Button.IsPressed():\n  Wheel.Stop()", 1, "[test]( … )"),
    ("[Run.IsTrue()](WAIT(1);) else (WAIT(2););", 26, "!( … )"),
    ("[Run.IsTrue()]{ Wheel.Stop(); }", 15, "( )"),
    ("[Run.IsTrue() && Flag.IsTrue()](WAIT(1););", 16, "one &"),
    ("[Run.IsTrue() || Flag.IsTrue()](WAIT(1););", 16, "one |"),
    ("[Run.IsTrue() and Flag.IsTrue()](WAIT(1););", 15, "&"),
    ("[not Run.IsTrue()](WAIT(1););", 2, "!( … )"),
    ("[!Run.IsTrue()](WAIT(1););", 3, "!( … )"),
    ("//(WAIT(1);, °Wheel.Advance(50););", 14, "°Object.Method()°"),
    ("//(WAIT(1);, Wheel.Advance(50)°;);", 32, "°Object.Method()°"),
    ("// drive; now", 4, "a comment begins with #"),
    ("/* drive; now */", 1, "a comment begins with #"),
    ("-- drive", 1, "a comment begins with #"),
    ('Wheel.Advance("very fast")', 15, "no texts"),
    ("Wheel.Advance(1.5)", 15, "numbers are whole"),
    ("WAIT(0.5)", 6, "WAIT(10) is one second"),
    ("1.5*(WAIT(1););", 1, "numbers are whole"),
    ("Wheel.Advance(-5)", 15, "no sign"),
    ("WAIT(-1)", 6, "no sign"),
    ("Wheel.Advance(50%)", 17, "without a unit"),
    ("Wheel.Advance(Count + 1)", 21, "does not calculate"),
    ("Wheel.Advance(Count)", 20, "Count.Value()"),
    ("Wheel.Advance(speed=50)", 15, "without its name"),
    ("Wheel.Advance(۵۰)", 15, "write `50`"),
    ("Wheel.Advance（50）；", 14, "write `(50);`"),
    ("Wheel.Stop()؛", 13, "write `;`"),
    ("3×(Wheel.Stop(););", 2, "write `*`"),
    ("wait(10)", 1, "WAIT"),
    ("*(WAIT(1); break;)", 12, "BREAK"),
    ("sleep(1)", 1, "WAIT(10)"),
    ("stop()", 5, "Object.stop()"),
    ("Wheel.Advance 50", 15, "Wheel.Advance( … )"),
    ("{ Wheel.Stop(); WAIT(1); }", 1, "( )"),
]


@pytest.mark.parametrize(("text", "column", "help"), HABITS, ids=[row[0] for row in HABITS])
def test_a_habit_is_told_once_at_its_place_with_what_to_write(text: str, column: int, help: str) -> None:
    (told,) = compile_text(text, load_catalogue().robots["mini-robot"]).diagnostics
    assert told.place is not None
    assert (told.place.line, told.place.column) == (1, column)
    assert help in told.help


@pytest.mark.parametrize("text", [row[0] for row in HABITS])
def test_what_stands_around_a_habit_is_read(text: str) -> None:
    program = parse(f"first.one();\n{text}\n;last.one();").program
    assert program.items[0] == Call("first", "one")
    assert program.items[-1] == Call("last", "one")


NAMES = ["if", "while", "else", "true", "wait", "Break", "not", "sleep", "repeat"]


@pytest.mark.parametrize("name", NAMES)
def test_such_a_word_is_a_name_where_a_method_follows(name: str) -> None:
    assert parse(f"{name}.Go(1); [{name}.Is()](A.b({name}.Value()););").diagnostics == []
