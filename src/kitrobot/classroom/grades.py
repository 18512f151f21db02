"""The rows of a class: what came of each submission, as plain values in every language."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final

from kitrobot.translation.languages import LANGUAGES
from kitrobot.translation.reader_language import override_language, translate

LONGEST_TEXT: Final = 500
"""Characters of one sentence in a row."""

TextsByLanguage = dict[str, str]
"""A text in each language, by its code: `en`, `fr` …"""


@dataclass(frozen=True)
class GoalGrade:
    """What came of one goal: as `GoalVerdict`, in plain values. `why` of a property that is kept is how that is known.

    `condition`: the mission that the exercise begins with reaches it.
    """

    label: TextsByLanguage
    points: int
    hidden: bool
    reached: bool
    why: TextsByLanguage
    seed: int | None
    seconds: float | None
    runs: int
    of: int
    condition: bool = False


@dataclass(frozen=True)
class Grade:
    """A row: what came of a submission. `problem` says why it could not be judged; then there are no goals."""

    submission: str
    exercise: TextsByLanguage
    goals: tuple[GoalGrade, ...] = ()
    problem: TextsByLanguage | None = None

    @property
    def earned(self) -> tuple[int, ...]:
        """The points of each goal: all of them where it is reached, else none.

        A goal that is reached from the beginning is a condition of the others: it counts once one of those is reached
        that are none. So a mission that was handed in as it was earns nothing.
        """
        others = [goal for goal in self.goals if not goal.condition]
        counts = not others or any(goal.reached for goal in others)
        return tuple(goal.points if goal.reached and (counts or not goal.condition) else 0 for goal in self.goals)

    @property
    def points(self) -> int:
        """Points that were earned."""
        return sum(self.earned)

    @property
    def of(self) -> int:
        """Points of all goals."""
        return sum(goal.points for goal in self.goals)

    @property
    def full(self) -> bool:
        """Whether it was judged and every goal is reached."""
        return self.problem is None and all(goal.reached for goal in self.goals)

    def to_json(self) -> dict[str, Any]:
        """As plain values, in the published shape, in English."""
        made: dict[str, Any] = {
            "submission": self.submission,
            "exercise": self.exercise.get("en", ""),
            "points": self.points,
            "of": self.of,
            "problem": None if self.problem is None else self.problem["en"],
            "goals": [],
        }
        for goal, earned in zip(self.goals, self.earned, strict=True):
            texts = {"label": goal.label["en"], "why": goal.why["en"]}
            made["goals"].append({**asdict(goal), **texts, "earned": earned})
        return made


def translate_all(sentence: str) -> TextsByLanguage:
    """A sentence in every language."""
    made = {}
    for language in LANGUAGES:
        with override_language(language):
            made[language] = str(translate(sentence))[:LONGEST_TEXT]
    return made


def texts_of(texts: Mapping[str, str]) -> TextsByLanguage:
    """The texts of an XML file in every language; English where there is none."""
    return {language: texts.get("" if language == "en" else language) or texts.get("", "") for language in LANGUAGES}
