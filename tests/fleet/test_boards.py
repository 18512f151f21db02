"""Boards in a fleet, on a network in memory: the loop of a robot on CPython, asked over the link."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.deploy import BoardError
from kitrobot.fleet.board_body import REST_MS
from kitrobot.sim.team_columns import T_HOLDER
from kitrobot_onboard.state import HELD, STATE
from tests.boards import drivers
from tests.fleet.bench_boards import bench_boards
from tests.fleet.network import Faults, Fleet
from tests.fleet.test_convoy import anew, texts, until
from tests.fleet.test_outcomes import finish, fleet_and_meaning


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
