"""What is sure not to fit a micro:bit of 2016 is refused before it is sent, and nothing that ran there is."""

from __future__ import annotations

import re

import pytest

from kitrobot.deploy.errors import BoardError, FullError, NoMemoryError
from kitrobot.deploy.microbit_2016.flash_loop import FLASH_LOOP, loop_block
from kitrobot.deploy.microbit_2016.flash_room import least_pieces, refuse_what_has_no_room
from kitrobot.deploy.package.board_package import LoopInstaller
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.memory import refuse_what_does_not_fit
from kitrobot.deploy.package.script import board_file
from kitrobot.robots.program import BoardProgram
from kitrobot.workspace.mission_loader import open_mission
from tests.deploy.small_flash import CHUNK, SmallFlash
from tests.effort import cases
from tests.verifier.check_fixtures import EXAMPLES
from tools.kit_pages import measured_2016
from tools.microbit_kits import programs, sendable, small_kits

FREE = 9696
"""Bytes that the board says are free when a deploy begins, in QEMU; with other firmware it is its own number."""


def refusal(program: BoardProgram, free: int = FREE, installer: LoopInstaller = FLASH_LOOP) -> BoardError | None:
    built = program.package.build("microbit", program.file.drivers, installer)
    try:
        refuse_what_does_not_fit(program.file, built, len(board_file(program.file, built)), free)
    except NoMemoryError as error:
        return error
    return None


def only(mission: str, kit: str) -> BoardProgram:
    ((_, program),) = programs(open_mission(EXAMPLES / mission / f"{mission}.krt"), small_kits()[kit])
    return program


def test_nothing_that_ran_there_is_refused_and_most_of_what_did_not_is() -> None:
    found = {True: 0, False: 0}
    measured = measured_2016()
    kits = small_kits()
    for name in cases(["move-motor"], [name for name in kits if name != "move-motor"]):
        kit = kits[name]
        for mission, made in sendable(kit).items():
            row = measured[mission][name]
            refused = any(refusal(program) is not None for _, program in made)
            if "problem" in row:
                found[refused] += 1
            else:
                assert not refused, f"{mission} ran on {name}, and left {row['free']} bytes"
    assert found[True] > found[False]


def test_it_says_what_costs_most_and_what_to_do() -> None:
    program = only("kit-rover", "cutebot")
    said = refusal(program)
    assert said is not None
    assert re.search(
        r"needs \d{4} bytes of memory, and beside KitRobot the board has \d{4}; nothing was sent", str(said)
    )
    assert "micro:bit V2" in str(said)
    assert "`ultrasonic` (" in str(said)
    # What counts is the memory that the board says it has.
    assert refusal(program, 2 * FREE) is None
    assert refusal(only("square", "cutebot"), FREE // 2) is not None


def test_a_v2_has_room_for_it() -> None:
    """Its heap has 64 kB, all of the loop lies in it, and the rules of the small board are not its own."""
    assert refusal(only("kit-rover", "cutebot"), 60_000, COMPILED_LOOP) is None


class Sized(SmallFlash):
    """A small board that also says how large its files are."""

    def number(self, expression: str) -> int:
        name = expression.removeprefix("os.size('").removesuffix("')")
        return len(self.files()[name])


def test_flash_without_room_is_said_before_anything_is_removed_or_written() -> None:
    one = loop_block()
    board = Sized()
    wanted = {"krboot.py": 500, "kr00000000.py": 3000, "main.py": 300}
    refuse_what_has_no_room(board, one, wanted, [], ())  # type: ignore[arg-type]
    board.put("mine.txt", bytes(600))
    board.put("photo.bin", bytes(7000))
    before = bytes(board.bytes)
    with pytest.raises(FullError, match=r"nothing was sent(.|\n)*photo\.bin, mine\.txt"):
        refuse_what_has_no_room(board, one, wanted, ["mine.txt", "photo.bin"], ())  # type: ignore[arg-type]
    refuse_what_has_no_room(board, one, wanted, ["mine.txt"], ())  # type: ignore[arg-type]
    with pytest.raises(FullError, match=r"nothing was sent(.|\n)*micro:bit V2"):
        refuse_what_has_no_room(board, one, {**wanted, "kp00000000": 9000}, [], ())  # type: ignore[arg-type]
    assert bytes(board.bytes) == before
    assert least_pieces(one) * CHUNK > 3000
