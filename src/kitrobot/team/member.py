"""`Member`: the whole of one member of a team, as a pure state machine: time and an event in, messages and changes out.

`step` has no clock, no socket, no thread and no randomness of its own; the same events give the same bytes. A host
brings what it received, the time in ms at least every `Charter.beat` (`Time`), and what its robot's program does; it
sends the messages and acts on the changes. What it must ask before a robot acts is `may_act`.

What a message can do is bounded: it has at most two answers, each member has a budget of messages for each beat, and
all rows of the state are as long as the charter or a constant. Crashes, pauses, lost, doubled, late and reordered
messages are tolerated; lies of members that hold the team's key are not, but are reported where they are seen
(`Refusal`).

What differs from a usual replicated state machine, and why: docs/team-protocol.md.
"""

from __future__ import annotations

from kitrobot.team import log as logs
from kitrobot.team import membership, shared_store
from kitrobot.team.changes import NewView, QuorumChange, VariableChange
from kitrobot.team.charter import Charter
from kitrobot.team.commands import Body, ViewChange
from kitrobot.team.events import Event, IncomingMessage, Leave, Time, Write
from kitrobot.team.log import StepOutput
from kitrobot.team.messages import EVERYONE, Behind, Compare, Heartbeat, Message, OutgoingMessage, Writes
from kitrobot.team.state import Member, StepResult
from kitrobot.text.sentences import Sentence

BUDGET = 768
"""Messages of one member in one beat; the rest is refused unread. Meetings as fast as they go take 300 of them."""


def step(charter: Charter, state: Member, now: int, event: Event) -> StepResult:
    """The member after an event at a time; a time before the last one counts as that."""
    out = StepOutput()
    now = max(now, state.now)
    before = state
    state = _record_right(charter, state, now)
    if isinstance(event, IncomingMessage):
        state = _receive(charter, state, now, event.message, out)
    elif isinstance(event, Write):
        state = _write(charter, state, event, out)
    elif isinstance(event, Leave):
        state = state._replace(leaving=True)
    elif isinstance(event, Time):
        state = _time(charter, state, now, out)
    else:
        state = _submit(state, event, out)
    if not (isinstance(event, IncomingMessage) and event.more):
        state = state._replace(log=logs.advance(charter, state.log, now, out))
    if state.log.tables != before.log.tables:
        state = _follow_view(charter, before, state, now, out)
    return StepResult(state, tuple(out.messages), tuple(out.changes))


def _record_right(charter: Charter, state: Member, now: int) -> Member:
    """Records the right lent so far; one that was stopped itself gives the others a new lease to be heard."""
    firm = logs.is_firm(state.log)
    right = membership.lent_until(state.membership, charter, state.tables.view, state.seat, now, firm)
    since = now if now - state.now >= charter.lease // 2 else state.membership.since
    known = state.membership
    if (right, since) != (known.right, known.since):
        known = known._replace(right=right, since=since)
    return state._replace(now=now, membership=known)


def _receive(charter: Charter, state: Member, now: int, message: Message, out: StepOutput) -> Member:
    """Takes in a message, if its sender is another member and has not used up its budget."""
    member = message.sender.member
    if not 0 <= member < charter.members or member == state.seat.member:
        out.refuse(member, Sentence("a message of member {member}, which is nobody else in this team", member))
        return state
    spent = state.spent[member] + 1
    if spent > BUDGET:
        if spent == BUDGET + 1:
            out.refuse(member, Sentence("member {member} sends too much; the rest is left unread", member))
            state = state._replace(spent=_with(state.spent, member, spent))
        return state._replace(refused=_with(state.refused, member, state.refused[member] + 1))
    state = state._replace(spent=_with(state.spent, member, spent))
    reported = len(out.changes)
    if isinstance(message, Heartbeat):
        state = _receive_heartbeat(state, now, message, out)
    elif isinstance(message, Compare):
        if entries := shared_store.later_entries(state.store, message.stamps):
            out.messages.append(OutgoingMessage(member, Writes(state.seat, entries)))
    elif isinstance(message, Writes):
        store, news, refused = shared_store.merge(state.store, message.entries)
        out.changes.extend(VariableChange(entry.variable, entry.value) for entry in news)
        if refused:
            out.refuse(member, Sentence("member {member} wrote a shared variable in a way that cannot be", member))
        state = state._replace(store=store)
    else:
        state = state._replace(log=logs.receive(charter, state.log, message, now, out))
    if any(getattr(change, "why", None) for change in out.changes[reported:]):
        state = state._replace(refused=_with(state.refused, member, state.refused[member] + 1))
    return state


def _receive_heartbeat(state: Member, now: int, message: Heartbeat, out: StepOutput) -> Member:
    """Takes in a heartbeat, and asks for what it shows to be missing."""
    member = message.sender.member
    known = membership.hear(state.membership, state.tables.view, state.seat, message, now)
    if message.slot > state.log.slot:
        out.messages.append(OutgoingMessage(member, Behind(state.seat, state.log.slot)))
    elif message.digest != shared_store.digest(state.store):
        out.messages.append(OutgoingMessage(member, Compare(state.seat, state.store.stamps)))
    return state._replace(membership=known)


def _write(charter: Charter, state: Member, event: Write, out: StepOutput) -> Member:
    if not 0 <= event.variable < charter.variables:
        out.refuse(state.seat.member, Sentence("there is no shared variable {number}", event.variable))
        return state
    store, entry = shared_store.write(state.store, state.seat, event.variable, event.value)
    out.messages.append(OutgoingMessage(EVERYONE, Writes(state.seat, (entry,))))
    out.changes.append(VariableChange(entry.variable, entry.value))
    return state._replace(store=store)


def _submit(state: Member, body: Body, out: StepOutput) -> Member:
    """Submits a command to the log."""
    log = logs.add_command(state.log, body)
    if log is None:
        out.refuse(state.seat.member, Sentence("too many commands wait to be decided; wait for some of them"))
        return state
    first = state.tables.view.seats[0]
    if first != state.seat and log != state.log:
        out.messages.append(logs.request(log, first.member))
    return state._replace(log=log)


def _time(charter: Charter, state: Member, now: int, out: StepOutput) -> Member:
    """What is due: the heartbeat, commands sent again, the next view."""
    known, view = state.membership, state.tables.view
    heard = membership.hears_quorum(known, charter, view, state.seat, now)
    if heard != known.heard:
        out.changes.append(QuorumChange(heard))
        known = known._replace(heard=heard, since=now)
        state = state._replace(membership=known)
    if now < known.beat_at:
        return state
    if state.leaving and state.seat not in view.seats:
        return state
    beat = Heartbeat(
        sender=state.seat,
        stamp=now,
        view=view.number,
        slot=state.log.slot,
        firm=logs.is_firm(state.log),
        digest=shared_store.digest(state.store),
        echoes=(),
    )
    out.messages.append(OutgoingMessage(EVERYONE, membership.heartbeat(known, charter, now, beat)))
    if state.log.pending and state.seat != view.seats[0]:
        out.messages.append(logs.request(state.log, EVERYONE))
    state = state._replace(
        membership=known._replace(beat_at=now + charter.beat),
        spent=(0,) * charter.members,
    )
    if state.leaving and len(view.seats) > 1:
        return _submit(state, ViewChange(view.number, (state.seat.member,), ()), out)
    change = membership.change_wanted(known, charter, view, state.seat, now)
    if change and not any(isinstance(command.body, ViewChange) for command in state.log.pending):
        state = _submit(state, change, out)
    return state


def _follow_view(charter: Charter, before: Member, state: Member, now: int, out: StepOutput) -> Member:
    """What a member draws from new tables: whether it is in the view.

    Its place is new, and held off, also if it may have been another's in a view that was passed over.
    """
    view, was = state.tables.view, before.tables.view
    if not state.log.recent and before.log.slot != state.log.slot:
        out.changes.append(NewView(view))
    if view == was:
        return state
    stayed = view.number <= was.number + 1 and state.seat in was.seats
    if state.seat in view.seats and not stayed:
        state = state._replace(acts_from=now + charter.hold)
    return state._replace(membership=membership.in_new_view(state.membership, now))


def _with(row: tuple[int, ...], index: int, value: int) -> tuple[int, ...]:
    return (*row[:index], value, *row[index + 1 :])
