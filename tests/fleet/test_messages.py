"""Bytes that come from elsewhere: cut off, too large, of another version, key or run, forged, of wrong types."""

from __future__ import annotations

import contextlib
import json
from pathlib import Path

import orjson
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.fleet import envelopes
from kitrobot.fleet.body_messages import (
    Frame,
    FrameError,
    ReplicaSnapshot,
    Reply,
    decode_record,
    encode_record,
)
from kitrobot.fleet.charter import FleetError
from kitrobot.fleet.envelopes import Envelope, EnvelopeError, seal, unseal
from kitrobot.fleet.keys import VARIABLE, find_key, key_of, new_key
from kitrobot.fleet.replica import Replica
from kitrobot.sim.host_step import TickResult, fits
from kitrobot.team.changes import AppliedNote, NewView
from kitrobot.team.commands import Seat
from kitrobot.team.messages import Heartbeat
from kitrobot.team.records import Record
from kitrobot.team.tables import View
from tests.fleet.network import LEASE
from tests.fleet.test_convoy import anew, fleet, until

KEY, OTHER = key_of("a key of sixteen letters", "here"), key_of("another key of as many", "here")
ENVELOPE = Envelope(envelopes.MEMBER, 77, 1, 2, 3, b"body", 9)
FRAME = Frame(5, 3, True, False, (1, 0, -4))
REPLY = Reply(
    5,
    2,
    True,
    False,
    TickResult((1, 2), (3, 0), ((0, 1, 2, 3),)),
    ((0, 9),),
    4,
    ((AppliedNote(Seat(1, 0), (0, 0, 3, 1, 9)), NewView(View(2, (Seat(0, 0), Seat(1, 1))))), ()),
    ReplicaSnapshot(6, ((1, 2), ())),
)


def why(data: bytes, key: bytes = KEY) -> str:
    with pytest.raises(EnvelopeError) as raised:
        unseal(data, key)
    return str(raised.value.args[0])


def test_an_envelope_is_read_as_it_was_written() -> None:
    assert unseal(seal(ENVELOPE, KEY), KEY) == ENVELOPE


def test_a_foreign_key_is_told_and_refused() -> None:
    assert "another key" in why(seal(ENVELOPE, OTHER))


@given(st.integers(0, 53), st.integers(1, 255))
def test_no_byte_of_an_envelope_can_be_changed(at: int, change: int) -> None:
    data = bytearray(seal(ENVELOPE, KEY))
    data[at % len(data)] ^= change
    why(bytes(data))


def test_another_version_is_told_although_its_seal_may_be_another() -> None:
    data = bytearray(seal(ENVELOPE, KEY))
    data[2] = 9
    assert why(bytes(data)) == "a message of version 9, this is version 5"


@pytest.mark.parametrize("length", [0, 1, 10, 29, 41, 50])
def test_an_envelope_that_is_cut_off_is_refused(length: int) -> None:
    said = why(seal(ENVELOPE, KEY)[:length])
    assert "cut off" in said or (length == 50 and "another key" in said)


def test_an_envelope_that_is_too_large_is_refused() -> None:
    assert "too large" in why(b"KF" + bytes(envelopes.MOST_BYTES))


def test_frames_answers_and_replicas_are_read_as_they_were_written() -> None:
    records: list[Record] = [FRAME, REPLY, ReplicaSnapshot(3, ((1,), (2, 3)))]
    for record in records:
        assert decode_record(encode_record(record), type(record)) == record


@given(
    st.binary(max_size=60)
    | st.recursive(st.none() | st.integers() | st.text(), st.lists).map(json.dumps).map(str.encode)
)
def test_whatever_comes_instead_is_refused_with_a_sentence(data: bytes) -> None:
    for kind in (Frame, Reply, ReplicaSnapshot):
        with contextlib.suppress(FrameError):
            decode_record(data, kind)


@given(st.data())
def test_an_answer_with_something_else_in_it_is_refused(data: st.DataObject) -> None:
    rows = orjson.loads(encode_record(REPLY))
    at = data.draw(st.sampled_from([0, 1, 2, 3, 4, 5, 6, 7, 8]))
    rows[at] = data.draw(st.sampled_from(["x", 1.5, {"a": 1}, [["x"]], 1 << 60, True]))
    if not (at in (2, 3) and rows[at] is True):
        with pytest.raises(FrameError):
            decode_record(orjson.dumps(rows), Reply)


def test_what_cannot_be_of_a_machine_is_told_and_moves_nothing() -> None:
    one = fleet()
    until(one, 1000)
    world = one.world
    link = world.links[0]
    for ticked in (TickResult((1,), (0, 0)), TickResult((), ()), TickResult((0,) * 400, (9999, 0))):
        assert not fits(one.run, 0, ticked)
        link.waiting, link.ticked, link.sent = {link.serial: FRAME}, [], {link.serial: one.now}
        world.answer(one.now, 0, Reply(link.serial, world.replica.epochs[0], ticked=ticked))
        assert link.ticked == []
    assert "cannot be of its machine" in world.log[-1]


def test_an_answer_of_an_agent_that_was_missed_since_moves_nothing() -> None:
    one = fleet()
    until(one, 1000)
    world = one.world
    link = world.links[0]
    machine = one.run.members[0].machine
    ticked = TickResult(
        tuple(machine.cells[: machine.layout.cells]), tuple(machine.threads[: 2 * len(machine.image.slots)])
    )
    for late, taken in ((1, []), (0, [(link.serial, ticked)])):
        link.waiting, link.ticked, link.sent = {link.serial: FRAME}, [], {link.serial: one.now}
        world.answer(one.now, 0, Reply(link.serial, world.replica.epochs[0] - late, ticked=ticked))
        assert link.ticked == taken


def test_answers_are_taken_in_the_order_of_frames_and_once() -> None:
    one = fleet()
    until(one, 1000)
    world = one.world
    link = world.links[0]
    machine = one.run.members[0].machine
    cells, threads = (
        tuple(machine.cells[: machine.layout.cells]),
        tuple(machine.threads[: 2 * len(machine.image.slots)]),
    )
    epoch, last = world.replica.epochs[0], link.serial
    link.waiting, link.ticked = {last + 1: FRAME, last + 2: FRAME}, []
    link.sent = {last + 1: one.now, last + 2: one.now}
    replies = [Reply(last + n, epoch, ticked=TickResult((n, *cells[1:]), threads)) for n in (1, 2)]
    world.answer(one.now, 0, replies[1])
    assert link.ticked == []
    for reply in (replies[0], replies[0], replies[1]):
        world.answer(one.now, 0, reply)
    assert [ticked.cells[0] for _, ticked in link.ticked] == [1, 2]


def test_frames_are_ticked_in_their_order_and_once() -> None:
    host = fleet().hosts[0]
    inputs = (0,) * host.machine.layout.inputs
    frames = [Frame(n, 0, False, True, inputs) for n in (1, 2, 3)]
    assert [reply.serial for reply in host.frame(0, frames[0])] == [1]
    assert host.frame(0, frames[2]) == []
    assert [reply.serial for reply in host.frame(0, frames[1])] == [2, 3]
    again = host.frame(0, frames[2])
    assert [reply.serial for reply in again] == [3]
    assert host.frame(0, Frame(90, 0, False, True, inputs)) == []


@pytest.mark.parametrize("rows", [(), ((1,),), "cut", "long"])
def test_a_replica_of_another_team_changes_nothing(rows: object) -> None:
    mine = Replica(anew())
    packed = mine.packed()
    if rows == "cut":
        rows = packed[:-1]
    elif rows == "long":
        rows = [*packed[:-1], [*packed[-1], 1]]
    assert not mine.unpack(9, rows)  # type: ignore[arg-type]
    assert mine.packed() == packed
    assert mine.slot == 0


@given(st.lists(st.lists(st.integers(-(1 << 60), 1 << 60), max_size=6), max_size=6), st.integers(-3, 70000))
def test_no_note_breaks_a_replica(notes: list[list[int]], member: int) -> None:
    mine = Replica(anew())
    for slot, numbers in enumerate(notes):
        mine.apply(
            slot, [AppliedNote(Seat(member, 0), tuple(numbers)), AppliedNote(Seat(member % 4, 0), tuple(numbers))]
        )
    mine.apply(len(notes), [NewView(View(1, (Seat(member, 0), Seat(0, 0))))])


def test_the_key_of_a_team_is_a_long_text_in_a_file_or_in_the_environment(tmp_path: Path) -> None:
    file = tmp_path / "key"
    file.write_text(new_key() + "\n")
    assert find_key(file, {}) == key_of(file.read_text(), "here")
    assert find_key(None, {VARIABLE: file.read_text()}) == find_key(file, {})
    assert find_key(None, {}) is None
    file.write_text("short")
    with pytest.raises(FleetError, match="16 to 4096 letters"):
        find_key(file, {})
    with pytest.raises(FleetError, match="cannot be read"):
        find_key(tmp_path / "nowhere", {})
    file.write_bytes(b"\xff" * 40)
    with pytest.raises(FleetError, match="cannot be read"):
        find_key(file, {})


def test_ten_thousand_messages_of_one_member_are_bounded_and_change_nothing() -> None:
    one = fleet()
    until(one, 1000)
    host = one.hosts[0]
    for n in range(10_000):
        host.receive(one.now, Heartbeat(Seat(1, 0), n, 0, 0, True, 0, ()))
    assert host.state.refused[1] > 9000
    assert sum("sends too much" in str(line) for line in host.log) == 1
    assert len(host.log) < 20
    until(one, 1000 + 2 * LEASE)
    assert host.may_act(one.now)
