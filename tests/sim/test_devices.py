"""Devices: what each senses and does, against what can be worked out by hand; settings, latency and noise."""

from __future__ import annotations

import itertools
import math
import random
from dataclasses import replace
from pathlib import Path
from statistics import correlation, mean, stdev

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.diagnostics import KitRobotError
from kitrobot.sim import ALARM, ARM, LAMP, Simulation, SimulationError
from kitrobot.sim.angles import direction
from kitrobot.sim.chance import drawn, gauss, keys
from kitrobot.sim.devices import Actuator, Sensor, actuators, sensors
from kitrobot.sim.grids import fill, fixed
from kitrobot.sim.settings import find_device, read_settings
from kitrobot.sim.sight import floor_at, ray_to_discs, ray_to_walls
from kitrobot.world import ColouredLine, Corner, Dock, Floor, Road, Start, Storehouse, World
from kitrobot.world.model import rectangle_corners
from tests.sim.building import MOTOR, SIDE, WHEEL, avatar, catalogue, empty_world, run_of, steps

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
            assert read_settings(robot, part, device)[1] == []


def test_devices_are_found_by_their_names() -> None:
    moving = {"arm", "door", "drive", "lamp", "switch", "turn", "wheel"}
    assert moving | {"display", "music", "pin-out"} == set(actuators())
    places = {"button", "cargo", "collision", "colour", "presence", "range", "sign", "store"}
    assert places | {"accelerometer", "key", "pin-in", "random"} == set(sensors())
    assert all(issubclass(device, Actuator) for device in actuators().values())
    assert all(issubclass(device, Sensor) for device in sensors().values())


# ---- range


def to_walls(angle: float, reach: float, walls: list[list[float]]) -> float:
    room = 4 * len(walls[0]) + 40
    ux, uy = direction(angle)
    return ray_to_walls(0, 0, ux, uy, reach, walls, *fixed(walls, 0), [0] * room, [0.0] * room)


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
    low = [0] * count
    frame, shape, starts, items = [0.0] * 3, [1, 1], [0] * (2 * count + 16), [0] * 4 * count
    fill(list(range(count)), x, y, radius, max(radius), list(low), list(low), frame, shape, starts, items)
    ux, uy = direction(angle)
    room = [0] * (4 * count + 40)
    far = [0.0] * len(room)
    return ray_to_discs(x[0], y[0], ux, uy, reach, 0, x, y, radius, frame, shape, starts, items, room, far)


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


def test_a_colour_sensor_reads_lines_and_nothing_beside_them() -> None:
    lines = (
        ColouredLine("blue", 40, (Corner(0, 1000), Corner(4000, 1000))),
        ColouredLine("red", 40, (Corner(2000, 0), Corner(2000, 2500))),
    )
    mini = catalogue().robots["mini-robot"]

    def colour(x: float, y: float) -> int:
        world = replace(empty_world(a=(x, y, 0)), lines=lines)
        return sensed(run_of({"a": (mini, "WAIT(9);")}, world), "Light")

    assert [colour(500, 1000), colour(500, 1019.9), colour(500, 1020.1), colour(2000, 500), colour(2000, 1000)] == [
        3,
        3,
        0,
        1,
        1,
    ]


def test_a_colour_sensor_reads_coloured_floor_below_lines_the_last_on_top() -> None:
    circle = tuple(Corner(x, y, 200) for x, y in ((600, 600), (1000, 600), (1000, 1000), (600, 1000)))
    floors = (
        Floor("red", rectangle_corners(500, 500, 300, 300)),
        Floor("blue", circle),
        Floor("green", (Corner(2000, 0), Corner(3000, 0), Corner(2000, 1000))),
    )
    lines = (ColouredLine("red", 40, (Corner(900, 800), Corner(3000, 800))),)
    mini = catalogue().robots["mini-robot"]

    def colour(x: float, y: float) -> int:
        world = replace(empty_world(a=(x, y, 0)), floors=floors, lines=lines)
        return sensed(run_of({"a": (mini, "WAIT(9);")}, world), "Light")

    places = [(510, 510), (490, 510), (780, 780), (640, 640), (800, 995), (800, 1005), (950, 800), (950, 830)]
    assert [colour(*place) for place in places] == [1, 0, 3, 1, 3, 0, 1, 3]
    assert [colour(2400, 590), colour(2400, 610), colour(2190, 810)] == [2, 0, 1]


@given(st.lists(st.tuples(st.integers(0, 40), st.integers(0, 40)), min_size=3, max_size=8), st.randoms())
def test_a_point_is_on_a_floor_when_its_border_winds_around_it(
    corners: list[tuple[int, int]], rng: random.Random
) -> None:
    x, y = rng.uniform(-2, 42), rng.uniform(-2, 42)
    border = [*corners, corners[0]]
    angles = [math.atan2(b - y, a - x) for a, b in border]
    winding = sum(math.remainder(after - before, math.tau) for before, after in itertools.pairwise(angles))
    xs, ys = ([float(point[n]) for point in border] for n in (0, 1))
    box = [[min(xs)], [min(ys)], [max(xs)], [max(ys)]]
    inside = round(winding / math.tau) % 2 == 1
    assert floor_at(x, y, [[2], [0], [len(xs) - 1]], box, [xs, ys]) == (2 if inside else 0)


# ---- the road and the docks


def lane(**starts: float) -> World:
    road = Road("lane", 120, False, (Corner(100, 500), Corner(2100, 500)))
    houses = (Storehouse("A", 0, 0, 100, 100, 5, 2), Storehouse("B", 500, 0, 100, 100, 1, 0))
    docks = (Dock("in", "lane", 500, 30, "A", "load"), Dock("out", "lane", 1500, 30, "B", "unload"))
    places = [Start(name, road="lane", at_mm=at) for name, at in starts.items()]
    places += [Start("loader", dock="in"), Start("unloader", dock="out")]
    return World("lane", 2200, 1000, roads=(road,), docks=docks, storehouses=houses, starts=tuple(places))


@pytest.mark.parametrize(("gap", "pressed"), [(119, 1), (120, 1), (121, 0)])
def test_a_carrier_notices_another_one_ahead_within_its_reach_bumper_to_bumper(gap: int, pressed: int) -> None:
    carrier = catalogue().robots["carrier"]
    world = lane(a=400, b=400 + 135 + gap)
    run = run_of({"a": (carrier, "WAIT(9);"), "b": (carrier, "WAIT(9);")}, world)
    assert sensed(run, "Collision", 0) == pressed
    assert bool(run.agents[0].flags & ALARM) == bool(pressed)
    # It looks ahead only.
    assert sensed(run, "Collision", 1) == 0


def test_backwards_a_carrier_looks_behind() -> None:
    carrier = catalogue().robots["carrier"]
    run = run_of({"a": (carrier, "WAIT(9);"), "b": (carrier, "Wheel.Reverse(50); WAIT(600);")}, lane(a=400, b=1000))
    while run.agents[1].inputs["Collision"] == 0:
        run.step()
    assert run.stage.bodies.gap_behind[1] <= 120


def test_carriers_that_do_not_look_touch_once_and_stand_bumper_to_bumper() -> None:
    carrier = catalogue().robots["carrier"]
    run = run_of({"a": (carrier, "Wheel.Advance(100); WAIT(600);"), "b": (carrier, "WAIT(600);")}, lane(a=400, b=1000))
    steps(run, 300)
    assert run.collisions == 1
    assert run.stage.bodies.at[0] == pytest.approx(1000 - 135, abs=0.6)


@pytest.mark.parametrize(("at", "present"), [(469, 0), (470, 1), (530, 1), (531, 0)])
def test_presence_is_a_carrier_that_stands_within_reach_of_the_dock(at: float, present: int) -> None:
    carrier, loader, unloader = (catalogue().robots[name] for name in ("carrier", "loader", "unloader"))
    agents = {"a": (carrier, "WAIT(9);"), "loader": (loader, "WAIT(9);"), "unloader": (unloader, "WAIT(9);")}
    run = run_of(agents, lane(a=at))
    assert sensed(run, "Presence", 1) == present
    run.stage.bodies.load[0] = 1
    assert sensed(run, "Presence", 1) == 0


def test_a_carrier_that_drives_through_the_dock_is_not_present() -> None:
    carrier, loader = catalogue().robots["carrier"], catalogue().robots["loader"]
    run = run_of({"a": (carrier, "Wheel.Advance(100); WAIT(9);"), "loader": (loader, "WAIT(600);")}, lane(a=300))
    for _ in range(45):
        assert sensed(run, "Presence", 1) == 0
    assert run.stage.bodies.at[0] > 530


def test_an_arm_takes_the_time_its_xml_says_and_hands_the_box_over_at_the_end() -> None:
    carrier = catalogue().robots["carrier"]
    arm = """<actuator name="Arm" device="arm" time="400"><procedure name="Load" completes="later"/></actuator>"""
    loader = avatar(arm, name="quick-loader")
    run = run_of({"a": (carrier, "<Cargo.IsPressed()>();"), "loader": (loader, "Arm.Load();")}, lane(a=500))
    steps(run, 19)
    assert run.agents[0].load == 0
    assert run.stock == {"A": 2, "B": 0}
    steps(run, 1)
    assert run.agents[0].load == 1
    assert run.stock == {"A": 1, "B": 0}
    while run.outcome is None:
        run.step()
    assert run.tick == 21


@pytest.mark.parametrize(
    ("at", "load", "stock", "words"),
    [
        (300, 0, 2, "no empty carrier stands in dock in"),
        (500, 1, 2, "no empty carrier stands in dock in"),
        (500, 0, 0, "storehouse A has no box"),
    ],
)
def test_an_arm_that_cannot_load_says_so_and_moves_no_box(at: float, load: int, stock: int, words: str) -> None:
    carrier, loader = catalogue().robots["carrier"], catalogue().robots["loader"]
    world = lane(a=at)
    houses = (replace(world.storehouses[0], stock=stock), world.storehouses[1])
    world = replace(world, storehouses=houses)
    run = run_of({"a": (carrier, "WAIT(600);"), "loader": (loader, "Arm.Load();")}, world)
    run.stage.bodies.load[0] = load
    run.stage.total += load
    texts: list[str] = []
    while not run.members[1].ended:
        run.step()
        texts += [event.text for event in run.events if event.kind == "message"]
    assert texts == [words]
    assert run.stage.stock[0] == stock
    assert run.stage.bodies.load[0] == load


def over_a_full_storehouse(program: str = "Arm.Unload();") -> Simulation:
    """A loaded carrier in the dock of a storehouse that has room for one box and holds it."""
    carrier, unloader = catalogue().robots["carrier"], catalogue().robots["unloader"]
    world = lane(a=1500)
    world = replace(world, storehouses=(world.storehouses[0], replace(world.storehouses[1], stock=1)))
    run = run_of({"a": (carrier, "WAIT(90); Wheel.Advance(50); WAIT(900);"), "unloader": (unloader, program)}, world)
    run.stage.bodies.load[0] = 1
    run.stage.total += 1
    return run


def test_an_arm_over_a_full_storehouse_says_so_once_and_waits_until_there_is_room() -> None:
    run = over_a_full_storehouse()
    texts: list[str] = []

    def go(count: int) -> None:
        for _ in range(count):
            run.step()
            texts.extend(event.text for event in run.events if event.kind == "message")

    go(300)
    assert texts == ["storehouse B is full"]
    assert (run.stage.stock[1], run.stage.bodies.load[0]) == (1, 1)
    assert run.view(1).flags & ARM
    assert run.view(1).state == "waiting"
    run.stage.stock[1] = 0
    go(1)
    assert (run.stage.stock[1], run.stage.bodies.load[0]) == (1, 0)
    go(2)
    assert run.members[1].ended
    assert texts == ["storehouse B is full"]


def test_an_arm_over_a_full_storehouse_comes_back_when_the_carrier_leaves() -> None:
    run = over_a_full_storehouse()
    texts: list[str] = []
    while not run.members[1].ended:
        run.step()
        texts += [event.text for event in run.events if event.kind == "message"]
    assert texts == ["storehouse B is full", "no loaded carrier stands in dock out"]
    assert (run.stage.stock[1], run.stage.bodies.load[0]) == (1, 1)


@pytest.mark.parametrize(("load", "stock", "words"), [(0, 0, "no loaded carrier stands in dock out")])
def test_an_arm_that_cannot_unload_says_so_and_moves_no_box(load: int, stock: int, words: str) -> None:
    carrier, unloader = catalogue().robots["carrier"], catalogue().robots["unloader"]
    world = lane(a=1500)
    world = replace(world, storehouses=(world.storehouses[0], replace(world.storehouses[1], stock=stock)))
    run = run_of({"a": (carrier, "WAIT(600);"), "unloader": (unloader, "Arm.Unload();")}, world)
    run.stage.bodies.load[0] = load
    run.stage.total += load
    texts: list[str] = []
    while not run.members[1].ended:
        run.step()
        texts += [event.text for event in run.events if event.kind == "message"]
    assert texts == [words]
    assert run.stage.stock[1] == stock


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


def test_every_device_has_latency_and_drop_outs_and_every_measure_has_noise() -> None:
    for device in (*actuators().values(), *sensors().values()):
        names = {setting.name for setting in device.settings}
        assert {"latency", "dropout"} <= names, device.name
        certain = {"display", "lamp", "music", "pin-out", "random", "switch"}
        assert ("noise" in names) != (device.name in certain), device.name


def test_the_kinds_of_devices_are_numbered_in_the_order_of_their_names() -> None:
    for known in (actuators(), sensors()):
        assert [device.kind for device in known.values()] == list(range(len(known)))
        assert list(known) == sorted(known)


def test_a_lost_reading_leaves_the_one_before() -> None:
    fast = WHEEL.format(settings='speed="1000" acceleration="1e6"')
    eyes = [RANGE.format(most=1000, settings=f'reach="1000" {lost}') for lost in ("", 'dropout="50"', 'dropout="100"')]
    runs = [
        run_of({"a": (avatar(fast, eye), "Wheel.Advance(100); WAIT(600);")}, empty_world(a=(2900, 1000, 0)))
        for eye in eyes
    ]
    fresh, half, never = ([sensed(run, "Captor") for _ in range(40)] for run in runs)
    assert never == [0] * 40
    kept = [now == before for before, now in itertools.pairwise(half)]
    assert 8 < sum(kept) < 32
    assert all(value in ([0, *fresh]) for value in half)
    assert all(now in (true, before) for before, now, true in zip([0, *half], half, fresh, strict=False))


def test_a_boolean_sensor_with_noise_is_wrong_as_often_as_it_says() -> None:
    robot = avatar(WHEEL.format(settings=""), SENSOR.format(name="Button", device="button", settings='noise="30"'))
    run = run_of({"a": (robot, "WAIT(600);")}, empty_world(a=(1000, 1000, 0)), seconds=100)
    readings = [sensed(run, "Button") for _ in range(2000)]
    assert mean(readings) == pytest.approx(0.3, abs=0.04)


def test_a_colour_sensor_with_noise_reads_every_other_colour_now_and_then() -> None:
    eye = """<sensor name="Light" device="colour" min="0" max="3" noise="50">
      <operation name="Value" value="yes"/></sensor>"""
    robot = avatar(WHEEL.format(settings=""), eye)
    run = run_of({"a": (robot, "WAIT(600);")}, empty_world(a=(1000, 1000, 0)), seconds=100)
    readings = [sensed(run, "Light") for _ in range(2000)]
    counts = [readings.count(colour) / 2000 for colour in range(4)]
    assert counts == pytest.approx([0.5, 1 / 6, 1 / 6, 1 / 6], abs=0.04)


LIGHT = """<actuator name="Light" device="lamp" {settings}>
  <procedure name="LightOn"/><procedure name="LightOff"/></actuator>"""


def test_a_lost_command_says_so_and_the_next_one_may_arrive() -> None:
    lossy = avatar(LIGHT.format(settings='dropout="90"'), '<variable name="Go" type="boolean" initial="true"/>')
    run = run_of({"a": (lossy, "*[Go.IsTrue()]( Light.LightOn(); );")}, empty_world(a=(1000, 1000, 0)))
    texts = [event.text for _ in range(60) for event in steps(run, 1).events]
    assert 0 < len(texts) < 59
    assert set(texts) == {"a command did not reach Light"}
    assert run.agents[0].flags & LAMP
    never = avatar(LIGHT.format(settings='dropout="100"'))
    run = steps(run_of({"a": (never, "Light.LightOn(); WAIT(9);")}, empty_world(a=(1000, 1000, 0))), 2)
    assert not run.agents[0].flags & LAMP


def test_a_door_with_noise_takes_a_little_more_or_less_each_time() -> None:
    door = """<actuator name="Door" device="door" time="1000" noise="10">
      <procedure name="Open" completes="later"/><procedure name="Close" completes="later"/></actuator>"""
    text = "9*( Door.Open(); Door.Close(); );"
    run = run_of({"a": (avatar(door), text)}, empty_world(a=(1000, 1000, 0)), seconds=100)
    while run.outcome is None:
        run.step()
    assert run.tick == pytest.approx(18 * 50, rel=0.1)
    assert run.tick != 18 * 50 + 1


def test_a_motor_with_noise_turns_by_about_the_angle() -> None:
    motor = """<actuator name="Motor" device="turn" rate="720" noise="5">
      <procedure name="AbsoluteTurn" completes="later">
      <parameter name="angle" min="0" max="100"/><parameter name="speed" min="0" max="100"/></procedure></actuator>"""

    def turned(seed: int) -> float:
        run = run_of({"a": (avatar(motor), "Motor.AbsoluteTurn(25, 100);")}, empty_world(a=(1000, 1000, 0)), seed=seed)
        while run.outcome is None:
            run.step()
        return run.agents[0].heading_rad

    angles = [turned(seed) for seed in range(40)]
    assert mean(angles) == pytest.approx(math.pi / 2, rel=0.04)
    assert stdev(angles) == pytest.approx(0.05 * math.pi / 2, rel=0.4)


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
    text = (Path(__file__).parents[2] / "docs" / "xml.md").read_text(encoding="utf-8")
    table = text[text.index("## Devices of the simulator") :]
    lines = {line.split("|")[1].strip(): line for line in table.splitlines() if line.startswith("| `")}
    for device in (*actuators().values(), *sensors().values()):
        for setting in device.settings:
            assert setting.help in lines[f"`{device.name}`"] or setting.name in {"latency", "dropout"} or setting.words
            assert f"`{setting.name}`" in table
