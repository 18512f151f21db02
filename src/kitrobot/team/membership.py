"""`Membership`: who is heard, who is suspected, and until when the right to act is lent.

Every member sends heartbeats with its time and echoes the times that it heard of others. A member counts as heard for a
lease from its *own* time that came back, so both directions work and nobody's clock is compared with another's.

The right to act rests on a quorum of echoes from voters that know the same view and have not voted for a change of
it (`firm`). The quorum that decides a change shares a voter with that one, and the voter echoed before it voted:
so a lease after the change was decided nobody acts by the old view, however long it was stopped or cut off. A member
that comes into the view waits `Charter.hold` from when it learned of it. Clocks may differ in speed by an eighth, not
more.
(Gray and Cheriton, Leases, 1989; Lamport, Malkhi and Zhou, Vertical Paxos, 2009.)
"""

from __future__ import annotations

from operator import itemgetter
from typing import NamedTuple

from msgspec.structs import replace

from kitrobot.team.charter import Charter
from kitrobot.team.commands import Seat, ViewChange
from kitrobot.team.consensus import first_quorum, is_quorum
from kitrobot.team.messages import Echo, Heartbeat
from kitrobot.team.tables import View

NEVER = -(1 << 52)


class Peer(NamedTuple):
    """What is known of another member.

    Attributes:
        life: its latest life; -1: never heard. view: the number of the view it knew.
        stamp, heard: its latest time stamp, and when that came.
        echoed: the latest own time that it sent back; granted: the same, where it supports the present view.
    """

    life: int = -1
    view: int = -1
    stamp: int = NEVER
    heard: int = NEVER
    echoed: int = NEVER
    granted: int = NEVER


_GRANTED = itemgetter(Peer._fields.index("granted"))


class Membership(NamedTuple):
    """What a member knows of the others.

    Attributes:
        since: from when on silence counts (its start, a pause of its own, a new view, a quorum heard again).
        right: until when it may act, as far as views before the present one lent it.
        heard: whether it hears a quorum.
    """

    peers: tuple[Peer, ...]
    since: int
    beat_at: int
    right: int = NEVER
    heard: bool = False


def heartbeat(state: Membership, charter: Charter, now: int, rest: Heartbeat) -> Heartbeat:
    """`rest` with the echoes of what was heard within a lease."""
    echoes = (
        Echo(member, peer.life, peer.stamp)
        for member, peer in enumerate(state.peers)
        if peer.life >= 0 and now - peer.heard < charter.lease
    )
    return replace(rest, echoes=tuple(echoes))


def hear(state: Membership, view: View, seat: Seat, message: Heartbeat, now: int) -> Membership:
    """Takes in a heartbeat; one of an earlier life, and echoes of times that were not, are left."""
    sender = message.sender
    peer = state.peers[sender.member]
    if sender.life < peer.life:
        return state
    if sender.life > peer.life:
        peer = Peer(sender.life)
    if message.stamp >= peer.stamp:
        peer = peer._replace(view=message.view, stamp=message.stamp, heard=now)
    me, mine = seat.member, NEVER
    for member, life, stamp in message.echoes:
        if member == me and life == seat.life and mine < stamp <= now:
            mine = stamp
    supports = message.firm and message.view == view.number and sender in view.seats
    peer = peer._replace(echoed=max(peer.echoed, mine), granted=max(peer.granted, mine) if supports else peer.granted)
    return state._replace(peers=(*state.peers[: sender.member], peer, *state.peers[sender.member + 1 :]))


def in_new_view(state: Membership, now: int) -> Membership:
    """Clears the support of the view before, which does not count for the new one."""
    return state._replace(since=now, peers=tuple(peer._replace(granted=NEVER) for peer in state.peers))


def lent_until(state: Membership, charter: Charter, view: View, seat: Seat, now: int, firm: bool) -> int:
    """Until when a quorum of the view, as it was heard until now, lends the right to act."""
    if seat not in view.seats or not firm:
        return state.right
    granted: list[int] = [*map(_GRANTED, state.peers)]
    granted[seat.member] = now
    stamps = [granted[member] for member, _ in view.seats]
    latest = sorted(range(len(stamps)), key=stamps.__getitem__, reverse=True)
    return max(state.right, stamps[first_quorum(latest)[-1]] + charter.lease)


def hears_quorum(state: Membership, charter: Charter, view: View, seat: Seat, now: int) -> bool:
    """Whether a quorum of the view, this seat in it, was heard within a lease."""
    if seat not in view.seats:
        return False
    peers, since = state.peers, now - charter.lease
    ranks = [
        rank
        for rank, (member, life) in enumerate(view.seats)
        if member == seat.member or (peers[member].life == life and peers[member].echoed > since)
    ]
    return is_quorum(ranks, len(view.seats))


def suspects(state: Membership, charter: Charter, view: View, seat: Seat, now: int) -> tuple[int, ...]:
    """Members of the view that were not heard for a lease, or that began another life."""
    return tuple(
        other.member
        for other in view.seats
        if other != seat
        and (
            state.peers[other.member].life > other.life
            or (not _fresh(state, charter, other, now) and now - state.since >= charter.lease)
        )
    )


def change_wanted(state: Membership, charter: Charter, view: View, seat: Seat, now: int) -> ViewChange | None:
    """The next view, if this one is wrong and it is for this member to say so (the first that is not suspected).

    Who is outside joins when it is heard and knows the present view, so that it has caught up.
    """
    gone = suspects(state, charter, view, seat, now)
    if first_heard(view, gone) != seat or not state.heard:
        return None
    joins = tuple(
        Seat(member, peer.life)
        for member, peer in enumerate(state.peers)
        if peer.life >= 0
        and peer.view == view.number
        and _fresh(state, charter, Seat(member, peer.life), now)
        and Seat(member, peer.life) not in view.seats
    )
    return ViewChange(view.number, gone, joins) if gone or joins else None


def first_heard(view: View, gone: tuple[int, ...]) -> Seat | None:
    """The first seat of the view that is not suspected."""
    return next((seat for seat in view.seats if seat.member not in gone), None)


def _fresh(state: Membership, charter: Charter, seat: Seat, now: int) -> bool:
    peer = state.peers[seat.member]
    return peer.life == seat.life and now - peer.echoed < charter.lease
