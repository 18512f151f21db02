"""Pens: what is drawn is where the robot went while the pen was down, alike in the step, in a trace and under Numba."""

from __future__ import annotations

import math
import random

import pytest

from kitrobot.sim.recorder import Recorder, strokes_now
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.source import SimulationSource
from kitrobot.sim.step.pens import pens_of
from kitrobot.trace.drawing import Drawing, DrawingReader, Mark, Stroke
from kitrobot.trace.drawing_svg import drawing_svg
from kitrobot.trace.source import walk
from kitrobot.trace.strokes import tenths
from tests.sim.building import catalogue, empty_world, run_of

ACTS: tuple[str, ...] = (
    "Pen.PenDown();",
    "Pen.PenUp();",
    "Pen.Colour({a});",
    "Pen.Width({b});",
    "Wheel.Advance({a}0);",
)
ACTS += ("Wheel.Reverse(40);", "Wheel.Stop();", "Motor.AbsoluteTurn({b}, 50);", "Motor.Turn({a}0);", "Motor.Stop();")


def drawing_run(text: str, robots: int = 1) -> Simulation:
    robot = catalogue().robots["mini-robot"]
    poses = {f"r{n}": (1000.0, 700.0 + 300 * n, 0.3 * n) for n in range(robots)}
    return run_of(dict.fromkeys(poses, (robot, text)), empty_world(**poses), seconds=60)


def random_text(seed: int) -> str:
    chance = random.Random(seed)
    acts = [chance.choice(ACTS).format(a=chance.randrange(8), b=chance.randint(1, 50)) for _ in range(12)]
    return f"Pen.PenDown(); *( {' '.join(f'{act} WAIT({chance.randint(1, 4)});' for act in acts)} );"


def drawn_in(run: Simulation, stretches: list[int]) -> Drawing:
    drawing = Drawing(pens_of(run.members))
    for steps in stretches:
        goal = run.tick + steps
        while run.tick < goal:
            if run.advance(goal - run.tick) == 0:
                break
            drawing.add(run.drawn)
    return drawing


def read_of(run: Simulation, steps: int) -> Drawing:
    recorder = Recorder(run)
    reader = DrawingReader(recorder.header)
    reader.take(recorder.record())
    for _ in range(steps):
        run.step()
        reader.take(recorder.record())
    return reader.drawing


def away(place: tuple[float, float], stroke: Stroke) -> float:
    """How far a place is from a stroke, in mm."""
    best = math.inf
    for (ax, ay), (bx, by) in zip(stroke.points, stroke.points[1:] or stroke.points, strict=False):
        dx, dy = bx - ax, by - ay
        length = dx * dx + dy * dy
        part = 0.0 if length == 0 else min(1.0, max(0.0, ((place[0] - ax) * dx + (place[1] - ay) * dy) / length))
        best = min(best, math.dist(place, (ax + part * dx, ay + part * dy)))
    return best


def test_a_line_is_where_the_robot_went_with_its_pen_down_and_a_straight_one_has_two_points() -> None:
    run = drawing_run(
        "Wheel.Advance(50); WAIT(5); Pen.Colour(2); Pen.Width(7); Pen.PenDown(); WAIT(10); Pen.PenUp(); WAIT(9);"
    )
    drawing = drawn_in(run, [250])
    [stroke] = strokes_now(run, drawing)
    assert (stroke.colour, stroke.width_mm, len(stroke.points)) == (2, 7, 2)
    (x, y), (end, same) = stroke.points
    assert (y, same) == (700.0, 700.0)
    assert 1050 < x < 1150
    assert end - x == pytest.approx(204, abs=9)


def test_a_pen_that_is_put_down_and_lifted_without_moving_makes_a_dot() -> None:
    run = drawing_run("Pen.PenDown(); WAIT(1); Pen.PenUp(); WAIT(1);")
    [stroke] = strokes_now(run, drawn_in(run, [60]))
    assert stroke.points == ((1000.0, 700.0),)


@pytest.mark.parametrize("seed", range(3))
def test_the_step_and_the_trace_find_the_same_lines_and_no_point_of_the_way_is_off_them(seed: int) -> None:
    stepped = drawn_in(drawing_run(random_text(seed), 2), [1, 7, 200, 1, 91])
    run = drawing_run(random_text(seed), 2)
    assert read_of(run, 300).marks == stepped.marks != []
    for record in range(1, 300, 40):
        assert stepped.until(record) == [mark for mark in stepped.marks if mark.tick <= record]
    places = drawing_run(random_text(seed))
    while places.tick < 80:
        places.step()
        if places.members[0].outputs()[0][1][0]:
            x, y, *_ = places.poses()[0]
            lines = [one for one in strokes_now(run, stepped) if one.pen == 0]
            assert min(away((x, y), one) for one in lines) < 0.3


def test_plain_and_compiled_steps_draw_the_same(with_numba: None) -> None:
    for seed in range(4):
        plain, compiled = drawing_run(random_text(seed), 3), drawing_run(random_text(seed), 3)
        plain.stays_plain = True
        assert compiled.compile_step()
        assert drawn_in(plain, [1, 150, 200]).marks == drawn_in(compiled, [1, 150, 200]).marks
        assert plain.snapshot() == compiled.snapshot()


def test_going_back_takes_lines_away_and_going_on_draws_the_same_or_others() -> None:
    source = SimulationSource(drawing_run(random_text(4)))
    source.advance(300)
    whole = list(source.drawing.marks)
    first = source.drawing.news(300)
    assert first is not None
    assert (first.keep, list(first.marks)) == (0, whole)
    assert source.drawing.news(300) is None
    walk(source.seek(60))
    back = source.drawing.news(60)
    assert back is not None
    assert (back.keep, list(back.marks)) == (source.drawing.count(60), [])
    source.advance(240)
    on = source.drawing.news(300)
    assert on is not None
    assert whole[: on.keep] + list(on.marks) == whole == source.drawing.marks
    walk(source.seek(60))
    source.set_variable("r0", "Level", 3)
    source.fail("r0", "fail")
    source.advance(100)
    other = source.drawing.news(160)
    assert other is not None
    assert other.keep <= back.keep
    assert all(mark.tick <= 62 for mark in source.drawing.marks)


def test_a_drawing_is_bounded_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kitrobot.trace.drawing.MOST_MARKS", 3)
    drawing = Drawing()
    drawing.add(Mark(n, 0, 1, n, 0, 0, 1) for n in range(9))
    assert (len(drawing.marks), drawing.full) == (3, True)
    drawing.forget_after(1)
    assert (len(drawing.marks), drawing.full) == (2, False)


def test_a_drawing_as_svg_has_a_path_for_each_line_and_y_goes_down() -> None:
    strokes = [Stroke(0, 1, 3, ((0.0, 0.0), (10.5, 90.0))), Stroke(0, 0, 5, ((7.0, 7.0),))]
    text = drawing_svg(strokes, 200, 100)
    assert 'viewBox="0 0 200 100"' in text
    assert '<path d="M0 100 L10.5 10" stroke="#d3202f" stroke-width="3"/>' in text
    assert '<path d="M7 93 h0" stroke="#1b1f27" stroke-width="5"/>' in text


def test_lengths_are_rounded_as_a_trace_rounds_them() -> None:
    chance = random.Random(1)
    numbers = [chance.uniform(-1e5, 1e5) for _ in range(200)] + [n / 20 for n in range(-99, 99)]
    assert [tenths(one) for one in numbers] == [float(round(one * 10)) for one in numbers]
