"""`Decision`, every interleaving: loss, doubling, reordering, attempts at any moment, and voters that crash for good.

Messages that were once sent stay in the network for ever and arrive any number of times or never, so loss, doubling and
reordering are all in it, and so is a voter that crashes: it is one that does no further step. What is bounded is how
often a voter tries. Voters and messages are numbered, so that a step that was seen once is looked up.
"""

from __future__ import annotations

from typing import cast

import pytest

from kitrobot.team.commands import Batch, Command, Note, Seat
from kitrobot.team.consensus import Decision, SynodMessage, attempt, is_quorum, receive
from kitrobot.team.messages import EVERYONE, Ballot, Chosen, OutgoingMessage, Propose
from tests.effort import cases

_State = tuple[tuple[int, ...], tuple[int, ...], int]
"""The voters, how often each may still try, the messages that were sent (a bit each)."""


def _wish(member: int) -> Batch:
    return (Command(Seat(member, 0), 1, Note((member,))),)


def _voters(count: int) -> tuple[Decision, ...]:
    seats = tuple(Seat(member, 0) for member in range(count))
    return tuple(Decision(seat, 0, seats) for seat in seats)


class _Runs:
    """All runs of some voters that try so often each."""

    def __init__(self, tries: tuple[int, ...]) -> None:
        self.voters: list[Decision] = []
        self.letters: list[tuple[int, SynodMessage]] = []
        self.numbers: dict[object, int] = {}
        self.known: dict[tuple[int, int], tuple[int, int]] = {}
        self.tries = tries
        self.chosen: set[Batch] = set()

    def explore(self, most: int) -> int:
        """How many states were looked at: all there are, if those are fewer than `most`."""
        first: _State = (tuple(self.voter(voter) for voter in _voters(len(self.tries))), self.tries, 0)
        seen, waiting = {first}, [first]
        while waiting and len(seen) < most:
            following = [state for one in waiting for state in self.steps(one)]
            waiting = [state for state in dict.fromkeys(following) if state not in seen]
            seen.update(waiting)
            for state in waiting:
                chosen = {value for number in state[0] if (value := self.voters[number].chosen) is not None}
                assert len(chosen) <= 1, "two values were chosen"
                self.chosen |= chosen
        return len(seen)

    def steps(self, state: _State) -> list[_State]:
        voters, tries, sent = state
        found: list[_State] = []
        for member, number in enumerate(voters):
            if tries[member]:
                after, letters = self.tried(member, number)
                left = (*tries[:member], tries[member] - 1, *tries[member + 1 :])
                found.append(((*voters[:member], after, *voters[member + 1 :]), left, sent | letters))
        bits, letter = sent, 0
        while bits:
            if bits & 1:
                member = self.letters[letter][0]
                after, letters = self.delivered(voters[member], letter)
                found.append(((*voters[:member], after, *voters[member + 1 :]), tries, sent | letters))
            bits, letter = bits >> 1, letter + 1
        return found

    def tried(self, member: int, number: int) -> tuple[int, int]:
        if (number, -1) not in self.known:
            after, sent = attempt(self.voters[number], _wish(member))
            self.known[number, -1] = self.voter(after), self.sent(member, sent)
        return self.known[number, -1]

    def delivered(self, number: int, letter: int) -> tuple[int, int]:
        if (number, letter) not in self.known:
            member, message = self.letters[letter]
            after, sent, why = receive(self.voters[number], message)
            assert why is None
            self.known[number, letter] = self.voter(after), self.sent(member, sent)
        return self.known[number, letter]

    def voter(self, voter: Decision) -> int:
        if voter not in self.numbers:
            self.numbers[voter] = len(self.voters)
            self.voters.append(voter)
        return self.numbers[voter]

    def sent(self, sender: int, sent: tuple[OutgoingMessage, ...]) -> int:
        """The bits of messages; what was chosen is compared, not told, which could only hide a difference."""
        bits = 0
        for to, message in sent:
            for other in range(len(self.tries)) if to == EVERYONE else (to,):
                if other != sender and not isinstance(message, Chosen):
                    letter = (other, cast(SynodMessage, message))
                    if letter not in self.numbers:
                        self.numbers[letter] = len(self.letters)
                        self.letters.append(letter)
                    bits |= 1 << self.numbers[letter]
        return bits


@pytest.mark.parametrize("tries", cases([(1, 1, 0)], [(0, 1, 1)]))
def test_two_of_three_voters_try_and_no_run_chooses_two_values(tries: tuple[int, ...]) -> None:
    runs = _Runs(tries)
    assert 10_000 < runs.explore(100_000) < 100_000
    assert len(runs.chosen) == 2


@pytest.mark.thorough("test_two_of_three_voters_try_and_no_run_chooses_two_values, with fewer tries")
@pytest.mark.parametrize("tries", [(2, 1, 0), (1, 1, 1)])
def test_nor_do_the_first_million_states_where_there_are_more_tries(tries: tuple[int, ...]) -> None:
    runs = _Runs(tries)
    assert runs.explore(1_000_000) > 100_000
    assert len(runs.chosen) > 1


def test_any_two_quorums_share_a_voter() -> None:
    for count in range(1, 9):
        sets = [[r for r in range(count) if mask >> r & 1] for mask in range(1 << count)]
        quorums = [set(ranks) for ranks in sets if is_quorum(ranks, count)]
        assert all(a & b for a in quorums for b in quorums)
        assert all(is_quorum(r, count) for r in sets if 2 * len(r) > count)


def test_a_member_that_says_two_things_is_told() -> None:
    _, second, _ = _voters(3)
    one = Propose(Seat(0, 0), 0, Ballot(0, 0), _wish(0))
    voted, sent, why = receive(second, one)
    assert (len(sent), why) == (1, None)
    other = Propose(Seat(0, 0), 0, Ballot(0, 0), _wish(1))
    again, sent, why = receive(voted, other)
    assert (again, sent) == (voted, ())
    assert why == "member 0 said two different things about one decision"


def test_ballots_of_others_and_from_far_ahead_are_refused() -> None:
    _, second, _ = _voters(3)
    for ballot in (Ballot(1, 2), Ballot(1 << 30, 0)):
        state, sent, why = receive(second, Propose(Seat(0, 0), 0, ballot, ()))
        assert (state, sent) == (second, ())
        assert why


def test_a_seat_of_another_life_has_no_vote() -> None:
    _, second, _ = _voters(3)
    assert receive(second, Propose(Seat(0, 1), 0, Ballot(0, 0), _wish(0))) == (second, (), None)
