"""Simulated time against the clock."""

from __future__ import annotations

import pytest

from kitrobot.live.realtime_pacer import MOST_BEHIND_S, UNPACED, RealtimePacer


class Clock:
    """A clock that goes when it is told to."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock():
    return Clock()


def test_no_tick_is_due_before_its_time(clock):
    pace = RealtimePacer(0.02, clock)
    assert pace.due(0) == 0
    clock.now += 0.019
    assert pace.due(0) == 0
    clock.now += 0.002
    assert pace.due(0) == 1


@pytest.mark.parametrize(("speed", "ticks"), [(0.1, 5), (1, 50), (5, 250), (100, 5000)])
def test_a_second_in_small_steps_has_fifty_ticks_times_the_speed(clock, speed, ticks):
    pace, tick = RealtimePacer(0.02, clock, speed), 0
    for _ in range(64):
        clock.now += 1 / 64
        tick += pace.due(tick) or 0
    assert abs(tick - ticks) <= max(1, speed / 50)


def test_the_wait_ends_when_the_next_tick_is_due(clock):
    pace = RealtimePacer(0.02, clock, 0.5)
    wait = pace.wait_s(0) or 0
    assert wait == pytest.approx(0.04)
    clock.now += wait + 1e-9
    assert pace.due(0) == 1


def test_unpaced_has_no_limit_and_no_wait(clock):
    pace = RealtimePacer(0.02, clock, UNPACED)
    assert pace.due(0) is None
    assert pace.wait_s(0) == 0


def test_paused_nothing_is_due_and_there_is_nothing_to_wait_for(clock):
    pace = RealtimePacer(0.02, clock)
    pace.set_paused(True, 0)
    clock.now += 10
    assert pace.due(0) == 0
    assert pace.wait_s(0) is None


def test_the_time_of_a_pause_is_not_made_up_for(clock):
    pace = RealtimePacer(0.02, clock)
    pace.set_paused(True, 0)
    clock.now += 10
    pace.set_paused(False, 0)
    assert pace.due(0) == 0
    clock.now += 0.0201
    assert pace.due(0) == 1


def test_a_new_speed_counts_from_where_the_run_is(clock):
    pace = RealtimePacer(0.02, clock, 1)
    clock.now += 1
    pace.set_speed(10, 50)
    assert pace.due(50) == 0
    clock.now += 0.0201
    assert pace.due(50) == 10


@pytest.mark.parametrize("speed", [1, 10, 100])
def test_a_run_that_cannot_keep_up_makes_up_for_a_quarter_second_at_most(clock, speed):
    pace = RealtimePacer(0.02, clock, speed)
    clock.now += 3600
    most = int(MOST_BEHIND_S * speed / 0.02)
    assert pace.due(0) == most
    assert pace.due(most) == 0
