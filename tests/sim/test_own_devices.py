"""Devices of one's own, in XML alone: what `<simulate>` puts in the place of a sensor or an actuator."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.sim.recorder import Recorder
from kitrobot.sim.setup.limits import SimulationError
from kitrobot.sim.setup.settings import device_problems
from kitrobot.sim.simulation import Simulation
from tests.sim.building import WHEEL, avatar, empty_world, run_of, shipped_world, steps

SENSOR = """<sensor name="Own" device="thermometer" {range}>
  <simulate {simulate}/>
  <operation name="Value" value="yes"/><operation name="MoreThan" test="greater"><parameter name="value"/></operation>
</sensor>"""
ACTUATOR = """<actuator name="Own" device="pump">
  <simulate as="indicator" {settings}/>
  <procedure name="Pump" stop="Rest" {later}><parameter name="amount" min="0" max="50"/></procedure>
  <procedure name="Burst" {later}/>
  <procedure name="Rest"/>
</actuator>"""
WAITING = "*(WAIT(10);)"


def with_sensor(simulate: str, range: str = 'min="-20" max="60"', seed: int = 1) -> Simulation:
    robot = avatar(SENSOR.format(simulate=simulate, range=range))
    return run_of({"a": (robot, WAITING)}, empty_world(a=(1000, 1000, 0)), seed=seed, seconds=None)


def with_actuator(text: str, settings: str, later: str = "") -> Simulation:
    robot = avatar(ACTUATOR.format(settings=settings, later=later))
    return run_of({"a": (robot, text)}, empty_world(a=(1000, 1000, 0)))


def readings(run: Simulation, count: int) -> list[int]:
    return [steps(run, 1).agents[0].inputs["Own"] for _ in range(count)]


def shown(run: Simulation, count: int = 1) -> list[int]:
    return [dict(steps(run, 1).members[0].outputs())["Own"][0] for _ in range(count)]


# ---- sensors


def test_a_slider_reads_its_initial_number_until_somebody_sets_it() -> None:
    run = with_sensor('as="slider" initial="21"')
    assert readings(run, 2) == [21, 21]
    run.force("a", "Own", -3)
    assert readings(run, 2) == [-3, -3]
    run.force("a", "Own", 1000)
    assert readings(run, 1) == [60]


def test_a_run_that_waits_for_a_slider_is_not_stuck() -> None:
    robot = avatar(SENSOR.format(simulate='as="slider"', range=""))
    run = run_of({"a": (robot, "<Own.MoreThan(5)>(WAIT(1);)")}, empty_world(a=(1000, 1000, 0)), seconds=100)
    run.advance(100_000)
    assert run.outcome == "time"


def test_a_schedule_steps_from_number_to_number_and_begins_anew() -> None:
    run = with_sensor('as="schedule" values="0:20 0.1:30.4 0.2:-5" repeat="0.3"')
    once = [20] * 5 + [30] * 5 + [-5] * 5
    assert readings(run, 45) == once * 3


def test_a_schedule_goes_evenly_from_number_to_number() -> None:
    run = with_sensor('as="schedule" values="0.1:0 0.3:20" between="line"')
    assert readings(run, 20) == [0] * 6 + [2, 4, 6, 8, 10, 12, 14, 16, 18] + [20] * 5


@pytest.mark.parametrize(
    "values", ["", "20", "0:x", "1:2 1:3", "2:1 1:1", "-1:0", "0:nan", "0:inf", "0:1e30", "0:1," * 3, "0:1 " * 1001]
)
def test_a_schedule_that_cannot_be_read_is_told_with_its_place(values: str) -> None:
    robot = avatar(SENSOR.format(simulate=f'as="schedule" values="{values}"', range=""))
    (problem,) = device_problems(robot)
    assert "seconds:number" in problem.message
    assert problem.place is not None


def test_a_schedule_without_numbers_is_told() -> None:
    (problem,) = device_problems(avatar(SENSOR.format(simulate='as="schedule"', range="")))
    assert "expected the setting values" in problem.message


def test_chance_draws_anew_after_each_period_from_the_seed() -> None:
    run = with_sensor('as="chance" probability="30" period="100"', 'type="boolean"', seed=5)
    found = readings(run, 5000)
    periods = [set(found[at : at + 5]) for at in range(0, 5000, 5)]
    assert all(len(one) == 1 for one in periods)
    assert 250 < sum(one == {1} for one in periods) < 350
    again = readings(with_sensor('as="chance" probability="30" period="100"', 'type="boolean"', seed=5), 100)
    other = readings(with_sensor('as="chance" probability="30" period="100"', 'type="boolean"', seed=6), 100)
    assert again == found[:100] != other


@pytest.mark.parametrize(("probability", "value"), [(0, 0), (100, 1)])
def test_chance_that_is_none_or_certain(probability: int, value: int) -> None:
    run = with_sensor(f'as="chance" probability="{probability}" period="20"', 'type="boolean"')
    assert readings(run, 500) == [value] * 500


def test_a_place_is_noticed_within_reach_and_measured_as_a_distance() -> None:
    near = SENSOR.format(simulate='as="place" of="home" reach="200"', range='type="boolean"')
    far = SENSOR.replace('"Own"', '"Far"').format(simulate='as="place" of="home" reach="1000"', range='max="100"')
    robot = avatar(near, far, WHEEL.format(settings='speed="100" acceleration="1000000"'))
    world = empty_world(a=(1000, 1000, 0), home=(1500, 1000, 0))
    run = run_of({"a": (robot, "Wheel.Advance(100); *(WAIT(10);)")}, world)
    inputs = steps(run, 1).agents[0].inputs
    assert (inputs["Own"], inputs["Far"]) == (0, 50)
    while run.poses()[0][0] < 1295:
        run.step()
    assert run.agents[0].inputs["Own"] == 0
    inputs = steps(run, 10).agents[0].inputs
    assert (inputs["Own"], inputs["Far"]) == (1, 19)


def test_inside_a_storehouse_its_distance_is_none() -> None:
    world = shipped_world("ring")
    house = world.storehouses[0]
    middle = (house.x_mm + house.width_mm / 2, house.y_mm + house.height_mm / 2, 0)
    beside = (house.x_mm + house.width_mm / 2, house.y_mm - 50, 0)
    starts = empty_world(a=middle, b=beside).starts
    robot = avatar(SENSOR.format(simulate=f'as="place" of="{house.name}" reach="100"', range=""))
    run = run_of({"a": (robot, WAITING), "b": (robot, WAITING)}, replace(world, starts=starts))
    steps(run, 1)
    assert [agent.inputs["Own"] for agent in run.agents] == [0, 50]


def test_a_place_that_the_world_does_not_have_is_told_with_the_one_that_was_meant() -> None:
    robot = avatar(SENSOR.format(simulate='as="place" of="hme"', range=""))
    with pytest.raises(SimulationError, match=r"no storehouse, dock or start “hme”") as caught:
        run_of({"a": (robot, WAITING)}, empty_world(a=(1000, 1000, 0), home=(1500, 1000, 0)))
    assert "home" in caught.value.help


# ---- actuators


def test_a_value_stays_until_another_comes() -> None:
    for shows in ("lamp", "sound", "number", "bar"):
        run = with_actuator("Own.Pump(20); WAIT(1); Own.Burst(); WAIT(1); Own.Rest(); WAIT(1);", f'shows="{shows}"')
        assert shown(run) == [20]
        assert shown(run, 5)[-1] == 50
        assert shown(run, 10)[-1] == 0


def test_a_lamp_that_completes_later_is_on_for_its_time_and_the_program_waits() -> None:
    run = with_actuator("Own.Burst(); Own.Pump(7);", 'shows="lamp" time="100"', 'completes="later"')
    assert shown(run, 12) == [50] * 4 + [0] + [7] * 4 + [0] * 3
    assert run.outcome == "done"


def test_a_number_that_completes_later_stays() -> None:
    run = with_actuator("Own.Pump(7); WAIT(10);", 'shows="number" time="100"', 'completes="later"')
    assert shown(run, 10) == [7] * 10


def test_a_bar_goes_evenly_to_its_value_also_from_the_middle() -> None:
    run = with_actuator("Own.Pump(50); WAIT(1); Own.Rest(); WAIT(10);", 'shows="bar" time="200"')
    values = shown(run, 20)
    assert values[:5] == [5, 10, 15, 20, 25]
    assert values[5:] == sorted(values[5:], reverse=True)
    assert len(set(values[5:15])) == 10
    assert values[14:] == [0] * 6


def test_a_robot_that_failed_makes_no_sound() -> None:
    robot = avatar(ACTUATOR.format(settings='shows="sound"', later=""))
    world = empty_world(a=(1000, 1000, 0), b=(500, 500, 0))
    run = run_of({"a": (robot, "Own.Pump(40); WAIT(100);"), "b": (robot, WAITING)}, world)
    assert shown(run) == [40]
    run.inject_fault("a", "fail")
    assert shown(run, 2)[-1] == 0


# ---- all of them


ALL = (
    SENSOR.replace('"Own"', '"Knob"').format(simulate='as="slider" initial="3" noise="2"', range=""),
    SENSOR.replace('"Own"', '"Day"').format(simulate='as="schedule" values="0:1 2:50" between="line"', range=""),
    SENSOR.replace('"Own"', '"Luck"').format(simulate='as="chance" period="60" latency="40"', range=""),
    SENSOR.replace('"Own"', '"Home"').format(simulate='as="place" of="a" reach="500"', range=""),
    ACTUATOR.format(settings='shows="bar" time="300" noise="10" latency="60"', later=""),
)
BUSY = "*(Own.Pump(Day.Value()); WAIT(2); [Luck.MoreThan(50)](Own.Rest();) WAIT(2); Own.Burst(); WAIT(1);)"


def everything() -> Simulation:
    return run_of({"a": (avatar(*ALL), BUSY)}, empty_world(a=(1000, 1000, 0)), seconds=None)


def test_a_snapshot_goes_on_alike_and_a_recording_tells_what_is_shown() -> None:
    run = steps(everything(), 77)
    other = everything()
    other.restore(run.snapshot())
    recorder, again = Recorder(run), Recorder(other)
    columns = [column.name for column in recorder.header.columns]
    at = columns.index("shown Own 0")
    values = []
    for _ in range(200):
        steps(run, 1)
        steps(other, 1)
        record = recorder.record()
        assert again.record().numbers == record.numbers
        values.append(record.numbers[at])
    assert len(set(values)) > 10


def test_a_model_that_is_not_known_or_is_named_twice_is_told() -> None:
    (problem,) = device_problems(avatar(SENSOR.format(simulate='as="slidr"', range="")))
    assert problem.help.startswith("did you mean")
    text = f'<robot name="r" version="1"><help>x</help>{SENSOR.format(simulate="", range="")}</robot>'
    robot, problems = read_robot(text.encode(), "r.robot.xml")
    assert robot is None
    assert 'expected as="…" on <simulate>' in problems[0].message
    twice = SENSOR.format(simulate='as="slider"/><simulate as="chance"', range="")
    robot, problems = read_robot(f'<robot name="r" version="1"><help>x</help>{twice}</robot>'.encode(), "r.robot.xml")
    assert robot is None
    assert "holds a <simulate> already" in problems[0].message


def test_what_is_simulated_in_place_of_it_changes_no_image() -> None:
    plain: Robot = avatar(SENSOR.format(simulate='as="slider"', range=""))
    other = avatar(SENSOR.format(simulate='as="chance"', range=""))
    assert plain.fingerprint == other.fingerprint
    assert plain.sensors[0].board.driver == "thermometer"
