"""All constructors of the paper and every method of every object of its robot go graph → LLL → image → run."""

from __future__ import annotations

from functools import cache

import pytest

from kitrobot.compiler.compilation import compile_program
from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.graph.model import Program
from kitrobot.image.machine import Machine
from kitrobot.image.model import Image
from kitrobot.lll.printer import print_program
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.constructors import Role
from kitrobot.primitives.robot import Category, Kind
from tests.forms.drawing import draw

PAPER = {
    "Repetition",
    "While",
    "If Then",
    "If Then Else",
    "Wait",
    "Break",
    "And",
    "Or",
    "No",
    "Parallelism",
    "Branch",
    "Interrupt",
}

ALL_CONSTRUCTORS = draw(
    "mini-robot",
    {
        "thrice": "Repetition count=3",
        "turn": "Motor.Turn speed=10",
        "loop": "While",
        "running": "Run.IsTrue",
        "leave": "If Then",
        "both": "And",
        "two": "Count.EqualTo value=2",
        "not": "No",
        "pressed": "Button.IsPressed",
        "break": "Break",
        "count": "Count.Add value=1",
        "wait": "Wait duration=1",
        "choice": "If Then Else",
        "either": "Or",
        "near": "Captor.LessThan value=10",
        "pressed2": "Button.IsPressed",
        "open": "Door.Open",
        "close": "Door.Close",
        # branch.3 is what dropping a Branch on the Parallelism adds.
        "together": "Parallelism",
        "when": "When",
        "pressed3": "Button.IsPressed",
        "light": "Light.LightOn",
        "mark": "Interrupt",
        "drive": "Wheel.Advance",
        "level": "Level.Value",
        "switch": "Switch.SwitchOn",
        "back": "Wheel.Reverse speed=5",
    },
    """
    start>thrice  thrice.body>turn  turn>thrice@return
    thrice>loop  running>loop@condition
    loop.body>leave  both>leave@condition  two>both@left  not>both@right  pressed>not@condition
    leave.then>break  break>leave@return
    leave>count  count>wait  wait>loop@return
    loop>choice  either>choice@condition  near>either@left  pressed2>either@right
    choice.then>open  open>choice@return  choice.else>close  close>choice@return
    choice>together
    together.branch.1>when  pressed3>when@condition  when.body>light  light>when@return  when>together@return
    together.branch.2>mark  drive>mark@action  level>drive@speed  mark>together@return
    together.branch.3>switch  switch>together@return
    together>back  back>stop
    """,
)

ALL_CONSTRUCTORS_AS_LLL = """\
3*(Motor.Turn(10););
*[Run.IsTrue()](
  [Count.EqualTo(2) & !(Button.IsPressed())](BREAK;);
  Count.Add(1);
  WAIT(1);
);
[Captor.LessThan(10) | Button.IsPressed()](
  Door.Open();
)!(
  Door.Close();
);
//(
  <Button.IsPressed()>(Light.LightOn(););,
  °Wheel.Advance(Level.Value())°;,
  Switch.SwitchOn();
);
Wheel.Reverse(5);
"""


@cache
def catalogue() -> Catalogue:
    return load_catalogue()


def machine_of(program: Program) -> Machine:
    """Graph → LLL → three-address code → image → bytes → image → machine, with not even a hint on the way."""
    compiled = compile_program(program, catalogue())
    assert [item.message for item in compiled.diagnostics] == []
    assert compiled.image is not None
    return Machine(Image.from_bytes(compiled.image.to_bytes()), catalogue().robots[program.target])


def run(machine: Machine, ticks: int, given: dict[int, dict[str, int]]) -> dict[int, str]:
    seen = {}
    for tick in range(ticks):
        for sensor, value in given.get(tick, {}).items():
            machine.set_input(sensor, value)
        commands = [
            f"{command.actuator}.{command.procedure}({','.join(map(str, command.arguments))})"
            for command in machine.tick()
        ]
        if commands:
            seen[tick] = " ".join(commands)
    return seen


def words(text: str) -> str:
    return "".join(text.split())


def test_all_constructors_become_lll() -> None:
    translation = graph_to_lll(ALL_CONSTRUCTORS, catalogue())
    assert translation.diagnostics == []
    assert words(print_program(translation.program)) == words(ALL_CONSTRUCTORS_AS_LLL)


def test_all_constructors_run() -> None:
    machine = machine_of(ALL_CONSTRUCTORS)
    assert run(machine, 22, {0: {"Captor": 50}, 20: {"Button": 1}}) == {
        0: "Motor.Turn(10)",
        1: "Motor.Turn(10)",
        2: "Motor.Turn(10)",
        12: "Door.Close()",
        13: "Wheel.Advance(50) Switch.SwitchOn()",
        20: "Wheel.Stop() Light.LightOn()",
        21: "Wheel.Reverse(5)",
    }
    assert machine.variables()["Count"] == 2
    assert machine.ended


def test_the_drawing_above_holds_every_constructor_of_the_paper() -> None:
    used = {vertex.element for vertex in ALL_CONSTRUCTORS.vertices}
    for name in PAPER:
        constructor = catalogue().constructors[name]
        if constructor.role is Role.BRANCH:
            assert constructor.adds == ("Parallelism", "branch")
        else:
            assert name in used


# ---- every method of every object -----------------------------------------------------------------------

ROBOT = "mini-robot"
METHODS = [
    pytest.param(part.category, part.name, method.name, id=f"{part.category.value} {part.name}.{method.name}")
    for part in load_catalogue().robots[ROBOT].objects
    for method in part.methods
]


@pytest.mark.parametrize(("category", "name", "method_name"), METHODS)
def test_every_method_runs(category: Category, name: str, method_name: str) -> None:
    part, method = catalogue().robots[ROBOT].calls[name, method_name]
    assert part.category is category
    element = f"{name}.{method_name}"
    # 1, 2, …, so that no two parameters could be taken for one another; a boolean takes 1 only.
    numbers = [min(number, given.maximum) for number, given in enumerate(method.parameters, 1)]
    settings = "".join(f" {given.name}={number}" for given, number in zip(method.parameters, numbers, strict=True))
    if method.kind is Kind.PROCEDURE:
        machine = machine_of(draw(ROBOT, {"it": element + settings}, "start>it it>stop"))
        before = machine.variables()
        seen = run(machine, 2, {})
        if category is Category.ACTUATOR:
            assert seen == {0: f"{element}({','.join(map(str, numbers))})"}
        else:
            assert seen == {}
            expected = {"set": 1, "add": before.get(name, 0) + 1, "sub": max(0, before.get(name, 0) - 1), "clear": 0}
            assert machine.variables().get(name, 0) == expected[method.action]
        assert machine.ended
    elif method.kind is Kind.VALUE:
        drawing = draw(ROBOT, {"it": element, "turn": "Motor.Turn"}, "start>turn turn>stop it>turn@speed")
        machine = machine_of(drawing)
        given = 42 if category is Category.SENSOR else machine.variables()[name]
        assert run(machine, 2, {0: {name: 42}} if category is Category.SENSOR else {}) == {0: f"Motor.Turn({given})"}
    else:
        other = method.to if method.to is not None else numbers[0]
        for current in range(part.minimum, min(part.maximum, 4) + 1):
            drawing = draw(
                ROBOT,
                {"if": "If Then Else", "it": element + settings, "yes": "Light.LightOn", "no": "Light.LightOff"},
                "start>if it>if@condition if.then>yes yes>if@return if.else>no no>if@return if>stop",
            )
            machine = machine_of(drawing)
            if category is Category.SENSOR:
                machine.set_input(name, current)
            elif category is Category.VARIABLE:
                machine.set_variable(name, current)
            else:
                current = 0
            holds = {"equal": current == other, "less": current < other, "greater": current > other}[method.test]
            assert run(machine, 1, {}) == {0: "Light.LightOn()" if holds else "Light.LightOff()"}, current
