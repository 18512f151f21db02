"""A question that every run answers with yes or no: a line of text (`mission.property_text`) held against a mission.

A name is that of a property that Check knows, of one of the mission's own, or of an outcome: `done`, `failed`, `stuck`,
`time`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Final

from kitrobot.mission.property_forms import Form, is_ready
from kitrobot.mission.property_text import PropertyText, QuestionError, words_within
from kitrobot.sim.run_spec import RunSpec
from kitrobot.sim.setup.limits import MAX_SECONDS
from kitrobot.sim.simulation import Simulation
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.programs import AbstractionError
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.custom_properties import build_run_property
from kitrobot.verifier.properties.properties import Property, ready_properties
from kitrobot.verifier.report.replay import InjectedFault, judge_run

_BEHIND_S: Final = 1.0
"""Seconds that a run goes on behind a deadline."""
OUTCOMES: Final = ("done", "failed", "stuck", "time")


@dataclass(frozen=True, slots=True)
class RunAnswer:
    """What one run answered: whether what is asked for holds, at which step that was known, and how the run ended by
    then ("" where it went on).
    """

    seed: int
    holds: bool
    tick: int
    sentence: str


@dataclass(frozen=True, slots=True)
class RunProperty:
    """What a run is monitored for.

    Attributes:
        property: what is monitored.
        words: what is asked.
        is_reversed: whether a run that breaks the property is one in which what is asked holds, as of outcomes.
    """

    property: Property
    words: Sentence
    is_reversed: bool = False


def find_run_property(question: PropertyText, run: Simulation) -> RunProperty:
    """The property of a question, as runs of a mission are judged by it; `run` is one of them.

    Raises:
        QuestionError: the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
    """
    asked = question.asked or next((one for one in run.mission.properties if one.name == question.name), None)
    if asked is not None:
        found = RunProperty(build_run_property(asked, run), asked.words)
    elif question.name in OUTCOMES:
        words = Sentence("a run ends with the outcome {outcome}", question.name)
        found = RunProperty(Property(question.name, words, ends_as=(question.name,)), words, True)
    else:
        ready = find_ready_property(question.name, run)
        found = RunProperty(ready, ready.sentence)
    return replace(found, words=words_within(found.words, question.within_s))


class RunJudge:
    """Answers a question for the runs of a mission, one seed after the other.

    Args:
        question: what is asked.
        spec: the runs; with a time limit.

    Raises:
        QuestionError: the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
    """

    def __init__(self, question: PropertyText, spec: RunSpec) -> None:
        self._run = run = with_time_of(question, spec).simulation()
        run.keep_beginning()
        self.robots = len(run.members)
        self.tick_ms = run.tick_ms
        self._property = find_run_property(question, run)
        self.words: Sentence = self._property.words

    def answer(
        self,
        seed: int,
        stop: Callable[[], bool],
        is_plain: bool = False,
        faults: Sequence[InjectedFault] = (),
    ) -> RunAnswer | None:
        """What the run with that seed, and with these faults, answers; None when `stop` said to break off."""
        run = self._run
        run.begin_again(seed)
        run.stays_plain = is_plain
        is_broken, tick = judge_run(self._property.property, run, faults, stop)
        if is_broken is None:
            return None
        return RunAnswer(seed, is_broken == self._property.is_reversed, tick, run.sentence)


def with_time_of(question: PropertyText, spec: RunSpec) -> RunSpec:
    """The runs with the time that the question sets, or needs so that a deadline in it can pass."""
    if question.within_s is not None:
        return replace(spec, seconds=question.within_s)
    asked = question.asked
    if asked is None or not asked.seconds or spec.seconds is None or asked.form not in (Form.EVENTUALLY, Form.VISIT):
        return spec
    return replace(spec, seconds=max(spec.seconds, min(asked.seconds + _BEHIND_S, MAX_SECONDS)))


def ready_properties_of(run: Simulation) -> list[Property]:
    """The ready properties that fit the mission of a run, as runs are judged by them.

    Raises:
        AbstractionError: the mission has no model, which they are made from.
    """
    return ready_properties(Model(run, abstract_run(run), 0, Timing.LOCKSTEP))


def find_ready_property(name: str, run: Simulation) -> Property:
    """The ready property of that name that fits the mission of a run.

    Raises:
        QuestionError: there is none.
    """
    own = [one.name for one in run.mission.properties]
    found: list[Property] = []
    try:
        found = ready_properties_of(run)
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
