"""The twelve exercises that come along can be solved, and a wrong solution is told what it lacks."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.checking.exercise_evaluation import Evaluation, EvaluationOptions, evaluate_submission, open_handed_in
from kitrobot.classroom.grader_process import goal_grade, ready_exercise, shipped_exercises
from kitrobot.classroom.grades import Grade
from kitrobot.exercise.evidence import ProgramEvidence
from kitrobot.translation.languages import TEXT_LANGUAGES
from kitrobot.translation.translator import translate_to
from kitrobot.workspace.exercises import programs_of
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.search_path import SearchPath
from tests.exercises.handing_in import FOLDER, exercise_file, submission
from tests.exercises.solutions import KEEPS_DRIVING, SOLVED, WRONG, Programs

NAMES = sorted(SOLVED)


def judged(name: str, programs: Programs) -> Evaluation:
    ready = ready_exercise(exercise_file(name))
    opened = open_handed_in(ready.start, submission(name, programs), SearchPath(FOLDER))
    return evaluate_submission(ready.exercise, opened, EvaluationOptions(hidden=True))


def missed(made: Evaluation) -> list[int]:
    return [number for number, verdict in enumerate(made.verdicts, 1) if not verdict.reached]


@pytest.mark.parametrize("name", NAMES)
def test_a_model_solution_reaches_every_goal_and_a_wrong_one_is_told_which_it_misses(name: str) -> None:
    begun, solved = judged(name, {}), judged(name, SOLVED[name])
    assert missed(solved) == [], [verdict.why for verdict in solved.verdicts]
    assert solved.full
    programs, wanted = WRONG[name]
    wrong = judged(name, programs) if programs else begun  # the last exercise begins with its wrong solution
    assert missed(wrong) == wanted
    assert all(verdict.why for verdict in wrong.verdicts if not verdict.reached)
    assert not wrong.full
    assert not begun.full
    # What is handed in as it was earns nothing, and what is solved all there is.
    assert graded(begun, begun).points == 0
    assert graded(solved, begun).points == graded(solved, begun).of
    assert graded(wrong, begun).points < graded(wrong, begun).of


@pytest.mark.parametrize("name", KEEPS_DRIVING)
def test_who_keeps_driving_and_stops_by_the_clock_reaches_every_goal_too(name: str) -> None:
    made = judged(name, KEEPS_DRIVING[name])
    assert missed(made) == [], [verdict.why for verdict in made.verdicts]


def graded(made: Evaluation, begun: Evaluation) -> Grade:
    """The row of a submission, of an exercise whose beginning was judged so."""
    pairs = zip(map(goal_grade, made.verdicts), begun.verdicts, strict=True)
    return Grade("x", {}, tuple(replace(goal, condition=bool(start.reached)) for goal, start in pairs))


def test_there_are_twelve_in_each_language_and_their_programs_tell_them_apart() -> None:
    files = shipped_exercises()
    assert [path.name.removesuffix(".exercise.xml") for path in files] == NAMES
    assert len(NAMES) == 12
    programs: list[str] = []
    for path in files:
        exercise = ready_exercise(path).exercise
        for texts in (exercise.label, exercise.help, *(goal.label for goal in exercise.goals)):
            assert set(texts) == set(TEXT_LANGUAGES)
        programs += programs_of(open_mission(path.parent / exercise.start).mission)
    assert len(programs) == len(set(programs))


def test_what_was_found_before_judging_is_stopped_is_kept_and_nothing_else_is_said() -> None:
    """Two runs, then what is checked: stopped before them, between them, before the check, and not at all."""
    ready = ready_exercise(exercise_file("12-no-jam"))
    opened = open_handed_in(ready.start, submission("12-no-jam", {}), SearchPath(FOLDER))

    def reached(pieces: int) -> list[bool | None]:
        over: list[int] = []
        options = EvaluationOptions(stop=lambda: len(over) >= pieces, seeds=(1, 2))
        made = evaluate_submission(ready.exercise, opened, options, lambda done, _: over.append(done))
        return [verdict.reached for verdict in made.verdicts]

    assert [reached(pieces) for pieces in (0, 1, 2, 9)] == [
        [None, None, None, None, None],
        [None, False, None, None, None],
        [True, False, True, None, None],
        [True, False, True, False, False],
    ]


@pytest.mark.parametrize(
    ("name", "number", "english", "french"),
    [
        ("03-square", 3, "“Repeat” is not in the program", "« Répéter » n'est pas dans le programme"),
        (
            "05-before-the-wall",
            4,
            "“Distance sensor: Nearer than” is not in the program",
            "« Capteur de distance : Plus près que » n'est pas dans le programme",
        ),
    ],
)
def test_a_part_that_is_missed_is_called_as_on_the_page(name: str, number: int, english: str, french: str) -> None:
    why = judged(name, {}).verdicts[number - 1].why
    assert why is not None
    assert (str(why), translate_to(why, "fr")) == (english, french)


def test_a_part_that_no_robot_of_the_mission_has_is_called_by_its_name() -> None:
    assert str(ProgramEvidence({}, {}).label_of("Wings.Flap")) == "Wings.Flap"
