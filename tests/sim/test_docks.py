"""The road and the docks: carriers that notice one another, arms that load and unload."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.sim.agent_views import ALARM, ARM
from kitrobot.sim.simulation import Simulation
from kitrobot.world.geometry import Corner
from kitrobot.world.model import Dock, Road, Start, Storehouse, World
from tests.sim.building import avatar, catalogue, run_of, steps
from tests.sim.test_devices import sensed


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
