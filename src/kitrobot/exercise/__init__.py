"""Exercises: a mission to begin with, and goals that are decided from runs, from the programs and by checking."""

from kitrobot.exercise.evidence import CheckEvidence, Contact, PathPoint, ProgramEvidence, RunEvidence
from kitrobot.exercise.exercise_xml import read_exercise
from kitrobot.exercise.figures import figure_fault
from kitrobot.exercise.goals import CheckGoal, Fault, Goal, ProgramGoal, RunGoal
from kitrobot.exercise.hidden_parts import remove_hidden_parts
from kitrobot.exercise.model import Exercise, Seed

__all__ = [
    "CheckEvidence",
    "CheckGoal",
    "Contact",
    "Exercise",
    "Fault",
    "Goal",
    "PathPoint",
    "ProgramEvidence",
    "ProgramGoal",
    "RunEvidence",
    "RunGoal",
    "Seed",
    "figure_fault",
    "read_exercise",
    "remove_hidden_parts",
]
