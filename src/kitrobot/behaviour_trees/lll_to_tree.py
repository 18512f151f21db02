"""A program's LLL as a behaviour tree that means the same; `tree_to_lll` gives back a program of the same image.

A `BREAK` is a node that fails, so the loops that it leaves stand in `<ForceSuccess>`. What has no counterpart is
reported at its vertex or its place in the text.
"""

from __future__ import annotations

from collections.abc import Sequence

from kitrobot.behaviour_trees import rules
from kitrobot.behaviour_trees.calls import call_ids
from kitrobot.behaviour_trees.model import COUNTS, FOREVER, TreeNode, may_fail
from kitrobot.diagnostics.model import Diagnostic, Source
from kitrobot.lll.printer import print_template
from kitrobot.lll.tree import (
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Interrupt,
    Node,
    Not,
    Or,
    Parallel,
    Repeat,
    Seq,
    Wait,
    While,
)
from kitrobot.primitives.robot import Kind, Robot
from kitrobot.text.sentences import Help, Sentence

MAX_TREE_DEPTH = 60
"""Nodes inside one another, at most: what the reader of XML takes, without the elements around a tree."""


def lll_to_tree(program: Seq, robot: Robot, source: Source, name: str = "") -> tuple[TreeNode, list[Diagnostic]]:
    """The tree of a program for a robot, and what cannot be said in one. `source`: the text of its places; `name`: the
    program's, for the diagnostics.
    """
    translation = _Translation(robot, source, name)
    root = translation.body(program, in_loop=False)
    if not translation.found and _depth(root) > MAX_TREE_DEPTH:
        message = Sentence("expected at most {most} nodes inside one another, found one more", MAX_TREE_DEPTH)
        help = Sentence("make two trees of it, and two programs")
        translation.found.append(rules.SIZE(message, source.place(0, 0), help=help, program=name))
    return root, translation.found


class _Translation:
    def __init__(self, robot: Robot, source: Source, name: str) -> None:
        self.robot = robot
        self.source = source
        self.name = name
        self.ids = call_ids(robot)
        self.found: list[Diagnostic] = []

    def refuse(self, node: Node, message: Sentence, help: Help = "") -> list[TreeNode]:
        place = self.source.place(node.start, node.end)
        vertices = (node.vertex,) if node.vertex else ()
        self.found.append(rules.PROGRAM(message, place, help=help, program=self.name, vertices=vertices))
        return []

    # -- instructions

    def body(self, seq: Seq, *, in_loop: bool) -> TreeNode:
        return _sequence(self.nodes(seq, in_loop=in_loop))

    def nodes(self, seq: Seq, *, in_loop: bool, bare: bool = False) -> list[TreeNode]:
        """The nodes of a body. `bare`: its first one may be a condition, which ends the loop around it."""
        made: list[TreeNode] = []
        for node in seq.items:
            made += self.instruction(node, in_loop, bare or bool(made))
        return made

    def instruction(self, node: Instr, in_loop: bool, bare: bool) -> list[TreeNode]:
        match node:
            case Call():
                return self.action(node)
            case Wait(duration=int(duration)):
                return [TreeNode("Sleep", {"msec": str(duration * self.robot.wait_unit_ms)})]
            case Repeat(count=int(count)):
                inside = _sequence(self.nodes(node.body, in_loop=True, bare=True))
                return [_caught(TreeNode("Repeat", {COUNTS["Repeat"]: str(count)}, (inside,)))]
            case While():
                asked = [self.condition(node.condition)] if node.condition is not None else []
                inside = _sequence([*asked, *self.nodes(node.body, in_loop=True)])
                return [_caught(TreeNode("Repeat", {COUNTS["Repeat"]: FOREVER}, (inside,)))]
            case Conditional():
                return [self.conditional(node, in_loop, bare)]
            case Event():
                return self.event(node, in_loop)
            case Parallel() if node.branches:
                branches = tuple(self.body(branch, in_loop=False) for branch in node.branches)
                return [TreeNode("Parallel", {"failure_count": "1", "success_count": FOREVER}, branches)]
            case Parallel():
                return [TreeNode("Sleep", {"msec": "0"})]  # without branches it costs a tick, as WAIT(0) does
            case Break() if in_loop:
                return [TreeNode("AlwaysFailure")]
            case Break():
                message = Sentence("`{code}` outside a loop cannot be said in a behaviour tree", "BREAK")
                return self.refuse(node, message, Sentence("let a condition decide what is done behind it"))
            case Interrupt():
                message = Sentence("a marked action cannot be said in a behaviour tree")
                help = Sentence("take the ° away, and stop the action at its end")
                return self.refuse(node, message, help)
        return self.refuse(node, Sentence("this cannot be said in a behaviour tree"))

    def action(self, call: Call) -> list[TreeNode]:
        meant = self.robot.calls.get((call.object, call.method))
        if meant is not None and meant[1].kind is not Kind.PROCEDURE:
            name = f"{call.object}.{call.method}"
            message = Sentence("`{call}` as an instruction cannot be said in a behaviour tree", name)
            return self.refuse(call, message, Sentence("take it away: it does nothing"))
        return [self.leaf(call, "Action")]

    def leaf(self, call: Call, role: str) -> TreeNode:
        meant = self.robot.calls.get((call.object, call.method))
        names = [one.name for one in meant[1].parameters] if meant is not None else []
        ports = {name: _written(param) for name, param in zip(names, call.params, strict=False)}
        return TreeNode(self.ids.get((call.object, call.method), ""), ports, (), role)

    def conditional(self, node: Conditional, in_loop: bool, bare: bool) -> TreeNode:
        if node.orelse is not None:
            sides = (self.body(node.then, in_loop=in_loop), self.body(node.orelse, in_loop=in_loop))
            return TreeNode("IfThenElse", {}, (self.condition(node.condition), *sides))
        otherwise = self.negated(node.condition)
        if bare and in_loop and len(node.then.items) == 1 and isinstance(node.then.items[0], Break):
            return otherwise
        return TreeNode("Fallback", {}, (otherwise, self.body(node.then, in_loop=in_loop)))

    def event(self, node: Event, in_loop: bool) -> list[TreeNode]:
        asked, body = self.condition(node.condition), self.nodes(node.body, in_loop=in_loop)
        forever = {COUNTS["RetryUntilSuccessful"]: FOREVER}
        if any(may_fail(child) for child in body):
            return [TreeNode("RetryUntilSuccessful", forever, (asked,)), *body]
        return [TreeNode("RetryUntilSuccessful", forever, (_sequence([asked, *body]),))]

    # -- conditions

    def condition(self, node: Condition) -> TreeNode:
        match node:
            case And():
                return TreeNode("Sequence", {}, (*self.spine(node.left, And), self.condition(node.right)))
            case Or():
                return TreeNode("Fallback", {}, (*self.spine(node.left, Or), self.condition(node.right)))
            case Not():
                return TreeNode("Inverter", {}, (self.condition(node.condition),))
            case Call():
                return self.leaf(node, "Condition")
        self.refuse(node, Sentence("this cannot be said in a behaviour tree"))
        return TreeNode("AlwaysSuccess")

    def spine(self, node: Condition, kind: type[And | Or]) -> Sequence[TreeNode]:
        """The conditions on the left of one sign, one after another."""
        if isinstance(node, kind):
            return (*self.spine(node.left, kind), self.condition(node.right))
        return (self.condition(node),)

    def negated(self, node: Condition) -> TreeNode:
        if isinstance(node, Not):
            return self.condition(node.condition)
        return TreeNode("Inverter", {}, (self.condition(node),))


def _written(param: Node) -> str:
    if isinstance(param, Call):
        return print_template(param).strip().removesuffix(";")
    return str(getattr(param, "value", ""))


def _sequence(nodes: Sequence[TreeNode]) -> TreeNode:
    if not nodes:
        return TreeNode("AlwaysSuccess")
    return nodes[0] if len(nodes) == 1 else TreeNode("Sequence", {}, tuple(nodes))


def _caught(loop: TreeNode) -> TreeNode:
    return TreeNode("ForceSuccess", {}, (loop,)) if may_fail(loop) else loop


def _depth(root: TreeNode) -> int:
    deepest, waiting = 0, [(root, 1)]
    while waiting:
        node, depth = waiting.pop()
        deepest = max(deepest, depth)
        waiting += [(child, depth + 1) for child in node.children]
    return deepest
