"""The one tree that a file of several trees means: each `<SubTree>` is replaced by what its tree holds.

A port of a subtree that is given a value (`<SubTree ID="Turn" angle="90"/>`) stands for `{angle}` inside. Every other
`{…}` is read from the blackboard, which programs do not have.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from kitrobot.behaviour_trees import rules
from kitrobot.behaviour_trees.model import TreeFile, TreeNode
from kitrobot.behaviour_trees.tree_xml import MAX_NODES
from kitrobot.diagnostics.model import Diagnostic, Place, Rule
from kitrobot.lll.tree import MAX_NESTING
from kitrobot.text.phrases import listed, shown
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import nearest

BLACKBOARD_HELP = Sentence("use a variable of the robot, such as {example}", "`Count.Set`, `Count.EqualTo`")
_READ = re.compile(r"\{\s*@?([^{}]*?)\s*\}")
_EMPTY = TreeNode("AlwaysSuccess")


class _EndError(Exception):
    """The tree is too large to go on."""


def expand_subtrees(file: TreeFile) -> tuple[TreeNode, list[Diagnostic]]:
    """The tree of a file without subtrees, and what forbids it."""
    expansion = _Expansion(file)
    try:
        root = expansion.node(file.trees[file.main], {}, (file.main,), 1)
    except _EndError:
        root = _EMPTY
    return root, expansion.found


class _Expansion:
    def __init__(self, file: TreeFile) -> None:
        self.file = file
        self.found: list[Diagnostic] = []
        self.count = 0

    def report(self, rule: Rule, message: Sentence, place: Place | None, help: Help = "") -> None:
        self.found.append(rule(message, place, help=help))

    def node(self, node: TreeNode, values: Mapping[str, str], inside: tuple[str, ...], depth: int) -> TreeNode:
        self.count += 1
        if self.count > MAX_NODES or depth > MAX_NESTING:
            self.found.clear()
            message = (
                Sentence("expected at most {most} nodes, found one more", MAX_NODES)
                if self.count > MAX_NODES
                else Sentence("expected at most {most} nodes inside one another, found one more", MAX_NESTING)
            )
            self.report(rules.SIZE, message, node.place, Sentence("make two trees of it, and two programs"))
            raise _EndError
        ports = {name: self.value(node, name, text, values) for name, text in node.ports.items()}
        ports = {name: text for name, text in ports.items() if not self.is_script(node, name, text)}
        if node.name == "SubTree":
            return self.subtree(node, ports, inside, depth)
        children = tuple(self.node(child, values, inside, depth + 1) for child in node.children)
        return replace(node, ports=ports, children=children)

    def subtree(self, node: TreeNode, ports: dict[str, str], inside: tuple[str, ...], depth: int) -> TreeNode:
        name = ports.pop("ID", "")
        place = node.places.get("ID", node.place)
        tree = self.file.trees.get(name)
        if tree is None:
            near = nearest(name, self.file.trees)
            help = (
                Sentence("did you mean {near}?", near)
                if near
                else Sentence("there is {known}", listed(self.file.trees))
            )
            self.report(rules.FORM, Sentence("there is no tree {tree} in the file", shown(name)), place, help)
        elif name in inside:
            help = Sentence("use a <Repeat>: a tree cannot hold itself")
            self.report(rules.MEANING, Sentence("the tree {tree} is inside itself", shown(name)), place, help)
        else:
            return self.node(tree, ports, (*inside, name), depth + 1)
        return _EMPTY

    def value(self, node: TreeNode, port: str, text: str, values: Mapping[str, str]) -> str:
        """A port's value, in which what the subtree was given stands in its place."""
        read = _READ.fullmatch(text.strip())
        if read is None:
            return text
        name = read[1] if read[1] != "=" else port
        if name not in values:
            message = Sentence(
                "{port} of <{node}> is read from the blackboard, and a program has none", port, node.name
            )
            self.report(rules.MEANING, message, node.places.get(port, node.place), BLACKBOARD_HELP)
        return values.get(name, "")

    def is_script(self, node: TreeNode, port: str, text: str) -> bool:
        """Whether a port is a condition or a script around a node (`_skipIf`, `_onSuccess`), which is reported."""
        if not port.startswith("_"):
            return False
        if port != "_autoremap" or text not in ("false", "0", ""):
            message = Sentence("{port} on <{node}> is a script, and a program has none", port, node.name)
            help = Sentence("put a <Condition> of the robot before the node, in a <Sequence>")
            self.report(rules.MEANING, message, node.places.get(port, node.place), help)
        return True
