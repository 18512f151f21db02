"""`kitrobot calibrate`: how a robot drives and turns on the floor, asked step by step, into the file of its kit."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.bench import Port, robot_address, send_progress
from kitrobot.cli.dialogue import Dialogue
from kitrobot.cli.options import Replace
from kitrobot.cli.output import json_text, print_data, print_diagnostics, print_message, sanitize
from kitrobot.cli.watch import Board
from kitrobot.text.forms import number_form

if TYPE_CHECKING:
    from kitrobot.boards.bench import BenchStep
    from kitrobot.boards.bench_run import BenchRun
    from kitrobot.boards.calibration import Answers, WheelTurn
    from kitrobot.primitives.kit import Kit

_LONGEST_S = 30.0
"""How long a step may take that ends by itself."""

_SIDES = {"l": "left", "left": "left", "r": "right", "right": "right"}
_WAYS = {"f": True, "forward": True, "b": False, "backward": False}


def calibrate_robot(
    board: Annotated[
        str,
        typer.Option(
            "--board", metavar="NAME|FILE.board.xml", help="The kit that the robot is built of.", show_default=False
        ),
    ],
    port: Port = "",
    to: Board = None,
    times: Annotated[int, typer.Option(min=1, max=10, metavar="N", help="How often each way is measured.")] = 2,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE.board.xml",
            help="Where the kit as it was measured is written.",
            show_default="NAME.board.xml here, or the file itself when it is one of your own",
        ),
    ] = None,
    replace: Replace = False,
    as_json: Annotated[bool, typer.Option("--json", help="Give what was measured as one JSON object.")] = False,
) -> None:
    """Measure how a robot drives and turns, and write it into the file of its kit.

    It moves, and asks what you saw: which wheel turned and which way, how far it drove, how far it turned. An empty
    answer leaves that out. Kits that come with KitRobot are copied and never changed; beside your missions the copy
    takes their place. `kitrobot run --board NAME` simulates with what was measured.
    """
    from kitrobot.boards.bench_run import BenchRun
    from kitrobot.boards.calibration import (
        calibrated,
        expect_kit_place,
        left_out,
        measuring_steps,
        own_place,
        write_kit_file,
    )
    from kitrobot.workspace.kit_files import find_kit

    folder = Path.cwd()
    kit = find_kit(board, folder)
    bench, steps = measuring_steps(kit, folder)
    target = output if output is not None else own_place(board, kit, folder)
    expect_kit_place(kit, target)
    address = robot_address(port, to)
    with BenchRun(address, bench, send_progress(), replace=replace) as run:
        answers = _answers(run, steps, times)
    made = calibrated(kit, answers)
    if made == kit:
        print_message("nothing was changed: what was measured is what the kit's file says")
    else:
        print_diagnostics(*left_out(target))
        write_kit_file(made, target)
        print_message(f"written into {target}")
    if as_json:
        print_data(json_text(_object(kit, made, target), 2) + "\n")
    else:
        for line in _changes(kit, made):
            print_data(line + "\n")


def _answers(run: BenchRun, steps: dict[str, BenchStep], times: int) -> Answers:
    from kitrobot.boards.calibration import Answers

    dialogue = Dialogue(run.keep_alive)
    wheels: dict[str, WheelTurn] = {}
    numbers: dict[str, list[float]] = {"distance": [], "turn": []}
    for measure, step in steps.items():
        for _ in range(times if measure in numbers else 1):
            print_message(step.trouble.get("", ""))
            dialogue.ask("press Enter, then it moves: ")
            run.begin(step)
            run.finish(_LONGEST_S)
            if measure not in numbers:
                turned = _which_wheel(dialogue, step)
                if turned is not None:
                    wheels[measure] = turned
            elif (number := _number(dialogue, step)) is not None:
                numbers[measure].append(number)
    return Answers(wheels, numbers["distance"], numbers["turn"])


def _which_wheel(dialogue: Dialogue, step: BenchStep) -> WheelTurn | None:
    from kitrobot.boards.calibration import WheelTurn

    while True:
        words = dialogue.ask(f"{step.seen.get('', '')}: ").lower().split()
        if not words:
            return None
        if len(words) == 2 and words[0] in _SIDES and words[1] in _WAYS:
            return WheelTurn(_SIDES[words[0]], _WAYS[words[1]])
        print_message(
            "say for example: left forward; an empty line leaves it out, and `kitrobot bench` says what to look for"
        )


def _number(dialogue: Dialogue, step: BenchStep) -> float | None:
    while True:
        text = number_form(dialogue.ask(f"{step.seen.get('', '')}: ").replace(",", "."))
        if not text:
            return None
        try:
            return float(text)
        except ValueError:
            print_message("say a number; an empty line leaves it out")


def _differences(before: Kit, after: Kit) -> list[tuple[str, str, str | None, str | None]]:
    """What is new: devices, setting, the value before and after."""
    found: list[tuple[str, str, str | None, str | None]] = []
    for old, new in zip(before.parts, after.parts, strict=True):
        names = dict.fromkeys([*old.board.settings, *new.board.settings])
        for name in names:
            was, now = old.board.settings.get(name), new.board.settings.get(name)
            if was != now:
                found.append((" ".join(new.devices), name, was, now))
    for one in after.measured:
        if one not in before.measured:
            found += [(" ".join(one.devices), f"measured {name}", None, now) for name, now in one.settings.items()]
    return found


def _changes(before: Kit, after: Kit) -> list[str]:
    return [
        sanitize(f"{devices}: {name} {f'{was} → ' if was is not None else ''}{now if now is not None else 'none'}")
        for devices, name, was, now in _differences(before, after)
    ]


def _object(before: Kit, after: Kit, target: Path) -> dict[str, Any]:
    changed = [
        {"devices": devices, "setting": name, "before": was, "after": now}
        for devices, name, was, now in _differences(before, after)
    ]
    return {"board": after.name, "file": str(target) if changed else None, "changes": changed}
