"""`kitrobot grade`: what a class made of an exercise; a table, CSV, HTML or JSON."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.output import json_text, print_data, print_message, sanitize
from kitrobot.cli.progress import counted_progress
from kitrobot.diagnostics.read_files import expect_outputs, note_read

if TYPE_CHECKING:
    from kitrobot.classroom.grades import Grade


def grade_submissions(
    submissions: Annotated[list[Path], typer.Argument(metavar="SUBMISSION…", help="The missions that were handed in.")],
    exercise: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.exercise.xml",
            help="The exercise; else of each that one of KitRobot's whose programs it has.",
            show_default=False,
        ),
    ] = None,
    csv: Annotated[Path | None, typer.Option(metavar="FILE", help="Write the table for a spreadsheet, too.")] = None,
    html: Annotated[Path | None, typer.Option(metavar="FILE", help="Write the table as a page, too.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Give a list of JSON objects.")] = False,
    jobs: Annotated[
        int | None, typer.Option(metavar="N", min=1, help="Grade so many at a time; else one for each core.")
    ] = None,
) -> None:
    """Grade what a class made of an exercise, the hidden goals too.

    Each submission is judged in a process of its own, with bounds on memory and work; only the file that is named is
    read. The exit status is 0 when every submission reached every goal, and 1 when one did not or cannot be judged.
    """
    from kitrobot.classroom.grader_process import ready_exercise, shipped_exercises
    from kitrobot.classroom.grading import grade
    from kitrobot.workspace.child_processes import cores

    # Each is read by a process of its own, those of KitRobot too.
    for one in submissions:
        note_read(one)
    if exercise is not None:
        ready_exercise(exercise)
    else:
        for shipped in shipped_exercises():
            for one in (shipped, *shipped.parent.glob("*.krt")):
                note_read(one)
    expect_outputs(csv, html)
    with counted_progress("submissions", len(submissions)) as progress:
        found = list(grade(submissions, exercise, jobs or cores(), progress))
    places = {str(path): place for place, path in enumerate(submissions)}
    found.sort(key=lambda one: places[one.submission])
    if csv is not None or html is not None:
        _write(found, csv, html)
    if as_json:
        print_data(json_text([one.to_json() for one in found], 2) + "\n")
    else:
        print_data(_tables(found))
    full = sum(one.full for one in found)
    print_message(f"{full} of {len(found)} reached every goal")
    if full < len(found):
        raise typer.Exit(1)


def _write(found: Sequence[Grade], csv: Path | None, html: Path | None) -> None:
    from kitrobot.classroom.grade_tables import as_csv, as_html
    from kitrobot.files.disk import write_atomic

    if csv is not None:
        write_atomic(csv, as_csv(found).encode(errors="replace"))
    if html is not None:
        write_atomic(html, as_html(found).encode(errors="replace"))


def _tables(found: Sequence[Grade]) -> str:
    """A table for each exercise, then those that could not be judged."""
    from kitrobot.classroom.grade_tables import by_exercise

    lines: list[str] = []
    for rows in by_exercise(found):
        lines += [*_table(rows), ""]
    lost = [one for one in found if one.problem is not None]
    if lost:
        lines.append("Not judged:")
        lines += [f"  {_line(one.submission)}: {_line((one.problem or {})['en'])}" for one in lost]
        lines.append("")
    return "\n".join(lines[:-1]) + "\n"


def _table(rows: Sequence[Grade]) -> list[str]:
    """One exercise: what its goals are, a row for each submission, how properties are known, and what went wrong."""
    from kitrobot.classroom.grade_tables import grounds

    goals = rows[0].goals
    names = [_line(one.submission) for one in rows]
    width = max(len(name) for name in names)
    lines = [rows[0].exercise["en"], ""]
    for number, goal in enumerate(goals, 1):
        remark = " (hidden)" * goal.hidden + " (counts once another goal is reached)" * goal.condition
        lines.append(f"  {number:>2}  {_line(goal.label['en'])}{remark}")
    heads = "".join(f"{number:>4}" for number in range(1, len(goals) + 1))
    lines += ["", f"  {'':<{width}}{heads}  points"]
    for name, row in zip(names, rows, strict=True):
        marks = "".join(f"{'✓' if goal.reached else '✗':>4}" for goal in row.goals)
        lines.append(f"  {name:<{width}}{marks}  {row.points} of {row.of}")
    known = [
        f"  {number}: {_line(ground['en'])}{f' ({count} of {len(rows)})' if len(rows) > 1 else ''}"
        for number, ground, count in grounds(rows)
    ]
    wrong = [
        f"  {name}, {number}: {_line(goal.why['en'])}{_where(goal.seed, goal.seconds)}"
        for name, row in zip(names, rows, strict=True)
        for number, goal in enumerate(row.goals, 1)
        if not goal.reached
    ]
    return [*lines, *([""] if known else []), *known, *([""] if wrong else []), *wrong]


def _where(seed: int | None, seconds: float | None) -> str:
    if seed is None:
        return ""
    return f" (seed {seed}{'' if seconds is None else f', at {seconds:.1f} s'})"


def _line(text: str) -> str:
    """A text as one line that steers no terminal."""
    return sanitize(text.replace("\n", " "))
