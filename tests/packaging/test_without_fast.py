"""What is installed without the extras is enough: every command works, or says in a sentence what it needs."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from tests.patience import PATIENCE_S

ROOT = Path(__file__).parents[2]
SCENARIO = Path(__file__).with_name("without_packages.py")
WORKS = {
    "run",
    "replay",
    "verify",
    "check",
    "convert",
    "format",
    "diff",
    "exec",
    "maze",
    "boards",
    "merge",
    "grade",
}


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[str, int, str, str]]:
    """Command, status, output and messages of each call."""
    folder = tmp_path_factory.mktemp("without")
    ran = subprocess.run(
        [sys.executable, str(SCENARIO), str(ROOT), str(folder)],
        capture_output=True,
        text=True,
        check=False,
        timeout=PATIENCE_S,
    )
    assert ran.returncode == 0, ran.stderr
    return [tuple(one) for one in json.loads(ran.stdout)]


def test_every_command_works_without_numpy_numba_and_orjson(told: list[tuple[str, int, str, str]]) -> None:
    assert {words for words, *_ in told} >= WORKS
    ended = [(command, status) for command, status, *_ in told if command in WORKS]
    # A heart does not end in five seconds, a recording goes into no MCAP file, a check of 500 states is not finished,
    # an exercise is not done by itself, and nothing is sent to ROS 2.
    failed = [("run", 1), ("convert", 1), ("verify", 3), ("grade", 1), ("run", 1)]
    assert [one for one in ended if one[1] != 0] == failed
    assert [said for _, _, out, said in told if "Traceback" in out + said or "itself went wrong" in said] == []
    assert told[0][2].startswith("Done after 59.3 s: B holds all 12 boxes.")


def test_what_needs_a_package_says_how_to_install_it(told: list[tuple[str, int, str, str]]) -> None:
    needs = (("team", "eclipse-zenoh", "fleet"), ("run", "eclipse-zenoh", "fleet"), ("convert", "numpy", "ros"))
    for wanted, package, extra in needs:
        *_, said = [said for command, status, _, said in told if command == wanted and status == 1]
        assert f"`{package}`" in said
        assert f"pip install kitrobot[{extra}]" in said


def test_a_short_run_says_nothing_of_what_would_make_it_faster(told: list[tuple[str, int, str, str]]) -> None:
    assert [out + said for _, _, out, said in told if "[fast]" in out + said] == []


def test_numba_and_numpy_are_the_extra_fast_and_make_installs_it() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]

    def names(lines: list[str]) -> set[str]:
        return {re.match(r"[\w-]+", line)[0] for line in lines}  # type: ignore[index]

    assert names(project["optional-dependencies"]["fast"]) == {"numba", "numpy"}
    assert not names(project["dependencies"]) & {"numba", "numpy"}
    for file in ("Makefile", "tools/lock.sh"):
        assert "'.[cluster,data,dev,docs,fast,fleet,https,plot,ros]'" in (ROOT / file).read_text(encoding="utf-8")
