"""A board on CPython in a process of its own (`host_board`), with a program of a mission on it."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from kitrobot.boards.programs import load_board_program
from tests.boards.booting import lay
from tests.patience import PATIENCE_S

ROOT = Path(__file__).resolve().parents[2]
PULSE = """<kitrobot version="1">
  <program name="pulse" robot="pulser">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="While"/>
    <vertex id="v2" element="Run.IsTrue"/>
    <vertex id="v3" element="Display.Image"><set name="number">0</set></vertex>
    <vertex id="v4" element="Count.Add"><set name="value">1</set></vertex>
    <vertex id="v5" element="Wait"><set name="duration">3</set></vertex>
    <vertex id="v6" element="Display.Clear"/>
    <vertex id="v7" element="If Then"/>
    <vertex id="v8" element="ButtonA.IsPressed"/>
    <vertex id="v9" element="Count.Add"><set name="value">10</set></vertex>
    <vertex id="v10" element="Wait"><set name="duration">3</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v2" to="v1" at="condition"/>
    <arc from="v1" out="body" to="v3"/>
    <arc from="v3" to="v4"/>
    <arc from="v4" to="v5"/>
    <arc from="v5" to="v6"/>
    <arc from="v6" to="v7"/>
    <arc from="v8" to="v7" at="condition"/>
    <arc from="v7" out="then" to="v9"/>
    <arc from="v9" to="v7" at="return"/>
    <arc from="v7" to="v10"/>
    <arc from="v10" to="v1" at="return"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="pulse"/>
  </team>
</kitrobot>
"""
"""Shows a picture again and again, and counts, faster while the button is pressed; ends when `Run` is set to false."""

PULSER = """<?xml version="1.0" encoding="UTF-8"?>
<robot name="pulser" version="1" tick="20" wait-unit="100">
  <actuator name="Display" device="display">
    <board/>
    <procedure name="Image" stop="Clear"><parameter name="number" min="0" max="9" default="0"/></procedure>
    <procedure name="Clear"/>
  </actuator>
  <sensor name="ButtonA" device="key" type="boolean">
    <board which="a"/>
    <operation name="IsPressed" test="equal" to="1"/>
  </sensor>
  <variable name="Count" type="integer" min="0" max="1000" initial="0"/>
  <variable name="Run" type="boolean" initial="true"/>
</robot>
"""


def write_pulse(folder: Path, broken: bool = False) -> Path:
    """The mission and its robot as files; the mission's. `broken`: the display fails at every command."""
    board = '<board driver="broken" on="do"/>' if broken else "<board/>"
    (folder / "pulser.robot.xml").write_text(PULSER.replace("<board/>", board))
    # The board on this computer has a driver of that name; that there is one at all is looked for here.
    (folder / "broken.driver.py").write_text("def make(settings):\n    raise OSError\n")
    (folder / "pulse.krt").write_text(PULSE)
    return folder / "pulse.krt"


SEEN_PACE = 0.1
"""Where pages of a browser are to see what a robot does before it does the next thing, it goes slower."""


@dataclass
class HostBoard:
    """A running one."""

    address: str
    process: subprocess.Popen[str]

    def pull(self) -> None:
        """It is gone, in the middle of whatever it does."""
        self.process.kill()
        self.process.wait(PATIENCE_S)


@contextmanager
def host_board(mission: Path, program: str, pace: float = 1.0, *, waits: bool = False) -> Iterator[HostBoard]:
    """A board that has a program of a mission; `pace` and `waits` as of `board_with`."""
    with board_with(load_board_program(mission, program=program).file.to_bytes(), pace, waits=waits) as board:
        yield board


@contextmanager
def board_with(data: bytes, pace: float = 1.0, *, waits: bool = False) -> Iterator[HostBoard]:
    """A board that has that program file.

    Args:
        data: the file.
        pace: how fast its clock goes.
        waits: its clock goes with the traffic instead (`clocks.TrafficClock`), for hosts that hold it.
    """
    with tempfile.TemporaryDirectory() as held:
        lay(Path(held), data, generation=1)
        command = [
            sys.executable,
            "-m",
            "tests.boards.host_board",
            held,
            *(["--waits"] if waits else ["--pace", str(pace)]),
        ]
        process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None
        try:
            yield HostBoard(process.stdout.readline().strip(), process)
        finally:
            process.kill()
            process.wait(PATIENCE_S)
            process.stdout.close()
