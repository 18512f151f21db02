"""Recorded runs: the same seed gives the same bytes, also in another process, and the trace says what happened."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from kitrobot.sim.recorder import Recorder, simulate
from kitrobot.sim.simulation import Simulation
from kitrobot.trace.reader import TraceReader
from tests.effort import cases
from tests.patience import PATIENCE_S
from tests.sim.building import catalogue, empty_world, run_of, transport

ROOT = Path(__file__).parents[2]
CHILD = """
import sys
from pathlib import Path
from kitrobot.sim.recorder import simulate
from tests.sim.building import transport
simulate(transport(5, 3, 2), Path(sys.argv[1]))
"""


def test_the_same_seed_gives_the_same_bytes_and_another_seed_others(tmp_path: Path) -> None:
    traces = []
    for number, seed in enumerate((5, 5, 6)):
        path = tmp_path / f"{number}.krtrace"
        simulate(transport(seed, 3, 2), path)
        traces.append(hashlib.sha256(path.read_bytes()).hexdigest())
    assert traces[0] == traces[1] != traces[2]


@pytest.mark.parametrize("hash_seed", cases(["12345"], ["0"]))
def test_another_process_gives_the_same_bytes(tmp_path: Path, hash_seed: str) -> None:
    simulate(transport(5, 3, 2), tmp_path / "here.krtrace")
    there = tmp_path / "there.krtrace"
    environment = {"PYTHONHASHSEED": hash_seed, "PYTHONPATH": f"{ROOT}:{ROOT / 'src'}"}
    subprocess.run(
        [sys.executable, "-c", CHILD, str(there)], check=True, env=environment, cwd=tmp_path, timeout=PATIENCE_S
    )
    assert there.read_bytes() == (tmp_path / "here.krtrace").read_bytes()


def test_watching_a_run_does_not_change_it(tmp_path: Path) -> None:
    watched, alone = transport(2, 2, 2), transport(2, 2, 2)
    looks: list[float] = []
    simulate(watched, tmp_path / "a.krtrace", lambda run: looks.append(run.agents[0].x_mm))
    simulate(alone)
    assert (watched.tick, watched.poses()) == (alone.tick, alone.poses())
    assert len(looks) == watched.tick // 250


def test_a_trace_says_what_the_run_did(tmp_path: Path) -> None:
    path = tmp_path / "a.krtrace"
    run = transport(1, 2, 2)
    told: list[Any] = []
    recorder = Recorder(run)
    told.append((recorder.record(), []))
    while run.outcome is None:
        run.step()
        told.append((recorder.record(), list(run.events)))
    simulate(transport(1, 2, 2), path)
    with TraceReader(path) as reader:
        assert reader.header == recorder.header
        assert reader.outcome["outcome"] == "done"
        assert reader.outcome["delivered"] == run.delivered
        assert list(reader) == [record for record, _ in told]
        last = reader.seek(reader.last_tick)
    values = last.values(recorder.header)
    assert values[""]["stock B"] == 2
    assert values["carrier-1"]["x_mm"] == pytest.approx(run.agents[0].x_mm, abs=0.051)
    assert values["store-manager-B"]["variable Run"] == 0
    kinds = [event.kind for _, events in told for event in events]
    assert kinds.count("load") == kinds.count("unload") == 2
    assert kinds.count("end") == 6


def test_a_run_that_is_broken_off_leaves_a_trace_that_says_so(tmp_path: Path) -> None:
    path = tmp_path / "a.krtrace"
    run = simulate(transport(1), path, lambda run: run.tick >= 500)
    assert run.outcome is None
    with TraceReader(path) as reader:
        assert reader.outcome["outcome"] == "stopped"
        assert reader.last_tick == 500


def test_a_command_that_says_again_what_a_device_does_is_recorded_once() -> None:
    mini = catalogue().robots["mini-robot"]
    text = "*[Run.IsTrue()]( Light.LightOn(); );"
    run = run_of({"a": (mini, text)}, empty_world(a=(1000, 1000, 0)))
    recorder = Recorder(run)
    given = 0
    for _ in range(20):
        run.step()
        given += len(recorder.record().commands)
    assert given == 1


def test_an_hour_of_ten_busy_robots_stays_below_20_megabytes(tmp_path: Path) -> None:
    mini = catalogue().robots["mini-robot"]
    busy = "Wheel.Advance(30); Motor.Turn(20); WAIT(11); Motor.Turn(7); Light.LightOn(); WAIT(7); Light.LightOff();"
    text = f"*[Run.IsTrue()]( {busy} );"
    starts = {f"r{n}": (400.0 + n % 5 * 700, 600.0 + n // 5 * 1200, float(n)) for n in range(10)}
    run: Simulation = run_of(dict.fromkeys(starts, (mini, text)), empty_world(**starts), seconds=60)
    path = tmp_path / "a.krtrace"
    simulate(run, path)
    assert path.stat().st_size * 60 < 20_000_000
