"""The clock of a board under test goes on with what its host says."""

from __future__ import annotations

import pytest

from kitrobot_onboard.robot import HOLD_MS
from tests.boards.clocks import GRANTED_S, SLOW_PACE, TrafficClock


class Wall:
    """A clock on the wall that is turned by hand."""

    def __init__(self) -> None:
        self.at = 7.0

    def __call__(self) -> float:
        return self.at


@pytest.fixture
def wall() -> Wall:
    return Wall()


@pytest.fixture
def clock(wall: Wall) -> TrafficClock:
    return TrafficClock(wall)


def test_with_a_host_that_speaks_and_without_one_it_goes_as_on_the_wall(wall: Wall, clock: TrafficClock) -> None:
    wall.at += 60
    assert clock.ms() == pytest.approx(60_000)
    for _ in range(100):
        clock.heard()
        wall.at += GRANTED_S
    assert clock.ms() == pytest.approx(60_000 + 100 * 1000 * GRANTED_S)
    clock.left()
    wall.at += 2
    assert clock.ms() == pytest.approx(62_000 + 100 * 1000 * GRANTED_S)


def test_it_waits_for_a_host_that_is_busy_for_seconds_and_gives_up_one_that_is_gone(
    wall: Wall, clock: TrafficClock
) -> None:
    clock.heard()
    wall.at += 9
    assert clock.ms() < HOLD_MS
    wall.at += 3
    assert clock.ms() > HOLD_MS


def test_it_never_goes_back(wall: Wall, clock: TrafficClock) -> None:
    before = clock.ms()
    for passed, event in ((3, clock.heard), (GRANTED_S + 1, clock.heard), (9, clock.left), (0.1, clock.heard)):
        wall.at += passed
        event()
        assert clock.ms() > before
        before = clock.ms()
    wall.at += GRANTED_S + 1
    assert clock.ms() - before == pytest.approx(1000 * (GRANTED_S + SLOW_PACE))
