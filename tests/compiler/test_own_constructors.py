"""Constructors from XML of one's own: templates of any size are filled from a vertex."""

from __future__ import annotations

import pytest

from kitrobot.lll.parse_results import parse
from tests.compiler.graphs import graph, text_of, told, with_constructors

BLINK = """
<constructor name="Blink">
  <number name="times" min="1" max="9" default="3"/>
  <number name="pause" default="5"/>
  <code>{times}*(Light.LightOn(); WAIT({pause}); Light.LightOff(); WAIT({pause}))</code>
</constructor>
"""


def test_a_template_larger_than_one_construct_is_filled() -> None:
    program = graph("start > v1:Blink times=4 pause=2 > v2:Blink > stop")
    text = """\
4*(
  Light.LightOn();
  WAIT(2);
  Light.LightOff();
  WAIT(2);
);
3*(
  Light.LightOn();
  WAIT(5);
  Light.LightOff();
  WAIT(5);
);
"""
    assert text_of(program, with_constructors(BLINK)) == text


def test_a_number_outside_its_slot_s_own_range_is_told() -> None:
    catalogue = with_constructors(BLINK)
    assert told(graph("start > v1:Blink times=9 > stop"), catalogue) == []
    assert told(graph("start > v1:Blink times=10 > stop"), catalogue) == [("not-a-number", ("v1",))]
    assert told(graph("start > v1:Blink times=0 > stop"), catalogue) == [("not-a-number", ("v1",))]


OWN = [
    (
        "several instructions",
        '<constructor name="Own"><number name="n"/><code>Door.Open(); WAIT({n}); Door.Close();</code></constructor>',
        ["start > v1:Own n=3 > v2:Wheel.Stop > stop"],
        "Door.Open(); WAIT(3); Door.Close(); Wheel.Stop();",
    ),
    (
        "a body and what follows it",
        '<constructor name="Own"><number name="n"/><flow name="body"/>'
        "<code>*[Run.IsTrue()]({body}; WAIT({n}))</code></constructor>",
        ["start > v1:Own n=3 > stop", "v1.body > v2:Wheel.Stop > v3:Door.Open > v1.return"],
        "*[Run.IsTrue()]( Wheel.Stop(); Door.Open(); WAIT(3); );",
    ),
    (
        "a body and what stands before it",
        '<constructor name="Own"><flow name="body"/><code>2*(Wheel.Stop(); {body})</code></constructor>',
        ["start > v1:Own > stop", "v1.body > v2:Door.Open > v1.return"],
        "2*( Wheel.Stop(); Door.Open(); );",
    ),
    (
        "a body with nothing around it but instructions",
        '<constructor name="Own"><flow name="body"/><code>Door.Open(); {body}; Door.Close();</code></constructor>',
        ["start > v1:Own > stop", "v1.body > v2:Wheel.Stop > v1.return"],
        "Door.Open(); Wheel.Stop(); Door.Close();",
    ),
    (
        "a repeated body and what follows it in each branch",
        '<constructor name="Own"><flow name="b" repeat="yes" least="2"/><code>//({b}; WAIT(1))</code></constructor>',
        ["start > v1:Own > stop", "v1.b.1 > v2:Wheel.Stop > v1.return", "v1.b.2 > v3:Door.Open > v1.return"],
        "//( Wheel.Stop(); WAIT(1);, Door.Open(); WAIT(1); );",
    ),
    (
        "two bodies as branches",
        '<constructor name="Own"><flow name="a"/><flow name="b"/><code>//({a}, {b}, WAIT(9))</code></constructor>',
        ["start > v1:Own > stop", "v1.a > v2:Wheel.Stop > v1.return", "v1.b > v3:Door.Open > v1.return"],
        "//( Wheel.Stop();, Door.Open();, WAIT(9); );",
    ),
    (
        "numbers as parameters",
        '<constructor name="Own"><number name="a" default="25"/><number name="s" default="9"/>'
        "<code>Motor.AbsoluteTurn({a}, {s})</code></constructor>",
        ["start > v1:Own a=50 > stop"],
        "Motor.AbsoluteTurn(50, 9);",
    ),
    (
        "a value typed in",
        '<constructor name="Own"><value name="s" default="9"/><code>Wheel.Advance({s})</code></constructor>',
        ["start > v1:Own s=8 > stop"],
        "Wheel.Advance(8);",
    ),
    (
        "a value that is read",
        '<constructor name="Own"><value name="s" default="9"/><code>Wheel.Advance({s})</code></constructor>',
        ["start > v1:Own s=8 > stop", "v2:Captor.Value > v1.s"],
        "Wheel.Advance(Captor.Value());",
    ),
    (
        "a condition among tests",
        '<constructor name="Own"><condition name="c"/><flow name="body"/>'
        "<code>[Run.IsTrue() &amp; ({c} | Fault.IsRaised())]({body})!(BREAK)</code></constructor>",
        ["start > v1:Own > stop", "v2:Flag.IsTrue > v1.c", "v1.body > v1.return"],
        "[Run.IsTrue() & (Flag.IsTrue() | Fault.IsRaised())]()!( BREAK; );",
    ),
    (
        "a condition of one's own",
        '<constructor name="Own"><condition name="a"/><condition name="b"/>'
        "<code>({a} | {b}) &amp; !({a2})</code></constructor>".replace("{a2}", "Flag.IsTrue()"),
        [
            "start > v1:When > stop",
            "v1.body > v1.return",
            "v2:Own > v1.condition",
            "v3:Run.IsTrue > v2.a",
            "v4:Button.IsPressed > v2.b",
        ],
        "<(Run.IsTrue() | Button.IsPressed()) & !(Flag.IsTrue())>();",
    ),
    (
        "a marked action of one's own",
        '<constructor name="Own"><action name="a"/><flow name="until"/><code>//({until}, °{a}°)</code></constructor>',
        ["start > v1:Own > stop", "v2:Wheel.Advance > v1.a", "v1.until > v3:Door.Open > v1.return"],
        "//( Door.Open();, °Wheel.Advance(50)°; );",
    ),
]


@pytest.mark.parametrize(("xml", "lines", "text"), [row[1:] for row in OWN], ids=[row[0] for row in OWN])
def test_a_constructor_of_one_s_own_is_filled(xml: str, lines: list[str], text: str) -> None:
    made = text_of(graph(*lines), with_constructors(xml))
    assert " ".join(made.split()) == text
    assert parse(made).diagnostics == []
