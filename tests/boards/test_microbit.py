"""The micro:bit of 2016, its real firmware in QEMU.

Small programs are sent to it, over a bad line too, and cut at any message; they start by themselves and do there, tick
by tick, what they do in `Machine`; what it cannot hold is refused with a sentence.
"""

from __future__ import annotations

import contextlib
import random
import re
import socket
from collections.abc import Iterator
from dataclasses import replace
from importlib.resources import files
from itertools import count
from pathlib import Path

import pytest

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.errors import BoardError, FullError, LineError, SilentError
from kitrobot.deploy.installation import boot_records
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.deploy.microbit_2016 import flash_loop
from kitrobot.deploy.microbit_2016.flash import Flash
from kitrobot.deploy.microbit_2016.flash_loop import loop_block
from kitrobot.deploy.minification.minifier import parsed, shortened
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.image.machine import Machine
from kitrobot.image.model import Image
from kitrobot.robots.program import BoardProgram
from kitrobot.workspace.robots import find_robot
from tests.boards.bench import PROGRAMS, STORES, bench_program, bench_robot
from tests.boards.hex_sections import image_2016
from tests.boards.proxy import Proxy, noise
from tests.boards.qemu import Emulated, booted, running
from tests.boards.test_deploy import put as put_program
from tests.boards.test_deploy import runs
from tests.boards.test_line import mpremote
from tests.boards.test_team import write_crew
from tests.boards.test_ticks import compared
from tests.boards.watching import called, watched
from tests.effort import THOROUGH, cases
from tests.patience import PATIENCE_S

pytestmark = pytest.mark.boards

TICKS = 400 if THOROUGH else 30
STEPS = 2000 if THOROUGH else 25
"""Ticks of each program that a host steps through, which takes a message or two each."""

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
HEART = EXAMPLES / "heart" / "heart.krt"
MAIN = "from kri import tick\nexec(open('run').read())\n"
"""First the tick, while there is room to compile it."""

RUN = """
cells = {cells!r}
threads = {threads!r}
pars = {pars!r}
out = {out!r}
code = open('code', 'rb').read()
f = open('inputs', 'rb')
while True:
    r = f.read({width})
    if not r:
        break
    for i in range({width}):
        cells[1 + i] = r[i]
    tick(code, cells, threads, pars, out, ())
    print(out, threads, cells[0])
print('done')
"""


@contextlib.contextmanager
def receiving(address: str) -> Iterator[Receiver]:
    """The receiver on a board, for as long as the line is open."""
    line = Line(address)
    try:
        receiver = Receiver(RawRepl(line))
        receiver.begin()
        yield receiver
    finally:
        line.close()


def put(address: str, content: bytes) -> None:
    with receiving(address) as receiver:
        receiver.write("data", content)


def restarted(line: Line) -> str:
    """What `main.py` prints."""
    line.write(b"\x03\x02")
    line.read_until(b">>> ", PATIENCE_S)
    line.write(b"\x04")
    return line.read_until(b">>> ", PATIENCE_S).decode(errors="replace").replace("\r\n", "\n")


def test_the_same_tick_gives_the_same_in_every_tick(microbit: Emulated, tmp_path: Path) -> None:
    interpreter = files("kitrobot_onboard").joinpath("interpreter.py").read_text(encoding="utf-8")
    with receiving(microbit.address) as receiver:
        receiver.write("kri.py", shortened(parsed(interpreter, "interpreter.py")).encode())
        receiver.write("main.py", MAIN.encode())
        for number, text in enumerate(PROGRAMS):
            image = Image.from_bytes(bench_program(tmp_path, text).file.image)
            machine = Machine(image, find_robot(str(tmp_path / "bench.robot.xml")))
            run = RUN.format(
                cells=machine.cells, threads=machine.threads, pars=machine.pars, out=machine.out, width=image.inputs
            )
            chance = random.Random(number)
            inputs, expected = b"", []
            for _ in range(TICKS):
                values = [chance.randrange(101) if chance.random() < 0.5 else 1 for _ in range(image.inputs)]
                inputs += bytes(values)
                machine.cells[1 : 1 + image.inputs] = values
                machine.tick()
                expected.append(f"{list(machine.out)} {list(machine.threads)} {machine.cells[0]}")
            if number:
                receiver.begin()
            for name, content in (("run", run.encode()), ("code", bytes(machine.code)), ("inputs", inputs)):
                receiver.write(name, content)
            receiver.end()
            printed = restarted(receiver.line)
            assert re.findall(r"^\[.*$", printed, re.M) == expected, printed[-500:]


def test_files_arrive_whole_over_a_line_that_loses_changes_and_adds_bytes(microbit: Emulated) -> None:
    content = bytes(random.Random(3).randrange(256) for _ in range(1500))
    for seed in range(20):
        with Proxy(microbit.port, disturb=noise(seed, 0.001)) as proxy, contextlib.suppress(SilentError):
            put(proxy.address, content)
            break
    with receiving(microbit.address) as receiver:
        assert receiver.read("data") == content


def test_a_line_that_is_cut_at_any_message_needs_only_another_try(microbit: Emulated) -> None:
    content = bytes(random.Random(4).randrange(256) for _ in range(400))
    cut = messages = 0
    while cut <= messages:
        with Proxy(microbit.port, cut_after=cut) as proxy, contextlib.suppress(KitRobotError):
            put(proxy.address, content)
        with Proxy(microbit.port) as proxy:
            put(proxy.address, content)
            messages = proxy.messages
        cut += 1 if THOROUGH else 100
    with receiving(microbit.address) as receiver:
        assert receiver.read("data") == content


def place(board: Emulated, program: BoardProgram) -> None:
    """Sends a program; where there is no room for two, in the place of the one before."""
    try:
        deploy(board.address, program.file.to_bytes(), program.package)
    except FullError:
        deploy(board.address, program.file.to_bytes(), program.package, fresh=True)


def test_the_heart_is_sent_started_and_stopped_with_the_commands_of_a_user(used_microbit: Emulated) -> None:
    microbit = used_microbit
    to = ("--to", microbit.address)
    mine = bytes(range(90))
    put(microbit.address, mine)
    sent = called("deploy", str(HEART), *to)
    assert sent.returncode == 0, sent.stdout + sent.stderr
    assert "bytes of memory are left" in " ".join(sent.stdout.split())
    for word, said in (("stop", "stopped"), ("start", "started"), ("log", "no fault")):
        done = called(word, *to)
        assert done.returncode == 0, done.stderr
        assert said in done.stdout + done.stderr
    watched(*to, "--mission", str(HEART), enough=lambda heard: "v2" in str(heard[-1].get("ran")))
    again = called("deploy", str(HEART), *to)
    assert "nothing to send" in again.stdout
    microbit.cut_power()
    with connect(microbit.address, PATIENCE_S) as board:
        assert board.hello.state == 2, "it starts by itself"
        first = board.hello.tick
        assert any(board.greet().tick > first for _ in range(100)), "its program goes on"
    mpremote_enters_it(microbit)
    another_example_runs_on_it_and_a_file_of_the_user_is_left_alone(microbit, mine)


def mpremote_enters_it(microbit: Emulated) -> None:
    assert mpremote(microbit.address, "resume", "exec", "print(6*7)").strip() == "42"


def another_example_runs_on_it_and_a_file_of_the_user_is_left_alone(microbit: Emulated, mine: bytes) -> None:
    program = load_board_program(EXAMPLES / "dice" / "dice.krt")
    place(microbit, program)
    compared(microbit.address, program, find_robot("microbit"), seed=13, ticks=STEPS)
    with receiving(microbit.address) as receiver:
        assert receiver.read("data") == mine


@pytest.mark.thorough("test_three_hundred_instructions_fit_and_give_the_same_commands_in_every_tick, for one program")
@pytest.mark.parametrize("text", [PROGRAMS[0], PROGRAMS[1], PROGRAMS[3]])
def test_a_deployed_program_gives_the_same_commands_in_every_tick(
    used_microbit: Emulated, tmp_path: Path, text: str
) -> None:
    program = bench_program(tmp_path, text)
    place(used_microbit, program)
    compared(used_microbit.address, program, bench_robot(tmp_path), seed=11, ticks=STEPS)


def test_three_hundred_instructions_fit_and_give_the_same_commands_in_every_tick(
    used_microbit: Emulated, tmp_path: Path
) -> None:
    program = bench_program(tmp_path, PROGRAMS[0] * 25)
    assert Image.from_bytes(program.file.image).instructions > 300
    place(used_microbit, program)
    compared(used_microbit.address, program, bench_robot(tmp_path), seed=12, ticks=STEPS)


PARTS = 4 if THOROUGH else 1
"""The messages at which a deploy is cut are shared out, so that the parts can run side by side."""


@pytest.mark.parametrize("part", range(PARTS))
def test_a_deploy_that_is_cut_at_any_message_leaves_what_was_there(
    used_microbit: Emulated, tmp_path: Path, part: int
) -> None:
    old, new = bench_program(tmp_path / "old", PROGRAMS[0]), bench_program(tmp_path / "new", PROGRAMS[1])
    board = used_microbit
    for cut in count(1 + part, PARTS) if THOROUGH else (60,):
        place(board, old)
        with Proxy(board.port, cut_after=cut) as wire, contextlib.suppress(LineError):
            put_program(wire.address, new)
        if wire.messages < cut:
            break
        board.cut_power()
        found = runs(board.address)
        assert old.is_called(found) or new.is_called(found), f"cut after message {cut}"
        assert new.is_called(put_program(board.address, new).program)
        assert new.is_called(runs(board.address))
    assert THOROUGH or wire.messages == cut, "a message is cut that a deploy has"


@pytest.mark.thorough(
    "test_deploy::test_a_first_deploy_that_is_cut_is_mended_by_the_next_one, on a current MicroPython"
)
def test_the_first_deploy_of_all_may_be_cut_at_any_message(tmp_path: Path) -> None:
    program = bench_program(tmp_path, PROGRAMS[0])
    for cut in count(10, 10):
        with running() as board:
            with Proxy(board.port, cut_after=cut) as wire, contextlib.suppress(LineError):
                put_program(wire.address, program)
            was_cut = wire.messages == cut
            board.cut_power()
            assert program.is_called(put_program(board.address, program).program), f"cut after message {cut}"
            assert program.is_called(runs(board.address))
        if not was_cut:
            break


@pytest.mark.thorough("test_the_heart_is_sent_started_and_stopped_with_the_commands_of_a_user, with two examples")
def test_the_examples_for_it_run_on_it_one_after_the_other_and_leave_files_of_the_user_alone(
    used_microbit: Emulated,
) -> None:
    microbit = used_microbit
    mine = bytes(range(90))
    last = 9
    for turn in range(last + 1):
        program = load_board_program(EXAMPLES / (name := ("heart", "reaction", "dice")[turn % 3]) / f"{name}.krt")
        # The first makes room for the file; the last removes what is KitRobot's alone.
        deploy(microbit.address, program.file.to_bytes(), program.package, fresh=turn in (0, last))
        assert program.is_called(runs(microbit.address))
        if turn == 0:
            put(microbit.address, mine)
        compared(microbit.address, program, find_robot("microbit"), seed=13, ticks=STEPS)
    with receiving(microbit.address) as receiver:
        assert receiver.read("data") == mine


@pytest.mark.thorough(
    "test_files_arrive_whole_over_a_line_that_loses_changes_and_adds_bytes; test_deploy sends programs so"
)
def test_a_program_arrives_over_a_line_that_loses_changes_and_adds_bytes(
    used_microbit: Emulated, tmp_path: Path
) -> None:
    program = bench_program(tmp_path, PROGRAMS[0])
    place(used_microbit, bench_program(tmp_path / "before", PROGRAMS[1]))
    for seed in range(20):
        with Proxy(used_microbit.port, disturb=noise(seed, 0.001)) as proxy, contextlib.suppress(SilentError):
            put_program(proxy.address, program)
            break
    assert program.is_called(runs(used_microbit.address))


@pytest.mark.thorough(
    "test_microbit_2016.test_what_is_too_large_is_refused_before_anything_on_the_board_changes;"
    " deploy/test_room_of_2016.py: flash without room is said before anything is removed or written"
)
def test_a_program_that_does_not_fit_is_refused_and_the_old_one_goes_on(
    used_microbit: Emulated, tmp_path: Path
) -> None:
    small = bench_program(tmp_path, PROGRAMS[0])
    place(used_microbit, small)
    with receiving(used_microbit.address) as receiver:
        flash = Flash.of(receiver)
        assert flash is not None
        receiver.write("data", bytes(flash.free - 2000))
    with pytest.raises(FullError, match="flash"):
        put_program(used_microbit.address, bench_program(tmp_path, PROGRAMS[0] * 40))
    assert small.is_called(runs(used_microbit.address))
    with pytest.raises(BoardError, match="memory"):
        put_program(used_microbit.address, bench_program(tmp_path, PROGRAMS[0] * 150))
    assert small.is_called(runs(used_microbit.address))


RAISES = STORES.format(mark="one").replace(
    "        pass\n\n    def done", "        raise OSError(arguments[0])\n\n    def done"
)
NEVER = STORES.format(mark="one").replace("return True", "return False")


@pytest.mark.parametrize(
    ("driver", "text", "number", "said"),
    cases([(RAISES, "Motor.Turn(7); ", 1, "7")], [(NEVER, "Motor.Turn(7); WAIT(9000); ", 2, "not done")]),
)
def test_a_device_that_fails_stops_the_robot_and_is_told_with_its_instruction(
    used_microbit: Emulated, tmp_path: Path, driver: str, text: str, number: int, said: str
) -> None:
    program = bench_program(tmp_path, f"WAIT(3); {text}")
    (tmp_path / "stores.driver.py").write_text(driver, encoding="utf-8")
    robot = (tmp_path / "bench.robot.xml").read_text(encoding="utf-8")
    (tmp_path / "bench.robot.xml").write_text(robot.replace('pin="1"', 'pin="1" limit="0.2"'), encoding="utf-8")
    program = load_board_program(tmp_path / "program.lll", robot=str(tmp_path / "bench.robot.xml"))
    place(used_microbit, program)
    with connect(used_microbit.address, PATIENCE_S) as board:
        fault = next((found for _ in range(100) if (found := board.last_fault()) is not None), None)
        assert fault is not None
        assert (fault.number, said in fault.text) == (number, True)
        assert fault.instruction is not None
        assert Image.from_bytes(program.file.image).code[4 * fault.instruction] == 15, "ACT"
        assert board.greet().state == 4


TILT_AND_SOUND = (
    "[TiltX.IsLeft()](Display.Number(1); )!(Display.Number(2); ); [TiltY.IsForward()](Display.Number(3); )!();"
    " Music.Tone(440, 200); WAIT(2); Music.Stop();"
)
PINS = (
    "Pin1.Write(1); WAIT(1); Pin1.Analog(500); WAIT(1); Pin2.Servo(90); WAIT(1); Pin1.Write(0);"
    " [Pin1.IsHigh()](Display.Pixel(1, 2, 9); )!(Display.Clear(); );"
)
CHANCE = "[Random.LessThan(50)](Display.Number(Dice.Value()); )!(Display.Scroll(12); );"
KEYS_AND_SHAKING = (
    "[ButtonA.IsPressed()](Display.Number(4); )!();"
    " [Shake.IsShaken()](Display.Number(Dice.Value()); )!(Display.Clear(); );"
)
MELODY = "Music.Play(1); WAIT(2);"
TOGETHER = [TILT_AND_SOUND + CHANCE]
"""Pins, keys and shaking: test_a_program_that_fills_the_flash_is_sent_afresh."""
MUSIC_BY_KEY = (
    "[ButtonA.IsPressed()](Music.Play(1); )!(Music.Stop(); );"
    " [Shake.IsShaken()](Display.Number(Dice.Value()); )!(Display.Clear(); );"
)
APART = [MELODY, PINS + KEYS_AND_SHAKING, TILT_AND_SOUND, PINS, CHANCE, MUSIC_BY_KEY]
USES = cases(TOGETHER, APART)


@pytest.mark.parametrize("text", USES)
def test_all_devices_of_it_work_there(tmp_path: Path, text: str) -> None:
    path = tmp_path / "devices.lll"
    path.write_text(f"*[Run.IsTrue()]({text} WAIT(1); );\n", encoding="utf-8")
    program = load_board_program(path, robot="microbit")
    with booted(firmware=image_2016(program, tmp_path)) as board:
        compared(board.address, program, find_robot("microbit"), seed=14, ticks=STEPS)
        with connect(board.address, PATIENCE_S) as link:
            assert link.last_fault() is None


@pytest.mark.thorough(
    "deploy/test_flash.py: pages without anything in them are erased for a block, files and blocks stay whole, freed"
    " room counts; test_three_hundred_instructions_fit_and_give_the_same_commands_in_every_tick"
)
def test_a_program_that_fills_the_flash_is_sent_afresh_whatever_lies_freed_beside_its_loop(
    used_microbit: Emulated, tmp_path: Path
) -> None:
    path = tmp_path / "devices.lll"
    path.write_text(f"*[Run.IsTrue()]({PINS + KEYS_AND_SHAKING} WAIT(1); );\n", encoding="utf-8")
    program = load_board_program(path, robot="microbit")
    with receiving(used_microbit.address) as receiver:
        for name in receiver.names():
            if name != boot_records.MAIN:
                receiver.remove(name)
        flash = Flash.of(receiver)
        assert flash is not None
        for place, first in enumerate(flash.area.firsts):
            if first == 255:  # unused; now as if a file had been there and was removed
                receiver.write_words(flash.area.address(place), bytes((0, 255, 255, 255)))
    deploy(used_microbit.address, program.file.to_bytes(), program.package, fresh=True)
    compared(used_microbit.address, program, find_robot("microbit"), seed=14, ticks=STEPS)
    with connect(used_microbit.address, PATIENCE_S) as board:
        assert board.last_fault() is None


def test_it_does_the_ticks_of_a_member_and_waits_when_another_of_its_team_has_no_program(
    used_microbit: Emulated, tmp_path: Path
) -> None:
    with socket.create_server(("127.0.0.1", 0)) as listener:
        nobody = f"socket://127.0.0.1:{listener.getsockname()[1]}"
    boards = ("--board", f"bit-1={nobody}", "--board", f"bit-2={used_microbit.address}")
    sending = called("deploy", str(write_crew(tmp_path)), "--team", *boards)
    said = " ".join(sending.stderr.split())
    assert sending.returncode == 1
    assert "no robot of the team is started; mend what is said above of bit-1" in said
    assert "the new program is already on the boards of these, where it waits: bit-2" in said
    with connect(used_microbit.address, PATIENCE_S) as board:
        assert board.hello.free > 2200
        board.begin_member()
        assert board.member_tick({}), "the number of its thread is no longer 0"
        assert board.greet().tick == 1
        board.stop()
        assert board.last_fault() is None


@pytest.mark.thorough(
    "deploy/test_flash.py and test_room_of_2016.py: no room is said before anything changes, the old is freed"
)
def test_another_kitrobot_finds_no_room_beside_the_old_one_and_takes_its_place_when_told_to(
    used_microbit: Emulated, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    microbit = used_microbit
    old, new = bench_program(tmp_path / "old", PROGRAMS[0]), bench_program(tmp_path / "new", PROGRAMS[1])
    place(microbit, old)
    there = runs(microbit.address)
    other = replace(loop_block(), name="kr01234567")
    monkeypatch.setattr(flash_loop, "loop_block", lambda: other)
    with pytest.raises(FullError, match="flash"):
        put_program(microbit.address, new)
    assert runs(microbit.address) == there
    done = deploy(microbit.address, new.file.to_bytes(), new.package, fresh=True)
    assert runs(microbit.address) == done.program != there
