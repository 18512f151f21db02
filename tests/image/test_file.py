"""The file of an image: what is written is read, and what is damaged is refused with a sentence."""

from __future__ import annotations

import random
import struct
import zlib
from contextlib import suppress
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.compilation import compile_lll
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.image.model import Image, ImageError
from kitrobot.text.sentences import Sentence
from kitrobot_onboard.image import HEADER_SIZE, load
from tests.image.listings import TWO_BRANCHES, compiled, image
from tests.strategies import random_program, random_robot

GOOD = compiled(TWO_BRANCHES)
DATA = GOOD.to_bytes()


def with_checksum(data: bytes) -> bytes:
    """The file with the checksum that fits."""
    return data[:-4] + struct.pack("<I", zlib.crc32(data[:-4]))


def refused(data: bytes, message: str) -> None:
    with pytest.raises(ImageError) as caught:
        Image.from_bytes(data)
    assert caught.value.message == message
    assert caught.value.help == "make it again with `kitrobot convert`"
    with pytest.raises(ValueError, match="image"):
        load(data)


def test_what_is_written_is_read() -> None:
    assert Image.from_bytes(DATA) == GOOD
    assert Image.from_bytes(DATA).to_bytes() == DATA


def test_the_same_program_gives_the_same_bytes() -> None:
    assert compiled(TWO_BRANCHES).to_bytes() == DATA


@given(st.randoms(use_true_random=True))
def test_a_random_program_s_image_is_read_as_it_was_written(rng: random.Random) -> None:
    robot = random_robot(rng)
    made = compile_lll(random_program(rng, robot), robot).image
    assert made is not None
    assert Image.from_bytes(made.to_bytes()) == made


@pytest.mark.parametrize(
    "data", [b"", b"KRI", b"KRI\0", b"MZ" + DATA[2:], b"kri\0" + DATA[4:], DATA[: HEADER_SIZE + 3]]
)
def test_a_file_that_is_no_image_is_refused(data: bytes) -> None:
    refused(data, "this is not a KitRobot image")


@pytest.mark.parametrize("version", [0, 2, 65535])
def test_an_image_of_another_format_is_refused_and_says_which(version: int) -> None:
    data = with_checksum(DATA[:4] + struct.pack("<H", version) + DATA[6:])
    refused(data, f"this image has format {version}, and only format 1 can be read")


@pytest.mark.parametrize("change", [-1, -7, 1, 1000])
def test_an_image_of_another_length_is_refused(change: int) -> None:
    data = DATA[:change] if change < 0 else DATA + bytes(change)
    with pytest.raises(ImageError) as caught:
        Image.from_bytes(data)
    assert caught.value.message == f"this image is damaged: it has {len(data)} bytes where {len(DATA)} belong"
    with pytest.raises(ValueError, match=f"{len(data)} bytes where {len(DATA)} belong"):
        load(data)


def test_an_image_with_one_bit_flipped_anywhere_is_refused() -> None:
    for position in range(len(DATA)):
        data = bytearray(DATA)
        data[position] ^= 1 << (position % 8)
        with pytest.raises(ImageError, match="image"):
            Image.from_bytes(bytes(data))
        with pytest.raises(ValueError, match="image"):
            load(bytes(data))


def test_an_image_with_a_wrong_checksum_is_refused() -> None:
    refused(DATA[:-1] + bytes((DATA[-1] ^ 1,)), "this image is damaged: its checksum does not fit")


def test_a_slot_marked_in_an_unknown_way_is_refused() -> None:
    slots = HEADER_SIZE + 4 * len(GOOD.cells)
    data = DATA[: slots + 4] + struct.pack("<H", 2) + DATA[slots + 6 :]
    with pytest.raises(ImageError, match="this image is damaged: a slot is marked in a way we do not know"):
        Image.from_bytes(with_checksum(data))


@given(st.binary(max_size=200))
def test_any_bytes_are_refused_or_read_and_never_anything_else(data: bytes) -> None:
    for one in (data, b"KRI\0\1\0\0\0" + data, with_checksum(b"KRI\0\1\0\0\0" + data + bytes(HEADER_SIZE))):
        with suppress(ImageError):
            assert Image.from_bytes(one).to_bytes() == one


@pytest.mark.parametrize(
    "made",
    [
        replace(GOOD, tick_ms=65536),
        replace(GOOD, wait_unit_ms=-1),
        replace(GOOD, cells=(2**31, *GOOD.cells[1:])),
        replace(GOOD, commands=(65536,)),
        replace(GOOD, slots=(GOOD.slots[0]._replace(entry=70000), *GOOD.slots[1:])),
    ],
)
def test_numbers_that_do_not_fit_the_file_are_refused_when_writing(made: Image) -> None:
    with pytest.raises(ImageError, match="this image does not fit its file"):
        made.to_bytes()


def test_an_error_of_an_image_is_an_error_of_ours() -> None:
    assert issubclass(ImageError, KitRobotError)
    assert str(ImageError(Sentence("what"), Sentence("how"))) == "what\nhelp: how"
    assert str(ImageError(Sentence("what"))) == "what"


def test_the_sizes_of_an_image_are_in_its_header() -> None:
    made = image("MOV 1 3/END")
    data = made.to_bytes()
    assert len(data) == HEADER_SIZE + 4 * 4 + 8 + 2 + 4 * 2 + 4
    assert data[:6] == b"KRI\0\1\0"
    assert data[8:16].hex() == "0123456789abcdef"
    assert made.instructions == 2
    assert made.first_constant == 2
