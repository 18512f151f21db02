"""Parts tried by hand and kits measured, on boards: by the commands a user types."""

from __future__ import annotations

import io
import json
import os
import pty
import re
import select
import sys
import threading
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from kitrobot.boards import bench_run
from kitrobot.boards.bench import Bench, PartKey, bench_of
from kitrobot.boards.bench_loader import PartError, load_parts
from kitrobot.boards.bench_run import BenchRun
from kitrobot.boards.calibration import bench_robot
from kitrobot.cli.app import main
from kitrobot.deploy.errors import FullError, LineError, NoMemoryError
from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.news import Fault
from kitrobot.primitives.catalogue import SHIPPED, load_catalogue
from kitrobot.primitives.kit_xml import read_kit
from kitrobot.robots.program import BoardProgram
from kitrobot.robots.session import RobotSession
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.kit_files import kit_named
from tests.boards.modern import ModernBoard, onboard_files
from tests.boards.qemu import Emulated
from tests.boards.test_modern_robot import pins_told
from tests.patience import PATIENCE_S
from tools.microbit_kits import small_kits

MOTORS = (2, 3, 4, 5)
MOMENT = ("--json", "--seconds", "0.7")
LEFT_OUT = ["Pin0", "ButtonB", "Shake", "TiltY", "Random"]
"""The micro:bit has each of these a second time, or its like: without them two programs do for all its parts."""
UNPLUGGED = onboard_files()["machine.py"] + b"\nwidths[15] = None\n"
"""A Pico whose range finder does not answer; a colour sensor is on no bus of these boards anyway."""


@pytest.fixture(scope="module")
def _kept_kit() -> Iterator[ModernBoard]:
    with ModernBoard({"lib/machine.py": UNPLUGGED}) as board:
        yield board


def command(*words: str, status: int = 0) -> tuple[str, str]:
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err), pytest.raises(SystemExit) as end:
        main(list(words))
    assert end.value.code == status, (out.getvalue(), err.getvalue())
    return out.getvalue(), err.getvalue()


def duties(board: ModernBoard) -> list[tuple[int, ...]]:
    """What the four motor pins gave one after the other, in percent."""
    now = dict.fromkeys(MOTORS, 0)
    found: list[tuple[int, ...]] = []
    for name, what, value in pins_told(board):
        if name in MOTORS and what == "duty":
            now[int(str(name))] = (value * 100 + 32767) // 65535
            found.append(tuple(now.values()))
    return found


def test_every_part_is_tried_and_what_is_not_plugged_in_fails_by_itself_alone(kit: ModernBoard) -> None:
    out, _ = command("bench", kit.address, "--board", "pico", "--robot", "mini-robot", *MOMENT, status=1)
    rows = {(row["call"] or row["part"]): row for row in json.loads(out)}
    broken = {name for name, row in rows.items() if not row["ok"]}
    assert broken == {"Captor", "Light"}
    assert "not plugged in" in rows["Captor"]["error"]["message"]
    assert rows["Button"]["values"]
    assert "pressed" in rows["Button"]["words"][0]
    assert len(rows["Button"]["words"]) == len(rows["Button"]["values"])
    assert rows["Wheel.Advance(40)"]["seen"] == "Both wheels turn forward."
    with connect(kit.address, PATIENCE_S) as board:
        assert board.hello.state_name == "ready"
    moves = duties(kit)
    for one in ((40, 0, 40, 0), (0, 40, 0, 40), (0, 40, 40, 0)):
        assert one in moves
    assert moves[-1] == (0, 0, 0, 0)


def test_a_part_moves_until_its_step_ends_and_everything_stands_when_the_line_is_lost(kit: ModernBoard) -> None:
    bench = bench_of(bench_robot(), kit_named("pico"))
    steps = {step.call or step.part.name: step for step in bench.steps}
    run = BenchRun(kit.address, bench)
    run.begin(steps["Wheel.Advance(40)"])
    assert run.watch(0.1) == []
    run.end()
    run.begin(steps["Button"])
    assert set(run.watch(0.2)) <= {0, 1}
    run.begin(steps["Captor"])
    with pytest.raises(PartError, match="`Captor` failed"):
        run.watch(30)
    run.begin(steps["Motor.Turn(40)"])
    run._hand.session.link.close()  # the cable is pulled
    with connect(kit.address, PATIENCE_S) as board:
        # Nobody speaks to it any more.
        while not isinstance(news := board.news(1), Fault):
            pass
    assert news.number == 6
    moves = duties(kit)
    assert (0, 40, 40, 0) in moves
    assert moves[-1] == (0, 0, 0, 0)


SLOW = b"""
import time
quick = Pin.value
def slow(self, *level):
    if self.name == 10:
        time.sleep_ms(90)
    return quick(self, *level)
Pin.value = slow
"""


def test_a_driver_that_takes_longer_than_a_tick_is_told_of_its_own_step_alone(tmp_path: Path) -> None:
    parts = '<actuator device="lamp" driver="led" pin="1"/><sensor device="button" driver="key" pin="10"/>'
    path = tmp_path / "two.board.xml"
    path.write_text(f'<board name="two" version="1">{parts}</board>')
    with ModernBoard({"lib/machine.py": onboard_files()["machine.py"] + SLOW}) as board:
        out, _ = command("bench", board.address, "--board", str(path), "--all", "--seconds", "2")
        (button,) = (line for line in out.splitlines() if line.startswith("Button"))
        assert "this part takes longer than a tick" in button
        kit, _ = read_kit(path.read_bytes(), "two")
        assert kit is not None
        bench = bench_of(bench_robot(), kit)
        lamp = next(step for step in bench.steps if step.call)
        (pressed,) = (step for step in bench.steps if step.part.name == "Button")
        with BenchRun(board.address, bench) as run:
            run.begin(pressed)
            while not run.is_slow:
                run.poll(0.1)
            run.end()
            run.begin(lamp)
            assert (run.late, run.is_slow) == (0, False)


def test_by_keys_a_step_goes_on_and_off_and_ctrl_c_stops_everything(kit: ModernBoard, tmp_path: Path) -> None:
    pid, terminal = pty.fork()
    if pid == 0:
        os.chdir(tmp_path)
        words = ["-m", "kitrobot", "bench", kit.address, "--board", "pico", "--robot", "mini-robot"]
        os.execv(sys.executable, [sys.executable, *words])
    said = b""

    def read_until(end: bytes) -> None:
        nonlocal said
        while end not in said:
            assert select.select([terminal], [], [], PATIENCE_S / 5)[0], said
            said += os.read(terminal, 4096)
        said = said.partition(end)[2]

    try:
        read_until(b"q leaves")
        read_until(b"Motor.Turn(40)")
        os.write(terminal, b"n\n")
        read_until(b"Wheel.Advance(40)")
        read_until(b"  on ")
        os.write(terminal, b"\n")
        read_until(b"  off")
        os.write(terminal, b"n\n")
        read_until(b"Wheel.Reverse(40)")
        read_until(b"  on ")
        os.write(terminal, b"\x03")
        with suppress(OSError):
            read_until(b"never said")
    finally:
        _, status = os.waitpid(pid, 0)
        os.close(terminal)
    assert os.waitstatus_to_exitcode(status) == 130
    moves = duties(kit)
    there, back = moves.index((40, 0, 40, 0)), moves.index((0, 40, 0, 40))
    assert (0, 0, 0, 0) in moves[there:back]
    assert moves[-1] == (0, 0, 0, 0)


def test_without_a_terminal_or_without_a_robot_it_says_what_to_say() -> None:
    _, err = command("bench", "socket://127.0.0.1:1", "--board", "pico", status=2)
    assert "--all" in err
    _, err = command("bench", "socket://127.0.0.1:1", "--all", status=2)
    assert "--robot" in err
    _, err = command("bench", "socket://127.0.0.1:1", "--all", "--board", "picoo", status=1)
    assert "pico" in err


def test_calibrating_asks_moves_and_writes_a_file_beside_that_takes_the_place_of_the_shipped_one(
    kit: ModernBoard, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    answers = ["", "left backward", "", "right up", "r f", "", "300", "", "much", "310,0", "", "300", "", "300"]
    monkeypatch.setattr("sys.stdin", io.StringIO("\n".join(answers) + "\n"))
    out, err = command("calibrate", kit.address, "--board", "pico", "--json")
    assert "say for example: left forward" in err
    assert "say a number" in err
    told: dict[str, Any] = json.loads(out)
    assert Path(told["file"]) == tmp_path / "pico.board.xml"
    made = kit_named("pico", tmp_path)
    turning = next(part.board.settings for part in made.parts if "turn" in part.devices)
    assert (turning["rate"], turning["left-flipped"]) == ("150", "yes")
    found = {one.devices[0]: dict(one.settings) for one in made.measured}
    assert found["drive"] == {"speed": "305", "noise": "2.3"}
    assert found["turn"] == {"rate": "150", "noise": "0"}
    moves = duties(kit)
    assert {(40, 0, 0, 0), (0, 0, 40, 0), (50, 0, 50, 0), (0, 50, 50, 0)} <= set(moves)
    assert moves[-1] == (0, 0, 0, 0)


class Thinking(io.StringIO):
    """Answers of a person who thinks until the robot has been spoken to so often that it would have given up."""

    HEARD = 6
    """Four times a second: more than the 0.8 s after which a robot that is held stops."""

    def __init__(self, answers: list[str]) -> None:
        super().__init__("".join(f"{one}\n" for one in answers))
        self.heard = threading.Semaphore(0)
        self.thinks = False
        self.answered_too_early = 0

    def readline(self, size: int | None = -1, /) -> str:  # type: ignore[override]
        for _ in range(self.HEARD if self.thinks else 0):
            self.answered_too_early += not self.heard.acquire(timeout=PATIENCE_S / 10)
        self.thinks = True  # from the second answer on: before the first nothing runs
        return super().readline()


def test_whoever_thinks_about_an_answer_keeps_the_robot_that_waits_for_it(
    kit: ModernBoard, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    answers = Thinking(["", "left forward", "", "right forward", "", "300", "", "300"])
    starts = 0
    start, ping = RobotSession.start, Board.ping

    def counted(session: RobotSession, held: bool = False) -> None:
        nonlocal starts
        starts += 1
        start(session, held)

    def heard(board: Board) -> None:
        ping(board)
        answers.heard.release()

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", answers)
    monkeypatch.setattr(RobotSession, "start", counted)
    monkeypatch.setattr(Board, "ping", heard)
    out, _ = command("calibrate", "--to", kit.address, "--board", "pico", "--times", "1", "--json")
    found = {row["setting"]: row["after"] for row in json.loads(out)["changes"]}
    assert found["measured speed"] == "300"
    assert answers.answered_too_early == 0
    assert starts == 1, "the robot gave up meanwhile, and its program was begun anew"


def test_answers_that_end_too_early_write_nothing_and_the_robot_stands(
    kit: ModernBoard, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", io.StringIO("\nleft forward\n"))
    _, err = command("calibrate", kit.address, "--board", "pico", status=1)
    assert "the answers ended" in err
    assert not list(tmp_path.glob("*.xml"))
    with connect(kit.address, PATIENCE_S) as board:
        assert board.hello.state_name == "ready"


def test_a_kit_that_needs_a_newer_micropython_is_refused_with_the_way_to_it(kit: ModernBoard, tmp_path: Path) -> None:
    parts = '<actuator device="lamp" driver="led" pin="1"/>'
    text = f'<board name="k" version="1" micropython="9.0" firmware="https://example.org/k">{parts}</board>'
    path = tmp_path / "k.board.xml"
    path.write_text(text)
    assert read_kit(text.encode(), "k")[0] is not None
    _, err = command("bench", kit.address, "--board", str(path), "--all", status=1)
    assert "MicroPython 1.29" in err
    assert "https://example.org/k" in err


def micro_bit_without(parts: list[str]) -> bytes:
    """The shipped micro:bit as a robot's file, without the parts of these names."""
    text = (SHIPPED / "microbit.robot.xml").read_text(encoding="utf-8")
    for part in parts:
        text, found = re.subn(rf'<(actuator|sensor) name="{part}".*?</\1>\s*', "", text, flags=re.DOTALL)
        assert found, part
    return text.encode()


def test_a_board_with_little_memory_gets_its_parts_in_as_many_programs_as_it_needs() -> None:
    bench = bench_of(load_catalogue().robots["microbit"], kit_named("microbit"))
    keys = {step.key for step in bench.steps}
    room = len(bench.program(bench.together(list(keys))).file.image) * 2 // 3
    sent: list[bool] = []

    def send(program: BoardProgram, fresh: bool) -> None:
        sent.append(fresh)
        if not fresh:
            raise FullError(Sentence("no room beside the old"))
        if len(program.file.image) > room:
            raise NoMemoryError(Sentence("too large"))

    loads: list[frozenset[PartKey]] = []
    for key in keys:
        if not any(key in load for load in loads):
            loads.append(load_parts(bench, key, {}, send)[0])
    assert frozenset().union(*loads) == keys
    assert 1 < len(loads) < len(keys)
    assert sent[:2] == [False, True], "what KitRobot put there before is removed first"
    room = 0
    with pytest.raises(NoMemoryError):
        load_parts(bench, None, {}, send)


@pytest.mark.thorough("test_a_board_with_little_memory_gets_its_parts_in_as_many_programs_as_it_needs, without a board")
@pytest.mark.parametrize("left_out", [LEFT_OUT, []], ids=lambda names: "without" if names else "all")
def test_a_micro_bit_of_2016_gets_its_parts_in_as_many_programs_as_it_needs(
    microbit: Emulated, tmp_path: Path, left_out: list[str]
) -> None:
    robot = tmp_path / "few.robot.xml"
    robot.write_bytes(micro_bit_without(left_out))
    out, err = command(
        "bench", microbit.address, "--robot", str(robot), "--board", "microbit", "--json", "--seconds", "0.5"
    )
    rows = {(row["call"] or row["part"]): row for row in json.loads(out)}
    assert all(row["ok"] for row in rows.values())
    assert rows["Display.Image(0)"]["seen"] == "The display shows a picture."
    assert rows["ButtonA"]["values"] == [0]
    assert err.splitlines().count("starting") > 1, err


@pytest.mark.thorough(
    "test_drivers_of_2016.test_a_driver_of_a_micro_bit_calls_no_function_that_calls_another, without a board; "
    "test_a_part_whose_program_has_no_room_is_a_row_and_the_rest_goes_on"
)
@pytest.mark.parametrize("name", sorted(small_kits()))
def test_a_micro_bit_of_2016_runs_every_part_that_a_kit_claims(microbit: Emulated, name: str) -> None:
    with redirect_stderr(io.StringIO()), redirect_stdout(io.StringIO()) as out, pytest.raises(SystemExit):
        main(["bench", "--to", microbit.address, "--board", name, "--json", "--seconds", "0.3"])
    rows = json.loads(out.getvalue())
    assert len(rows) > 8
    failed = {row["call"] or row["part"]: row["error"]["message"] for row in rows if not row["ok"]}
    # The emulator has no range finder.
    assert all("not plugged in" in message for message in failed.values()), failed


def test_a_part_whose_program_has_no_room_is_a_row_and_the_rest_goes_on(
    kit: ModernBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    load = load_parts

    def loaded(bench: Bench, needed: PartKey, broken: Any, send: Any) -> Any:
        if needed[1] == "Wheel":
            raise NoMemoryError(Sentence("too large"), Sentence("take a larger board"))
        few = [one for one in bench.steps if one.key[1] != "Wheel"]
        return load(replace(bench, steps=tuple(few)), needed, broken, send)

    monkeypatch.setattr(bench_run, "load_parts", loaded)
    out, _ = command("bench", "--to", kit.address, "--board", "pico", "--robot", "mini-robot", *MOMENT, status=1)
    rows = {(row["call"] or row["part"]): row for row in json.loads(out)}
    assert rows["Wheel.Advance(40)"]["error"]["message"] == "`Wheel` cannot be tried: too large"
    assert not rows["Wheel.Reverse(40)"]["ok"]
    assert rows["Motor.Turn(40)"]["ok"]
    assert rows["Button"]["values"]


def test_once_the_robot_is_gone_the_table_says_what_was_tried_and_what_was_not(
    kit: ModernBoard, monkeypatch: pytest.MonkeyPatch
) -> None:
    watch = BenchRun.watch

    def watched(run: BenchRun, seconds: float) -> list[int]:
        step = run._hand.step
        if step is not None and step.call == "Wheel.Reverse(40)":
            raise LineError(Sentence("the cable was pulled"))
        return watch(run, seconds)

    monkeypatch.setattr(BenchRun, "watch", watched)
    out, _ = command("bench", "--to", kit.address, "--board", "pico", "--robot", "mini-robot", *MOMENT, status=1)
    rows = [(row["call"] or row["part"], (row["error"] or {"message": ""})["message"]) for row in json.loads(out)]
    at = [name for name, _ in rows].index("Wheel.Reverse(40)")
    assert rows[at][1] == "the cable was pulled"
    assert {message for _, message in rows[at + 1 :]} == {"not tried: the cable was pulled"}
    assert all(message == "" for _, message in rows[:at])
