"""Real robots as agents of a team of processes: boards on CPython at the end of a socket, as a person starts them."""

from __future__ import annotations

import json
import socket
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from kitrobot.boards.teams import agent_program
from kitrobot.fleet.keys import new_key
from kitrobot.trace.reader import TraceReader
from kitrobot.workspace.mission_loader import open_mission
from tests.boards.host import HostBoard, board_with
from tests.boards.proxy import Proxy
from tests.fleet.short_convoy import write_short_convoy
from tests.fleet.test_processes import agents_of, is_there, linux, started

NOWHERE = "socket://127.0.0.1:9"


@pytest.fixture
def mission(tmp_path: Path) -> Path:
    """The short convoy."""
    return write_short_convoy(tmp_path)


@pytest.fixture
def boards(mission: Path) -> Iterator[dict[str, HostBoard]]:
    """Boards that have the programs of two agents."""
    opened = open_mission(mission)
    with ExitStack() as stack:
        yield {
            name: stack.enter_context(board_with(agent_program(opened, name).file.to_bytes()))
            for name in ("robot-2", "robot-4")
        }


@linux
@pytest.mark.slow
@pytest.mark.thorough(
    "server/test_fleet_runs.py: processes whose cable is pulled, another board takes over; "
    "test_hosts.py: `kitrobot team` with a board, recorded"
)
def test_a_cable_that_is_pulled_is_an_agent_that_failed_and_another_board_takes_over_and_all_is_recorded(
    mission: Path, boards: dict[str, HostBoard], tmp_path: Path, kitrobot: Any
) -> None:
    trace = tmp_path / "run.krtrace"
    with (
        Proxy(int(boards["robot-2"].address.rpartition(":")[2]), cut_after=90) as cable,
        started(
            *("team", str(mission), "--pace", "4", "--json", "--board", f"robot-2={cable.address}"),
            *("--board", f"robot-4={boards['robot-4'].address}", "--trace", str(trace)),
        ) as team,
    ):
        team.until("robot-2: its board is lost")
        team.until("robot-4: takes over for robot-2")
        agents = agents_of(team)
        assert {"robot-1", "robot-4"} <= agents.keys()
        status, out, said = team.end()
    assert (status, json.loads(out)["outcome"]) == (0, "done"), said
    assert "the line to" in said
    assert "robot-2: is missed by its team" in said
    assert not any(map(is_there, agents.values()))
    with TraceReader(trace) as recorded:
        assert (2, "takes over for robot-2") in [(event.agent, event.text) for _, event in recorded.events]
        assert recorded.outcome["outcome"] == "done"
    assert kitrobot("replay", trace).status == 0


def test_what_cannot_be_a_team_with_boards_is_told(
    mission: Path, boards: dict[str, HostBoard], tmp_path: Path, kitrobot: Any
) -> None:
    key = tmp_path / "key"
    key.write_text(new_key(), encoding="utf-8")
    agent = ("agent", str(mission), "--key", str(key), "--connect", "tcp/127.0.0.1:1")
    other = boards["robot-4"].address
    with socket.create_server(("127.0.0.1", 0)) as silent:
        gone = f"socket://127.0.0.1:{silent.getsockname()[1]}"
    for words, said in [
        (("team", str(mission), "--board", f"robot-9={NOWHERE}"), "no agent `robot-9`"),
        (("team", str(mission), "--board", NOWHERE), "which agent has which board"),
        (("team", str(mission), "--board", "robot-1=x", "--board", "robot-1=y"), "two boards are given"),
        (("team", str(mission), "--board", "robot-1=x", "--board", "robot-2=x"), "both given the board on `x`"),
        (
            ("team", str(mission), "--board", "robot-1=x", "--elsewhere", "robot-1", "--key", str(key)),
            "is started elsewhere",
        ),
        ((*agent, "--as", "robot-1", "--board", gone), "cannot be opened"),
        (("deploy", str(mission), "--team"), "belong together"),
        (("deploy", str(mission), "--board", "robot-1=x"), "belongs to --team"),
        (("deploy", str(mission), "--team", "--board", "robot-1=x", "--to", "y"), "--board says the ports"),
        (("deploy", str(mission), "--team", "--board", f"robot-1={gone}"), "no robot of the team is started"),
        (("deploy", str(mission), "--to", gone), "is the program of a team"),
    ]:
        found = kitrobot(*words)
        assert found.status in (1, 2), words
        assert said in " ".join(found.err.replace("│", " ").split()), found.err
        assert "Traceback" not in found.err
    mission.write_text(mission.read_text(encoding="utf-8").replace(">10<", ">11<"), encoding="utf-8")
    found = kitrobot(*agent, "--as", "robot-4", "--board", other)
    assert found.status == 1
    assert "does not have the program of `robot-4` as it is now" in found.err
