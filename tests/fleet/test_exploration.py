"""What a fleet runs, explored: three hosts, letters in any order, lost, doubled, a cut that heals and one crash.

Every state within the bounds keeps every law of `agent_laws` and `slot_laws`, and from each of them a team that nothing
disturbs any more comes to one view, ends its meetings and its work, and its programs end. A protocol that is made wrong
on purpose is refuted, by a run in words.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Collection
from typing import Any

import pytest

from kitrobot.fleet import replica
from kitrobot.lll.parse_results import parse_team
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.state import State
from kitrobot.sim.tables.state import Team as TeamTables
from kitrobot.sim.tables.team_columns import HAS_UNIT, LOST_UNIT, P_MEMBERS, T_AT, W_LEFT, W_TAKEN
from kitrobot.sim.team import meetings
from kitrobot.team import consensus, membership
from kitrobot.team.consensus import Decision
from tests.effort import cases
from tests.fleet.agent_laws import LAWS, all_is_done, what_stays_undone
from tests.fleet.three_agents import Faults, Plan, Team, ThreeAgents
from tests.sim.team_building import RunningTeam
from tests.team.state_exploration import Exploration, explore
from tests.team_programs.making import TeamMaker


def mission(program: str, roles: tuple[str, str, str], counts: tuple[int, int, int] = (0, 0, 0)) -> Any:
    """Makes runs of a team of three ants with these roles ("": spare), whose variables `Count` begin so."""
    parsed = parse_team(program)
    assert parsed.ok, parsed.diagnostics
    maker = TeamMaker(random.Random(0))
    maker.agents = {f"a-{n}": ("ant", role) for n, role in enumerate(roles)}
    team = RunningTeam(maker, parsed.program, 1)

    def run() -> Simulation:
        made = team.anew()
        for agent, count in zip(made.members, counts, strict=True):
            agent.machine.set_variable("Count", count)
        return made

    return run


MEETING = mission(
    """role ants: ant 3; group all = ants on failure drop;
    [any ants (Count.GreaterThan(0))](ParOfSeq ants (Count.Add(1);););""",
    ("ants", "ants", "ants"),
    (0, 1, 0),
)
"""A question that all three answer, a block of all three, and its end."""

ROLE = mission(
    """role lead: ant; role rest: ant; group first = lead on failure substitute;
    ParOfSeq lead (Count.Add(1););""",
    ("lead", "rest", ""),
)
"""A role with a spare robot, and a robot of another role."""

_WORK = """role ants: ant {}; group all = ants on failure substitute; work Boxes = 1 {};
    ParOfSeq ants (Boxes.Take(); Boxes.Done(););"""
WORK = mission(_WORK.format(1, ""), ("", "ants", ""))
"""A unit of work for one robot, and two spare robots."""

LEASED = mission(_WORK.format(1, "lease 1"), ("", "ants", ""))
TWO_WORK = mission(_WORK.format(2, ""), ("", "ants", "ants"))
TWO_LEASED = mission(_WORK.format(2, "lease 1"), ("", "ants", "ants"))
LEASE_MS = 4


def _go(plan: Plan, most: int = 600_000) -> tuple[ThreeAgents, Exploration[Team]]:
    model = ThreeAgents(plan, LAWS)
    return model, explore(model, most)


@pytest.mark.parametrize(
    ("plan", "states"),
    cases(
        [
            pytest.param(Plan(MEETING, letters=3, prompt=True), 3_257, id="meeting"),
            pytest.param(Plan(ROLE, Faults(crashes=1), 2, True), 3_094, id="role-crash"),
            pytest.param(Plan(WORK, Faults(crashes=1), 3, True), 6_702, id="work-crash"),
            pytest.param(Plan(WORK, Faults(lost=1, doubled=1), 3, True), 2_662, id="work-lost-doubled"),
        ],
        [
            pytest.param(Plan(MEETING, Faults(crashes=1), 2, True), 7_255, id="meeting-crash"),
            pytest.param(Plan(ROLE, Faults(cuts=1), 2, True), 8_136, id="role-cut"),
            pytest.param(Plan(WORK, Faults(cuts=1), 2, True), 4_898, id="work-cut"),
            pytest.param(Plan(MEETING, Faults(lost=1), 3, True), 30_705, id="meeting-lost"),
        ],
    ),
)
def test_every_run_of_three_keeps_the_laws_and_settles_when_nothing_disturbs_it(plan: Plan, states: int) -> None:
    model, explored = _go(plan)
    assert explored.broken is None, str(explored.broken)
    assert explored.complete
    undone = {what for state in explored.states if (what := what_stays_undone(model, state))}
    assert undone == set()
    assert len(explored.states) == states
    assert any(all_is_done(model, state) for state in explored.states), "nothing came to its end within the bounds"


@pytest.mark.parametrize(
    "plan",
    [
        pytest.param(Plan(MEETING, Faults(cuts=1, lost=1), 3), id="meeting-cut-lost"),
        pytest.param(Plan(ROLE, Faults(crashes=1, lost=1, doubled=1), 6), id="role-crash-lost-doubled"),
        pytest.param(Plan(TWO_WORK, Faults(crashes=1), 3, True), id="two-work-crash"),
        pytest.param(Plan(LEASED, Faults(crashes=1), 3, False, LEASE_MS), id="leased-crash"),
        pytest.param(Plan(TWO_LEASED, Faults(late=1), 3, False, LEASE_MS), id="two-leased-late"),
    ],
)
def test_the_first_states_of_longer_runs_keep_the_laws_and_settle(plan: Plan) -> None:
    model, explored = _go(plan, cases([600], [200_000])[-1])
    assert explored.broken is None, str(explored.broken)
    undone = {what for state in explored.states if (what := what_stays_undone(model, state))}
    assert undone == set()


_count_promise = consensus._count_promise


def _forgets_votes(state: Decision, rank: int, *vote: object) -> object:
    return _count_promise(state, rank, consensus.NO_BALLOT, ())


def _anybody_alone(ranks: Collection[int], voters: int) -> bool:
    return len(ranks) > 0


def _without_the_last(p: int, team: TeamTables) -> bool:
    members = team.members[team.points[P_MEMBERS][p]]
    return sum(bool(one) and team.robots[T_AT][i] == p for i, one in enumerate(members)) >= sum(members) - 1


def _counts_what_was_lost(i: int, w: int, state: State) -> None:
    team = state.team
    team.works[W_TAKEN][w] -= team.holds[w][i] == HAS_UNIT
    team.works[W_LEFT][w] -= team.holds[w][i] in (HAS_UNIT, LOST_UNIT)
    team.holds[w][i] = 0


def _for_ever(*what: object) -> int:
    return 1 << 40


@pytest.mark.parametrize(
    ("room", "name", "wrong", "plan", "law"),
    [
        pytest.param(
            consensus,
            "is_quorum",
            _anybody_alone,
            Plan(ROLE, Faults(cuts=1), 6, True),
            "a slot and so a view is agreed by a majority of the view before",
            id="a view agreed without a majority",
        ),
        pytest.param(
            consensus,
            "_count_promise",
            _forgets_votes,
            Plan(MEETING, Faults(crashes=1, late=1), 3, True),
            "a slot and so a view is agreed by a majority of the view before",
            id="a vote forgotten by whoever tries again",
        ),
        pytest.param(
            meetings,
            "are_all_present",
            _without_the_last,
            Plan(MEETING, letters=3, prompt=True),
            "a meeting is over for all who come to it when all have come or left",
            id="a meeting that does not wait for the last",
        ),
        pytest.param(
            replica,
            "finish_unit",
            _counts_what_was_lost,
            Plan(LEASED, Faults(), 3, False, LEASE_MS),
            "a unit is counted once and for its holder",
            id="a unit counted for an old holder",
        ),
        pytest.param(
            membership,
            "lent_until",
            _for_ever,
            Plan(ROLE, Faults(cuts=1), 2, True),
            "no two robots may act in one place of the team",
            id="a right to act that is lent for ever",
        ),
    ],
)
def test_a_protocol_made_wrong_is_refuted_by_a_shortest_run_in_words(
    monkeypatch: pytest.MonkeyPatch, room: Any, name: str, wrong: Callable[..., object], plan: Plan, law: str
) -> None:
    monkeypatch.setattr(room, name, wrong)
    _, explored = _go(plan)
    assert explored.broken is not None
    assert explored.broken.law == law
    assert len(explored.broken.events) == explored.depth + 1


def test_the_run_that_refutes_is_told_event_by_event(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(meetings, "are_all_present", _without_the_last)
    explored = _go(Plan(MEETING, letters=3, prompt=True))[1]
    first, *events = str(explored.broken).splitlines()
    assert first == "a meeting is over for all who come to it when all have come or left: broken after 11 events"
    assert events[0] == "  1. the program of 0 goes on"
    assert events[-2:] == [
        " 10. Request of 2 to 0 (commands [Note(numbers=(0, 0, 0, 0, 1)) of 2]) arrives",
        " 11. Accepted of 1 to 0 (slot 1, ballot 0.0) arrives",
    ]


def test_a_team_that_never_changes_its_view_does_not_settle_after_a_crash(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(membership, "change_wanted", lambda *what: None)
    model, explored = _go(Plan(ROLE, Faults(crashes=1), 2, True), 200)
    assert explored.broken is None
    undone = {what_stays_undone(model, state, rounds=12) for state in explored.states}
    assert undone == {"", "all that run, and nobody else, are in the view"}


def test_an_exploration_that_was_cut_short_says_so() -> None:
    explored = _go(Plan(MEETING), 100)[1]
    assert (len(explored.states), explored.complete, explored.broken) == (100, False, None)
