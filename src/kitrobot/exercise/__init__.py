"""Exercises: a mission to begin with, and goals that are decided from runs, from the programs and by checking."""

from kitrobot.exercise.evidence import CheckSeen, Contact, PathPoint, ProgramsSeen, RunSeen
from kitrobot.exercise.figures import figure_fault
from kitrobot.exercise.goals import CheckGoal, Fault, Goal, ProgramGoal, RunGoal
from kitrobot.exercise.handing_out import without_hidden
from kitrobot.exercise.model import Exercise, Seed
from kitrobot.exercise.reading import read_exercise

__all__ = [
    "CheckGoal",
    "CheckSeen",
    "Contact",
    "Exercise",
    "Fault",
    "Goal",
    "PathPoint",
    "ProgramGoal",
    "ProgramsSeen",
    "RunGoal",
    "RunSeen",
    "Seed",
    "figure_fault",
    "read_exercise",
    "without_hidden",
]
