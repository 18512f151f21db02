"""The paper's robots on a kit with a current MicroPython: deployed by the command a user types, with recorded pins."""

from __future__ import annotations

from pathlib import Path

from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import connect
from tests.boards.alvik import HEARD, NOTHING, STANDING, TURNED, frame
from tests.boards.modern import ModernBoard, greet_until, onboard_files
from tests.boards.test_modern_robot import deploy_by_command, pins_told
from tests.patience import PATIENCE_S

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
MOTORS = (2, 3, 4, 5)


def until_it_did(board: Board, ticks: int) -> None:
    greet_until(board, lambda hello: hello.state != 2 or hello.tick >= ticks)


def test_square_drives_and_turns_on_a_pico_with_two_motors_and_stop_stops_them(kit: ModernBoard) -> None:
    deploy_by_command(EXAMPLES / "square" / "square.krt", kit, "--board", "pico")
    with connect(kit.address, PATIENCE_S) as board:
        until_it_did(board, 150)
        board.stop()
        assert board.last_fault() is None
    duties = dict.fromkeys(MOTORS, 0)
    moves: list[tuple[bool, ...]] = []
    for name, what, value in pins_told(kit):
        if name in MOTORS and what == "duty":
            duties[int(str(name))] = value
            going = tuple(duties[pin] > 0 for pin in MOTORS)
            if not moves or moves[-1] != going:
                moves.append(going)
            assert not (duties[2] and duties[3]), "never both inputs of a motor at once"
            assert not (duties[4] and duties[5])
    straight, turning = (True, False, True, False), (False, True, True, False)
    assert straight in moves
    assert turning in moves
    assert moves.index(straight) < moves.index(turning)
    assert moves[-1] == (False,) * 4


def test_a_range_finder_that_is_not_plugged_in_is_a_fault_of_its_part_and_everything_stands(
    tmp_path: Path,
) -> None:
    machine = onboard_files()["machine.py"] + b"\nwidths[15] = None\n"
    with ModernBoard({"lib/machine.py": machine}) as board:
        path = tmp_path / "wall.lll"
        path.write_text("Wheel.Advance(50); *[Captor.GreaterThan(20)](WAIT(1); ); Wheel.Stop();", encoding="utf-8")
        deploy_by_command(path, board, "--robot", "mini-robot", "--board", "pico")
        with connect(board.address, PATIENCE_S) as line:
            fault = None
            while fault is None:
                fault = line.last_fault()
        assert "not plugged in" in fault.text
        told = [value for name, what, value in pins_told(board) if name in MOTORS and what == "duty"]
    assert max(told) > 0
    assert told[-1] == 0


def test_square_on_an_alvik_tells_its_stm32_to_drive_and_to_turn_and_stop_stops_it() -> None:
    turn = frame("R", "f", 90)
    robot = f"""
levels[13] = 1
ends = [{STANDING!r}]
def stm32(data):
    if data:
        ends[0] = {TURNED!r} if data == {turn!r} else {STANDING!r}
    return b"" if data else ends[0]
partners[1] = stm32
"""
    with ModernBoard({"lib/machine.py": onboard_files()["machine.py"] + robot.encode()}) as board:
        deploy_by_command(EXAMPLES / "square" / "square.krt", board, "--board", "alvik")
        with connect(board.address, PATIENCE_S) as line:
            until_it_did(line, 300)  # 30 cm take it 4.8 seconds
            line.stop()
            assert line.last_fault() is None
        told = [value for _, what, value in pins_told(board) if what == "write"]
    drives = [data for data in told if data[2:3] == b"J" and data != frame("J", "2f", 0, 0)]
    assert drives
    assert turn in told
    assert told.index(drives[0]) < told.index(turn)
    assert told[told.index(turn) + 1] == HEARD
    assert frame("J", "2f", 0, 0) in told[-4:]
    assert told.index(drives[0]) < len(told) - 4


def test_an_alvik_that_falls_silent_is_a_fault_of_the_part_that_is_looked_at_and_its_wheels_are_told_to_stand(
    tmp_path: Path,
) -> None:
    robot = f"""
levels[13] = 1
looks = [0]
def stm32(data):
    looks[0] += not data
    return {NOTHING!r} if not data and looks[0] < 20 else b""
partners[1] = stm32
"""
    with ModernBoard({"lib/machine.py": onboard_files()["machine.py"] + robot.encode()}) as board:
        path = tmp_path / "wall.lll"
        path.write_text("Wheel.Advance(50); *[Captor.GreaterThan(20)](WAIT(1); ); Wheel.Stop();", encoding="utf-8")
        deploy_by_command(path, board, "--robot", "mini-robot", "--board", "alvik")
        with connect(board.address, PATIENCE_S) as line:
            fault = None
            while fault is None:
                fault = line.last_fault()
        told = [value for _, what, value in pins_told(board) if what == "write"]
    assert fault.text.startswith("s"), "a sensor"
    assert "no answer from the Alvik" in fault.text
    assert frame("J", "2f", 35, 35) in told
    assert [data for data in told if data[2:3] == b"J"][-1] == frame("J", "2f", 0, 0)
