"""`n*`, `*[c]`, their passes, and BREAK."""

from __future__ import annotations

from tests.semantics.facts import Fact, every, every_fact, holds

REPEATS = [
    Fact("1*(a) is a", "1*(Wheel.Advance(1)); Light.LightOn();", {0: "Wheel.Advance(1) Light.LightOn()"}, ended=0),
    Fact(
        "n* makes one pass a tick where the body does not block; what follows goes on in the tick of the last pass",
        "3*(Wheel.Advance(1)); Light.LightOn();",
        {**every(range(2), "Wheel.Advance(1)"), 2: "Wheel.Advance(1) Light.LightOn()"},
        ended=2,
    ),
    Fact("0*() does nothing", "0*(Wheel.Advance(1)); Light.LightOn();", {0: "Light.LightOn()"}, ended=0),
    Fact("n* with an empty body passes once a tick", "3*(); Light.LightOn();", {2: "Light.LightOn()"}, ended=2),
    Fact(
        "n* around a wait has a period of exactly the wait",
        "3*(Wheel.Advance(1); WAIT(1)); Light.LightOn();",
        {**every(range(0, 15, 5), "Wheel.Advance(1)"), 15: "Light.LightOn()"},
        ended=15,
    ),
    Fact(
        "a back edge that costs a tick does not make the loop around it block",
        "2*(2*(Wheel.Advance(1)); Light.LightOn());",
        {
            **every(range(0, 4, 2), "Wheel.Advance(1)"),
            **every(range(1, 4, 2), "Wheel.Advance(1) Light.LightOn()"),
        },
        ended=3,
    ),
    Fact(
        "n* (n ≥ 1) around a surely blocking body surely blocks, so the loop around it is free",
        "2*(3*(Wheel.Advance(1); WAIT(1)));",
        every(range(0, 30, 5), "Wheel.Advance(1)"),
        ended=30,
        ticks=40,
    ),
    Fact(
        "0* around a wait does not block",
        "3*(0*(WAIT(1)); Wheel.Advance(1));",
        every(range(3), "Wheel.Advance(1)"),
        ended=2,
    ),
    Fact(
        "n* counts from the start each time it is entered",
        "*[Run.IsTrue()](2*(Wheel.Advance(1)); WAIT(1));",
        every(range(0, 30, 6), "Wheel.Advance(1)") | every(range(1, 30, 6), "Wheel.Advance(1)"),
    ),
]

WHILES = [
    Fact(
        "*( ) goes on once a tick where its body does not block",
        "*(Wheel.Advance(1)); Light.LightOn();",
        every(range(30), "Wheel.Advance(1)"),
    ),
    Fact(
        "*( ) around a wait has a period of exactly the wait",
        "*(Wheel.Advance(1); WAIT(1));",
        every(range(0, 30, 5), "Wheel.Advance(1)"),
    ),
    Fact(
        "BREAK leaves *( ), and what follows runs in the same tick",
        "*(WAIT(1); BREAK); Light.LightOn();",
        {5: "Light.LightOn()"},
        ended=5,
    ),
    Fact(
        "*( ) makes the loop around it pass once a tick, as a *[c] whose c is always true does",
        "3*(*(WAIT(1); BREAK); Wheel.Advance(1));",
        every(range(5, 18, 6), "Wheel.Advance(1)"),
        ended=17,
    ),
    Fact(
        "what was written for *( ) before takes the same ticks",
        "3*(*[Fault.IsRaised() | !(Fault.IsRaised())](WAIT(1); BREAK); Wheel.Advance(1));",
        every(range(5, 18, 6), "Wheel.Advance(1)"),
        ended=17,
    ),
    Fact(
        "*[c] tests before the first pass, and what follows runs in the tick that finds c false",
        "*[Button.IsPressed()](Wheel.Advance(1)); Light.LightOn();",
        {0: "Light.LightOn()"},
        ended=0,
    ),
    Fact(
        "*[c] whose back edge costs a tick tests again in the next",
        "*[Button.IsPressed()](Wheel.Advance(1)); Light.LightOn();",
        {**every(range(3), "Wheel.Advance(1)"), 3: "Light.LightOn()"},
        ended=3,
        given={0: {"Button": 1}, 3: {"Button": 0}},
    ),
    Fact(
        "*[c](WAIT(1)) has a period of exactly one unit, and is left at the end of one",
        "*[Button.IsPressed()](Wheel.Advance(1); WAIT(1)); Light.LightOn();",
        {0: "Wheel.Advance(1)", 5: "Wheel.Advance(1)", 10: "Light.LightOn()"},
        ended=10,
        given={0: {"Button": 1}, 7: {"Button": 0}},
    ),
    Fact(
        "*[c] with an empty body tests once a tick",
        "*[Button.IsReleased()](); Light.LightOn();",
        {4: "Light.LightOn()"},
        ended=4,
        given={4: {"Button": 1}},
    ),
    Fact(
        "*[c] sees what its own body wrote",
        "*[Count.LessThan(3)](Count.Add(1)); Light.LightOn();",
        {3: "Light.LightOn()"},
        ended=3,
        variables={0: {"Count": 1}, 1: {"Count": 2}, 2: {"Count": 3}, 3: {"Count": 3}},
    ),
]

PASSES = [
    Fact(
        "a later call surely blocks",
        "*[Run.IsTrue()](Door.Open(); Wheel.Advance(1));",
        {0: "Door.Open()", **every(range(1, 6), "Wheel.Advance(1) Door.Open()")},
        ticks=6,
    ),
    Fact(
        "a marked later call surely blocks",
        "*[Run.IsTrue()](°Door.Open()°; Wheel.Advance(1));",
        {0: "Door.Open()", **every(range(1, 6), "Wheel.Advance(1) Door.Open()")},
        ticks=6,
    ),
    Fact(
        "a parallel surely blocks",
        "*[Run.IsTrue()](//(Wheel.Advance(1)); Light.LightOn());",
        {0: "Wheel.Advance(1)", **every(range(1, 6), "Wheel.Advance(1) Light.LightOn()")},
        ticks=6,
    ),
    Fact(
        "a parallel with no branch surely blocks",
        "*[Run.IsTrue()](//(); Light.LightOn());",
        every(range(1, 6), "Light.LightOn()"),
        ticks=6,
    ),
    Fact(
        "a conditional with one blocking side does not surely block: the pass costs its own tick too",
        "*[Run.IsTrue()]([Button.IsPressed()](WAIT(1)); Wheel.Advance(1));",
        every(range(5, 30, 6), "Wheel.Advance(1)"),
        given={0: {"Button": 1}},
    ),
    Fact(
        "the same conditional on its other side: one pass a tick",
        "*[Run.IsTrue()]([Button.IsPressed()](WAIT(1)); Wheel.Advance(1));",
        every(range(6), "Wheel.Advance(1)"),
        ticks=6,
    ),
    Fact(
        "a conditional with both sides surely blocking surely blocks",
        "*[Run.IsTrue()]([Button.IsPressed()](WAIT(1))!(WAIT(2)); Wheel.Advance(1));",
        every(range(5, 30, 5), "Wheel.Advance(1)"),
        given={0: {"Button": 1}},
    ),
    Fact(
        "an event around a surely blocking body surely blocks",
        "*[Run.IsTrue()](<Button.IsPressed()>(WAIT(1)); Wheel.Advance(1));",
        every(range(5, 30, 5), "Wheel.Advance(1)"),
        given={0: {"Button": 1}},
    ),
    Fact(
        "an event by itself does not surely block, even where it waits",
        "*[Run.IsTrue()](<Button.IsPressed()>(); Wheel.Advance(1));",
        every(range(3, 8), "Wheel.Advance(1)"),
        given={3: {"Button": 1}},
        ticks=8,
    ),
    Fact(
        "a while around a wait does not surely block",
        "*[Run.IsTrue()](*[Button.IsReleased()](WAIT(1)); Wheel.Advance(1));",
        every(range(5, 9), "Wheel.Advance(1)"),
        given={3: {"Button": 1}},
        ticks=9,
    ),
    Fact(
        "a way that leaves by BREAK is not a way round",
        "*[Run.IsTrue()]([Button.IsPressed()](BREAK)!(WAIT(1)); Wheel.Advance(1)); Light.LightOn();",
        {5: "Wheel.Advance(1)", 10: "Wheel.Advance(1)", 15: "Wheel.Advance(1) Light.LightOn()"},
        ended=15,
        given={12: {"Button": 1}},
    ),
    Fact(
        "what stands behind a BREAK is no way round",
        "*[Run.IsTrue()]([Button.IsPressed()](BREAK; Light.LightOn())!(WAIT(1)); Wheel.Advance(1));",
        every(range(5, 30, 5), "Wheel.Advance(1)"),
    ),
    Fact(
        "an inner loop that BREAK may leave without blocking does not surely block",
        "*[Run.IsTrue()](2*([Button.IsPressed()](BREAK)!(WAIT(1))); Wheel.Advance(1));",
        {10: "Wheel.Advance(1)", 21: "Wheel.Advance(1)"},
    ),
    Fact(
        "an inner loop that is left by BREAK in each pass gives up one tick a pass of the outer",
        "*[Run.IsTrue()](2*([Button.IsPressed()](BREAK)!(WAIT(1))); Wheel.Advance(1));",
        every(range(6), "Wheel.Advance(1)"),
        given={0: {"Button": 1}},
        ticks=6,
    ),
    Fact(
        "an inner n* that blocks before its BREAK surely blocks",
        "*[Run.IsTrue()](2*(WAIT(1); BREAK); Wheel.Advance(1));",
        every(range(5, 30, 5), "Wheel.Advance(1)"),
    ),
    Fact(
        "a wait in a branch blocks the branch's loop, not more",
        "//( *[Run.IsTrue()](Wheel.Advance(1); WAIT(1)), *[Run.IsTrue()](Count.Add(1)) );",
        every(range(0, 10, 5), "Wheel.Advance(1)"),
        variables={0: {"Count": 1}, 9: {"Count": 10}},
        ticks=10,
    ),
]

BREAKS = [
    Fact(
        "BREAK leaves the innermost loop, and what follows runs in the same tick",
        "*[Run.IsTrue()](*[Run.IsTrue()](BREAK); Wheel.Advance(1); BREAK); Light.LightOn();",
        {0: "Wheel.Advance(1) Light.LightOn()"},
        ended=0,
    ),
    Fact(
        "BREAK with no loop ends the program", "Wheel.Advance(1); BREAK; Light.LightOn();", {0: "Wheel.Advance(1)"}, 0
    ),
    Fact(
        "BREAK leaves the loop from inside a conditional and an event",
        "*[Run.IsTrue()](<Button.IsPressed()>([Run.IsTrue()](BREAK)); Wheel.Advance(1)); Light.LightOn();",
        {2: "Light.LightOn()"},
        ended=2,
        given={2: {"Button": 1}},
    ),
    Fact(
        "BREAK with no loop in its branch ends the branch and never crosses the parallel",
        "*[Run.IsTrue()](//(BREAK; Light.LightOn();, Wheel.Advance(1)); Switch.SwitchOn(); BREAK);",
        {0: "Wheel.Advance(1)", 1: "Switch.SwitchOn()"},
        ended=1,
    ),
    Fact(
        "BREAK inside an event with no loop ends the program",
        "<Button.IsPressed()>(BREAK); Light.LightOn();",
        ended=3,
        given={3: {"Button": 1}},
    ),
    Fact(
        "n* that was left by BREAK counts from the start when it is entered again",
        "*[Run.IsTrue()](3*(Wheel.Advance(1); [Count.EqualTo(0)](BREAK)); Count.Set(1); Light.LightOn());",
        every(range(10), "Wheel.Advance(1)") | every(range(0, 10, 3), "Wheel.Advance(1) Light.LightOn()"),
        ticks=10,
    ),
    Fact(
        "BREAK leaves n* for good",
        "9*(Wheel.Advance(1); [Count.EqualTo(2)](BREAK); Count.Add(1)); Light.LightOn();",
        {**every(range(2), "Wheel.Advance(1)"), 2: "Wheel.Advance(1) Light.LightOn()"},
        ended=2,
    ),
]


@every_fact(REPEATS)
def test_repeat(fact: Fact, engine: str) -> None:
    holds(fact, engine)


@every_fact(WHILES)
def test_while(fact: Fact, engine: str) -> None:
    holds(fact, engine)


@every_fact(PASSES)
def test_passes(fact: Fact, engine: str) -> None:
    holds(fact, engine)


@every_fact(BREAKS)
def test_break(fact: Fact, engine: str) -> None:
    holds(fact, engine)
