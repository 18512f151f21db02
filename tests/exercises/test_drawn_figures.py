"""`<draws by="pen">`: what the pen drew is the figure, whatever was driven besides."""

from __future__ import annotations

import pytest

from kitrobot.checking.run_evidence import collect_run_evidence
from kitrobot.exercise.exercise_xml import read_exercise
from kitrobot.exercise.goals import RunGoal
from tests.sim.building import catalogue, empty_world, run_of

SIDE = "Wheel.Advance(60); WAIT(15); Wheel.Stop(); WAIT(5); Motor.AbsoluteTurn(25, 90);"
SQUARE = f"Pen.PenDown(); 4*( {SIDE} ); Pen.PenUp();"


def goal(by: str) -> RunGoal:
    text = f"""<exercise version="1" start="x.krt"><label>E</label>
      <draws corners="4" side="100" by="{by}"><label>A square</label></draws></exercise>"""
    found, problems = read_exercise(text.encode(), "x.exercise.xml")
    assert problems == []
    assert found is not None
    [one] = found.goals
    assert isinstance(one, RunGoal)
    return one


@pytest.mark.parametrize(
    ("text", "by_pen", "by_way"),
    [
        (SQUARE, None, None),
        (
            f"Wheel.Advance(60); WAIT(20); Wheel.Stop(); WAIT(5); {SQUARE} Wheel.Advance(60); WAIT(30);",
            None,
            "away from",
        ),
        (f"4*( {SIDE} );", "found 0", None),
        (f"Pen.PenDown(); {SIDE} Pen.PenUp(); {SIDE} Pen.PenDown(); {SIDE} Pen.PenUp(); {SIDE}", "found 2", None),
        (f"Pen.PenDown(); 3*( {SIDE} ); Pen.PenUp(); {SIDE}", "away from", None),
    ],
)
def test_what_the_pen_drew_or_what_was_driven_is_the_figure(text: str, by_pen: str | None, by_way: str | None) -> None:
    robot = catalogue().robots["mini-robot"]
    run = collect_run_evidence(run_of({"a": (robot, text)}, empty_world(a=(1000, 1000, 0.4))), 1, True)
    assert run is not None
    for by, words in (("pen", by_pen), ("way", by_way)):
        fault = goal(by).fault(run)
        if words is None:
            assert fault is None, fault
        else:
            assert fault is not None
            assert words in fault.sentence
