"""A real robot recorded: a current MicroPython runs what was sent to it, and what it tells is recorded."""

from __future__ import annotations

import json
import signal
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from kitrobot.boards.programs import load_board_program
from kitrobot.files.examples import examples_folder
from kitrobot.primitives.image_name import ImageName
from kitrobot.trace.reader import TraceReader
from kitrobot.workspace.replay import state_at, summary_of
from kitrobot.workspace.traces import open_trace
from tests.boards.host import write_pulse
from tests.boards.modern import ModernBoard, onboard_files
from tests.boards.watching import KITROBOT, LONG_S, called, counts, line_with, watched

COMMANDS = {("Display", "Image"): "v3", ("Display", "Clear"): "v6"}
"""Of the program `pulse`, with the vertices that give them."""
DRIVERS = {
    "display": "class Display:\n    def do(self, name, values):\n        pass\n    def stop(self):\n        pass\n",
    "key": "class Key:\n    def read(self):\n        return 1\n",
}
"""No board without hardware has a display or a key; this key is always down."""


@pytest.fixture
def pulse(tmp_path: Path) -> Path:
    """The mission that counts, with drivers of its own beside it."""
    path = write_pulse(tmp_path)
    for name, text in DRIVERS.items():
        made = f"{text}\n\ndef make(settings):\n    return {name.capitalize()}()\n"
        (tmp_path / f"{name}.driver.py").write_text(made, encoding="utf-8")
    return path


@pytest.fixture
def boards() -> Iterator[list[ModernBoard]]:
    """Two of them."""
    files = {"lib/machine.py": onboard_files()["machine.py"]}
    with ModernBoard(files) as one, ModernBoard(files) as two:
        yield [one, two]


def deployed(*arguments: str) -> None:
    done = called("deploy", *arguments)
    assert done.returncode == 0, done.stderr


def to(*boards: ModernBoard) -> list[str]:
    return [word for board in boards for word in ("--to", board.address)]


def test_what_was_sent_from_here_is_recorded_without_naming_the_mission(
    kit: ModernBoard, pulse: Path, tmp_path: Path
) -> None:
    deployed(str(pulse), *to(kit))
    record = tmp_path / "r.krtrace"

    def enough(heard: list[dict[str, Any]]) -> bool:
        ran = {place["vertex"] for news in heard for place in news.get("ran", [])}
        return len(counts(heard)) > 3 and ran >= {"v3", "v5", "v6", "v10"}

    heard = watched(*to(kit), "--trace", str(record), enough=enough)
    trace = open_trace(record)
    with trace.reader as reader:
        assert not reader.cut
        assert summary_of(trace)["real"]
        # Every number that the robot told is in the recording, and no other.
        name = reader.header.agents[0].name
        told = counts(heard)
        values = [int(record.values(reader.header)[name]["variable Count"]) for record in reader]
        seen = [count for count, before in zip(values, [None, *values], strict=False) if count != before]
        assert seen in (told, [0, *told])
        vertices = reader.header.vertices[ImageName("pulse")]
        stood = {vertices[at] for record in reader for _, at in record.active[0]}
        assert stood == {line["vertex"] for news in heard for line in news.get("active", [])}
        assert stood & {"v5", "v10"}
        ran = {line["vertex"] for news in heard for line in news.get("ran", [])}
        given = {(one.actuator, one.procedure) for record in reader for one in record.commands}
        assert given == {call for call, vertex in COMMANDS.items() if vertex in ran} != set()
        last: dict[str, Any] = state_at(trace, 99)["agents"][name]
        assert (last["state"], last["inputs"], last["x_mm"]) == ("running", {"ButtonA": 1}, None)


def test_two_boards_share_one_recording_and_one_whose_power_is_gone_is_silent_in_it(
    boards: list[ModernBoard], pulse: Path, tmp_path: Path
) -> None:
    deployed(str(pulse), *to(*boards))
    record = tmp_path / "r.krtrace"
    command = [*KITROBOT, "watch", *to(*boards), "--trace", str(record), "--json"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout is not None
    assert process.stderr is not None
    heard: set[str] = set()
    while heard != {board.address for board in boards}:
        line = process.stdout.readline()
        assert line, process.stderr.read()
        heard.add(json.loads(line)["board"])
    boards[1].process.kill()
    assert boards[1].address in line_with("broke", process.stderr)
    while json.loads(process.stdout.readline())["board"] != boards[0].address:
        continue
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=LONG_S)
    assert process.returncode == 1
    assert "recorded in" in said
    names = [board.address.removeprefix("socket://") for board in boards]
    with TraceReader(record) as reader:
        assert not reader.cut
        assert [agent.name for agent in reader.header.agents] == names
        (lost,) = (event for _, event in reader.events if event.kind == "failure")
        assert (lost.agent, lost.text, lost.cause) == (1, "the link is lost", "link")
        end = reader.seek(reader.last_tick)
        values = end.values(reader.header)
        assert [values[name]["doing"] for name in names] == [2, 4]
        assert all(values[name]["variable Count"] > 0 for name in names)
        assert end.active[0]
        assert not end.active[1]


def test_the_mission_of_a_kit_robot_comes_with_its_recording(kit: ModernBoard, tmp_path: Path) -> None:
    folder = examples_folder()
    assert folder is not None
    mission = folder / "kit-rover" / "kit-rover.krt"
    deployed(str(mission), *to(kit))
    heard = watched(*to(kit), "--trace", str(tmp_path / "r.krtrace"), enough=lambda heard: heard[-1].get("active"))
    with TraceReader(tmp_path / "r.krtrace") as reader:
        names = load_board_program(mission).names
        assert {column.name for column in reader.header.columns} >= {f"input {name}" for name in names.sensors}
        assert f'<program name="{names.program}"' in reader.header.mission
        at = {instruction for record in reader for _, instruction in record.active[0]}
        assert at == {place["instruction"] for news in heard for place in news.get("active", [])}
