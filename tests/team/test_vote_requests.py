"""How few messages a decision takes: who is asked for votes, and what is decided together."""

from __future__ import annotations

from dataclasses import dataclass, field

from kitrobot.team.charter import Charter
from kitrobot.team.commands import Note, Seat
from kitrobot.team.events import Event, IncomingMessage, Time
from kitrobot.team.member import step
from kitrobot.team.messages import EVERYONE, Accepted, Message, Propose
from kitrobot.team.state import Member, initial_state

MEMBERS = 5
CHARTER = Charter(MEMBERS)


@dataclass
class Members:
    """Members whose messages arrive in order; `proposed`: each Propose that was sent, by slot, with who was asked."""

    states: list[Member] = field(
        default_factory=lambda: [initial_state(CHARTER, Seat(m, 0), 0) for m in range(MEMBERS)]
    )
    proposed: list[tuple[int, tuple[int, ...]]] = field(default_factory=list)
    deaf: set[int] = field(default_factory=set)
    now: int = 0

    def tell(self, member: int, event: Event) -> None:
        """An event at a member, and all that follows from it."""
        waiting = [(member, event)]
        while waiting:
            to, what = waiting.pop(0)
            stepped = step(CHARTER, self.states[to], self.now, what)
            self.states[to] = stepped.state
            asked: list[int] = []
            for addressee, message in stepped.messages:
                for other in range(MEMBERS) if addressee == EVERYONE else (addressee,):
                    if other != to and other not in self.deaf:
                        waiting.append((other, IncomingMessage(message)))
                    if other != to and isinstance(message, Propose):
                        asked.append(other)
            if asked:
                self.proposed.append((self.states[to].log.slot, tuple(asked)))

    def pass_time(self, ms: int) -> None:
        for _ in range(ms // 25):
            self.now += 25
            for member in range(MEMBERS):
                if member not in self.deaf:
                    self.tell(member, Time())


def test_those_are_asked_first_who_voted_last_and_all_where_one_of_them_is_missing() -> None:
    team = Members()
    team.tell(0, Note((1,)))
    team.tell(0, Note((2,)))
    assert team.proposed == [(0, (1, 2, 3, 4)), (1, (1, 2))]
    team.deaf = {1}
    team.tell(0, Note((3,)))
    assert team.states[0].log.slot == 2
    team.pass_time(CHARTER.lease // 2)
    assert team.proposed[2:] == [(2, (1, 2)), (2, (1, 2, 3, 4))]
    assert {state.log.slot for member, state in enumerate(team.states) if member != 1} == {3}
    # From then on all are asked for some time.
    team.tell(0, Note((4,)))
    assert team.proposed[4:] == [(3, (1, 2, 3, 4))]
    assert team.states[0].log.slot == 4


def test_what_came_together_is_decided_together() -> None:
    asking: list[Message] = []
    for member in range(1, MEMBERS):
        state = initial_state(CHARTER, Seat(member, 0), 0)
        asking += [message for _, message in step(CHARTER, state, 0, Note((member,))).messages]
    first = initial_state(CHARTER, Seat(0, 0), 0)
    sent: list[Message] = []
    for number, message in enumerate(asking, 1):
        stepped = step(CHARTER, first, 0, IncomingMessage(message, more=number < len(asking)))
        first = stepped.state
        sent += [message for _, message in stepped.messages]
    [proposal] = sent
    assert isinstance(proposal, Propose)
    assert [command.seat.member for command in proposal.value] == [1, 2, 3, 4]


def test_votes_of_an_earlier_slot_count_for_nothing() -> None:
    team = Members()
    team.tell(0, Note((1,)))
    team.deaf = {1, 2, 3, 4}
    team.tell(0, Note((2,)))
    ballot = team.states[0].log.decision.ballot
    for voter in (1, 2, 3, 4):
        team.tell(0, IncomingMessage(Accepted(Seat(voter, 0), 0, ballot)))
    assert team.states[0].log.slot == 1
