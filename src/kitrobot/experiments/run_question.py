"""A question that every run answers with yes or no, read from one line of text.

    delivered                         a property that Check knows, or one of the mission's own, by its name
    done                              an outcome: done, failed, stuck or time
    never CONDITION                   the forms of properties, with conditions of docs/check.md
    eventually CONDITION
    after CONDITION eventually CONDITION
    stays CONDITION until CONDITION
    CONDITION                         as eventually

Behind each may stand `within SECONDS`. The run then has so much simulated time; of `after … eventually …` it says in
which time the second condition follows the first.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.mission.property_forms import AskedProperty, Form, is_ready
from kitrobot.mission.trial import LONGEST_CONDITION
from kitrobot.sim.run_spec import RunSpec
from kitrobot.sim.setup.limits import MAX_SECONDS
from kitrobot.sim.simulation import Simulation
from kitrobot.text.phrases import listed, shown
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.programs import AbstractionError
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.custom_properties import build_run_property
from kitrobot.verifier.properties.properties import Property, ready_properties
from kitrobot.verifier.report.replay import violation_tick

OUTCOMES: Final = ("done", "failed", "stuck", "time")
_LONGEST: Final = 2 * LONGEST_CONDITION + 100
_WITHIN = re.compile(r"(?s)(.*\S)\s+within\s+(\S+?)\s*s?")
_FORMS: Final = (
    (Form.NEVER, re.compile(r"(?s)never\s+(.+)")),
    (Form.EVENTUALLY, re.compile(r"(?s)eventually\s+(.+)")),
    (Form.AFTER, re.compile(r"(?s)after\s+(.+?)\s+eventually\s+(.+)")),
    (Form.STAYS, re.compile(r"(?s)stays\s+(.+?)\s+until\s+(.+)")),
)


class QuestionError(KitRobotError):
    """A question that no run can answer."""


@dataclass(frozen=True, slots=True)
class RunQuestion:
    """A question, not yet held against a mission; it can be sent to other processes.

    Attributes:
        text: as it was asked, without needless blanks.
        name: of a property or an outcome, "" where `asked` says what is asked.
        asked: a property in one of the four forms.
        within_s: simulated seconds; None: as long as a run takes.
    """

    text: str
    name: str = ""
    asked: AskedProperty | None = None
    within_s: float | None = None

    @property
    def run_seconds(self) -> float | None:
        """The time limit that it sets to runs; None: any."""
        return None if self.asked is not None and self.asked.form is Form.AFTER else self.within_s


@dataclass(frozen=True, slots=True)
class RunAnswer:
    """What one run answered: whether what is asked for holds, at which step that was known, and how the run ended by
    then ("" where it went on).
    """

    seed: int
    holds: bool
    tick: int
    sentence: str


def read_question(text: str) -> RunQuestion:
    """Reads a question.

    Raises:
        QuestionError: it is empty or too long, or its time makes no sense.
    """
    text = " ".join(text.split())
    if not text:
        raise QuestionError(Sentence("there is no question"), _FORM_HELP)
    if len(text) > _LONGEST:
        raise QuestionError(
            Sentence("expected at most {longest} characters in a question, found {count}", _LONGEST, len(text)),
            Sentence("put a longer property into the mission, and ask by its name"),
        )
    body, within = text, None
    timed = _WITHIN.fullmatch(text)
    if timed is not None:
        body, within = timed[1], _seconds(timed[2])
    for form, pattern in _FORMS:
        found = pattern.fullmatch(body)
        if found is not None:
            return RunQuestion(text, "", AskedProperty("asked", form, *found.groups()), within)
    if "(" in body or " " in body:
        return RunQuestion(text, "", AskedProperty("asked", Form.EVENTUALLY, body), within)
    return RunQuestion(text, body, None, within)


_FORM_HELP = Sentence("ask one like `delivered within 120` or `never any carrier (Collision.IsPressed())`")


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = math.nan
    if not 0 < seconds <= MAX_SECONDS:
        raise QuestionError(
            Sentence("expected seconds behind within, found {found}", shown(text)),
            Sentence("write a number larger than 0, as in `delivered within 120`"),
        )
    return seconds


class RunJudge:
    """Answers a question for the runs of a mission, one seed after the other.

    Args:
        question: what is asked.
        spec: the runs; with a time limit.

    Raises:
        QuestionError: the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
    """

    def __init__(self, question: RunQuestion, spec: RunSpec) -> None:
        limited = spec if question.run_seconds is None else replace(spec, seconds=question.run_seconds)
        self._run = run = limited.simulation()
        run.keep_beginning()
        self.robots = len(run.members)
        self.tick_ms = run.tick_ms
        self._outcome = ""
        self._is_reversed = False
        asked = question.asked or next((one for one in run.mission.properties if one.name == question.name), None)
        if asked is not None:
            # What comes eventually breaks the property that it never comes: such a run need not go on.
            self._is_reversed = asked.form is Form.EVENTUALLY
            judged = replace(asked, form=Form.NEVER) if self._is_reversed else asked
            self._property = build_run_property(judged, run, question.within_s)
            self.words: Sentence = asked.words
        elif question.name in OUTCOMES:
            self._outcome = question.name
            self._property = Property(question.name, Sentence(""), ends_as=(question.name,))
            self._is_reversed = True
            self.words = Sentence("a run ends with the outcome {outcome}", question.name)
        else:
            self._property = _ready_property(question.name, run)
            self.words = self._property.sentence
        if question.within_s is not None:
            self.words = Sentence("{question}, within {seconds} s", self.words, f"{question.within_s:g}")

    def answer(self, seed: int, stop: Callable[[], bool], is_plain: bool = False) -> RunAnswer | None:
        """What the run with that seed answers; None when `stop` said to break off."""
        run = self._run
        run.begin_again(seed)
        run.stays_plain = is_plain
        tick = violation_tick(self._property, run, (), stop)
        if tick < 0 and run.outcome is None:
            return None
        return RunAnswer(seed, (tick >= 0) == self._is_reversed, tick if tick >= 0 else run.tick, run.sentence)


def _ready_property(name: str, run: Simulation) -> Property:
    """The property of that name that fits the mission."""
    own = [one.name for one in run.mission.properties]
    found: list[Property] = []
    try:
        found = ready_properties(Model(run, abstract_run(run), 0, Timing.LOCKSTEP))
    except AbstractionError as error:
        if is_ready(name):
            raise QuestionError(
                Sentence("the ready properties of this mission are not known: {reason}", error.message),
                Sentence("ask for an outcome instead, as in `done within 120`"),
            ) from None
    for one in found:
        if one.name == name:
            return one
    known = [*OUTCOMES, *own, *(one.name for one in found)]
    raise QuestionError(
        Sentence("this mission has no property {name}", name),
        did_you_mean(name, known) or Sentence("its properties are: {names}", listed(known)),
    )
