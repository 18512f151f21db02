"""`kitrobot replay`, and recordings given to the studio."""

from __future__ import annotations

import signal
import subprocess
import sys

import pytest

import kitrobot
from kitrobot.trace.reader import TraceReader
from tests.cli.conftest import EXAMPLE
from tests.patience import PATIENCE_S

CHILD = """
import sys
from pathlib import Path
import kitrobot

def stop_there(seconds):
    if seconds > 24:
        print("now", flush=True)
        sys.stdin.read()

kitrobot.open(sys.argv[1]).run(seed=1, trace=Path(sys.argv[2]), progress=stop_there)
"""


@pytest.fixture(scope="module")
def recording(tmp_path_factory):
    """The bytes of a recording of the example."""
    path = tmp_path_factory.mktemp("recorded") / "a.krtrace"
    kitrobot.open(EXAMPLE).run(seed=1, trace=path)
    return path.read_bytes()


@pytest.fixture
def recorded(recording, here):
    """A recording of the example."""
    (here / "a.krtrace").write_bytes(recording)
    return here / "a.krtrace"


def test_everything_that_happened_is_told_with_how_it_ended(kitrobot, recorded):
    said = kitrobot("replay", recorded)
    assert (said.status, said.err) == (0, "")
    lines = said.out.splitlines()
    assert lines[0].endswith("of 7 robots in ring, seed 1")
    assert "  00:03.52  loader           load     a box from A" in lines
    assert lines[-1].startswith("Done after")


def test_json_holds_the_same(kitrobot, recorded):
    found = kitrobot("replay", recorded, "--json").json
    assert (found["outcome"], found["seed"], found["world"], found["cut"]) == ("done", 1, "ring", False)
    assert found["seconds"] == pytest.approx(found["ticks"] * 0.02)
    kinds = [event["kind"] for event in found["events"]]
    assert kinds.count("load") == kinds.count("unload") == 12
    assert {event["cause"] for event in found["events"]} == {"program"}


def test_a_moment_is_told_with_where_everybody_stands(kitrobot, recorded):
    said = kitrobot("replay", recorded, "--at", 12.5)
    assert said.out.startswith("00:12.50 (tick 625)\n")
    assert "carrier-1: running, at " in said.out
    assert "stands at Parallelism (v3)" in said.out
    assert "Run = 1" in said.out
    found = kitrobot("replay", recorded, "--at", 12.5, "--json").json
    assert (found["tick"], found["seconds"]) == (625, 12.5)
    assert found["agents"]["carrier-1"]["values"]["Run"] == 1
    assert sum(found["stock"].values()) <= 12
    end = kitrobot("replay", recorded, "--at", 1e9, "--json").json
    assert end["stock"] == {"A": 0, "B": 12}
    assert kitrobot("replay", recorded, "--at", 0, "--json").json["tick"] == 0


@pytest.mark.parametrize("at", ["-1", "nan", "inf", "soon"])
def test_a_moment_that_is_none_is_refused(kitrobot, recorded, at):
    assert kitrobot("replay", recorded, "--at", at).status == 2


def test_a_cut_recording_is_told_up_to_the_cut(kitrobot, recorded, here):
    data = recorded.read_bytes()
    (here / "cut.krtrace").write_bytes(data[: len(data) * 2 // 3])
    said = kitrobot("replay", "cut.krtrace")
    assert said.status == 0
    assert said.out.endswith("The recording was cut off here.\n")
    assert kitrobot("replay", "cut.krtrace", "--json").json["outcome"] == "cut"


@pytest.mark.parametrize("data", [b"", b"KRTRACE\n", b"<kitrobot/>", b"KRTRACE\n\x01\0" + b"\0" * 20])
@pytest.mark.parametrize("command", ["replay", "studio"])
def test_what_is_no_recording_is_a_sentence(kitrobot, here, data, command):
    (here / "bad.krtrace").write_bytes(data)
    said = kitrobot(command, "bad.krtrace")
    assert (said.status, said.out) == (1, "")
    assert said.err.startswith("error: ")
    assert "KitRobot itself" not in said.err


def test_a_file_that_is_not_there_is_a_sentence(kitrobot, here):
    said = kitrobot("replay", "none.krtrace")
    assert (said.status, said.out) == (1, "")
    assert "cannot be read" in said.err


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGKILL")
def test_a_run_that_is_killed_leaves_what_it_recorded(here):
    path = here / "k.krtrace"
    child = [sys.executable, "-c", CHILD, str(EXAMPLE), str(path)]
    with subprocess.Popen(child, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as run:
        assert run.stdout is not None
        assert run.stdout.readline() == "now\n"
        run.send_signal(signal.SIGKILL)
        run.wait(PATIENCE_S)
    with TraceReader(path) as reader:
        assert reader.cut
        ticks = [record.tick for record in reader]
    assert ticks == list(range(1000))
