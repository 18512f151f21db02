"""Fixes: where there is one right answer, doing it takes the problem away, in the text and in the graph."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.compiler.compilation import compile_program, compile_text
from kitrobot.diagnostics.model import Diagnostic, Fix, FixKind, Source
from kitrobot.graph.model import NEXT, Arc, Program, Vertex
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Robot


def mini() -> Robot:
    return load_catalogue().robot("mini-robot")


def mended(text: str, problem: Diagnostic) -> str:
    assert problem.fix is not None
    assert problem.place is not None
    lines = text.split("\n")
    place = problem.place
    starts = [sum(len(line) + 1 for line in lines[:number]) for number in range(len(lines))]
    start, end = starts[place.line - 1] + place.column - 1, starts[place.end_line - 1] + place.end_column - 1
    return text[:start] + problem.fix.text + text[end:]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("Wheel.Advanse(50);", "Wheel.Advance(50);"),
        ("Weel.Advance(50);", "Wheel.Advance(50);"),
        ("wheel.Stop();", "Wheel.Stop();"),
        ("Wheel.Advance(500);", "Wheel.Advance(100);"),
        ("Wheel.Advance();", "Wheel.Advance(50);"),
        ("Wheel.Advance(1, 2);", "Wheel.Advance(1);"),
        ("Wheel.Stop(3);", "Wheel.Stop();"),
        ("°Wheel.Advance(5)°;", "Wheel.Advance(5);"),
        ("*[Captor.LesThan(5)]( Wheel.Stop(); );", "*[Captor.LessThan(5)]( Wheel.Stop(); );"),
        ("Count.Set(Captor.Valeu());", "Count.Set(Captor.Value());"),
        ("Wheel.Stop() Door.Open();", "Wheel.Stop(); Door.Open();"),
        ("Motor.AbsoluteTurn(30);", "Motor.AbsoluteTurn(30, 50);"),
    ],
)
def test_in_a_text(text: str, wanted: str) -> None:
    compiled = compile_text(text, mini(), "p.lll")
    (problem,) = compiled.diagnostics
    after = mended(text, problem)
    assert after.split() == wanted.split()
    assert not compile_text(after, mini(), "p.lll").diagnostics


@pytest.mark.parametrize("text", ["Xyzzy.Advance(50);", "Wheel.Teleport();", "Weel.Teleport();", "Captor.Value();"])
def test_no_fix_where_there_is_no_one_right_answer(text: str) -> None:
    (problem,) = compile_text(text, mini(), "p.lll").diagnostics
    assert problem.fix is None


def program(element: str, **settings: str) -> Program:
    vertices = [Vertex("start", "Start"), Vertex("v1", element, settings), Vertex("stop", "Stop")]
    return Program("p", "mini-robot", vertices, [Arc("start", "v1"), Arc("v1", "stop", NEXT)])


def fixed(drawn: Program, problem: Diagnostic) -> Program:
    fix = problem.fix
    assert fix is not None
    assert problem.vertices == ("v1",)
    vertex = drawn.vertices[1]
    settings = dict(vertex.settings)
    if fix.kind is FixKind.ELEMENT:
        vertex = replace(vertex, element=fix.name)
    elif fix.kind is FixKind.SETTING:
        settings[fix.name] = fix.text
    elif fix.kind is FixKind.UNSET:
        del settings[fix.name]
    return replace(drawn, vertices=[drawn.vertices[0], replace(vertex, settings=settings), drawn.vertices[2]])


@pytest.mark.parametrize(
    ("drawn", "fix"),
    [
        (program("Wheel.Advanse", speed="50"), Fix("Wheel.Advance", FixKind.ELEMENT, "Wheel.Advance")),
        (program("Repetitoin", count="3"), Fix("Repetition", FixKind.ELEMENT, "Repetition")),
        (program("Wheel.Advance", speed="500"), Fix("100", FixKind.SETTING, "speed")),
        (program("Wheel.Advance", speed="-5"), Fix("0", FixKind.SETTING, "speed")),
        (program("Wheel.Advance", speed="999999"), Fix("65535", FixKind.SETTING, "speed")),
        (program("Wheel.Advance", speed="50", sped="5"), Fix("", FixKind.UNSET, "sped")),
    ],
)
def test_in_a_graph(drawn: Program, fix: Fix) -> None:
    catalogue = load_catalogue()
    problem, *others = compile_program(drawn, catalogue).diagnostics
    assert problem.fix == fix
    after = compile_program(fixed(drawn, problem), catalogue).diagnostics
    assert problem.message not in [item.message for item in after]
    assert len(after) <= len(others) + 1


def test_words_are_no_numbers() -> None:
    (problem,) = compile_program(program("Wheel.Advance", speed="fast"), load_catalogue()).diagnostics
    assert problem.fix is None


def test_places_are_those_of_the_text() -> None:
    text = "Wheel.Stop();\nWheel.Advanse(50);\n"
    (problem,) = compile_text(text, mini(), "p.lll").diagnostics
    assert mended(text, problem) == "Wheel.Stop();\nWheel.Advance(50);\n"
    assert Source("p.lll", text).position(text.index("Advanse")) == (2, 7)
