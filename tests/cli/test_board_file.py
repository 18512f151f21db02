"""`kitrobot deploy --file`: what it writes, what it says, and what it refuses before anything is written."""

from __future__ import annotations

import json

import pytest

from tests.verifier.check_fixtures import EXAMPLES

pytestmark = pytest.mark.usefixtures("no_boards")
HEART = EXAMPLES / "heart" / "heart.krt"


def test_the_file_is_written_and_is_read_wherever_a_mission_is(kitrobot, here):
    done = kitrobot("deploy", HEART, "--file", "heart.hex")
    assert (done.status, "written for the micro:bit of 2016, the micro:bit V2" in done.err) == (0, True)
    assert kitrobot("convert", "heart.hex", "again.krt").status == 0
    assert (here / "again.krt").read_bytes() == HEART.read_bytes()
    assert "no problems" in kitrobot("check", "heart.hex").err
    over = kitrobot("deploy", "heart.hex", "--file", "heart.hex")
    assert (over.status, "is a file that is read" in over.err) == (1, True)


def test_a_program_for_the_v2_alone_says_why_and_what_takes_most(kitrobot, here):
    done = kitrobot(
        "deploy", EXAMPLES / "kit-rover" / "kit-rover.krt", "--board", "cutebot", "--file", "r.hex", "--json"
    )
    assert done.status == 0
    assert list(json.loads(done.out)["left_out"]) == ["the micro:bit of 2016"]
    assert "it is not for the micro:bit of 2016: the program needs" in done.err
    assert "the drivers that take most are" in done.err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("heart", "--file", "heart.bin"), "let it end in `.hex`"),
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
    assert list(here.glob("*.hex")) == []


def test_a_conversion_into_a_hex_names_the_command_that_makes_one(kitrobot, here):
    done = kitrobot("convert", HEART, "heart.hex")
    assert (done.status, "--file heart.hex" in done.err) == (1, True)
