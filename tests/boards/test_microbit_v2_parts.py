"""What a micro:bit V2 has and a board of 2016 has not: its loudspeaker, its touch logo, its microphone.

There is no V2: the files are read out of the V2's section of a hex by a library that is not ours, and run on a current
MicroPython with a module `microbit` of our own, whose logo, microphone and music remember and say what a test wants.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import micropython_microbit_fs
import pytest

from kitrobot.boards.bench import PartKey, bench_of
from kitrobot.boards.bench_loader import load_parts
from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.microbit_2016.board_fit import refuse_on_2016
from kitrobot.deploy.microbit_hex.board_hex import make_board_hex
from kitrobot.deploy.microbit_hex.bundled_firmware import V1, V2
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Category
from kitrobot.robots.program import BoardProgram
from tests.boards.hex_sections import section
from tests.boards.kit_steps import results_of
from tests.boards.modern import ModernBoard, greet_until
from tests.boards.qemu import Emulated
from tests.boards.test_microbit_v2 import board, goes_on
from tests.boards.test_modern_robot import pins_told
from tests.patience import PATIENCE_S

PROGRAM = """*[Logo.IsReleased()]( WAIT(1); );
Music.Tone(880, 40);
*[Loudness.LessThan(129)]( WAIT(1); );
Music.{last};
"""
"""Waits for the logo, then for a noise."""

SENSED = b"""
class Counted:
    asked = 0

    def is_touched(self):
        self.asked += 1
        return self.asked > 20

    def sound_level(self):
        self.asked += 1
        return 255 if self.asked > 60 else 128

pin_logo = Counted()
microphone = Counted()
"""
"""A logo that is touched, and a noise, after so many times that they were asked."""

STEPS = {
    "logo": """
logo = make("microbit.logo")
result = [logo()]
levels["logo"] = 1
result.append(logo())
""",
    "microphone": """
loudness = make("microbit.microphone")
result = []
for volts["microphone"] in (0, 128, 255):
    result.append(loudness())
""",
    "speaker": """
speaker = make("microbit.speaker")
made = taken()
speaker.do("Tone", [440, 30])
busy = speaker.done()
while not speaker.done(): pass
speaker.do("Play", [9])
speaker.do("Stop", [])
done = speaker.done()
speaker.do("Tone", [0, 0])
result = [made, busy, done, taken()]
""",
    "music": """
result = []
for settings in ({}, {"pin": "1"}):
    music = make("microbit.music", **settings)
    music.do("Play", [0])
    music.stop()
    result.append(taken())
""",
}


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    return results_of(STEPS)


def test_the_logo_says_whether_it_is_touched_and_the_microphone_how_loud_it_is(found: dict[str, Any]) -> None:
    assert found["logo"] == [False, True]
    assert found["microphone"] == [0, 128, 255]


def told(what: str, value: object, pin: int | None) -> tuple[str, str, object]:
    return "music", what, (value, pin)


def test_the_loudspeaker_plays_without_a_pin_and_is_quiet_before_each_sound(found: dict[str, Any]) -> None:
    made, busy, done, heard = found["speaker"]
    assert (made, busy, done) == ([("speaker", "on", None)], False, True)
    quiet = told("stop", None, None)
    assert heard == [
        *(quiet, told("pitch", (440, 30), None), quiet, told("play", "BIRTHDAY", None)),
        *(quiet, quiet),
    ]


def test_music_at_a_pin_is_what_it_was(found: dict[str, Any]) -> None:
    assert found["music"] == [
        [told("stop", None, pin), told("play", "POWER_UP", pin), told("stop", None, pin)] for pin in (0, 1)
    ]


def program(folder: Path, last: str = "Play(2)", kit: str | None = "microbit-v2") -> BoardProgram:
    path = folder / "clap.lll"
    path.write_text(PROGRAM.format(last=last), encoding="utf-8")
    return load_board_program(path, robot="microbit", kit=kit)


def running(made: BoardProgram) -> ModernBoard:
    """A V2 whose flash has what another library reads out of its section of the hex."""
    files = {one.name: one.content for one in micropython_microbit_fs.get_files(section(made, V2))}
    return board("nRF52833", files=files, more=SENSED)


def sounds(v2: ModernBoard) -> list[tuple[str, Any]]:
    """What was to be heard, without repeated silence."""
    heard = [(what, value) for name, what, value in pins_told(v2) if name == "music"]
    return [one for number, one in enumerate(heard) if number == 0 or one != heard[number - 1]]


QUIET = ("stop", (None, None))
BEEP = ("pitch", ((880, 40), None))


def test_a_hex_of_a_v2_waits_for_the_logo_and_for_a_noise_and_is_quiet_at_its_end(tmp_path: Path) -> None:
    made = program(tmp_path)
    with running(made) as v2:
        with connect(v2.address, PATIENCE_S) as link:
            assert link.hello.program in made.called
            greet_until(link, lambda hello: hello.state == 3)
        assert sounds(v2) == [QUIET, BEEP, QUIET, ("play", ("JUMP_UP", None)), QUIET]


@pytest.mark.parametrize("kit", ["microbit-v2", None])
def test_nothing_sounds_after_stop(tmp_path: Path, kit: str | None) -> None:
    made = program(tmp_path, "Tone(440, 10000)", kit)
    with running(made) as v2:
        with connect(v2.address, PATIENCE_S) as link:
            goes_on(link)
            greet_until(link, lambda hello: hello.tick > 70)
            link.stop()
            assert link.last_fault() is None
        pin = None if kit is not None else 0
        assert sounds(v2)[-2:] == [("pitch", ((440, 10000), pin)), ("stop", (None, pin))]


def test_the_hex_is_for_the_v2_alone_and_says_which_parts_the_other_lacks(tmp_path: Path) -> None:
    made = program(tmp_path, kit=None)
    hex_file = make_board_hex(made.file, made.package, made.needs)
    assert hex_file.boards == (V2,)
    assert hex_file.left_out[V1].message == "only a micro:bit V2 has what the program uses: `Logo`, `Loudness`"
    assert hex_file.left_out[V1].help == "take a micro:bit V2, or leave these parts out of the program"


def test_the_kit_of_a_v2_is_refused_on_a_board_of_2016_whatever_the_program_uses() -> None:
    made = load_board_program(Path("heart"), kit="microbit-v2")
    hex_file = make_board_hex(made.file, made.package, made.needs)
    assert hex_file.boards == (V2,)
    assert "the kit `microbit-v2` is for a micro:bit V2, and this board is one of 2016" in hex_file.left_out[V1].message
    plain = load_board_program(Path("heart"))
    assert make_board_hex(plain.file, plain.package, plain.needs).boards == (V1, V2)


@pytest.mark.boards
def test_a_board_of_2016_keeps_its_program_when_it_is_sent_what_it_lacks(
    used_microbit: Emulated, tmp_path: Path
) -> None:
    made = program(tmp_path, kit=None)
    with connect(used_microbit.address, PATIENCE_S) as link:
        before = link.hello.program
    with pytest.raises(BoardError, match="only a micro:bit V2 has what the program uses"):
        deploy(used_microbit.address, made.file.to_bytes(), made.package)
    with connect(used_microbit.address, PATIENCE_S) as link:
        assert link.hello.program == before


def test_on_a_board_of_2016_the_other_parts_are_tried_by_hand() -> None:
    bench = bench_of(load_catalogue().robots["microbit"], None)
    broken: dict[PartKey, KitRobotError] = {}

    def send(made: BoardProgram, fresh: bool) -> None:
        refuse_on_2016(made.file, made.package, made.needs)

    parts, _ = load_parts(bench, (Category.ACTUATOR, "Display"), broken, send)
    assert broken.keys() == {(Category.SENSOR, "Logo"), (Category.SENSOR, "Loudness")}
    message = broken[Category.SENSOR, "Loudness"].message
    assert message == "`Loudness` does not start: only a micro:bit V2 has what the program uses: `Loudness`"
    assert (Category.SENSOR, "ButtonA") in parts
