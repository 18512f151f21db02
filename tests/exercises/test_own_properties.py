"""Goals that are properties of an exercise's own: read as a mission's are, judged by a check or by runs, and not to be
weakened by what is handed in.
"""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

import kitrobot
from kitrobot.checking.check_evidence import assign_judges, collect_check_evidence
from kitrobot.checking.exercise_evaluation import EvaluationOptions, GoalVerdict, evaluate_submission, open_handed_in
from kitrobot.exercise.exercise_xml import MOST_GOALS, read_exercise
from kitrobot.exercise.goals import CheckGoal
from kitrobot.lll.tree import Members
from kitrobot.mission.model import Mission
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.mission.reader import read_mission
from kitrobot.primitives.catalogue import SHIPPED
from kitrobot.workspace.file_check import check_file
from kitrobot.workspace.mission_loader import OpenMission, open_mission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.search_path import SearchPath
from tests.exercises.handing_in import FOLDER, submission
from tests.exercises.solutions import SOLVED
from tests.mission.test_asked import HEAD, LINES
from tests.primitives.samples import messages

RED = "07-red-line"
JAM = "12-no-jam"
CONVOY = "11-in-step"
LOADED = 'after="any ring-carrier (Cargo.IsPressed())" eventually="any ring-carrier (Cargo.IsReleased())"'


def goals_file(*goals: str, start: str = "x.krt", seeds: tuple[int, ...] = (1,)) -> str:
    inside = "".join(f"<holds {goal}><label>G</label></holds>" for goal in goals)
    inside += "".join(f'<seed value="{seed}"/>' for seed in seeds)
    return f'<exercise version="1" start="{start}" seconds="60"><label>E</label>{inside}</exercise>'


def judged(
    name: str,
    mission: Mission,
    *goals: str,
    options: EvaluationOptions | None = None,
    seeds: tuple[int, ...] = (1,),
    start: OpenMission | None = None,
) -> list[GoalVerdict]:
    """What comes of such goals of an exercise with the first mission of `name`, or with `start`."""
    exercise, problems = read_exercise(goals_file(*goals, seeds=seeds).encode(), "x.exercise.xml")
    assert exercise is not None, problems
    start = start or open_mission(FOLDER / f"{name}.krt")
    opened = open_handed_in(start, mission, SearchPath(FOLDER))
    return list(evaluate_submission(exercise, opened, options, start=start).verdicts)


def test_every_form_is_read_as_that_of_a_mission() -> None:
    mission, _ = read_mission("\n".join((HEAD, *LINES, "</kitrobot>")).encode(), "m.krt")
    assert mission is not None
    texts = [line.partition(" ")[2].partition(" ")[2].removesuffix("/>") for line in LINES]
    found, problems = read_exercise(goals_file(*texts).encode(), "x.exercise.xml")
    assert (found is not None, problems) == (True, [])
    goals = [goal for goal in (found.goals if found is not None else ()) if isinstance(goal, CheckGoal)]
    asked = [goal.asked for goal in goals]
    assert asked == [replace(one, name="asked") for one in mission.properties]
    assert [goal.property for goal in goals] == [str(one.words) for one in mission.properties]


HOLDS = "any robot-1 (Light.IsGreen())"
ANY = "any p (Button.IsPressed())"


@pytest.mark.parametrize(
    ("goal", "said"),
    [
        ("", '<holds | xml-missing | expected property="…" on <holds>, found none'),
        ('sometimes="x"', None),
        (
            f'never="{ANY}" until="{ANY}"',
            f"{ANY} | mission-property-form | the attributes of <holds> are of none of the forms of a property:"
            " never, until",
        ),
        (
            f'property="deadlock" never="{ANY}"',
            "deadlock | exercise-goal | expected a ready property or one of your own in <holds>, found both",
        ),
        (
            f'eventually="{ANY}" within="-3"',
            "-3 | xml-bad-value | expected a number from 0 to 1e+06 in within, found “-3”",
        ),
        (
            f'eventually="{ANY}" within="0"',
            "0 | xml-bad-value | expected a number of seconds larger than 0 in within, found “0”",
        ),
        (
            f'at-most="{ANY}" times="101"',
            "101 | xml-bad-value | expected a whole number from 0 to 100 in times, found “101”",
        ),
        (
            f'eventually="{ANY}" within="60"',
            "60 | exercise-goal | expected less than the 60 seconds of a run, found no less",
        ),
        (f'holds="{ANY}" for="99"', "99 | exercise-goal | expected less than the 60 seconds of a run, found no less"),
        (
            f'holds="{ANY}" for="2" failures="1"',
            "1 | exercise-goal | failures is of a check, and this property counts seconds, so runs judge it",
        ),
        (
            f'never="{"x" * 1001}"',
            f"{'x' * 1001} | mission-property-form | expected at most 1000 characters in never, found 1001",
        ),
    ],
)
def test_a_mistake_is_said_with_its_place(goal: str, said: str | None) -> None:
    found = messages(read_exercise, goals_file(goal))
    assert found == [said] if said is not None else "sometimes" in found[0]


def test_ten_thousand_properties_are_refused_in_a_sentence() -> None:
    *_, said = messages(read_exercise, goals_file(*['never="any p (Button.IsPressed())"'] * 10_000))
    assert said == f"<exercise | exercise-start | expected at most {MOST_GOALS} goals, found 10000"


def test_a_check_proves_what_needs_no_time_and_runs_see_what_does() -> None:
    goals = (
        'never="all ring-carrier (Collision.IsPressed())"',
        'first="any ring-carrier (Cargo.IsPressed())" before="any ring-carrier (Dock.EqualTo(3))"',
        f'{LOADED} within="59"',
        'at-most="any carrier-1 (Collision.IsPressed())" times="0"',
    )
    never, first, after, most = judged(JAM, submission(JAM, SOLVED[JAM]), *goals, seeds=(1, 2))
    assert (never.reached, first.reached, after.reached) == (True, True, True)
    assert [str(one.why) for one in (never, first)] == ["proved for every order of events of the model (lockstep)"] * 2
    assert (after.why, str(after.runs_ground)) == ("", "seen in 2 runs, which is no proof")
    assert most.reached is False
    assert ": it can go wrong when " in most.why


def test_what_a_run_breaks_has_its_seed_and_moment_and_what_never_comes_up_does_not_count() -> None:
    short = {"red-line-green-line": SOLVED[RED]["red-line-green-line"].replace("WAIT(20)", "WAIT(10)")}
    stays = 'holds="any robot-1 (Light.IsRed())" for="2"'
    [one] = judged(RED, submission(RED, short), stays, seeds=(3, 1))
    assert (one.reached, one.seed, one.runs, one.of) == (False, 3, 0, 2)
    assert one.seconds is not None
    assert 4 < one.seconds < 6
    assert one.why == "once `any robot-1 (Light.IsRed())`, it stays so for 2 s: a run breaks it"
    [one] = judged(RED, submission(RED, {}), stays, seeds=(3, 1))
    assert (one.reached, one.seed) == (False, None)
    assert one.why.endswith(": it never comes to that")
    # One of several runs does not know whether it comes up in another.
    [one] = judged(RED, submission(RED, {}), stays, seeds=(3, 1), options=EvaluationOptions(seeds=(3,)))
    assert one.reached is None
    assert one.why.endswith(": it never comes to that")


def test_what_no_check_can_decide_is_judged_by_runs_but_not_what_may_happen_after_failures() -> None:
    order = 'visit="any robot-1 (Light.IsRed()); any robot-1 (Light.IsGreen())" order="given"'
    mission = submission(RED, SOLVED[RED])
    seen, failing = judged(RED, mission, order, f'{order} failures="1"')
    assert (seen.reached, seen.runs, seen.why) == (True, 1, "")
    assert failing.reached is False
    assert "this could not be checked: Light of robot-1 may read anything at any time" in failing.why
    pieces = [EvaluationOptions(seeds=(1,), checks=False), EvaluationOptions(runs=False)]
    assert [judged(RED, mission, order, options=piece)[0].reached for piece in pieces] == [True, None]


@pytest.mark.parametrize(
    ("condition", "said"),
    [
        ("any robot-9 (Light.IsRed())", "`robot-9` is no agent of this team, and no program of one"),
        ("any robot-1 (Boxes.EqualTo(3))", "Boxes"),
        ("any robot-1 (Light.IsPurple())", "IsPurple"),
        ("Light.IsRed()", "`Light.IsRed` does not say whose it is"),
        ("any robot-1 (", ""),
        ("", "expected a condition"),
    ],
)
@pytest.mark.parametrize("form", ['never="{}"', 'holds="{}" for="2"'])
def test_a_name_that_is_not_there_is_said_and_is_no_pass(condition: str, said: str, form: str) -> None:
    [one] = judged(RED, submission(RED, SOLVED[RED]), form.format(condition))
    assert one.reached is False
    assert one.why.startswith("this could not be checked: ")
    assert said in one.why


def test_what_is_handed_in_removes_and_weakens_no_property() -> None:
    start = open_mission(FOLDER / f"{JAM}.krt")
    demand = AskedProperty("alone", Form.NEVER, "any ring-carrier (Collision.IsPressed())")
    start = replace(start, mission=replace(start.mission, properties=[demand]))
    handed = submission(JAM, {})
    weaker = [AskedProperty(f"p{n}", Form.NEVER, "x") for n in range(10_000)]
    weaker += [replace(demand, first="any ring-carrier (Sign.EqualTo(99))")]
    for properties in ([], weaker):
        handed.properties = properties
        opened = open_handed_in(start, handed, SearchPath(FOLDER))
        assert opened.mission.properties == [demand]
        [one] = judged(JAM, handed, f'never="{demand.first}"', start=start)
        assert one.reached is False


def test_runs_judge_only_where_the_first_mission_has_no_model_either(tmp_path: Path) -> None:
    """Otherwise a program could get rid of a proof. A carrier that can drive by lengths has no model."""
    by = '<procedure name="DriveBy" completes="later"><parameter name="distance" min="0" max="100"/></procedure>'
    robot = (SHIPPED / "carrier.robot.xml").read_text(encoding="utf-8").replace('name="carrier"', 'name="own"', 1)
    (tmp_path / "own.robot.xml").write_text(robot.replace("</actuator>", f"{by}</actuator>", 1), encoding="utf-8")
    shutil.copy(FOLDER / "short-ring.world.xml", tmp_path)
    mission = (FOLDER / f"{JAM}.krt").read_text(encoding="utf-8").replace('robot="carrier"', 'robot="own"')
    (tmp_path / "x.krt").write_text(mission, encoding="utf-8")
    exercise, _ = read_exercise(goals_file('never="all ring-carrier (Collision.IsPressed())"').encode(), "x")
    assert exercise is not None
    goals = [goal for goal in exercise.goals if isinstance(goal, CheckGoal)]
    start = open_mission(tmp_path / "x.krt")
    prepared = start.prepare(RunOptions(1, 60.0))
    assert [len(found) for found in assign_judges(prepared, goals, start)] == [0, 1, 0]
    judges = assign_judges(prepared, goals, open_mission(FOLDER / f"{JAM}.krt"))
    assert judges.checks == goals
    [seen] = collect_check_evidence(prepared, goals).values()
    assert (seen.answer, "drives a distance" in seen.sentence) == ("none", True)


def test_a_group_that_is_declared_in_another_way_is_said_and_is_no_pass() -> None:
    goal = 'never="any convoy (Captor.LessThan(5))" while="any convoy (Captor.LessThan(5))"'
    mission = submission(CONVOY, SOLVED[CONVOY])
    [one] = judged(CONVOY, mission, goal)
    assert "declared otherwise" not in one.why
    groups = mission.team.groups
    group = next(one for one in groups if one.name == "convoy")
    mission.team.groups = [replace(group, members=Members(group.members.names[:1]))]
    [one] = judged(CONVOY, mission, goal)
    assert one.reached is False
    assert one.why == ("this could not be checked: `convoy` is declared otherwise than in the mission of the exercise")


def test_a_check_of_the_file_says_what_the_first_mission_lacks_and_python_what_the_exercise_says(
    tmp_path: Path,
) -> None:
    for name in (f"{RED}.krt", "two-lines.world.xml"):
        shutil.copy(FOLDER / name, tmp_path / name)
    path = tmp_path / "own.exercise.xml"
    path.write_text(goals_file('never="any robot-9 (Light.IsRed())"', f'never="{HOLDS}"', start=f"{RED}.krt"))
    report = check_file(path)
    assert [str(one.message) for one in report.diagnostics] == [
        "`robot-9` is no agent of this team, and no program of one"
    ]
    assert report.diagnostics[0].place is not None
    assert report.diagnostics[0].place.line == 1
    made = kitrobot.grade_mission(open_mission(tmp_path / f"{RED}.krt"), path)
    assert [one.reached for one in made.verdicts] == [False, True]
    path.write_text(goals_file('never="any robot-9 (Light.IsRed())"', start="gone.krt"))
    assert check_file(path).diagnostics == ()


def test_an_exercise_of_a_folder_is_graded_with_its_properties(tmp_path: Path) -> None:
    from kitrobot.classroom.grade_tables import as_html
    from kitrobot.classroom.grading import grade
    from kitrobot.mission.writer import write_mission

    for name in (f"{RED}.krt", "two-lines.world.xml"):
        shutil.copy(FOLDER / name, tmp_path / name)
    goals = ('holds="any robot-1 (Light.IsRed())" for="2"', 'eventually="any robot-9 (Light.IsRed())" within="9"')
    (tmp_path / "own.exercise.xml").write_text(goals_file(*goals, start=f"{RED}.krt"))
    (tmp_path / "ada.krt").write_bytes(write_mission(submission(RED, SOLVED[RED])))
    [row] = grade([tmp_path / "ada.krt"], tmp_path / "own.exercise.xml", 1)
    assert row.problem is None
    assert [goal.reached for goal in row.goals] == [True, False]
    assert row.goals[0].why["en"] == "seen in 1 run, which is no proof"
    assert row.goals[0].why["fr"] != row.goals[0].why["en"]
    assert "robot-9" in row.goals[1].why["en"]
    page = as_html([row])
    assert page.index("How it is known") < page.index("seen in 1 run") < page.index("What went wrong")
