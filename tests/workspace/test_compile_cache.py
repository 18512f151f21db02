"""Programs that were compiled are kept, and never stand for another program or for other parts."""

from __future__ import annotations

from dataclasses import replace

from kitrobot.compiler.compilation import compile_program
from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.graph.model import Note, Program
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.own_xml import OwnVariable, read_own
from kitrobot.workspace.compile_cache import MOST_STATES, CompileCache
from tests.compiler.graphs import graph, shipped


def blink(*, wait: int = 2) -> Program:
    return graph(f"start > a:Light.LightOn > b:Wait duration={wait} > stop")


def test_the_same_program_is_found_again_with_all_that_was_made_of_it() -> None:
    kept = CompileCache()
    first = kept.of(blink(), shipped())
    again = kept.of(blink(), shipped())
    assert again is first
    assert again.compiled is first.compiled
    assert again.compiled == compile_program(blink(), shipped())


def test_another_word_anywhere_in_a_program_is_another_program() -> None:
    kept = CompileCache()
    program = blink()
    vertex = program.vertices[-1]
    others = [
        replace(program, name="other"),
        replace(program, target="carrier"),
        replace(program, arcs=program.arcs[:-1]),
        replace(program, arcs=[replace(program.arcs[0], at="return"), *program.arcs[1:]]),
        replace(program, vertices=program.vertices[::-1]),
        *(
            replace(program, vertices=[*program.vertices[:-1], replace(vertex, **change)])
            for change in (
                {"id": "x"},
                {"element": "Break"},
                {"settings": {"duration": "3"}},
                {"settings": {"duration": ""}},
                {"notes": [Note("duration")]},
                {"unknown": "<x/>"},
            )
        ),
    ]
    for one in others:
        first = kept.of(program, shipped())
        assert kept.of(one, shipped()) is not first
        assert kept.of(blink(), shipped()) is first


def test_the_order_of_settings_counts_as_it_does_in_the_text_of_a_call_that_nobody_knows() -> None:
    kept = CompileCache()
    texts = []
    for settings in ({"a": "1", "b": "2"}, {"b": "2", "a": "1"}):
        program = graph("start > a:Lamp.Glow > stop")
        program.vertices = [replace(one, settings=settings) if one.id == "a" else one for one in program.vertices]
        texts.append(kept.of(program, shipped()).compiled.source.text)
    assert texts == ["Lamp.Glow(1, 2);\n", "Lamp.Glow(2, 1);\n"]


def test_parts_that_were_read_anew_are_other_parts() -> None:
    kept = CompileCache()
    assert kept.of(blink(), load_catalogue()) is not kept.of(blink(), load_catalogue())


def test_the_same_parts_of_a_mission_extend_a_catalogue_once_and_others_anew() -> None:
    kept, common = CompileCache(), shipped()
    one, other = variable("Laps"), variable("Turns")
    extended = kept.catalogue(common, [], [one])
    assert kept.catalogue(common, [], [one]) is extended
    assert "Laps" in objects(extended)
    for variables in ([other], [one, other], [], [replace(one)]):
        assert objects(kept.catalogue(common, [], variables)) == objects(common.extended([], variables))
        assert kept.catalogue(common, [], variables) is not extended
    assert kept.catalogue(load_catalogue(), [], [one]) is not extended


def test_what_is_kept_has_a_limit_and_the_oldest_goes_first() -> None:
    program = blink()
    size = len(program.vertices)
    kept = CompileCache(most_vertices=2 * size)
    first, second = kept.of(program, shipped()), kept.of(blink(wait=3), shipped())
    assert kept.of(program, shipped()) is first
    kept.of(blink(wait=4), shipped())
    assert kept.of(program, shipped()) is first
    assert kept.of(blink(wait=3), shipped()) is not second


def test_of_one_program_the_newest_states_are_kept() -> None:
    kept = CompileCache()
    states = [kept.of(blink(wait=wait), shipped()) for wait in range(1, MOST_STATES + 2)]
    assert kept.of(replace(blink(), name="other"), shipped()) not in states
    found = [kept.of(blink(wait=wait), shipped()) for wait in range(2, MOST_STATES + 2)]
    assert all(one is other for one, other in zip(found, states[1:], strict=True))
    assert kept.of(blink(wait=1), shipped()) is not states[0]


def test_a_program_beyond_the_limit_is_compiled_all_the_same() -> None:
    kept = CompileCache(most_vertices=1)
    assert kept.of(blink(), shipped()).compiled.ok


def test_a_translation_that_is_there_is_used() -> None:
    translation = graph_to_lll(blink(), shipped())
    assert CompileCache().of(blink(), shipped(), translation).translation is translation


def variable(name: str) -> OwnVariable:
    made, problems = read_own([f'<variable robot="mini-robot" name="{name}" max="9"/>'], "variable")
    assert isinstance(made, OwnVariable), problems
    return made


def objects(catalogue: Catalogue) -> set[str]:
    return {one for one, _ in catalogue.robot("mini-robot").calls}
