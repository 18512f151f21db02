"""Sensors of warmth, sound and light: what zones make of them, the same bits on both steps, nothing without zones."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest

from kitrobot.sim.recorder import Recorder
from kitrobot.sim.simulation import Simulation
from kitrobot.world.limits import ZoneKind
from kitrobot.world.model import BRIGHT, LOUD, WARM, Zone
from tests.sim.building import WHEEL, avatar, catalogue, empty_world, run_of

VALUE = '<operation name="Value" value="yes"/></sensor>'
SENSORS = f"""
<sensor name="Temperature" device="temperature" min="0" max="50">{VALUE}
<sensor name="Sound" device="sound" min="0" max="100">{VALUE}
<sensor name="Brightness" device="brightness" min="0" max="100" ambient="15">{VALUE}
<sensor name="IsWarm" device="temperature" type="boolean"><operation name="Is" test="equal" to="1"/></sensor>
{WHEEL.format(settings='speed="500"')}
"""


def standing(x: float, y: float, *zones: Zone, text: str = "WAIT(9);") -> Simulation:
    world = replace(empty_world(r=(x, y, 0.0)), zones=zones)
    return run_of({"r": (avatar(SENSORS), text)}, world, seconds=60)


def felt(x: float, y: float, *zones: Zone) -> dict[str, int]:
    run = standing(x, y, *zones)
    run.step()
    return dict(run.agents[0].inputs)


def circle(kind: ZoneKind, value: float, falloff: float = 100.0, x: float = 500.0) -> Zone:
    return Zone(kind, x, 500.0, 200.0, 0.0, 0.0, value, falloff)


def test_without_zones_every_sensor_measures_what_is_around() -> None:
    assert felt(500, 500) == {"Temperature": 20, "Sound": 0, "Brightness": 15, "IsWarm": 0}


@pytest.mark.parametrize(
    ("x", "warm"), [(500, 40), (699, 40), (700, 40), (725, 35), (750, 30), (799, 20), (800, 20), (1500, 20)]
)
def test_a_zone_has_its_value_inside_and_fades_evenly_beyond_its_edge(x: float, warm: int) -> None:
    seen = felt(x, 500, circle(WARM, 40))
    assert (seen["Temperature"], seen["Sound"], seen["Brightness"]) == (warm, 0, 15)
    assert seen["IsWarm"] == (1 if x <= 700 else 0)


def test_each_sensor_feels_its_own_kind_and_rectangles_by_their_nearest_side_or_corner() -> None:
    loud = Zone(LOUD, 500, 500, 0, 200, 400, 80, 100)
    bright = circle(BRIGHT, 95)
    assert [felt(500, y, loud)["Sound"] for y in (500, 700, 750, 800)] == [80, 80, 40, 0]
    assert felt(630, 740, loud)["Sound"] == 40
    assert felt(500, 500, loud, bright) == {"Temperature": 20, "Sound": 80, "Brightness": 95, "IsWarm": 0}


def test_of_several_zones_the_one_that_changes_most_counts_and_a_zone_without_falloff_ends_at_its_edge() -> None:
    cold, warm = circle(WARM, 5), circle(WARM, 30, x=700)
    assert felt(600, 500, cold, warm)["Temperature"] == 5
    assert felt(890, 500, cold, warm)["Temperature"] == 30
    assert [felt(x, 500, circle(WARM, 40, 0))["Temperature"] for x in (700, 700.5)] == [40, 20]


def test_what_a_sensor_cannot_say_is_its_least_or_largest_number() -> None:
    assert felt(500, 500, circle(WARM, 90))["Temperature"] == 50


def test_zones_change_nothing_but_what_their_sensors_measure() -> None:
    robot = catalogue().robots["mini-robot"]
    bare = empty_world(r=(500.0, 500.0, 0.0))
    text = "Wheel.Advance(80); WAIT(9); Motor.AbsoluteTurn(25, 50); Wheel.Stop();"
    runs = [
        run_of({"r": (robot, text)}, world, seconds=60) for world in (bare, replace(bare, zones=(circle(WARM, 40),)))
    ]
    bare_one, other = (Recorder(run) for run in runs)
    assert bare_one.header.columns == other.header.columns
    for _ in range(100):
        for run in runs:
            run.advance(1)
        assert bare_one.record() == other.record()


def test_sensors_that_feel_the_same_zones_share_their_numbers() -> None:
    zones = tuple(circle(WARM, at) for at in range(50))
    world = replace(empty_world(**{f"r{n}": (200.0 + 150 * n, 900.0, 0.0) for n in range(9)}), zones=zones)
    run = run_of({f"r{n}": (avatar(SENSORS), "WAIT(9);") for n in range(9)}, world, seconds=60)
    assert len(run.state.sensors.numbers) == 50 * 7


def test_the_same_bits_plain_and_compiled(with_numba: None) -> None:
    chance = random.Random(5)

    def zones() -> tuple[Zone, ...]:
        return tuple(
            Zone(
                chance.choice((WARM, LOUD, BRIGHT)),
                chance.uniform(200, 2500),
                chance.uniform(300, 700),
                *(
                    (chance.uniform(20, 300), 0.0, 0.0)
                    if at % 2
                    else (0.0, chance.uniform(9, 400), chance.uniform(9, 400))
                ),
                chance.uniform(0, 100),
                chance.choice((0.0, chance.uniform(1, 500))),
            )
            for at in range(30)
        )

    there = zones()
    plain, compiled = (standing(200, 500, *there, text="Wheel.Advance(80); WAIT(60);") for _ in range(2))
    plain.stays_plain = True
    assert compiled.compile_step()
    readings = set()
    for _ in range(250):
        plain.step()
        compiled.step()
        assert plain.agents[0].inputs == compiled.agents[0].inputs
        readings.add(plain.agents[0].inputs["Temperature"])
    assert plain.snapshot() == compiled.snapshot()
    assert len(readings) > 5
