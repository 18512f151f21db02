"""Teams as real processes on loopback: they meet over Zenoh, and all of them end with the run."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from kitrobot.fleet.keys import new_key
from kitrobot.workspace.fleets import free_endpoint

ROOT = Path(__file__).resolve().parents[2]
CONVOY = "examples/convoy/convoy.krt"
SEARCH = "examples/shared-search/shared-search.krt"
NAMES = ["robot-1", "robot-2", "robot-3", "robot-4"]


class Started:
    """A command that runs; `lines` are those of its messages that were read."""

    def __init__(self, *words: str) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "kitrobot", *words],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,  # as in `tests.boards.qemu`
        )
        self.lines: list[str] = []

    def until(self, text: str) -> str:
        """Reads messages up to one with this text."""
        assert self.process.stderr is not None
        for line in self.process.stderr:
            self.lines.append(line)
            if re.search(text, line):
                return line
        raise AssertionError(f"never said: {text}\n{''.join(self.lines)}")

    def end(self) -> tuple[int, str, str]:
        """Its status, output and messages."""
        out, rest = self.process.communicate()
        return self.process.returncode, out, "".join(self.lines) + rest


@contextmanager
def started(*words: str) -> Iterator[Started]:
    one = Started(*words)
    try:
        yield one
    finally:
        if one.process.poll() is None:
            one.process.kill()
        one.process.communicate()


def agents_of(team: Started) -> dict[str, int]:
    """The processes that a team started, by the name of the agent."""
    found = {}
    for folder in Path("/proc").iterdir():
        if folder.name.isdigit():
            try:
                parent = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
                words = (folder / "cmdline").read_bytes().decode().split("\0")
            except (OSError, ValueError):
                continue
            if parent == team.process.pid and "--as" in words:
                found[words[words.index("--as") + 1]] = int(folder.name)
    return found


def is_there(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


linux = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="looks for processes in /proc")


@linux
def test_an_agent_that_is_killed_is_told_of_and_all_end_with_the_team_that_started_them() -> None:
    with started("team", SEARCH) as team:
        team.until("hears its team")
        agents = agents_of(team)
        assert len(agents) == 2
        os.kill(agents["robot-2"], signal.SIGKILL)
        team.until(r"robot-2: its process has ended \(status -9\)")
        assert is_there(agents["robot-1"])
        team.process.kill()
        # Their messages go where the team's go, so the last one of them to end closes that.
        team.process.communicate()
    assert not any(map(is_there, agents.values()))


def test_an_agent_elsewhere_needs_the_key_and_the_mission_of_the_team(tmp_path: Path) -> None:
    key, foreign = tmp_path / "key", tmp_path / "foreign"
    key.write_text(new_key())
    foreign.write_text(new_key())
    words = [word for name in NAMES for word in ("--elsewhere", name)]
    where = free_endpoint()
    to = ("--connect", where, "--fleet", "here")
    with started("team", CONVOY, *words, "--key", str(key), "--fleet", "here", "--listen", where) as team:
        team.until("the team is at")
        with started("agent", CONVOY, "--as", "robot-1", "--key", str(foreign), *to):
            team.until("another key than this team's")
        with started("agent", "examples/sumo/sumo.krt", "--as", "strong", "--key", str(key), *to, "--json") as other:
            status, out, _ = other.end()
            assert status == 1
            assert "its mission, its world or its programs are others" in json.loads(out)["error"]["message"]
        team.until("refused: agent strong")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("agent", CONVOY, "--as", "robot-5", "--connect", "tcp/127.0.0.1:1"), "no agent `robot-5`"),
        (("agent", CONVOY, "--as", "robot-1", "--connect", "tcp/127.0.0.1:1"), "needs the key"),
        (("agent", CONVOY, "--as", "robot-1", "--key", "KEY"), "where its team is"),
        (("agent", CONVOY, "--as", "robot-1", "--key", "KEY", "--connect", "nonsense"), "cannot be opened"),
        (("agent", CONVOY, "--as", "robot-1", "--key", "KEY", "--connect", "tls/127.0.0.1:1", "--tls", "."), "ca.pem"),
        (("team", CONVOY, "--elsewhere", "robot-1"), "need the key"),
        (("team", CONVOY, "--elsewhere", "robot-9"), "no agent `robot-9`"),
        (("team", CONVOY, "--lease", "5"), "100 to 60000 ms"),
        (("team", CONVOY, "--pace", "nan"), "0 to 1000"),
        (("team", CONVOY, "--seconds", "0"), "at most"),
        (("team", CONVOY, "--pace", "0.01"), "at a pace of 0.01 a step takes 2000 ms"),
        (("team", CONVOY, "--wait", "nan"), "seconds from 0"),
        (("agent", CONVOY, "--as", "robot-1", "--wait", "-1"), "seconds from 0"),
        (("team", CONVOY, "--stop-on-broken"), "properties that are watched"),
        (("team", CONVOY, "--watch"), "no properties of its own"),
        (("team", CONVOY, "--watch", "never any robot-9 (Captor.LessThan(1))"), "robot-9"),
    ],
)
def test_what_cannot_be_is_told(words: tuple[str, ...], said: str, tmp_path: Path, kitrobot: Any) -> None:
    key = tmp_path / "key"
    key.write_text(new_key())
    found = kitrobot(*(str(key) if word == "KEY" else ROOT / CONVOY if word == CONVOY else word for word in words))
    assert found.status in (1, 2)
    assert said in " ".join(found.err.replace("│", " ").split()), found.err
    assert "Traceback" not in found.err
