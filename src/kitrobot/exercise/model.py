"""An exercise as it was read."""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.exercise.goals import Goal
from kitrobot.primitives.robot import Texts
from kitrobot.xml.lessons import LAST


@dataclass(frozen=True)
class Seed:
    """Where chance begins in one of the runs; a hidden one is for the teacher only."""

    value: int
    hidden: bool = False


@dataclass(frozen=True)
class Exercise:
    """An exercise; `start` is the `.krt` beside it that it begins with.

    `seconds` is the simulated time that each run may take, `order` its place on the path to learn. There is at least
    one goal and one seed that is not hidden.
    """

    start: str
    label: Texts
    help: Texts
    icon: str
    seconds: float
    goals: tuple[Goal, ...]
    seeds: tuple[Seed, ...]
    order: int = LAST

    def goals_for(self, hidden: bool) -> tuple[Goal, ...]:
        """The goals that are judged: with or without the hidden ones."""
        return tuple(goal for goal in self.goals if hidden or not goal.hidden)

    def seeds_for(self, hidden: bool) -> tuple[int, ...]:
        """The seeds of the runs that are judged."""
        return tuple(seed.value for seed in self.seeds if hidden or not seed.hidden)
