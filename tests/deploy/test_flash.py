"""Blocks between the files of a small board: found, written, freed, and in nobody's way."""

from __future__ import annotations

import contextlib
import random
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.deploy.errors import FullError
from kitrobot.deploy.microbit_2016.flash import Flash
from kitrobot.deploy.microbit_2016.flash_code import HEAD
from tests.deploy.small_flash import CHUNK, END, PAGE, SPARE, START, FlashFull, SmallFlash


def seen(board: Any) -> Flash:
    found = Flash.of(board)
    assert found is not None
    return found


def content(size: int, seed: int = 1) -> bytes:
    """Bytes that are neither of those that mean something at the beginning of a piece."""
    chance = random.Random(seed)
    return bytes(chance.randrange(78, 250) for _ in range(size))


def block(board: SmallFlash, sign: int) -> bytes | None:
    """What a block holds, without its head."""
    at = seen(board).find(sign)
    if at is None:
        return None
    count = int.from_bytes(board.bytes[at + 8 : at + 12], "little")
    return bytes(board.bytes[at + HEAD : at + count * CHUNK])


@pytest.fixture
def board() -> SmallFlash:
    made = SmallFlash(start=50)
    made.put("one", b"1" * 300)
    return made


def test_without_a_file_of_two_pieces_nothing_says_where_the_files_are() -> None:
    empty = SmallFlash()
    assert Flash.of(empty) is None  # type: ignore[arg-type]
    empty.put("short", b"1")
    assert Flash.of(empty) is None  # type: ignore[arg-type]
    empty.put("long", b"1" * 200)
    assert seen(empty).area.start == 0x3BC00


@pytest.mark.parametrize("first", [0x38800, 0x3A000, 0x3BC00])
@pytest.mark.parametrize("firmware", [1, 7, 254])
def test_the_files_are_found_wherever_the_firmware_ends(first: int, firmware: int) -> None:
    board = SmallFlash(first, 90, firmware)
    for number in range(12):
        board.put(f"f{number}", bytes(20 * number))
    area = seen(board).area
    assert (area.start, len(area.firsts)) == (first, (END - 2 * PAGE - first) // CHUNK)


def test_a_block_is_found_when_it_is_whole_only(board: SmallFlash) -> None:
    data = content(900)
    assert block(board, 5) is None
    flash = seen(board)
    flash.write(5, data)
    assert (block(board, 5) or b"")[: 900 - HEAD] == data[HEAD:]
    assert block(board, 6) is None
    assert board.files() == {"one": b"1" * 300}


@pytest.mark.parametrize("words", [0, 1, 2, 3, 40, 240, 255])
def test_one_whose_writing_was_cut_counts_never_and_is_freed(board: SmallFlash, words: int) -> None:
    flash = seen(board)
    write = board.write_words

    def cut(at: int, data: bytes) -> None:
        write(at, data[: 4 * words])
        raise ConnectionError

    board.write_words = cut  # type: ignore[method-assign,assignment]
    with pytest.raises(ConnectionError):
        flash.write(5, content(1000))
    board.write_words = write  # type: ignore[method-assign]
    assert block(board, 5) is None
    flash = seen(board)
    flash.clear(set())
    used = [first for first in flash.area.firsts if first not in (0, 255)]
    assert len(used) == 3, "the pieces of the file"
    flash.write(5, content(1000, 2))
    assert block(board, 5) is not None


def test_what_files_left_behind_is_freed_and_files_and_kept_blocks_are_not(board: SmallFlash) -> None:
    flash = seen(board)
    flash.write(5, content(700))
    flash.write(6, content(500))
    board.put("two", b"2" * 400)
    start = next(at for at in range(board.first, board.last, CHUNK) if board.bytes[at] == START)
    lost = bytes(board.bytes[start + 3 : start + 6]).decode()
    board.bytes[start] = 0  # as the board does when it opens a file anew: the rest of the old one is nobody's
    flash.see()
    flash.clear({6})
    assert block(board, 5) is None
    assert block(board, 6) is not None
    assert list(board.files()) == [name for name in ("one", "two") if name != lost]
    left = sum(first not in (0, 255) for first in flash.area.firsts)
    assert left == 4 + {"one": 4, "two": 3}[lost]


def test_pages_without_anything_in_them_are_erased_for_a_block() -> None:
    board = SmallFlash()
    for number in range(30):
        board.put(f"f{number}", bytes(400))
    for number in range(2, 28):
        board.remove(f"f{number}")
    for at in range(board.first, board.last, CHUNK):
        if board.bytes[at] == 255:
            board.bytes[at] = 0
    seen(board).write(5, content(3000))
    assert block(board, 5) is not None
    assert set(board.files()) == {"f0", "f1", "f28", "f29"}


def test_where_no_room_is_left_that_is_said() -> None:
    board = SmallFlash()
    with contextlib.suppress(FlashFull):
        for number in range(200):
            board.put(f"f{number}", bytes(300))
    with pytest.raises(FullError, match="no room left in one piece"):
        seen(board).write(5, content(600))


def test_room_for_files_is_what_is_unused_or_freed(board: SmallFlash) -> None:
    flash = seen(board)
    flash.refuse_less_than(117 * 126)
    with pytest.raises(FullError):
        flash.refuse_less_than(117 * 126 + 1)


def test_a_script_of_an_editor_at_the_end_of_the_flash_is_left_alone(board: SmallFlash) -> None:
    script = b"MP" + bytes(1000)
    board.bytes[0x3E000 : 0x3E000 + len(script)] = script
    board.bytes[0x3DC00] = SPARE
    flash = seen(board)
    assert flash.area.address(len(flash.area.firsts)) == 0x3DC00
    flash.clear(set())
    flash.write(5, content(900))
    assert bytes(board.bytes[0x3E000 : 0x3E000 + len(script)]) == script


@given(
    st.integers(0, 119),
    st.lists(st.tuples(st.sampled_from("abcdef"), st.integers(0, 1500)) | st.integers(1, 3), max_size=40),
)
def test_files_and_blocks_stay_whole_whatever_is_written_after_them(
    start: int, steps: list[tuple[str, int] | int]
) -> None:
    board = SmallFlash(start=start)
    board.put("probe", bytes(200))
    files = {"probe": bytes(200)}
    blocks: dict[int, bytes] = {}
    for number, step in enumerate(steps):
        if isinstance(step, int):
            flash = seen(board)
            blocks = {sign: data for sign, data in blocks.items() if sign != step}
            flash.clear(set(blocks))
            data = content(300 * step, number)
            with contextlib.suppress(FullError):
                flash.write(step, data)
                blocks[step] = data
        else:
            name, size = step
            files.pop(name, None)
            board.remove(name)
            try:
                board.put(name, bytes((number,)) * size)
                files[name] = bytes((number,)) * size
            except FlashFull:
                board.remove(name)
        assert board.files() == files
        for sign, data in blocks.items():
            found = block(board, sign)
            assert found is not None
            assert found.startswith(data[HEAD:])
