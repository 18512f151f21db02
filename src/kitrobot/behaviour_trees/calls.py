"""Actions and conditions of a tree as calls of the robot: `<Action ID="Wheel.Advance" speed="50"/>` is
`Wheel.Advance(50)`.

An ID is a call of the robot, or the form of one that is written (`Wheel_Advance`), or the name of a method that one
part alone has, or its model says which call it is (`<Metadata kitrobot="Wheel.Advance"/>`). A port holds a whole
number, `true` or `false`, or a value or a test of the robot as LLL writes it (`Captor.Value()`).
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from kitrobot.behaviour_trees import rules
from kitrobot.behaviour_trees.model import NodeModel, TreeNode
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import MAX_NUMBER, Call, Number, Param
from kitrobot.primitives.robot import Kind, Method, Parameter, Robot, ValueType
from kitrobot.text.phrases import listed, shown
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import Suggestions

_NUMBER = re.compile(r"[+-]?[0-9]{1,9}")
_LONGEST_VALUE = 200
_TRUTHS = {"true": 1, "false": 0}


def call_ids(robot: Robot) -> dict[tuple[str, str], str]:
    """The ID that a tree is given for each call of a robot: Groot2 takes letters, digits and `_` alone."""
    ids: dict[tuple[str, str], str] = {}
    taken: set[str] = set()
    for part, method in robot.calls:
        name = f"{part}_{method}"
        while name in taken:
            name += "_"
        taken.add(name)
        ids[part, method] = name
    return ids


class CallReader:
    """Makes calls of a robot of leaves; `found` is what is wrong with them."""

    def __init__(self, robot: Robot, models: Mapping[str, NodeModel]) -> None:
        self.robot = robot
        self.models = models
        self.found: list[Diagnostic] = []
        self._suggestions = Suggestions()
        self._by_id = {name: call for call, name in call_ids(robot).items()}

    def method_of(self, node: TreeNode) -> tuple[str, Method] | None:
        """The object and the method that a leaf calls; None for none of the robot."""
        model = self.models.get(node.name)
        name = model.call if model is not None and model.call else node.name
        part, method = self._by_id.get(name) or name.partition(".")[::2]
        found = self.robot.calls.get((part, method))
        if found is not None:
            return part, found[1]
        alike = [(key[0], value[1]) for key, value in self.robot.calls.items() if key[1] == name]
        return alike[0] if len(alike) == 1 else None

    def report_unknown(self, node: TreeNode) -> None:
        """Says that a leaf is nothing of the robot."""
        known = [f"{part}.{method}" for part, method in self.robot.calls]
        help: Help = self._suggestions.did_you_mean(node.name, known) or Sentence(
            "name a part and what it does, as in {example}, or give its model {metadata}",
            f'`<Action ID="{known[0]}"/>`' if known else "`<Action/>`",
            '`<Metadata kitrobot="Part.Method"/>`',
        )
        message = Sentence("{node} is no call of the robot `{robot}`", shown(node.name), self.robot.name)
        self.found.append(rules.NODE(message, node.place, help=help))

    def read(self, node: TreeNode, *, condition: bool) -> Call | None:
        """The call of a leaf, as an action or as a condition; None where it cannot be one."""
        meant = self.method_of(node)
        if meant is None:
            self.report_unknown(node)
            return None
        part, method = meant
        if (method.kind is Kind.TEST) is not condition or method.kind is Kind.VALUE:
            role = Sentence("a condition") if condition else Sentence("an action")
            message = Sentence("`{call}` cannot be {role}", f"{part}.{method.name}", role)
            help = Sentence("an action is a procedure of the robot, and a condition is one of its tests")
            self.found.append(rules.NODE(message, node.place, help=help))
            return None
        if node.children:
            message = Sentence("`{call}` holds nodes, and a call of the robot holds none", f"{part}.{method.name}")
            self.found.append(rules.FORM(message, node.place))
        names = [one.name for one in method.parameters]
        for port in node.ports:
            if port not in names:
                message = Sentence("`{call}` has no port {port}", f"{part}.{method.name}", shown(port))
                port_help: Help = self._suggestions.did_you_mean(port, names) or (
                    Sentence("there is {known}", listed(names)) if names else ""
                )
                self.found.append(rules.NODE(message, node.places.get(port, node.place), help=port_help))
        return Call(part, method.name, [self.param(node, method, one) for one in method.parameters])

    def param(self, node: TreeNode, method: Method, parameter: Parameter) -> Param:
        """What a port holds; its model's value or the robot's where it is not given."""
        model = self.models.get(node.name)
        default = model.defaults.get(parameter.name) if model is not None else None
        text = node.ports.get(parameter.name, default)
        least, most = max(0, parameter.minimum), min(parameter.maximum, MAX_NUMBER)
        if not method.is_limited:
            least, most = 0, MAX_NUMBER
        if text is None:
            return Number(min(max(parameter.default, least), max(most, 0)))
        text = text.strip()
        if parameter.type is ValueType.BOOLEAN and text.lower() in _TRUTHS:
            return Number(_TRUTHS[text.lower()])
        if _NUMBER.fullmatch(text):
            if least <= int(text) <= most:
                return Number(int(text))
        elif "." in text and (called := _called(text)) is not None:
            return called
        expected = Sentence("a whole number from {least} to {most}", least, most)
        message = Sentence("expected {expected} in {attribute}, found {found}", expected, parameter.name, shown(text))
        self.found.append(rules.NODE(message, node.places.get(parameter.name, node.place)))
        return Number(least)


def _called(text: str) -> Call | None:
    """A value or a test of the robot as LLL writes it; None for anything else."""
    if len(text) > _LONGEST_VALUE:
        return None
    parsed = parse(f"{text};")
    (node,) = parsed.program.items if len(parsed.program.items) == 1 else (None,)
    if not isinstance(node, Call) or not parsed.ok or not node.object:
        return None
    return Call(node.object, node.method, node.params)
