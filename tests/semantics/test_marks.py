"""Marked actions: which branches are forced and when, and which stops are posted."""

from __future__ import annotations

from tests.semantics.facts import Fact, every_fact, holds

FORCED = [
    Fact(
        "when all branches without a mark have ended, the marked one is forced",
        "//( WAIT(1), °Flag.Set(1)°; *[Run.IsTrue()](WAIT(0)) ); Light.LightOn();",
        {6: "Light.LightOn()"},
        ended=6,
    ),
    Fact(
        "a forced branch finishes the step of this tick and is then abandoned",
        "//( WAIT(1), °Flag.Set(1)°; WAIT(1); Light.LightOn(); WAIT(1); Switch.SwitchOn(); );",
        {5: "Light.LightOn()"},
        ended=6,
    ),
    Fact(
        "all marked branches are forced together",
        "//( °Flag.Set(1)°; WAIT(4); Light.LightOn();, WAIT(1), °Run.Set(1)°; WAIT(3); Switch.SwitchOn(); );",
        ended=6,
    ),
    Fact(
        "all branches without a mark must have ended",
        "//( WAIT(1), °Flag.Set(1)°; WAIT(4); Light.LightOn();, WAIT(2) );",
        ended=11,
    ),
    Fact(
        "a marked branch that has ended forces nobody",
        "//( WAIT(2); Light.LightOn();, °Flag.Set(1)° );",
        {10: "Light.LightOn()"},
        ended=11,
    ),
    Fact(
        "a forced branch is abandoned with everything nested in it",
        "//( WAIT(1), °Flag.Set(1)°; //(*[Run.IsTrue()](Wheel.Advance(1); WAIT(1)), WAIT(2)); Light.LightOn(); );",
        {0: "Wheel.Advance(1)", 5: "Wheel.Advance(1)"},
        ended=6,
    ),
    Fact(
        "a mark is a static property: an action that is never reached marks its branch",
        "//( WAIT(1), *[Run.IsTrue()](WAIT(1)); °Wheel.Advance(1)° );",
        ended=6,
    ),
    Fact(
        "a mark deep in loops, conditionals and events marks the branch",
        "//( WAIT(1), *[Run.IsTrue()]([Button.IsPressed()](0*(<Flag.IsTrue()>(°Wheel.Advance(1)°))); WAIT(1)) );",
        ended=6,
    ),
    Fact(
        "a mark belongs to the branch of the innermost parallel",
        "//( WAIT(1), //(°Wheel.Advance(1)°; WAIT(2);, WAIT(3)) ); Light.LightOn();",
        {0: "Wheel.Advance(1)", 15: "Wheel.Stop()", 17: "Light.LightOn()"},
        ended=17,
    ),
    Fact(
        "if every branch is marked, the last that is left is forced",
        "//( °Flag.Set(1)°; WAIT(1);, °Run.Set(1)°; WAIT(4); Light.LightOn(); );",
        ended=6,
    ),
    Fact(
        "if every branch is marked and two are left, none is forced",
        "//( °Flag.Set(1)°; WAIT(1);, °Run.Set(1)°; WAIT(2);, °Flag.Set(1)°; WAIT(5); Light.LightOn(); );",
        ended=11,
    ),
    Fact(
        "if every branch is marked, two that end in one tick leave none, and the parallel is over",
        "//( °Flag.Set(1)°; WAIT(1);, °Run.Set(1)°; WAIT(1); Light.LightOn(); );",
        {5: "Light.LightOn()"},
        ended=6,
    ),
    Fact(
        "a single marked branch is not forced",
        "//( °Flag.Set(1)°; WAIT(2); Light.LightOn(); );",
        {10: "Light.LightOn()"},
        ended=11,
    ),
    Fact(
        "a missing branch is dropped before marks are counted",
        "//( °Flag.Set(1)°; WAIT(2); Light.LightOn();, );",
        {10: "Light.LightOn()"},
        ended=11,
    ),
    Fact(
        "a forced parallel can be started again",
        "2*(//( WAIT(1), °Flag.Set(1)°; WAIT(2); Light.LightOn(); ); Switch.SwitchOn(); );",
        {6: "Switch.SwitchOn()", 12: "Switch.SwitchOn()"},
        ended=12,
    ),
    Fact(
        "a branch that is forced in the tick in which it would fork takes the first steps of its branches",
        "//( WAIT(1), °Flag.Set(1)°; WAIT(1); //(Light.LightOn(); WAIT(0); Switch.SwitchOn()); );",
        {5: "Light.LightOn()"},
        ended=6,
    ),
]

STOPPED = [
    Fact(
        "a branch that drives until an event stands still afterwards",
        "//( <Button.IsPressed()>(), °Wheel.Advance(50)° );",
        {0: "Wheel.Advance(50)", 4: "Wheel.Stop()"},
        ended=5,
        given={4: {"Button": 1}},
    ),
    Fact(
        "a marked action that a forced branch had started gets its stop in the tick of the force",
        "//( WAIT(1), °Wheel.Advance(50)°; WAIT(9) );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Stop()"},
        ended=6,
    ),
    Fact(
        "the stop comes after the last step: it beats the marked action posted in that same tick",
        "//( WAIT(1), *[Run.IsTrue()](°Wheel.Advance(50)°; WAIT(1)) );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Stop()"},
        ended=6,
    ),
    Fact(
        "a parallel that is over in its first tick only posts the stop",
        "//( °Wheel.Advance(50)°, Light.LightOn() );",
        {0: "Wheel.Stop() Light.LightOn()"},
        ended=1,
    ),
    Fact(
        "a single marked branch gets its stop when it ends",
        "//( °Wheel.Advance(1)°; WAIT(1) ); Light.LightOn();",
        {0: "Wheel.Advance(1)", 5: "Wheel.Stop()", 6: "Light.LightOn()"},
        ended=6,
    ),
    Fact(
        "a marked action that was never started gets no stop",
        "//( WAIT(1), [Button.IsPressed()](°Wheel.Advance(1)°) );",
        ended=6,
    ),
    Fact(
        "each marked action gets its own stop",
        "//( WAIT(1), °Wheel.Advance(1)°; °Light.LightOn()°; °Switch.SwitchOn()° );",
        {
            0: "Wheel.Advance(1) Light.LightOn() Switch.SwitchOn()",
            5: "Wheel.Stop() Light.LightOff() Switch.SwitchOff()",
        },
        ended=6,
    ),
    Fact(
        "a marked action without a stop procedure is just abandoned",
        "//( WAIT(1), °Door.Open()°; Light.LightOn(); );",
        {0: "Door.Open()"},
        ended=6,
        given={0: {"done:Door": 0}},
    ),
    Fact(
        "a marked later action is stopped while it runs",
        "//( WAIT(1), °Motor.AbsoluteTurn(10,50)°; Light.LightOn(); );",
        {0: "Motor.AbsoluteTurn(10,50)", 5: "Motor.Stop()"},
        ended=6,
        given={0: {"done:Motor": 0}},
    ),
    Fact(
        "a marked later action that is already done gets its stop all the same",
        "//( WAIT(1), °Motor.AbsoluteTurn(10,50)°; Light.LightOn(); );",
        {0: "Motor.AbsoluteTurn(10,50)", 1: "Light.LightOn()", 5: "Motor.Stop()"},
        ended=6,
    ),
    Fact(
        "actions without a mark are not stopped",
        "//( WAIT(1), °Flag.Set(1)°; Wheel.Advance(50); WAIT(9) );",
        {0: "Wheel.Advance(50)"},
        ended=6,
    ),
    Fact(
        "outside a parallel a mark does nothing",
        "°Wheel.Advance(1)°; WAIT(1);",
        {0: "Wheel.Advance(1)"},
        ended=5,
    ),
    Fact(
        "a marked action stands still when its own parallel settles, not when an outer one does",
        "//( //(°Wheel.Advance(1)°; WAIT(1)); WAIT(1);, WAIT(4) );",
        {0: "Wheel.Advance(1)", 5: "Wheel.Stop()"},
        ended=21,
    ),
    Fact(
        "a parallel that is abandoned from outside stops its marked actions",
        "//( WAIT(1), °Flag.Set(1)°; //(°Wheel.Advance(1)°; WAIT(9);, WAIT(9)) );",
        {0: "Wheel.Advance(1)", 5: "Wheel.Stop()"},
        ended=6,
    ),
    Fact(
        "... also in a branch of it that had already ended",
        "//( WAIT(1), °Flag.Set(1)°; //(°Wheel.Advance(1)°, WAIT(9)) );",
        {0: "Wheel.Advance(1)", 5: "Wheel.Stop()"},
        ended=6,
    ),
    Fact(
        "... and two levels down, and together with those of the outer one",
        "//( WAIT(1), °Light.LightOn()°; //(°Flag.Set(1)°; //(°Wheel.Advance(1)°; WAIT(9);, WAIT(9));, WAIT(9)) );",
        {0: "Wheel.Advance(1) Light.LightOn()", 5: "Wheel.Stop() Light.LightOff()"},
        ended=6,
    ),
    Fact(
        "an inner parallel that settled before is not stopped a second time",
        "//( WAIT(2), °Flag.Set(1)°; //(°Wheel.Advance(1)°); Wheel.Advance(2); WAIT(9) );",
        {0: "Wheel.Stop()", 1: "Wheel.Advance(2)"},
        ended=11,
    ),
    Fact(
        "a parallel that is started again stops only what it started this time",
        "2*(//( WAIT(1), [Button.IsPressed()](°Wheel.Advance(1)°) ));",
        {0: "Wheel.Advance(1)", 5: "Wheel.Stop()"},
        ended=12,
        given={0: {"Button": 1}, 3: {"Button": 0}},
    ),
    Fact(
        "Reverse, Turn, LightOn and SwitchOn have stops as well",
        "//( WAIT(1), °Wheel.Reverse(5)°, °Motor.Turn(6)°, °Light.LightOn()°, °Switch.SwitchOn()° );",
        {
            0: "Motor.Turn(6) Wheel.Reverse(5) Light.LightOn() Switch.SwitchOn()",
            5: "Motor.Stop() Wheel.Stop() Light.LightOff() Switch.SwitchOff()",
        },
        ended=6,
    ),
]

GIVES_WAY = [
    Fact(
        "a stop gives way to the command of another branch in the same tick",
        "//( WAIT(1); Wheel.Reverse(20);, °Wheel.Advance(50)°; WAIT(9) );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Reverse(20)"},
        ended=6,
    ),
    Fact(
        "commands of earlier ticks do not protect",
        "//( WAIT(1); Wheel.Reverse(20); WAIT(0);, °Wheel.Advance(50)°; WAIT(9) );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Reverse(20)", 6: "Wheel.Stop()"},
        ended=7,
    ),
    Fact(
        "a command of the same branch does not protect",
        "//( WAIT(1), °Wheel.Advance(50)°; WAIT(1); Wheel.Reverse(20); WAIT(1) );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Stop()"},
        ended=6,
    ),
    Fact(
        "a command that would lose its actuator to one of the same branch does not protect",
        "//( WAIT(1); Wheel.Reverse(20);, °Wheel.Advance(50)°; WAIT(1); Wheel.Advance(60); WAIT(1) );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Stop()"},
        ended=6,
    ),
    Fact(
        "a command to another actuator does not protect",
        "//( WAIT(1); Light.LightOn();, °Wheel.Advance(50)°; WAIT(9) );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Stop() Light.LightOn()"},
        ended=6,
    ),
    Fact(
        "a command of a branch nested in the marked one is another branch's",
        "//( WAIT(1), °Wheel.Advance(50)°; //(WAIT(1); Wheel.Reverse(20); WAIT(1)) );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Reverse(20)"},
        ended=6,
    ),
    Fact(
        "two marked branches on one actuator: the one whose command wins is stopped",
        "//( WAIT(1), *[Run.IsTrue()](°Wheel.Advance(1)°; WAIT(1)), *[Run.IsTrue()](°Wheel.Reverse(2)°; WAIT(1)) );",
        {0: "Wheel.Reverse(2)", 5: "Wheel.Stop()"},
        ended=6,
    ),
    Fact(
        "a command of the thread outside comes one tick later and is not touched",
        "//( WAIT(1), °Wheel.Advance(50)° ); Wheel.Reverse(20);",
        {0: "Wheel.Advance(50)", 5: "Wheel.Stop()", 6: "Wheel.Reverse(20)"},
        ended=6,
    ),
    Fact(
        "a stop at the end of an inner parallel gives way to a branch of the outer one",
        "//( //(°Wheel.Advance(50)°; WAIT(1)), WAIT(1); Wheel.Reverse(20); );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Reverse(20)"},
        ended=7,
    ),
    Fact(
        "... whichever of the two stands first",
        "//( WAIT(1); Wheel.Reverse(20);, //(°Wheel.Advance(50)°; WAIT(1)) );",
        {0: "Wheel.Advance(50)", 5: "Wheel.Reverse(20)"},
        ended=7,
    ),
]


@every_fact(FORCED)
def test_forced(fact: Fact, engine: str) -> None:
    holds(fact, engine)


@every_fact(STOPPED)
def test_stopped(fact: Fact, engine: str) -> None:
    holds(fact, engine)


@every_fact(GIVES_WAY)
def test_gives_way(fact: Fact, engine: str) -> None:
    holds(fact, engine)
