"""Procedures, the order of commands, and `done`."""

from __future__ import annotations

from tests.semantics.facts import Fact, every_fact, holds

FACTS = [
    Fact("the empty program ends in its first tick", "", ended=0),
    Fact(
        "after a now procedure the thread goes on in the same tick",
        "Wheel.Advance(50); Switch.SwitchOn();",
        {0: "Wheel.Advance(50) Switch.SwitchOn()"},
        ended=0,
    ),
    Fact(
        "the effect of a procedure stays, nothing is sent again",
        "Wheel.Advance(50); WAIT(2);",
        {0: "Wheel.Advance(50)"},
        ended=10,
    ),
    Fact(
        "commands are handed out in the order of the actuators in the robot's file",
        "Switch.SwitchOn(); Light.LightOn(); Wheel.Advance(1);",
        {0: "Wheel.Advance(1) Light.LightOn() Switch.SwitchOn()"},
        ended=0,
    ),
    Fact(
        "of two commands to one actuator in one tick the last wins",
        "Wheel.Advance(50); Wheel.Reverse(20);",
        {0: "Wheel.Reverse(20)"},
        ended=0,
    ),
    Fact(
        "between two branches the last is the one with the higher slot",
        "//(Wheel.Advance(1), Wheel.Advance(2));",
        {0: "Wheel.Advance(2)"},
        ended=1,
    ),
    Fact(
        "a later procedure is posted at once and its done is looked at from the next tick on",
        "Door.Open(); Light.LightOn();",
        {0: "Door.Open()", 1: "Light.LightOn()"},
        ended=1,
    ),
    Fact(
        "a later procedure blocks the thread, which goes on in the tick that sees done",
        "Door.Open(); Light.LightOn();",
        {0: "Door.Open()", 4: "Light.LightOn()"},
        ended=4,
        given={1: {"done:Door": 0}, 4: {"done:Door": 1}},
    ),
    Fact(
        "a done that is already low when the command is posted is waited for all the same",
        "Door.Open(); Light.LightOn();",
        {0: "Door.Open()", 3: "Light.LightOn()"},
        ended=3,
        given={0: {"done:Door": 0}, 3: {"done:Door": 1}},
    ),
    Fact(
        "done belongs to the actuator: two threads that wait for it go on together",
        "//(Motor.AbsoluteTurn(10,50); Wheel.Advance(1);, Motor.AbsoluteTurn(20,50); Light.LightOn(););",
        {0: "Motor.AbsoluteTurn(20,50)", 3: "Wheel.Advance(1) Light.LightOn()"},
        ended=4,
        given={0: {"done:Motor": 0}, 3: {"done:Motor": 1}},
    ),
    Fact(
        "the done of another actuator releases nobody",
        "Motor.AbsoluteTurn(1,1); Light.LightOn();",
        {0: "Motor.AbsoluteTurn(1,1)", 5: "Light.LightOn()"},
        ended=5,
        given={0: {"done:Motor": 0, "done:Door": 0}, 2: {"done:Door": 1}, 5: {"done:Motor": 1}},
    ),
    Fact(
        "a now procedure of an actuator does not wait for its done",
        "Motor.Turn(5); Light.LightOn();",
        {0: "Motor.Turn(5) Light.LightOn()"},
        ended=0,
        given={0: {"done:Motor": 0}},
    ),
    Fact(
        "a thread whose command lost its actuator to another waits for done as well",
        "//(Door.Open(); Light.LightOn();, Door.Close(););",
        {0: "Door.Close()", 2: "Light.LightOn()"},
        ended=3,
        given={0: {"done:Door": 0}, 2: {"done:Door": 1}},
    ),
    Fact(
        "a value or a test used as an instruction does nothing and costs nothing",
        "Captor.Value(); Button.IsPressed(); Light.LightOn();",
        {0: "Light.LightOn()"},
        ended=0,
    ),
    Fact(
        "a later procedure in every tick: posted, done, posted again",
        "3*(Door.Open());",
        {0: "Door.Open()", 1: "Door.Open()", 2: "Door.Open()"},
        ended=3,
    ),
    Fact(
        "an actuator and a sensor may share a name",
        "[Light.IsRed()](Light.LightOn())!(Light.LightOff());",
        {0: "Light.LightOn()"},
        ended=0,
        given={0: {"Light": 1}},
    ),
    Fact(
        "WAIT goes on after whole units",
        "WAIT(2); Light.LightOn();",
        {10: "Light.LightOn()"},
        ended=10,
    ),
    Fact("WAIT(0) is one tick", "WAIT(0); Light.LightOn();", {1: "Light.LightOn()"}, ended=1),
    Fact("two waits add up", "WAIT(1); WAIT(0); WAIT(1); Light.LightOn();", {11: "Light.LightOn()"}, ended=11),
]


@every_fact(FACTS)
def test_action(fact: Fact, engine: str) -> None:
    holds(fact, engine)
