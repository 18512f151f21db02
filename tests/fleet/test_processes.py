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

from kitrobot.fleet import new_key
from kitrobot.trace import TraceReader

CONVOY = "examples/convoy/convoy.krt"
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
@pytest.mark.slow
def test_a_team_of_processes_goes_on_without_one_that_is_killed_and_its_run_is_recorded(tmp_path: Path) -> None:
    trace = tmp_path / "run.krtrace"
    with started("team", CONVOY, "--pace", "4", "--trace", str(trace), "--json") as team:
        team.until("robot-2: fails")
        team.until("takes over for robot-2")
        agents = agents_of(team)
        assert sorted(agents) == NAMES
        os.kill(agents["robot-3"], signal.SIGKILL)
        status, out, said = team.end()
    result: dict[str, Any] = json.loads(out)
    assert (status, result["outcome"]) == (0, "done"), said
    assert "robot-3: its process has ended (status -9)" in said
    assert "robot-3: is missed by its team" in said
    assert not any(map(is_there, agents.values()))
    with TraceReader(trace) as recorded:
        assert (3, "takes over for robot-2") in [(event.agent, event.text) for _, event in recorded.events]
        assert recorded.outcome["outcome"] == "done"
    with started("replay", str(trace)) as replayed:
        assert replayed.end()[0] == 0


@linux
def test_the_emergency_stop_reaches_all_and_everything_ends() -> None:
    with started("team", CONVOY, "--json") as team:
        team.until("hears its team")
        agents = agents_of(team)
        team.process.send_signal(signal.SIGINT)
        status, out, said = team.end()
    result = json.loads(out)
    assert (status, result["outcome"]) == (130, "stopped")
    assert sorted(result["stopped_ms"]) == NAMES, said
    assert not any(map(is_there, agents.values()))


@linux
def test_agents_end_with_the_team_that_started_them() -> None:
    with started("team", CONVOY) as team:
        team.until("hears its team")
        agents = agents_of(team)
        assert len(agents) == 4
        team.process.kill()
        # Their messages go where the team's go, so the last one of them to end closes that.
        team.process.communicate()
    assert not any(map(is_there, agents.values()))


def test_an_agent_elsewhere_needs_the_key_and_the_mission_of_the_team(tmp_path: Path) -> None:
    key, foreign = tmp_path / "key", tmp_path / "foreign"
    key.write_text(new_key())
    foreign.write_text(new_key())
    words = [word for name in NAMES for word in ("--elsewhere", name)]
    with started("team", CONVOY, *words, "--key", str(key)) as team:
        where = team.until("the team is at").split()[-1]
        to = ("--connect", where, "--fleet", "here")
        team.process.kill()
    with started("team", CONVOY, *words, "--key", str(key), "--fleet", "here", "--listen", where) as team:
        team.until("the team is at")
        with started("agent", CONVOY, "--as", "robot-1", "--key", str(foreign), *to):
            team.until("another key than this team's")
        with started("agent", "examples/sumo/sumo.krt", "--as", "strong", "--key", str(key), *to, "--json") as other:
            status, out, _ = other.end()
            assert status == 1
            assert "its mission, its world or its programs are others" in json.loads(out)["error"]["message"]
        team.until("refused strong")


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
    ],
)
def test_what_cannot_be_is_told(words: tuple[str, ...], said: str, tmp_path: Path) -> None:
    key = tmp_path / "key"
    key.write_text(new_key())
    with started(*(str(key) if word == "KEY" else word for word in words)) as one:
        status, _, messages = one.end()
    assert status in (1, 2)
    assert said in " ".join(messages.replace("│", " ").split()), messages
    assert "Traceback" not in messages
