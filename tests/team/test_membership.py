"""Three members, every partition and crash in every round, breadth first: never two in one role, never two logs.

A round is three quarters of a lease. In each the network is whole, or one member is cut off, or one is stopped, or one
crashes (once); within a round every message arrives. States are compared by times relative to the present.
"""

from __future__ import annotations

from typing import Any

import pytest

from kitrobot.team import EVERYONE, Charter, Group, Member, Received, Role, Seat, Time, first_state, may_act, step
from kitrobot.team.membership import NEVER

_CHARTER = Charter(members=3, roles=(Role((0, 1, 2), 1, 0),), groups=(Group((0,), "substitute"),), lease=400)
_ROUND = 300
_MEMBERS = range(3)
_Team = tuple[Member | None, ...]


def _round(team: _Team, now: int, cut: int, stopped: int) -> _Team:
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
                    state, sent, _ = step(_CHARTER, state, time, Received(message))
                    members[other] = state
                    letters += [(other, one) for one in sent]
            assert len(letters) < 2_000, "messages call for messages without end"
        acting = [m for m in _MEMBERS if (state := members[m]) and may_act(_CHARTER, state, 0, time)]
        assert len(acting) <= 1, f"{acting} act in one role"
    running = [state for state in members if state]
    for a in running:
        for b in running:
            assert a.log.slot != b.log.slot or a.tables == b.tables, "two members decide a slot differently"
    return tuple(members)


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
        return ago(value.now), times, log, tuple(ago(time) for time in value.acts_from)
    return tuple(_relative(one, now) for one in value)


def _explore(rounds: int) -> tuple[int, int]:
    """(states, members that ever acted in the role) of all runs of so many rounds, after two in which all is well."""
    start: _Team = tuple(first_state(_CHARTER, Seat(member, 0), 0) for member in _MEMBERS)
    now, states, acted = 2 * _ROUND, 0, set[int]()
    layer: dict[Any, _Team] = {None: _round(_round(start, _ROUND, -1, -1), now, -1, -1)}
    for _ in range(rounds):
        now += _ROUND
        following: dict[Any, _Team] = {}
        for team in layer.values():
            choices = [(team, -1, -1), *((team, m, -1) for m in _MEMBERS), *((team, -1, m) for m in _MEMBERS)]
            if None not in team:
                choices += [((*team[:m], None, *team[m + 1 :]), -1, -1) for m in _MEMBERS]
            for before, cut, stopped in choices:
                after = _round(before, now, cut, stopped)
                following[_relative(after, now)] = after
                acted |= {m for m, state in enumerate(after) if state and may_act(_CHARTER, state, 0, now)}
        layer = following
        states += len(layer)
    return states, len(acted)


def test_whoever_is_cut_off_stopped_or_crashes_nobody_ever_shares_a_role() -> None:
    states, acted = _explore(3)
    assert states > 300
    assert acted == 2


@pytest.mark.thorough("test_whoever_is_cut_off_stopped_or_crashes_nobody_ever_shares_a_role, for three rounds")
def test_the_same_for_longer_runs() -> None:
    states, acted = _explore(5)
    assert states > 1_000
    assert acted == 2
