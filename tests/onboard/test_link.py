"""The frames of the link: the same vectors for both ends, and what a robot does with noise."""

from __future__ import annotations

import json
import random
import struct
from itertools import pairwise
from pathlib import Path

import pytest

from kitrobot_onboard.link import LONGEST, checksum, unwrap, wrap
from kitrobot_onboard.state import LATE, NEWS, REST
from tests.onboard.bench import Bench
from tests.onboard.test_watchdog import file

VECTORS = json.loads((Path(__file__).parent / "link-vectors.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("vector", VECTORS["whole"], ids=lambda vector: vector["means"])
def test_a_message_and_its_frame(vector: dict[str, str | int]) -> None:
    payload = bytes.fromhex(str(vector["payload"]))
    frame = bytes.fromhex(str(vector["frame"]))
    assert wrap(str(vector["type"]), int(vector["number"]), payload) == frame
    assert unwrap(frame[1:-1]) == (vector["type"], vector["number"], payload)


@pytest.mark.parametrize("vector", VECTORS["damaged"], ids=lambda vector: vector["means"])
def test_what_is_damaged_is_no_message(vector: dict[str, str]) -> None:
    frame = bytes.fromhex(vector["frame"])
    assert all(unwrap(part) is None for part in frame.split(b"~"))


def test_there_is_a_vector_for_every_type() -> None:
    assert {vector["type"] for vector in VECTORS["whole"]} == set("hsxnfvwpilq" + "KNHCTF")


def test_no_byte_that_means_something_to_a_line_stands_in_a_frame() -> None:
    rng = random.Random("frames")
    for _ in range(500):
        payload = rng.randbytes(rng.randrange(30))
        frame = wrap(rng.choice("hsxnfvwpilqKNHCTF"), rng.randrange(256), payload)
        assert not set(frame[1:-1]) & set(b"~\x03\x11\x13")


def test_any_flipped_bit_is_noticed() -> None:
    rng = random.Random("flips")
    for _ in range(300):
        frame = bytearray(wrap("n", rng.randrange(1, 256), rng.randbytes(10))[1:-1])
        frame[rng.randrange(len(frame))] ^= 1 << rng.randrange(8)
        assert all(unwrap(part) is None for part in bytes(frame).split(b"~"))


def test_the_sum_is_fletchers() -> None:
    assert checksum(b"abcde") == 0xC8F0
    assert checksum(b"\xff" * 60) == 0


def noise(rng: random.Random) -> bytes:
    """Bytes that might come over a bad line, without what asks for the prompt."""
    good = wrap(rng.choice("hpnfvwxlz"), rng.randrange(1, 256), rng.randbytes(rng.randrange(12)))
    made = rng.choice(
        (
            rng.randbytes(rng.randrange(80)),
            good[: rng.randrange(len(good))],
            good[rng.randrange(len(good)) :],
            b"~" * rng.randrange(9),
            b"~" + rng.randbytes(rng.choice((70, 500, 3000))),
            wrap("n", 9, bytes(rng.randrange(LONGEST, 200))),
        )
    )
    return made.replace(b"\x03", b"")


def test_after_any_noise_the_next_good_frame_is_answered_and_little_is_kept(tmp_path: Path) -> None:
    rng = random.Random("noise")
    with Bench(tmp_path, file()) as bench:
        for _ in range(300):
            bench.send(noise(rng))
            # A frame that was begun swallows the "~" of the next one: hosts ask again, and so does this one.
            bench.number = bench.number % 255 + 1
            request = wrap("h", bench.number, b"\1")
            answers = [kind for kind, number, _ in bench.send(request + request) if number == bench.number]
            assert answers
            assert set(answers) == {"H"}
            assert len(bench.robot[REST]) <= 2 * LONGEST


def test_what_was_heard_twice_is_done_once(tmp_path: Path) -> None:
    with Bench(tmp_path, file()) as bench:
        bench.ask("x")
        step = wrap("n", 77, b"")
        first, second = bench.send(step + step)
        assert first == second
        assert struct.unpack_from("<I", first[2]) == (1,)


def test_news_are_told_as_often_as_asked_and_only_what_changed(tmp_path: Path) -> None:
    with Bench(tmp_path, file()) as bench:
        assert bench.ask("w", struct.pack("<H", 100)) == ("K", b"")
        news = [data for kind, _, data in bench.wait(2000) if kind == "T"]
        assert 2 <= len(news) <= 20
        assert all(len(data) <= LONGEST for data in news)
        seen = [data[at : at + 1] for data in news for at in records(data)]
        assert {b"c", b"t", b"r", b"s"} == set(seen)
        assert bench.ask("w", struct.pack("<H", 0)) == ("K", b"")
        assert bench.wait(1000) == []


def test_who_watches_is_told_how_it_goes_though_nothing_changes(tmp_path: Path) -> None:
    with Bench(tmp_path, file(text="WAIT(9000);")) as bench:
        assert bench.ask("w", struct.pack("<H", 100)) == ("K", b"")
        bench.wait(300)
        bench.robot[LATE] = 70_000
        news = [data for kind, _, data in bench.wait(2000) if kind == "T"]
        assert 15 <= len(news) <= 20
        assert {data[4:] for data in news} == {b"s" + struct.pack("<BH", 2, 65535)}
        assert all(later > earlier for earlier, later in pairwise(data[:4] for data in news)), "the ticks go on"
        assert bench.ask("x") == ("K", b"")
        assert bench.wait(2000) == []


SIZES = {ord("c"): 6, ord("t"): 4, ord("r"): 3, ord("s"): 4}
"""Bytes of each kind of record in a T."""


def all_told(bench: Bench) -> dict[bytes, bytes]:
    """What was told last of each cell and each slot until nothing new comes."""
    news = [data for kind, _, data in bench.wait(2000) if kind == "T"]
    pieces = [data[at : at + SIZES[data[at]]] for data in news for at in records(data)]
    return {piece[:2]: piece[2:] for piece in pieces if piece[:1] in (b"c", b"t")}


def test_what_is_started_tells_everything_anew_and_nothing_of_the_run_before(tmp_path: Path) -> None:
    with Bench(tmp_path, file(text="WAIT(9000);")) as bench:
        assert bench.ask("w", struct.pack("<H", 100)) == ("K", b"")
        everything = all_told(bench)
        assert b"t\0" in everything
        assert all_told(bench) == {}
        bench.robot[NEWS] = b"c\1" + struct.pack("<i", 502)
        assert bench.ask("s", b"\0") == ("K", b"")
        assert all_told(bench) == everything


def records(data: bytes) -> list[int]:
    """Where each record of a T begins."""
    at = 4
    found = []
    while at < len(data):
        found.append(at)
        at += SIZES[data[at]]
    assert at == len(data)
    return found
