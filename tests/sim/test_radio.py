"""The radio: who hears whom, how late, what gets lost, and that copies are equal again when robots hear each other."""

from __future__ import annotations

import math
import random

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kitrobot.mission.radio import Radio
from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.primitives.robot import Robot
from kitrobot.sim.setup.limits import SimulationError
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import X, Y
from kitrobot.sim.team.radio import BEAT, is_in_reach, is_on, neighbours
from tests.effort import examples
from tests.sim.building import WHEEL, avatar, empty_world, run_of, steps
from tests.sim.team_building import RunningTeam, random_team_program
from tests.sim.teams import random_team
from tests.team_programs.hosting import TooLarge

SEEDS = st.integers(0, 10**9)
ROOM = empty_world(a=(500, 500, 0), b=(1500, 500, 0), c=(2500, 500, 0))
LEVEL = '<variable name="Level" type="integer" min="0" max="1000" shared="yes"/>'
RADIOS = st.builds(
    Radio,
    st.none() | st.sampled_from((200.0, 1200.0)),
    st.sampled_from((0, 30, 500)),
    st.sampled_from((0.0, 20.0, 80.0)),
)


def robot(*parts: str, name: str = "avatar") -> Robot:
    return avatar(*parts, LEVEL, '<variable name="Own" type="integer" min="0" max="1000"/>', name=name)


def levels(run: Simulation) -> list[int]:
    return [agent.values["Level"] for agent in run.agents]


def three(radio: Radio, failures: tuple[Failure, ...] = (), first: str = "Level.Set(7); WAIT(900);") -> Simulation:
    """Robots a metre apart, of which the first one writes."""
    others = {name: (robot(), "WAIT(900);") for name in "bc"}
    return run_of({"a": (robot(), first), **others}, ROOM, failures=failures, radio=radio, seconds=90)


def test_a_write_arrives_after_the_delay() -> None:
    run = three(Radio(delay_ms=100))
    assert [levels(steps(run, 1)) for _ in range(6)] == [[7, 0, 0]] * 5 + [[7, 7, 7]]


def test_who_is_out_of_range_hears_it_from_who_is_not() -> None:
    run = three(Radio(range_mm=1100))
    assert levels(steps(run, 1)) == [7, 7, 0]
    assert levels(steps(run, run.state.radio.numbers[BEAT])) == [7, 7, 7]
    assert levels(steps(three(Radio(range_mm=900)), 200)) == [7, 0, 0]


def test_what_is_lost_is_told_and_said_again() -> None:
    run = three(Radio(loss=50))
    told = []
    while levels(run) != [7, 7, 7]:
        run.step()
        told += [event.text for event in run.events if "lost" in event.text]
    assert set(told) <= {"did not hear a: the message got lost", "did not hear b: the message got lost"}
    assert levels(steps(three(Radio(loss=100)), 300)) == [7, 0, 0]


def test_two_halves_keep_their_own_and_the_later_write_wins_when_they_meet() -> None:
    cut = tuple(Failure(name, 0.1, FailureKind.APART) for name in "bc")
    healed = tuple(Failure(name, 3.0, FailureKind.REVIVE) for name in "bc")
    write = {"a": "WAIT(5); Level.Set(7); WAIT(900);", "b": "WAIT(6); Level.Set(8); Level.Set(9); WAIT(900);"}
    team = {name: (robot(), text) for name, text in write.items()}
    run = run_of({**team, "c": (robot(), "WAIT(900);")}, ROOM, failures=(*cut, *healed), radio=Radio())
    assert levels(steps(run, 140)) == [7, 9, 9]
    assert levels(steps(run, 30)) == [9, 9, 9]


def test_who_has_lost_its_radio_hears_nothing_and_everything_afterwards() -> None:
    failures = Failure("b", 0.0, FailureKind.MUTE), Failure("b", 1.0, FailureKind.REVIVE)
    run = three(Radio(), failures, "WAIT(1); Level.Set(7); WAIT(900);")
    assert levels(steps(run, 20)) == [7, 0, 7]
    assert levels(steps(run, 50)) == [7, 7, 7]


def test_robots_out_of_reach_wait_in_vain_and_the_run_says_so() -> None:
    others = {name: (robot(), "<Level.EqualTo(7)>( Own.Set(1); );") for name in "bc"}
    run = run_of({"a": (robot(), "Level.Set(7);"), **others}, ROOM, radio=Radio(range_mm=900), seconds=None)
    run.advance(10_000)
    assert run.outcome == "stuck", run.sentence
    run = run_of({"a": (robot(), "Level.Set(7);"), **others}, ROOM, radio=Radio(1100, 2000, 90), seconds=None)
    run.advance(100_000)
    assert run.outcome == "done", run.sentence


NEIGHBOURS = """<sensor name="Radio" device="neighbours" min="0" max="2">
<operation name="Value" value="yes"/></sensor>"""
HEARS = """<sensor name="Other" device="hears" of="{of}" type="boolean">
<operation name="IsTrue" test="equal" to="1"/></sensor>"""


def test_sensors_tell_who_is_in_reach() -> None:
    watching = robot(
        NEIGHBOURS, HEARS.format(of="c"), WHEEL.format(settings='speed="500" length="60"'), name="watching"
    )
    leaving = {"a": (watching, "Wheel.Advance(100); WAIT(900);"), **{n: (robot(), "WAIT(900);") for n in "bc"}}
    for radio, before, after in (
        (Radio(range_mm=1400), (1, 0), (2, 1)),
        (Radio(), (2, 1), (2, 1)),
        (None, (2, 1), (2, 1)),
    ):
        run = run_of(leaving, ROOM, radio=radio)
        assert tuple(steps(run, 3).agents[0].inputs.values()) == before
        assert tuple(steps(run, 100).agents[0].inputs.values()) == after
    run.inject_fault("c", "fail")
    assert tuple(steps(run, 3).agents[0].inputs.values()) == (1, 0)
    with pytest.raises(SimulationError, match=r"avatar\.Other: no agent “d” takes part"):
        run_of({"a": (robot(HEARS.format(of="d")), "")}, ROOM)


@given(SEEDS, st.integers(1, 12))
@settings(max_examples=examples(3))
def test_a_radio_that_reaches_all_at_once_changes_nothing(seed: int, robots: int) -> None:
    without, with_one = random_team(seed, robots), random_team(seed, robots, radio=Radio())
    for count in (1, 1, 7, 40, 100):
        without.advance(count)
        with_one.advance(count)
        # Of two writes in one tick, that of the later agent wins; with a radio, both are told.
        assert set(without.events) <= set(with_one.events)
        assert without.agents == with_one.agents
        assert without.poses() == with_one.poses()


@given(SEEDS, st.integers(2, 30), RADIOS)
@settings(max_examples=examples(5))
def test_reach_is_found_as_by_comparing_all_pairs(seed: int, robots: int, radio: Radio) -> None:
    run = random_team(seed, robots, radio=radio)
    for _ in range(4):
        run.advance(random.Random(seed).randrange(1, 40))
        state, members = run.state, range(len(run.members))
        for i in members:
            near = [j for j in members if j != i and is_on(j, state) and is_in_reach(i, j, state)]
            assert neighbours(i, state) == (len(near) if is_on(i, state) else 0)
            x, y = state.robots.floats[X], state.robots.floats[Y]
            assert all(math.hypot(x[j] - x[i], y[j] - y[i]) <= (radio.range_mm or math.inf) for j in near)


@given(SEEDS, st.integers(2, 8), st.sampled_from((0, 30, 500)), st.sampled_from((0.0, 20.0, 80.0)))
@settings(max_examples=examples(5))
def test_all_copies_are_equal_once_nobody_writes_and_all_hear_each_other(
    seed: int, robots: int, delay: int, loss: float
) -> None:
    rng = random.Random(seed)
    names = [f"r{n}" for n in range(robots)]
    world = empty_world(**{name: (200.0 * n + 100, 100, 0) for n, name in enumerate(names)})
    text = {
        name: " ".join(
            f"WAIT({rng.randrange(1, 6)}); Level.{rng.choice(('Set', 'Add'))}({rng.randrange(1, 9)});" for _ in range(5)
        )
        for name in names
    }
    kinds = (FailureKind.APART, FailureKind.MUTE, FailureKind.STALL, FailureKind.FAIL)
    failures = [Failure(rng.choice(names), rng.random() * 3, rng.choice(kinds)) for _ in range(4)]
    healed = [Failure(name, 4.0, FailureKind.REVIVE) for name in names]
    made = {name: (robot(), text[name] + " WAIT(9000);") for name in names}
    run = run_of(made, world, failures=[*failures, *healed], radio=Radio(None, delay, loss), seed=seed, seconds=900)
    run.advance(300)
    middle = run.snapshot()
    run.advance(2700)
    assert len(set(levels(run))) == 1
    again = run_of(made, world, failures=[*failures, *healed], radio=Radio(None, delay, loss), seed=seed, seconds=900)
    again.restore(middle)
    again.advance(2700)
    assert again.snapshot() == run.snapshot()


@given(SEEDS, st.integers(0, 1), st.sampled_from((Radio(delay_ms=40), Radio(loss=30), Radio(None, 20, 20))))
@settings(max_examples=examples(3))
def test_a_team_in_reach_does_the_same_however_late_and_lossy_its_messages(
    seed: int, spares: int, radio: Radio
) -> None:
    maker, program = random_team_program(seed, spares)
    try:
        teams = [RunningTeam(maker, program, seed, radio=one) for one in (None, radio)]
    except TooLarge:
        assume(False)
        raise
    for team in teams:
        while team.run.outcome is None and team.run.tick < 800:
            team.step()
    assert teams[1].run.outcome in (None, teams[0].run.outcome)
    for without, with_one in zip(*(team.lines_of_roles().values() for team in teams), strict=True):
        assert with_one == without[: len(with_one)]


@given(SEEDS)
@settings(max_examples=examples(10))
def test_of_two_halves_of_a_team_one_at_most_goes_on(seed: int) -> None:
    maker, program = random_team_program(seed, 1)
    rng = random.Random(seed)
    names = list(maker.agents)
    cut = rng.sample(names, rng.randrange(1, len(names)))
    at = rng.random() * 2
    try:
        team = RunningTeam(maker, program, seed, [Failure(name, at, FailureKind.APART) for name in cut], Radio())
    except TooLarge:
        assume(False)
        raise
    missed: set[str] = set()
    while team.run.outcome is None and team.run.tick < 1000:
        team.step()
        missed |= {event.agent for event in team.run.events if event.text == "is missed by its team"}
    assert not (missed & set(cut) and missed - set(cut))
