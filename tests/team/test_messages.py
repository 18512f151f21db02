"""Messages as bytes, and members that are told what cannot be: hostile, merely mistaken, or far too much."""

from __future__ import annotations

import contextlib
import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.team.changes import Change, Refusal, VariableChange
from kitrobot.team.charter import Charter
from kitrobot.team.codec import MessageError, decode, encode
from kitrobot.team.commands import Batch, Body, Command, Note, Seat, ViewChange
from kitrobot.team.events import IncomingMessage, Time, Write
from kitrobot.team.member import BUDGET, step
from kitrobot.team.messages import Behind, Chosen, Echo, Entry, Heartbeat, Message, Request, Snapshot, Stamp, Writes
from kitrobot.team.shared_store import LAST_CLOCK
from kitrobot.team.state import Member, initial_state
from kitrobot.team.tables import initial_tables

_CHARTER = Charter(3, variables=2)
_ME, _OTHER = Seat(0, 0), Seat(1, 0)

_NUMBERS = st.integers(-5, 1 << 53)
_BODIES: st.SearchStrategy[Body] = st.one_of(
    st.builds(Note, st.lists(_NUMBERS, max_size=5).map(tuple)),
    st.builds(ViewChange, _NUMBERS, st.tuples(_NUMBERS), st.tuples(st.builds(Seat, _NUMBERS, _NUMBERS))),
)
_BATCHES: st.SearchStrategy[Batch] = st.lists(
    st.builds(Command, st.just(_OTHER), st.integers(1, 3), _BODIES), max_size=3
).map(tuple)


def _fresh() -> Member:
    return initial_state(_CHARTER, _ME, 0)


def _told(message: Message, state: Member | None = None) -> tuple[Member, list[str]]:
    """The state after a message and what was refused."""
    after, sent, changes = step(_CHARTER, state or _fresh(), 1, IncomingMessage(message))
    assert len(sent) <= 2
    return after, [change.why for change in changes if isinstance(change, Refusal)]


@given(_BATCHES, _NUMBERS)
def test_a_message_comes_back_from_its_bytes(batch: Batch, number: int) -> None:
    echoes = (Echo(1, 0, number),)
    for message in (
        Chosen(_OTHER, number, batch),
        Request(_OTHER, batch),
        Heartbeat(_OTHER, number, 0, 0, True, 0, echoes),
        Snapshot(_OTHER, 3, initial_tables(_CHARTER)),
        Writes(_OTHER, (Entry(1, Stamp(2, 1, 0), number),)),
    ):
        assert decode(encode(message, 7), 7) == message


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"", "this is no message of a team"),
        (b"[" * 100_000, "this is no message of a team"),
        (b"\xff\xfe", "this is no message of a team"),
        (b"[3,7]", "this is no message of a team"),
        (b'[3,7,["Fire",[0,0],1]]', "this is no message of a team"),
        (b'[3,7,["Behind",[0,0],1.5]]', "this is no message of a team"),
        (b'[3,7,["Behind",[0,0],true]]', "this is no message of a team"),
        (b'[3,7,["Behind",[0],1]]', "this is no message of a team"),
        (b'[3,7,["Behind",[0,0],1,2]]', "this is no message of a team"),
        (b'[3,7,["Behind",[0,0],' + b"9" * 5000 + b"]]", "this is no message of a team"),
        (b'[3,7,["Behind",[0,0],' + b"[" * 100_000, "this is no message of a team"),
        (b'[3,7,["Chosen",[0,0],1,[[[0,0],1,["Note"]]]]]', "this is no message of a team"),
        (b'[3,7,["Chosen",[0,0],1,[[[0,0],1,["Chosen",[0]]]]]]', "this is no message of a team"),
        (b'[3,7,["Behind",[0,0],%d]]' % ((1 << 53) + 1), "this is no message of a team"),
        (b'[2,7,"Behind",[0,0],1]', "a message of version 2, this is version 3"),
        (b'[3,8,["Behind",[0,0],1]]', "a message of another run"),
        (b" " * (1 << 18) + b"1", "a message of 262145 bytes is too large"),
    ],
)
def test_bytes_that_are_no_message_are_refused_with_a_sentence(data: bytes, said: str) -> None:
    with pytest.raises(MessageError) as refused:
        decode(data, 7)
    assert refused.value.args == (said,)


@given(st.integers(0, 200), st.integers(0, 255))
def test_damaged_and_cut_messages_are_refused_or_are_others(at: int, byte: int) -> None:
    data = bytearray(encode(Snapshot(_OTHER, 3, initial_tables(_CHARTER)), 7))
    for damaged in (bytes(data[:at]), bytes(data[:at]) + bytes([byte]) + bytes(data[at + 1 :])):
        try:
            message = decode(damaged, 7)
        except MessageError:
            continue
        _told(message)


@given(_BATCHES)
def test_whatever_is_decided_the_tables_stay_tables(batch: Batch) -> None:
    state, _ = _told(Chosen(_OTHER, 0, batch))
    assert state.log.slot == 1
    assert len(state.tables.applied) == 3
    assert state.tables.view.seats


@given(st.sampled_from([None, 1, -1, "x", [], {}, [[]], 1.5, True]), st.integers(0, 12))
def test_a_field_of_another_type_is_refused_or_read_as_what_it_is(value: object, place: int) -> None:
    plain = json.loads(encode(Heartbeat(_OTHER, 1, 0, 0, True, 0, ()), 7))
    plain[place % len(plain)] = value
    with contextlib.suppress(MessageError):
        _told(decode(json.dumps(plain).encode(), 7))


def test_a_view_that_the_log_has_not_decided_is_not_adopted() -> None:
    forged = Heartbeat(_OTHER, 1, 99, 500, True, 0, (Echo(0, 0, 0),))
    state, _ = _told(forged)
    assert state.tables == _fresh().tables
    _, sent, _ = step(_CHARTER, _fresh(), 1, IncomingMessage(forged))
    assert [one.message for one in sent] == [Behind(_ME, 0)]


def test_tables_of_another_team_are_refused() -> None:
    state, refused = _told(Snapshot(_OTHER, 9, initial_tables(Charter(2))))
    assert refused == ["member 1 is of another team"]
    assert state.log == _fresh().log


def test_two_decisions_of_one_slot_are_told_and_the_first_stays() -> None:
    state, _ = _told(Chosen(_OTHER, 0, (Command(_OTHER, 1, Note((1,))),)))
    after, refused = _told(Chosen(Seat(2, 0), 0, ()), state)
    assert refused == ["member 2 said two different things about one decision"]
    assert after.tables == state.tables
    assert after.refused == (0, 0, 1)


def test_who_asks_in_the_name_of_another_is_refused() -> None:
    state, refused = _told(Request(_OTHER, (Command(Seat(2, 0), 1, Note((1,))),)))
    assert refused == ["member 1 asked for what it may not ask for"]
    assert state.log == _fresh().log


@pytest.mark.parametrize("member", [-1, 0, 3, 1 << 53])
def test_a_sender_that_is_nobody_else_in_the_team_is_refused(member: int) -> None:
    state, refused = _told(Behind(Seat(member, 0), 0))
    assert refused == [f"a message of member {member}, which is nobody else in this team"]
    assert state.log == _fresh().log


def test_as_many_messages_as_fast_meetings_take_are_read_in_one_beat() -> None:
    state = _fresh()
    for number in range(700):
        state, _, _ = step(_CHARTER, state, 1, IncomingMessage(Heartbeat(_OTHER, 1, 0, number + 1, True, 0, ())))
    assert state.refused[1] == 0


def test_thousands_of_messages_in_one_beat_leave_state_and_answers_bounded() -> None:
    refused: list[Change] = []
    state, sent = _fresh(), 0
    for number in range(3_000):
        state, messages, changes = step(
            _CHARTER, state, 1, IncomingMessage(Heartbeat(_OTHER, 1, 0, number + 1, True, 0, ()))
        )
        sent += len(messages)
        refused += changes
    assert sent <= BUDGET
    assert [change.why for change in refused if isinstance(change, Refusal)] == [
        "member 1 sends too much; the rest is left unread"
    ]
    assert state.refused[1] == 3_000 - BUDGET
    # The next beat has a budget of its own.
    state, _, _ = step(_CHARTER, state, 500, Time())
    _, messages, _ = step(_CHARTER, state, 501, IncomingMessage(Heartbeat(_OTHER, 1, 0, 7, True, 0, ())))
    assert len(messages) == 1


@pytest.mark.parametrize("entry", [Entry(0, Stamp(LAST_CLOCK, 1, 0), 5), Entry(2, Stamp(1, 1, 0), 5)])
def test_a_write_from_the_far_future_or_to_no_variable_is_refused(entry: Entry) -> None:
    state, refused = _told(Writes(_OTHER, (entry,)))
    assert refused == ["member 1 wrote a shared variable in a way that cannot be"]
    assert state.store == _fresh().store


def test_the_latest_write_wins_in_whatever_order_it_comes() -> None:
    early, late = Entry(0, Stamp(1, 1, 0), 5), Entry(0, Stamp(1, 2, 0), 4)
    for order in ((early, late), (late, early), (early, late, early)):
        state = _fresh()
        for entry in order:
            state, _ = _told(Writes(_OTHER, (entry,)), state)
        assert state.store.entries[0] == late
    state, _, changes = step(_CHARTER, state, 2, Write(0, 9))
    assert changes == (VariableChange(0, 9),)
    assert state.store.entries[0] == Entry(0, Stamp(2, 0, 0), 9)


def test_a_program_that_names_a_variable_that_is_not_there_is_refused() -> None:
    state, sent, changes = step(_CHARTER, _fresh(), 0, Write(2, 0))
    assert changes == (Refusal(0, "there is no shared variable 2"),)  # type: ignore[arg-type]
    assert (state.log, state.store, sent) == (_fresh().log, _fresh().store, ())


def test_commands_that_are_not_decided_are_bounded() -> None:
    state, refused = _fresh(), 0
    state = initial_state(_CHARTER, _OTHER, 0)
    for number in range(100):
        state, _, changes = step(_CHARTER, state, 0, Note((number,)))
        refused += sum(isinstance(change, Refusal) for change in changes)
    assert (len(state.log.pending), refused) == (16, 84)
