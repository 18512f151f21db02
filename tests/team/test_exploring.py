"""The protocol explored: three members, letters in any order, lost, doubled, a cut that heals and one crash.

Every state within the bounds keeps every law of `laws`, and from each of them a team that nothing disturbs any more
comes to one view, ends its meetings and does its work. A protocol that was made wrong is refuted, by a run in words.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Any

import pytest

from kitrobot.team import Charter, Group, MeetingRule, Role, Time, Work, decision, meeting, membership, step, work
from kitrobot.team.decision import Decision
from tests.effort import cases
from tests.team.exploring import Explored, explore
from tests.team.laws import LAWS, all_is_done, what_stays_undone
from tests.team.moving import LEASE, NOW, moved
from tests.team.three import Faults, Plan, Team, Three

_ROLE = Charter(3, roles=(Role((0, 1, 2), 1, 0),), groups=(Group((0, 1), "substitute"),), lease=LEASE)
_MEETING = Charter(3, groups=(Group((0, 1, 2)),), meetings=(MeetingRule((0,), "any"),), lease=LEASE)
_WORK = Charter(3, works=(Work(1),), lease=LEASE)
_LEASED = Charter(3, works=(Work(1, 2 * LEASE),), lease=LEASE)

_SAY = (0, 1, 0)
_TAKE = (1, 2)


def _go(plan: Plan, most: int = 400_000) -> tuple[Three, Explored[Team]]:
    model = Three(plan, LAWS)
    return model, explore(model, most)


@pytest.mark.parametrize(
    ("plan", "states"),
    cases(
        [
            pytest.param(Plan(_MEETING, Faults(lost=1), _SAY, letters=2), 1_544, id="meeting-lost-2"),
            pytest.param(Plan(_WORK, Faults(crashes=1), takers=(1,), letters=3), 4_557, id="work-crash"),
            pytest.param(Plan(_ROLE, Faults(cuts=1, doubled=1), letters=3), 1_389, id="role-cut-doubled"),
            pytest.param(Plan(_ROLE, Faults(cuts=1, lost=1), letters=2), 1_627, id="role-cut-lost-2"),
            pytest.param(Plan(_ROLE, Faults(cuts=1, late=1), letters=2), 981, id="role-cut-late-2"),
        ],
        [
            pytest.param(Plan(_WORK, Faults(doubled=1, lost=1), takers=(1,), letters=3), 6_195, id="work-doubled"),
            pytest.param(Plan(_LEASED, Faults(), takers=_TAKE, letters=3), 19_904, id="work-lease"),
            pytest.param(Plan(_ROLE, Faults(cuts=1), letters=6), 14_533, id="role-cut"),
            pytest.param(Plan(_ROLE, Faults(cuts=1, lost=1), letters=3), 3_089, id="role-cut-lost"),
            pytest.param(Plan(_ROLE, Faults(cuts=1, late=1), letters=4), 17_503, id="role-cut-late"),
            pytest.param(Plan(_MEETING, Faults(lost=1), _SAY, letters=3), 56_972, id="meeting-lost"),
            pytest.param(Plan(_MEETING, Faults(crashes=1), _SAY, letters=3), 146_249, id="meeting-crash"),
            pytest.param(Plan(_WORK, Faults(crashes=1), takers=_TAKE, letters=3), 117_074, id="two-work-crash"),
            pytest.param(Plan(_WORK, Faults(cuts=1), takers=(1,), letters=3), 26_497, id="work-cut"),
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
        pytest.param(Plan(_WORK, Faults(doubled=1, lost=1), takers=(1,), letters=3), id="work-doubled"),
        pytest.param(Plan(_LEASED, Faults(), takers=_TAKE, letters=3), id="work-lease"),
    ],
)
def test_the_first_states_of_longer_runs_keep_the_laws(plan: Plan) -> None:
    explored = _go(plan, 3_000)[1]
    assert explored.broken is None, str(explored.broken)
    assert len(explored.states) == 3_000


_participants = meeting.participants
_promised = decision._promised


def _only_two(*what: Any) -> tuple[int, ...]:
    return _participants(*what)[:2]


def _forgets_votes(state: Decision, rank: int, *vote: object) -> object:
    return _promised(state, rank, decision.NO_BALLOT, ())


def _anybody_alone(ranks: Collection[int], voters: int) -> bool:
    return len(ranks) > 0


def _whoever_held_it(units: Any, member: int, command: Any) -> bool:
    return not units.units[command.unit].done


def _for_ever(*what: object) -> int:
    return 1 << 40


@pytest.mark.parametrize(
    ("room", "name", "wrong", "plan", "law"),
    [
        pytest.param(
            decision,
            "is_quorum",
            _anybody_alone,
            Plan(_ROLE, Faults(cuts=1), letters=6),
            "a slot and so a view is agreed by a majority of the view before",
            id="a view agreed without a majority",
        ),
        pytest.param(
            decision,
            "_promised",
            _forgets_votes,
            Plan(_MEETING, Faults(crashes=1), (0, -1, 0), letters=3),
            "a slot and so a view is agreed by a majority of the view before",
            id="a vote forgotten by who tries again",
        ),
        pytest.param(
            work,
            "has",
            _whoever_held_it,
            Plan(_LEASED, takers=_TAKE, letters=3),
            "a unit is counted once and for its holder",
            id="a unit counted for an old holder",
        ),
        pytest.param(
            meeting,
            "participants",
            _only_two,
            Plan(_MEETING, answers=_SAY, letters=3),
            "a meeting is over when all have come or left",
            id="a meeting that does not wait for the last",
        ),
        pytest.param(
            membership,
            "lent_until",
            _for_ever,
            Plan(_ROLE, Faults(cuts=1), letters=6),
            "no two members may act in one role",
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
    monkeypatch.setattr(meeting, "participants", lambda *what: _participants(*what)[:1])
    explored = _go(Plan(_MEETING, answers=_SAY, letters=3))[1]
    assert str(explored.broken).splitlines() == [
        "a meeting is over when all have come or left: broken after 3 events",
        "  1. 0 comes to the meeting and says 0",
        "  2. Propose of 0 to 1 (slot 0, ballot 0.0, value [Announce(meeting=0, occurrence=0, answer=0) of 0]) arrives",
        "  3. Accepted of 1 to 0 (slot 0, ballot 0.0) arrives",
    ]


def test_a_team_that_never_changes_its_view_does_not_settle_after_a_crash(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(membership, "change_wanted", lambda *what: None)
    model, explored = _go(Plan(_ROLE, Faults(crashes=1), letters=3))
    assert explored.broken is None
    undone = {what_stays_undone(model, state) for state in explored.states}
    assert undone == {"", "all that run, and nobody else, are in the view"}


def test_an_exploration_that_was_cut_short_says_so() -> None:
    explored = _go(Plan(_MEETING, answers=_SAY), 100)[1]
    assert (len(explored.states), explored.complete, explored.broken) == (100, False, None)


def test_a_member_at_another_time_does_the_same() -> None:
    """States are compared by times relative to now: a machine that is moved in time gives what it gave, moved."""
    model, explored = _go(Plan(_ROLE, Faults(cuts=1), letters=6), 300)
    for team in explored.states:
        for number in team.members:
            state = model.states[number]
            for ahead in (2, LEASE):
                here = step(model.plan.charter, state, NOW + ahead, Time())
                there = step(model.plan.charter, moved(state, 7), NOW + ahead + 7, Time())
                assert moved(here.state, 7) == there.state
                assert here.changes == there.changes
