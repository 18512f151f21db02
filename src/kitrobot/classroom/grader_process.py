"""The process that judges one submission: its limits, and what it answers.

It is given the bytes of the submission and the exercise's file, never the submission's place. It may not write files,
and where the system has such limits its memory and processor time are bounded; its work is bounded by steps anyway
(`exercise_evaluation`). It answers once, in JSON, which runs nothing.
"""

from __future__ import annotations

import json
from contextlib import suppress
from dataclasses import asdict, dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, Final

from kitrobot.checking.exercise_evaluation import (
    Evaluation,
    EvaluationOptions,
    GoalVerdict,
    evaluate_submission,
    open_handed_in,
)
from kitrobot.classroom.grades import GoalGrade, texts_of, translate_all
from kitrobot.diagnostics.model import KitRobotError, Source
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.diagnostics.regular import named_file
from kitrobot.exercise.exercise_xml import read_exercise
from kitrobot.exercise.model import Exercise
from kitrobot.exercise.rules import START
from kitrobot.files.disk import read_bytes
from kitrobot.files.embedded_mission import carried_mission
from kitrobot.files.examples import examples_folder
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.child_processes import end_with_parent
from kitrobot.workspace.exercises import programs_of
from kitrobot.workspace.mission_loader import OpenMission, open_mission
from kitrobot.workspace.search_path import SearchPath

MOST_MEMORY_MB: Final = 1024
"""Memory of the process, in MB."""
MOST_CPU_S: Final = 120
"""Processor time of the process, in seconds; the largest exercise that comes along takes some seconds."""
EXERCISES: Final = "exercises"
"""The folder of the exercises among the examples."""


class ExerciseUnknownError(KitRobotError):
    """It cannot be told which exercise a submission is of."""


@dataclass(frozen=True)
class ReadyExercise:
    """An exercise with its mission opened."""

    path: Path
    exercise: Exercise
    start: OpenMission

    @property
    def folder(self) -> Path:
        """The folder that both are in."""
        return self.path.parent


def ready_exercise(path: Path) -> ReadyExercise:
    """The exercise of a file, with its mission.

    Raises:
        FileError: one of both cannot be read.
        ProblemsError: one of both has errors; all are told.
    """
    data = read_bytes(path)
    exercise, problems = read_exercise(data, str(path))
    source = Source(str(path), data.decode("utf-8-sig", errors="replace"))
    words = Sentence("the exercise `{exercise}` cannot be used", path)
    if exercise is None:
        raise ProblemsError(words, "", tuple(problems), (source,))
    beside = named_file(path.parent, exercise.start)
    if beside is None:
        message = Sentence("there is no mission `{mission}` beside this exercise", exercise.start)
        help = Sentence("put the mission that it begins with there")
        raise ProblemsError(words, "", (*problems, START(message, source.place(0, 1), help=help)), (source,))
    return ReadyExercise(path, exercise, open_mission(beside))


def shipped_exercises() -> list[Path]:
    """The files of the exercises that come with KitRobot."""
    folder = examples_folder()
    return [] if folder is None else sorted((folder / EXERCISES).glob("*.exercise.xml"))


def serve(connection: Connection, data: bytes, name: str, exercise: str | None) -> None:
    """Judges one submission and says what came of it, once."""
    end_with_parent()
    limit()
    try:
        answer = _judged(data, name, exercise)
    except KitRobotError as error:
        answer = _no(error.message)
    except MemoryError:
        answer = _no(Sentence("judging it took more than {most} MB of memory", MOST_MEMORY_MB))
    except RecursionError:
        answer = _no(Sentence("it is nested too deeply"))
    except Exception as error:
        answer = _no(Sentence("KitRobot itself went wrong ({kind}); please report it", type(error).__name__))
    with suppress(OSError):
        connection.send_bytes(json.dumps(answer).encode())
    connection.close()


def limit() -> None:
    """Takes from this process what a submission cannot need, where the system has such limits."""
    try:
        import resource
    except ImportError:
        return
    memory = MOST_MEMORY_MB * 1024 * 1024
    wanted = {
        "RLIMIT_CORE": (0, 0),
        "RLIMIT_CPU": (MOST_CPU_S, MOST_CPU_S + 5),
        "RLIMIT_DATA": (memory, memory),
        "RLIMIT_FSIZE": (0, 0),
    }
    for limit, values in wanted.items():
        with suppress(AttributeError, OSError, ValueError):
            resource.setrlimit(getattr(resource, limit), values)


def _judged(data: bytes, name: str, exercise: str | None) -> dict[str, Any]:
    data, name = carried_mission(data, name)
    mission, problems = read_mission(data, name)
    if mission is None:
        raise KitRobotError(next(one.message for one in problems if one.is_error))
    ready = ready_exercise(Path(exercise)) if exercise is not None else exercise_of(mission)
    made = evaluate_mission(mission, ready)
    return {
        "exercise": texts_of(ready.exercise.label),
        "file": str(ready.path),
        "goals": [asdict(goal_grade(verdict)) for verdict in made.verdicts],
        "problem": None,
    }


def evaluate_mission(mission: Mission, ready: ReadyExercise) -> Evaluation:
    """What comes of every goal of an exercise, the hidden ones too.

    Raises:
        AnotherMissionError: the mission is of another exercise.
    """
    opened = open_handed_in(ready.start, mission, SearchPath(ready.folder))
    return evaluate_submission(ready.exercise, opened, EvaluationOptions(hidden=True), start=ready.start)


def exercise_of(mission: Mission) -> ReadyExercise:
    """The exercise that comes along whose programs the mission has.

    Raises:
        ExerciseUnknownError: there is none, or there are several.
    """
    ours = {program.name for program in mission.programs}
    found = [one for one in map(ready_exercise, shipped_exercises()) if set(programs_of(one.start.mission)) <= ours]
    if len(found) != 1:
        raise ExerciseUnknownError(
            Sentence("it has the programs of no exercise that comes with KitRobot; say which with --exercise")
            if not found
            else Sentence("it has the programs of several exercises; say which with --exercise")
        )
    return found[0]


def goal_grade(verdict: GoalVerdict) -> GoalGrade:
    """A verdict in plain values; whether the goal is a condition is not known here."""
    goal = verdict.goal
    return GoalGrade(
        texts_of(goal.label),
        goal.points,
        goal.hidden,
        bool(verdict.reached),
        translate_all(verdict.why or verdict.runs_ground),
        verdict.seed,
        verdict.seconds,
        verdict.runs,
        verdict.of,
    )


def _no(why: str) -> dict[str, Any]:
    return {"exercise": {}, "file": "", "goals": [], "problem": translate_all(why)}
