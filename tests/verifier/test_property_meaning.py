"""What properties mean on a run: the automaton that judges runs and recordings, and the plain reference, agree."""

from __future__ import annotations

import copy
import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.mission.property_forms import AskedProperty, Form, VisitOrder
from kitrobot.verifier.properties.property_automaton import PropertyAutomaton, PropertyState
from tests.effort import examples
from tests.verifier.reference.property_meaning import Trace, is_broken_by_end, is_broken_so_far

TICK_MS = 20
LISTED = ("any a (A.B())", "any a (B.C())", "any a (C.D())")


@st.composite
def properties(draw: st.DrawFn) -> AskedProperty:
    form = draw(st.sampled_from(Form))
    size = draw(st.integers(1, 3))
    first = "; ".join(LISTED[:size]) if form in (Form.AGAIN, Form.VISIT) else "A"
    two = form in (Form.AFTER, Form.STAYS, Form.BEFORE) or (form is Form.NEVER and draw(st.booleans()))
    timed = form in (Form.AFTER, Form.EVENTUALLY, Form.HOLDS, Form.AGAIN, Form.VISIT)
    seconds = draw(st.sampled_from((0.0, 0.02, 0.03, 0.04, 0.05, 0.1, 0.13))) if timed else 0.0
    return AskedProperty(
        "asked", form, first, "B" if two else "", seconds, draw(st.integers(0, 3)), draw(st.sampled_from(VisitOrder))
    )


def sparse(rng: random.Random, size: int) -> Trace:
    """A trace in which few things hold, so that orders and deadlines are often kept."""
    often = rng.choice((0.1, 0.3, 0.6))
    return [tuple(rng.random() < often for _ in range(size)) for _ in range(rng.randrange(14))]


def judge(one: AskedProperty, trace: Trace) -> tuple[PropertyAutomaton, int]:
    """The automaton after a trace, and the tick in which it was broken; -1 for none."""
    automaton = PropertyAutomaton(one, TICK_MS)
    for tick, now in enumerate(trace):
        if automaton.read(tick, now) is PropertyState.BROKEN:
            return automaton, tick
    return automaton, -1


def check(one: AskedProperty, trace: Trace) -> tuple[bool, bool]:
    """Compares both on a trace and all its beginnings; whether it is broken, and whether by its end."""
    automaton, broken = judge(one, trace)
    first = next((n for n in range(len(trace)) if is_broken_so_far(one, trace[: n + 1], TICK_MS)), -1)
    assert broken == first, (one, trace)
    by_end = is_broken_by_end(one, trace, TICK_MS)
    assert automaton.is_broken_by_end() == by_end, (one, trace)
    if automaton.standing is PropertyState.KEPT:
        rest = [tuple(not value for value in trace[-1]), *reversed(trace)] if trace else []
        assert not is_broken_by_end(one, [*trace, *rest], TICK_MS)
    return broken >= 0, by_end


@given(properties(), st.randoms(use_true_random=False))
def test_each_trace_is_judged_as_the_reference_judges_it(one: AskedProperty, rng: random.Random) -> None:
    check(one, sparse(rng, len(one.conditions)))


def test_very_many_random_traces_break_and_keep_every_form() -> None:
    rng, said = random.Random(41), set()
    for _ in range(examples(3000, 300_000)):
        form, order = rng.choice(list(Form)), rng.choice(list(VisitOrder))
        first = "; ".join(LISTED[: rng.randint(1, 3)]) if form in (Form.AGAIN, Form.VISIT) else "A"
        second = "B" if form in (Form.AFTER, Form.STAYS, Form.BEFORE) else ""
        seconds = rng.choice((0.0, 0.04, 0.1)) if form in (Form.AFTER, Form.HOLDS, Form.AGAIN, Form.VISIT) else 0.0
        one = AskedProperty("asked", form, first, second, seconds, rng.randint(0, 2), order)
        said.add((form, *check(one, sparse(rng, len(one.conditions)))))
    for form in Form:
        assert (form, False, False) in said
        assert any((form, *broken) in said for broken in ((True, True), (False, True)))


def test_a_copy_goes_on_by_itself() -> None:
    one = AskedProperty("asked", Form.VISIT, "; ".join(LISTED), order=VisitOrder.TURN)
    first = PropertyAutomaton(one, TICK_MS)
    first.read(1, (True, False, False))
    second = copy.deepcopy(first)
    assert first.read(2, (False, False, True)) is PropertyState.BROKEN
    assert second.read(2, (False, True, False)) is PropertyState.OPEN


@pytest.mark.parametrize(
    ("seconds", "last"), [(0.02, 1), (0.039, 1), (0.04, 2), (0.1, 5), (0.3, 15), (1 / 3, 16), (600, 30_000)]
)
def test_a_deadline_is_kept_at_its_last_tick_and_broken_one_later(seconds: float, last: int) -> None:
    one = AskedProperty("asked", Form.EVENTUALLY, "A", seconds=seconds)
    automaton = PropertyAutomaton(one, TICK_MS)
    assert automaton.read(last, (False,)) is PropertyState.OPEN
    assert copy.deepcopy(automaton).read(last + 1, (True,)) is PropertyState.BROKEN
