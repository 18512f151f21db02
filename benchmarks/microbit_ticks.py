"""Ticks of gallery programs on the slowest board of the kits of a micro:bit, that of 2016, by the board's own clock.

    python -m benchmarks.microbit_ticks          measure (ten minutes)
    python -m benchmarks.microbit_ticks --write  and write it down for docs/kits.md (tools/microbit-ticks.json)

Of each kit the program that leaves least memory of those that run there (`tools.microbit_kits`), and programs that
drive. They run as they are deployed, on the firmware in QEMU (`benchmarks.firmware_probe`), with no listener: the range
finder sees something else each time, and the eyes for the ground see lines come and go.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from itertools import pairwise

from benchmarks.firmware_probe import FirmwareProbe, ProbedCall, open_probe
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.deploy.microbit_2016.flash import Flash
from kitrobot.primitives.kit import Kit
from kitrobot.robots.program import BoardProgram
from kitrobot.workspace.mission_loader import open_mission
from tests.patience import PATIENCE_S
from tools.kit_pages import REPOSITORY, TICKS_2016, TickRow, measured_2016
from tools.microbit_kits import programs, small_kits

TICKS = 500
DRIVING = ("square/square", "line-follower/line-follower")
_SETTLING = 20
"""Ticks that do not count: the board is still late from its answer to the deployment."""

_EYES = (22, 23)
"""The pins of the processor where the eyes of Maqueen and Cutebot are: P14 and P13."""

_LOOK_S = 0.05
_IDLE = 200
"""A program has ended when the loop did so much without a tick."""

_NEAR = 4
"""Behind the end of a tick the loop asks so soon for the next one."""


@dataclass(frozen=True)
class Tick:
    """When it began and was done, in us; by how many ms it was done after the next one was due."""

    begun_us: int
    done_us: int
    over_ms: int


def ticks_of(calls: Sequence[ProbedCall], period_ms: int) -> list[Tick]:
    """The ticks that are whole in these calls: the loop asks whether one is due, does it, and adds a period to that."""
    found = []
    before = 0
    for at, end in enumerate(calls):
        if not end.is_end or end.second != period_ms:
            continue
        due = end.first
        begin = next((one for one in calls[before:at] if not one.is_end and one.first == due <= one.second), None)
        after = next((one for one in calls[at : at + _NEAR] if not one.is_end and one.first == due + period_ms), None)
        if begin is not None and after is not None:
            found.append(Tick(begin.at_us, end.at_us, max(0, after.second - after.first)))
        before = at
    return found


def spread(values: Sequence[float]) -> tuple[float, float, float]:
    """The median, 99 of 100, the worst; zeros where there is none."""
    ordered = sorted(values) or [0.0]
    return ordered[len(ordered) // 2], ordered[len(ordered) * 99 // 100], ordered[-1]


def row_of(runs: Sequence[Sequence[Tick]], period_ms: int, free: tuple[int, int], flash: int) -> TickRow:
    """What is written down of a program's runs."""

    def ms(values: Sequence[int]) -> list[float]:
        return [round(value / 1000, 1) for value in spread(values)]

    ticks = [tick for run in runs for tick in run]
    late = [tick.over_ms for tick in ticks if tick.over_ms]
    apart = [later.begun_us - earlier.begun_us for run in runs for earlier, later in pairwise(run)]
    return TickRow(
        ticks=len(ticks),
        late=len(late),
        late_ms=[int(value) for value in spread(late)],
        takes_ms=ms([tick.done_us - tick.begun_us for tick in ticks]),
        off_ms=ms([abs(one - 1000 * period_ms) for one in apart]),
        free=list(free),
        flash=flash,
    )


def measured(program: BoardProgram, ticks: int = TICKS) -> TickRow:
    """A program on a board of its own.

    Raises:
        BoardError: it does not start.
        RuntimeError: a part failed, or it does not get on with its ticks.
    """
    period_ms = program.names.tick_ms
    with open_probe() as found:
        done = deploy(found.board.address, program.file.to_bytes(), program.package, fresh=True)
        found.start_clock()
        runs: list[list[Tick]] = []
        with connect(found.board.address, 20) as board:
            while (left := ticks - sum(map(len, runs))) > 0:
                board.stop()
                board.start()
                runs.append(_ran(found, left, period_ms))
                hello = board.greet()
                if hello.state_name == "fault":
                    fault = board.last_fault()
                    raise RuntimeError(program.names.fault_text(fault.text) if fault is not None else "a fault")
            board.quit()
        return row_of(runs, period_ms, (done.free, hello.free), _flash_left(found.board.address))


def _ran(found: FirmwareProbe, ticks: int, period_ms: int) -> list[Tick]:
    """So many ticks of a program that was just started, behind those that do not count; fewer where it ends."""
    found.forget_calls()
    until = time.monotonic() + PATIENCE_S
    calls: list[ProbedCall] = []
    looks = 0
    while sum(one.is_end and one.second == period_ms for one in calls) <= _SETTLING + ticks:
        if time.monotonic() > until:
            raise RuntimeError("the board does not get on with its ticks")
        time.sleep(_LOOK_S)
        for number, pin in enumerate(_EYES):
            found.set_pin(pin, bool(looks // (1 + number) % 2))
        looks += 1
        calls += found.calls()
        if len(calls) > _IDLE and not any(one.is_end and one.second == period_ms for one in calls[-_IDLE:]):
            break
    return ticks_of(calls, period_ms)[_SETTLING : _SETTLING + ticks]


def _flash_left(address: str) -> int:
    line = Line(address)
    try:
        receiver = Receiver(RawRepl(line))
        receiver.begin()
        flash = Flash.of(receiver)
        return flash.free if flash is not None else 0
    finally:
        line.close()


def chosen(kit: Kit) -> list[str]:
    """The missions that are measured on a kit: the one that leaves least memory, and those that drive."""
    fits = {
        mission: int(row[kit.name]["free"])
        for mission, row in measured_2016().items()
        if "free" in row.get(kit.name, {}) and not mission.startswith(("exercises", "tutorials"))
    }
    return list(dict.fromkeys([min(fits, key=lambda one: fits[one]), *(one for one in DRIVING if one in fits)]))


def largest_program(mission: str, kit: Kit) -> BoardProgram:
    """Of a mission's programs the one that is longest on the board."""
    opened = open_mission(REPOSITORY / "examples" / f"{mission}.krt")
    return max((made for _, made in programs(opened, kit)), key=lambda made: len(made.file.to_bytes()))


def main(words: list[str]) -> int:
    rows: dict[str, dict[str, TickRow]] = {}
    with tempfile.TemporaryDirectory() as nobody:
        os.environ["KITROBOT_CONFIG"] = nobody
        for name, kit in small_kits().items():
            for mission in chosen(kit):
                row = measured(largest_program(mission, kit))
                rows.setdefault(name, {})[mission] = row
                print(name, mission, json.dumps(asdict(row)), flush=True)
    if "--write" in words:
        lines = [
            f" {json.dumps(kit)}: {{\n"
            + ",\n".join(f"  {json.dumps(mission)}: {json.dumps(asdict(row))}" for mission, row in found.items())
            + "\n }"
            for kit, found in rows.items()
        ]
        TICKS_2016.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8", newline="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
