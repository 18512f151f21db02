"""Parallels without marks: starting, settling, slots, live variables."""

from __future__ import annotations

from tests.semantics.facts import Fact, every, every_fact, holds

FACTS = [
    Fact(
        "the branches run their first step in the tick in which the parallel is reached",
        "Wheel.Advance(1); //(Light.LightOn(), Switch.SwitchOn());",
        {0: "Wheel.Advance(1) Light.LightOn() Switch.SwitchOn()"},
        ended=1,
    ),
    Fact(
        "the thread goes on in the tick after the one in which all branches have ended",
        "//(Wheel.Advance(1), WAIT(1)); Light.LightOn();",
        {0: "Wheel.Advance(1)", 6: "Light.LightOn()"},
        ended=6,
    ),
    Fact("a parallel with no branch costs one tick", "//(); Light.LightOn();", {1: "Light.LightOn()"}, ended=1),
    Fact(
        "a missing branch is dropped",
        "//(, Wheel.Advance(1), ,); Light.LightOn();",
        {0: "Wheel.Advance(1)", 1: "Light.LightOn()"},
        ended=1,
    ),
    Fact(
        "each parallel in a row costs a tick",
        "//(Wheel.Advance(1)); //(Wheel.Advance(2)); Light.LightOn();",
        {0: "Wheel.Advance(1)", 1: "Wheel.Advance(2)", 2: "Light.LightOn()"},
        ended=2,
    ),
    Fact(
        "each level of nesting costs a tick",
        "//(//(Wheel.Advance(1))); Light.LightOn();",
        {0: "Wheel.Advance(1)", 2: "Light.LightOn()"},
        ended=2,
    ),
    Fact(
        "a branch goes on after its inner parallel while the others run",
        "//( //(WAIT(1), WAIT(2)); Wheel.Advance(1);, WAIT(3) ); Light.LightOn();",
        {11: "Wheel.Advance(1)", 16: "Light.LightOn()"},
        ended=16,
    ),
    Fact(
        "a parallel can be started again and again",
        "2*(//(Wheel.Advance(1), WAIT(1)));",
        {0: "Wheel.Advance(1)", 6: "Wheel.Advance(1)"},
        ended=12,
    ),
    Fact(
        "a write is seen at once by slots that run later in the tick, by earlier ones in the next tick",
        "//( [Count.EqualTo(1)](Wheel.Advance(1)), Count.Add(1), [Count.EqualTo(1)](Light.LightOn()) );",
        {0: "Light.LightOn()"},
        ended=1,
    ),
    Fact(
        "slots are in reading order: what is nested in a branch runs before the next branch",
        "//( //(Count.Set(5), WAIT(0)), Level.Set(Count.Value()) );",
        ended=3,
        variables={0: {"Count": 5, "Level": 5}},
    ),
    Fact(
        "the outer thread of a slot runs before what is nested in it",
        "//( Count.Set(1); //([Count.EqualTo(1)](Wheel.Advance(1))); );",
        {0: "Wheel.Advance(1)"},
        ended=2,
    ),
    Fact(
        "a command of a nested branch loses to one of a later branch",
        "//( //(Wheel.Advance(1), Wheel.Advance(2)), Wheel.Advance(3) );",
        {0: "Wheel.Advance(3)"},
        ended=2,
    ),
    Fact(
        "branches keep their own count of the same kind of loop",
        "//( 2*(Wheel.Advance(1); WAIT(1)), 3*(Light.LightOn(); WAIT(0)) );",
        {0: "Wheel.Advance(1) Light.LightOn()", 1: "Light.LightOn()", 2: "Light.LightOn()", 5: "Wheel.Advance(1)"},
        ended=11,
    ),
    Fact(
        "the program's own thread ends only after its parallel",
        "//(*[Button.IsReleased()](WAIT(0)), WAIT(1));",
        ended=9,
        given={8: {"Button": 1}},
    ),
    Fact(
        "two threads add to one variable in one tick",
        "//( 3*(Count.Add(1)), 3*(Count.Add(2)) );",
        ended=3,
        variables={0: {"Count": 3}, 1: {"Count": 6}, 2: {"Count": 9}},
    ),
    Fact(
        "a branch may be an endless loop, and then nothing follows",
        "//( *[Run.IsTrue()](Wheel.Advance(1)), WAIT(1) ); Light.LightOn();",
        every(range(30), "Wheel.Advance(1)"),
    ),
]


@every_fact(FACTS)
def test_parallel(fact: Fact, engine: str) -> None:
    holds(fact, engine)
