"""Three members, every partition and crash in every round, breadth first: one log, no right that outlives a view.

A round is three quarters of a lease. In each the network is whole, or one member is cut off, or one is stopped, or one
crashes (once); within a round every message arrives. States are compared by times relative to the present.
"""

from __future__ import annotations

from typing import Any

import pytest

from kitrobot.team.charter import Charter
from kitrobot.team.commands import Seat
from kitrobot.team.events import IncomingMessage, Time
from kitrobot.team.member import step
from kitrobot.team.membership import NEVER
from kitrobot.team.messages import EVERYONE
from kitrobot.team.state import Member, initial_state, may_act

_CHARTER = Charter(members=3, lease=400)
_ROUND = 300
_MEMBERS = range(3)
_Team = tuple[Member | None, ...]
_Viewed = tuple[int, int]
"""The number of the newest view that anybody knows, and when somebody first did."""


def _round(team: _Team, viewed: _Viewed, now: int, cut: int, stopped: int) -> tuple[_Team, _Viewed]:
    """All messages of a round arrive, but those from and to who is cut off; a stopped one reads none."""
    members = list(team)
    for time in (now - _ROUND // 2, now):
        letters = []
        for member in _MEMBERS:
            state = members[member]
            if state and member != stopped:
                state, sent, _ = step(_CHARTER, state, time, Time())
                members[member] = state
                letters += [(member, one) for one in sent]
        for sender, (to, message) in letters:
            for other in _MEMBERS if to == EVERYONE else (to,):
                state = members[other]
                if other != sender and state and other != stopped and cut not in (sender, other):
                    state, sent, _ = step(_CHARTER, state, time, IncomingMessage(message))
                    members[other] = state
                    letters += [(other, one) for one in sent]
            assert len(letters) < 2_000, "messages call for messages without end"
        views = [state.tables.view for state in members if state]
        newest = max(views, key=lambda view: view.number)
        viewed = max(viewed, (newest.number, time if newest.number > viewed[0] else viewed[1]))
        if time - viewed[1] >= _CHARTER.hold and newest.number == viewed[0]:
            acting = [state.seat for state in members if state and may_act(_CHARTER, state, time)]
            assert set(acting) <= set(newest.seats), f"{acting} act, and {newest} has left some of them"
    running = [state for state in members if state]
    for a in running:
        for b in running:
            assert a.log.slot != b.log.slot or a.tables == b.tables, "two members decide a slot differently"
    return tuple(members), viewed


def _relative(value: Any, now: int) -> Any:
    """A state with its times relative to now, those that are long over made equal."""
    if isinstance(value, Member | None):
        if value is None:
            return None
        known = value.membership

        def ago(time: int) -> int:
            return max(time - now, -4 * _CHARTER.lease)

        peers = tuple((p.life, p.view, ago(p.stamp), ago(p.heard), ago(p.echoed), ago(p.granted)) for p in known.peers)
        times = ago(known.since), ago(known.beat_at), ago(known.right), known.heard, peers
        log = value.log._replace(retry_at=ago(value.log.retry_at) if value.log.retry_at else NEVER)
        return ago(value.now), times, log, ago(value.acts_from)
    return tuple(_relative(one, now) for one in value)


def _explore(rounds: int) -> tuple[int, int]:
    """(states, members that a view has left) of all runs of so many rounds, after two in which all is well."""
    team: _Team = tuple(initial_state(_CHARTER, Seat(member, 0), 0) for member in _MEMBERS)
    viewed: _Viewed = 0, 0
    for now in (_ROUND, 2 * _ROUND):
        team, viewed = _round(team, viewed, now, -1, -1)
    now, states, left = 2 * _ROUND, 0, set[int]()
    layer: dict[Any, tuple[_Team, _Viewed]] = {None: (team, viewed)}
    for _ in range(rounds):
        now += _ROUND
        following: dict[Any, tuple[_Team, _Viewed]] = {}
        for team, viewed in layer.values():
            choices = [(team, -1, -1), *((team, m, -1) for m in _MEMBERS), *((team, -1, m) for m in _MEMBERS)]
            if None not in team:
                choices += [((*team[:m], None, *team[m + 1 :]), -1, -1) for m in _MEMBERS]
            for before, cut, stopped in choices:
                after, since = _round(before, viewed, now, cut, stopped)
                following[_relative(after, now), max(since[1] - now, -_CHARTER.hold)] = after, since
                left |= {
                    member
                    for state in after
                    if state
                    for member in set(_MEMBERS) - {seat.member for seat in state.tables.view.seats}
                }
        layer = following
        states += len(layer)
    return states, len(left)


def test_whoever_is_cut_off_stopped_or_crashes_no_right_to_act_outlives_a_view() -> None:
    states, left = _explore(4)
    assert states > 300
    assert left == 3


@pytest.mark.thorough("test_whoever_is_cut_off_stopped_or_crashes_no_right_to_act_outlives_a_view, for four rounds")
def test_the_same_for_longer_runs() -> None:
    states, left = _explore(5)
    assert states > 1_000
    assert left == 3
