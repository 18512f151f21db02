"""One robot's program as a host runs it: names for cells and commands, its state, and what it refuses."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.compilation import compile_lll, compile_text
from kitrobot.image.devices import Command, Readings
from kitrobot.image.listing import disassemble
from kitrobot.image.machine import Machine
from kitrobot.image.model import ImageError
from kitrobot.primitives.robot import Robot
from kitrobot.primitives.robot_xml import read_robot
from tests.image.listings import TWO_BRANCHES, compiled, mini_robot
from tests.strategies import random_program, random_robot, random_script

ROBOT = """\
<robot name="odd" version="1" tick="{tick}">
  <actuator name="A" device="drive">
    <procedure name="Go"><parameter name="speed" min="0" max="{most}" default="0"/></procedure>
    <procedure name="Later" completes="later"/>
  </actuator>
  <actuator name="B" device="lamp"><procedure name="On"/></actuator>
  <sensor name="S" device="range" min="5" max="9"><operation name="Value" value="yes"/></sensor>
  <variable name="{variable}" type="integer" min="-3" max="3" initial="-2"/>
  <variable name="W" type="boolean" initial="true"/>
</robot>
"""


def robot(tick: int = 20, most: int = 9, variable: str = "V") -> Robot:
    made, problems = read_robot(ROBOT.format(tick=tick, most=most, variable=variable).encode(), "odd.robot.xml")
    assert made is not None, problems
    return made


def machine(text: str, on: Robot | None = None) -> Machine:
    on = on or robot()
    result = compile_text(text, on)
    assert result.image is not None, result.diagnostics
    return Machine(result.image, on)


def test_a_robot_begins_with_its_first_values() -> None:
    made = machine("WAIT(1);")
    assert made.variables() == {"V": -2, "W": 1}
    assert made.input("S") == 5
    assert (made.fault, made.ended) == (0, False)
    assert made.active() == [(0, 0)]


@pytest.mark.parametrize(("value", "sampled"), [(4, 5), (5, 5), (7, 7), (9, 9), (10, 9), (-(10**9), 5), (10**9, 9)])
def test_a_sensor_is_sampled_within_its_range_and_raises_no_fault(value: int, sampled: int) -> None:
    made = machine("WAIT(1);")
    made.set_input("S", value)
    made.tick()
    assert (made.input("S"), made.fault) == (sampled, 0)


@pytest.mark.parametrize(("value", "kept"), [(-4, -3), (-3, -3), (0, 0), (3, 3), (4, 3)])
def test_a_variable_set_from_outside_stays_in_its_range(value: int, kept: int) -> None:
    made = machine("WAIT(1);")
    made.set_variable("V", value)
    assert made.variables()["V"] == kept


def test_a_name_that_is_not_there_is_a_mistake_of_the_host() -> None:
    made = machine("")
    with pytest.raises(KeyError):
        made.set_input("Nose", 1)
    with pytest.raises(StopIteration):
        made.set_variable("Nose", 1)


def test_done_of_an_actuator_that_never_completes_later_is_of_no_effect() -> None:
    made = machine("B.On(); WAIT(9);")
    before = made.cells[:]
    made.set_done("B", False)
    made.set_done("Nose", False)
    assert made.cells == before


def test_done_holds_a_later_procedure_up() -> None:
    made = machine("A.Later(); B.On();")
    made.set_done("A", False)
    assert made.tick() == [Command("A", "Later", [], 0, 0)]
    assert made.tick() == []
    made.set_done("A", True)
    assert made.tick() == [Command("B", "On", [], 0, 3)]
    assert made.ended


def test_commands_come_in_the_order_of_the_actuators_with_who_gave_them() -> None:
    given = machine("//(B.On();, A.Go(7););").tick()
    assert [(one.actuator, one.procedure, one.arguments, one.slot) for one in given] == [
        ("A", "Go", [7], 2),
        ("B", "On", [], 1),
    ]


def test_commands_of_the_last_tick_can_be_asked_again() -> None:
    made = machine("B.On();")
    given = made.tick()
    assert made.commands() == given
    assert made.tick() == made.commands() == []


def test_the_program_s_end_is_the_end_of_its_own_thread() -> None:
    made = machine("B.On();")
    made.tick()
    assert made.ended
    assert made.active() == []


def test_a_live_thread_stands_where_it_waits() -> None:
    made = machine("B.On(); WAIT(1); B.On();")
    listing = disassemble(made.image).split(".code\n")[1].splitlines()
    made.tick()
    ((slot, instruction),) = made.active()
    assert slot == 0
    assert listing[instruction].split()[0] == "WAIT"


def test_a_fault_is_raised_by_clamping_and_cleared_by_the_program() -> None:
    made = machine("V.Add(9); WAIT(1); Fault.Clear();")
    made.tick()
    assert (made.fault, made.variables()["V"]) == (1, 3)
    for _ in range(5):
        made.tick()
    assert made.fault == 0


def test_a_watched_machine_says_which_instructions_ran() -> None:
    on = robot()
    image = compile_text("[W.IsTrue()](B.On();)!(A.Go(1););", on).image
    assert image is not None
    made = Machine(image, on, watch=True)
    made.tick()
    assert made.seen == [1, 1, 1, 0, 1]
    made.tick()
    assert made.seen == [0, 0, 0, 0, 0]


# ---- refusals -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("other", [robot(tick=40), robot(most=8), robot(variable="X")], ids=["tick", "range", "name"])
def test_an_image_for_another_definition_of_the_robot_is_refused(other: Robot) -> None:
    image = machine("B.On();").image
    with pytest.raises(ImageError) as caught:
        Machine(image, other)
    assert caught.value.message == "this image was made for another robot than `odd` as it is defined now"
    assert caught.value.help == "compile the program again for this robot"


def test_an_image_for_another_robot_is_refused() -> None:
    with pytest.raises(ImageError, match="this image was made for another robot than `mini-robot`"):
        Machine(machine("B.On();").image, mini_robot())


def test_an_image_with_other_inputs_or_variables_than_its_robot_is_refused() -> None:
    image = compiled("Wheel.Stop();")
    bad = replace(image, inputs=image.inputs - 1, variables=image.variables + 1)
    with pytest.raises(ImageError, match="this image's cells are not those of its robot"):
        Machine(bad, mini_robot())


def test_an_image_with_other_commands_than_its_robot_is_refused() -> None:
    image = compiled("Wheel.Stop();")
    with pytest.raises(ImageError, match="this image's commands are not those of its robot"):
        Machine(replace(image, commands=image.commands[::-1]), mini_robot())


# ---- snapshots ----------------------------------------------------------------------------------------------


def test_a_restored_robot_goes_on_as_it_did() -> None:
    made = Machine(compiled(TWO_BRANCHES), mini_robot())
    made.tick()
    made.tick()
    kept = made.snapshot()
    first = [(made.tick(), made.variables(), made.active(), made.ended) for _ in range(30)]
    made.restore(kept)
    assert [(made.tick(), made.variables(), made.active(), made.ended) for _ in range(30)] == first
    assert first[-1][3]


def test_a_snapshot_does_not_change_when_the_robot_goes_on() -> None:
    made = Machine(compiled(TWO_BRANCHES), mini_robot())
    kept = made.snapshot()
    copy = tuple(part[:] for part in kept)
    for _ in range(20):
        made.tick()
    assert kept == copy
    made.restore(kept)
    made.tick()
    assert kept == copy


def test_two_machines_of_one_image_share_nothing() -> None:
    image = compiled("Count.Add(1);")
    one, other = Machine(image, mini_robot()), Machine(image, mini_robot())
    one.tick()
    assert (one.variables()["Count"], other.variables()["Count"]) == (1, 0)


@given(st.randoms(use_true_random=True))
def test_a_random_program_restored_anywhere_goes_on_the_same(rng: random.Random) -> None:
    on = random_robot(rng)
    image = compile_lll(random_program(rng, on), on).image
    assert image is not None
    script = random_script(rng, on, 40)

    def go(made: Machine, ticks: range) -> list[object]:
        seen: list[object] = []
        for tick in ticks:
            for sensor, value in script[tick].inputs.items():
                made.set_input(sensor, value)
            for actuator, done in script[tick].done.items():
                made.set_done(actuator, done)
            seen.append((made.tick(), made.cells[:], made.threads[:], made.pars[:]))
        return seen

    whole = Machine(image, on)
    half = rng.randint(1, 39)
    go(whole, range(half))
    kept = whole.snapshot()
    wanted = go(whole, range(half, 40))
    fresh = Machine(image, on)
    go(fresh, range(rng.randint(0, 10)))
    fresh.restore(kept)
    assert go(fresh, range(half, 40)) == wanted


# ---- a host's devices ---------------------------------------------------------------------------------------


class Bench:
    """Devices that give what they are told, and keep what they are given."""

    def __init__(self, *readings: Readings) -> None:
        self.readings = list(readings)
        self.applied: list[Sequence[Command]] = []

    def read(self) -> Readings:
        return self.readings.pop(0)

    def apply(self, commands: Sequence[Command]) -> None:
        self.applied.append(commands)


def test_a_reaction_reads_the_devices_then_ticks_then_applies_the_commands() -> None:
    made = machine("A.Later(); B.On(); A.Go(S.Value());")
    bench = Bench(Readings(done={"A": False}), Readings(), Readings({"S": 20}, {"A": True}))
    given = [made.react(bench) for _ in range(3)]
    assert bench.applied == given
    called = [[(one.actuator, one.procedure, one.arguments) for one in commands] for commands in given]
    assert called == [[("A", "Later", [])], [], [("A", "Go", [9]), ("B", "On", [])]]
    assert made.input("S") == 9


def test_an_input_without_a_reading_keeps_its_value() -> None:
    made = machine("WAIT(1);")
    bench = Bench(Readings({"S": 7}, {"A": False}), Readings())
    made.react(bench)
    made.react(bench)
    assert (made.input("S"), made.cells[made.layout.done["A"]]) == (7, 0)
