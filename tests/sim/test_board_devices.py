"""Devices of small boards: display, keys, music, accelerometer, pins, chance; what they show, what a person does."""

from __future__ import annotations

import itertools
from collections import Counter

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.primitives.robot import Robot
from kitrobot.sim.devices.display import run_through
from kitrobot.sim.recorder import Recorder
from kitrobot.sim.simulation import Simulation
from tests.sim.building import avatar, empty_world, run_of, steps

DISPLAY = """<actuator name="Display" device="display" {settings}>
  <procedure name="Clear"/>
  <procedure name="Image"><parameter name="number" max="19"/></procedure>
  <procedure name="Number"><parameter name="value" max="99"/></procedure>
  <procedure name="Scroll" completes="later" stop="Clear"><parameter name="value" min="-999" max="9999"/></procedure>
  <procedure name="Pixel" completes="later">
    <parameter name="x" max="9"/><parameter name="y" max="9"/><parameter name="brightness" max="99"/>
  </procedure>
</actuator>"""
MUSIC = """<actuator name="Music" device="music" {settings}>
  <procedure name="Stop"/>
  <procedure name="Tone" completes="later" stop="Stop">
    <parameter name="frequency" max="20000"/><parameter name="duration" max="60000"/>
  </procedure>
  <procedure name="Play" completes="later" stop="Stop"><parameter name="melody" max="99"/></procedure>
</actuator>"""
HUM = """<actuator name="Music" device="music">
  <procedure name="Tone" stop="Stop"><parameter name="frequency" max="20000"/></procedure><procedure name="Stop"/>
</actuator>"""
PIN = """<actuator name="Pin" device="pin-out">
  <procedure name="Servo"><parameter name="angle" max="180"/></procedure>
  <procedure name="Analog"><parameter name="value" max="1023"/></procedure>
  <procedure name="Write"><parameter name="value" max="1"/></procedure>
</actuator>"""
SENSOR = """<sensor name="{name}" device="{device}" {settings}>
  <operation name="Value" value="yes"/><operation name="IsOne" test="equal" to="1"/>
</sensor>"""
KEY = SENSOR.format(name="A", device="key", settings='type="boolean"')
RANDOM = SENSOR.format(name="Chance", device="random", settings='min="{least}" max="{most}" {more}')


def run(text: str, *parts: str, seed: int = 1, seconds: float | None = 60, tick: int = 20) -> Simulation:
    robot: Robot = avatar(*parts, tick=tick)
    return run_of({"a": (robot, text)}, empty_world(a=(1000, 1000, 0)), seed=seed, seconds=seconds)


def shown(simulation: Simulation, name: str) -> list[int]:
    return dict(simulation.members[0].outputs())[name]


def picture(simulation: Simulation) -> list[str]:
    return [f"{row:05}" for row in shown(simulation, "Display")]


# ---- display


HEART = ["09090", "99999", "99999", "09990", "00900"]


def test_an_image_is_shown_until_something_else_is() -> None:
    made = run("Display.Image(0); WAIT(2); Display.Clear(); WAIT(1);", DISPLAY.format(settings=""))
    assert picture(made) == ["00000"] * 5
    assert picture(steps(made, 1)) == picture(steps(made, 9)) == HEART
    assert picture(steps(made, 1)) == ["00000"] * 5


def test_a_number_is_a_digit_and_more_than_nine_is_nine() -> None:
    one = steps(run("Display.Number(1); WAIT(1);", DISPLAY.format(settings="")), 1)
    assert picture(one) == ["00900", "09900", "00900", "00900", "09990"]
    nines = [steps(run(f"Display.Number({n}); WAIT(1);", DISPLAY.format(settings="")), 1) for n in (9, 10, 99)]
    assert len({tuple(picture(each)) for each in nines}) == 1


def test_an_image_beyond_the_last_is_the_last() -> None:
    display = DISPLAY.format(settings="").replace('max="19"', 'max="65535"')
    last, more = (steps(run(f"Display.Image({n}); WAIT(1);", display), 1) for n in (19, 65535))
    assert picture(last) == picture(more) == ["09090", "90909", "09090", "90909", "09090"]


def test_pixels_are_set_one_a_tick_over_what_is_there_and_stay_on_the_display() -> None:
    text = (
        "Display.Image(0); WAIT(1); Display.Pixel(0, 0, 5); Display.Pixel(1, 0, 0); Display.Pixel(9, 9, 99); WAIT(1);"
    )
    made = steps(run(text, DISPLAY.format(settings="")), 5)
    assert [picture(steps(made, 1))[0] for _ in range(2)] == ["59090", "50090"]
    assert picture(steps(made, 1)) == ["50090", *HEART[1:4], "00909"]


def test_a_number_runs_through_in_its_time_and_is_done_when_it_is_out() -> None:
    # Five columns to come in and six for each of two digits, 40 ms each: 34 ticks, and one to go on.
    made = run("Display.Scroll(42); Display.Number(0);", DISPLAY.format(settings='delay="40"'))
    frames = []
    while made.outcome is None:
        frames.append(picture(steps(made, 1)))
    assert made.tick == 35
    assert made.seconds == pytest.approx(0.7)
    # "4" stands in the middle after five columns, "2" after eleven.
    assert frames[9] == ["00990", "09090", "90090", "99999", "00090"]
    assert frames[21] == ["99900", "00090", "09900", "90000", "99990"]
    assert frames[33] == ["00000"] * 5


def test_a_number_below_zero_runs_through_with_its_sign() -> None:
    output = [0] * 6
    assert not run_through(-7, 5, output)
    assert output[:5] == [0, 0, 9990, 0, 0]
    assert not run_through(-7, 11, output)
    assert [f"{row:05}" for row in output[:5]] == ["99999", "00090", "00900", "09000", "90000"]
    assert not run_through(-7, 16, output)
    assert run_through(-7, 17, output)


@given(st.integers(-(2**29), 2**29), st.integers(0, 100))
def test_whatever_runs_through_every_row_is_five_lights(value: int, column: int) -> None:
    output = [0] * 6
    assert run_through(value, column, output) == (column >= 5 + 6 * len(str(value)))
    assert all(0 <= row <= 99_999 and set(f"{row:05}") <= {"0", "9"} for row in output[:5])


def test_another_command_takes_the_place_of_a_number_that_runs_through() -> None:
    made = run("//(WAIT(1);, °Display.Scroll(8888)°;); WAIT(1);", DISPLAY.format(settings=""))
    steps(made, 20)
    assert picture(made) == ["00000"] * 5
    assert made.outcome == "done"


def test_a_late_display_shows_pixels_where_they_belong() -> None:
    made = run("Display.Pixel(1, 2, 3); WAIT(9);", DISPLAY.format(settings='latency="100"'))
    assert picture(steps(made, 5)) == ["00000"] * 5
    assert picture(steps(made, 1)) == ["00000", "00000", "03000", "00000", "00000"]


# ---- music and pins


def test_a_tone_sounds_as_long_as_it_says() -> None:
    made = run("Music.Tone(440, 100); Music.Tone(220, 20);", MUSIC.format(settings=""))
    heard = []
    while made.outcome is None:
        heard.append(shown(steps(made, 1), "Music"))
    assert heard == [[440, 0]] * 4 + [[0, 0]] + [[0, 0]] * (len(heard) - 5)
    assert len(heard) == 7


def test_a_melody_is_over_after_its_time_and_can_be_stopped() -> None:
    made = run("Music.Play(2);", MUSIC.format(settings=""))
    assert shown(steps(made, 1), "Music") == [0, 3]
    while made.outcome is None:
        steps(made, 1)
    assert made.seconds == pytest.approx(0.66, abs=0.03)
    made = steps(run("//(WAIT(1);, °Music.Play(8)°;); WAIT(1);", MUSIC.format(settings="")), 9)
    assert shown(made, "Music") == [0, 0]


def test_a_tone_without_a_duration_sounds_until_it_is_stopped() -> None:
    made = steps(run("Music.Tone(300); WAIT(50); Music.Stop(); WAIT(1);", HUM), 240)
    assert shown(made, "Music") == [300, 0]
    assert shown(steps(made, 20), "Music") == [0, 0]


def test_a_robot_that_failed_is_silent() -> None:
    robot = avatar(HUM)
    agents = dict.fromkeys(("a", "b"), (robot, "Music.Tone(300); WAIT(50);"))
    made = steps(run_of(agents, empty_world(a=(1000, 1000, 0), b=(2000, 1000, 0))), 5)
    made.inject_fault("a", "fail")
    steps(made, 1)
    assert [dict(member.outputs())["Music"] for member in made.members] == [[0, 0], [300, 0]]


def test_a_pin_remembers_how_it_is_used_and_what_it_was_told() -> None:
    made = run("Pin.Write(1); WAIT(1); Pin.Analog(700); WAIT(1); Pin.Servo(90); WAIT(1);", PIN)
    assert shown(made, "Pin") == [0, 0]
    assert [shown(steps(made, 5), "Pin") for _ in range(3)] == [[1, 1], [2, 700], [3, 90]]


# ---- what a person does


def test_a_key_is_not_pressed_until_somebody_holds_it() -> None:
    made = steps(run("<A.IsOne()>(WAIT(1););", KEY, seconds=None), 1000)
    assert (made.outcome, made.agents[0].inputs["A"]) == (None, 0)
    made.force("a", "A", 1)
    assert steps(made, 1).agents[0].inputs["A"] == 1
    made.force("a", "A", 0)
    steps(made, 10)
    assert made.outcome == "done"


@pytest.mark.parametrize("sensor", [KEY, RANDOM.format(least=0, most=1, more="")])
def test_who_waits_for_a_person_or_for_chance_is_not_stuck(sensor: str) -> None:
    plain = SENSOR.format(name="A", device="button", settings='type="boolean"')
    waiting = "*[Flag.IsFalse()](WAIT(1););"
    flag = '<variable name="Flag" type="boolean"/>'
    assert steps(run(waiting, plain, flag), 1000).outcome == "stuck"
    assert steps(run(waiting, sensor, flag, seconds=None), 1000).outcome is None


def test_a_held_key_that_is_let_go_again_leaves_the_run_open() -> None:
    made = run("*[Flag.IsFalse()](WAIT(1););", KEY, '<variable name="Flag" type="boolean"/>', seconds=None)
    for value in (1, None, 1, 0, None):
        made.force("a", "A", value)
        steps(made, 300)
    assert made.outcome is None


@pytest.mark.parametrize(
    ("settings", "resting"),
    [('axis="x"', 0), ('axis="y"', 0), ('axis="z"', -1024), ('what="shake" axis="z"', 0), ("", 0)],
)
def test_a_board_lies_level_and_still(settings: str, resting: int) -> None:
    sensor = SENSOR.format(name="Tilt", device="accelerometer", settings=f'min="-2048" max="2047" {settings}')
    made = steps(run("WAIT(9);", sensor), 3)
    assert made.agents[0].inputs["Tilt"] == resting
    made.force("a", "Tilt", 700)
    assert steps(made, 1).agents[0].inputs["Tilt"] == 700
    made.force("a", "Tilt", None)
    assert steps(made, 1).agents[0].inputs["Tilt"] == resting


def test_a_pin_reads_what_somebody_puts_there() -> None:
    made = steps(run("WAIT(9);", SENSOR.format(name="Pin", device="pin-in", settings='max="1023"')), 3)
    assert made.agents[0].inputs["Pin"] == 0
    made.force("a", "Pin", 512)
    assert steps(made, 1).agents[0].inputs["Pin"] == 512


# ---- chance


def drawn(seed: int = 1, least: int = 1, most: int = 6, more: str = "", count: int = 3000, tick: int = 20) -> list[int]:
    made = run("WAIT(60000);", RANDOM.format(least=least, most=most, more=more), seed=seed, seconds=None, tick=tick)
    return [steps(made, 1).agents[0].inputs["Chance"] for _ in range(count)]


def test_a_random_sensor_gives_every_number_as_often() -> None:
    found = Counter(drawn())
    assert set(found) == {1, 2, 3, 4, 5, 6}
    assert all(400 < count < 600 for count in found.values())


def test_the_seed_decides_what_is_drawn() -> None:
    assert drawn(count=50) == drawn(count=50)
    assert drawn(count=50) != drawn(seed=2, count=50)


def test_random_numbers_have_any_range() -> None:
    assert set(drawn(least=-1, most=1, count=100)) == {-1, 0, 1}
    assert set(drawn(least=1, most=1, count=5)) == {1}
    wide = drawn(least=-(2**29 - 1), most=2**29 - 1, count=50)
    assert min(wide) < -(10**8) < 10**8 < max(wide)


def test_a_random_number_that_is_lost_is_the_one_before() -> None:
    found = drawn(more='dropout="50"', most=1000)
    stays = sum(now == before for before, now in itertools.pairwise(found))
    assert 1400 < stays < 1600


# ---- what is recorded


def test_what_is_shown_stands_in_the_recording() -> None:
    made = run(
        "Display.Image(0); Music.Tone(440, 100); WAIT(1);", DISPLAY.format(settings=""), MUSIC.format(settings="")
    )
    recorder = Recorder(made)
    names = [column.name for column in recorder.header.columns if column.name.startswith("shown ")]
    assert names == [*(f"shown Display {row}" for row in range(5)), "shown Music 0", "shown Music 1"]
    steps(made, 1)
    numbers = dict(zip((column.name for column in recorder.header.columns), recorder.record().numbers, strict=True))
    assert [numbers[name] for name in names] == [9090, 99999, 99999, 9990, 900, 440, 0]
