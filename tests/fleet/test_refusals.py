"""What is refused is told once of each sender and reason, then counted: no flood fills a log."""

from __future__ import annotations

import random
import struct

import pytest

from kitrobot.fleet.envelopes import Envelope, VersionError, seal, unseal
from kitrobot.fleet.refusals import MOST_KINDS, NOBODY, Refusals
from kitrobot.fleet.transport import MOST_REASONS
from kitrobot.text.sentences import Sentence
from tests.fleet.bus import KEY, Bus
from tests.fleet.test_agent_arrival import turns

HELLO_OF_VERSION_3 = struct.pack("<2sBBQHHQ", b"KF", 3, 3, 0, 2, 0xFFFF, 1) + b'["robot-3", "abc"]' + bytes(16)


def test_the_first_is_told_then_the_count_when_it_has_another_digit() -> None:
    refusals = Refusals()
    why = [Sentence("a message of {size} bytes is too large", size) for size in range(1, 2001)]
    told = [line for one in why if (line := refusals.count(1, one)) is not None]
    assert told == [
        "refused: a message of 1 bytes is too large",
        *(
            f"refused {count} messages, the last one because: a message of {count} bytes is too large"
            for count in (10, 100, 1000)
        ),
    ]
    assert refusals.count(2, why[0]) == "refused: a message of 1 bytes is too large"
    assert refusals.count(3, why[0], 250) is not None


def test_what_is_remembered_of_refusals_is_bounded() -> None:
    refusals = Refusals()
    told = [refusals.count(sender, Sentence("a message for somebody else")) for sender in range(100_000)]
    assert sum(line is not None for line in told) <= MOST_KINDS + 6
    assert len(refusals._counts) <= MOST_KINDS + 1
    assert refusals.count(NOBODY, Sentence("another")) is None


def test_thousands_of_wrong_bytes_without_a_key_are_a_few_lines(bus: Bus) -> None:
    team = bus.team()
    chance = random.Random(1)
    for _ in range(20):
        for _ in range(1000):
            data = bytearray(seal(Envelope(3, 0, chance.randrange(65536), 0xFFFF, 1, b"x" * 20), bytes(32)))
            data[2] = chance.randrange(256)
            bus.put(None, "kitrobot/here/t", bytes(data[: chance.randrange(len(data) + 1)]))
        team.channel.receive(0)
    assert 1 < len(team.channel.refused) < 2 * MOST_REASONS


def test_an_agent_of_another_version_is_told_of_and_hears_something_that_it_can_say(bus: Bus) -> None:
    with pytest.raises(VersionError) as raised:
        unseal(HELLO_OF_VERSION_3, KEY)
    assert raised.value.args[1] == 2
    team = bus.team()
    bus.put(None, "kitrobot/here/t", HELLO_OF_VERSION_3)
    bus.meanwhile(lambda: turns(5))
    team.gather(None)
    assert "refused: a message of version 3, this is version 5" in bus.said
    answers = [data for name, data in bus.recorded if name == "kitrobot/here/m/2"]
    assert answers
    assert answers[0][:3] == b"KF\x05", "an older agent says: a message of version 5"
