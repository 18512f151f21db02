"""An explanation in at most three sentences: what happened, the moment that decided it, what would have avoided it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.verdicts import Counterexample
from kitrobot.verifier.report.avoidance import Avoidance, Certainty
from kitrobot.verifier.report.counterexample_text import describe_any_step, describe_step
from kitrobot.verifier.report.minimization import is_fault
from kitrobot.verifier.tables.bodies import RUNS

_MOST = 3
"""Events, or agents, that one sentence names."""


def describe_explanation(
    model: Model, one: Property, run: Counterexample, avoidance: Avoidance
) -> tuple[Sentence, ...]:
    """The sentences about a run that breaks a property."""
    return (_what_happened(model, one, run), *_what_decided(model, run, avoidance))


def _what_happened(model: Model, one: Property, run: Counterexample) -> Sentence:
    if run.repeats_from >= 0:
        if run.repeats_from < len(run.steps):
            return Sentence("the same steps come again and again, and `{property}` waits in vain", one.name)
        waiting = list(_waiting(model, run))
        if not waiting:
            return Sentence("nothing happens any more, and `{property}` is broken", one.name)
        agents, more = Series(COMMA, waiting[:_MOST]), len(waiting) - _MOST
        if more > 0:
            return Sentence("nothing happens any more: {agents} and {count} more wait for ever", agents, more)
        if len(waiting) > 1:
            return Sentence("nothing happens any more: {agents} wait for ever", agents)
        return Sentence("nothing happens any more: {agent} waits for ever", waiting[0])
    if not run.steps:
        return Sentence("the very first state breaks `{property}`", one.name)
    events = describe_any_step(model, run.states[-2], run.steps[-1])
    named = events[-1:] if _has_events(model, run, len(run.steps) - 1) else events
    return Sentence("{event}: this breaks `{property}`", _joined(named), one.name)


def _waiting(model: Model, run: Counterexample) -> Iterator[str]:
    for i, part in enumerate(model.parts):
        inside = model.inside(i, run.states[-1][1 + i])
        if inside.down == RUNS and not model.has_ended(i, inside):
            yield part.agent.name


def _what_decided(model: Model, run: Counterexample, avoidance: Avoidance) -> Iterator[Sentence]:
    other, at = avoidance.other, avoidance.step
    if avoidance.certainty is Certainty.NEVER:
        yield Sentence("every order of events breaks it: nothing that robots do earlier or later avoids it")
        yield Sentence("only another program or another world helps")
        return
    if other is None:
        yield Sentence("the search ended before it knew whether it could be avoided: more time may tell")
        return
    taken, instead = _said(model, run, at), _said(model, other, at)
    if avoidance.certainty is Certainty.ALWAYS:
        yield Sentence("it is never too late: what is waited for can still come")
        yield from _what_helps(model, other, at)
        return
    if model.timing is Timing.LOCKSTEP and not _has_events(model, other, at):
        # That all go on in their programs is no other way, where they do in any case.
        instead = []
    decided = [one for one in taken if one not in instead] or taken
    others = [one for one in instead if one not in taken]
    if avoidance.certainty is Certainty.UNKNOWN:
        yield Sentence("this is the last moment known at which it could still be avoided: {events}", _joined(decided))
    elif run.repeats_from < 0 and at == len(run.steps) - 1:
        yield Sentence("until that very moment it could still be avoided")
    elif others and model.timing is Timing.LOCKSTEP and not _has_events(model, run, at):
        yield Sentence("it is decided because this does not come yet: {events}", _joined(others))
        yield Sentence("it does not break if that comes in time")
        return
    else:
        yield Sentence("this decides it: {events}", _joined(decided))
    if any(is_fault(event) for event in run.steps[at].events):
        yield Sentence("it does not break without that failure")
    elif others and any(
        one in _said(model, other, later) for later in range(at + 1, len(other.steps)) for one in decided
    ):
        yield Sentence("it does not break if this comes first: {events}", _joined(others))
    elif others:
        yield Sentence("it does not break if this happens instead: {events}", _joined(others))
    else:
        yield Sentence("it does not break if that comes later, or not at all")


def _what_helps(model: Model, other: Counterexample, at: int) -> Iterator[Sentence]:
    """The first event of the other way that comes by itself, as far as there is one."""
    for step in range(at, len(other.steps)):
        if _has_events(model, other, step):
            yield Sentence("it comes after this: {events}", _joined(_said(model, other, step)))
            return


def _has_events(model: Model, run: Counterexample, at: int) -> bool:
    """Whether anything but ticks happens in a step; False behind the end."""
    return at < len(run.steps) and any(True for _ in describe_step(model, run.states[at], run.steps[at], {}))


def _said(model: Model, run: Counterexample, at: int) -> list[Sentence]:
    """What happens in a step of a run; nothing behind its end."""
    return describe_any_step(model, run.states[at], run.steps[at]) if at < len(run.steps) else []


def _joined(events: Sequence[Sentence]) -> Series:
    return Series(COMMA, events[:_MOST])
