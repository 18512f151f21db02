"""One command on the tables: deterministic, total, without effect where the command is old, foreign or meaningless.

A command takes effect if its seat is in the view and it is the next one of that seat, so each does so once, in the
order in which its member gave them. A command of a seat that is not in the view waits at its member.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from kitrobot.team import meeting, work
from kitrobot.team.changes import Change, Counted, Granted, NotCounted, Noted, Viewed
from kitrobot.team.charter import Charter, Move
from kitrobot.team.commands import Announce, Batch, Command, Done, Free, Note, Take, ViewChange
from kitrobot.team.tables import Applied, Tables, View

T = TypeVar("T")


def applied(charter: Charter, tables: Tables, batch: Batch) -> tuple[Tables, list[Change]]:
    """The tables after the commands of a slot, and what is told of them."""
    told: list[Change] = []
    for command in batch:
        if is_next(tables, command):
            view = tables.view
            tables = _command(charter, tables, command, told)
            tables = _consequences(charter, tables, told)
            if tables.view != view:
                told.append(Viewed(tables.view))
    return tables, told


def is_next(tables: Tables, command: Command) -> bool:
    """Whether the command would take effect."""
    member = command.seat.member
    return command.seat in tables.view.seats and tables.applied[member] == (command.seat.life, command.number - 1)


def _command(charter: Charter, tables: Tables, command: Command, told: list[Change]) -> Tables:
    """The effect of a command by itself."""
    member = command.seat.member
    tables = tables._replace(applied=_with(tables.applied, member, Applied(command.seat.life, command.number)))
    match command.body:
        case Announce() as said if 0 <= said.meeting < len(tables.meetings):
            after = meeting.announced(tables.meetings[said.meeting], member, said)
            return tables._replace(meetings=_with(tables.meetings, said.meeting, after))
        case Take(work=number) if 0 <= number < len(tables.works):
            return tables._replace(works=_with(tables.works, number, work.asked(tables.works[number], member)))
        case Done() | Free() as said if 0 <= said.work < len(tables.works):
            units = tables.works[said.work]
            if not work.has(units, member, said):
                if isinstance(said, Done):
                    told.append(NotCounted(member, said.work, said.unit))
                return tables
            if isinstance(said, Done):
                told.append(Counted(member, said.work, said.unit))
                return tables._replace(works=_with(tables.works, said.work, work.finished(units, said)))
            return tables._replace(works=_with(tables.works, said.work, work.freed(units, said)))
        case Note(numbers=numbers):
            told.append(Noted(command.seat, numbers))
        case ViewChange() as change if change.view == tables.view.number:
            return _viewed(charter, tables, change)
    return tables


def _viewed(charter: Charter, tables: Tables, change: ViewChange) -> Tables:
    """The tables in the next view; a change that leaves nobody, or changes nothing, has no effect."""
    gone = {seat.member for seat in tables.view.seats} & set(change.leaves)
    stay = tuple(seat for seat in tables.view.seats if seat.member not in gone)
    seats = stay
    for seat in change.joins:
        known = 0 <= seat.member < charter.members and seat.life >= tables.applied[seat.member].life
        if known and all(seat.member != other.member for other in seats):
            seats += (seat,)
    if not seats or seats == tables.view.seats:
        return tables
    forgot = {seat.member for seat in seats if seat.life > tables.applied[seat.member].life}
    for member in gone | forgot:
        forgets = member in forgot
        tables = tables._replace(works=tuple(work.left(units, member, forgets) for units in tables.works))
    for seat in seats:
        if seat.member in forgot:
            tables = tables._replace(applied=_with(tables.applied, seat.member, Applied(seat.life, 0)))
    aborted = (i for i, g in enumerate(charter.groups) if g.failure == "abort" and gone.intersection(tables.groups[i]))
    return _filled(
        charter,
        tables._replace(
            view=View(tables.view.number + 1, seats),
            groups=tuple(tuple(m for m in group if m not in gone) for group in tables.groups),
            players=tuple(tuple(m for m in players if m not in gone) for players in tables.players),
            meetings=tuple(
                m._replace(announced=tuple(said for said in m.announced if said.member not in forgot))
                for m in tables.meetings
            ),
            aborted=tables.aborted if tables.aborted >= 0 else next(aborted, -1),
        ),
    )


def _filled(charter: Charter, tables: Tables) -> Tables:
    """Places of roles that nobody plays go to members without a role: of the group, or spares if it substitutes."""
    for number, role in enumerate(charter.roles):
        busy = {member for players in tables.players for member in players}
        group, players = tables.groups[role.group], tables.players[number]
        spare = [m for m in sorted(set(role.able)) if m not in busy and tables.view.has(m)]
        inside = [m for m in spare if m in group]
        substitutes = charter.groups[role.group].failure == "substitute"
        outside = [m for m in spare if substitutes and not any(m in other for other in tables.groups)]
        new = (inside + outside)[: max(0, role.wanted - len(players))]
        tables = tables._replace(
            players=_with(tables.players, number, tuple(sorted([*players, *new]))),
            groups=_with(tables.groups, role.group, tuple(sorted({*group, *new}))),
        )
    return tables


def _moved(charter: Charter, tables: Tables, move: Move) -> Tables:
    """The first members of a group in another one; what they played in the first is played by others."""
    goers = [m for m in tables.groups[move.source] if tables.view.has(m)][: move.count]
    groups = _with(tables.groups, move.source, tuple(m for m in tables.groups[move.source] if m not in goers))
    groups = _with(groups, move.target, tuple(sorted({*groups[move.target], *goers})))
    players = tuple(
        tuple(m for m in players if m not in goers) if role.group == move.source else players
        for role, players in zip(charter.roles, tables.players, strict=True)
    )
    after = _filled(charter, tables._replace(groups=groups, players=players))
    if after.players == tables.players:
        return after
    return after._replace(view=View(tables.view.number + 1, tables.view.seats))


def _consequences(charter: Charter, tables: Tables, told: list[Change]) -> Tables:
    """Ends the meetings that are over, and gives units to those who wait."""
    for number in range(len(tables.meetings)):
        if end := meeting.ended(charter, tables, number):
            tables = tables._replace(meetings=_with(tables.meetings, number, end[0]))
            for move in charter.meetings[number].moves:
                tables = _moved(charter, tables, move)
            return _consequences(charter, tables, told)
    for number, units in enumerate(tables.works):
        if not units.waiting:
            continue
        after, given = work.shared_out(units, tables.view.has)
        told.extend(Granted(m, number, unit, after.units[unit].number if unit >= 0 else 0) for m, unit in given)
        tables = tables._replace(works=_with(tables.works, number, after))
    return tables


def _with(row: Sequence[T], index: int, value: T) -> tuple[T, ...]:
    return (*row[:index], value, *row[index + 1 :])
