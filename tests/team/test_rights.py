"""The hardest moments of the right to act: a view was changed, and some that voted for it do not know it is decided."""

from __future__ import annotations

from kitrobot.team.charter import Charter
from kitrobot.team.commands import Command, Seat, ViewChange
from kitrobot.team.events import IncomingMessage, Leave
from kitrobot.team.member import step
from kitrobot.team.messages import (
    Accepted,
    Chosen,
    Heartbeat,
    History,
    Message,
    Prepare,
    Promise,
    Propose,
    Request,
    Snapshot,
)
from kitrobot.team.state import may_act
from tests.team.network import Network, Phase, team

_SYNOD = (Prepare, Promise, Propose, Accepted)
_DECIDED = (Chosen, History, Snapshot)


def _network(members: int) -> Network:
    """A team whose programs do nothing."""
    network = Network(Charter(members), 1, rounds=0)
    network.run(Phase(1_000, idle=True))
    assert _acts(network, 0)
    return network


def _acts(network: Network, member: int) -> bool:
    return network.acts(network.robots[member])


def _until_viewed(network: Network, *members: int) -> None:
    """Goes on until these know of another view."""
    for _ in range(200):
        if all(network.robots[member].state.tables.view.number for member in members):
            return
        network.run(Phase(25, idle=True))
    raise AssertionError("no new view")


def _goes_on_without_0(network: Network) -> None:
    """Goes on until another may have taken the place of 0; `run` looks at every moment that 0 does not act then."""
    network.run(Phase(2_000, idle=True))
    assert _acts(network, 1)
    assert not _acts(network, 0)


def test_voters_that_do_not_know_that_the_change_was_decided_support_nobody_in_the_old_view() -> None:
    network = _network(5)
    network.blocked = lambda sender, to, message: 0 in (sender, to) or (to in (2, 3) and isinstance(message, _DECIDED))
    _until_viewed(network, 1)
    assert network.robots[2].state.tables.view.number == 0
    # Now 0 is with those two, and 1 with the last: half of the new view, with its first.
    network.blocked = lambda sender, to, message: (
        (sender in (1, 4)) != (to in (1, 4)) or (to in (0, 2, 3) and isinstance(message, (*_SYNOD, *_DECIDED)))
    )
    _goes_on_without_0(network)


def test_members_of_a_later_view_support_nobody_in_the_old_one() -> None:
    network = _network(5)
    network.blocked = lambda sender, to, message: 0 in (sender, to)
    _until_viewed(network, 1, 2)
    # 0 hears that they live, and nothing of what they decided.
    network.blocked = lambda sender, to, message: 0 in (sender, to) and not isinstance(message, Heartbeat)
    _goes_on_without_0(network)


def test_who_voted_for_its_own_removal_does_not_support_itself() -> None:
    network = _network(3)

    def only_the_vote_of_0(sender: int, to: int, message: Message) -> bool:
        if isinstance(message, _SYNOD):
            return 2 in (sender, to)
        return isinstance(message, (Request, *_DECIDED)) or (sender == 0 and isinstance(message, Heartbeat))

    network.blocked = only_the_vote_of_0
    _until_viewed(network, 1)
    assert network.robots[0].state.log.decision.value
    network.blocked = lambda sender, to, message: 1 in (sender, to) or isinstance(message, (*_SYNOD, *_DECIDED))
    _goes_on_without_0(network)


def test_a_member_that_left_and_came_back_while_nothing_was_heard_is_held_off() -> None:
    network = _network(3)
    state, now = network.robots[0].state, network.clock(network.robots[0])
    there = Command(Seat(1, 0), 1, ViewChange(0, (0,), ())), Command(Seat(2, 0), 1, ViewChange(1, (1,), (Seat(0, 0),)))
    history = History(Seat(2, 0), 0, tuple((command,) for command in there))
    state, _, _ = step(network.charter, state, now, IncomingMessage(history))
    assert state.seat in state.tables.view.seats
    assert now < state.membership.right
    assert not may_act(network.charter, state, now)


def test_a_team_that_loses_one_after_the_other_goes_on_with_two() -> None:
    network = Network(team(5), 2)
    network.run(Phase(500))
    for member in (4, 3, 2):
        network.run(Phase(2_500, crash=member))
    slot = network.robots[0].state.log.slot
    network.run(Phase(1_000))
    assert network.robots[0].state.log.slot > slot
    assert [seat.member for seat in network.robots[1].state.tables.view.seats] == [0, 1]


def test_a_member_that_leaves_stays_out() -> None:
    network = _network(3)
    network.event(0, Leave())
    network.run(Phase(2_500, idle=True))
    assert [seat.member for seat in network.robots[1].state.tables.view.seats] == [1, 2]
    assert _acts(network, 1)
    assert not _acts(network, 0)


def test_the_last_one_cannot_leave_and_says_nothing_more() -> None:
    network = _network(1)
    network.event(0, Leave())
    network.run(Phase(2_500, idle=True))
    assert network.robots[0].state.log.slot == 0
