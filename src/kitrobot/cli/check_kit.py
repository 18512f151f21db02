"""`kitrobot check --board`: what the robots of missions are on a kit, part by part."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from kitrobot.cli.language import translated
from kitrobot.cli.output import error_object, json_text, print_data, print_diagnostics, print_message, sanitize

if TYPE_CHECKING:
    from kitrobot.boards.kits import ProgramOnKit
    from kitrobot.deploy.kits.kits import PartOnKit
    from kitrobot.primitives.kit import Kit


def check_on_kit(files: Sequence[Path], board: str, robot: str | None, *, as_json: bool) -> None:
    """Says of each program of missions and texts what becomes of its robot's parts; ends with 1 when one cannot be
    sent.
    """
    from kitrobot.workspace.kit_files import find_kit

    rows: list[dict[str, Any]] = []
    failed = False
    for path in files:
        kit = find_kit(board, path.parent)
        for program in _programs(path, kit, robot):
            failed |= program.problem is not None
            if as_json:
                rows.append({"file": str(path), "board": kit.name, **_object(program)})
            else:
                _write(program, kit)
    if as_json:
        print_data(json_text(rows, 2) + "\n")
    if failed:
        raise typer.Exit(1)


def _programs(path: Path, kit: Kit, robot: str | None) -> list[ProgramOnKit]:
    from kitrobot.boards.kits import mission_on_kit, text_on_kit
    from kitrobot.boards.programs import no_robot
    from kitrobot.files.embedded_mission import may_carry_mission
    from kitrobot.files.program_formats import Form, form_of
    from kitrobot.workspace.mission_loader import open_mission

    if may_carry_mission(path.name) or form_of(path, (Form.TEXT, Form.MISSION)) is Form.MISSION:
        return mission_on_kit(open_mission(path, robot=robot), kit)
    if robot is None:
        raise no_robot(path)
    return [text_on_kit(path, robot, kit)]


def _write(program: ProgramOnKit, kit: Kit) -> None:
    from kitrobot.translation.reader_language import translate

    heading = f"{sanitize(program.program)} (robot {sanitize(program.robot)}) on {sanitize(kit.name)}:"
    table = [_row(one) for one in program.parts]
    widths = [max((len(row[column]) for row in table), default=0) for column in range(2)]
    print_data(heading + "\n")
    for name, used, words in table:
        print_data(f"  {name.ljust(widths[0])}  {used.ljust(widths[1])}  {words}\n")
    if program.problem is None:
        print_data("  it can be sent\n")
    else:
        if program.problem.diagnostics:
            print_diagnostics(program.problem.diagnostics, getattr(program.problem, "sources", ()))
        print_message(f"{program.program}: {translate(program.problem.message)}")
        if program.problem.help:
            print_message(f"  help: {translate(program.problem.help)}")


def _row(one: PartOnKit) -> tuple[str, str, str]:
    return sanitize(one.part.name), "used" if one.is_used else "not used", _words(one)


def _words(one: PartOnKit) -> str:
    from kitrobot.translation.reader_language import translate

    if one.found is None or one.found.is_missing:
        why = translated(one.found.help) if one.found is not None else ""
        if one.is_missing:
            return "missing" + (f": {sanitize(why)}" if why else "")
    if one.problem is not None:
        return f"does not work: {sanitize(translate(one.problem.message))}"
    if one.found is None:
        return "every board has it"
    told = " ".join(f"{name}={value}" for name, value in one.part.board.settings.items())
    return sanitize(f"{one.part.board.driver} {told}".rstrip())


def _object(program: ProgramOnKit) -> dict[str, Any]:
    from kitrobot.translation.reader_language import translate

    return {
        "program": program.program,
        "robot": program.robot,
        "ok": program.problem is None,
        "error": error_object(program.problem) if program.problem is not None else None,
        "parts": [
            {
                "part": one.part.name,
                "category": one.part.category.value,
                "used": one.is_used,
                "missing": one.is_missing,
                "why": translated(one.found.help) if one.found is not None and one.is_missing else "",
                "problem": translate(one.problem.message) if one.problem is not None else "",
                "driver": "" if one.is_missing else one.part.board.driver,
                "settings": {} if one.is_missing else dict(one.part.board.settings),
            }
            for one in program.parts
        ],
    }
