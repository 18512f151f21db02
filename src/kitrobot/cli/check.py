"""`kitrobot check`: every problem of files of every kind."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from kitrobot.cli.check_kit import check_on_kit
from kitrobot.cli.language import Language
from kitrobot.cli.output import json_text, print_data, print_message
from kitrobot.diagnostics.model import Severity


def check_files(
    files: Annotated[
        list[Path],
        typer.Argument(metavar="FILE…", help="Missions, LLL texts, images, robots, kits, constructors, worlds."),
    ],
    robot: Annotated[
        str | None,
        typer.Option(
            metavar="NAME|FILE.robot.xml", help="The robot that LLL texts and trees are for.", show_default=False
        ),
    ] = None,
    board: Annotated[
        str | None,
        typer.Option(
            metavar="NAME|FILE.board.xml",
            help="A kit: say part by part what the robots of the missions are on it.",
            show_default=False,
        ),
    ] = None,
    language: Language = "en",
    as_json: Annotated[bool, typer.Option("--json", help="Give a list of JSON objects.")] = False,
) -> None:
    """Show every problem of the files, each with its place and a way out.

    Kinds: `.krt`, `.lll`, `.kri`, `.kra`, files with a mission inside (`.svg`, `.png`, `.pdf`, `.hex`, `.uf2`), XML of
    robots, kits, constructors, worlds and behaviour trees. Of an `.lll` and a tree without `--robot` only the syntax is
    checked. The exit status is 1 if there is an error, and 0 if there are only warnings and hints. With --board it is 1
    when a program cannot be sent.
    """
    from kitrobot.diagnostics.problems import with_help, written_out
    from kitrobot.diagnostics.renderer import to_json
    from kitrobot.translation.reader_language import override_language
    from kitrobot.workspace.file_check import check_file
    from kitrobot.workspace.robots import find_robot

    if board is not None:
        with override_language(language):
            check_on_kit(files, board, robot, as_json=as_json)
        return
    if language != "en":
        raise typer.BadParameter("say --board too: it is the language of what a kit says", param_hint="'--language'")
    meant = find_robot(robot) if robot is not None else None
    reports = [check_file(path, meant) for path in files]
    problems = [problem for report in reports for problem in with_help(report.diagnostics)]
    if as_json:
        print_data(json_text([to_json(problem) for problem in problems], 2) + "\n")
    else:
        for report in reports:
            text = written_out(report.diagnostics, report.sources)
            print_data(text + "\n" if text else "")
            for note in report.notes:
                print_message(note)
        print_message(_count([problem.severity for problem in problems], len(files)))
    if any(problem.is_error for problem in problems):
        raise typer.Exit(1)


def _count(severities: list[Severity], files: int) -> str:
    """`2 errors, 1 hint in 3 files`."""
    found = []
    for severity in Severity:
        number = severities.count(severity)
        if number:
            found.append(f"{number} {severity}{'s' if number > 1 else ''}")
    return f"{', '.join(found) or 'no problems'} in {files} file{'s' if files != 1 else ''}"
