"""`kitrobot deploy LIST --set`: to each of many boards what a list names for its label; a table of what runs where."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from kitrobot.cli.output import json_text, print_data, print_diagnostics, print_error, print_message, sanitize
from kitrobot.cli.result_json import board_result, deployed_result
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence

if TYPE_CHECKING:
    from kitrobot.boards.class_set import SetResult

Bars = Callable[[Sequence[str]], AbstractContextManager[Callable[[str, str, int, int], None]]]

HEAD = ("label", "port", "program", "state", "KitRobot", "MicroPython", "generation", "memory left")


def deploy_set(path: Path, bars: Bars, *, replace: bool, fresh: bool, as_json: bool) -> None:
    """Sends them, gives the table or JSON, and ends with the status."""
    from kitrobot.boards.class_set import prepare_set, read_set

    found = prepare_set(read_set(path))
    for program in {id(one.program): one.program for one in found.members if one.program is not None}.values():
        print_diagnostics(program.diagnostics, program.sources)
    with bars(found.addresses) as progress:
        results = found.send(progress, replace=replace, fresh=fresh)
    if as_json:
        print_data(json_text([_object(one) for one in results], 2) + "\n")
    else:
        for line in table([HEAD, *map(_row, results)]):
            print_data(line)
    _print_results(results)
    if found.others:
        print_message(Sentence("not in the list, and left as they are: {ports}", listed(found.others)))
    if any(one.error is not None for one in results):
        raise typer.Exit(1)


def table(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """Rows with columns as wide as they must be."""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    for row in rows:
        yield "  ".join(word.ljust(width) for word, width in zip(row, widths, strict=True)).rstrip() + "\n"


def _print_results(results: Sequence[SetResult]) -> None:
    """What went wrong with which boards; what is the same for several is said once."""
    wrong: dict[KitRobotError | tuple[str, str], tuple[KitRobotError, list[str]]] = {}
    for one in results:
        if one.error is not None:
            place = f" ({one.member.address})" if one.member.address else ""
            name = sanitize(one.member.wanted.label + place)
            wrong.setdefault((one.error.message, one.error.help), (one.error, []))[1].append(name)
    for error, names in wrong.values():
        print_message(f"{', '.join(names)}:")
        print_error(error)


def _row(one: SetResult) -> tuple[str, ...]:
    where = (sanitize(one.member.wanted.label), sanitize(one.member.address))
    done = one.sent.deployed if one.sent is not None else None
    if done is None or one.member.program is None:
        return (*where, "", "failed", "", "", "", "")
    program = f"{sanitize(one.member.program.names.program)} ({done.program})"
    return (
        *where,
        program,
        done.hello.state_name,
        sanitize(done.package),
        sanitize(done.micropython) or "?",
        str(done.generation),
        f"{done.free} bytes",
    )


def _object(one: SetResult) -> dict[str, Any]:
    wanted = one.member.wanted
    named = {"label": wanted.label, "mission": str(wanted.mission)}
    done = one.sent.deployed if one.sent is not None else None
    if done is None or one.member.program is None:
        return {**named, **board_result(one.member.address, one.error)}
    told = {
        "state": done.hello.state_name,
        "name_of_program": one.member.program.names.program,
        **deployed_result(done),
    }
    return {**named, **board_result(one.member.address, None, **told)}
