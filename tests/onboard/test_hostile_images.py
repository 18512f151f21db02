"""Random bytes and damaged images are refused with a sentence, or run for 200 ticks without a crash or a hang."""

from __future__ import annotations

import os
import random
import signal
import struct
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import SupportsIndex

import pytest

from kitrobot.image.machine import Machine
from kitrobot.image.model import LARGEST_VALUE, Image, ImageError
from kitrobot.image.verification import most_instructions_a_tick, verify
from kitrobot_onboard.image import header, load, whole_arrays
from kitrobot_onboard.interpreter import tick
from tests.oracle.agreement import machine_for, random_case

BUDGET = int(os.environ.get("KITROBOT_BUDGET", "50"))
HEADER_SIZE = 46
CRC_SIZE = 4


class Guarded(list[int]):
    """A list that refuses the negative indices which Python would take and which leave an array under Numba."""

    def __getitem__(self, index: SupportsIndex | slice) -> int:  # type: ignore[override]
        if not isinstance(index, slice) and index.__index__() < 0:
            raise IndexError(f"index {index}")
        return super().__getitem__(index)  # type: ignore[return-value]

    def __setitem__(self, index: SupportsIndex | slice, value: int) -> None:  # type: ignore[override]
        if not isinstance(index, slice) and index.__index__() < 0:
            raise IndexError(f"index {index}")
        super().__setitem__(index, value)  # type: ignore[index]


@contextmanager
def no_longer_than(seconds: float) -> Iterator[None]:
    """A hang becomes an error: so much time of the processor, whatever else it does. Where the system has no such
    alarm, the test's own time limit does it.
    """
    if not hasattr(signal, "setitimer"):
        yield
        return

    def ring(*_: object) -> None:
        raise TimeoutError(f"still running after {seconds} s")

    before = signal.signal(signal.SIGPROF, ring)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def with_checksum(body: bytes) -> bytes:
    return body + struct.pack("<I", zlib.crc32(body))


def refused(data: bytes) -> bool:
    """Whether an image is refused, with a sentence; otherwise it has been run for 200 ticks."""
    sentence = ""
    try:
        image = Image.from_bytes(data)
        verify(image)
    except ImageError as error:
        sentence = str(error)
    if sentence:
        assert len(sentence) > 20
        return True
    assert image.to_bytes() == data
    code, cells, threads, pars, out = whole_arrays(data, header(data))
    rng = random.Random(len(data))
    most = most_instructions_a_tick(image)
    numbers = Guarded(cells)
    code_cells, slots, tables, commands = Guarded(code), Guarded(threads), Guarded(pars), Guarded(out)
    with no_longer_than(20):
        for _ in range(200):
            for cell in range(1, 1 + image.inputs):
                numbers[cell] = rng.choice((0, 1, rng.randint(-LARGEST_VALUE, LARGEST_VALUE)))
            seen = Guarded([0] * image.instructions)
            tick(code_cells, numbers, slots, tables, commands, seen)
            assert sum(seen) <= most
            assert all(abs(value) <= LARGEST_VALUE for value in numbers)
    return False


def images(name: str, count: int) -> Iterator[tuple[random.Random, bytes]]:
    """Images of random programs."""
    for seed in range(count):
        rng = random.Random(f"{name}/{seed}")
        machine = machine_for(random_case(rng))
        if machine is not None:
            yield rng, machine.image.to_bytes()


def test_every_image_of_the_compiler_is_accepted() -> None:
    for _, data in images("whole", BUDGET // 2):
        assert not refused(data)


def test_random_bytes_are_refused() -> None:
    for seed in range(BUDGET):
        data = random.Random(seed).randbytes(seed % 300)
        assert refused(data)
        assert refused(with_checksum(b"KRI\0" + data))
        with pytest.raises(ValueError, match=r"image"):
            load(data)


def test_a_random_body_behind_a_good_header_is_refused_or_harmless() -> None:
    for rng, data in images("body", BUDGET):
        body = data[HEADER_SIZE:-CRC_SIZE]
        refused(with_checksum(data[:HEADER_SIZE] + rng.randbytes(len(body))))
        refused(with_checksum(data[: -4 * 6 - CRC_SIZE] + rng.randbytes(4 * 6)))


def test_any_flipped_bit_is_refused_without_a_new_checksum() -> None:
    for rng, data in images("flip", BUDGET // 4):
        for _ in range(10):
            assert refused(flipped(rng, data, 1))
            with pytest.raises(ValueError, match=r"image"):
                load(flipped(rng, data, 1))


def test_every_cut_image_is_refused() -> None:
    for rng, data in images("cut", BUDGET // 8):
        for end in {0, 1, HEADER_SIZE, len(data) - 1, *(rng.randrange(len(data)) for _ in range(10))}:
            assert refused(data[:end])
            if end != len(data) - CRC_SIZE:
                assert refused(with_checksum(data[:end]))
            with pytest.raises(ValueError, match=r"image"):
                load(data[:end])
        assert refused(data + b"\0")


def test_flipped_bits_with_a_right_checksum_are_refused_or_harmless() -> None:
    outcomes = []
    for rng, data in images("bits", BUDGET):
        for _ in range(10):
            outcomes.append(refused(with_checksum(flipped(rng, data[:-CRC_SIZE], rng.choice((1, 1, 2, 8))))))
    # Both must happen, else this test looks at nothing.
    assert {True, False} == set(outcomes)


def test_changed_instructions_with_a_right_checksum_are_refused_or_harmless() -> None:
    outcomes = []
    for rng, data in images("code", BUDGET):
        count = Image.from_bytes(data).instructions
        start = len(data) - CRC_SIZE - 4 * count
        for _ in range(10):
            mutated = bytearray(data[:-CRC_SIZE])
            for _ in range(rng.choice((1, 1, 2, 4))):
                at = start + 4 * rng.randrange(count)
                other = start + 4 * rng.randrange(count)
                change = rng.randrange(5)
                if change == 0:  # another operation
                    mutated[at] = rng.randrange(20)
                elif change == 1:  # another operand
                    mutated[at + rng.randrange(1, 4)] = rng.randrange(rng.choice((4, 16, 256)))
                elif change == 2:  # an instruction twice
                    mutated[at : at + 4] = mutated[other : other + 4]
                elif change == 3:  # two instructions change places
                    mutated[at : at + 4], mutated[other : other + 4] = mutated[other : other + 4], mutated[at : at + 4]
                else:  # a jump to an instruction near
                    mutated[at + 2] = (at - start) // 4 % 256
                    mutated[at + 3] = (at - start) // 4 // 256
            outcomes.append(refused(with_checksum(bytes(mutated))))
    assert {True, False} == set(outcomes)


def test_a_machine_refuses_the_image_of_another_robot() -> None:
    case = random_case(random.Random("mine"))
    other = random_case(random.Random("other"))
    machine = machine_for(case)
    assert machine is not None
    assert case.robot.fingerprint != other.robot.fingerprint
    with pytest.raises(ImageError, match="another robot"):
        Machine(machine.image, other.robot)


def flipped(rng: random.Random, data: bytes, bits: int) -> bytes:
    mutated = bytearray(data)
    for _ in range(bits):
        mutated[rng.randrange(len(mutated))] ^= 1 << rng.randrange(8)
    return bytes(mutated)
