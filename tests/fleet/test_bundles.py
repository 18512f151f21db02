"""Messages that travel in one envelope: each member gets what is for it, in order, and nothing else."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.fleet.bundles import FULL, SMALL, bundle, unbundle
from kitrobot.fleet.envelopes import EVERYBODY, EnvelopeError
from kitrobot.team.codec import decode
from kitrobot.team.commands import Seat
from kitrobot.team.messages import EVERYONE, Behind, Echo, Heartbeat, Message, OutgoingMessage

RUN, MEMBERS = 7, 5
SAID = [Behind(Seat(0, 0), slot) for slot in range(4)]
LARGE = Heartbeat(Seat(0, 0), 1, 0, 0, True, 0, (Echo(1, 2, 3),) * SMALL)
ADDRESSEES = st.sampled_from([EVERYONE, *range(MEMBERS)])
SENDINGS = st.lists(st.builds(OutgoingMessage, ADDRESSEES, st.sampled_from([*SAID, LARGE])), max_size=12)


def heard(envelopes: list[tuple[int, bytes]], me: int) -> list[Message]:
    bodies = [body for to, body in envelopes if to in (me, EVERYBODY)]
    return [decode(data, RUN) for body in bodies for data in unbundle(body, me)]


@given(SENDINGS)
def test_each_member_hears_what_is_for_it_and_nothing_else(sendings: list[OutgoingMessage]) -> None:
    envelopes = bundle(sendings, RUN)
    for me in range(MEMBERS):
        meant = [message for to, message in sendings if to in (me, EVERYONE)]
        assert sorted(map(str, heard(envelopes, me))) == sorted(map(str, meant))


@given(st.lists(st.builds(OutgoingMessage, ADDRESSEES, st.sampled_from(SAID)), max_size=12))
def test_small_messages_come_in_the_order_of_sending_in_one_envelope_for_each_member(
    sendings: list[OutgoingMessage],
) -> None:
    envelopes = bundle(sendings, RUN)
    for me in range(MEMBERS):
        assert heard(envelopes, me) == [message for to, message in sendings if to in (me, EVERYONE)]
        assert len([to for to, _ in envelopes if to in (me, EVERYBODY)]) <= 1


def test_what_is_large_and_for_one_goes_to_that_one_alone() -> None:
    envelopes = dict(
        bundle([OutgoingMessage(EVERYONE, SAID[0]), OutgoingMessage(3, LARGE), OutgoingMessage(2, SAID[1])], RUN)
    )
    assert set(envelopes) == {EVERYBODY, 3}
    assert len(envelopes[EVERYBODY]) < SMALL


def test_a_body_that_is_full_is_not_made_longer() -> None:
    sendings = [OutgoingMessage(EVERYONE, SAID[n % 4]) for n in range(FULL // 10)]
    envelopes = bundle(sendings, RUN)
    assert len(envelopes) > 1
    assert max(len(body) for _, body in envelopes) < FULL + SMALL
    assert heard(envelopes, 1) == [message for _, message in sendings]


@given(SENDINGS.filter(bool), st.data())
def test_a_body_that_is_cut_off_is_refused(sendings: list[OutgoingMessage], data: st.DataObject) -> None:
    _, body = data.draw(st.sampled_from(bundle(sendings, RUN)))
    ends = {0}
    while max(ends) < len(body):
        whole = next(at for at in range(max(ends) + 1, len(body) + 1) if is_read(body[:at]))
        ends.add(whole)
    cut = data.draw(st.integers(0, len(body)).filter(lambda at: at not in ends))
    assert not is_read(body[:cut])


def is_read(body: bytes) -> bool:
    try:
        unbundle(body, 0)
    except EnvelopeError:
        return False
    return True


@given(st.binary(max_size=64), st.integers(0, MEMBERS))
def test_any_bytes_are_read_or_refused_with_a_sentence(body: bytes, me: int) -> None:
    if is_read(body):
        unbundle(body, me)


def test_a_size_beyond_the_end_is_refused() -> None:
    with pytest.raises(EnvelopeError, match="no message of a fleet, or it is cut off"):
        unbundle(bytes([0, 0, 0xFF, 0xFF, 0xFF, 0x7F]) + b"{}", 0)
