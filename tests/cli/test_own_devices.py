"""The robot of docs/xml.md whose devices are XML alone, on the command line: checked, run, recorded, replayed."""

from __future__ import annotations

from pathlib import Path

from typer.testing import CliRunner

from kitrobot.cli.app import app
from kitrobot.trace.reader import TraceReader
from tests.gardener import gardener


def test_devices_of_ones_own_are_checked_run_and_recorded(tmp_path: Path) -> None:
    mission, trace = gardener(tmp_path), tmp_path / "garden.krtrace"
    call = CliRunner().invoke
    checked = call(app, ["check", str(mission), str(tmp_path / "gardener.robot.xml")])
    assert checked.exit_code == 0, checked.output
    assert "error" not in checked.output
    ran = call(app, ["run", str(mission), "--seconds", "30", "--trace", str(trace)])
    assert "The time of 30 s ran out" in ran.output
    with TraceReader(trace) as reader:
        columns = [(column.owner, column.name) for column in reader.header.columns]
        light, pump = (columns.index(("robot-1", name)) for name in ("input Light", "shown Pump 0"))
        read = [reader.seek(tick).numbers for tick in (0, 125, 250, 500, 1000)]
    assert [numbers[light] for numbers in read][1:] == [45, 90, 90, 0]
    # The soil stays as wet as its slider says, so nothing is watered.
    assert {numbers[pump] for numbers in read} == {0}


def test_a_mistake_in_what_is_simulated_is_told_at_its_line(tmp_path: Path) -> None:
    gardener(tmp_path)
    file = tmp_path / "gardener.robot.xml"
    file.write_text(file.read_text().replace('as="slider"', 'as="slidr"').replace("5:90 15:90", "15:90 5:90"))
    checked = CliRunner().invoke(app, ["check", str(file)])
    assert checked.exit_code == 1
    assert "gardener.robot.xml:14:" in checked.output
    assert "did you mean slider?" in checked.output
    assert "gardener.robot.xml:19:" in checked.output
    assert "seconds:number" in checked.output
