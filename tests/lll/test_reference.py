"""docs/language.md, held to what the code does."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from kitrobot.compiler.program.checker import check
from kitrobot.image import model as images
from kitrobot.image.instructions import OPS
from kitrobot.lll.parse_results import parse, parse_team
from kitrobot.lll.printer import print_team_program
from kitrobot.lll.tree import MAX_NESTING, MAX_NUMBER
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot_onboard.image import FORMAT, HEADER_SIZE
from tests.lll.expectations import meets_expectations

PAGE = (Path(__file__).parents[2] / "docs" / "language.md").read_text(encoding="utf-8")
PROGRAMS = re.findall(r"```lll\n(.*?)```", PAGE, flags=re.DOTALL)


@pytest.mark.parametrize("text", PROGRAMS)
def test_a_program_of_the_reference_says_what_is_wrong_with_it(text: str) -> None:
    parsed = parse(text)
    robot = load_catalogue().robots["mini-robot"]
    meets_expectations(text, parsed.diagnostics + check(parsed.program, robot, parsed.source))


def test_the_reference_has_programs() -> None:
    assert len(PROGRAMS) == 5


def test_the_team_s_program_of_the_reference_is_read_and_laid_out_as_it_stands() -> None:
    [text] = re.findall(r"```team\n(.*?)```", PAGE, flags=re.DOTALL)
    parsed = parse_team(text)
    assert parsed.diagnostics == []
    assert print_team_program(parsed.program) == text


def test_the_reference_lists_every_instruction_in_its_order() -> None:
    table = PAGE.split("| op | operands | does |")[1].split("\n\n")[0]
    assert re.findall(r"^\| `([A-Z]+)`", table, flags=re.MULTILINE) == [op.name for op in OPS]


def test_the_reference_gives_the_limits_there_are() -> None:
    rows = re.findall(r"^\| [^|]+ \| (\d+) \|$", PAGE.split("### Limits")[1].split("\n## ")[0], flags=re.MULTILINE)
    assert list(map(int, rows)) == [
        images.MOST_CELLS,
        images.MOST_SLOTS,
        images.MOST_PARALLELS,
        images.MOST_STOPS,
        images.MOST_COMMANDS,
        images.MOST_ARGUMENTS,
        images.MOST_INSTRUCTIONS,
        MAX_NUMBER,
        images.LARGEST_VALUE,
        MAX_NESTING,
    ]


def test_the_reference_counts_the_bytes_of_the_header() -> None:
    rows = re.findall(r"^\| ([^|]+) \| [^|]+ \|$", PAGE.split("| bytes | hold |")[1], flags=re.MULTILINE)
    fixed = [row for row in rows if "each" not in row][:-1]
    sizes = [int(one) for row in fixed if "×" not in row for one in row.split(",")]
    sizes += [int(size) * int(count) for row in fixed if "×" in row for size, count in [row.split("×")]]
    assert sum(sizes) == HEADER_SIZE
    assert f"format version {FORMAT};" in PAGE
