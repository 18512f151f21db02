"""What an exercise says of a mission that is at hand, in this process.

Left to others: files that strangers handed in, each in a process with limits (`grading`).
"""

from __future__ import annotations

from os import PathLike, fspath
from pathlib import Path

from kitrobot.checking.exercise_evaluation import Evaluation
from kitrobot.classroom.grader_process import evaluate_mission, exercise_of, ready_exercise
from kitrobot.workspace.mission_loader import OpenMission


def grade_mission(mission: OpenMission, exercise: str | PathLike[str] | None = None) -> Evaluation:
    """Judges every goal of an exercise, the hidden ones too; only the programs of the mission count.

    Args:
        mission: what is judged.
        exercise: the path of a `.exercise.xml`, with its first mission beside it; None: the exercise that comes with
            KitRobot whose programs the mission has.

    Raises:
        ProblemsError: the exercise or its mission has errors.
        KitRobotError: the mission is of another exercise.

    Examples:
        >>> import kitrobot
        >>> made = kitrobot.grade_mission(kitrobot.open_mission("exercises/07-red-line"))
        >>> [verdict.reached for verdict in made.verdicts]
        [True, False, False, False, False, True, True]
        >>> print(made.verdicts[2].why)
        once `any robot-1 (Light.IsRed())`, it stays so for 2 s: it never comes to that
    """
    ready = exercise_of(mission.mission) if exercise is None else ready_exercise(Path(fspath(exercise)))
    return evaluate_mission(mission.mission, ready)
