"""What the page about the command line shows is true."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from kitrobot.cli.app import app
from tools.command_outputs import BLOCK, prepared, printed, stale, updated

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "cli.md").read_text(encoding="utf-8")
COMMANDS = [command.name for command in app.registered_commands if command.name]


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_and_every_option_is_on_the_page(kitrobot, command):
    assert f"kitrobot {command}" in PAGE
    for option in set(re.findall(r"--[a-z-]+", kitrobot(command, "--help").out)) - {"--help", "--browser"}:
        assert option in PAGE, f"{command} {option}"


def test_the_outputs_on_the_page_are_those_of_today():
    assert len(BLOCK.findall(PAGE)) >= 6
    assert list(stale()) == [], "run `python -m tools.command_outputs --write`"


def test_an_output_that_is_no_longer_true_is_replaced_and_a_number_of_a_clock_is_kept():
    page = "<!-- prints: kitrobot {} -->\n```\n{}```\n"
    with prepared() as folder:
        old = page.format("run examples/transport/transport.krt --json", "Done\n")
        new = updated(old, folder)
        assert '"outcome": "done"' in new
        other_clock = re.sub(r'"speed": [\d.]+', '"speed": 1.5', new)
        assert updated(other_clock, folder) == other_clock
        assert len(printed("kitrobot replay ring.krtrace | lines 3-4", folder).splitlines()) == 2
