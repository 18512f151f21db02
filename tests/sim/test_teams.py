"""Teams in the simulator: their robots do what the team's program says, and wait for one another at its points."""

from __future__ import annotations

import random

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kitrobot.lll.parse_results import parse_team
from kitrobot.mission.radio import Radio
from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.team_columns import HAS_UNIT, LOST_UNIT, NO_UNIT, T_HOLDER, W_LEFT, W_TAKEN
from tests.effort import examples
from tests.sim.team_building import RunningTeam, random_team_program
from tests.team_programs.hosting import TooLarge
from tests.team_programs.making import TeamMaker
from tests.team_programs.reference import Meaning, TooLong

SEEDS = st.integers(0, 10**9)


def team_and_meaning(seed: int, spares: int = 0, asks: bool = True) -> tuple[RunningTeam, Meaning]:
    """A random team before its first step, and what it is to do."""
    maker, program = random_team_program(seed, spares, asks)
    roles = {name: role for name, (_, role) in maker.agents.items() if role}
    meaning = Meaning(roles, maker.sets(program), maker.programs, left=dict(maker.works))
    try:
        meaning.seq(program.seq, list(roles))
        return RunningTeam(maker, program, seed), meaning
    except (TooLong, TooLarge):
        assume(False)
        raise


@given(SEEDS, st.integers(0, 1))
@settings(max_examples=examples(8))
def test_every_robot_does_its_lines_and_nobody_goes_on_before_all_are_there(seed: int, spares: int) -> None:
    team, meaning = team_and_meaning(seed, spares)
    team.finish()
    assert team.run.outcome == "done", team.run.sentence
    assert {name: lines for name, lines in team.lines.items() if name in meaning.lines} == meaning.lines
    assert not any(lines for name, lines in team.lines.items() if name not in meaning.lines)
    assert team.left() == meaning.left
    for moment in meaning.before:
        logs = [(team.moments[name], count) for name, count in moment.items()]
        over = [log[count - 1][1] for log, count in logs if count]
        begun = [log[count][0] for log, count in logs if count < len(log)]
        assert not over or not begun or max(over) <= min(begun)


@given(SEEDS)
@settings(max_examples=examples(8))
def test_from_a_snapshot_another_run_goes_on_alike(seed: int) -> None:
    team, _ = team_and_meaning(seed, 1)
    run, other = team.run, team.anew()
    run.advance(random.Random(seed).randrange(1, 200))
    other.restore(run.snapshot())
    for one in (run, other):
        while one.outcome is None:
            one.advance(1000)
    assert run.snapshot() == other.snapshot()
    assert (run.outcome, run.sentence) == (other.outcome, other.sentence)


@given(SEEDS, st.lists(st.integers(0, 80), min_size=1, max_size=4))
@settings(max_examples=examples(10))
def test_a_substitute_goes_on_with_what_was_lost_and_no_role_is_held_twice(seed: int, moments: list[int]) -> None:
    team, meaning = team_and_meaning(seed, spares=2, asks=False)
    run, chance = team.run, random.Random(seed)
    kinds = {agent.name: agent.robot.name for agent in run.members}
    left = {"ant": 2, "bee": 2}
    for steps in moments:
        for _ in range(steps):
            if run.outcome is None:
                team.step()
        going = [name for name in team.playing() if left[kinds[name]]]
        going = [name for name in going if run.view(team.names.index(name)).state not in ("failed", "stalled")]
        if going and run.outcome is None:
            name = chance.choice(going)
            left[kinds[name]] -= 1
            run.inject_fault(name, chance.choice(("fail", "stall", "mute")))
    while run.outcome is None:
        team.step()
        seats = [seat for seat in run.state.team.robots[T_HOLDER] if seat >= 0]
        assert len(seats) == len(set(seats)) == len(team.playing())
    assert run.outcome == "done", run.sentence
    assert team.lines_of_roles() == meaning.lines
    assert not any(run.state.team.works[W_TAKEN])
    assert all(0 <= team.left()[work] <= left for work, left in meaning.left.items())


@given(SEEDS, st.lists(st.integers(0, 80), min_size=1, max_size=4))
@settings(max_examples=examples(8))
def test_without_spare_robots_the_run_still_ends_and_says_why(seed: int, moments: list[int]) -> None:
    team, meaning = team_and_meaning(seed)
    run, chance = team.run, random.Random(seed)
    for steps in moments:
        run.advance(steps)
        if run.outcome is None:
            run.inject_fault(chance.choice(team.names), chance.choice(("fail", "stall", "mute", "revive")))
    while run.outcome is None:
        run.advance(1000)
    assert run.outcome != "time", run.sentence
    assert run.seconds < 300
    assert meaning.steps > 0


def small(text: str, agents: dict[str, str], failures: list[Failure]) -> Simulation:
    """A team of ants in the simulator, from the text of its program."""
    parsed = parse_team(text)
    assert parsed.diagnostics == []
    maker = TeamMaker(random.Random(0))
    maker.agents = {name: ("ant", role) for name, role in agents.items()}
    return RunningTeam(maker, parsed.program, 1, failures).run


PAIR = """role scout: ant 2;
group scouts = scout on failure {failure};

SeqOfPar scouts (
  Arm.Do(1);
  WAIT(100);
  Arm.Do(2);
);
"""


def ended(run: Simulation) -> Simulation:
    while run.outcome is None:
        run.advance(100)
    return run


def told(run: Simulation) -> list[tuple[str, str]]:
    """Who said what, but for the ends of programs."""
    found = []
    while run.outcome is None:
        run.step()
        found += [(event.agent, event.text) for event in run.events if event.kind != "end"]
    return found


def test_others_go_on_without_one_that_is_dropped() -> None:
    run = ended(small(PAIR.format(failure="drop"), {"a": "scout", "b": "scout"}, [Failure("a", 0.5)]))
    assert run.outcome == "done"
    assert (
        run.sentence == "Done after 2.2 s, although a failed after 0.5 s (on schedule): every other program has ended."
    )


def test_the_team_ends_where_a_group_says_so() -> None:
    run = ended(small(PAIR.format(failure="abort"), {"a": "scout", "b": "scout"}, [Failure("a", 0.5)]))
    assert (run.outcome, run.seconds) == ("failed", 1.52)
    assert run.sentence == (
        "The team cannot go on: a is missed, without whom scouts does not go on; a failed after 0.5 s (on schedule)."
    )


def test_who_is_back_begins_anew_as_a_spare_one_and_takes_over_later() -> None:
    failures = [
        Failure("a", 0.2, FailureKind.MUTE),
        Failure("a", 1.5, FailureKind.REVIVE),
        Failure("b", 1.6, FailureKind.STALL),
    ]
    run = small(PAIR.format(failure="substitute"), {"a": "scout", "b": "scout", "c": ""}, failures)
    assert told(run) == [
        ("a", "loses its radio (on schedule)"),
        ("a", "is missed by its team"),
        ("c", "takes over for a"),
        ("a", "is well again (on schedule)"),
        ("a", "begins anew, as a spare one"),
        ("b", "stalls (on schedule)"),
        ("b", "is missed by its team"),
        ("a", "takes over for b"),
    ]
    assert run.outcome == "done"


def test_who_is_back_plays_the_role_again_that_nobody_could_take_over_as_far_as_another_one_is() -> None:
    failures = [Failure("a", 0.2, FailureKind.MUTE), Failure("a", 1.5, FailureKind.REVIVE)]
    run = small(PAIR.format(failure="substitute"), {"a": "scout", "b": "scout"}, failures)
    assert told(run) == [
        ("a", "loses its radio (on schedule)"),
        ("a", "is missed by its team"),
        ("a", "is well again (on schedule)"),
        ("a", "begins anew, as a spare one"),
        ("a", "plays its role again"),
    ]
    assert run.outcome == "done"
    assert [agent.ended for agent in run.members] == [True, True]


@pytest.mark.parametrize(("failure", "agents"), [("drop", "ab"), ("substitute", "a")])
def test_who_is_back_stays_spare_where_nobody_was_to_take_over_or_nobody_else_plays_the_role(
    failure: str, agents: str
) -> None:
    text = f"""role scout: ant {len(agents)};
role digger: ant;
group scouts = scout on failure {failure};

SeqOfPar scouts ( Arm.Do(1); WAIT(10); );
ParOfSeq digger ( WAIT(300); );
"""
    failures = [Failure("a", 0.8, FailureKind.MUTE), Failure("a", 2.1, FailureKind.REVIVE)]
    found = told(small(text, {**dict.fromkeys(agents, "scout"), "c": "digger"}, failures))
    assert ("a", "begins anew, as a spare one") in found
    assert ("a", "plays its role again") not in found


def test_one_that_was_silent_for_less_than_a_second_goes_on() -> None:
    failures = [Failure("a", 0.2, FailureKind.MUTE), Failure("a", 1.1, FailureKind.REVIVE)]
    run = small(PAIR.format(failure="substitute"), {"a": "scout", "b": "scout", "c": ""}, failures)
    assert [text for _, text in told(run)] == ["loses its radio (on schedule)", "is well again (on schedule)"]
    assert run.outcome == "done"


def test_a_block_that_nobody_is_left_for_is_named() -> None:
    text = """role scout: ant;
role digger: ant;

ParOfSeq digger (
  WAIT(100);
);
ParOfSeq scout (
  Arm.Do(1);
);
"""
    run = ended(small(text, {"a": "scout", "b": "digger"}, [Failure("a", 0.2)]))
    assert run.outcome == "failed"
    assert run.sentence == (
        "The team cannot go on: nobody is left of scout at team; a failed after 0.2 s (on schedule)."
    )


def test_a_team_of_which_nobody_is_left_has_failed() -> None:
    run = ended(
        small(PAIR.format(failure="drop"), {"a": "scout", "b": "scout"}, [Failure("a", 0.2), Failure("b", 0.3)])
    )
    assert run.outcome == "failed"


WORK = """role scout: ant {robots};
group scouts = scout on failure {failure};
work Boxes = {units} lease {lease};

{block} scouts (
  {lines}
);
"""
ALONE = """*[!(Boxes.IsEmpty())](
    Boxes.Take();
    Arm.Do(1);
    Boxes.Done();
  );"""
TOGETHER = """Boxes.Take();
  Arm.Do(1);
  Boxes.Done();"""


def crowd(robots: int, spares: int = 0) -> dict[str, str]:
    return {f"a-{n}": "scout" for n in range(robots)} | {f"s-{n}": "" for n in range(spares)}


@given(st.integers(0, 9), st.integers(1, 4), st.lists(st.tuples(st.integers(0, 60), st.integers(0, 3)), max_size=4))
@settings(max_examples=examples(10))
def test_every_unit_is_done_once_whoever_fails(units: int, robots: int, losses: list[tuple[int, int]]) -> None:
    text = WORK.format(robots=robots, failure="substitute", units=units, lease=0, block="ParOfSeq", lines=ALONE)
    run = small(text, crowd(robots, 4), [])
    for steps, number in losses:
        run.advance(steps)
        if run.outcome is None:
            run.inject_fault(run.members[number % robots].name, "fail")
    left, taken = list(run.state.team.works[W_LEFT]), 0
    while run.outcome is None:
        run.step()
        now, taken = run.state.team.works[W_LEFT][0], run.state.team.works[W_TAKEN][0]
        holding = sum(one == HAS_UNIT for one in run.state.team.holds[0])
        assert 0 <= taken == holding <= now <= left[0]
        left = [now]
    assert run.outcome == "done", run.sentence
    assert (left, taken) == ([0], 0)


def test_robots_in_step_do_not_wait_for_units_of_those_who_wait_for_them() -> None:
    text = WORK.format(robots=3, failure="drop", units=2, lease=0, block="SeqOfPar", lines=TOGETHER)
    run = ended(small(text, crowd(3), []))
    assert run.outcome == "done"
    assert list(run.state.team.works[W_LEFT]) == [0]


def test_a_unit_is_free_again_after_its_lease_and_its_old_holder_is_refused() -> None:
    lines = "Boxes.Take();\n  WAIT(100);\n  Boxes.Done();"
    text = WORK.format(robots=2, failure="drop", units=1, lease=1, block="ParOfSeq", lines=lines)
    run = small(text, crowd(2), [])
    late = "was too late: its unit of Boxes is free again, or another's"
    assert told(run) == [("a-0", late), ("a-1", late)]
    assert run.outcome == "done"
    assert list(run.state.team.works[W_LEFT]) == [1]


def test_of_two_who_wait_for_the_unit_of_one_that_failed_the_second_waits_on() -> None:
    lines = "Boxes.Take();\n  WAIT(100);\n  Boxes.Done();"
    text = WORK.format(robots=3, failure="drop", units=1, lease=60, block="ParOfSeq", lines=lines)
    run = small(text, crowd(3), [Failure("a-0", 0.2)])
    run.advance(75)
    holds, waits = run.state.team.holds[0], run.state.team.waits[0]
    assert list(holds) == [LOST_UNIT, HAS_UNIT, NO_UNIT]
    assert waits[2] >= 0
    assert ended(run).outcome == "done"


BESIDE = """role scout: ant;
role porter: ant;
group scouts = scout on failure substitute;

//(
  ParOfSeq scouts (
    Arm.Do(1);
    WAIT(100);
  );,
  ParOfSeq porter (
    <Count.GreaterThan({most})>();
  );
);
"""


@pytest.mark.parametrize("moment", [0.0, 0.5])
def test_when_others_wait_in_vain_beside_a_block_that_nobody_is_left_of_the_team_has_failed(moment: float) -> None:
    run = ended(small(BESIDE.format(most=0), {"a": "scout", "b": "porter"}, [Failure("a", moment)]))
    assert run.outcome == "failed"
    assert run.sentence == (
        f"The team cannot go on: nobody is left of scouts at team; a failed after {moment} s (on schedule)."
    )


def test_who_waits_in_vain_after_the_block_of_those_who_are_missed_is_stuck() -> None:
    run = ended(small(BESIDE.format(most=0), {"a": "scout", "b": "porter"}, [Failure("a", 2.4)]))
    assert run.outcome == "stuck"
    assert "a failed after 2.4 s" in run.sentence


VACANT = """role scout: ant 2;
role digger: ant;
group scouts = scout on failure substitute;

{first} scouts ( Arm.Do(1); );
{block} ( Arm.Do(2); WAIT(250); Arm.Do(3); );
SeqOfPar scouts ( Arm.Do(4); );
"""
AWAY = [Failure("a", 0.3, FailureKind.STALL), Failure("a", 2, FailureKind.REVIVE)]


@pytest.mark.parametrize("first", ["SeqOfPar", "ParOfSeq"])
@pytest.mark.parametrize("block", ["ParOfSeq b", "SeqOfPar {b, digger}", "SeqOfPar b"])
def test_who_is_back_is_led_only_into_blocks_whose_set_holds_its_place(first: str, block: str) -> None:
    text = VACANT.format(first=first, block=block)
    run = small(text, {"a": "scout", "b": "scout", "c": "digger"}, AWAY)
    done = []
    while run.outcome is None:
        run.step()
        done += [one.arguments[0] for one in run.members[0].commands if one.actuator == "Arm"]
    assert run.outcome == "done", run.sentence
    assert done == [1, 4]


def test_who_is_back_waits_until_the_others_have_gone_the_same_way_and_then_stands_in_its_own_groups() -> None:
    text = """role scout: ant 3;
group first = {a} on failure substitute;
group others = {b, c};

SeqOfPar scout ( Arm.Do(1); );
//( ParOfSeq {a, c} ( Arm.Do(2); WAIT(200); Arm.Do(3); );, ParOfSeq b ( Arm.Do(4); WAIT(250); ); );
ParOfSeq first ( Arm.Do(5); );
ParOfSeq others ( Arm.Do(6); );
"""
    run = small(text, {"a": "scout", "b": "scout", "c": "scout"}, AWAY)
    done = []
    while run.outcome is None:
        run.step()
        done += [(a.name, one.arguments[0]) for a in run.members for one in a.commands if one.actuator == "Arm"]
    assert run.outcome == "done", run.sentence
    assert [line for name, line in done if name == "a"] in ([1, 2, 3, 5], [1, 2, 2, 3, 5])
    assert sorted(line for name, line in done if line > 4) == [5, 6, 6]


BRANCHES = """role scout: ant;
role porter: ant;
group scouts = scout on failure {failure};
work Boxes = 3;

{before}
//(
  ParOfSeq scouts ( Boxes.Take(); Arm.Do(1); WAIT(50); Arm.Do(2); Boxes.Done(); );,
  ParOfSeq porter ( {porter} );
);
ParOfSeq porter ( Arm.Do(4); );
"""


@pytest.mark.parametrize("porter", ["Arm.Do(3);", "*( Arm.Do(3); );", "WAIT(250);"])
@pytest.mark.parametrize("before", ["", "ParOfSeq porter ( WAIT(150); );"])
@pytest.mark.parametrize("failure", ["drop", "substitute"])
def test_a_branch_that_nobody_is_left_of_is_not_done(porter: str, before: str, failure: str) -> None:
    text = BRANCHES.format(failure=failure, before=before, porter=porter)
    run = ended(small(text, {"a": "scout", "b": "porter"}, [Failure("a", 0.3)]))
    assert run.outcome == "failed"
    assert run.sentence.startswith("The team cannot go on: nobody is left of scouts at team; a failed")
    assert run.seconds < 4


def test_a_branch_whose_robots_are_lost_after_its_end_is_done() -> None:
    text = BRANCHES.format(failure="drop", before="", porter="WAIT(150);")
    run = ended(small(text, {"a": "scout", "b": "porter"}, [Failure("a", 2.0)]))
    assert run.outcome == "done", run.sentence


@pytest.mark.parametrize("revived", [0.0, 1.6])
def test_a_silent_robot_is_given_no_unit_and_what_it_does_counts_when_it_is_heard_again(revived: float) -> None:
    text = WORK.format(robots=2, failure="drop", units=20, lease=0, block="ParOfSeq", lines=ALONE)
    back = [Failure("a-0", revived, FailureKind.REVIVE)] if revived else []
    run = small(text, crowd(2), [Failure("a-0", 0.9, FailureKind.MUTE), *back])
    holds, events, lines = run.state.team.holds[0], [], [0, 0]
    heard, begun = True, 0
    while run.outcome is None:
        run.step()
        events += [event.text for event in run.events]
        for n, agent in enumerate(run.members):
            lines[n] += sum(one.actuator == "Arm" for one in agent.commands)
        if run.members[0].fault_text and heard:
            heard, begun = False, lines[0]
        if run.members[0].fault_text:
            assert lines[0] <= begun + 1
    late = [text for text in events if text.startswith("was too late")]
    assert run.outcome in ("done", "stuck")
    assert list(run.state.team.works[W_LEFT]) == [0]
    assert 20 + len(late) <= sum(lines) <= 22 + len(late)  # without a unit each does its line once more at most
    assert len(late) == (0 if revived else 1)
    assert NO_UNIT in holds


@pytest.mark.parametrize(("kind", "said"), [("mute", "has no radio"), ("apart", "hears no majority of its team")])
def test_the_end_says_who_had_not_ended_and_that_all_others_had(kind: str, said: str) -> None:
    parsed = parse_team(PAIR.format(failure="drop").replace("2;", "3;", 1))
    maker = TeamMaker(random.Random(0))
    maker.agents = dict.fromkeys("abc", ("ant", "scout"))
    run = RunningTeam(maker, parsed.program, 1, [Failure("a", 0.5, FailureKind(kind))], Radio(None, 20, 0)).run
    ended(run)
    assert run.outcome == "done"
    assert run.sentence.endswith(f"although a {said}: every other program has ended.")
