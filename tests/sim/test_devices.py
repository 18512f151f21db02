"""Devices: what each senses and does, against what can be worked out by hand; settings, latency and noise."""

from __future__ import annotations

import math
import random
from pathlib import Path
from statistics import correlation, mean, stdev

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.sim.agent_views import LAMP
from kitrobot.sim.devices import Actuator, Sensor, actuators, sensors
from kitrobot.sim.physics.angles import direction
from kitrobot.sim.physics.grids import fill, fixed
from kitrobot.sim.physics.sight import ray_to_discs, ray_to_walls
from kitrobot.sim.setup.limits import SimulationError
from kitrobot.sim.setup.settings import find_device, read_settings
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import RADIUS, X, Y
from kitrobot.sim.tables.random_numbers import drawn, gauss, keys
from kitrobot.sim.tables.state import Grid, Rays, Walls
from tests.sim.building import MOTOR, SIDE, WHEEL, avatar, catalogue, empty_world, robots_with, run_of, steps

ROOT = Path(__file__).parents[2]
RANGE = """<sensor name="Captor" device="range" min="0" max="{most}" {settings}>
  <operation name="Value" value="yes"/>
</sensor>"""
SENSOR = """<sensor name="{name}" device="{device}" type="boolean" {settings}>
  <operation name="IsPressed" test="equal" to="1"/><operation name="IsReleased" test="equal" to="0"/>
</sensor>"""


def sensed(run: Simulation, sensor: str, agent: int = 0) -> int:
    steps(run, 1)
    return run.agents[agent].inputs[sensor]


def test_every_device_that_a_shipped_robot_names_is_there_with_its_settings_and_procedures() -> None:
    robots = catalogue().robots
    assert {"carrier", "loader", "unloader", "store-manager", "mini-robot"} <= set(robots)
    for robot in robots.values():
        for part in (*robot.actuators, *robot.sensors):
            device, problems = find_device(robot, part)
            assert problems == []
            assert device is not None
            assert read_settings(part, device, part.name)[1] == []


def test_devices_are_found_by_their_names() -> None:
    moving = {"arm", "door", "drive", "lamp", "switch", "turn", "wheel"}
    assert moving | {"display", "indicator", "music", "pen", "pin-out", "team", "work"} == set(actuators())
    places = {"button", "cargo", "collision", "colour", "presence", "range", "sign", "store"}
    alone = {"accelerometer", "chance", "key", "pin-in", "place", "random", "schedule", "slider"}
    zones = {"brightness", "sound", "temperature"}
    assert places | alone | zones | {"hears", "neighbours", "team", "work"} == set(sensors())
    assert all(issubclass(device, Actuator) for device in actuators().values())
    assert all(issubclass(device, Sensor) for device in sensors().values())


# ---- range


def to_walls(angle: float, reach: float, walls: list[list[float]]) -> float:
    room = 4 * len(walls[0]) + 40
    ux, uy = direction(angle)
    return ray_to_walls(0, 0, ux, uy, reach, Walls(walls, fixed(walls, 0)), Rays([0] * room, [0.0] * room))


@pytest.mark.parametrize("angle", [0.0, 0.3, -0.7, math.pi / 2, 3.0])
@pytest.mark.parametrize("more", [0, 200])
def test_the_range_to_a_wall_is_the_distance_along_the_ray(angle: float, more: int) -> None:
    # With many walls behind it, short ones, there are many cells to go through.
    behind = [400.0 + n for n in range(more)]
    walls = [[300, *behind], [-1e5, *behind], [300, *behind], [1e5, *(y + 1 for y in behind)]]
    expected = 300 / math.cos(angle) if math.cos(angle) > 1e-6 else 1e6
    assert to_walls(angle, 1e6, walls) == pytest.approx(min(expected, 1e6))


def to_discs(angle: float, reach: float, discs: list[tuple[float, float, float]]) -> float:
    """From the first of the discs (x, y, radius)."""
    x, y, radius = (list(row) for row in zip(*discs, strict=True))
    count = len(discs)
    robots = robots_with({X: x, Y: y, RADIUS: radius})
    grid = Grid([0.0] * 3, [1, 1], [0] * (2 * count + 16), [0] * 4 * count)
    fill(robots, max(radius), grid)
    ux, uy = direction(angle)
    room = 4 * count + 40
    return ray_to_discs(0, ux, uy, reach, robots, grid, Rays([0] * room, [0.0] * room))


def test_the_range_to_a_disc_is_the_distance_to_its_edge() -> None:
    discs = [(0.0, 0.0, 50.0), (500.0, 0.0, 40.0)]
    assert to_discs(0.0, 1e6, discs) == pytest.approx(460)
    assert to_discs(math.asin(40 / 500) + 1e-6, 1e6, discs) == 1e6
    assert to_discs(math.pi, 1e6, discs) == 1e6


@given(st.integers(0, 10**6), st.integers(2, 120), st.floats(-4, 4), st.floats(10, 3000))
def test_looking_in_the_cells_of_a_ray_is_looking_at_everything(
    seed: int, count: int, angle: float, reach: float
) -> None:
    rng = random.Random(seed)
    discs = [(rng.uniform(0, 3000), rng.uniform(0, 1000), rng.uniform(5, 70)) for _ in range(count)]
    walls = [[rng.uniform(-500, 2500) for _ in range(count)] for _ in range(4)]
    x, y, _ = discs[0]
    ux, uy = direction(angle)
    nearest = reach
    for other_x, other_y, radius in discs[1:]:
        along, across = (other_x - x) * ux + (other_y - y) * uy, (other_x - x) * uy - (other_y - y) * ux
        if abs(across) <= radius and along + math.sqrt(radius**2 - across**2) >= 0:
            nearest = min(nearest, max(0.0, along - math.sqrt(radius**2 - across**2)))
    assert to_discs(angle, reach, discs) == pytest.approx(nearest)
    nearest = reach
    for x1, y1, x2, y2 in zip(*walls, strict=True):
        turned = (x2 - x1) * uy - (y2 - y1) * ux
        far, part = (x1 * (y1 - y2) - y1 * (x1 - x2)) / turned, (x1 * uy - y1 * ux) / -turned
        if far >= 0 and 0 <= part <= 1:
            nearest = min(nearest, far)
    assert to_walls(angle, reach, walls) == pytest.approx(nearest)


@pytest.mark.parametrize(("x", "value"), [(3000, 93), (3500, 43), (3900, 3), (2000, 100)])
def test_a_range_sensor_reads_from_the_edge_of_the_robot_in_parts_of_its_reach(x: float, value: int) -> None:
    robot = avatar(WHEEL.format(settings='length="140"'), RANGE.format(most=100, settings='reach="1000"'))
    assert sensed(run_of({"a": (robot, "WAIT(9);")}, empty_world(a=(x, 1000, 0))), "Captor") == value


def test_a_range_sensor_sees_robots_and_looks_where_its_angle_says() -> None:
    robot = avatar(WHEEL.format(settings='length="100"'), RANGE.format(most=1000, settings='reach="1000" angle="90"'))
    world = empty_world(a=(1000, 1000, 0), b=(1000, 1400, 0))
    assert sensed(run_of({"a": (robot, "WAIT(9);"), "b": (robot, "WAIT(9);")}, world), "Captor") == 300


def test_noise_spreads_readings_by_its_standard_deviation_and_is_the_same_for_the_same_seed() -> None:
    robot = avatar(WHEEL.format(settings=""), RANGE.format(most=1000, settings='reach="1000" noise="20"'))

    def readings(seed: int) -> list[int]:
        run = run_of({"a": (robot, "WAIT(600);")}, empty_world(a=(3432.5, 1000, 0)), seed=seed)
        return [sensed(run, "Captor") for _ in range(1000)]

    assert mean(readings(1)) == pytest.approx(500, abs=3)
    assert stdev(readings(1)) == pytest.approx(20, rel=0.1)
    assert readings(1) == readings(1) != readings(2)


def test_latency_makes_a_reading_as_old_as_it_says() -> None:
    parts = WHEEL.format(settings='speed="1000" acceleration="1e6"'), RANGE.format(most=1000, settings='reach="1000"')
    late = RANGE.format(most=1000, settings='reach="1000" latency="100"')
    world = empty_world(a=(3000, 1000, 0))
    now = run_of({"a": (avatar(*parts), "Wheel.Advance(100); WAIT(600);")}, world)
    then = run_of({"a": (avatar(parts[0], late), "Wheel.Advance(100); WAIT(600);")}, world)
    fresh = [sensed(now, "Captor") for _ in range(40)]
    old = [sensed(then, "Captor") for _ in range(40)]
    assert old[5:] == fresh[:-5]


# ---- actuators


def test_a_late_actuator_does_what_it_is_told_later_and_is_not_done_before() -> None:
    door = """<actuator name="Door" device="door" time="200" {settings}>
      <procedure name="Open" completes="later"/><procedure name="Close" completes="later"/></actuator>"""
    runs = []
    for settings in ("", 'latency="100"'):
        run = run_of({"a": (avatar(door.format(settings=settings)), "Door.Open();")}, empty_world(a=(1000, 1000, 0)))
        while run.outcome is None:
            run.step()
        runs.append(run.tick)
    assert runs == [11, 16]


def test_a_lamp_and_a_switch_stay_as_they_were_told() -> None:
    mini = catalogue().robots["mini-robot"]
    run = steps(
        run_of({"a": (mini, "Light.LightOn(); WAIT(1); Light.LightOff(); WAIT(9);")}, empty_world(a=(900, 900, 0))), 3
    )
    assert run.agents[0].flags & LAMP
    assert not steps(run, 5).agents[0].flags & LAMP


def test_a_robot_that_drives_into_a_wall_stands_there_and_it_is_one_collision() -> None:
    mini = catalogue().robots["mini-robot"]
    run = run_of(
        {"a": (mini, "Wheel.Advance(100); <Button.IsPressed()>( Wheel.Stop(); ) WAIT(20);")},
        empty_world(a=(3500, 1000, 0)),
    )
    while run.outcome is None:
        run.step()
    robot = run.agents[0]
    assert robot.x_mm + run.stage.bodies.radius[0] == pytest.approx(4000)
    assert robot.inputs["Button"] == 1
    assert robot.inputs["Captor"] == 0
    assert run.collisions == 1


def test_a_robot_slides_along_a_wall_and_never_through_it() -> None:
    mini = catalogue().robots["mini-robot"]
    run = steps(run_of({"a": (mini, "Wheel.Advance(100); WAIT(600);")}, empty_world(a=(3700, 1000, 0.8))), 400)
    robot = run.agents[0]
    radius = run.stage.bodies.radius[0]
    assert robot.x_mm <= 4000 - radius + 1e-6
    assert robot.y_mm == pytest.approx(2500 - radius, abs=1)


def test_two_robots_that_meet_push_but_never_overlap() -> None:
    mini = catalogue().robots["mini-robot"]
    program = "Wheel.Advance(100); WAIT(600);"
    run = run_of({"a": (mini, program), "b": (mini, program)}, empty_world(a=(1000, 1000, 0), b=(1600, 1020, math.pi)))
    for _ in range(300):
        run.step()
        first, second = run.agents
        apart = math.hypot(first.x_mm - second.x_mm, first.y_mm - second.y_mm)
        assert apart >= 2 * run.stage.bodies.radius[0] - 1e-6
    assert run.collisions >= 1


def test_a_sensor_can_be_forced_and_given_back() -> None:
    mini = catalogue().robots["mini-robot"]
    run = steps(run_of({"a": (mini, "WAIT(600);")}, empty_world(a=(1000, 1000, 0))), 1)
    run.force("a", "Button", 1)
    assert sensed(run, "Button") == 1
    run.force("a", "Button", None)
    assert sensed(run, "Button") == 0
    with pytest.raises(KitRobotError, match="no agent a with a sensor Knob"):
        run.force("a", "Knob", 1)


# ---- colour


# ---- the road and the docks


# ---- what a robot's XML may get wrong


@pytest.mark.parametrize(
    ("part", "words", "help"),
    [
        (WHEEL.format(settings='spead="4"'), "has no setting “spead”", "speed"),
        (WHEEL.format(settings='speed="0.9"'), "a number from 1 to 100000 mm/s in speed, found “0.9”", "full speed"),
        (WHEEL.format(settings='speed="nan"'), "found “nan”", "full speed"),
        (WHEEL.format(settings='guide="rail"'), "free or road in guide", "leads"),
        (WHEEL.format(settings="").replace('"drive"', '"dive"'), "found “dive”", "drive"),
        (WHEEL.format(settings="").replace('"Advance"', '"Advanced"'), "not Advanced", "Advance"),
        (SENSOR.format(name="Eye", device="eye", settings=""), "found “eye”", ""),
        (SENSOR.format(name="Eye", device="presence", settings=""), "needs a dock", "dock="),
        (SENSOR.format(name="Eye", device="store", settings=""), "needs a storehouse", "storehouse="),
        (WHEEL.format(settings='guide="road"'), "needs a road", "road="),
        (SIDE.format(name="L", settings='side="up"'), "left or right in side, found “up”", "where it is"),
        (SIDE.format(name="L", settings='track="0"'), "from 1 to 10000 mm in track", "apart"),
        (
            SIDE.format(name="L", settings="") + SIDE.format(name="R", settings=""),
            "another side than that of L",
            "its own",
        ),
        (
            SIDE.format(name="L", settings="") + WHEEL.format(settings=""),
            "cannot have Wheel, the device drive",
            "take L",
        ),
        (
            SIDE.format(name="L", settings="") + MOTOR.format(settings=""),
            "cannot have Motor, the device turn",
            "take L",
        ),
    ],
)
def test_a_device_that_cannot_be_simulated_is_an_error_in_a_sentence(part: str, words: str, help: str) -> None:
    with pytest.raises(SimulationError) as caught:
        run_of({"a": (avatar(part), "WAIT(1);")}, empty_world(a=(1000, 1000, 0)))
    assert words in caught.value.message
    assert help in caught.value.help
    assert caught.value.diagnostics


def test_a_setting_at_its_limit_is_right() -> None:
    robot = avatar(WHEEL.format(settings='speed="1"'))
    assert run_of({"a": (robot, "WAIT(1);")}, empty_world(a=(1000, 1000, 0))).tick == 0


# ---- drop-outs and noise, of every device


# ---- chance and angles


@given(st.floats(-100, 100))
def test_sine_and_cosine_are_those_of_the_library_to_the_last_bits(angle: float) -> None:
    assert direction(angle) == pytest.approx((math.cos(angle), math.sin(angle)), abs=5e-16)


def test_chance_is_even_and_normal_and_neighbours_have_nothing_in_common() -> None:
    a, b = keys(1, "robot", "sensor", "Eye")
    c, d = keys(1, "robot", "sensor", "Ear")
    draws = [drawn(a, b, n) / 2**32 for n in range(20_000)]
    others = [drawn(c, d, n) / 2**32 for n in range(20_000)]
    assert mean(draws) == pytest.approx(0.5, abs=0.01)
    assert stdev(draws) == pytest.approx(math.sqrt(1 / 12), abs=0.01)
    assert abs(correlation(draws[:-1], draws[1:])) < 0.03
    assert abs(correlation(draws, others)) < 0.03
    deviates = [gauss(a, b, 3 * n) for n in range(20_000)]
    assert mean(deviates) == pytest.approx(0, abs=0.03)
    assert stdev(deviates) == pytest.approx(1, abs=0.02)
    assert sum(abs(deviate) > 2 for deviate in deviates) / 20_000 == pytest.approx(0.0455, abs=0.006)


def test_the_documentation_names_every_device_and_setting() -> None:
    text = (ROOT / "docs" / "xml.md").read_text(encoding="utf-8")
    table = text[text.index("## Devices of the simulator") :]
    lines = {line.split("|")[1].strip(): line for line in table.splitlines() if line.startswith("| `")}
    for device in (*actuators().values(), *sensors().values()):
        for setting in device.settings:
            assert setting.help in lines[f"`{device.name}`"] or setting.name in {"latency", "dropout"} or setting.words
            assert f"`{setting.name}`" in table
