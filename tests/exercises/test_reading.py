"""An exercise is read whole, or its mistake is said with its place. Damaged XML: tests/primitives/test_bad_xml.py."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
import xmlschema

import kitrobot.primitives
from kitrobot.exercise.exercise_xml import KINDS, MOST_GOALS, MOST_SEEDS, read_exercise
from kitrobot.exercise.goals import CheckGoal, DoneGoal, DrawingGoal, Parts
from kitrobot.exercise.model import Seed
from tests.primitives.samples import EXERCISE, messages

GOAL = "<done><label>D</label></done>"


@cache
def schema() -> xmlschema.XMLSchema:
    return xmlschema.XMLSchema(Path(kitrobot.primitives.__file__).parent / "schemas" / "exercise.xsd")


def exercise(inside: str, start: str = "x.krt") -> str:
    return f'<exercise version="1" start="{start}"><label>E</label>{inside}</exercise>'


def test_an_exercise_is_read_with_everything_in_it_and_fits_its_schema() -> None:
    found, problems = read_exercise(EXERCISE.encode(), "x.exercise.xml")
    assert problems == []
    assert found is not None
    assert (found.start, found.icon, found.seconds) == ("x.krt", "square", 60.0)
    assert found.label == {"": "A square ✓"}
    assert found.seeds == (Seed(1), Seed(7, hidden=True))
    done, draws, parts, holds = found.goals
    assert done == DoneGoal({"": "It ends", "fr": "Il finit"}, 2, False)
    assert draws == DrawingGoal({"": "A square"}, 1, False, 4, 150.0, 30.0, "")
    assert parts == Parts({"": "At most 12 parts"}, 1, True, "", 12)
    assert holds == CheckGoal({"": "Never stuck"}, 1, False, "deadlock", "lockstep", 0, 100_000, False)
    assert found.goals_for(hidden=False) == (done, draws, holds)
    assert found.seeds_for(hidden=False) == (1,)
    schema().validate(EXERCISE)


def test_every_kind_of_goal_is_read_from_what_it_needs_alone() -> None:
    needs = {
        "within": 'seconds="5"',
        "visits": 'x="1" y="-2.5"',
        "draws": 'corners="3"',
        "uses": 'part="Wait"',
        "avoids": 'part="Wait"',
        "parts": 'most="1"',
        "holds": 'property="served"',
    }
    text = exercise("".join(f"<{kind} {needs.get(kind, '')}><label>G</label></{kind}>" for kind in KINDS))
    found, problems = read_exercise(text.encode(), "x")
    assert problems == []
    assert found is not None
    assert len(found.goals) == len(KINDS)
    schema().validate(text)


def test_as_many_goals_and_seeds_as_are_allowed_are_read_and_one_more_is_not() -> None:
    seeds = "".join(f'<seed value="{n}"/>' for n in range(MOST_SEEDS))
    found, _ = read_exercise(exercise(GOAL * MOST_GOALS + seeds).encode(), "x")
    assert found is not None
    assert messages(read_exercise, exercise(GOAL * (MOST_GOALS + 1))) == [
        f"<exercise | exercise-start | expected at most {MOST_GOALS} goals, found {MOST_GOALS + 1}"
    ]
    assert messages(read_exercise, exercise(GOAL + seeds + '<seed value="1000"/>')) == [
        f"<exercise | exercise-start | expected at most {MOST_SEEDS} seeds, found {MOST_SEEDS + 1}"
    ]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (exercise(""), "<exercise | exercise-start | expected a goal that is not hidden, found none"),
        (
            exercise('<done hidden="yes"><label>D</label></done>'),
            "<exercise | exercise-start | expected a goal that is not hidden, found none",
        ),
        (
            exercise(GOAL + '<seed value="1" hidden="yes"/>'),
            "<exercise | exercise-start | expected a seed that is not hidden, found none",
        ),
        (
            exercise(GOAL + '<seed value="1"/><seed value="1"/>'),
            "<seed | xml-duplicate | the seed “1” is there already",
        ),
        (exercise("<done/>"), "<done | exercise-goal | expected a <label> in English in <done>, found none"),
        (
            exercise('<within seconds="121"><label>W</label></within>'),
            "121 | exercise-goal | expected at most the 120 seconds of a run, found more",
        ),
        (
            exercise('<holds property="luck"><label>H</label></holds>'),
            "luck | xml-bad-value | expected contact, empty-storehouse, empty-swing, stock, deadlock, delivered,"
            " served, meets, stopped or end in property, found “luck”",
        ),
        (
            exercise('<draws corners="2"><label>D</label></draws>'),
            "2 | xml-bad-value | expected a whole number from 3 to 12 in corners, found “2”",
        ),
        (
            exercise(GOAL, start="../x.krt"),
            "../x.krt | xml-bad-value | expected the name of a .krt in the same folder in start, found “../x.krt”",
        ),
    ],
)
def test_a_mistake_is_said_with_its_place(text: str, said: str) -> None:
    assert messages(read_exercise, text) == [said]


def test_an_exercise_without_a_name_is_said() -> None:
    [said] = messages(read_exercise, f'<exercise version="1" start="x.krt">{GOAL}</exercise>')
    assert said == "<exercise | exercise-start | expected a <label> in English, found none"
