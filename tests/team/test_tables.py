"""What decided commands make of the tables: views when members leave and come, each command once."""

from __future__ import annotations

import pytest

from kitrobot.team.changes import AppliedNote, Change, NewView
from kitrobot.team.charter import Charter
from kitrobot.team.commands import Body, Command, Note, Seat, ViewChange
from kitrobot.team.table_transitions import apply_batch
from kitrobot.team.tables import Tables, initial_tables


class _Team:
    """Tables, and commands given to them one after the other."""

    def __init__(self, members: int) -> None:
        self.tables: Tables = initial_tables(Charter(members))

    def give(self, member: int, body: Body, life: int = 0) -> list[Change]:
        last = self.tables.applied[member]
        number = last.last + 1 if last.life == life else 1
        self.tables, changes = apply_batch(self.tables, (Command(Seat(member, life), number, body),))
        return changes

    def view(self, *leaves: int, joins: tuple[Seat, ...] = (), by: int = 0) -> list[Change]:
        return self.give(by, ViewChange(self.tables.view.number, leaves, joins))

    def seats(self) -> list[tuple[int, int]]:
        return [(seat.member, seat.life) for seat in self.tables.view.seats]


def test_a_member_leaves_the_view_and_comes_back_behind_the_others() -> None:
    team = _Team(3)
    assert team.view(1) == [NewView(team.tables.view)]
    assert (team.tables.view.number, team.seats()) == (1, [(0, 0), (2, 0)])
    team.view(joins=(Seat(1, 0),))
    assert (team.tables.view.number, team.seats()) == (2, [(0, 0), (2, 0), (1, 0)])


def test_a_member_in_another_life_gives_its_commands_from_the_first_on() -> None:
    team = _Team(2)
    assert team.give(1, Note((7,))) == [AppliedNote(Seat(1, 0), (7,))]
    team.view(1, joins=(Seat(1, 2),))
    assert team.seats() == [(0, 0), (1, 2)]
    assert team.give(1, Note((7,))) == [], "its first life is over"
    assert team.give(1, Note((8,)), life=2) == [AppliedNote(Seat(1, 2), (8,))]


@pytest.mark.parametrize(
    "change",
    [
        ViewChange(0, (2,), ()),
        ViewChange(1, (0, 2, 3), ()),
        ViewChange(1, (), (Seat(9, 0), Seat(-1, 0))),
        ViewChange(1, (), (Seat(2, 0),)),
    ],
)
def test_a_change_of_an_old_view_or_that_leaves_nobody_or_names_nobody_has_no_effect(change: ViewChange) -> None:
    team = _Team(4)
    team.view(1)
    before = team.tables.view
    team.give(0, change)
    assert team.tables.view == before


def test_each_command_takes_effect_once_in_its_order_and_only_from_the_view() -> None:
    tables = initial_tables(Charter(2))
    first, second = (Command(Seat(0, 0), number, Note((number,))) for number in (1, 2))
    noted = []
    for batch in ((second,), (first,), (first,), (Command(Seat(0, 1), 2, Note((9,))),), (second, second)):
        tables, changes = apply_batch(tables, batch)
        noted += [change.numbers for change in changes if isinstance(change, AppliedNote)]
    assert noted == [(1,), (2,)]


@pytest.mark.parametrize("size", [{"members": 0}, {"members": 65}, {"lease": 9}])
def test_a_charter_of_a_size_that_cannot_be_is_an_error(size: dict[str, int]) -> None:
    with pytest.raises(ValueError, match="a team has 1 to 64 members"):
        Charter(**{"members": 2, **size})
