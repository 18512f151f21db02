"""Meetings: over when every member of the meeting's groups that is in the view has announced, with one answer for all.

Announcements are commands of the log, so that a meeting is over is not said by anybody: it follows from the log, at all
members from the same slot on. A meeting is passed again and again by loops: each time is an occurrence with a
number that the host counts. A late member (a substitute that begins a block from its start) finds the last
`KEPT` results; one that asks for an older one is told that it is `Late`.
"""

from __future__ import annotations

from kitrobot.team.charter import Charter, Quantifier
from kitrobot.team.commands import Announce
from kitrobot.team.tables import Answered, Meeting, Result, Tables

KEPT = 8


def announced(meeting: Meeting, member: int, command: Announce) -> Meeting:
    """The member stands at this occurrence; what it said first about one stays, an occurrence that is over is left."""
    mine = [said for said in meeting.announced if said.member == member]
    if is_over(meeting, command.occurrence) or (mine and mine[0].occurrence >= command.occurrence):
        return meeting
    others = [said for said in meeting.announced if said.member != member]
    said = Answered(member, command.occurrence, command.answer)
    return meeting._replace(announced=tuple(sorted([*others, said])))


def is_over(meeting: Meeting, occurrence: int) -> bool:
    """Whether this occurrence is over, or so old that nobody knows."""
    kept = meeting.results
    return any(result.occurrence == occurrence for result in kept) or (
        len(kept) == KEPT and occurrence < kept[0].occurrence
    )


def result_of(meeting: Meeting, occurrence: int) -> int | None:
    """The answer of an occurrence that is over; None where it is not over, or forgotten."""
    return next((result.answer for result in meeting.results if result.occurrence == occurrence), None)


def participants(charter: Charter, tables: Tables, number: int) -> tuple[int, ...]:
    """The members that a meeting waits for: those of its groups that are in the view."""
    members = {member for group in charter.meetings[number].groups for member in tables.groups[group]}
    return tuple(sorted(member for member in members if tables.view.has(member)))


def ended(charter: Charter, tables: Tables, number: int) -> tuple[Meeting, Result] | None:
    """The meeting after its end and how it ended, if all it waits for have announced the same occurrence."""
    meeting = tables.meetings[number]
    if not meeting.announced:
        return None
    present = participants(charter, tables, number)
    said = [answered for answered in meeting.announced if answered.member in present]
    if not present or len(said) < len(present) or len({answered.occurrence for answered in said}) > 1:
        return None
    answers = [answered.answer for answered in said]
    result = Result(said[0].occurrence, combined(charter.meetings[number].quantifier, answers))
    waiting = tuple(answered for answered in meeting.announced if answered.occurrence != result.occurrence)
    return Meeting(waiting, tuple(sorted([*meeting.results, result]))[-KEPT:]), result


def combined(quantifier: Quantifier, answers: list[int]) -> int:
    """One answer of several, 0 or 1: any, all, or more than half."""
    yes = sum(answer != 0 for answer in answers)
    return int(
        yes > 0 if quantifier == "any" else yes == len(answers) if quantifier == "all" else 2 * yes > len(answers)
    )
