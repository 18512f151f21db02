"""`Decision`: the voters of one slot agree on one value, though messages are lost, doubled, late and out of order.

It is Lamport's single-decree synod (The Part-Time Parliament, 1998). The lowest ballot belongs to the first voter and
needs no promises, so the usual case is one round trip; anyone else takes over with a higher ballot. When to try again
is the caller's affair (`log`): nothing here depends on time.

Invariant: a value is chosen in ballot b only if a quorum voted for it in b, and no higher ballot proposes another
one, because any two quorums share a voter. A quorum is more than half, or exactly half with the first voter.

A voter keeps its promises for the whole of its life; a process that forgot them has another seat and is no voter.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NamedTuple

from kitrobot.team.commands import Batch, Seat
from kitrobot.team.messages import (
    EVERYONE,
    Accepted,
    Ballot,
    Chosen,
    Denied,
    OutgoingMessage,
    Prepare,
    Promise,
    Propose,
)
from kitrobot.text.sentences import Sentence

FIRST = Ballot(0, 0)
NO_BALLOT = Ballot(-1, -1)
FAR = 1 << 20
"""Rounds by which a ballot may be ahead of what a voter promised; nobody comes that far by trying."""

SynodMessage = Prepare | Promise | Propose | Accepted | Denied | Chosen


def is_quorum(ranks: Collection[int], voters: int) -> bool:
    """Whether these voters, by rank, may decide for all of them."""
    return 2 * len(ranks) > voters or (2 * len(ranks) == voters and 0 in ranks)


def first_quorum(ranks: Sequence[int]) -> Sequence[int]:
    """The fewest voters from the beginning of a row of all of them, by rank, that may decide for all."""
    half = ranks[: len(ranks) // 2]
    return half if is_quorum(half, len(ranks)) else ranks[: len(half) + 1]


class Decision(NamedTuple):
    """One voter's (or onlooker's) part in one slot.

    Attributes:
        promised: it votes in no lower ballot.
        accepted, value: its last vote.
        ballot: its own attempt; `proposal` is what that proposes, None while promises are collected; `wanted` is what
            it would like to propose.
        promises: (rank, accepted, value) of those who promised `ballot`; votes: ranks of those who voted in it.
        chosen: what was decided, None before.
        fewest: ranks of the voters that a proposal asks at first, a quorum; () asks all. A repetition asks all.
    """

    seat: Seat
    slot: int
    voters: tuple[Seat, ...]
    promised: Ballot = FIRST
    accepted: Ballot = NO_BALLOT
    value: Batch = ()
    ballot: Ballot = NO_BALLOT
    wanted: Batch = ()
    proposal: Batch | None = None
    promises: tuple[tuple[int, Ballot, Batch], ...] = ()
    votes: tuple[int, ...] = ()
    chosen: Batch | None = None
    fewest: tuple[int, ...] = ()

    @property
    def rank(self) -> int:
        """Its place among the voters; -1 for one that only looks on."""
        return self.voters.index(self.seat) if self.seat in self.voters else -1


Answer = tuple[Decision, tuple[OutgoingMessage, ...], Sentence | None]
"""The state after a step, what is sent, and why the message was refused, if it was."""


def attempt(state: Decision, wanted: Batch) -> tuple[Decision, tuple[OutgoingMessage, ...]]:
    """Begins a ballot of its own, or repeats the request of the running one; nothing for an onlooker."""
    if state.rank < 0 or state.chosen is not None:
        return state, ()
    if state.ballot == state.promised:
        return state, open_requests(state)
    if state.rank == 0 and state.promised == FIRST:
        return _propose(state._replace(ballot=FIRST), wanted)
    ballot = Ballot(state.promised.round + 1, state.rank)
    state = state._replace(promised=ballot, ballot=ballot, wanted=wanted, proposal=None, promises=(), votes=())
    state, sent = _count_promise(state, state.rank, state.accepted, state.value)
    return state, sent or open_requests(state)


def receive(state: Decision, message: SynodMessage) -> Answer:
    """Handles a message of another voter about this slot, or of anyone about its decision."""
    if isinstance(message, Chosen):
        if state.chosen is None:
            return state._replace(chosen=message.value), (), None
        return state, (), None if state.chosen == message.value else contradiction(message.sender)
    if message.sender not in state.voters or message.slot != state.slot:
        return state, (), None
    if state.chosen is not None:
        known = (
            () if isinstance(message, Accepted) else _to(message.sender, Chosen(state.seat, state.slot, state.chosen))
        )
        return state, known, None
    rank = state.voters.index(message.sender)
    if message.ballot.round > state.promised.round + FAR:
        return state, (), Sentence("member {member} is too far ahead to be believed", message.sender.member)
    if isinstance(message, Prepare | Propose):
        return _vote(state, message, rank)
    if isinstance(message, Denied):
        return (state._replace(promised=message.ballot) if message.ballot > state.promised else state), (), None
    if message.ballot != state.ballot:
        return state, (), None
    if isinstance(message, Promise):
        return *_count_promise(state, rank, message.accepted, message.value), None
    return *_count_vote(state, rank), None


def _vote(state: Decision, message: Prepare | Propose, rank: int) -> Answer:
    """The answer of a voter to a ballot of another one."""
    ballot = message.ballot
    if state.rank < 0:
        return state, (), None
    if ballot.rank != rank:
        return state, (), Sentence("member {member} used a ballot that is not its own", message.sender.member)
    if ballot < state.promised:
        return state, _to(message.sender, Denied(state.seat, state.slot, state.promised)), None
    if isinstance(message, Prepare):
        state = state._replace(promised=ballot)
        return state, _to(message.sender, Promise(state.seat, state.slot, ballot, state.accepted, state.value)), None
    if ballot == state.accepted and message.value != state.value:
        return state, (), contradiction(message.sender)
    state = state._replace(promised=ballot, accepted=ballot, value=message.value)
    return state, _to(message.sender, Accepted(state.seat, state.slot, ballot)), None


def _count_promise(
    state: Decision, rank: int, accepted: Ballot, value: Batch
) -> tuple[Decision, tuple[OutgoingMessage, ...]]:
    """Counts a promise; with a quorum, proposes the value of the highest vote among them, else the one wanted."""
    if state.proposal is not None or state.ballot != state.promised:
        return state, ()
    others = [promise for promise in state.promises if promise[0] != rank]
    state = state._replace(promises=tuple(sorted([*others, (rank, accepted, value)], key=lambda promise: promise[0])))
    if not is_quorum([promise[0] for promise in state.promises], len(state.voters)):
        return state, ()
    _, highest, voted = max(state.promises, key=lambda promise: promise[1])
    return _propose(state, state.wanted if highest == NO_BALLOT else voted)


def _propose(state: Decision, value: Batch) -> tuple[Decision, tuple[OutgoingMessage, ...]]:
    """Asks for votes, and votes itself."""
    state = state._replace(proposal=value, promises=(), accepted=state.ballot, value=value)
    state, sent = _count_vote(state, state.rank)
    if sent:
        return state, sent
    return state, tuple(
        sending._replace(to=to)
        for sending in open_requests(state)
        for to in [state.voters[rank].member for rank in state.fewest if rank != state.rank] or [EVERYONE]
    )


def _count_vote(state: Decision, rank: int) -> tuple[Decision, tuple[OutgoingMessage, ...]]:
    """Counts a vote; with a quorum the value is chosen."""
    if state.proposal is None:
        return state, ()
    state = state._replace(votes=tuple(sorted({*state.votes, rank})))
    if not is_quorum(state.votes, len(state.voters)):
        return state, ()
    return state._replace(chosen=state.proposal), (
        OutgoingMessage(EVERYONE, Chosen(state.seat, state.slot, state.proposal or ())),
    )


def open_requests(state: Decision, to: int = EVERYONE) -> tuple[OutgoingMessage, ...]:
    """Returns the open request of the running ballot to the others, if one runs."""
    if state.ballot == NO_BALLOT or state.ballot != state.promised or state.chosen is not None:
        return ()
    if state.proposal is None:
        return (OutgoingMessage(to, Prepare(state.seat, state.slot, state.ballot)),)
    return (OutgoingMessage(to, Propose(state.seat, state.slot, state.ballot, state.proposal)),)


def _to(seat: Seat, message: SynodMessage) -> tuple[OutgoingMessage, ...]:
    return (OutgoingMessage(seat.member, message),)


def contradiction(sender: Seat) -> Sentence:
    """The refusal of a member that contradicts itself."""
    return Sentence("member {member} said two different things about one decision", sender.member)
