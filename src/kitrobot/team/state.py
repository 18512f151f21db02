"""`Member`: the state of one member, and whether its robot may act by it."""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.team import log as logs
from kitrobot.team import membership, shared_store
from kitrobot.team.changes import Changes, OutgoingMessages
from kitrobot.team.charter import Charter
from kitrobot.team.commands import Seat
from kitrobot.team.log import Log
from kitrobot.team.membership import Membership, Peer
from kitrobot.team.shared_store import SharedStore
from kitrobot.team.tables import Tables


class Member(NamedTuple):
    """The state of a member: frozen and hashable.

    Attributes:
        now: the latest time it was given, ms.
        acts_from: when its right to act begins.
        spent: for each member, how many of its messages were read in this beat; refused: how many were ever refused.
    """

    seat: Seat
    now: int
    log: Log
    membership: Membership
    store: SharedStore
    acts_from: int
    spent: tuple[int, ...]
    refused: tuple[int, ...]
    leaving: bool = False

    @property
    def tables(self) -> Tables:
        """What is agreed, as far as the member knows it."""
        return self.log.tables


class StepResult(NamedTuple):
    """A state, the messages to send, and the changes to report to the host."""

    state: Member
    messages: OutgoingMessages
    changes: Changes


def initial_state(charter: Charter, seat: Seat, now: int) -> Member:
    """A member that starts. Its life must be larger than any it had in this run; 0 only at its first start."""
    size = charter.members
    return Member(
        seat=seat,
        now=now,
        log=logs.initial_log(charter, seat),
        membership=Membership((Peer(),) * size, now, now),
        store=shared_store.initial_store(charter.variables),
        acts_from=now,
        spent=(0,) * size,
        refused=(0,) * size,
    )


def may_act(charter: Charter, state: Member, now: int) -> bool:
    """Whether the member's robot may act at this moment, by the host's clock of now; checked before each act."""
    view, seat = state.tables.view, state.seat
    if seat not in view.seats or now < state.acts_from:
        return False
    firm = logs.is_firm(state.log)
    return now < membership.lent_until(state.membership, charter, view, seat, now, firm)
