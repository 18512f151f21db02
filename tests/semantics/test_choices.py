"""Conditionals, events and conditions."""

from __future__ import annotations

import pytest

from tests.semantics.facts import Fact, every_fact, holds

CHOICES = [
    Fact(
        "[c] runs its first side where c holds",
        "[Button.IsPressed()](Wheel.Advance(1))!(Light.LightOn()); Switch.SwitchOn();",
        {0: "Wheel.Advance(1) Switch.SwitchOn()"},
        ended=0,
        given={0: {"Button": 1}},
    ),
    Fact(
        "[c] runs its other side where c does not hold",
        "[Button.IsPressed()](Wheel.Advance(1))!(Light.LightOn()); Switch.SwitchOn();",
        {0: "Light.LightOn() Switch.SwitchOn()"},
        ended=0,
    ),
    Fact(
        "[c] may have one side only",
        "[Button.IsPressed()](Wheel.Advance(1)); Light.LightOn();",
        {0: "Light.LightOn()"},
        0,
    ),
    Fact(
        "[c] tests once, now: what changes later does not matter",
        "[Button.IsPressed()](WAIT(1); Wheel.Advance(1))!(Light.LightOn());",
        {5: "Wheel.Advance(1)"},
        ended=5,
        given={0: {"Button": 1}, 1: {"Button": 0}},
    ),
    Fact(
        "<c> tests in the tick it is reached and runs its body in the tick that finds c true",
        "<Button.IsPressed()>(Wheel.Advance(1)); Light.LightOn();",
        {0: "Wheel.Advance(1) Light.LightOn()"},
        ended=0,
        given={0: {"Button": 1}},
    ),
    Fact(
        "<c> tests every tick until c holds",
        "<Button.IsPressed()>(Wheel.Advance(1)); Light.LightOn();",
        {7: "Wheel.Advance(1) Light.LightOn()"},
        ended=7,
        given={7: {"Button": 1}},
    ),
    Fact(
        "<c> runs its body once and to its end, whatever becomes of c",
        "<Button.IsPressed()>(WAIT(1); Wheel.Advance(1));",
        {7: "Wheel.Advance(1)"},
        ended=7,
        given={2: {"Button": 1}, 3: {"Button": 0}},
    ),
    Fact(
        "<c> does not see what happened before it was reached",
        "WAIT(1); <Button.IsPressed()>(Wheel.Advance(1));",
        {},
        given={2: {"Button": 1}, 3: {"Button": 0}},
    ),
    Fact(
        "<c> sees a variable that an earlier branch wrote in the same tick",
        "//( WAIT(1); Flag.Set(1);, <Flag.IsTrue()>(Wheel.Advance(1)) );",
        {5: "Wheel.Advance(1)"},
        ended=6,
    ),
    Fact(
        "<c> sees a variable that a later branch wrote one tick after",
        "//( <Flag.IsTrue()>(Wheel.Advance(1)), WAIT(1); Flag.Set(1); );",
        {6: "Wheel.Advance(1)"},
        ended=7,
    ),
]

TRUTH = [
    # condition, Captor, Button → holds
    ("Button.IsPressed()", 0, 1, True),
    ("Button.IsReleased()", 0, 1, False),
    ("!(Button.IsPressed())", 0, 0, True),
    ("Captor.LessThan(10)", 9, 0, True),
    ("Captor.LessThan(10)", 10, 0, False),
    ("Captor.GreaterThan(10)", 10, 0, False),
    ("Captor.GreaterThan(10)", 11, 0, True),
    ("Captor.EqualTo(10)", 10, 0, True),
    ("Captor.EqualTo(10)", 11, 0, False),
    ("Captor.LessThan(10) & Button.IsPressed()", 5, 1, True),
    ("Captor.LessThan(10) & Button.IsPressed()", 5, 0, False),
    ("Captor.LessThan(10) | Button.IsPressed()", 50, 1, True),
    ("Captor.LessThan(10) | Button.IsPressed()", 50, 0, False),
    ("Button.IsReleased() | Captor.LessThan(10) & Button.IsPressed()", 50, 0, True),
    ("(Button.IsReleased() | Captor.LessThan(10)) & Button.IsPressed()", 50, 0, False),
    ("Captor.LessThan(10) & Button.IsPressed() | Button.IsReleased()", 50, 0, True),
    ("Captor.LessThan(10) & (Button.IsPressed() | Button.IsReleased())", 50, 0, False),
    ("!(Captor.LessThan(10) | Button.IsPressed())", 50, 0, True),
    ("!(!(Captor.LessThan(10)))", 5, 0, True),
    ("Captor.LessThan(Level.Value())", 49, 0, True),
    ("Captor.LessThan(Level.Value())", 50, 0, False),
    ("Captor.EqualTo(Captor.Value())", 77, 0, True),
    ("Count.EqualTo(0)", 0, 0, True),
    ("Level.GreaterThan(49)", 0, 0, True),
    ("Level.LessThan(50)", 0, 0, False),
    ("Run.IsTrue()", 0, 0, True),
    ("Flag.IsTrue()", 0, 0, False),
    ("Flag.IsFalse()", 0, 0, True),
    ("Fault.IsRaised()", 0, 0, False),
    ("Light.IsRed() | Light.IsGreen() | Light.IsBlue()", 0, 0, False),
]


@every_fact(CHOICES)
def test_choice(fact: Fact, engine: str) -> None:
    holds(fact, engine)


@pytest.mark.parametrize("engine", ["oracle", "machine"])
@pytest.mark.parametrize(("condition", "captor", "button", "expected"), TRUTH)
def test_condition(condition: str, captor: int, button: int, expected: bool, engine: str) -> None:
    commands = {0: "Wheel.Advance(1)"} if expected else {0: "Light.LightOn()"}
    program = f"[{condition}](Wheel.Advance(1))!(Light.LightOn());"
    holds(Fact(condition, program, commands, 0, given={0: {"Captor": captor, "Button": button}}), engine)
    inverted = f"[!({condition})](Light.LightOn())!(Wheel.Advance(1));"
    holds(Fact(condition, inverted, commands, 0, given={0: {"Captor": captor, "Button": button}}), engine)
