"""Members moved in time: states are compared by times relative to now, which the machines never see."""

from __future__ import annotations

from kitrobot.team.membership import NEVER
from kitrobot.team.state import Member

LEASE = 16
"""Ms: a beat is 2 of them, and all that a machine waits for is a number of beats."""
NOW = 1_000


def shifted(state: Member, ms: int, oldest: int = -(1 << 60)) -> Member:
    """The member with all its times so much later, none before the `oldest`."""

    def at(time: int) -> int:
        return max(time + ms if time != NEVER else NEVER, oldest)

    known = state.membership
    peers = tuple(
        peer._replace(stamp=at(peer.stamp), heard=at(peer.heard), echoed=at(peer.echoed), granted=at(peer.granted))
        for peer in known.peers
    )
    log = state.log
    return state._replace(
        now=state.now + ms,
        log=log._replace(retry_at=at(log.retry_at) if log.retry_at else 0),
        membership=known._replace(peers=peers, since=at(known.since), beat_at=at(known.beat_at), right=at(known.right)),
        acts_from=at(state.acts_from),
    )


def relative(state: Member) -> Member:
    """The member with `NOW` for its time. What is over for four leases is made equal, and so are attempts from the
    eighth on, which no machine tells apart.
    """
    state = shifted(state, NOW - state.now, NOW - 4 * LEASE)
    return state._replace(log=state.log._replace(attempts=min(state.log.attempts, 8)))
