"""What is refused before it runs: one bad image for each sentence, and good ones at its edge."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.compilation import compile_lll
from kitrobot.image.machine import Machine
from kitrobot.image.model import LARGEST_VALUE, Image, ImageError, ParallelRecord, SlotRecord, StopRecord
from kitrobot.image.verification import most_instructions_a_tick, verify
from tests.image.listings import TWO_BRANCHES, compiled, image, mini_robot
from tests.strategies import random_program, random_robot

GOOD = compiled(TWO_BRANCHES)
BRANCH = (".slot - 0 0 2", ".slot 0 3 0 2", ".parallel 0 1 2")
FORKS = "FORK 0/JOIN 0/END/"

RIGHT = [
    ("the smallest", image("END")),
    ("every kind of data", image("MOV 1 3/ADD 1 1 3/CLAMP 1 2 3/SUB 1 1 3/CLAMP 1 2 3/EQ 1 0 3/LT 1 0 3/NOT 1 0/END")),
    ("the fault flag is written", image("MOV 0 2/END")),
    ("a jump on", image("JZ 1 2/MOV 1 3/END")),
    ("a jump to itself that gives up the tick", image("LOOP 0")),
    ("a jump back over a wait", image("WAIT 3/JMP 0")),
    ("a command without arguments", image("ACT 0 0 0/END")),
    ("a command with the last cell", image("ACT 0 3 1/END")),
    ("no arguments from behind the last cell", image("ACT 0 4 0/END")),
    ("a parallel", image(f"{FORKS}END", *BRANCH)),
    ("a parallel that is joined only", image("JOIN 0/NOT 1 0/END/END", *BRANCH)),
    ("what is behind END", image("END/NOT 1 0/END")),
    ("clamping to one value", image("CLAMP 1 3 3/END")),
]


@pytest.mark.parametrize("made", [row[1] for row in RIGHT], ids=[row[0] for row in RIGHT])
def test_a_safe_image_is_accepted(made: Image) -> None:
    verify(made)
    assert Image.from_bytes(made.to_bytes()) == made


WRONG: list[tuple[str, Image, str]] = [
    # sizes
    ("a cell too few", replace(GOOD, cells=GOOD.cells[:-1]), f"it has {len(GOOD.cells) - 1} cells, and 1 to 256"),
    ("a cell too many", replace(GOOD, cells=(*GOOD.cells, 0)), f"it has {len(GOOD.cells) + 1} cells"),
    (
        "257 cells",
        replace(
            GOOD, cells=(*GOOD.cells, *[0] * (257 - len(GOOD.cells))), constants=GOOD.constants + 257 - len(GOOD.cells)
        ),
        "it has 257 cells, and 1 to 256 are possible",
    ),
    ("a value too large", replace(GOOD, cells=(LARGEST_VALUE + 1, *GOOD.cells[1:])), "a cell's value is outside"),
    ("a value too small", replace(GOOD, cells=(-LARGEST_VALUE - 1, *GOOD.cells[1:])), "a cell's value is outside"),
    ("no code", replace(GOOD, code=b""), "it has no whole instructions"),
    ("half an instruction", replace(GOOD, code=GOOD.code[:-1]), "it has no whole instructions"),
    ("65537 instructions", replace(GOOD, code=GOOD.code[-4:] * 65537), "it has no whole instructions"),
    ("no slots", replace(GOOD, slots=()), "it has too many slots, parallels or stops"),
    ("257 slots", replace(GOOD, slots=GOOD.slots * 100), "it has too many slots"),
    ("257 parallels", replace(GOOD, parallels=GOOD.parallels[:1] * 257), "it has too many slots"),
    ("257 stops", replace(GOOD, stops=GOOD.stops[:1] * 257), "it has too many slots"),
    ("257 commands", replace(GOOD, commands=(0,) * 257), "it has too many commands"),
    ("257 actuators", replace(GOOD, actuators=257), "it has too many commands, actuators or arguments"),
    ("256 arguments", replace(GOOD, most_arguments=256), "it has too many commands, actuators or arguments"),
    ("a command of no actuator", replace(GOOD, actuators=GOOD.actuators - 1), "a command belongs to an actuator that"),
    ("a tick of nothing", replace(GOOD, tick_ms=0), "its tick and wait unit must be at least 1 ms"),
    ("a wait unit of nothing", replace(GOOD, wait_unit_ms=0), "its tick and wait unit must be at least 1 ms"),
    # the tree of slots and parallels
    (
        "a program in a parallel",
        replace(GOOD, slots=(GOOD.slots[0]._replace(parallel=0), *GOOD.slots[1:])),
        "slot 0 is",
    ),
    (
        "a marked program",
        replace(GOOD, slots=(GOOD.slots[0]._replace(marked=True), *GOOD.slots[1:])),
        "slot 0 is not the",
    ),
    (
        "a program that ends early",
        replace(GOOD, slots=(GOOD.slots[0]._replace(end=2), *GOOD.slots[1:])),
        "slot 0 is not",
    ),
    ("a branch of nothing", replace(GOOD, slots=(*GOOD.slots[:-1], SlotRecord(None, 20, False, 4))), "slot 3 is not a"),
    ("a branch of a parallel that is not there", image("END/END", ".slot - 0 0 2", ".slot 0 1 0 2"), "slot 1 is not a"),
    (
        "a branch that ends before it begins",
        image("END/END", ".slot - 0 0 2", ".slot 0 1 0 1", BRANCH[2]),
        "slot 1 is not",
    ),
    ("a branch that ends behind all", image("END/END", ".slot - 0 0 2", ".slot 0 1 0 3", BRANCH[2]), "slot 1 is not a"),
    (
        "a parallel in its own branch",
        image("END/END", ".slot - 0 0 2", ".slot 0 1 0 2", ".parallel 1 1 2"),
        "parallel 0",
    ),
    ("an empty parallel", image("END/END", *BRANCH[:2], ".parallel 0 1 1"), "parallel 0 does not lie inside its slot"),
    (
        "a parallel behind all",
        image("END/END", *BRANCH[:2], ".parallel 0 1 3"),
        "parallel 0 does not lie inside its slot",
    ),
    (
        "a parallel of a slot that is not there",
        image("END/END", *BRANCH[:2], ".parallel 9 10 11"),
        "parallel 0 does not",
    ),
    (
        "parallels out of order",
        replace(
            GOOD,
            parallels=GOOD.parallels[::-1],
            slots=tuple(s if s.parallel is None else s._replace(parallel=1 - s.parallel) for s in GOOD.slots),
        ),
        "the parallels are not in reading order",
    ),
    (
        "a branch in another parallel's stretch",
        replace(GOOD, slots=(*GOOD.slots[:2], GOOD.slots[2]._replace(parallel=1), GOOD.slots[3])),
        "slot 2 does not belong to parallel 0",
    ),
    (
        "a branch of no parallel's stretch",
        image("END/END/END", ".slot - 0 0 3", ".slot 0 1 0 2", ".slot 0 2 0 3", ".parallel 0 1 2"),
        "a slot belongs to no parallel",
    ),
    (
        "a stop of no slot",
        replace(GOOD, stops=(StopRecord(9, 0),)),
        "a stop names a slot or command that does not exist",
    ),
    ("a stop of the program", replace(GOOD, stops=(StopRecord(0, 0),)), "a stop names a slot or command"),
    (
        "a stop of no command",
        replace(GOOD, stops=(StopRecord(1, len(GOOD.commands)),)),
        "a stop names a slot or command",
    ),
    # where slots have their code
    (
        "code that begins late",
        replace(GOOD, slots=(GOOD.slots[0]._replace(entry=1), *GOOD.slots[1:])),
        "the slots' code is",
    ),
    (
        "two slots with one code",
        image("END/END", ".slot - 0 0 2", ".slot 0 0 0 2", BRANCH[2]),
        "the slots' code is not in",
    ),
    (
        "a slot behind the code",
        image("END/END", ".slot - 0 0 2", ".slot 0 2 0 2", BRANCH[2]),
        "a slot begins behind the",
    ),
    # instructions
    ("number 0", image(".bytes 0 0 0 0/END"), "instruction 0 has the unknown number 0"),
    ("number 19", image("END/.bytes 19 0 0 0/END"), "instruction 1 has the unknown number 19"),
    ("number 255", image(".bytes 255 0 0 0/END"), "instruction 0 has the unknown number 255"),
    ("a jump behind the code", image("JMP 2/END"), "instruction 0 jumps out of its slot"),
    ("a jump far away", image("JMP 65535/END"), "instruction 0 jumps out of its slot"),
    ("a jump into another slot", image("FORK 0/JMP 3/END/END", *BRANCH), "instruction 1 jumps out of its slot"),
    ("a jump out of a branch", image(f"{FORKS}LOOP 0", *BRANCH), "instruction 3 jumps out of its slot"),
    ("a jump with a third number", image(".bytes 8 1 0 0/END"), "instruction 0 (JMP) has the operand 1"),
    ("END with a number", image(".bytes 14 0 0 1/END"), "instruction 0 (END) has the operand 1"),
    (
        "writing a constant",
        image("MOV 2 1/END"),
        "instruction 0 (MOV) has the operand 2, which names nothing it may use",
    ),
    ("writing behind the cells", image("NOT 4 1/END"), "instruction 0 (NOT) has the operand 4"),
    ("reading behind the cells", image("MOV 1 4/END"), "instruction 0 (MOV) has the operand 4"),
    ("comparing with what is behind the cells", image("EQ 1 1 4/END"), "instruction 0 (EQ) has the operand 4"),
    ("testing behind the cells", image("JZ 4 1/END"), "instruction 0 (JZ) has the operand 4"),
    ("waiting behind the cells", image("WAIT 4/END"), "instruction 0 (WAIT) has the operand 4"),
    ("clamping to a variable", image("CLAMP 1 1 3/END"), "instruction 0 (CLAMP) has the operand 1"),
    ("a command that is not there", image("ACT 1 0 0/END"), "instruction 0 (ACT) has the operand 1"),
    ("arguments behind the cells", image("ACT 0 4 1/END"), "instruction 0 (ACT) has the operand 1"),
    ("arguments from far behind the cells", image("ACT 0 5 0/END"), "instruction 0 (ACT) has the operand 5"),
    ("more arguments than any command has", image("ACT 0 0 2/END"), "instruction 0 (ACT) has the operand 2"),
    ("a stop that is not there", image("ARM 0/END"), "instruction 0 (ARM) has the operand 0"),
    ("a parallel that is not there", image("FORK 0/END"), "instruction 0 (FORK) has the operand 0"),
    ("joining a parallel that is not there", image("JOIN 0/END"), "instruction 0 (JOIN) has the operand 0"),
    ("code without an end", image("MOV 1 3"), "instruction 0 runs past the end of its slot"),
    ("a test at the end", image("JZ 1 0"), "instruction 0 runs past the end of its slot"),
    ("a branch without an end", image(f"{FORKS}YIELD", *BRANCH), "instruction 3 runs past the end of its slot"),
    ("a program that runs into its branch", image("FORK 0/JOIN 0/NOT 1 0/END", *BRANCH), "instruction 2 runs past"),
    (
        "a sum that is not clamped",
        image("ADD 1 1 3/END"),
        "instruction 0 (ADD) is not followed by the CLAMP of its sum",
    ),
    ("a sum of another cell clamped", image("SUB 1 1 3/CLAMP 0 2 3/END"), "instruction 0 (SUB) is not followed by"),
    ("clamping to nothing", image("CLAMP 1 3 2/END"), "instruction 0 clamps to an empty range"),
    (
        "forking another slot's parallel",
        image(f"{FORKS}FORK 0/END", *BRANCH),
        "instruction 3 (FORK) uses a parallel of another slot",
    ),
    (
        "joining another slot's parallel",
        image(f"{FORKS}JOIN 0/END", *BRANCH),
        "instruction 3 (JOIN) uses a parallel of another slot",
    ),
    (
        "arming another slot's stop",
        image("ARM 0/JOIN 0/END/END", *BRANCH, ".stop 1 0"),
        "instruction 0 arms the stop of another slot",
    ),
    # ways round
    ("a jump to itself", image("JMP 0"), "instruction 0 goes round to 0 without ever giving up the tick"),
    ("a way round", image("MOV 1 3/JMP 0"), "instruction 1 goes round to 0 without ever giving up the tick"),
    (
        "a way round on a condition",
        image("JZ 1 0/END"),
        "instruction 0 goes round to 0 without ever giving up the tick",
    ),
    (
        "a way round past a wait",
        image("JZ 1 2/WAIT 3/JMP 0"),
        "instruction 2 goes round to 0 without ever giving up the",
    ),
    (
        "a way round that nothing leads to",
        image("END/JMP 1"),
        "instruction 1 goes round to 1 without ever giving up the",
    ),
    ("a way round a join", image("JOIN 0/JMP 0/END/END", *BRANCH), "instruction 1 goes round to 0 without ever giving"),
]


@pytest.mark.parametrize(("made", "sentence"), [row[1:] for row in WRONG], ids=[row[0] for row in WRONG])
def test_an_image_that_is_not_safe_is_refused_with_a_sentence(made: Image, sentence: str) -> None:
    with pytest.raises(ImageError) as caught:
        verify(made)
    assert caught.value.message.startswith(f"this image cannot be run: {sentence}")
    assert caught.value.help == "make it again with `kitrobot convert`"


def test_an_image_at_the_largest_value_is_accepted() -> None:
    verify(replace(GOOD, cells=(LARGEST_VALUE, *GOOD.cells[1:])))
    verify(replace(GOOD, cells=(-LARGEST_VALUE, *GOOD.cells[1:])))


def test_a_machine_verifies_before_it_runs() -> None:
    bad = replace(GOOD, code=GOOD.code[:-4] + bytes((8, 0, 0, 0)))
    with pytest.raises(ImageError, match=r"this image cannot be run: instruction \d+ jumps out of its slot"):
        Machine(bad, mini_robot())


def test_the_records_of_an_image_are_what_the_program_says() -> None:
    assert GOOD.slots == (
        SlotRecord(None, 0, False, 4),
        SlotRecord(0, 5, True, 2),
        SlotRecord(0, 9, False, 3),
        SlotRecord(1, 18, False, 4),
    )
    assert GOOD.parallels == (ParallelRecord(0, 1, 3), ParallelRecord(0, 3, 4))
    assert [stop.slot for stop in GOOD.stops] == [1]


COSTS = [
    ("the smallest", image("END"), 1),
    ("a row", image("MOV 1 3/MOV 1 3/END"), 3),
    ("a wait in between", image("MOV 1 3/WAIT 3/MOV 1 3/NOT 1 0/END"), 3),
    ("the longer of two ways", image("JZ 1 3/MOV 1 3/MOV 1 3/END"), 4),
    ("each slot by itself", image(f"{FORKS}MOV 1 3/END", *BRANCH), 4),
    ("a jump back over a wait", image("MOV 1 3/WAIT 3/JMP 0"), 3),
]


@pytest.mark.parametrize(("made", "most"), [row[1:] for row in COSTS], ids=[row[0] for row in COSTS])
def test_the_most_instructions_a_tick_can_take_are_known(made: Image, most: int) -> None:
    assert most_instructions_a_tick(made) == most


@given(st.randoms(use_true_random=True))
def test_every_compiled_program_is_accepted_and_keeps_to_its_most_instructions(rng: random.Random) -> None:
    robot = random_robot(rng)
    result = compile_lll(random_program(rng, robot), robot)
    assert result.image is not None
    machine = Machine(result.image, robot, watch=True)
    most = most_instructions_a_tick(result.image)
    for _ in range(20):
        machine.tick()
        assert sum(machine.seen) <= most
