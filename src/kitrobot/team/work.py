"""Work shared out in units: each has at most one holder, is counted as done once, and is never lost.

A unit's number grows with each holder, so what an old holder says of it is known to be old. Leases are the host's
time, not the log's: the leader asks for `Free` when a lease has run out by its clock, and the log decides.
"""

from __future__ import annotations

from collections.abc import Callable

from kitrobot.team.commands import Done, Free
from kitrobot.team.tables import Unit, WorkList


def asked(work: WorkList, member: int) -> WorkList:
    """The member waits for a unit; it stands in the row once."""
    return work if member in work.waiting else work._replace(waiting=(*work.waiting, member))


def has(work: WorkList, member: int, command: Done | Free) -> bool:
    """Whether the command names a unit as it is held now; only the holder may say that it is done."""
    if not 0 <= command.unit < len(work.units):
        return False
    unit = work.units[command.unit]
    held = not unit.done and unit.holder >= 0 and unit.number == command.number
    return held and (isinstance(command, Free) or unit.holder == member)


def finished(work: WorkList, command: Done) -> WorkList:
    """The unit is done."""
    return _with(work, command.unit, Unit(-1, command.number, True))


def freed(work: WorkList, command: Free) -> WorkList:
    """The unit is nobody's again."""
    return _with(work, command.unit, Unit(-1, command.number, False))


def left(work: WorkList, member: int, forgets: bool) -> WorkList:
    """What the member holds is free; it keeps its place in the row unless its process `forgets` that it asked."""
    units = tuple(Unit(-1, unit.number, False) if unit.holder == member else unit for unit in work.units)
    waiting = tuple(m for m in work.waiting if m != member) if forgets else work.waiting
    return WorkList(units, waiting)


def shared_out(work: WorkList, present: Callable[[int], bool]) -> tuple[WorkList, list[tuple[int, int]]]:
    """Free units go to those who wait and are present; (member, unit) for each, unit -1 where none will come."""
    given: list[tuple[int, int]] = []
    for member in work.waiting:
        if not present(member):
            continue
        free = next((i for i, unit in enumerate(work.units) if not unit.done and unit.holder < 0), -1)
        if free < 0 and work.left:
            break
        if free >= 0:
            work = _with(work, free, Unit(member, work.units[free].number + 1, False))
        work = work._replace(waiting=tuple(m for m in work.waiting if m != member))
        given.append((member, free))
    return work, given


def _with(work: WorkList, index: int, unit: Unit) -> WorkList:
    return work._replace(units=(*work.units[:index], unit, *work.units[index + 1 :]))
