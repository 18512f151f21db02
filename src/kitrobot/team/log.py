"""`Log`: one decision after the other. The voters of a slot are the view that the slots before it made.

So a change of the view is a decision like any other, and no two views ever decide the same slot. Members send
their commands to the first of the view, which proposes what it has as one batch; when nothing is decided for some time
anyone with a command tries a ballot of its own. Patience grows with the rank and with each attempt, and begins anew
when another one tries: of several that try, the first in rank is left alone. (Lamport's multi-decree synod with the
reconfiguration of its section on choosing a new legislature, with no slots in parallel.)

A member that missed decisions requests them from whoever knows more. Only the last `MOST_RECENT` are stored; before
them, tables are sent.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from kitrobot.team import consensus as synod
from kitrobot.team.changes import Change, LogGap, Refusal, SlotDecision
from kitrobot.team.charter import Charter
from kitrobot.team.commands import Batch, Body, Command, Seat, ViewChange
from kitrobot.team.consensus import FIRST, NO_BALLOT, Decision, SynodMessage, is_quorum
from kitrobot.team.messages import (
    Behind,
    Chosen,
    History,
    OutgoingMessage,
    Prepare,
    Promise,
    Propose,
    Request,
    Snapshot,
)
from kitrobot.team.table_transitions import apply_batch
from kitrobot.team.tables import Tables, initial_tables
from kitrobot.text.sentences import Sentence

MOST_RECENT = 32
MOST_COMMANDS = 64
"""Commands in a batch."""
MOST_PENDING = 16
"""Commands of one member that are not decided yet."""
WARY = 16
"""Slots for which votes are requested of all at once after one that was requested twice."""

LogMessage = SynodMessage | Request | Behind | History | Snapshot


@dataclass(slots=True)
class StepOutput:
    """What a step sends and reports, while it is made."""

    messages: list[OutgoingMessage] = field(default_factory=list)
    changes: list[Change] = field(default_factory=list)

    def refuse(self, member: int, why: Sentence) -> None:
        self.changes.append(Refusal(member, why))


class Log(NamedTuple):
    """A member's copy.

    Attributes:
        decision: the slot that is open; its number is how many are decided.
        recent: what the last slots decided.
        pending: own commands that have no effect yet; `given` is the number of the last one.
        requested: for each member, the commands it requested.
        retry_at: when to try a ballot, 0: nothing to try; attempts: how often that was done for this slot.
        wary: for how many slots yet votes are requested of all at once, since one request had to be repeated.
    """

    tables: Tables
    decision: Decision
    recent: tuple[Batch, ...]
    pending: Batch
    given: int
    requested: tuple[Batch, ...]
    retry_at: int = 0
    attempts: int = 0
    wary: int = 0

    @property
    def slot(self) -> int:
        """How many slots are decided."""
        return self.decision.slot


def initial_log(charter: Charter, seat: Seat) -> Log:
    """The log of a member that knows of no decision."""
    tables = initial_tables(charter)
    return Log(tables, Decision(seat, 0, tables.view.seats), (), (), 0, ((),) * charter.members)


def add_command(log: Log, body: Body) -> Log | None:
    """The log with one more own command; None when there are too many. One that is pending is not given twice."""
    if any(command.body == body for command in log.pending):
        return log
    if len(log.pending) >= MOST_PENDING:
        return None
    command = Command(log.decision.seat, log.given + 1, body)
    return log._replace(pending=(*log.pending, command), given=command.number)


def is_firm(log: Log) -> bool:
    """Whether it has voted for no change of the view in the open slot."""
    value = log.decision.value
    if not any(isinstance(command.body, ViewChange) for command in value):
        return True
    return apply_batch(log.tables, value)[0].view == log.tables.view


def request(log: Log, to: int) -> OutgoingMessage:
    """Asks for the own commands to be decided."""
    return OutgoingMessage(to, Request(log.decision.seat, log.pending))


def receive(charter: Charter, log: Log, message: LogMessage, now: int, out: StepOutput) -> Log:
    """Takes in a message about the log."""
    seat, sender = log.decision.seat, message.sender
    if isinstance(message, Request):
        own = all(command.seat == sender for command in message.commands)
        if not own or len(message.commands) > MOST_PENDING:
            out.refuse(sender.member, Sentence("member {member} asked for what it may not ask for", sender.member))
            return log
        known = log.requested[sender.member]
        if known and message.commands and _newest(message.commands) < _newest(known):
            return log
        requested = (*log.requested[: sender.member], message.commands, *log.requested[sender.member + 1 :])
        return log._replace(requested=requested)
    if isinstance(message, Behind):
        if message.slot < log.slot:
            out.messages.append(OutgoingMessage(sender.member, _history_from(log, message.slot)))
            out.messages.extend(synod.open_requests(log.decision, sender.member))
        return log
    if isinstance(message, Snapshot):
        return _from_snapshot(charter, log, message, out)
    if isinstance(message, History):
        for slot, value in enumerate(message.values, message.slot):
            log = receive(charter, log, Chosen(sender, slot, value), now, out)
        return log
    if message.slot > log.slot:
        if not isinstance(message, Chosen):
            out.messages.append(OutgoingMessage(sender.member, Behind(seat, log.slot)))
        return log
    if message.slot < log.slot:
        index = len(log.recent) - (log.slot - message.slot)
        if index < 0:
            return log
        if isinstance(message, Chosen) and message.value != log.recent[index]:
            out.refuse(sender.member, synod.contradiction(sender))
        if isinstance(message, Prepare | Propose):
            out.messages.append(OutgoingMessage(sender.member, Chosen(seat, message.slot, log.recent[index])))
        return log
    if isinstance(message, Propose | Chosen | Promise) and len(message.value) > MOST_COMMANDS:
        out.refuse(sender.member, Sentence("member {member} asked for what it may not ask for", sender.member))
        return log
    before = log.decision.promised
    after, sent, why = synod.receive(log.decision, message)
    out.messages.extend(sent)
    if why:
        out.refuse(sender.member, why)
    log = log._replace(decision=after)
    if after.promised > before and log.retry_at:
        log = log._replace(retry_at=now + _patience(charter, log))
    return _progress(charter, log, out)


def advance(charter: Charter, log: Log, now: int, out: StepOutput) -> Log:
    """Proposes what there is to decide: the first of the view at once, others when their patience has run out."""
    while True:
        state = log.decision
        begun = state.accepted != NO_BALLOT or state.ballot != NO_BALLOT
        waits = begun and log.retry_at and now < log.retry_at
        batch = () if waits else _batch(log)
        free = state.rank == 0 and state.promised == FIRST and state.ballot == NO_BALLOT
        if state.rank < 0 or not (batch or begun):
            return log._replace(retry_at=0) if log.retry_at else log
        if not (free and batch):
            if not log.retry_at:
                return log._replace(retry_at=now + _patience(charter, log))
            if now < log.retry_at:
                return log
        if any(isinstance(command.body, ViewChange) for command in batch):
            state = state._replace(fewest=())
        after, sent = synod.attempt(state, batch)
        out.messages.extend(sent)
        log = log._replace(decision=after, attempts=log.attempts + 1)
        log = _progress(charter, log._replace(retry_at=now + _patience(charter, log)), out)
        if log.slot == state.slot:
            return log


def _progress(charter: Charter, log: Log, out: StepOutput) -> Log:
    """Goes on to the next slot where this one is decided."""
    value = log.decision.chosen
    if value is None:
        return log
    tables, changes = apply_batch(log.tables, value)
    out.changes.extend(changes)
    out.changes.append(SlotDecision(log.slot))
    wary = WARY if log.attempts > 1 else max(0, log.wary - 1)
    return _open_slot(log._replace(tables=tables, recent=(*log.recent, value)[-MOST_RECENT:], wary=wary), log.slot + 1)


def _open_slot(log: Log, slot: int) -> Log:
    """The slot after what is known, without the commands that have taken effect."""
    life, count = log.tables.applied[log.decision.seat.member]
    seat = log.decision.seat
    pending = tuple(command for command in log.pending if seat.life > life or command.number > count)
    return log._replace(
        decision=Decision(seat, slot, log.tables.view.seats, fewest=_fewest(log)),
        pending=pending,
        requested=tuple(
            tuple(c for c in requested if c.seat.life > log.tables.applied[member].life or c.number > count_of)
            for member, (requested, (_, count_of)) in enumerate(zip(log.requested, log.tables.applied, strict=True))
        ),
        retry_at=0,
        attempts=0,
    )


def _fewest(log: Log) -> tuple[int, ...]:
    """The voters that are asked first in the next slot: those that voted for its own proposal in this one, a quorum.

    If a voter is missing or messages get lost, votes are requested of all.
    """
    last = log.decision
    same = last.voters == log.tables.view.seats
    return last.votes if same and not log.wary and is_quorum(last.votes, len(last.voters)) else ()


def _batch(log: Log) -> Batch:
    """Commands that can take effect next, of each seat in its order; whose come first changes from slot to slot."""
    if not log.pending and not any(log.requested):
        return ()
    seats = log.tables.view.seats
    batch: list[Command] = []
    first = log.slot % len(seats)
    for seat in (*seats[first:], *seats[:first]):
        own = log.pending if seat == log.decision.seat else log.requested[seat.member]
        if not own:
            continue
        count = log.tables.applied[seat.member].last
        for command in own:
            if command.seat == seat and command.number == count + 1 and len(batch) < MOST_COMMANDS:
                batch.append(command)
                count += 1
    return tuple(batch)


def _newest(commands: Batch) -> tuple[int, int]:
    """Life and number of the last command: late ones are recognised by it."""
    return commands[-1].seat.life, commands[-1].number


def _patience(charter: Charter, log: Log) -> int:
    """Ms to wait before the next attempt."""
    return charter.lease // 4 * (1 + max(0, log.decision.rank) + min(log.attempts, 8))


def _history_from(log: Log, slot: int) -> History | Snapshot:
    """What was decided from a slot on, or the tables where that is forgotten."""
    index = len(log.recent) - (log.slot - slot)
    if index < 0 or slot < 0:
        return Snapshot(log.decision.seat, log.slot, log.tables)
    return History(log.decision.seat, slot, log.recent[index:])


def _from_snapshot(charter: Charter, log: Log, message: Snapshot, out: StepOutput) -> Log:
    """The log with the tables of another member, if it knows more and they are tables of this team."""
    if message.slot <= log.slot:
        return log
    if not fits(charter, message.tables):
        out.refuse(message.sender.member, Sentence("member {member} is of another team", message.sender.member))
        return log
    out.changes.append(LogGap(message.slot))
    return _open_slot(log._replace(tables=message.tables, recent=()), message.slot)


def fits(charter: Charter, tables: Tables) -> bool:
    """Whether the tables have the shape of the charter's, and name only members that it has."""
    members = [seat.member for seat in tables.view.seats]
    return (
        len(tables.applied) == charter.members
        and all(0 <= member < charter.members for member in members)
        and 0 < len(members) == len(set(members))
    )
