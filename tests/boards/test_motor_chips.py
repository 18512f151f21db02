"""Motors behind a chip on an I2C bus: what the bus carries, and what happens when the chip does not answer."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.news import Fault
from tests.boards.kit_steps import results_of
from tests.boards.modern import ModernBoard, onboard_files
from tests.boards.test_modern_robot import deploy_by_command, pins_told
from tests.effort import cases
from tests.patience import PATIENCE_S

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "drivers.md").read_text(encoding="utf-8")
ADDRESS = 96
WIRES = {
    "motors": "pca9685", "motors-address": str(ADDRESS), "sda": "0", "scl": "1", "frequency": "1526",
    "left-power": "8", "left-backward": "9", "left-forward": "10",
    "right-power": "13", "right-backward": "12", "right-forward": "11",
}  # fmt: skip
"""As Adafruit's motor boards are wired: each motor has three channels of the chip, behind which is a TB6612."""

ALL_OFF = (0xFD, b"\x10")
SET_UP = [ALL_OFF, (0x00, b"\x30"), (0xFE, b"\x03"), (0x01, b"\x04"), (0x00, b"\x20")]
OFF, ON = b"\0\0\0\x10", b"\0\x10\0\0"


def channel(number: int, data: bytes) -> tuple[int, bytes]:
    """Four registers of a channel, by the data sheet of the PCA9685: on and off, each its lower byte first."""
    return 0x06 + 4 * number, data


def wave(percent: int) -> bytes:
    """On for that part of 4096 steps."""
    return b"\0\0" + (percent * 65535 // 100 * 4096 // 65535).to_bytes(2, "little")


ANOTHER = PAGE[PAGE.index("class Speeds:") : PAGE.index("```", PAGE.index("class Speeds:"))]
"""A kind of chip that the page adds."""

BEFORE = f"""
from kitrobot_onboard.drivers.machine.shared import buses, motor_chips
motor_chips.chips.clear()
buses.buses.clear()
machine.registers.clear()
machine.registers[{ADDRESS}] = {{}}
WIRES = {WIRES!r}
def bus():
    return [entry[1:] for entry in taken() if entry[0] == {ADDRESS}]
"""
STEPS = {
    "three channels": """
drive, turn = make("machine.drive", **WIRES), make("machine.turn", **WIRES)
result = [bus()]
for part, procedure, arguments in (
    (drive, "Advance", [50]), (drive, "Advance", [100]), (drive, "Reverse", [100]), (drive, "Stop", []),
    (turn, "Turn", [40]), (turn, "Turn", [40]), (turn, "Stop", []), (drive, "Advance", [50]),
):
    part.do(procedure, arguments)
    result.append(bus())
drive.stop()
result.append(bus())
turn.stop()
result.append(bus())
drive.do("Advance", [50])
result.append(bus())
""",
    "two channels": """
wires = {name: WIRES[name] for name in WIRES if name not in ("left-power", "right-power", "motors-address")}
machine.registers[64] = {}
left, right = (make("machine.wheel", side=side, **wires) for side in ("left", "right"))
taken()
left.do("Forward", [50])
right.do("Backward", [1])
left.do("Backward", [50])
result = taken()
""",
    "a direction": """
wires = {name: WIRES[name] for name in WIRES if name not in ("left-power", "right-power")}
drive = make("machine.drive", bridge="direction", **wires)
bus()
result = []
for procedure, arguments in (("Advance", [50]), ("Reverse", [50])):
    drive.do(procedure, arguments)
    result.append(bus())
""",
    "frequencies": """
result = []
for hertz in ("24", "50", "1000", "1526"):
    motor_chips.chips.clear()
    make("machine.drive", **dict(WIRES, frequency=hertz))
    result += [data for register, data in bus() if register == 0xFE]
""",
    "road": """
levels.clear()
road = make("machine.road", **dict(WIRES, **{"left-eye": "16", "right-eye": "17"}))
road.do("Advance", [50])
bus()
levels[16] = 1
road.tend()
road.tend()
result = bus()
""",
    "not there": """
machine.registers.clear()
result = []
for name in ("drive", "turn"):
    try:
        make("machine." + name, **WIRES)
    except OSError as error:
        result.append(repr(error))
machine.registers[96] = {}
make("machine.drive", **WIRES)
result.append(bus())
""",
    "lost": """
drive, turn = make("machine.drive", **WIRES), make("machine.turn", **WIRES)
drive.do("Advance", [50])
machine.registers.clear()
result = []
for do in (lambda: drive.do("Advance", [60]), drive.stop, turn.stop):
    try:
        do()
    except OSError as error:
        result.append(repr(error))
bus()
machine.registers[96] = {}
drive.stop()
drive.do("Advance", [60])
result.append(bus())
""",
    "another chip": f"""
exec({ANOTHER!r}, motor_chips.__dict__)
machine.registers[20] = {{}}
drive = make("machine.drive", **{{"motors": "speeds", "sda": "0", "scl": "1", "left-forward": "1", "right-forward": "0",
    "left-flipped": "yes"}})
taken()
result = []
for procedure, arguments in (("Advance", [50]), ("Stop", [])):
    drive.do(procedure, arguments)
    result.append(taken())
drive.stop()
result.append(taken())
""",
    "one message lost": """
drive = make("machine.drive", **WIRES)
bus()
class Bus:
    spoilt = 1
    def writeto_mem(self, address, register, data):
        if self.spoilt:
            self.spoilt -= 1
            raise OSError(5)
        machine.I2C(0).writeto_mem(address, register, data)
drive.base.turns.bus = Bus()
drive.do("Advance", [50])
result = bus()
""",
}


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    """The result of each of the steps."""
    return results_of({name: BEFORE + text for name, text in STEPS.items()})


def test_the_chip_is_set_up_and_told_forward_backward_and_stop_in_as_few_messages_as_may_be(
    found: dict[str, Any],
) -> None:
    made, half, full, back, still, turns, again, ends, ahead, *_ = found["three channels"]
    assert made == SET_UP
    assert half == [channel(10, ON), channel(8, wave(50)), channel(11, ON), channel(13, wave(50))]
    assert full == [channel(8, ON), channel(13, ON)]
    assert back == [channel(10, OFF), channel(9, ON), channel(11, OFF), channel(12, ON)]
    assert {data for _, data in still} == {OFF}
    assert {register for register, _ in still} == {channel(number, OFF)[0] for number in (8, 9, 12, 13)}
    assert turns == [channel(9, ON), channel(8, wave(40)), channel(11, ON), channel(13, wave(40))]
    assert again == []
    assert {data for _, data in ends} == {OFF}
    assert ahead == half


def test_stop_is_one_message_for_all_channels_and_sets_the_chip_up_anew(found: dict[str, Any]) -> None:
    *_, half, stopped, stopped_again, ahead = found["three channels"]
    assert stopped == stopped_again == SET_UP
    assert ahead == half


def test_a_motor_with_two_channels_has_a_wave_at_one_of_them_and_never_both_on(found: dict[str, Any]) -> None:
    assert found["two channels"] == [
        (64, *channel(10, wave(50))),
        (64, *channel(12, wave(1))),
        *[(64, *channel(10, OFF)), (64, *channel(9, wave(50)))],
    ]


def test_a_motor_with_a_direction_has_a_wave_and_a_level(found: dict[str, Any]) -> None:
    assert found["a direction"] == [
        [channel(10, wave(50)), channel(11, wave(50))],
        [channel(9, ON), channel(12, ON)],
    ]


def test_the_frequency_is_a_divider_of_the_clock_of_the_chip(found: dict[str, Any]) -> None:
    dividers = [data[0] for data in found["frequencies"]]
    assert dividers == [253, 121, 5, 3]
    for divider, hertz in zip(dividers, (24, 50, 1000, 1526), strict=True):
        assert 25_000_000 / 4096 / (divider + 1) == pytest.approx(hertz, rel=0.02)


def test_a_robot_on_a_road_tells_the_chip_only_what_changes(found: dict[str, Any]) -> None:
    assert found["road"] == [channel(8, wave(20))]


def test_a_chip_that_is_not_there_is_an_error_of_each_part_and_works_when_it_is_there(found: dict[str, Any]) -> None:
    *errors, told = found["not there"]
    assert errors == [f"OSError('no answer at address {ADDRESS}: not plugged in?',)"] * 2
    assert told == SET_UP


def test_a_chip_that_is_lost_is_an_error_of_who_speaks_to_it_and_is_set_up_when_it_is_back(
    found: dict[str, Any],
) -> None:
    *errors, told = found["lost"]
    assert errors == [f"OSError('no answer at address {ADDRESS}: not plugged in?',)"] * 3
    assert told == [*SET_UP, channel(10, ON), channel(8, wave(60)), channel(11, ON), channel(13, wave(60))]


def test_a_message_that_is_disturbed_is_said_once_more(found: dict[str, Any]) -> None:
    assert found["one message lost"] == found["three channels"][1]


def test_the_chip_that_the_page_adds_turns_motors(found: dict[str, Any]) -> None:
    ahead, still, stopped = found["another chip"]
    assert ahead == [(20, 1, bytes([256 - 63])), (20, 0, bytes([63]))]
    assert still == [(20, 1, b"\0"), (20, 0, b"\0")]
    assert {data for _, _, data in stopped} == {b"\0"}


# A whole robot, sent by the command that a user types.

SETTINGS = " ".join(f'{name}="{value}"' for name, value in WIRES.items())
KIT = f"""<board name="chip" version="1">
  <actuator device="drive turn wheel" {SETTINGS} rate="180"/>
  <actuator device="lamp" driver="hot"/>
</board>
"""
HOT = """
class Lamp:
    def do(self, procedure, arguments):
        raise ValueError("too hot")
    def stop(self):
        pass


def make(settings):
    return Lamp()
"""
"""A lamp that fails when it is lit."""

FRAIL = f"""
registers[{ADDRESS}] = {{}}
_say = I2C.writeto_mem
missed = 0
def say(self, address, register, data):
    global missed
    if register == 42 and data == bytes((0, 16, 0, 0)):  # the left wheel backward: the plug comes out
        registers.clear()
        missed = MISSED
    if missed:
        missed -= 1
        if not missed:
            registers[{ADDRESS}] = {{}}
        raise OSError(5)
    _say(self, address, register, data)
I2C.writeto_mem = say
"""
"""A chip that answers until the left wheel is to turn backward, at channel 9, and then not to MISSED messages."""

MACHINE = onboard_files()["machine.py"]


def sent(board: ModernBoard, folder: Path, program: str, status: int = 0) -> dict[str, Any]:
    """What `kitrobot deploy` says of a program on a kit with the motors' chip."""
    (folder / "chip.board.xml").write_text(KIT, encoding="utf-8")
    (folder / "hot.driver.py").write_text(HOT, encoding="utf-8")
    path = folder / "go.lll"
    path.write_text(program + "\n", encoding="utf-8")
    kit = str(folder / "chip.board.xml")
    return deploy_by_command(path, board, "--robot", "mini-robot", "--board", kit, status=status)


def told(board: ModernBoard) -> list[tuple[int, bytes]]:
    """What the chip was told since the program came."""
    return [(int(what), data) for name, what, data in pins_told(board) if name == ADDRESS]


def fault_of(board: Board) -> Fault:
    while not isinstance(news := board.news(1), Fault):
        pass
    return news


def moves(messages: list[tuple[int, bytes]]) -> bool:
    """Whether a motor had power."""
    return any(message in messages for message in (channel(8, wave(50)), channel(13, wave(50))))


@pytest.fixture(scope="module")
def plugged() -> Iterator[ModernBoard]:
    """A board with the chip on its bus."""
    with ModernBoard({"lib/machine.py": MACHINE + f"\nregisters[{ADDRESS}] = {{}}\n".encode()}) as found:
        yield found


@pytest.mark.parametrize("end", ["STOP", "a fault of another part", "the one who holds it falls silent"])
def test_both_motors_have_no_power_after(end: str, plugged: ModernBoard, tmp_path: Path) -> None:
    plugged.cut_power()
    then = "WAIT(20); Light.LightOn();" if end.startswith("a fault") else ""
    sent(plugged, tmp_path, f"Wheel.Advance(50); {then} WAIT(6000); Wheel.Stop(); Light.LightOff();")
    with connect(plugged.address, PATIENCE_S) as board:
        board.start(held=end.startswith("the one"))
        if end == "STOP":
            board.stop()
        else:
            board._held = False  # nobody speaks to it any more
            fault = fault_of(board)
            assert fault.number == (1 if end.startswith("a fault") else 6)
    messages = told(plugged)
    assert moves(messages) or end == "STOP"
    assert messages[-len(SET_UP) :] == SET_UP


def test_a_chip_that_is_not_there_stops_the_program_from_being_put_on_and_names_the_part(tmp_path: Path) -> None:
    with ModernBoard({"lib/machine.py": MACHINE}) as modern:
        said = sent(modern, tmp_path, "Wheel.Advance(50); WAIT(60);", status=1)
        assert f"Wheel: drive OSError('no answer at address {ADDRESS}: not plugged in?'" in said["error"]["message"]


@pytest.mark.parametrize("missed", cases([2], [1000]))
def test_a_chip_that_is_lost_on_the_way_is_a_fault_and_starts_again_when_it_is_back(
    missed: int, tmp_path: Path
) -> None:
    frail = FRAIL.replace("MISSED", str(missed)).encode()
    with ModernBoard({"lib/machine.py": MACHINE + frail}) as modern:
        sent(modern, tmp_path, "Wheel.Advance(50); WAIT(20); Wheel.Reverse(50); WAIT(6000);")
        with connect(modern.address, PATIENCE_S) as board:
            board.start()
            fault = fault_of(board)
            assert (fault.number, fault.instruction is not None) == (1, True)
            assert fault.text == f"a1 OSError('no answer at address {ADDRESS}: not plugged in?',)"
            assert board.greet().state_name == "fault"
            if missed == 2:
                board.start()
                board.stop()
            else:
                with pytest.raises(BoardError):
                    board.start()
        assert missed > 2 or told(modern)[-len(SET_UP) :] == SET_UP
