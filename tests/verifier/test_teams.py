"""Programs of teams: the simulator does nothing that the model does not allow, and what waits for ever is found."""

from __future__ import annotations

import random
from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any

import pytest

from kitrobot.lll.parse_results import parse_team
from kitrobot.mission.trial import FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.sim.tables.team_columns import T_MISSED
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.engines import PLAIN
from kitrobot.verifier.exploration.exploration import StateSpace, explore
from kitrobot.verifier.model.absence import AbsenceAgreement
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.model.table_builder import KINDS
from kitrobot.verifier.model.team_agreement import Agreement
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from kitrobot.verifier.report.counterexample_text import describe_run
from kitrobot.verifier.report.replay import InjectedFault, confirm
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.bodies import RUNS
from tests.effort import cases
from tests.sim.team_building import RunningTeam, random_team_program
from tests.team_programs.blocks import BlocksMaker
from tests.team_programs.hosting import TooLarge
from tests.verifier.check_fixtures import EXAMPLES, answers, judged, prepared

DECLARED = "role scout: ant 2; group all-of-us = {scout}; work Boxes = 1;"


def team(body: str) -> RunningTeam:
    """Two robots of one role that run a team's program."""
    parsed = parse_team(f"{DECLARED} {body}")
    assert parsed.diagnostics == []
    agents = {"scout-0": ("ant", "scout"), "scout-1": ("ant", "scout")}
    maker: Any = SimpleNamespace(agents=agents, programs={})
    return RunningTeam(maker, parsed.program, 1)


def following(made: StateSpace, state: State) -> set[State]:
    """The states after a step."""
    model = made.model
    while True:
        t = model.t
        found = PLAIN.expand(t, *model.layout.key(state))
        if found >= 0:
            return {model.layout.state(int(t.next_x[n]), int(t.next_y[n])) for n in range(found)}
        made.fill(int(t.regs[0]))


def follow(run: Simulation, steps: int, faults: Sequence[InjectedFault] = ()) -> int:
    """Follows a run of a team, and all states of the model in lockstep that fit; gives how much was agreed on.

    `faults`: what is done before which step, and to whom.
    """
    parts = abstract_run(run)
    failures = sum(fault.kind != "revive" for fault in faults)
    names = [agent.name for agent in run.members]
    model = Model(run, parts, failures, kinds=[kind for kind in KINDS if any(fault.kind == kind for fault in faults)])
    assert model.agreement is not None
    made = explore(model, Budget(1), True, PLAIN)
    may_fail = model.t.fixed[v.MAY_FAIL]
    fitting = {made.state(0)}
    agreed = set()
    for _ in range(steps):
        if run.outcome is not None:
            break
        now_harmed = [
            fault
            for fault in faults
            if fault.tick == run.tick
            and not run.members[names.index(fault.agent)].ended
            and run.inject_fault(fault.agent, fault.kind)
        ]
        failures -= sum(fault.kind != "revive" for fault in now_harmed)
        # What else could befall somebody in this step is left out: it would only take time.
        if bool(model.t.fixed[v.MAY_FAIL]) != bool(now_harmed):
            model.t.fixed[v.MAY_FAIL] = may_fail if now_harmed else 0
            model.place_fields()
        run.advance(1)
        now = seen(run, model, failures)
        agreed.add(now[-1])
        fitting = {
            after for state in fitting for after in following(made, state) if shown(model, after, failures) == now
        }
        assert fitting, f"step {run.tick}"
    return len(agreed)


def seen(run: Simulation, model: Model, left: int) -> tuple[Any, ...]:
    """What can be seen of a run of a team that is also in a state of the model."""
    robots, agents = run.state.robots.ints, []
    for i, part in enumerate(model.parts):
        part.table.machine.restore(run.members[i].machine.snapshot())
        is_well = robots[c.DOWN][i] == c.WELL
        is_lost = not is_well and run.state.team.robots[T_MISSED][i]
        local = part.table.first if is_lost else part.table.current()
        agents.append((local, robots[c.DOWN][i], is_well and robots[c.MUTED][i]))
    assert model.agreement is not None
    actuators = model.agreement.actuators
    if model.absence is None:
        return tuple(agents), Agreement(run, actuators).first
    return tuple(agents), model.absence.reduced(AbsenceAgreement(run, actuators).first, left)


def shown(model: Model, state: State, left: int) -> tuple[Any, ...]:
    """The same of a state of the model, if so many failures are left in it."""
    insides = [model.inside(i, state[1 + i]) for i in range(model.count)]
    agents = tuple((one.local, one.down, one.down == RUNS and one.is_muted) for one in insides)
    shared = model.shareds()[state[0]]
    assert model.agreement is not None
    return agents, shared[-len(model.agreement.first) :] if shared[0] == left else ()


@pytest.mark.parametrize("seed", cases([0, 7], [*range(1, 7), *range(8, 200)]))
def test_a_team_agrees_on_nothing_that_the_model_does_not(seed: int) -> None:
    maker, program = random_team_program(seed)
    try:
        running = RunningTeam(maker, program, seed)
    except TooLarge:
        return
    assert follow(running.run, 120) > 1


@pytest.mark.parametrize("seed", cases([3, 8], [*range(3), *range(4, 8), *range(9, 400)]))
def test_a_team_of_which_some_fail_does_nothing_that_the_model_does_not(seed: int) -> None:
    """They fail, stall or lose their radio at any moment, one or two of them; who stalls may go on, or is missed.

    What befalls a robot whose program has ended, or a second time, is nothing that the model knows.
    """
    chance = random.Random(seed)
    maker, program = random_team_program(seed, chance.randint(0, 2))
    for group in program.groups:
        group.failure = chance.choice(("drop", "substitute", "substitute", "abort"))
    try:
        running = RunningTeam(maker, program, seed)
    except TooLarge:
        return
    faults = []
    for who in chance.sample(running.names, 1 if len(running.names) > 5 else 2):
        when, kind = chance.randint(0, 60), chance.choice(list(KINDS))
        faults.append(InjectedFault(when, who, kind.value))
        if kind is FailureKind.STALL and chance.random() < 0.8:
            faults.append(InjectedFault(when + chance.randint(1, 120), who, "revive"))
    follow(running.run, 200, sorted(faults, key=lambda fault: fault.tick))


@pytest.mark.parametrize("seed", cases([3], [*range(3), *range(4, 200)]))
def test_branches_that_are_lost_and_places_that_are_taken_again_are_in_the_model_too(seed: int) -> None:
    chance = random.Random(seed)
    maker = BlocksMaker(chance, chance.randint(0, 1), "substitute")
    try:
        running = RunningTeam(maker, maker.program(), seed)
    except TooLarge:
        return
    first, second = chance.sample(running.names, 2)
    faults = [
        InjectedFault(chance.randint(0, 40), first, "stall"),
        InjectedFault(chance.randint(80, 150), first, "revive"),
    ]
    faults.append(InjectedFault(chance.randint(0, 150), second, "fail"))
    follow(running.run, 300, sorted(faults, key=lambda fault: fault.tick))


@pytest.mark.parametrize("timing", list(Timing))
def test_a_team_whose_members_meet_comes_to_its_end(timing: Timing) -> None:
    run = team("2*( SeqOfPar scout ( Arm.Do(1); Arm.Do(2); ); ); ParOfSeq scout ( Boxes.Take(); Boxes.Done(); );").run
    made = judged(run, timing)
    assert made.complete
    assert set(answers(made).values()) <= {"holds", "vacuous"}


@pytest.mark.parametrize("timing", list(Timing))
def test_who_keeps_a_unit_for_ever_keeps_the_others_waiting(timing: Timing) -> None:
    """One waits until all is done before it says that its unit is; the other waits for that unit."""
    run = team("ParOfSeq scout ( Boxes.Take(); <Boxes.IsEmpty()>( Boxes.Done(); ); );").run
    made = judged(run, timing)
    assert made.complete
    assert answers(made)["deadlock"] == "broken"


@pytest.mark.parametrize("name", ["exchange", "convoy"])
def test_the_shipped_teams_come_to_their_end(name: str) -> None:
    made = judged(prepared(EXAMPLES / name / f"{name}.krt").again(), Timing.LOCKSTEP)
    assert made.complete
    assert set(answers(made).values()) <= {"holds", "vacuous"}


WAITING = """role giver: ant; role helper: ant; role waiter: ant;
group givers = {{giver}} on failure {rule}; group waiters = {{waiter}} on failure drop;
work Boxes = 1;
ParOfSeq givers ( Count.Add(1); );
Where {{giver, helper}} [Count.LessThan(1)]( WAIT(1); ) ! ( Boxes.Take(); Arm.Do(1); Boxes.Done(); );
ParOfSeq waiters ( <Boxes.IsEmpty()>( Arm.Do(2); ); );
"""


@pytest.mark.parametrize(
    ("rule", "answer", "timing"),
    cases(
        [
            ("drop", "broken", Timing.LOCKSTEP),
            ("substitute", "broken", Timing.LOCKSTEP),
            ("abort", "holds", Timing.LOCKSTEP),
            ("abort", "holds", Timing.FREE),
        ],
        [("drop", "broken", Timing.FREE), ("substitute", "broken", Timing.FREE)],
    ),
)
def test_who_waits_for_what_nobody_does_any_more_waits_for_ever(rule: str, answer: str, timing: Timing) -> None:
    """Whoever takes over does not know what the one before had counted. A team that gives up does not stand still."""
    parsed = parse_team(WAITING.format(rule=rule))
    assert parsed.diagnostics == []
    agents = {"giver-0": ("ant", "giver"), "helper-0": ("ant", "helper"), "waiter-0": ("ant", "waiter")}
    agents["spare-0"] = "ant", ""
    maker: Any = SimpleNamespace(agents=agents, programs={})
    team = RunningTeam(maker, parsed.program, 1)
    assert set(answers(judged(team.run, timing)).values()) <= {"holds", "vacuous"}
    model = Model(team.run, abstract_run(team.run), 1, timing, (FailureKind.FAIL,))
    made = check_properties(model, ready_properties(model), Budget(50_000))
    assert made.complete
    deadlock = next(verdict for verdict in made.verdicts if verdict.property.name == "deadlock")
    assert deadlock.answer.value == answer
    counterexample = deadlock.counterexample
    if counterexample is not None:
        assert any("the team misses giver-0" in str(words) for _, words in describe_run(model, counterexample))
        assert confirm(deadlock.property, counterexample, model, lambda seed: team.anew(), lambda: False) is not None


@pytest.mark.parametrize("rule", ["drop", "substitute", "abort"])
@pytest.mark.parametrize("timing", list(Timing))
def test_members_that_meet_go_on_or_give_up_after_any_one_failure(timing: Timing, rule: str) -> None:
    parsed = parse_team(f"role scout: ant 2; group scouts = scout on failure {rule}; SeqOfPar scouts ( Arm.Do(1); );")
    agents = {"scout-0": ("ant", "scout"), "scout-1": ("ant", "scout"), "spare-0": ("ant", "")}
    maker: Any = SimpleNamespace(agents=agents, programs={})
    made = judged(RunningTeam(maker, parsed.program, 1).run, timing, failures=1)
    assert made.complete
    assert set(answers(made).values()) <= {"holds", "vacuous"}


def test_a_shipped_team_on_a_road_is_followed() -> None:
    run = prepared(EXAMPLES / "transport-team" / "transport-team.krt").again()
    model = Model(run, abstract_run(run))
    made = check_properties(model, ready_properties(model), Budget(300))
    assert made.states == 300
    assert not any("no discrete form" in str(limit) for limit in model.limits)
