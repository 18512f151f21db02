"""A drive that is kept straight by encoders: two wheels that are not equally strong, as numbers, at recorded pins."""

from __future__ import annotations

from typing import Any

import pytest

from tests.boards.kit_steps import results_of

COUNTS = 160
"""Edges of both encoders for a full turn: discs of 20 slots, and wheels half as wide as they are apart."""

BEFORE = f"""
from kitrobot_onboard.drivers.machine.shared import encoders
encoders.edges.clear()
machine.watchers.clear()
ENCODERS = {{"counts": "{COUNTS}", "left-count": "10", "right-count": "11"}}
class Floor:  # each wheel follows its pins a tenth of a second later, and gives an edge as it goes
    def __init__(self, left, right, a_second):
        self.strong = left, right
        self.a_second = a_second
        self.goes = [0, 0]
        self.way = [0, 0]
        self.edges = [0, 0]
    def tick(self):
        pins = duties()
        for side in (0, 1):
            wanted = (pins[2 * side] - pins[2 * side + 1]) * self.strong[side] // 100
            self.goes[side] += (wanted - self.goes[side]) / 5
            self.way[side] += self.goes[side] / 100 * self.a_second / 50
            while abs(self.way[side]) >= 1:
                self.way[side] -= 1 if self.way[side] > 0 else -1
                self.edges[side] += 1
                if 10 + side in machine.watchers:
                    machine.watchers[10 + side](None)
    def ahead(self):
        return self.edges[0] - self.edges[1]
"""
STEPS = {
    "straight": """
result = []
for counts, left, right, speed, straight in (
    (160, 100, 85, 60, "0"), (160, 100, 85, 60, "3"), (160, 85, 100, 60, "3"), (160, 100, 85, 100, "3"),
    (160, 100, 85, -60, "3"), (2340, 100, 85, 60, "3"), (2340, 90, 100, -100, "3"), (160, 100, 100, 60, "3"),
):
    for each in (heard, encoders.edges):
        each.clear()
    sys.modules["kitrobot_onboard.drivers.machine.shared.motors"].bases.clear()
    drive = make("machine.drive", straight=straight, **dict(DRV8833, **dict(ENCODERS, counts=str(counts))))
    floor = Floor(left, right, counts * 2)
    drive.do("Advance" if speed > 0 else "Reverse", [abs(speed)])
    far, told = [], []
    for at in range(500):
        drive.tend()
        told.append(tuple(duties()))
        floor.tick()
        far.append(floor.ahead())
    result.append((far[-1] * 360 / counts, max(abs(one) for one in far) * 360 / counts, min(told), max(told)))
""",
    "bounds": """
drive = make("machine.drive", **dict(DRV8833, **ENCODERS))
result = [sorted(machine.watchers)]
for procedure, arguments, side, edges in (
    ("Advance", [60], 0, 0), (None, [], 0, 1), (None, [], 0, 3), (None, [], 0, 1000000), ("Advance", [61], 0, 0),
    ("Reverse", [60], 1, 2), ("Stop", [], 1, 50), ("Advance", [2], 1, 1), (None, [], 1, 100),
):
    if procedure:
        drive.do(procedure, arguments)
    drive.straight.left.seen += 0 if side else edges
    drive.straight.right.seen += edges if side else 0
    drive.tend()
    result.append(duties())
taken()
drive.tend()
result.append(taken())
drive.stop()
drive.tend()
result.append(duties())
""",
    "a turn on the way": """
drive, turn = (make("machine." + name, **dict(DRV8833, **ENCODERS)) for name in ("drive", "turn"))
result = []
def edges(left, right):
    for side, count in ((0, left), (1, right)):
        for _ in range(count):
            machine.watchers[10 + side](None)
drive.do("Advance", [50])
turn.do("Turn", [20])
edges(0, 30)
drive.tend()
result.append(duties())
turn.do("Stop", [])
drive.tend()
result.append(duties())
edges(2, 0)
drive.tend()
result.append(duties())
drive.do("Stop", [])
turn.do("AbsoluteTurn", [25, 20])
edges(20, 19)
result.append(turn.done())
edges(0, 1)
result.append(turn.done())
""",
    "two wheels": """
left, right = (make("machine.wheel", side=side, **dict(DRV8833, **ENCODERS)) for side in ("left", "right"))
result = []
def edges(left_edges, right_edges):
    for side, count in ((0, left_edges), (1, right_edges)):
        for _ in range(count):
            machine.watchers[10 + side](None)
    left.tend()
    right.tend()
    result.append(duties())
left.do("Forward", [50])
edges(30, 0)
right.do("Forward", [50])
edges(0, 0)
edges(4, 0)
left.do("Forward", [50])
edges(0, 0)
right.do("Backward", [50])
edges(3, 3)
left.do("Backward", [50])
edges(0, 4)
left.stop()
edges(9, 0)
""",
    "without": """
drive = make("machine.drive", **DRV8833)
drive.do("Advance", [50])
duties()
drive.tend()
result = taken(), sorted(machine.watchers)
""",
}


@pytest.fixture(scope="module")
def found() -> dict[str, Any]:
    """The result of each of the steps."""
    return results_of({name: BEFORE + text for name, text in STEPS.items()})


def test_ten_seconds_with_wheels_that_are_not_equally_strong_end_within_a_few_degrees(found: dict[str, Any]) -> None:
    without, *kept, even = found["straight"]
    assert abs(without[0]) > 90
    for end, most, *_ in kept:
        assert abs(end) <= 7.5
        assert most <= 7.5
    assert even[1] <= 2.25  # one edge


def test_no_wheel_goes_faster_than_it_was_told_or_less_than_half_as_fast(found: dict[str, Any]) -> None:
    watched, even, one, three, many, again, back, still, slow, slower, nothing, stopped = found["bounds"]
    assert watched == [10, 11]
    assert even == [60, 0, 60, 0]
    assert one == [60 - 60 * 6 // 100, 0, 60, 0]  # 2.25 degrees
    assert three == [60 - 60 * 27 // 100, 0, 60, 0]  # 9 degrees, four edges
    assert many == [30, 0, 60, 0]
    assert again == [31, 0, 61, 0]  # told again on the way, it still is off
    assert back == [0, 60, 0, 60 - 60 * 13 // 100]  # another way: from here on
    assert still == [0, 0, 0, 0]
    assert slow == [2, 0, 2, 0]
    assert slower == [2, 0, 1, 0]
    assert nothing == []
    assert stopped == [0, 0, 0, 0]


def test_a_turn_on_the_way_is_not_undone_and_both_count_the_same_edges(found: dict[str, Any]) -> None:
    turns, after, off, busy, done = found["a turn on the way"]
    assert turns == [30, 0, 70, 0]
    assert after == [50, 0, 50, 0]
    assert off == [50 - 50 * 13 // 100, 0, 50, 0]
    assert (busy, done) == (False, True)


def test_without_encoders_nothing_is_told_between_commands(found: dict[str, Any]) -> None:
    assert found["without"] == ([], [])


def test_two_wheels_that_are_told_the_same_are_kept_at_one_rate_and_else_are_not(found: dict[str, Any]) -> None:
    alone, both, ahead, again, apart, back, stopped = found["two wheels"]
    assert alone == [50, 0, 0, 0]
    assert both == [50, 0, 50, 0], "what one did before the other was told counts for nothing"
    assert ahead[0] < 50
    assert ahead[2] == 50
    assert again == ahead, "told the same again, they stay as they are"
    assert apart == [50, 0, 0, 50]
    assert back[1] == 50
    assert back[3] < 50
    assert stopped == [0, 0, 0, 0]
