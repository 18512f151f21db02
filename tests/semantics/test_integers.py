"""Variables, parameters, clamping, the fault flag, inputs; and the robot's own tick and wait unit."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.primitives.robot import Robot
from tests.semantics.facts import Fact, every_fact, holds, mini_robot


def wide_captor() -> Robot:
    """The paper's robot with a Captor that sees 0…200, more than a parameter or variable takes."""
    robot = mini_robot()
    sensors = tuple(replace(part, maximum=200) if part.name == "Captor" else part for part in robot.sensors)
    return replace(robot, sensors=sensors)


FACTS = [
    Fact(
        "variables have their first values",
        "WAIT(9);",
        variables={0: {"Count": 0, "Level": 50, "Run": 1, "Flag": 0}},
        ticks=3,
    ),
    Fact(
        "Set, Add and Sub change a variable at once",
        "Count.Set(10); Count.Add(5); Count.Sub(3); Wheel.Advance(Count.Value());",
        {0: "Wheel.Advance(12)"},
        ended=0,
        variables={0: {"Count": 12}},
    ),
    Fact("a variable may reach its max", "Count.Set(100);", ended=0, variables={0: {"Count": 100}}),
    Fact("a sum may reach the max", "Level.Add(50);", ended=0, variables={0: {"Level": 100}}),
    Fact("a difference may reach the min", "Level.Sub(50);", ended=0, variables={0: {"Level": 0}}),
    Fact(
        "a sum over the max is clamped and raises the fault",
        "Level.Add(51);",
        ended=0,
        variables={0: {"Level": 100}},
        faults=range(30),
    ),
    Fact(
        "a difference under the min is clamped and raises the fault",
        "Level.Sub(51);",
        ended=0,
        variables={0: {"Level": 0}},
        faults=range(30),
    ),
    Fact(
        "a value given to Set over the max is clamped and raises the fault",
        "Count.Set(Captor.Value());",
        ended=0,
        given={0: {"Captor": 150}},
        variables={0: {"Count": 100}},
        faults=range(30),
        robot=wide_captor(),
    ),
    Fact(
        "Add and Sub may be given more than the variable holds",
        "Level.Add(Captor.Value()); Level.Sub(Captor.Value());",
        ended=0,
        given={0: {"Captor": 150}},
        variables={0: {"Level": 0}},
        faults=range(30),
        robot=wide_captor(),
    ),
    Fact(
        "what a procedure is given is clamped to its parameter and raises the fault",
        "Wheel.Advance(Captor.Value());",
        {0: "Wheel.Advance(100)"},
        ended=0,
        given={0: {"Captor": 101}},
        faults=range(30),
        robot=wide_captor(),
    ),
    Fact(
        "a procedure may be given exactly the max",
        "Wheel.Advance(Captor.Value());",
        {0: "Wheel.Advance(100)"},
        ended=0,
        given={0: {"Captor": 100}},
        robot=wide_captor(),
    ),
    Fact(
        "tests compare as it is and never raise the fault",
        "[Captor.GreaterThan(149)](Light.LightOn()); [Level.LessThan(Captor.Value())](Switch.SwitchOn());",
        {0: "Light.LightOn() Switch.SwitchOn()"},
        ended=0,
        given={0: {"Captor": 150}},
        robot=wide_captor(),
    ),
    Fact(
        "an input over its sensor's range is clamped, which is no fault",
        "Count.Set(Captor.Value());",
        ended=0,
        given={0: {"Captor": 150}},
        variables={0: {"Count": 100}},
    ),
    Fact(
        "an input under its sensor's range is clamped too",
        "Level.Set(Captor.Value());",
        ended=0,
        given={0: {"Captor": -7}},
        variables={0: {"Level": 0}},
    ),
    Fact(
        "inputs are 0 until they are given, and hold until they are given again",
        "*[Run.IsTrue()](Count.Set(Captor.Value()));",
        given={2: {"Captor": 7}, 5: {"Captor": 0}},
        variables={1: {"Count": 0}, 2: {"Count": 7}, 4: {"Count": 7}, 5: {"Count": 0}},
    ),
    Fact(
        "a test as a parameter is 1 or 0",
        "*[Run.IsTrue()](Flag.Set(Captor.LessThan(Level.Value())));",
        given={0: {"Captor": 49}, 1: {"Captor": 50}, 2: {"Captor": 0}},
        variables={0: {"Flag": 1}, 1: {"Flag": 0}, 2: {"Flag": 1}},
    ),
    Fact("true and false are 1 and 0", "Flag.Set(1); Run.Set(0);", ended=0, variables={0: {"Flag": 1, "Run": 0}}),
    Fact(
        "the fault is seen at once and stays until it is cleared",
        "Level.Add(51); [Fault.IsRaised()](Light.LightOn()); WAIT(0);"
        "Fault.Clear(); [Fault.IsRaised()](Light.LightOn());",
        {0: "Light.LightOn()"},
        ended=1,
        faults=range(1),
    ),
    Fact(
        "a fault that is cleared in the tick of its raising does not show",
        "Level.Add(51); Fault.Clear();",
        ended=0,
        variables={0: {"Level": 100}},
    ),
    Fact(
        "clearing a fault that is not raised does nothing", "Fault.Clear(); Light.LightOn();", {0: "Light.LightOn()"}, 0
    ),
    Fact(
        "each parameter goes to its own place",
        "Motor.AbsoluteTurn(Count.Value(), Level.Value());",
        {0: "Motor.AbsoluteTurn(0,50)"},
        ended=1,
    ),
    Fact(
        "what a command was given does not follow the variable afterwards",
        "Wheel.Advance(Level.Value()); Level.Set(7);",
        {0: "Wheel.Advance(50)"},
        ended=0,
    ),
    Fact(
        "after the end variables stay as they are",
        "Count.Set(3);",
        ended=0,
        variables={0: {"Count": 3}, 29: {"Count": 3}},
    ),
]


@every_fact(FACTS)
def test_integer(fact: Fact, engine: str) -> None:
    holds(fact, engine)


@pytest.mark.parametrize("engine", ["oracle", "machine"])
@pytest.mark.parametrize(
    ("tick_ms", "wait_unit_ms", "duration", "ticks"),
    [
        (20, 100, 0, 1),
        (20, 100, 1, 5),
        (20, 100, 100, 500),
        (30, 100, 1, 4),
        (30, 100, 3, 10),
        (30, 100, 6, 20),
        (20, 10, 1, 1),
        (20, 10, 2, 1),
        (20, 10, 3, 2),
        (100, 1, 1, 1),
        (7, 3, 5, 3),
    ],
)
def test_wait_takes_whole_ticks_rounded_up(
    tick_ms: int, wait_unit_ms: int, duration: int, ticks: int, engine: str
) -> None:
    robot = replace(mini_robot(), tick_ms=tick_ms, wait_unit_ms=wait_unit_ms)
    program = f"WAIT({duration}); Light.LightOn();"
    holds(Fact("wait", program, {ticks: "Light.LightOn()"}, ended=ticks, ticks=ticks + 2, robot=robot), engine)
