"""A program of ours as a Blockly workspace: the same instructions and tests, one block for each vertex.

Loops, choices, `and`, `or`, `not` and BREAK are Blockly's own blocks; every method of the robot is a block of its own,
with its numbers in fields, as in a Blockly for robots. Stacks are short and side by side: in one long stack each block
would lie inside the JSON of the one before it.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from kitrobot.lll.tree import (
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Not,
    Number,
    Or,
    Repeat,
    Seq,
    Wait,
    While,
)
from kitrobot.primitives.robot import Robot

_STACK = 20
_STATEMENT = {"previousStatement": None, "nextStatement": None}
_OWN = (
    {
        "type": "kit_wait",
        "message0": "wait %1",
        "args0": [{"type": "field_number", "name": "duration"}],
        **_STATEMENT,
    },
    {
        "type": "kit_when",
        "message0": "when %1 %2",
        "args0": [
            {"type": "input_value", "name": "CONDITION", "check": "Boolean"},
            {"type": "input_statement", "name": "DO"},
        ],
        **_STATEMENT,
    },
)

Block = dict[str, Any]


def definitions(robot: Robot, program: Seq) -> list[Block]:
    """The blocks that the workspace of a program needs besides Blockly's own; `call` is what they generate."""
    made: dict[str, Block] = {}
    for call in _calls(program.items):
        part, method = robot.calls[call.object, call.method]
        arguments = [
            {"type": "field_number" if isinstance(given, Number) else "input_value", "name": parameter.name}
            for given, parameter in zip(call.params, method.parameters, strict=True)
        ]
        name = f"{part.name}.{method.name}"
        words = " ".join([name, *(f"%{number}" for number in range(1, len(arguments) + 1))])
        shape = _STATEMENT if method.kind.value == "procedure" else {"output": None}
        made[name] = {"type": name, "call": name, "message0": words, "args0": arguments, **shape}
    return [*made.values(), *({**block, "call": block["type"]} for block in _OWN)]


def workspace(program: Seq, robot: Robot) -> tuple[Block, int]:
    """The state of a workspace, as Blockly saves one, and how many blocks it has."""
    drawing = _Drawing(robot)
    stacks = (Seq(program.items[at : at + _STACK]) for at in range(0, len(program.items), _STACK))
    blocks = [block for block in map(drawing.stack, stacks) if block is not None]
    return {"blocks": {"languageVersion": 0, "blocks": blocks}}, drawing.count


def _calls(items: Iterable[Any]) -> Iterable[Call]:
    for node in items:
        if isinstance(node, Call):
            yield node
            yield from _calls(node.params)
        else:
            inner = [getattr(node, name, None) for name in ("condition", "left", "right", "body", "then", "orelse")]
            for part in inner:
                yield from _calls(part.items if isinstance(part, Seq) else [part] if part is not None else [])


class _Drawing:
    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.count = 0

    def block(self, type: str, fields: Block | None = None, inputs: Block | None = None) -> Block:
        self.count += 1
        filled = {name: {"block": block} for name, block in (inputs or {}).items() if block is not None}
        return {"type": type, "id": f"b{self.count}", "fields": fields or {}, "inputs": filled}

    def stack(self, seq: Seq) -> Block | None:
        first: Block | None = None
        for node in reversed(seq.items):
            block = self.instruction(node)
            if first is not None:
                block["next"] = {"block": first}
            first = block
        return first

    def instruction(self, node: Instr) -> Block:
        match node:
            case Call():
                return self.call(node)
            case Wait():
                return self.block("kit_wait", {"duration": node.duration})
            case Break():
                return self.block("controls_flow_statements", {"FLOW": "BREAK"})
            case Repeat():
                return self.block("controls_repeat", {"TIMES": node.count}, {"DO": self.stack(node.body)})
            case While():
                if node.condition is None:
                    test = self.block("logic_boolean", {"BOOL": "TRUE"})
                else:
                    test = self.condition(node.condition)
                inputs = {"BOOL": test, "DO": self.stack(node.body)}
                return self.block("controls_whileUntil", {"MODE": "WHILE"}, inputs)
            case Event():
                inputs = {"CONDITION": self.condition(node.condition), "DO": self.stack(node.body)}
                return self.block("kit_when", None, inputs)
            case Conditional():
                inputs = {"IF0": self.condition(node.condition), "DO0": self.stack(node.then)}
                if node.orelse is None:
                    return self.block("controls_if", None, inputs)
                return self.block("controls_ifelse", None, inputs | {"ELSE": self.stack(node.orelse)})
            case _:
                raise ValueError(f"Blockly has no block for {type(node).__name__}")

    def condition(self, node: Condition) -> Block:
        match node:
            case And() | Or():
                inputs = {"A": self.condition(node.left), "B": self.condition(node.right)}
                return self.block("logic_operation", {"OP": "AND" if isinstance(node, And) else "OR"}, inputs)
            case Not():
                return self.block("logic_negate", None, {"BOOL": self.condition(node.condition)})
            case Call():
                return self.call(node)
            case _:
                raise ValueError(f"Blockly has no block for {type(node).__name__}")

    def call(self, call: Call) -> Block:
        part, method = self.robot.calls[call.object, call.method]
        fields: Block = {}
        inputs: Block = {}
        for given, parameter in zip(call.params, method.parameters, strict=True):
            if isinstance(given, Number):
                fields[parameter.name] = given.value
            elif isinstance(given, Call):
                inputs[parameter.name] = self.call(given)
        return self.block(f"{part.name}.{method.name}", fields, inputs)
