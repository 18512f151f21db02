"""The laws of single steps of a member; those of states are in `laws`."""

from __future__ import annotations

from kitrobot.team import Counted, Granted, Member, Refused
from kitrobot.team.state import Stepped


def step_breaks(before: Member, stepped: Stepped) -> str:
    """The law of single steps that this one breaks, "" if none."""
    after = stepped.state
    if any(isinstance(change, Refused) for change in stepped.changes):
        return "no message of a member that follows the protocol is refused"
    if after.log.slot < before.log.slot or after.tables.view.number < before.tables.view.number:
        return "nobody forgets what was decided"
    for was, now in zip(before.tables.works, after.tables.works, strict=True):
        for a, b in zip(was.units, now.units, strict=True):
            if b.number < a.number or a.done > b.done:
                return "the number of a unit never falls and a unit that is done stays done"
    holders = {
        (number, index): (unit.holder, unit.done)
        for number, work in enumerate(before.tables.works)
        for index, unit in enumerate(work.units)
    }
    for change in stepped.changes:
        if isinstance(change, Granted) and change.unit >= 0:
            holders[change.work, change.unit] = change.member, False
        if isinstance(change, Counted):
            if holders[change.work, change.unit] != (change.member, False):
                return "a unit is counted once and for its holder"
            holders[change.work, change.unit] = -1, True
    return ""
