"""The example with a team, as a fleet: what happens to one of its processes, and what comes of it."""

from __future__ import annotations

import dataclasses
import shutil
from functools import cache
from pathlib import Path

import pytest

from kitrobot.cli.agent import prepare_team_run
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.team_columns import T_HOLDER
from kitrobot.workspace.mission_loader import OpenMission, open_mission, read_mission_data
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.search_path import SearchPath
from tests.fleet.network import Faults, Fleet

CONVOY = Path("examples/convoy/convoy.krt")


@cache
def convoy(rounds: int) -> OpenMission:
    """The example without its scheduled failure, so often there and back."""
    text, twice = CONVOY.read_text(encoding="utf-8"), '<set name="count">2</set>'
    assert twice in text
    data = text.replace(twice, f'<set name="count">{rounds}</set>').encode()
    opened = read_mission_data(data, CONVOY.name, SearchPath(CONVOY.parent))
    return dataclasses.replace(opened, mission=dataclasses.replace(opened.mission, failures=[]))


def anew(rounds: int = 1) -> Simulation:
    return convoy(rounds).prepare(RunOptions(1, 600)).simulation


def fleet(rounds: int = 1) -> Fleet:
    return Fleet(lambda: anew(rounds))


def texts(one: Fleet) -> list[tuple[str, str]]:
    return [(event.agent, event.text) for event in one.events if event.kind != "end"]


def until(one: Fleet, now: int) -> None:
    while one.now < now:
        one.step()


@pytest.mark.thorough("test_boards.py::test_a_fleet_with_boards_comes_to_the_end_of_the_simulator, half of them boards")
def test_a_fleet_comes_to_the_end_of_the_simulator() -> None:
    run, one = anew(), fleet()
    while run.outcome is None:
        run.step()
    one.finish()
    assert one.run.outcome == run.outcome == "done"
    assert one.run.seconds < 1.1 * run.seconds
    assert texts(one) == []


def test_for_a_killed_process_the_spare_robot_takes_over() -> None:
    one = fleet()
    until(one, 2000)
    one.kill(1)
    one.finish()
    assert one.run.outcome == "done"
    told = texts(one)
    assert ("robot-2", "is missed by its team") in told
    assert ("robot-4", "takes over for robot-2") in told
    assert one.run.state.team.robots[T_HOLDER][1] == 3


def test_a_process_that_was_stopped_believes_in_its_role_and_moves_nothing() -> None:
    one = fleet()
    until(one, 1500)
    one.faults = Faults(stopped=frozenset({0}))
    until(one, 6500)
    believes = one.hosts[0]
    assert believes.replica.state.team.robots[T_HOLDER][0] == 0
    assert not believes.may_act(one.now)
    x, y = one.run.poses()[0][:2]
    one.faults = Faults()
    one.finish()
    assert one.run.outcome == "done"
    assert ("robot-1", "begins anew, as a spare one") in texts(one)
    assert one.run.poses()[0][:2] == (x, y)


def test_a_process_that_is_started_again_is_a_spare_one() -> None:
    one = fleet()
    until(one, 1500)
    one.kill(2)
    until(one, 4500)
    one.start(2)
    one.finish()
    assert one.run.outcome == "done"
    assert ("robot-3", "begins anew, as a spare one") in texts(one)
    slots = {host.replica.slot for host in one.hosts.values()}
    packs = [host.replica.packed() for host in one.hosts.values() if host.replica.slot == max(slots)]
    assert all(pack == packs[0] for pack in packs)


def test_a_role_that_nobody_is_left_for_ends_the_run_though_who_was_towed_is_back() -> None:
    opened = open_mission(Path("examples/transport-team/transport-team.krt"))
    one = Fleet(lambda: opened.prepare(RunOptions(1, 600)).simulation)
    until(one, 2500)
    one.faults = Faults(side=frozenset({0, 1, 2}), bodies_too=True)
    until(one, 9500)
    one.faults = Faults()
    one.finish(60_000)
    assert sorted(agent for agent, text in texts(one) if "towed" in text) == ["carrier-1", "carrier-2", "carrier-3"]
    assert one.run.outcome == "failed"
    assert "nobody is left of movers" in one.run.sentence


def test_without_a_majority_all_stand_still_until_it_is_back() -> None:
    one = fleet()
    until(one, 3000)
    one.faults = Faults(side=frozenset({0}), loss=100)
    until(one, 5000)
    assert not any(host.may_act(one.now) for host in one.hosts.values())
    poses = one.run.poses()
    until(one, 7000)
    assert one.run.poses() == poses
    one.faults = Faults()
    one.finish()
    assert one.run.outcome == "done"
    assert not any("missed" in text for _, text in texts(one))


def test_who_was_away_for_more_slots_than_are_kept_adopts_the_tables_of_another() -> None:
    one = fleet(2)
    until(one, 1500)
    one.faults = Faults(side=frozenset({3}), bodies_too=True)
    until(one, 13_000)
    behind = one.hosts[3].replica.slot
    assert one.hosts[0].replica.slot > behind + 32
    one.faults = Faults()
    until(one, 16_000)
    assert one.hosts[3].replication.adopted
    one.finish()
    assert one.hosts[3].replica.packed() == one.hosts[0].replica.packed()
    assert one.run.outcome == "done"


def test_the_emergency_stop_ends_the_right_to_act() -> None:
    one = fleet()
    until(one, 2000)
    assert one.hosts[0].may_act(one.now)
    one.hosts[0].stop()
    assert not one.hosts[0].may_act(one.now)


def test_the_network_is_the_radio_whatever_the_mission_says(tmp_path: Path) -> None:
    for beside in CONVOY.parent.iterdir():
        shutil.copy(beside, tmp_path)
    text = CONVOY.read_text(encoding="utf-8").replace("</kitrobot>", '<radio range="1" loss="100"/></kitrobot>')
    file = tmp_path / "convoy.krt"
    file.write_text(text, encoding="utf-8")
    assert prepare_team_run(file, RunOptions()).simulation.state.radio.numbers == []
