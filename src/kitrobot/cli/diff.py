"""`kitrobot diff`: what is different between two missions, or two LLL texts, in words."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from kitrobot.cli.output import json_text, print_data

DIFFERENT = 1


def diff_files(
    before: Annotated[Path, typer.Argument(metavar="A", help="A mission or an LLL text.", show_default=False)],
    after: Annotated[Path, typer.Argument(metavar="B", help="Another of the same kind.", show_default=False)],
    as_json: Annotated[bool, typer.Option("--json", help="Give a list of JSON objects.")] = False,
) -> None:
    """Say what is different between two `.krt` missions (or pictures that carry one), or two `.lll` texts, in words.

    The layout of the files does not count. The exit status is that of `diff`: 0 when they are equal, 1 when they
    differ, 2 when one of them cannot be read.
    """
    from kitrobot.versions.file_comparison import compare_files

    found = compare_files(before, after)
    if as_json:
        print_data(json_text([asdict(one) for one in found], 2) + "\n")
    else:
        print_data("".join(f"{one.sentence}\n" for one in found))
    if found:
        raise typer.Exit(DIFFERENT)
