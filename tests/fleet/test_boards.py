"""Boards in a fleet, on a network in memory: the loop of a robot on CPython, asked over the link."""

from __future__ import annotations

from pathlib import Path
from threading import Event
from typing import Any

import pytest

from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.line.board import Board
from kitrobot.fleet.board_body import REST_MS, Order
from kitrobot.fleet.board_line import LEAST_SILENT_S, BoardLine
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.team_columns import T_AT, T_HOLDER
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot_onboard.state import HELD, STATE
from tests.boards import drivers
from tests.effort import cases
from tests.fleet.bench_boards import bench_boards
from tests.fleet.network import LEASE, STEP, Faults, Fleet
from tests.fleet.test_convoy import anew, texts, until
from tests.fleet.test_outcomes import finish, fleet_and_meaning
from tests.patience import PATIENCE_S


def test_a_fleet_with_boards_comes_to_the_end_of_the_simulator(tmp_path: Path) -> None:
    run = anew()
    while run.outcome is None:
        run.step()
    with bench_boards(run, {0: 15, 2: 0}, tmp_path) as boards:
        one = Fleet(anew, boards=boards)
        one.finish()
    assert one.run.outcome == run.outcome == "done"
    assert one.run.seconds < 1.1 * run.seconds
    assert texts(one) == []


@pytest.mark.parametrize("seed", range(3))
def test_boards_do_the_lines_of_random_teams(seed: int, tmp_path: Path) -> None:
    team, meaning = fleet_and_meaning(seed, 0, 1000)
    apart = range(0, len(team.names), 2)
    with bench_boards(team.anew(), dict.fromkeys(apart, 0), tmp_path) as boards:
        team.fleet.with_boards(boards)
        finish(team)
    assert team.run.outcome == "done", team.run.sentence
    assert team.lines_of_roles() == meaning.lines


def test_a_board_takes_over_from_a_board_whose_line_is_cut(tmp_path: Path) -> None:
    with bench_boards(anew(), {1: 0, 3: 0}, tmp_path) as boards:
        one = Fleet(anew, boards=boards)
        until(one, 2000)
        one.kill(1)
        one.finish()
        cut = boards[1].bench
        cut.wait(1000)
        assert cut.robot[STATE] == 4, "it stops by itself when it hears nothing"
    assert one.run.outcome == "done"
    assert ("robot-4", "takes over for robot-2") in texts(one)
    assert one.run.state.team.robots[T_HOLDER][1] == 3


@pytest.mark.parametrize("moment", cases(["start"], ["meeting"]))
def test_a_board_whose_line_is_cut_at_the_start_or_in_a_meeting_is_taken_over_from(moment: str, tmp_path: Path) -> None:
    with bench_boards(anew(), {1: 0, 3: 0}, tmp_path) as boards:
        one = Fleet(anew, boards=boards)
        if moment == "start":
            while not one.hosts[1].may_act(one.now):
                one.step()
            assert boards[1].bench.robot[STATE] != 2, "it has not begun yet"
        else:
            table = one.run.state.team.robots
            while table[T_AT][1] < 0 or table[T_AT][0] == table[T_AT][1]:
                one.step()
        one.kill(1)
        one.finish()
    assert one.run.outcome == "done"
    assert ("robot-4", "takes over for robot-2") in texts(one)


def test_a_board_that_is_silent_for_a_lease_is_missed_though_its_line_is_open_and_comes_back(tmp_path: Path) -> None:
    with bench_boards(anew(), {1: 0, 3: 0}, tmp_path) as boards:
        one = Fleet(anew, boards=boards)
        until(one, 2000)
        # The line is open, but nothing comes over it.
        boards[1].free_at = one.now + LEASE - STEP
        until(one, one.now + 3 * LEASE)
        assert one.hosts[1].may_act(one.now)
        assert not any("missed" in text for _, text in texts(one))
        boards[1].free_at = one.now + 4 * LEASE
        one.finish()
        until(one, one.now + REST_MS + 50)
        told = texts(one)
        assert one.hosts[1].may_act(one.now) or one.hosts[1].machine.ended
    assert one.run.outcome == "done"
    assert told.index(("robot-2", "is missed by its team")) < told.index(("robot-4", "takes over for robot-2"))


class SilentLine:
    """A line that is open, and over which nothing comes; time passes with waiting."""

    address = "silent"

    def __init__(self) -> None:
        self.at = 0.0

    def write(self, data: bytes) -> None:
        """It goes nowhere."""

    def read(self, timeout_s: float) -> bytes:
        self.at += max(timeout_s, 0.001)
        return b""

    def now(self) -> float:
        return self.at

    def close(self) -> None:
        """Nothing to close."""


@pytest.mark.parametrize(("lease", "seconds"), [(500, LEAST_SILENT_S), (4000, 4.0)])
def test_a_silent_line_is_given_up_after_a_lease_but_not_before_it_was_asked_again(lease: int, seconds: float) -> None:
    silent: Any = SilentLine()
    line = BoardLine(Board(silent))
    woken = Event()
    line.wake = woken.set
    line.set_lease(lease)
    line.order(Order("still"))
    assert woken.wait(PATIENCE_S)
    [done] = line.take_results()
    assert done.error is not None
    assert "silent" in done.error.message
    assert seconds <= silent.at < seconds + 0.1
    line.close()


def test_a_mission_without_a_program_of_a_team_has_boards_too(tmp_path: Path) -> None:
    opened = open_mission(Path("examples/pair/pair.krt"))

    def alone() -> Simulation:
        return opened.prepare(RunOptions(1, 20)).simulation

    run = alone()
    assert opened.team is None
    while run.outcome is None:
        run.step()
    with bench_boards(alone(), {0: 0}, tmp_path) as boards:
        one = Fleet(alone, boards=boards)
        one.finish()
    assert (one.run.outcome, one.run.sentence) == (run.outcome, run.sentence)


def test_a_slow_board_is_there_although_its_ticks_take_long(tmp_path: Path) -> None:
    with bench_boards(anew(), {0: 150}, tmp_path) as boards:
        one = Fleet(anew, boards=boards)
        until(one, 6000)
    assert not any("missed" in text for _, text in texts(one))
    assert one.world.links[0].serial > 150
    assert one.hosts[0].may_act(one.now)


def test_a_board_that_may_not_act_stands_still_and_goes_on_where_it_was(tmp_path: Path) -> None:
    with bench_boards(anew(), {0: 0}, tmp_path) as boards:
        one = Fleet(anew, boards=boards)
        until(one, 3000)
        one.faults = Faults(side=frozenset({0}), loss=100)
        until(one, 3000 + 400 + REST_MS + 200)
        robot = boards[0].bench.robot
        assert (robot[STATE], robot[HELD]) == (2, False)
        assert [word for word, _ in drivers.log[-3:]] == ["stop"] * 3
        one.faults = Faults()
        one.finish()
        until(one, one.now + REST_MS + 50)
        assert robot[STATE] == 1
    assert one.run.outcome == "done"
    assert not any("missed" in text for _, text in texts(one))


def test_the_emergency_stop_stops_a_board(tmp_path: Path) -> None:
    with bench_boards(anew(), {0: 0}, tmp_path) as boards:
        one = Fleet(anew, boards=boards)
        until(one, 2000)
        one.hosts[0].stop()
        one.step()
        assert boards[0].bench.robot[STATE] == 1


def test_a_board_that_began_anew_by_itself_makes_no_tick(tmp_path: Path) -> None:
    with bench_boards(anew(), {0: 0}, tmp_path) as boards:
        board = boards[0].board
        with pytest.raises(BoardError, match="cannot do that now"):
            board.member_tick({})
        board.begin_member()
        assert board.member_tick({})
        board.stop()
        with pytest.raises(BoardError, match="cannot do that now"):
            board.member_tick({})
        board.begin_member()
        for payload, why in ((b"\1\1", 3), (b"\1\0\0\0\0\0", 2), (b"\1\x77\0\0\0\0", 2)):
            assert boards[0].bench.ask("m", payload) == ("N", bytes((why,)))


def test_what_a_board_cannot_have_said_is_refused(tmp_path: Path) -> None:
    with bench_boards(anew(), {0: 0}, tmp_path) as boards:
        one = Fleet(anew, boards=boards)
        until(one, 1000)
        body = one.hosts[0].board
        assert body is not None
        for changes in ([(60_000, 1)], [(5, 1), (300, 1)]):
            assert not body.ticked(one.now, changes)
