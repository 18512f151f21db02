"""`kitrobot run --fail-sweep`."""

from __future__ import annotations

import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import pytest

from kitrobot.cli.sweep import with_values
from kitrobot.sim.sweep import SweepStoppedError
from kitrobot.workspace import sweep as sweeping
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.sweep import SweepError, SweepOptions, run_sweep
from tests.cli.conftest import EXAMPLE
from tests.patience import PATIENCE_S

EXAMPLES = EXAMPLE.parents[1]


@pytest.fixture
def exchange(here):
    """A short mission of four robots, and its world."""
    shutil.copytree(EXAMPLES / "exchange", here, dirs_exist_ok=True)
    return here / "exchange.krt"


def test_every_robot_fails_at_every_moment_and_the_table_counts_what_came_of_it(kitrobot, exchange):
    said = kitrobot("run", exchange, "--fail-sweep", 2, "--jobs", 1)
    assert (said.status, said.err) == (0, "")
    assert said.out.startswith("Without these failures: Done after 22.9 s")
    assert "  robot-4       2       0       0       0\n" in said.out
    assert "  all           8       0       0       0\n" in said.out
    assert "8 of 8, at 2 moments" in said.out


def test_json_and_the_map_are_the_same_for_any_number_of_processes_and_say_what_is_where(kitrobot, exchange):
    text = exchange.read_text().replace("</label>", " &amp; &lt;more&gt;</label>", 1)
    exchange.write_text(text)
    found, maps = [], []
    for jobs in (1, 2):
        said = kitrobot("run", exchange, "--fail-sweep", 2, "--jobs", jobs, "--json", "--output", "map.svg")
        assert said.status == 0
        found.append(said.json)
        assert set(found[-1].pop("timing")) == {"real_seconds"}
        maps.append((exchange.parent / "map.svg").read_bytes())
    assert found[0] == found[1]
    assert maps[0] == maps[1]
    titles = [title.text for title in ElementTree.fromstring(maps[0]).iter("{http://www.w3.org/2000/svg}title")]
    assert titles[0] == "Change of groups & <more>: an agent fails"
    assert "robot-2 at 0.0 to 11.4 s: done" in titles, titles
    assert found[0]["moments"] == [0.0, 11.42]
    assert found[0]["counts"] == {"done": 8, "failed": 0, "stuck": 0, "time": 0}
    assert found[0]["complete"] is True
    assert "timing" not in found[0]["baseline"]
    first = found[0]["fields"][1]
    assert first["failures"] == [{"agent": "robot-1", "at": 11.42}]
    assert (first["outcome"], first["sentence"][:5]) == ("done", "Done ")


def test_pairs_fail_one_after_the_other_or_at_once(kitrobot, exchange):
    said = kitrobot("run", exchange, "--fail-sweep", 2, "--pairs", "--jobs", 1, "--json", "-o", "map.svg")
    fields = said.json["fields"]
    assert len(fields) == said.json["total"] == 6 * 4
    assert len({str(field["failures"]) for field in fields}) == 24
    assert all(one["failures"][0]["at"] <= one["failures"][1]["at"] for one in fields)
    outcomes = {field["outcome"] for field in fields}
    assert said.status == (0 if outcomes <= {"done", "failed"} else 1)
    names = [text.text for text in ElementTree.parse("map.svg").iter("{http://www.w3.org/2000/svg}text")]
    assert {"robot-1", "robot-2", "robot-3", "robot-4"} <= set(names)


def test_what_is_not_done_gives_the_status_1_and_a_reason(kitrobot, here):
    shutil.copy(EXAMPLES / "transport" / "transport.krt", here / "transport.krt")
    said = kitrobot("run", "transport.krt", "--fail-sweep", 1, "--jobs", 1)
    assert said.status == 1
    assert "  stuck, carrier-1, 1 in all, at 0.0 s: Nothing can change any more" in said.out


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        (("--pairs",), "of a sweep"),
        (("--jobs", "2"), "of a sweep"),
        (("-o", "map.svg"), "of a sweep"),
        (("--fail-sweep", "--trace", "t.krtrace"), "not recorded"),
        (("--fail-sweep", "-1"), "--fail-sweep"),
        (("--fail-sweep", "--jobs", "0"), "--jobs"),
    ],
)
def test_what_does_not_go_together_is_refused(kitrobot, exchange, arguments, word):
    before = exchange.read_bytes()
    said = kitrobot("run", "exchange.krt", *arguments)
    assert said.status == 2
    assert word in " ".join(said.err.replace("│", " ").split())
    assert exchange.read_bytes() == before


@pytest.mark.parametrize(
    ("arguments", "words"),
    [(("--fail-sweep", "10001"), "1 to 10000 moments"), (("--fail-sweep", "3", "--jobs", "257"), "1 to 256 processes")],
)
def test_too_much_is_refused_with_a_sentence(kitrobot, exchange, arguments, words):
    said = kitrobot("run", exchange, *arguments)
    assert said.status == 1
    assert words in said.err


def test_very_many_fields_are_refused_before_they_are_run(exchange, monkeypatch):
    monkeypatch.setattr(sweeping, "MOST_FIELDS", 7)
    with pytest.raises(SweepError, match="8 fields; at most 7"):
        run_sweep(open_mission(exchange).prepare(RunOptions(1, 600.0)), SweepOptions(2, jobs=1))


def test_a_map_that_cannot_be_written_is_told(kitrobot, exchange):
    said = kitrobot("run", exchange, "--fail-sweep", 1, "--jobs", 1, "-o", "no/such/folder/map.svg")
    assert said.status == 1
    assert "error: " in said.err


def test_what_is_behind_the_options_may_be_left_out():
    assert with_values(["run", "m.krt", "--fail-sweep"]) == ["run", "m.krt", "--fail-sweep", "0"]
    assert with_values(["run", "--fail-sweep", "m.krt"]) == ["run", "--fail-sweep", "0", "m.krt"]
    assert with_values(["--fail-sweep", "7", "x"]) == ["--fail-sweep", "7", "x"]
    assert with_values(["--fail-sweep", "--json"]) == ["--fail-sweep", "0", "--json"]
    assert with_values(["--", "--fail-sweep"]) == ["--", "--fail-sweep"]
    assert with_values(["run", "m.krt", "--watch"]) == ["run", "m.krt", "--watch", ""]
    assert with_values(["team", "--watch", "m.krt", "--json"]) == ["team", "--watch", "", "m.krt", "--json"]
    assert with_values(["--watch", "--json", "--watch", "done"]) == ["--watch", "", "--json", "--watch", "done"]


def test_ctrl_c_ends_with_what_was_found_and_says_how_far_it_came(kitrobot, exchange, monkeypatch):
    def interrupted(prepared, simulation, tasks, jobs, work, stop):
        every = real(prepared, simulation, tasks, 1, work, stop)
        yield from (found for found, _ in zip(every, range(3), strict=False))
        raise KeyboardInterrupt

    real = sweeping._run
    monkeypatch.setattr(sweeping, "_run", interrupted)
    sweep = run_sweep(open_mission(exchange).prepare(RunOptions(1, 600.0)), SweepOptions(2, jobs=1))
    assert (len(sweep.fields), sweep.total, sweep.complete, sweep.holds) == (3, 8, False, False)
    assert sweep.to_json()["complete"] is False
    said = kitrobot("run", exchange, "--fail-sweep", 200, "--jobs", 2, "-o", "m.svg")
    assert said.status == 130
    assert "Without these failures: Done" in said.out
    assert "broken off after" in said.err
    assert "of 800 fields" in said.err
    assert (exchange.parent / "m.svg").exists()


@pytest.mark.parametrize("jobs", [1, 2])
def test_whoever_asks_for_the_end_gets_what_was_found(exchange, jobs):
    over = []
    prepared = open_mission(exchange).prepare(RunOptions(1, 600.0))
    sweep = run_sweep(prepared, SweepOptions(2, jobs=jobs), lambda done, total: over.append(done), lambda: bool(over))
    assert 1 <= len(sweep.fields) < sweep.total == 8
    with pytest.raises(SweepStoppedError):
        run_sweep(prepared, SweepOptions(2, jobs=jobs), stop=lambda: True)


PROBE = """
import os, signal, sys
from pathlib import Path
from kitrobot.cli.app import main
from kitrobot.workspace import sweep

real = sweep._run

def watched(*given):
    for number, found in enumerate(real(*given)):
        yield found
        if number == 2:
            os.kill(os.getpid(), signal.SIGINT)

sweep._run = watched
if __name__ == "__main__":
    main(sys.argv[1:])
"""


@pytest.mark.thorough("test_ctrl_c_ends_with_what_was_found_and_says_how_far_it_came; test_whoever_asks_for_the_end")
@pytest.mark.skipif(sys.platform == "win32", reason="no such signal")
def test_an_interrupted_sweep_of_several_processes_ends_and_says_how_far_it_came(exchange):
    (exchange.parent / "probe.py").write_text(PROBE)
    command = [sys.executable, "probe.py", "run", "exchange.krt", "--fail-sweep", "200", "--jobs", "2", "-o", "m.svg"]
    ended = subprocess.run(command, capture_output=True, cwd=exchange.parent, timeout=PATIENCE_S, check=False)
    assert ended.returncode == 130, ended.stderr
    assert b"Without these failures: Done" in ended.stdout
    assert b"broken off after" in ended.stderr
    assert b"of 800 fields" in ended.stderr
    assert b"Traceback" not in ended.stderr
    assert (exchange.parent / "m.svg").exists()
