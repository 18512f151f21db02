"""`kitrobot deploy --file`: what it writes, what it says, and what it refuses before anything is written."""

from __future__ import annotations

import json

import pytest

from tests.deploy.uf2_firmware import binary, uf2
from tests.verifier.check_fixtures import EXAMPLES

pytestmark = pytest.mark.usefixtures("no_boards")
HEART = EXAMPLES / "heart" / "heart.krt"
SQUARE = EXAMPLES / "square" / "square.krt"
FIRMWARE = "RPI_PICO-20260101-v1.27.0.uf2"


def test_the_file_is_written_and_is_read_wherever_a_mission_is(kitrobot, here):
    done = kitrobot("deploy", HEART, "--file", "heart.hex")
    assert (done.status, "written for the micro:bit of 2016, the micro:bit V2" in done.err) == (0, True)
    assert kitrobot("convert", "heart.hex", "again.krt").status == 0
    assert (here / "again.krt").read_bytes() == HEART.read_bytes()
    assert "no problems" in kitrobot("check", "heart.hex").err
    over = kitrobot("deploy", "heart.hex", "--file", "heart.hex")
    assert (over.status, "is a file that is read" in over.err) == (1, True)


def test_a_uf2_says_for_which_board_it_is_and_what_is_done_with_it(kitrobot, here):
    (here / FIRMWARE).write_bytes(uf2(binary()))
    done = kitrobot("deploy", SQUARE, "--board", "pico", "--file", "s.uf2", "--firmware", FIRMWARE, "--json")
    assert (done.status, f"s.uf2: written for the board of `{FIRMWARE}` (RP2040)" in done.err) == (0, True)
    assert "Hold the button BOOTSEL while you plug the board in" in done.err
    assert json.loads(done.out) == {"file": "s.uf2", "bytes": (here / "s.uf2").stat().st_size, "left_out": {}}
    assert kitrobot("convert", "s.uf2", "again.krt").status == 0
    assert (here / "again.krt").read_bytes() == SQUARE.read_bytes()
    assert "no problems" in kitrobot("check", "s.uf2").err
    over = kitrobot("deploy", SQUARE, "--board", "pico", "--file", FIRMWARE, "--firmware", FIRMWARE)
    assert (over.status, "is a file that is read" in over.err) == (1, True)
    twice = kitrobot("deploy", SQUARE, "--board", "pico", "--file", "t.uf2", "--firmware", "s.uf2")
    assert (twice.status, "brings files of its own along" in twice.err) == (1, True)
    assert not (here / "t.uf2").exists()


def test_a_program_for_the_v2_alone_says_why_and_what_takes_most(kitrobot, here):
    done = kitrobot(
        "deploy", EXAMPLES / "kit-rover" / "kit-rover.krt", "--board", "cutebot", "--file", "r.hex", "--json"
    )
    assert done.status == 0
    assert list(json.loads(done.out)["left_out"]) == ["the micro:bit of 2016"]
    assert "it is not for the micro:bit of 2016: the program needs" in done.err
    assert "the drivers that take most are" in done.err


def test_a_program_with_parts_of_the_v2_says_which_they_are_and_what_can_be_done(kitrobot, here):
    (here / "touch.lll").write_text("*[Logo.IsReleased()]( WAIT(1); );\nMusic.Play(0);\n")
    done = kitrobot("deploy", "touch.lll", "--robot", "microbit", "--file", "t.hex")
    assert done.status == 0
    lines = done.err.splitlines()
    said = "it is not for the micro:bit of 2016: only a micro:bit V2 has what the program uses: `Logo`"
    assert said in lines
    assert "  help: take a micro:bit V2, or leave these parts out of the program" in lines
    assert "t.hex: written for the micro:bit V2" in lines


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("heart", "--file", "heart.bin"), "let it end in `.hex`"),
        (("square", "--board", "pico", "--file", "s.uf2"), "fetch MicroPython for your board from https://micropython"),
        (("heart", "--file", "h.hex", "--firmware", "f.uf2"), "a `.hex` has the MicroPython of the micro:bit already"),
        (("heart", "--firmware", "f.uf2"), "it goes with --file FILE.uf2"),
        (("square", "--board", "pico", "--file", "s.uf2", "--firmware", "f.uf2"), "`f.uf2` cannot be read"),
        (("heart", "--file", "none/heart.hex"), "there is no folder"),
        (("square", "--board", "pico", "--file", "s.hex"), "the kit `pico` is for another board"),
        (("heart", "--file", "h.hex", "--to", "COM3"), "a file goes to no board yet"),
        (("heart", "--file", "h.hex", "--fresh"), "a file goes to no board yet"),
        (("x.csv", "--set", "--file", "h.hex"), "nothing goes into a file"),
    ],
)
def test_what_cannot_be_written_is_a_sentence_and_no_file(kitrobot, here, arguments, said):
    done = kitrobot("deploy", *arguments)
    assert done.status in (1, 2)
    assert said in " ".join(done.err.replace("│", " ").split())
    assert [*here.glob("*.hex"), *here.glob("*.uf2")] == []


@pytest.mark.parametrize("target", ["heart.hex", "heart.uf2"])
def test_a_conversion_into_a_file_for_a_board_names_the_command_that_makes_one(kitrobot, here, target):
    done = kitrobot("convert", HEART, target)
    assert (done.status, f"--file {target}" in done.err) == (1, True)
    assert ("--firmware" in done.err) == target.endswith(".uf2")
