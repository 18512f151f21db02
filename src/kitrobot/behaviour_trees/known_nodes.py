"""The nodes of a tree that a program can say, with the role of each leaf; all others are reported."""

from __future__ import annotations

from dataclasses import replace

from kitrobot.behaviour_trees import refusals, rules
from kitrobot.behaviour_trees.calls import CallReader
from kitrobot.behaviour_trees.model import LOOPS, PARALLELS, TreeNode, is_condition
from kitrobot.behaviour_trees.tree_xml import child_count_message
from kitrobot.diagnostics.model import Rule
from kitrobot.primitives.robot import Kind
from kitrobot.text.sentences import Help, Sentence

_NOTHING = TreeNode("AlwaysSuccess")


class KnownNodes:
    """Looks nodes through for a robot; what it finds goes to the mistakes of the reader of calls."""

    def __init__(self, calls: CallReader) -> None:
        self.calls = calls

    def refuse(self, node: TreeNode, message: Sentence, help: Help = "", rule: Rule = rules.MEANING) -> None:
        self.calls.found.append(rule(message, node.place, help=help))

    def node(self, node: TreeNode) -> TreeNode:
        """The node with the role of each leaf; nodes that no program can say are reported."""
        refusal = refusals.REFUSED.get(node.name)
        if refusal is not None:
            self.refuse(node, Sentence("<{node}> {reason}", node.name, refusal.reason), refusal.help)
            return _NOTHING
        if node.name not in refusals.CHILDREN:
            meant = self.calls.method_of(node)
            if meant is None:
                self.calls.report_unknown(node)
                return _NOTHING
            return replace(node, role=node.role or ("Condition" if meant[1].kind is Kind.TEST else "Action"))
        least, most = refusals.CHILDREN[node.name]
        count = len(node.children)
        if count < least or (most is not None and count > most):
            expected = least if least == most else f"{least}–{most}" if most is not None else f"≥ {least}"
            self.refuse(node, child_count_message(node.name, count, expected), rule=rules.FORM)
            return _NOTHING
        made = replace(node, children=tuple(self.node(child) for child in node.children))
        if node.name.startswith("Reactive") and any(_takes_time(child, self.calls) for child in made.children):
            reason = refusals.INTERRUPTION
            self.refuse(node, Sentence("<{node}> {reason}", node.name, reason.reason), reason.help)
        if node.name == "Inverter" and not is_condition(made.children[0]):
            self.refuse(
                node,
                Sentence("<Inverter> turns the answer of a condition round, and there is an action in it"),
                refusals.ASK_FIRST,
            )
        return made


def _takes_time(node: TreeNode, calls: CallReader) -> bool:
    """Whether a node may be RUNNING, so that a reactive node would ask again meanwhile."""
    if node.name in (*LOOPS, *PARALLELS, "Sleep", "Delay", "RetryUntilSuccessful"):
        return True
    if node.role == "Action":
        meant = calls.method_of(node)
        return meant is not None and meant[1].completes_later
    return any(_takes_time(child, calls) for child in node.children)
