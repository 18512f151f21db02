"""The tutorials that come along: step by step with what a child draws, and what was drawn at last runs to its end."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import kitrobot
from kitrobot.live.studio import Studio
from kitrobot.mission.model import Mission
from kitrobot.translation.languages import TEXT_LANGUAGES
from kitrobot.tutorial.model import Tutorial
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.tutorials import watched
from tests.exercises.handing_in import with_programs
from tools.teacher_pages import main as teacher_pages

EXAMPLES = Path(__file__).parents[2] / "examples" / "tutorials"
TURN = "Motor.AbsoluteTurn(25, 50)"
SIDE = "Wheel.DriveBy(30)"
CORNER = "Motor.LeftBy(90)"
FELT = "<Button.IsPressed()>()"
DRIVE = "Wheel.Advance(60); WAIT(20); Wheel.Stop()"

DRAWN = {
    "first-steps": (
        {"first": "Pen.PenDown();"},
        {"first": f"Pen.PenDown(); {SIDE};"},
        {},
        {"first": f"Pen.PenDown(); 10*({SIDE});"},
        {"first": f"Pen.PenDown(); 4*({SIDE});"},
        {"first": f"Pen.PenDown(); 4*({SIDE}; {CORNER});"},
        {},
    ),
    "dance": (
        {"dance": f"{TURN};"},
        {"dance": f"{TURN}; Light.LightOn();"},
        {"dance": f"{TURN}; Light.LightOn(); WAIT(5);"},
        {"dance": f"{TURN}; Light.LightOn(); WAIT(5); Light.LightOff();"},
        {"dance": f"6*({TURN}; Light.LightOn(); WAIT(5); Light.LightOff());"},
        {},
    ),
    "draw": (
        {"draw": f"Pen.PenDown(); 4*({SIDE}; {CORNER});"},
        {},
        {"draw": f"Pen.Colour(3); Pen.PenDown(); 4*({SIDE}; {CORNER});"},
        {"draw": f"Pen.Colour(3); Pen.PenDown(); 5*({SIDE}; {CORNER});"},
        {"draw": f"Pen.Colour(3); Pen.PenDown(); 5*({SIDE}; Motor.LeftBy(144));"},
        {},
    ),
    "sensing": (
        None,
        {"look": "*[Captor.GreaterThan(40)]();"},
        {"look": "*[Captor.GreaterThan(40)](Wheel.Advance(50));"},
        {"look": "*[Captor.GreaterThan(40)](Wheel.Advance(50)); Wheel.Stop();"},
        {},
        {"look": f"*[Captor.GreaterThan(40)](Wheel.Advance(50)); Wheel.Stop(); {TURN};"},
        {
            "look": f"*[Captor.GreaterThan(40)](Wheel.Advance(50)); Wheel.Stop(); {TURN}; "
            "[Captor.GreaterThan(40)](Light.LightOn());"
        },
        {},
    ),
    "faster": (
        {},
        {"faster": "6*(Wheel.Advance(Level.Value()); WAIT(5)); Wheel.Stop();"},
        {"faster": "Level.Set(10); 6*(Wheel.Advance(Level.Value()); WAIT(5)); Wheel.Stop();"},
        {"faster": "Level.Set(10); 6*(Wheel.Advance(Level.Value()); WAIT(5); Level.Add(10)); Wheel.Stop();"},
        {},
    ),
    "red-line": (
        None,
        None,
        {"line": "*[!(Light.IsRed())]();"},
        {"line": "*[!(Light.IsRed())](Wheel.Advance(50));"},
        {"line": "*[!(Light.IsRed())](Wheel.Advance(50)); Wheel.Stop();"},
        {},
    ),
    "bump": (
        {"bump": "//(, );"},
        {"bump": f"//({FELT}, );"},
        {"bump": f"//({FELT}, °Wheel.Advance(50)°);"},
        {"bump": f"//({FELT}, °Wheel.Advance(50)°); Wheel.Reverse(40); WAIT(10); Wheel.Stop();"},
        {},
    ),
    "take-turns": (
        {},
        {"two": f"<Go.IsTrue()>(); {DRIVE};"},
        {"one": f"{DRIVE}; Go.Set(1);"},
        {},
        {"two": f"<Go.IsTrue()>(); {DRIVE}; Go.Set(0);"},
        {"one": f"{DRIVE}; Go.Set(1); <Go.IsFalse()>(Light.LightOn());"},
        {},
    ),
}
"""For each step the programs as they are then; none where only a run is wanted, None where a test is still missing."""


def done(tutorial: Tutorial, opened: OpenMission, mission: Mission) -> list[bool]:
    return watched(tutorial, mission, opened.catalogue)


def opened(name: str, folder: Path) -> tuple[Tutorial, OpenMission]:
    """A tutorial and the mission that it begins with."""
    studio = Studio(folder, None)
    tutorial, start = studio.tutorials.usable(f"example:tutorials/{name}/{name}.tutorial.xml")
    data, _ = studio.folder.read(start)
    return tutorial, studio.read(data, start, start)


@pytest.mark.parametrize("name", DRAWN)
def test_each_step_is_done_by_what_it_asks_for_and_not_before(name: str, tmp_path: Path) -> None:
    tutorial, start = opened(name, tmp_path)
    mission = start.mission
    steps = DRAWN[name]
    assert len(steps) == len(tutorial.steps)
    for at, texts in enumerate(steps):
        if texts is None:
            continue
        if texts:
            assert not done(tutorial, start, mission)[at], tutorial.steps[at].label[""]
        mission = with_programs(start, mission, texts)
        assert done(tutorial, start, mission)[at], tutorial.steps[at].label[""]
        assert bool(tutorial.steps[at].events) == (texts == {})
    assert all(done(tutorial, start, mission)[at] for at, texts in enumerate(steps) if texts != {})
    made = replace(start, mission=mission).run(seconds=60)
    assert made.outcome == "done", made.sentence
    assert made.seconds < 45


@pytest.mark.parametrize(
    ("name", "program", "corner", "sides"),
    [
        ("first-steps", "first", "Motor.RightBy(90)", 4),
        ("first-steps", "first", TURN, 4),
        ("draw", "draw", "Motor.RightBy(144)", 5),
        ("draw", "draw", "Motor.AbsoluteTurn(40, 50)", 5),
    ],
)
def test_a_figure_may_turn_the_other_way_or_be_driven_by_the_clock(
    name: str, program: str, corner: str, sides: int, tmp_path: Path
) -> None:
    tutorial, start = opened(name, tmp_path)
    side = "Wheel.Advance(60); WAIT(12); Wheel.Stop(); WAIT(5)" if "Absolute" in corner else SIDE
    text = f"Pen.Colour(3); Pen.PenDown(); {sides}*({side}; {corner});"
    assert all(done(tutorial, start, with_programs(start, start.mission, {program: text})))
    wrong = text.replace(corner, corner.replace("(", "(1"))
    assert not all(done(tutorial, start, with_programs(start, start.mission, {program: wrong})))


def test_what_stands_behind_a_loop_is_not_what_is_wanted_in_it(tmp_path: Path) -> None:
    tutorial, start = opened("sensing", tmp_path)
    behind = with_programs(start, start.mission, {"look": "*[Captor.GreaterThan(40)](); Wheel.Advance(50);"})
    assert done(tutorial, start, behind)[:3] == [True, True, False]


def test_what_an_unchanged_start_does_is_seen_to_its_end() -> None:
    for name in ("draw", "faster", "take-turns"):
        assert kitrobot.open(EXAMPLES / name / f"{name}.krt").run(seconds=60).outcome == "done"


def test_tutorials_stand_in_their_order_and_each_has_a_page_for_teachers(tmp_path: Path) -> None:
    found = Studio(tmp_path, None).tutorials.all()
    names = [one.name.split("/")[1] for one in found]
    assert names == [
        *("first-steps", "dance", "draw", "sensing", "faster", "red-line", "bump", "together"),
        *("take-turns", "together-in-step", "when-one-fails"),
    ]
    for one in found:
        assert one.lesson is not None
        page = one.lesson.teacher
        assert page is not None
        assert 1 <= page.minutes <= 10
        assert len(page.troubles) >= 2
        assert len(page.questions) >= 2
        for texts in (page.aim, *page.troubles, *page.questions):
            assert set(TEXT_LANGUAGES) == set(texts)
            assert all(texts.values())


def test_the_teachers_pages_say_what_the_tutorials_say() -> None:
    assert teacher_pages(["--check"]) == 0, "python tools/teacher_pages.py"
