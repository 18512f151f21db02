"""The kinds of goals and how each is decided: a closed set, one class for each.

`fault` of a goal returns what is wrong with the given `evidence`, or None when the goal is reached. Run goals get each
run, program goals all programs, check goals what a check or a run says of the property. `exercise_xml` gives each its
element and attributes, whose names are those of the fields.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from kitrobot.diagnostics.model import Place
from kitrobot.exercise.evidence import CheckEvidence, PathPoint, ProgramEvidence, RunEvidence
from kitrobot.exercise.figures import figure_fault
from kitrobot.mission.property_forms import AskedProperty
from kitrobot.primitives.robot import Texts
from kitrobot.text.sentences import SEMICOLON, Sentence, Series


@dataclass(frozen=True)
class Fault:
    """Why a goal is not reached; `seconds` is when in the run, where that can be said.

    `seed` is of the run that shows it where that is another one than the run that was looked at.
    """

    sentence: str
    seconds: float | None = None
    seed: int | None = None


@dataclass(frozen=True)
class Goal:
    """What is asked for. `label` says it to a child; a hidden one is judged for the teacher only."""

    label: Texts
    points: int
    hidden: bool


@dataclass(frozen=True)
class RunGoal(Goal):
    """A goal that every run has to reach."""

    def fault(self, run: RunEvidence) -> Fault | None:
        """What is wrong with a run."""
        raise NotImplementedError

    @property
    def needs_path(self) -> bool:
        """Whether it asks where agents were."""
        return False


@dataclass(frozen=True)
class ProgramGoal(Goal):
    """A goal that is decided from the programs as they are drawn; `program` is the one that is meant, "" all."""

    program: str

    def fault(self, seen: ProgramEvidence) -> Fault | None:
        """What is wrong with the programs."""
        raise NotImplementedError

    def count(self, seen: ProgramEvidence, part: str) -> int:
        """How often a part is used."""
        return sum(
            found.get(part, 0) for name, found in seen.elements.items() if not self.program or name == self.program
        )


@dataclass(frozen=True)
class CheckGoal(Goal):
    """`<holds>`: a property holds. `states` bounds the exact search, behind which an approximate one finds what is
    broken; that it finds nothing counts if the goal is `approximate`.

    `property` is the name of a ready one. Of one of the exercise's own, `asked`, it is what that demands in words; one
    that counts seconds is judged by runs. `place` is where it stands in the exercise's file.
    """

    property: str
    timing: str
    failures: int
    states: int
    approximate: bool
    asked: AskedProperty | None = None
    place: Place | None = field(default=None, compare=False)

    def ground(self, seen: CheckEvidence) -> Sentence | str:
        """How a check knows that the goal is reached; "" where it is not."""
        if seen.answer == "holds":
            return Sentence("proved for every order of events of the model ({timing})", self.timing)
        if seen.answer == "nothing found" and self.approximate:
            return Sentence(
                "not proved; nothing was found in {states} states, and some may have been missed", f"{seen.states:,}"
            )
        return ""

    def fault(self, seen: CheckEvidence) -> Fault | None:
        """What is wrong with what a check or a run says of it."""
        match seen.answer:
            case "holds":
                return None
            case "vacuous":
                return Fault(Sentence("{property}: it never comes to that", seen.sentence))
            case "not finished":
                return Fault(
                    Sentence("{property}: not known, there are more than {states} states", seen.sentence, self.states)
                )
            case "nothing found":
                if self.approximate:
                    return None
                return Fault(
                    Sentence(
                        "{property}: not proved; nothing was found in {states} states, and some may have been missed",
                        seen.sentence,
                        f"{seen.states:,}",
                    )
                )
            case "none":
                return Fault(Sentence("this could not be checked: {reason}", seen.sentence))
        if not seen.steps and seen.seed is not None:
            return Fault(Sentence("{property}: a run breaks it", seen.sentence), seen.seconds, seen.seed)
        if not seen.steps:
            return Fault(Sentence("{property}: it can go wrong", seen.sentence))
        steps = Series(SEMICOLON, seen.steps)
        words = Sentence("{property}: it can go wrong when {steps}", seen.sentence, steps)
        return Fault(words, seen.seconds, seen.seed)


@dataclass(frozen=True)
class DoneGoal(RunGoal):
    """`<done>`: the run ends as done. The mission's own goals are reached, or without any every program has ended."""

    def fault(self, run: RunEvidence) -> Fault | None:
        return None if run.outcome == "done" else Fault(run.sentence, run.seconds)


@dataclass(frozen=True)
class NoContactGoal(RunGoal):
    """`<no-contact>`: the agent, "" none, never touches a wall, a thing or another robot."""

    agent: str

    def fault(self, run: RunEvidence) -> Fault | None:
        for contact in run.contacts:
            if self.agent in ("", contact.agent):
                return Fault(Sentence("`{agent}`: {what}", contact.agent, contact.text), contact.seconds)
        return None


@dataclass(frozen=True)
class TimeLimitGoal(RunGoal):
    """`<within>`: the run is done after at most so many seconds."""

    seconds: float

    def fault(self, run: RunEvidence) -> Fault | None:
        if run.outcome != "done":
            return Fault(run.sentence, run.seconds)
        if run.seconds <= self.seconds:
            return None
        found = f"{run.seconds:.1f}"
        words = Sentence("it took {found} s; at most {most} s are allowed", found, f"{self.seconds:g}")
        return Fault(words, self.seconds)


@dataclass(frozen=True)
class VisitGoal(RunGoal):
    """`<visits>`: the agent, "" any, comes at most `radius` mm near the place x, y of the world, in mm.

    `when` is `ever`, or `end`: it is there when the run ends.
    """

    x: float
    y: float
    radius: float
    agent: str
    when: str

    @property
    def needs_path(self) -> bool:
        return True

    def fault(self, run: RunEvidence) -> Fault | None:
        nearest, point = math.inf, PathPoint(0, 0, 0)
        for name, path in (run.paths or {}).items():
            if self.agent not in ("", name):
                continue
            for one in path if self.when == "ever" else path[-1:]:
                away = math.dist((one.x, one.y), (self.x, self.y))
                if away < nearest:
                    nearest, point = away, one
        if nearest <= self.radius:
            return None
        if nearest == math.inf:
            return Fault(Sentence("there is no robot `{name}`", self.agent))
        if self.when == "end":
            return Fault(Sentence("in the end it is {away} mm away from the place", round(nearest)), run.seconds)
        words = Sentence("the place was missed: {away} mm from it is as near as it got", round(nearest))
        return Fault(words, point.seconds)


@dataclass(frozen=True)
class DrawingGoal(RunGoal):
    """`<draws>`: the way of the agent, "" the first, is a regular figure (see `figures`).

    `by` is `way`, or `pen`: what its pen drew is the figure, in one line.
    """

    corners: int
    side: float
    tolerance: float
    agent: str
    by: str = "way"

    @property
    def needs_path(self) -> bool:
        return True

    def fault(self, run: RunEvidence) -> Fault | None:
        paths = run.paths or {}
        if self.by == "pen":
            lines = (run.lines or {}).get(self.agent or next(iter(paths), ""), ())
            if len(lines) != 1:
                return Fault(Sentence("expected one line that is drawn, found {found}", len(lines)), run.seconds)
            wrong = figure_fault(lines[0], self.corners, self.side, self.tolerance)
            return None if wrong is None else Fault(wrong, run.seconds)
        path = paths.get(self.agent) if self.agent else next(iter(paths.values()), None)
        if not path:
            return Fault(Sentence("there is no robot `{name}`", self.agent))
        wrong = figure_fault(path, self.corners, self.side, self.tolerance)
        return None if wrong is None else Fault(wrong, run.seconds)


@dataclass(frozen=True)
class UseGoal(ProgramGoal):
    """`<uses>`: a constructor or an object's method is used at least so many times."""

    part: str
    times: int

    def fault(self, seen: ProgramEvidence) -> Fault | None:
        found = self.count(seen, self.part)
        if found >= self.times:
            return None
        if self.times == 1:
            return Fault(Sentence("“{part}” is not in the program", seen.label_of(self.part)))
        part = seen.label_of(self.part)
        words = Sentence("“{part}” is there {found} times; it is asked for {times} times", part, found, self.times)
        return Fault(words)


@dataclass(frozen=True)
class AvoidanceGoal(ProgramGoal):
    """`<avoids>`: a constructor or an object's method is not used."""

    part: str

    def fault(self, seen: ProgramEvidence) -> Fault | None:
        if not self.count(seen, self.part):
            return None
        return Fault(Sentence("“{part}” is in the program, and is not allowed", seen.label_of(self.part)))


@dataclass(frozen=True)
class Parts(ProgramGoal):
    """`<parts>`: there are at most so many parts, Start and Stop and what is parked not counted."""

    most: int

    def fault(self, seen: ProgramEvidence) -> Fault | None:
        found = sum(
            sum(elements.values()) + seen.own.get(name, 0)
            for name, elements in seen.elements.items()
            if not self.program or name == self.program
        )
        if found <= self.most:
            return None
        return Fault(Sentence("there are {found} parts; at most {most} are allowed", found, self.most))
