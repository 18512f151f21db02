"""Measure which programs of the gallery run on a micro:bit of 2016 with each of its kits: its own firmware in QEMU.

python -m tools.microbit_kits                 print what was measured
python -m tools.microbit_kits --write         measure all, and write it down beside this file (twenty minutes)
python -m tools.microbit_kits square cutebot  measure that mission on that kit

Each program that can be sent to a kit is sent with `--fresh`, runs for some ticks, is stopped, started again, and does
a tick on request. What does not do all that counts as not running there, with the reason. docs/kits.md says it
(`tools.kit_pages`). The emulator's bus takes all that is said to motors, and its sensors see nothing: a program with a
range finder counts as running when it came to the fault that none is plugged in.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from typing import Any

from kitrobot.boards.programs import board_program
from kitrobot.boards.teams import agent_program
from kitrobot.deploy.errors import BoardError, FullError, NoMemoryError
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.board import Board
from kitrobot.deploy.line.handshake import connect
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.kit import CHIP_OF_V2, Kit
from kitrobot.robots.program import BoardProgram
from kitrobot.workspace.kit_files import kits_at_hand
from kitrobot.workspace.mission_loader import OpenMission, open_mission
from tools.kit_pages import SMALL, key_of, measured_2016, missions

_TICKS = 15
_NO_ANSWER = "not plugged in"
"""What a range finder says that is asked five times: the emulator has none, and a program that needs one ends so."""

Row = dict[str, dict[str, Any]]
"""By kit: `free`, the fewest bytes that a program of the mission left; or `problem`, and which program has it."""


class FaultError(Exception):
    """A part failed."""


def small_kits() -> dict[str, Kit]:
    """The kits that come along and take a micro:bit of 2016."""
    return {name: kit for name, kit in kits_at_hand().items() if kit.family == "microbit" and kit.chip != CHIP_OF_V2}


def programs(opened: OpenMission, kit: Kit) -> Iterator[tuple[str, BoardProgram]]:
    """The programs of a mission on a kit, that of a team for each of its kinds of robots.

    Raises:
        KitRobotError: the kit lacks something for one of them.
    """
    folder = opened.path.parent if opened.path is not None else None
    for program in opened.mission.programs:
        if program.level.is_team:
            agents = {agent.robot: agent.name for agent in opened.mission.team.agents if agent.program == program.name}
            for agent in agents.values():
                yield program.name, agent_program(opened, agent, folder, kit)
        else:
            yield program.name, board_program(opened, program.name, folder, kit)


def sendable(kit: Kit) -> dict[str, list[tuple[str, BoardProgram]]]:
    """What can be sent to a kit, by mission."""
    found = {}
    for path in missions():
        opened = open_mission(path)
        with suppress(KitRobotError):
            made = list(programs(opened, kit))
            if any(program.file.drivers for _, program in made):
                found[key_of(path)] = made
    return found


def try_out(address: str, program: BoardProgram, *, fresh: bool = True) -> int:
    """Bytes that are left while it runs. `fresh`: what the board holds of KitRobot is removed first.

    Raises:
        BoardError: it does not start, or does not do what it is asked.
        FaultError: a part failed meanwhile.
    """
    done = deploy(address, program.file.to_bytes(), program.package, fresh=fresh)
    with connect(address, 20) as board:
        board.arguments = list(program.names.arguments)
        if program.file.is_member:
            board.begin_member()
            for _ in range(_TICKS):
                board.member_tick({})
        else:
            _run(board)
            board.stop()
            board.start()
            _run(board)
            board.stop()
            board.step({})
        _refuse_fault(board)
        board.stop()
    return done.free


def _run(board: Board) -> None:
    while (hello := board.greet()).state == 2 and hello.tick < _TICKS:
        pass
    _refuse_fault(board)


def _refuse_fault(board: Board) -> None:
    fault = board.last_fault()
    if fault is not None and _NO_ANSWER not in fault.text:
        raise FaultError(f"{fault.meaning}: {fault.text}")


def _problem_of(error: Exception) -> str:
    if isinstance(error, NoMemoryError):
        return "memory"
    return "flash" if isinstance(error, FullError) else str(error).partition("\n")[0]


def measure(kit: Kit, wanted: str = "") -> dict[str, dict[str, Any]]:
    """What runs on a kit, by mission."""
    from tests.boards.qemu import running

    found: dict[str, dict[str, Any]] = {}
    with running("-icount", "shift=6") as board:
        for mission, made in sendable(kit).items():
            if wanted and wanted not in mission.split("/"):
                continue
            row: dict[str, Any] = {"free": 1 << 16}
            known: set[bytes] = set()
            for name, program in made:
                if (data := program.file.to_bytes()) in known:
                    continue
                known.add(data)
                try:
                    row["free"] = min(row["free"], try_out(board.address, program))
                except (BoardError, FaultError) as error:
                    row = {"problem": _problem_of(error), "program": name}
                    board.cut_power()
                    break
            found[mission] = row
            print(kit.name, mission, row, flush=True)
    return found


def main(words: list[str]) -> int:
    if not words:
        print(json.dumps(measured_2016(), indent=1))
        return 0
    with tempfile.TemporaryDirectory() as nobody:
        os.environ["KITROBOT_CONFIG"] = nobody
        kits = small_kits()
        if words != ["--write"]:
            measure(kits[words[1]], words[0])
            return 0
        with ThreadPoolExecutor(2) as pool:
            found = dict(zip(kits, pool.map(measure, kits.values()), strict=True))
    rows: dict[str, Row] = {}
    for kit, by_mission in found.items():
        for mission, row in by_mission.items():
            rows.setdefault(mission, {})[kit] = row
    lines = [f" {json.dumps(mission)}: {json.dumps(rows[mission], sort_keys=True)}" for mission in sorted(rows)]
    SMALL.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8", newline="\n")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
