"""The files here: `# expect CODE` stands on each guilty line, `# at TICK…` on each line whose command is given.

Heads of files: `# robot NAME`; for runs `# given TICK: NAME=VALUE…` (sensors, `done:ACTUATOR`) and `# ends TICK`. After
`# at TICK…` a `: COMMAND` says the command where it is not the last call on the line.
"""

from __future__ import annotations

import re
from collections import defaultdict
from pathlib import Path

import pytest

from kitrobot.compiler.compilation import compile_text
from kitrobot.lll.parse_results import parse
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.robot import Robot
from tests.semantics.engines import start
from tests.semantics.facts import written

HERE = Path(__file__).parent
EXPECT = re.compile(r"# expect (.+)$")
AT = re.compile(r"# at ([0-9 ]+?)\s*(?:: (.+))?$")
GIVEN = re.compile(r"# given ([0-9]+): (.+)$")
CALL = re.compile(r"\w+\.\w+\([^()]*\)")


def files(folder: str) -> list[object]:
    return [pytest.param(path, id=path.stem) for path in sorted((HERE / folder).glob("*.lll"))]


def head(text: str, word: str) -> str:
    found = re.search(rf"(?m)^# {word} (.+)$", text)
    assert found is not None, f"expected a line `# {word} …`"
    return found[1].strip()


def robot_of(text: str) -> Robot:
    return load_catalogue().robots[head(text, "robot")]


@pytest.mark.parametrize("path", files("mistakes"))
def test_each_mistake_is_found_on_its_line_and_nothing_else(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    expected = [
        (number, code)
        for number, line in enumerate(text.splitlines(), 1)
        if (found := EXPECT.search(line))
        for code in found[1].split()
    ]
    problems = compile_text(text, robot_of(text), path.name).diagnostics
    places = [(problem.place.line, problem.code) for problem in problems if problem.place is not None]
    assert sorted(places) == expected
    for problem in problems:
        assert problem.message
        assert problem.place is not None
        assert problem.place.file == path.name


@pytest.mark.parametrize("engine", ["oracle", "machine"])
@pytest.mark.parametrize("path", files("runs"))
def test_each_command_is_given_in_its_ticks_and_no_other(path: Path, engine: str) -> None:
    text = path.read_text(encoding="utf-8")
    expected: dict[int, set[str]] = defaultdict(set)
    given: dict[int, dict[str, int]] = defaultdict(dict)
    for line in text.splitlines():
        if found := AT.search(line):
            for tick in found[1].split():
                command = found[2] or CALL.findall(line[: found.start()])[-1]
                expected[int(tick)].add(command.replace(" ", ""))
        if found := GIVEN.search(line):
            given[int(found[1])] |= {name: int(value) for name, value in re.findall(r"(\S+)=(-?\d+)", found[2])}
    ends = int(head(text, "ends"))
    parsed = parse(text, path.name)
    assert parsed.diagnostics == []
    machine = start(engine, parsed.program, robot_of(text))
    seen: dict[int, set[str]] = {}
    ended = None
    for tick in range(ends + 5):
        sensors = {name: value for name, value in given[tick].items() if not name.startswith("done:")}
        done = {name[5:]: bool(value) for name, value in given[tick].items() if name.startswith("done:")}
        outcome = machine.tick(sensors, done)
        if outcome.commands:
            seen[tick] = set(written(outcome).split())
        if outcome.ended and ended is None:
            ended = tick
    assert seen == dict(expected)
    assert ended == ends
