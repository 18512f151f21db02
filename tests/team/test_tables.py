"""What decided commands make of the tables: roles and groups when members leave and come, meetings, moves, work."""

from __future__ import annotations

import pytest

from kitrobot.team import (
    Announce,
    Charter,
    Done,
    Free,
    Group,
    Late,
    MeetingRule,
    Move,
    Passed,
    Role,
    Seat,
    Take,
    Work,
    first_state,
    step,
)
from kitrobot.team.applying import applied
from kitrobot.team.changes import Change, Counted, Granted, NotCounted, Viewed
from kitrobot.team.charter import Failure
from kitrobot.team.commands import Body, Command, ViewChange
from kitrobot.team.meeting import KEPT, combined
from kitrobot.team.tables import Tables, Unit, first_tables


class _Team:
    """Tables, and commands given to them one after the other."""

    def __init__(self, charter: Charter) -> None:
        self.charter = charter
        self.tables: Tables = first_tables(charter)

    def give(self, member: int, body: Body, life: int = 0) -> list[Change]:
        last = self.tables.applied[member]
        number = last.last + 1 if last.life == life else 1
        self.tables, told = applied(self.charter, self.tables, (Command(Seat(member, life), number, body),))
        return told

    def results(self) -> list[tuple[int, int]]:
        return [(result.occurrence, result.answer) for result in self.tables.meetings[0].results]

    def view(self, *leaves: int, joins: tuple[Seat, ...] = (), by: int = 0) -> list[Change]:
        return self.give(by, ViewChange(self.tables.view.number, leaves, joins))


def _with_failure(failure: Failure) -> _Team:
    return _Team(Charter(4, roles=(Role((1, 2, 3), 1, 0),), groups=(Group((0, 1), failure),)))


def test_a_substitute_takes_the_role_and_the_place_in_the_group() -> None:
    team = _with_failure("substitute")
    assert team.tables.players == ((1,),)
    assert team.view(1) == [Viewed(team.tables.view)]
    assert (team.tables.players, team.tables.groups, team.tables.aborted) == (((2,),), ((0, 2),), -1)
    team.view(joins=(Seat(1, 0),))
    assert (team.tables.players, team.tables.groups) == (((2,),), ((0, 2),)), "who comes back is a spare"
    team.view(2, 3)
    assert team.tables.players == ((1,),)


def test_a_group_that_drops_goes_on_without_and_one_that_aborts_says_so() -> None:
    for failure, aborted in (("drop", -1), ("abort", 0)):
        team = _with_failure(failure)  # type: ignore[arg-type]
        team.view(1)
        assert (team.tables.players, team.tables.groups, team.tables.aborted) == (((),), ((0,),), aborted)


def test_a_change_of_an_old_view_or_that_leaves_nobody_has_no_effect() -> None:
    team = _with_failure("drop")
    team.view(1)
    for change in (ViewChange(0, (2,), ()), ViewChange(1, (0, 2, 3), ()), ViewChange(1, (), (Seat(9, 0), Seat(-1, 0)))):
        before = team.tables.view
        team.give(0, change)
        assert team.tables.view == before


def test_each_command_takes_effect_once_in_its_order_and_only_from_the_view() -> None:
    team = _Team(Charter(2, works=(Work(3),)))
    take = [Command(Seat(0, 0), number, Take(0)) for number in (1, 2)]
    for batch in (take[1:], take[:1], take[:1], (Command(Seat(0, 1), 2, Take(0)),)):
        team.tables, _ = applied(team.charter, team.tables, tuple(batch))
    assert [unit.holder for unit in team.tables.works[0].units] == [0, -1, -1]


def test_a_unit_is_done_once_and_only_by_its_holder() -> None:
    team = _Team(Charter(3, works=(Work(1),)))
    assert team.give(1, Take(0)) == [Granted(1, 0, 0, 1)]
    assert team.give(2, Take(0)) == []
    assert team.give(2, Done(0, 0, 1)) == [NotCounted(2, 0, 0)]
    team.give(0, Free(0, 0, 1))
    assert team.tables.works[0].units == (Unit(2, 2, False),), "who waits gets what is free"
    team.give(0, Free(0, 0, 1))
    assert team.tables.works[0].units == (Unit(2, 2, False),)
    assert team.give(1, Done(0, 0, 1)) == [NotCounted(1, 0, 0)]
    assert team.give(2, Done(0, 0, 2)) == [Counted(2, 0, 0)]
    assert team.give(2, Done(0, 0, 2)) == [NotCounted(2, 0, 0)]
    assert team.give(1, Take(0)) == [Granted(1, 0, -1, 0)], "none is left"


def test_what_a_member_that_left_held_is_free_again() -> None:
    team = _Team(Charter(3, works=(Work(1),)))
    team.give(1, Take(0))
    team.give(2, Take(0))
    assert Granted(2, 0, 0, 2) in team.view(1)
    team.view(2, joins=(Seat(2, 5),))
    assert team.tables.works[0].units == (Unit(-1, 2, False),)
    assert team.give(2, Take(0), life=5) == [Granted(2, 0, 0, 3)]


def _meeting(*moves: Move) -> _Team:
    groups = (Group((0, 1)), Group((2,), "substitute"))
    return _Team(Charter(3, (Role((0, 1, 2), 2, 1),), groups, (MeetingRule((0,), "any", moves),)))


def test_a_meeting_is_over_when_all_of_the_view_have_come_or_left() -> None:
    team = _meeting()
    team.give(0, Announce(0, 0, 0))
    assert not team.results()
    team.give(2, Announce(0, 0, 1))
    assert not team.results(), "one that is in no group of it does not count"
    team.give(0, Announce(0, 0, 1))
    team.give(1, Announce(0, 0, 0))
    assert team.results() == [(0, 0)], "what was said first counts"
    team.give(0, Announce(0, 1, 1))
    team.view(1)
    assert team.results() == [(0, 0), (1, 1)]


def test_a_move_is_made_once_at_the_end_of_its_meeting_and_is_a_new_view() -> None:
    team = _meeting(Move(0, 1, 1))
    team.give(0, Announce(0, 0, 0))
    team.give(1, Announce(0, 0, 0))
    assert (team.tables.groups, team.tables.players) == (((1,), (0, 2)), ((0, 2),))
    assert team.tables.view.number == 1


def test_a_late_member_hears_the_answer_or_that_it_is_too_late() -> None:
    charter = Charter(1, groups=(Group((0,)),), meetings=(MeetingRule((0,)),))
    state, answer = first_state(charter, Seat(0, 0), 0), 1
    for occurrence in range(KEPT + 2):
        state, _, changes = step(charter, state, 0, Announce(0, occurrence, occurrence % 2))
        assert Passed(0, occurrence, occurrence % 2) in changes
    for occurrence in (2, KEPT + 1):
        state, _, changes = step(charter, state, 0, Announce(0, occurrence, answer))
        assert changes == (Passed(0, occurrence, occurrence % 2),)
    assert step(charter, state, 0, Announce(0, 1, 1)).changes == (Late(0, 1),)


@pytest.mark.parametrize(
    ("answers", "said"), [([0, 0], (0, 0, 0)), ([1, 0], (1, 0, 0)), ([1, 1, 0], (1, 0, 1)), ([1], (1, 1, 1))]
)
def test_answers_are_combined_by_any_all_or_most(answers: list[int], said: tuple[int, int, int]) -> None:
    assert (combined("any", answers), combined("all", answers), combined("most", answers)) == said


@pytest.mark.parametrize("change", [{"members": 0}, {"lease": 9}, {"groups": (Group((2,)),)}, {"works": (Work(5000),)}])
def test_a_charter_that_names_what_it_has_not_is_an_error(change: dict[str, object]) -> None:
    with pytest.raises(ValueError, match=r"a charter names|a team has|work has"):
        Charter(**{"members": 2, **change})  # type: ignore[arg-type]
