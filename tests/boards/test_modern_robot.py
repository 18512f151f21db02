"""A kit robot with a current MicroPython: deployed by the command a user types, run with the drivers of real boards."""

from __future__ import annotations

import ast
import io
import json
import random
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import pytest

import kitrobot
from kitrobot.cli.app import main
from kitrobot.compiler.compilation import compile_text
from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.image.machine import Layout, Machine
from kitrobot.lll.printer import print_program
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot_onboard.link import wrap
from tests.boards.modern import ModernBoard, greet_until
from tests.effort import THOROUGH
from tests.patience import PATIENCE_S
from tests.strategies import Shape, TickInputs, random_program, random_script

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "kit-rover" / "kit-rover.krt"
LOOKS = "[Captor.LessThan(0)](Light.LightOff(); )!();"
"""Never true; but only devices that a program uses go onto a board."""

FORWARD_LEFT, FORWARD_RIGHT, SERVO, TRIGGER = 2, 4, 22, 14


def deploy_by_command(path: Path, board: ModernBoard, *options: str, status: int = 0) -> dict[str, Any]:
    """What `kitrobot deploy` says of the board."""
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err), pytest.raises(SystemExit) as end:
        main(["deploy", str(path), "--to", board.address, "--json", *options])
    assert end.value.code == status, (out.getvalue(), err.getvalue())
    found: dict[str, Any] = json.loads(out.getvalue())[0]
    return found


def pins_told(board: ModernBoard) -> list[tuple[object, str, Any]]:
    """What the pins were told since the power came on, read at the prompt that the robot leaves to."""
    line = Line(board.address)
    try:
        line.write(b"\r\x03\x03")
        line.read_until(b">>> ", 20)
        line.write(b"\r\x01")
        line.read_until(b"exit\r\n>", 20)
        text = RawRepl(line).run("import machine;print(machine.log)", 20)
    finally:
        line.close()
    found: list[tuple[object, str, Any]] = ast.literal_eval(text)
    return found


def same_commands(board: Board, machine: Machine, script: list[TickInputs]) -> None:
    """Steps through the program with these inputs, on the board and in the simulator's machine."""
    calls = machine.layout.commands
    board.arguments = [len(machine.robot.calls[actuator, name][1].parameters) for _, actuator, name in calls]
    board.stop()
    for number, (inputs, done) in enumerate(script):
        for sensor, value in inputs.items():
            machine.set_input(sensor, value)
        for actuator, is_done in done.items():
            machine.set_done(actuator, is_done)
        cells = {cell: int(machine.cells[cell]) for cell in range(1, machine.layout.inputs + 1)}
        expected = [
            (machine.layout.command[one.actuator, one.procedure], tuple(one.arguments)) for one in machine.tick()
        ]
        step = board.step(cells)
        assert (number, list(step.commands)) == (number, expected)
        assert (step.fault_flag, step.ended) == (bool(machine.fault), machine.ended)
        if machine.ended:
            break


def test_the_example_gives_the_commands_of_the_simulator_tick_by_tick(kit: ModernBoard) -> None:
    done = deploy_by_command(EXAMPLE, kit)
    opened = kitrobot.open(EXAMPLE)
    program = opened.mission.programs[0]
    image = opened.compiled[program.name].image
    assert image is not None
    robot = opened.catalogue.robots[program.target]
    script = random_script(random.Random("kit"), robot, 30)
    with connect(kit.address, PATIENCE_S) as board:
        assert board.hello.program == done["program"]
        same_commands(board, Machine(image, robot), script)


def test_random_programs_give_the_commands_of_the_simulator_tick_by_tick(kit: ModernBoard, tmp_path: Path) -> None:
    robot = load_catalogue().robots["kit-robot"]
    for seed in range(4 if THOROUGH else 2):
        rng = random.Random(f"kit/{seed}")
        path = tmp_path / "random.lll"
        path.write_text(print_program(random_program(rng, robot, Shape(15, 5))), encoding="utf-8")
        deploy_by_command(path, kit, "--robot", "kit-robot")
        compiled = compile_text(path.read_text(encoding="utf-8"), robot)
        assert compiled.image is not None
        with connect(kit.address, PATIENCE_S) as board:
            same_commands(board, Machine(compiled.image, robot), random_script(rng, robot, 40))


def test_the_pins_of_motors_servo_and_lamp_do_what_the_program_says_and_stop_stops(
    kit: ModernBoard, tmp_path: Path
) -> None:
    path = tmp_path / "drive.lll"
    robot = load_catalogue().robots["kit-robot"]
    number = next(variable.name for variable in robot.variables if variable.maximum >= 100)
    go = LOOKS + "LeftWheel.Forward(50); RightWheel.Forward(20); Door.Open(); Light.LightOn();"
    path.write_text(f"{go} {number}.Set(7); WAIT(600);\n")
    deploy_by_command(path, kit, "--robot", "kit-robot")
    with connect(kit.address, PATIENCE_S) as board:
        board.start()
        board.watch(20)
        assert told_value(board, Layout(robot).variables[number], 7)
        board.stop()
        assert board.greet().state == 1
    told = pins_told(kit)
    duties = {pin: [value for name, what, value in told if name == pin and what == "duty"] for pin in (2, 3, 4, 5, 22)}
    assert 32767 in duties[FORWARD_LEFT]
    assert 13107 in duties[FORWARD_RIGHT]
    assert duties[3] == [0] * len(duties[3])
    assert any(abs(duty / 65535 * 20 - 1.5) < 0.01 for duty in duties[SERVO])
    assert all(values[-1] == 0 for values in duties.values())
    assert ("LED", "value", 1) in told
    assert [value for name, what, value in told if name == "LED" and what == "value"][-1] == 0
    assert (TRIGGER, "value", 1) in told


def test_watching_tells_variables_and_inputs_and_a_variable_can_be_set(kit: ModernBoard, tmp_path: Path) -> None:
    path = tmp_path / "count.lll"
    robot = load_catalogue().robots["kit-robot"]
    number = next(variable.name for variable in robot.variables if variable.maximum >= 100)
    path.write_text(f"*[!({number}.EqualTo(100))]( WAIT(1); {LOOKS} );\n Light.LightOn();\n")
    deploy_by_command(path, kit, "--robot", "kit-robot")
    layout = Layout(robot)
    cell = layout.variables[number]
    with connect(kit.address, PATIENCE_S) as board:
        board.watch(20)
        board.set(cell, 57)
        assert told_value(board, cell, 57)
        board.force(layout.sensors["Captor"], 33)
        assert told_value(board, layout.sensors["Captor"], 33)
        board.set(cell, 100)
        greet_until(board, lambda hello: hello.state == 3)
        assert board.last_fault() is None


def told_value(board: Board, cell: int, value: int) -> bool:
    """Whether the board tells that a cell has this value, soon."""
    for _ in range(200):
        news = board.news(1)
        if news is not None and getattr(news, "cells", {}).get(cell) == value:
            return True
    return False


def test_the_link_survives_noise_and_floods_while_it_runs(kit: ModernBoard) -> None:
    deploy_by_command(EXAMPLE, kit)
    rng = random.Random("noise")
    line = Line(kit.address)
    try:
        for _ in range(20):
            # Two 0x03 in a row would rightly lead to the prompt.
            line.write(bytes(byte for byte in rng.randbytes(500) if byte != 3))
        line.write(b"~" + wrap("p", 99, b""))
        assert line.read_until(wrap("K", 99, b""), 30).endswith(wrap("K", 99, b"")), "all of it was read"
    finally:
        line.close()
    with connect(kit.address, PATIENCE_S) as board:
        assert board.hello.state in (2, 3)
        assert board.last_fault() is None


def test_a_driver_that_fails_stops_the_motors_and_the_board_says_which(kit: ModernBoard, tmp_path: Path) -> None:
    (tmp_path / "servo.driver.py").write_text(
        "class Broken:\n"
        "    def do(self, procedure, arguments):\n"
        "        raise OSError('stuck')\n"
        "    def done(self):\n"
        "        return True\n"
        "    def stop(self):\n"
        "        pass\n"
        "make = lambda settings: Broken()\n"
    )
    path = tmp_path / "broken.lll"
    path.write_text("LeftWheel.Forward(50); WAIT(5); Door.Open(); WAIT(600);\n")
    deploy_by_command(path, kit, "--robot", "kit-robot")
    with connect(kit.address, PATIENCE_S) as board:
        while (fault := board.last_fault()) is None:
            pass
        assert fault.number == 1
        assert fault.text.startswith("a2 ")
        assert "stuck" in fault.text
        assert fault.instruction is not None
        assert board.greet().state == 4
    left = [value for name, what, value in pins_told(kit) if name == FORWARD_LEFT and what == "duty"]
    assert 32767 in left
    assert left[-1] == 0


def test_a_pin_that_the_board_does_not_have_is_named_and_the_old_program_stays(
    kit: ModernBoard, tmp_path: Path
) -> None:
    before = deploy_by_command(EXAMPLE, kit)
    robot = (Path(kitrobot.__file__).parent / "primitives" / "shipped" / "kit-robot.robot.xml").read_text("utf-8")
    own = tmp_path / "own.robot.xml"
    own.write_text(robot.replace('trigger="14"', 'trigger="99"').replace('name="kit-robot"', 'name="own"'), "utf-8")
    path = tmp_path / "own.lll"
    path.write_text(LOOKS + "Light.LightOn();\n")
    answer = deploy_by_command(path, kit, "--robot", str(own), status=1)
    assert "invalid pin" in answer["error"]["message"]
    with connect(kit.address, PATIENCE_S) as board:
        assert board.hello.program == before["program"]
