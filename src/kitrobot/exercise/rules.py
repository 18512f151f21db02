"""The rules of exercises: what can be wrong with one beyond its XML."""

from __future__ import annotations

from kitrobot.diagnostics.model import Severity, rule

GOAL = rule(
    "exercise-goal",
    Severity.ERROR,
    "A goal of an exercise cannot be judged",
    "Every goal has a `<label>` in English; `<within>` is at most the `seconds` of the exercise, and `<holds>` names a "
    "property of `kitrobot verify` or has a form of a mission's properties, about what its first mission has.",
)
START = rule(
    "exercise-start",
    Severity.ERROR,
    "An exercise lacks what it is made of",
    "An exercise has a `<label>` in English, at least one goal and one seed that are not hidden, each seed once, and "
    "`start` is the file name of a `.krt` in its folder.",
)
