"""A walk by hand: its states are those of the check, its steps can be taken again and taken back."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from kitrobot.checking.mission_walk import begin_walk
from kitrobot.checking.verification import VerificationError, VerificationOptions, verify
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.exploration import explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.verdicts import Answer
from kitrobot.verifier.report.state_walk import MOST_AT_ONCE, MOST_STEPS, StateWalk, StateWalkError
from tests.effort import cases
from tests.verifier.check_fixtures import EXAMPLES, mutant, prepared
from tests.verifier.test_known_answers import UNCOUNTED

MISSIONS = cases(
    ["exchange", "traffic-light"], sorted(path.name for path in EXAMPLES.iterdir() if path.name != "exercises")
)


def _mission(name: str) -> Path:
    return EXAMPLES / name / f"{name}.krt"


def _situation(walk: StateWalk) -> tuple[object, ...]:
    """All that a walk shows of its state."""
    return (
        walk.list_steps(),
        walk.describe_last_step(),
        walk.describe_situation(),
        walk.describe_robots(),
        walk.describe_shared(),
        walk.draw(),
    )


@pytest.mark.parametrize("timing", Timing)
@pytest.mark.parametrize("name", MISSIONS)
def test_the_same_steps_lead_to_the_same_state_and_taking_them_back_leads_back(name: str, timing: Timing) -> None:
    if not _mission(name).exists():
        pytest.fail(f"there is no {name}")
    ready = prepared(_mission(name))
    rng = random.Random(1)
    walk = begin_walk(ready, timing, 1)
    seen = [_situation(walk)]
    while walk.list_steps() and len(walk.places) < 15:
        walk.take_step(rng.choice(walk.list_steps()).place)
        seen.append(_situation(walk))
    again = begin_walk(ready, timing, 1)
    for place in walk.places:
        again.take_step(place)
    assert _situation(again) == seen[-1]
    for expected in reversed(seen[:-1]):
        walk.go_back()
        assert _situation(walk) == expected
    walk.go_back()
    assert _situation(walk) == seen[0]


@pytest.mark.parametrize("timing", cases([Timing.LOCKSTEP, Timing.PROMPT], [Timing.FREE]))
def test_walks_reach_the_states_of_the_check_and_no_others(tmp_path: Path, timing: Timing) -> None:
    ready = mutant(tmp_path, carriers=1, stock=1)
    run = ready.spec.simulation(1)
    space = explore(Model(run, abstract_run(run), 0, timing), Budget(50_000), keeps_steps=False)
    assert space.complete
    walk = begin_walk(ready, timing)
    reached = {walk.state}
    ahead: list[tuple[int, ...]] = [()]
    while ahead:
        places = ahead.pop()
        walk.go_back(MOST_STEPS)
        for place in places:
            walk.take_step(place)
        for step in walk.list_steps():
            walk.take_step(step.place)
            if walk.state not in reached:
                reached.add(walk.state)
                ahead.append((*places, step.place))
            walk.go_back()
        assert len(reached) <= len(space)
    assert len(reached) == len(space)


@pytest.mark.parametrize(("timing", "carriers"), [(Timing.LOCKSTEP, 2), (Timing.PROMPT, 2), (Timing.FREE, 1)])
def test_a_broken_run_is_walked_to_its_end(tmp_path: Path, timing: Timing, carriers: int) -> None:
    ready = mutant(tmp_path, UNCOUNTED, carriers=carriers, stock=1)
    options = VerificationOptions(timings=(timing,), draws=True, explains=True, confirms=False, seconds=None)
    made = verify(ready, options)
    broken = [one for one in made.columns[0].findings if one.verdict.answer is Answer.BROKEN]
    assert broken
    for finding in broken:
        run = finding.verdict.counterexample
        assert run is not None
        assert len(finding.places) == len(run.steps)
        walk = begin_walk(ready, timing)
        for number, place in enumerate(finding.places):
            walk.take_step(place)
            said = [str(text) for step, text in finding.story if step == number]
            happened = [str(text) for text in walk.describe_last_step()]
            assert said == [] or set(said) & set(happened) or "reads" in said[0], (number, said, happened)
        if run.repeats_from < 0:
            name = finding.verdict.property.name
            assert any(f"`{name}`" in str(text) for text in walk.describe_situation())


def test_going_on_stops_before_a_choice_and_where_it_has_been(tmp_path: Path) -> None:
    walk = begin_walk(mutant(tmp_path), Timing.FREE)
    assert walk.go_on() == 0, "several carriers may begin"
    blink = begin_walk(prepared(_mission("blink")), Timing.LOCKSTEP)
    assert 0 < blink.go_on() <= MOST_AT_ONCE
    assert blink.list_steps() == ()
    assert [str(text) for text in blink.describe_situation()] == ["the mission is done"]


def test_a_step_back_to_a_state_of_the_walk_says_which() -> None:
    walk = begin_walk(prepared(_mission("dice")), Timing.PROMPT)
    rng, back = random.Random(1), None
    while back is None:
        steps = walk.list_steps()
        back = next((step for step in steps if step.returns_to >= 0), None)
        walk.take_step((back or rng.choice(steps)).place)
    assert f"this is state {back.returns_to} again" in map(str, walk.describe_situation())


def test_what_is_not_possible_is_refused_and_nothing_is_taken() -> None:
    ready = prepared(_mission("exchange"))
    walk = begin_walk(ready)
    for place in (-1, walk.count_steps(), 10**9):
        with pytest.raises(StateWalkError, match="there is no step"):
            walk.take_step(place)
    assert walk.places == []
    with pytest.raises(VerificationError, match="0 to 3 failures"):
        begin_walk(ready, failures=4)


def test_a_failed_robot_is_told_and_the_mission_is_not_done() -> None:
    walk = begin_walk(prepared(_mission("brake")), Timing.PROMPT, 1)
    failure = next(step for step in walk.list_steps() if step.is_failure)
    walk.take_step(failure.place)
    assert [str(text) for text in walk.describe_robots()[0].facts] == ["has failed"]
    assert "not done" in str(walk.describe_situation()[0])
