"""The listing of an image: complete, so that assembling it gives the image byte for byte."""

from __future__ import annotations

import random
from contextlib import suppress
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.compilation import compile_lll
from kitrobot.image.listing import assemble, disassemble
from kitrobot.image.model import Image, ImageError
from tests.image.listings import TWO_BRANCHES, compiled
from tests.strategies import random_program, random_robot

GOOD = compiled(TWO_BRANCHES)

LISTING = """\
; KitRobot three-address code. Cells: fault, inputs, variables, counters, temporaries, constants.
.robot {robot}
.tick 20
.wait-unit 100
.inputs 7
.variables 4
.counters 1
.temporaries 0
.constants 4
.actuators 6
.arguments 2
.cell 0          ; 0: fault
.cell 0          ; 1: input 0
.cell 0          ; 2: input 1
.cell 0          ; 3: input 2
.cell 1          ; 4: input 3
.cell 1          ; 5: input 4
.cell 1          ; 6: input 5
.cell 1          ; 7: input 6
.cell 0          ; 8: variable 0
.cell 50         ; 9: variable 1
.cell 1          ; 10: variable 2
.cell 0          ; 11: variable 3
.cell 0          ; 12: counter 0
.cell 2          ; 13: constant 0
.cell 5          ; 14: constant 1
.cell 1          ; 15: constant 2
.cell 0          ; 16: constant 3
.slot - 0 0 2  ; 0: parallel, entry, marked, end
.slot 0 11 1 2  ; 1: parallel, entry, marked, end
.parallel 0 1 2  ; 0: parent, first, end
.stop 1 7  ; 0: slot, command
.command 0  ; 0: actuator
.command 0  ; 1: actuator
.command 0  ; 2: actuator
.command 0  ; 3: actuator
.command 0  ; 4: actuator
.command 1  ; 5: actuator
.command 1  ; 6: actuator
.command 1  ; 7: actuator
.command 1  ; 8: actuator
.command 1  ; 9: actuator
.command 2  ; 10: actuator
.command 2  ; 11: actuator
.command 3  ; 12: actuator
.command 3  ; 13: actuator
.command 4  ; 14: actuator
.command 4  ; 15: actuator
.command 5  ; 16: actuator
.command 5  ; 17: actuator
.command 5  ; 18: actuator
.command 5  ; 19: actuator
.code
    MOV   12 13          ; 0
    WAIT  14             ; 1
    SUB   12 12 15       ; 2
    CLAMP 12 16 13       ; 3
    JZ    12 6           ; 4
    JMP   1              ; 5
    JZ    10 10          ; 6
    FORK  0              ; 7
    JOIN  0              ; 8
    JMP   6              ; 9
    END                  ; 10
    ARM   0              ; 11
    ACT   5 14 1         ; 12
    END                  ; 13
"""


def test_a_listing_reads_like_this() -> None:
    made = compiled("2*(WAIT(1);); *[Run.IsTrue()](//(°Wheel.Advance(5)°;););")
    assert disassemble(made) == LISTING.format(robot=made.fingerprint.hex())


def test_a_listing_gives_the_image_back() -> None:
    assert assemble(disassemble(GOOD)) == GOOD
    assert assemble(disassemble(GOOD)).to_bytes() == GOOD.to_bytes()


@given(st.randoms(use_true_random=True))
def test_the_listing_of_a_random_program_gives_its_image_back_byte_for_byte(rng: random.Random) -> None:
    robot = random_robot(rng)
    made = compile_lll(random_program(rng, robot), robot).image
    assert made is not None
    assert assemble(disassemble(made)).to_bytes() == made.to_bytes()


@given(st.binary(min_size=4, max_size=400))
def test_any_code_at_all_gives_itself_back(code: bytes) -> None:
    made = replace(GOOD, code=code[: len(code) // 4 * 4])
    assert assemble(disassemble(made)).to_bytes() == made.to_bytes()


def test_comments_blank_lines_and_white_space_do_not_matter() -> None:
    listing = disassemble(GOOD)
    bare = "\n".join(" ".join(line.partition(";")[0].split()) for line in listing.split("\n"))
    assert assemble(bare) == GOOD
    assert assemble(listing.replace("\n", "\r\n\n\t")) == GOOD


SMALL = [
    ".robot 0123456789abcdef",
    ".tick 20",
    ".wait-unit 100",
    ".inputs 0",
    ".variables 0",
    ".counters 0",
    ".temporaries 0",
    ".constants 0",
    ".actuators 1",
    ".arguments 0",
    ".cell 0",
    ".slot - 0 0 1",
    ".code",
    "END",
]


def test_a_small_listing_is_an_image() -> None:
    assert assemble("\n".join(SMALL)).code == bytes((14, 0, 0, 0))


WRONG = [
    ("an unknown instruction", "JUMP 3", "`JUMP` is no instruction"),
    ("case matters", "end", "`end` is no instruction"),
    ("an operand too few", "MOV 1", "MOV takes 2 operands, found 1"),
    ("an operand too many", "YIELD 1", "YIELD takes 0 operands, found 1"),
    ("one operand too many of one", "WAIT 1 2", "WAIT takes 1 operand, found 2"),
    ("an operand that is no number", "MOV 1 x", "expected a whole number from 0 to 255, found `x`"),
    ("an operand too large", "MOV 1 256", "expected a whole number from 0 to 255, found `256`"),
    ("an operand below 0", "MOV -1 1", "expected a whole number from 0 to 255, found `-1`"),
    ("a number of another script", "MOV ٣ 1", "expected a whole number from 0 to 255, found `٣`"),
    ("a target too large", "JMP 65536", "expected a whole number from 0 to 65535, found `65536`"),
    ("a huge number", "JMP " + "9" * 99, "expected a whole number from 0 to 65535, found `" + "9" * 24 + "`"),
    ("a byte too large", ".bytes 0 0 0 256", "expected a whole number from 0 to 255, found `256`"),
    ("three bytes", ".bytes 1 2 3", "`.bytes` takes 4 values, found 3"),
    ("an unknown directive", ".loop 3", "`.loop` is no directive of a listing"),
    ("an unknown directive with nothing", ".loop", "`.loop` is no directive of a listing"),
    ("a dot", ".", "`.` is no directive of a listing"),
    ("a directive without value", ".tick", "`.tick` takes 1 value, found 0"),
    ("a directive with a value too many", ".inputs 1 2", "`.inputs` takes 1 value, found 2"),
    ("a directive given twice", ".tick 30", "`.tick` is given twice"),
    ("the robot given twice", ".robot 0123456789abcdef", "`.robot` is given twice"),
    ("a cell too large", ".cell 2147483648", "expected a whole number from -2147483648 to 2147483647"),
    ("a cell too small", ".cell -2147483649", "expected a whole number from -2147483648 to 2147483647"),
    ("a slot of three", ".slot - 0 0", "`.slot` takes 4 values, found 3"),
    ("a slot marked 2", ".slot - 0 2 1", "expected a whole number from 0 to 1, found `2`"),
    ("a slot of parallel 65535", ".slot 65535 0 0 1", "expected a whole number from 0 to 65534, found `65535`"),
    ("a parallel of two", ".parallel 0 1", "`.parallel` takes 3 values, found 2"),
    ("a stop of one", ".stop 0", "`.stop` takes 2 values, found 1"),
    ("a command below 0", ".command -1", "expected a whole number from 0 to 65535, found `-1`"),
]


@pytest.mark.parametrize(("line", "message"), [row[1:] for row in WRONG], ids=[row[0] for row in WRONG])
def test_a_mistake_in_a_listing_is_told_with_file_and_line(line: str, message: str) -> None:
    with pytest.raises(ImageError) as caught:
        assemble("\n".join([*SMALL, line, "END"]), "mine.kra")
    assert caught.value.message.startswith(f"mine.kra:15: {message}")


@pytest.mark.parametrize("fingerprint", ["0123", "0123456789abcdef0", "0123456789abcdeX", "0123456789ABCDEF"])
def test_a_fingerprint_is_sixteen_small_hexadecimal_digits(fingerprint: str) -> None:
    with pytest.raises(ImageError) as caught:
        assemble("\n".join([f".robot {fingerprint}", *SMALL[1:]]), "mine.kra")
    assert caught.value.message == "mine.kra:1: a robot's fingerprint is 16 hexadecimal digits"


@pytest.mark.parametrize("left_out", [line.split(" ")[0] for line in SMALL[:10]])
def test_a_listing_without_a_size_says_which(left_out: str) -> None:
    lines = [line for line in SMALL if not line.startswith(left_out + " ")]
    with pytest.raises(ImageError) as caught:
        assemble("\n".join(lines), "mine.kra")
    assert caught.value.message == f"mine.kra:13: the listing ends without {left_out}"


def test_an_empty_listing_says_all_that_is_missing() -> None:
    with pytest.raises(ImageError) as caught:
        assemble("")
    missing = (
        ".robot, .tick, .wait-unit, .inputs, .variables, .counters, .temporaries, .constants, .actuators, .arguments"
    )
    assert caught.value.message == f"listing.kra:1: the listing ends without {missing}"


@pytest.mark.parametrize("cells", [0, 2])
def test_a_listing_with_other_cells_than_its_sizes_ask_for_says_so(cells: int) -> None:
    lines = [line for line in SMALL if line != ".cell 0"] + [".cell 0"] * cells
    with pytest.raises(ImageError, match=f"the sizes ask for 1 cells, and {cells} are given"):
        assemble("\n".join(lines))


@given(st.text(max_size=200))
def test_any_text_is_refused_or_assembled_and_never_anything_else(text: str) -> None:
    for one in (text, "\n".join(SMALL) + "\n" + text):
        with suppress(ImageError):
            made = assemble(one)
            assert Image.from_bytes(made.to_bytes()) == made
