"""Every mission of the gallery has no problems, says what it is, runs to its end as done, and does what it says."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import pytest

import kitrobot
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.sim.agent_views import LAMP
from kitrobot.sim.simulation import Simulation
from kitrobot.translation.languages import TEXT_LANGUAGES

EXAMPLES = [
    path
    for path in sorted((Path(__file__).resolve().parents[2] / "examples").glob("*/*.krt"))
    # What an exercise begins with is no example: it is to be made right.
    if path.parent.name != "exercises"
]
LANGUAGES = set(TEXT_LANGUAGES)


@dataclass
class Watched:
    """A run seen by its poses, once a tick: x mm, y mm, heading rad, load, flags of each agent."""

    run: Simulation
    poses: list[list[tuple[float, float, float, int, int]]] = field(default_factory=list)
    pictures: list[tuple[str, ...]] = field(default_factory=list)
    """What the display of the first agent shows, five rows of digits; empty where it has none."""

    def path(self, agent: int = 0) -> list[tuple[float, float]]:
        """Where an agent was."""
        return [(poses[agent][0], poses[agent][1]) for poses in self.poses]

    def reached(self, x: float, y: float, agent: int = 0) -> bool:
        """Whether an agent came by this point, to 60 mm."""
        return any(math.hypot(px - x, py - y) < 60 for px, py in self.path(agent))

    def lamps_lit(self, agent: int = 0) -> int:
        """How often the lamp went on."""
        lit = [bool(poses[agent][4] & 1) for poses in self.poses]
        return sum(now and not before for before, now in zip([False, *lit], lit, strict=False))


Hands = dict[int, list[tuple[str, int | None]]]
"""What a person does to the first robot: from which tick on, which sensor, and its value; None gives it back."""


def pressed(*presses: tuple[str, int]) -> Hands:
    """A person who holds each of these from its tick on, for a quarter of a second."""
    hands: Hands = {}
    for sensor, tick in presses:
        hands.setdefault(tick, []).append((sensor, 1))
        hands.setdefault(tick + 12, []).append((sensor, None))
    return hands


def watch(path: Path, hands: Hands | None = None, seed: int = 1) -> Watched:
    """Runs a mission to its end, at most five minutes of its time."""
    watched = Watched(kitrobot.open(path).simulation(seed=seed))
    while watched.run.outcome is None and watched.run.seconds < 300:
        for sensor, value in (hands or {}).get(watched.run.tick, ()):
            watched.run.force(watched.run.agents[0].name, sensor, value)
        watched.run.step()
        watched.poses.append(list(watched.run.poses()))
        outputs = dict(watched.run.members[0].outputs())
        watched.pictures.append(tuple(f"{row:05}" for row in outputs.get("Display", ())))
    return watched


def variable(watched: Watched, name: str) -> int:
    return watched.run.agents[0].values[name]


def way(watched: Watched) -> float:
    path = watched.path()
    return sum(math.dist(a, b) for a, b in itertools.pairwise(path))


def is_lap_on_the_line(seen: Watched) -> bool:
    """Never further from the middle of the line than its width, and all the way round."""
    [line] = [one for one in seen.run.world.lines if one.closed]
    away = max(line.line.nearest(x, y)[1] for x, y in seen.path())
    return away < line.width_mm and way(seen) > 0.95 * line.line.length_mm


def is_along_the_walls(seen: Watched) -> bool:
    """Near one of the four walls of the hall all the time, and near all of them once."""
    world = seen.run.world
    near = [(x, y, world.width_mm - x, world.height_mm - y) for x, y in seen.path()]
    return all(100 < min(sides) < 300 for sides in near) and all(min(side) < 300 for side in zip(*near, strict=True))


def is_found(seen: Watched) -> bool:
    """It stands on the red floor, which it was the first to see."""
    [red] = [floor for floor in seen.run.world.floors if floor.colour == "red"]
    x, y = (sum(row[:-1]) / (len(row) - 1) for row in (red.line.xs, red.line.ys))
    inside = [math.dist(point, (x, y)) <= 200 for point in seen.path()]
    return inside[-1] and not any(inside[:-200]) and seen.lamps_lit() == 4


def keeps_to_the_light(seen: Watched) -> bool:
    """Who comes over the line does at green; the first had to wait for it, the second came at green and went on."""
    lamp = [poses[2][4] & LAMP for poses in seen.poses]
    paths = [[x for x, _ in seen.path(car)] for car in (0, 1)]
    crossed = [next(tick for tick, x in enumerate(path) if x > 2030) for path in paths]
    stood = [sum(now == before < 2100 for before, now in itertools.pairwise(path)) for path in paths]
    return all(lamp[tick] for tick in crossed) and stood[0] > 100 and stood[1] < 5 and min(x[-1] for x in paths) > 2650


def is_a_match(seen: Watched) -> bool:
    """They touched; one is out of the ring and knows it, the other never left it, and it alone blinked."""
    out = [agent.values["Out"] for agent in seen.run.agents]
    away = [max(math.dist(point, (650, 650)) for point in seen.path(k)) for k in (0, 1)]
    blinked = [seen.lamps_lit(k) for k in (0, 1)]
    return out == [0, 1] and away[0] < 450 < away[1] and blinked == [4, 0] and seen.run.collisions > 0


def is_a_train(seen: Watched) -> bool:
    """The leader goes far, and each keeps its distance to the one ahead."""
    gaps = [
        math.dist(ahead, behind) for k in (0, 1) for ahead, behind in zip(seen.path(k), seen.path(k + 1), strict=True)
    ]
    return way(seen) > 2500 and min(gaps) > 350 and max(gaps) < 550


def opens_three_times(seen: Watched) -> bool:
    """The door's lamp was lit for each of three touches."""
    return seen.run.collisions == 3 and seen.lamps_lit(0) == 3 and seen.path(1)[-1][0] < 1900


def is_exchanged(seen: Watched) -> bool:
    """Who is fast in both rounds drives furthest, who is slow in both least, and those who change in between."""
    ways = [sum(math.dist(a, b) for a, b in itertools.pairwise(seen.path(k))) for k in range(4)]
    return ways[1] > ways[0] > ways[3] and ways[1] > ways[2] > ways[3] and abs(ways[0] - ways[2]) < 50


def is_searched(seen: Watched, room: int) -> bool:
    """Exactly one of the two was at the back of this room."""
    x, y = 510 + 400 * room, 914
    return sum(seen.reached(x, y, agent) for agent in (0, 1)) == 1


HEART = ("09090", "99999", "99999", "09990", "00900")
SMALL_HEART = ("00000", "09090", "09990", "00900", "00000")
LEFT_ARROW = ("00900", "09000", "99999", "09000", "00900")
RIGHT_ARROW = ("00900", "00090", "99999", "00090", "00900")
CROSS = ("90009", "09090", "00900", "09090", "90009")
TARGET = ("00900", "09990", "99099", "09990", "00900")
DARK = ("00000",) * 5
DOTS = {
    1: ("00000", "00000", "00900", "00000", "00000"),
    2: ("90000", "00000", "00000", "00000", "00009"),
    3: ("90000", "00000", "00900", "00000", "00009"),
    4: ("90009", "00000", "00000", "00000", "90009"),
    5: ("90009", "00000", "00900", "00000", "90009"),
    6: ("90009", "00000", "90009", "00000", "90009"),
}


def shown(seen: Watched) -> list[tuple[str, ...]]:
    """What the display showed, one picture after the other."""
    return [picture for picture, _ in itertools.groupby(seen.pictures)]


def beats(seen: Watched) -> bool:
    """Big and small take turns, half a second each, and it is dark in the end."""
    lasts = [len(list(group)) for _, group in itertools.groupby(seen.pictures)]
    return shown(seen) == [HEART, SMALL_HEART] * 30 + [DARK] and set(lasts[:-1]) == {25}


def throws(seen: Watched) -> bool:
    """A shake and a press each threw a number and showed it as dots."""
    found = [picture for picture in shown(seen) if picture in DOTS.values()]
    return found[-1] == DOTS[variable(seen, "Count")] and len(shown(seen)) > 3 and shown(seen)[-1] == DARK


def is_won_by_a(seen: Watched) -> bool:
    """The arrow points to A, and the time is what went by since the target was shown."""
    arrow = shown(seen)[shown(seen).index(TARGET) + 1]
    return arrow == LEFT_ARROW and variable(seen, "Time") == 20 * seen.pictures.count(TARGET) == 360


def delivers(seen: Watched) -> bool:
    """It came along the line to the wall, and lit its lamp there."""
    [line] = seen.run.world.lines
    away = max(line.line.nearest(x, y)[1] for x, y in seen.path())
    return away < line.width_mm and 2300 < seen.path()[-1][0] < 2500 and seen.lamps_lit() == 1


HANDS: dict[str, Hands] = {
    "dice": pressed(("Shake", 20), ("ButtonA", 100), ("ButtonB", 200)),
    "reaction": pressed(("ButtonA", 20), ("ButtonA", 200)),
}
"""What a person does in missions that wait for one."""

ACHIEVED: dict[str, Callable[[Watched], bool]] = {
    "blink": lambda seen: seen.lamps_lit() == 5 and way(seen) > 300,
    "brake": lambda seen: 3700 < seen.path()[-1][0] < 3960,
    "bump": lambda seen: seen.run.collisions == 1 and seen.path()[-1][0] < 3800,
    "circle": lambda seen: seen.reached(1800, 1000) and seen.reached(1100, 1700) and seen.reached(400, 1050),
    "convoy": lambda seen: [seen.lamps_lit(k) > 0 for k in range(4)] == [True] * 4 and seen.run.seconds < 21,
    "dice": throws,
    "door": lambda seen: seen.lamps_lit() == 5 and math.dist(seen.path()[0], seen.path()[-1]) < 5 and way(seen) > 1100,
    "doorbell": opens_three_times,
    "exchange": lambda seen: [seen.lamps_lit(k) for k in range(4)] == [1, 1, 1, 0] and is_exchanged(seen),
    "faster": lambda seen: variable(seen, "Level") == 80 and way(seen) > 500,
    "follow-the-leader": is_a_train,
    "heart": beats,
    "kit-rover": delivers,
    "line-follower": is_lap_on_the_line,
    "merge": lambda seen: seen.run.stock == {"A": 0, "B": 8, "C": 0} and len(seen.run.delivered) == 2,
    "pair": lambda seen: all(abs(seen.path(k)[-1][0] - 350) < 60 and seen.lamps_lit(k) == 2 for k in (0, 1)),
    "passing-loop": lambda seen: seen.run.stock == {"A": 0, "B": 6} and min(seen.run.delivered.values()) == 3,
    "reaction": is_won_by_a,
    "red-and-green": lambda seen: seen.lamps_lit() == 1 and abs(seen.path()[-1][0] - 1900) < 120,
    "rooms": lambda seen: way(seen) > 3000,
    "search": is_found,
    "shared-search": lambda seen: all(is_searched(seen, room) for room in range(7)),
    "square": lambda seen: math.dist(seen.path()[0], seen.path()[-1]) < 30 and way(seen) == pytest.approx(1200, abs=5),
    "dance": lambda seen: seen.lamps_lit() == 8 and way(seen) > 7000 and math.dist(seen.path()[0], seen.path()[-1]) < 5,
    "draw-square": lambda seen: (
        math.dist(seen.path()[0], seen.path()[-1]) < 5 and way(seen) == pytest.approx(1200, abs=5)
    ),
    "flower": lambda seen: way(seen) > 6000 and math.dist(seen.path()[0], seen.path()[-1]) < 5,
    "star": lambda seen: math.dist(seen.path()[0], seen.path()[-1]) < 60 and seen.lamps_lit() == 15,
    "stripes": lambda seen: variable(seen, "Count") == 4 and 1500 < seen.path()[-1][0] < 1850,
    "sumo": is_a_match,
    "three-zones": lambda seen: seen.lamps_lit() == 1 and 2000 < seen.path()[-1][0] < 2250,
    "tidy-up": lambda seen: (
        seen.run.state.pushables.floats[0][1] > 1500 and seen.run.state.pushables.floats[0][2] > 1900
    ),
    "traffic-light": keeps_to_the_light,
    "transport": lambda seen: seen.run.stock == {"A": 0, "B": 12},
    "transport-team": lambda seen: seen.run.stock == {"A": 0, "B": 12},
    "wall": lambda seen: way(seen) > 5000,
    "wall-follower": is_along_the_walls,
}


TOUCHING = {"bump", "doorbell", "sumo"}
"""Missions that are about touching; in the others nobody touches anything."""


def test_the_gallery_holds_at_least_ten_missions_each_with_what_it_must_achieve() -> None:
    assert len(EXAMPLES) >= 10
    assert {path.stem for path in EXAMPLES} == set(ACHIEVED)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example_has_no_problems_and_ends_as_done_and_does_what_it_says(path: Path) -> None:
    assert list(kitrobot.open(path).check().problems) == []
    seen = watch(path, HANDS.get(path.stem))
    assert seen.run.outcome == "done", seen.run.sentence
    assert path.stem in TOUCHING or seen.run.collisions == 0
    assert ACHIEVED[path.stem](seen), (way(seen), seen.lamps_lit(), seen.path()[-1])


def example(name: str) -> Path:
    return next(path for path in EXAMPLES if path.stem == name)


@pytest.mark.parametrize(
    ("hands", "picture", "time_ms"),
    [
        (pressed(("ButtonA", 20), ("ButtonB", 183)), RIGHT_ARROW, 20),
        (pressed(("ButtonA", 20), ("ButtonA", 200), ("ButtonB", 199)), RIGHT_ARROW, 340),
        ({**pressed(("ButtonA", 20)), 150: [("ButtonB", 1)]}, CROSS, 0),
    ],
    ids=["b-at-once", "b-a-tick-before-a", "too-early"],
)
def test_the_reaction_game_says_who_was_first_and_how_fast(
    hands: Hands, picture: tuple[str, ...], time_ms: int
) -> None:
    seen = watch(example("reaction"), hands)
    assert picture in seen.pictures
    assert len({LEFT_ARROW, RIGHT_ARROW, CROSS} & set(seen.pictures)) == 1
    assert (seen.run.outcome, variable(seen, "Time")) == ("done", time_ms)


def test_the_dice_show_every_number_with_its_dots() -> None:
    presses = [("ButtonA", 10 + 50 * number) for number in range(40)]
    seen = watch(example("dice"), pressed(*presses, ("ButtonB", 2100)))
    stood = {picture for picture, group in itertools.groupby(seen.pictures) if len(list(group)) > 15}
    assert stood == {*DOTS.values(), DARK}


@pytest.mark.parametrize("name", ["dice", "heart", "kit-rover", "reaction"])
def test_an_example_for_a_real_board_is_small(name: str) -> None:
    [compiled] = kitrobot.open(example(name)).compiled.values()
    assert compiled.image is not None
    assert compiled.image.instructions <= 300
    assert len(compiled.image.cells) <= 64
    assert len(compiled.image.to_bytes()) <= 500


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example_says_its_title_and_what_happens_in_each_language(path: Path) -> None:
    mission, _ = read_mission(path.read_bytes(), path.name)
    assert mission is not None
    assert set(mission.label) == set(mission.help) == LANGUAGES
    assert all(0 < len(text) <= 32 for text in mission.label.values())
    assert all(0 < len(text) <= 100 for text in mission.help.values())


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example_is_written_canonically(path: Path) -> None:
    data = path.read_bytes()
    mission, problems = read_mission(data, path.name)
    assert problems == []
    assert mission is not None
    assert write_mission(mission) == data
