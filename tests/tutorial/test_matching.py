"""What a pattern finds in a program and what it does not: one by one, and on random programs."""

from __future__ import annotations

import copy
import random
from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.lll.parse_results import parse, parse_team, parse_template
from kitrobot.lll.tree import Call, Hole, Number, Repeat, Seq, Wait
from kitrobot.lll.walk import nodes
from kitrobot.tutorial.model import Pattern, Step, Tutorial
from kitrobot.tutorial.pattern_matcher import fits, steps_fit
from tests.counting import MOST, growth
from tests.strategies import random_program, shipped_robots


def pattern(code: str, whole: bool = False, **ranges: tuple[int, int]) -> Pattern:
    template, problems = parse_template(code)
    assert template is not None
    assert problems == []
    return Pattern(template, whole, ranges=ranges)


def program(text: str) -> Seq:
    parsed = parse(text)
    assert parsed.ok
    return parsed.program


CONTAINED = [
    # as it was asked, and more than was asked
    ("Wheel.Advance({speed})", "Wheel.Advance(40);"),
    ("Wheel.Advance({speed})", "Light.LightOn(); 4*(WAIT(1); [Button.IsPressed()](Wheel.Advance(1)););"),
    ("Wheel.Advance({s}); Wheel.Stop()", "Wheel.Advance(40); WAIT(10); Wheel.Stop(); Light.LightOn();"),
    ("Wheel.Advance({s}); WAIT({d})", "4*(Wheel.Advance(40)); WAIT(10);"),
    ("Wheel.Advance({s})", "°Wheel.Advance(40)°;"),
    # the right ways to write a loop
    (
        "4*(Wheel.Advance({s}); Motor.AbsoluteTurn({a}, {t}))",
        "4*(Wheel.Advance(4); WAIT(2); Motor.AbsoluteTurn(25, 9));",
    ),
    ("4*(Wheel.Advance({s}))", "Light.LightOn(); 4*(Light.LightOff(); 2*(Wheel.Advance(4));); Wheel.Stop();"),
    ("*[{c}]()", "*[Captor.LessThan(3)](Wheel.Stop());"),
    # a test may be a side of a longer one, in any order
    ("*[Captor.GreaterThan({d})]({b})", "*[Button.IsPressed() & Captor.GreaterThan(30)](WAIT(1));"),
    ("*[Captor.GreaterThan({d}) | Button.IsPressed()]()", "*[Button.IsPressed() | Captor.GreaterThan(30)](WAIT(1));"),
    ("Captor.GreaterThan({d}) & {more}", "4*([Button.IsPressed() & Captor.GreaterThan(30)](WAIT(1)););"),
    ("Captor.LessThan({d})", "<Captor.LessThan(30)>(WAIT(1));"),
    ("[{c}](Wheel.Stop())", "[Button.IsPressed()](Wheel.Stop())!(WAIT(3));"),
    # branches in any order, and more of them
    ("//(Wheel.Advance({s}), WAIT({d}))", "//(Light.LightOn(), WAIT(3), Wheel.Advance(4));"),
    ("//({one}, {two})", "//(Light.LightOn(), WAIT(3));"),
    # the same hole, the same number
    ("Wheel.Advance({s}); Wheel.Reverse({s})", "Wheel.Advance(4); Wheel.Advance(5); Wheel.Reverse(5);"),
    ("//(Wheel.Advance({s}), Motor.Turn({s}))", "//(Motor.Turn(5), Wheel.Advance(5), Motor.Turn(6));"),
]
NOT_CONTAINED = [
    ("Wheel.Advance({speed})", ""),
    ("Wheel.Advance({speed})", "Wheel.Reverse(40);"),
    ("Wheel.Advance(40)", "Wheel.Advance(41);"),
    ("Wheel.Advance({s}); Wheel.Stop()", "Wheel.Stop(); Wheel.Advance(40);"),
    ("Wheel.Advance({s}); Wheel.Advance({t})", "Wheel.Advance(40);"),
    ("4*(Wheel.Advance({s}))", "3*(Wheel.Advance(4));"),
    ("4*(Wheel.Advance({s}))", "4*(WAIT(1)); Wheel.Advance(4);"),
    ("*[Captor.GreaterThan({d})]()", "[Captor.GreaterThan(3)](WAIT(1));"),
    ("*[Captor.GreaterThan({d})]()", "*[!(Captor.GreaterThan(3))](WAIT(1));"),
    ("[{c}]({a})!({b})", "[Button.IsPressed()](WAIT(1));"),
    ("Captor.GreaterThan({d}) & {more}", "*[Captor.GreaterThan(3) | Button.IsPressed()]();"),
    ("//(Wheel.Advance({s}), WAIT({d}))", "//(Wheel.Advance(4), Light.LightOn());"),
    ("//(Wheel.Advance({s}), Wheel.Advance({t}))", "//(Wheel.Advance(4), Light.LightOn());"),
    ("Wheel.Advance({s}); WAIT({d})", "//(Wheel.Advance(4), WAIT(2));"),
    ("Wheel.Advance({s}); Wheel.Reverse({s})", "Wheel.Advance(4); Wheel.Reverse(5);"),
    ("°Wheel.Advance({s})°", "Wheel.Advance(4);"),
]


@pytest.mark.parametrize(("code", "text"), CONTAINED, ids=str)
def test_a_pattern_is_found_where_a_person_did_what_was_asked_and_more(code: str, text: str) -> None:
    assert fits(pattern(code), program(text))


@pytest.mark.parametrize(("code", "text"), NOT_CONTAINED, ids=str)
def test_a_pattern_is_not_found_where_something_is_missing(code: str, text: str) -> None:
    assert not fits(pattern(code), program(text))


@pytest.mark.parametrize(
    ("code", "text", "found"),
    [
        ("Wheel.Advance({s}); {rest}", "Wheel.Advance(4); WAIT(1); WAIT(2);", True),
        ("{before}; Wheel.Stop()", "Wheel.Advance(4); Wheel.Stop();", True),
        ("{before}; Wheel.Stop()", "Wheel.Stop(); Wheel.Advance(4);", False),
        ("Wheel.Stop()", "Wheel.Stop();", True),
        ("Wheel.Stop()", "Wheel.Stop(); WAIT(1);", False),
        ("4*({body})", "4*(WAIT(1); WAIT(2));", True),
        ("4*({body})", "4*(WAIT(1)); WAIT(1);", False),
        ("[{c}]({a})", "[Button.IsPressed()](WAIT(1))!(WAIT(2));", False),
        ("//(WAIT(1), WAIT(2))", "//(WAIT(2), WAIT(1));", True),
        ("//(WAIT(1), WAIT(2))", "//(WAIT(2), WAIT(1), WAIT(3));", False),
        ("WAIT(1)", "# a word\nWAIT(1);  # another\n# and more", True),
    ],
)
def test_matches_means_the_whole_program(code: str, text: str, found: bool) -> None:
    assert fits(pattern(code, whole=True), program(text)) is found


@pytest.mark.parametrize(("speed", "found"), [(29, False), (30, True), (60, True), (61, False)])
def test_a_number_counts_within_its_range(speed: int, found: bool) -> None:
    assert fits(pattern("Wheel.Advance({s})", s=(30, 60)), program(f"Wheel.Advance({speed});")) is found
    assert fits(pattern("{s}*(WAIT(1))", s=(30, 60)), program(f"{speed}*(WAIT(1));")) is found
    assert fits(pattern("WAIT({s})", s=(30, 60)), program(f"WAIT({speed});")) is found


def test_the_range_of_a_body_counts_its_instructions_and_that_of_a_number_wants_a_number() -> None:
    assert fits(pattern("4*({body})", body=(2, 9)), program("4*(WAIT(1); WAIT(1));"))
    assert not fits(pattern("4*({body})", body=(2, 9)), program("4*(WAIT(1));"))
    assert not fits(pattern("Wheel.Advance({s})", s=(0, 100)), program("Wheel.Advance(Level.Value());"))
    assert fits(pattern("Wheel.Advance({s})"), program("Wheel.Advance(Level.Value());"))


def test_a_test_that_is_not_there_yet_fills_no_hole() -> None:
    missing = program("*[Button.IsPressed()](WAIT(1));")
    missing.items[0].condition = Call("", "")  # type: ignore[union-attr]
    assert not fits(pattern("*[{c}]({b})"), missing)
    assert fits(pattern("*[{c}]({b})", c=(0, 1)), missing)
    assert not fits(pattern("*[{c}]({b})", c=(1, 1)), missing)
    assert fits(pattern("*[{c}]({b})", c=(1, 1)), program("*[Button.IsPressed()](WAIT(1));"))


def test_steps_ask_a_certain_program_any_program_or_several() -> None:
    def step(**where: Any) -> Step:
        found = Pattern(pattern("Wheel.Advance({s})").code, **where)
        return Step({}, {}, {}, (), ((found,),), ())

    either = Step({}, {}, {}, (), ((pattern("WAIT(7)"), pattern("Wheel.Stop()")), (pattern("WAIT(1)"),)), ())
    steps = (step(), step(program="b"), step(programs=2), step(programs=3), either, Step({}, {}, {}, (), (), ()))
    tutorial = Tutorial("x.krt", {}, {}, "", steps)
    programs = {"a": program("Wheel.Advance(1);"), "b": program("WAIT(1); Wheel.Stop();")}
    assert steps_fit(tutorial, programs) == [True, False, False, False, True, True]
    programs["b"] = program("Wheel.Advance(1); WAIT(1);")
    assert steps_fit(tutorial, programs) == [True, True, True, False, False, True]


@pytest.mark.parametrize(
    ("code", "text", "found"),
    [
        ("SeqOfPar {who} ()", "2*(SeqOfPar crew (WAIT(1)));", True),
        ("SeqOfPar {who} ()", "ParOfSeq crew (WAIT(1));", False),
        ("SeqOfPar {a, b} (WAIT({t}))", "SeqOfPar {b, a} (Wheel.Stop(); WAIT(1));", True),
        ("SeqOfPar crew (WAIT({t}))", "SeqOfPar a (WAIT(1));", False),
        ("SeqOfPar {x} (); ParOfSeq {x} ()", "SeqOfPar a (); ParOfSeq b ();", False),
        ("Where {who} [Button.IsPressed()](WAIT(1))", "Where a [Button.IsPressed()](WAIT(1))!(WAIT(2));", True),
        ("PROGRAM {p}", "ParOfSeq crew (PROGRAM dance);", True),
        ("PROGRAM dance", "PROGRAM walk;", False),
        ("MOVE {n} a -> {b}", "MOVE 2 a -> b;", True),
        ("MOVE 1 a -> {b}", "MOVE 2 a -> b;", False),
        ("*[any {who} (Button.IsPressed())]()", "*[any a (Button.IsPressed())](WAIT(1));", True),
        ("*[any {who} (Button.IsPressed())]()", "*[all a (Button.IsPressed())](WAIT(1));", False),
    ],
)
def test_a_team_s_program_is_compared_too(code: str, text: str, found: bool) -> None:
    parsed = parse_team(f"group crew = {{a, b}};\n{text}")
    assert parsed.ok
    assert fits(pattern(code), parsed.program.seq) is found


# -- random programs


def plain(seed: int) -> Seq:
    """A random program for a random robot."""
    rng = random.Random(seed)
    robots = list(shipped_robots().values())
    return random_program(rng, rng.choice(robots))


def with_holes(made: Seq, rng: random.Random) -> Seq:
    """The program as a pattern: some numbers and some whole bodies are holes now, each with a name of its own."""
    code = copy.deepcopy(made)
    count = 0
    for node in nodes(code):
        if isinstance(node, Seq) and node is not code and rng.random() < 0.2:
            count += 1
            node.items, node.hole, node.hole_at = [], Hole(f"h{count}"), 0
        if isinstance(node, Repeat | Wait) and rng.random() < 0.4:
            count += 1
            setattr(node, "count" if isinstance(node, Repeat) else "duration", Hole(f"h{count}"))
        if isinstance(node, Call):
            for at, param in enumerate(node.params):
                if isinstance(param, Number) and rng.random() < 0.4:
                    count += 1
                    node.params[at] = Hole(f"h{count}")
    return code


seeds = st.integers(0, 2**32)


@given(seeds)
def test_a_program_that_a_pattern_was_made_from_is_found(seed: int) -> None:
    made = plain(seed)
    code = with_holes(made, random.Random(seed))
    assert fits(Pattern(code, whole=True), made)
    assert fits(Pattern(code), made)


@given(seeds)
def test_more_instructions_anywhere_leave_it_contained_and_no_longer_whole(seed: int) -> None:
    made, rng = plain(seed), random.Random(seed)
    if not made.items:
        return
    more = copy.deepcopy(made)
    bodies = [node for node in nodes(more) if isinstance(node, Seq)]
    body = rng.choice(bodies)
    body.items.insert(rng.randint(0, len(body.items)), Wait(12_321))
    assert fits(Pattern(made), more)
    assert not fits(Pattern(made, whole=True), more)
    assert not fits(Pattern(more), made)


@given(seeds)
def test_a_changed_number_is_no_longer_the_program(seed: int) -> None:
    made, rng = plain(seed), random.Random(seed)
    waits = [at for at, node in enumerate(nodes(made)) if isinstance(node, Wait)]
    if not waits:
        return
    changed = copy.deepcopy(made)
    wait = nodes(changed)[rng.choice(waits)]
    assert isinstance(wait, Wait)
    wait.duration = 12_321
    assert not fits(Pattern(made, whole=True), changed)
    assert not fits(Pattern(changed), made)


def test_a_hostile_pattern_on_a_large_program_is_work_in_proportion() -> None:
    def of(count: int) -> Seq:
        return program("4*(Wheel.Advance(1); Wheel.Reverse(2); WAIT(3));" * count)

    large = of(300)
    same = "; ".join(["Wheel.Advance({a})", "Wheel.Reverse({b})"] * 8)
    for code in (f"{same}; Wheel.Advance(7)", f"4*({same}); Door.Open(); WAIT({{a}})", "//({a}, {b}, WAIT({a}))"):
        hostile = pattern(code)
        assert not fits(hostile, large)

        def looked_for(n: int, hostile: Pattern = hostile) -> Callable[[], object]:
            return partial(fits, hostile, of(n))

        assert growth(looked_for, 30) < MOST
    assert fits(pattern("4*(Wheel.Advance({a}); WAIT({b}))", a=(1, 1)), large)
