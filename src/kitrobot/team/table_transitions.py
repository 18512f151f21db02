"""One command on the tables: deterministic, total, without effect where the command is old, foreign or meaningless.

A command takes effect if its seat is in the view and it is the next one of that seat, so each does so once, in the
order in which its member gave them. A command of a seat that is not in the view waits at its member.
"""

from __future__ import annotations

from kitrobot.team.changes import AppliedNote, Change, NewView
from kitrobot.team.commands import Batch, Command, Note, ViewChange
from kitrobot.team.tables import LastCommand, Tables, View


def apply_batch(tables: Tables, batch: Batch) -> tuple[Tables, list[Change]]:
    """The tables after the commands of a slot, and the changes that hosts are given of them."""
    changes: list[Change] = []
    for command in batch:
        if is_next(tables, command):
            seat, body = command.seat, command.body
            tables = _with_last_command(tables, seat.member, LastCommand(seat.life, command.number))
            if isinstance(body, Note):
                changes.append(AppliedNote(seat, body.numbers))
            elif body.view == tables.view.number:
                view = tables.view
                tables = _change_view(tables, body)
                if tables.view != view:
                    changes.append(NewView(tables.view))
    return tables, changes


def is_next(tables: Tables, command: Command) -> bool:
    """Whether the command would take effect."""
    member = command.seat.member
    return command.seat in tables.view.seats and tables.applied[member] == (command.seat.life, command.number - 1)


def _change_view(tables: Tables, change: ViewChange) -> Tables:
    """The tables in the next view; a change that leaves nobody, or changes nothing, has no effect."""
    seats = tuple(seat for seat in tables.view.seats if seat.member not in change.leaves)
    for seat in change.joins:
        known = 0 <= seat.member < len(tables.applied) and seat.life >= tables.applied[seat.member].life
        if known and all(seat.member != other.member for other in seats):
            seats += (seat,)
    if not seats or seats == tables.view.seats:
        return tables
    for seat in seats:
        if seat.life > tables.applied[seat.member].life:
            tables = _with_last_command(tables, seat.member, LastCommand(seat.life, 0))
    return tables._replace(view=View(tables.view.number + 1, seats))


def _with_last_command(tables: Tables, member: int, value: LastCommand) -> Tables:
    return tables._replace(applied=(*tables.applied[:member], value, *tables.applied[member + 1 :]))
