"""`kitrobot exec`: one program against scripted inputs, tick by tick."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.options import ProgramName, RobotName
from kitrobot.cli.output import print_data, print_diagnostics
from kitrobot.text.sentences import Sentence

if TYPE_CHECKING:
    from kitrobot.workspace.execution import ExecutionTick

_AT_ONCE = 500
"""Lines written together."""


def execute_program(
    program: Annotated[
        Path,
        typer.Argument(metavar="PROGRAM", help="A `.lll`, `.kri` or `.krt` file, or a picture.", show_default=False),
    ],
    robot: RobotName = None,
    name: ProgramName = None,
    inputs: Annotated[
        Path | None,
        typer.Option(metavar="INPUTS.csv", help="What the robot senses: `tick,SENSOR,done:ACTUATOR,…`."),
    ] = None,
    ticks: Annotated[int, typer.Option(min=0, help="How many ticks to run.")] = 100,
    as_json: Annotated[bool, typer.Option("--json", help="Give one JSON object a line and tick.")] = False,
) -> None:
    """Run one program against scripted inputs, without a world.

    Each tick shows the commands handed to the devices, the variables after the tick, the fault flag, and whether the
    program has ended. Before any row of the inputs, sensors are 0 and every device is done; a row holds from its tick
    on, an empty cell changes nothing. The exit status is 1 when the program or the inputs have errors.
    """
    from kitrobot.diagnostics.problems import ProblemsError
    from kitrobot.workspace.executables import load_executable
    from kitrobot.workspace.execution import execute

    loaded = load_executable(program, robot=robot, program=name, inputs=inputs)
    if loaded.image is None or loaded.inputs is None:
        wrong = program if loaded.image is None else inputs
        raise ProblemsError(
            Sentence("`{wrong}` has errors, so nothing was run", wrong), "", tuple(loaded.diagnostics), loaded.sources
        )
    print_diagnostics(loaded.diagnostics, loaded.sources)
    made = execute(loaded.image, loaded.robot, ticks, loaded.inputs)
    lines = (
        (_json_line(tick) for tick in made)
        if as_json
        else _table(made, ticks, [variable.name for variable in loaded.robot.variables])
    )
    held: list[str] = []
    for line in lines:
        held.append(line)
        if len(held) == _AT_ONCE:
            print_data("".join(held))
            held.clear()
    print_data("".join(held))


def _json_line(tick: ExecutionTick) -> str:
    return json.dumps(tick.to_json(), ensure_ascii=False, separators=(",", ":")) + "\n"


def _table(made: Iterable[ExecutionTick], ticks: int, names: list[str]) -> Iterable[str]:
    """Columns: tick, variables, fault, commands; the last is as long as it needs to be."""
    first = max(len("tick"), len(str(max(ticks - 1, 0))))
    widths = [max(len(name), 4) for name in names]
    heads = [f"{name:>{width}}" for name, width in zip(names, widths, strict=True)]
    yield "  ".join([f"{'tick':>{first}}", *heads, "fault", "commands"]) + "\n"
    was_ended = False
    for tick in made:
        cells = [f"{tick.variables[name]:>{width}}" for name, width in zip(names, widths, strict=True)]
        commands = [f"{name}({', '.join(map(str, arguments))})" for name, arguments in tick.commands]
        if tick.ended and not was_ended:
            commands.append("(ended)")
        was_ended = tick.ended
        yield "  ".join([f"{tick.tick:>{first}}", *cells, f"{tick.fault:>5}", " ".join(commands)]).rstrip() + "\n"
