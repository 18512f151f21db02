"""A behaviour tree as LLL: the same calls and tests in the same order.

Actions never fail, so failures come from conditions alone. A node that may fail is translated for what its failure
leads to: nothing (it is the last one), or the end of the loop around it (`BREAK`). Where a failure would lead anywhere
else the tree is refused. docs/decisions/behaviour-trees.md says which trees these are, and why.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from enum import Enum, auto

from kitrobot.behaviour_trees import refusals, rules
from kitrobot.behaviour_trees.calls import CallReader
from kitrobot.behaviour_trees.known_nodes import KnownNodes
from kitrobot.behaviour_trees.model import (
    COUNTS,
    FALLBACKS,
    FOREVER,
    LOOPS,
    PARALLELS,
    SEQUENCES,
    TreeFile,
    TreeNode,
    is_condition,
    may_fail,
)
from kitrobot.behaviour_trees.subtrees import expand_subtrees
from kitrobot.diagnostics.model import Diagnostic, Rule, in_reading_order
from kitrobot.lll.tree import (
    MAX_NESTING,
    MAX_NUMBER,
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Not,
    Or,
    Parallel,
    Repeat,
    Seq,
    Wait,
    While,
)
from kitrobot.primitives.robot import Robot
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Help, Sentence


class _Failure(Enum):
    """What the failure of a node leads to."""

    IGNORED = auto()
    """Nothing: it is the last node, and nobody asks for its answer."""
    BREAK = auto()
    """The end of the loop around it."""


class _DepthError(Exception):
    """The program would be nested deeper than LLL allows."""


def tree_to_lll(file: TreeFile, robot: Robot) -> tuple[Seq, list[Diagnostic]]:
    """The program that the tree of a file means for a robot, and why it has no such meaning, in reading order."""
    root, found = expand_subtrees(file)
    if found:
        return Seq(), in_reading_order(found)
    translation = _Translation(robot, file)
    root = KnownNodes(translation.calls).node(root)
    if translation.found:
        return Seq(), in_reading_order(translation.found)
    try:
        program = Seq(translation.node(root, _Failure.IGNORED))
    except _DepthError:
        message = Sentence("expected at most {most} nodes inside one another, found one more", MAX_NESTING)
        return Seq(), [rules.SIZE(message, root.place, help=Sentence("make two trees of it, and two programs"))]
    return Seq() if translation.found else program, in_reading_order(translation.found)


class _Translation:
    def __init__(self, robot: Robot, file: TreeFile) -> None:
        self.robot = robot
        self.calls = CallReader(robot, file.models)
        self.found = self.calls.found
        self.depth = 0

    def refuse(
        self, node: TreeNode, message: Sentence, help: Help = "", port: str = "", rule: Rule = rules.MEANING
    ) -> None:
        self.found.append(rule(message, node.places.get(port, node.place), help=help))

    @contextmanager
    def level(self) -> Iterator[None]:
        self.depth += 1
        if self.depth > MAX_NESTING:
            raise _DepthError
        yield
        self.depth -= 1

    # -- conditions

    def condition(self, node: TreeNode) -> Condition:
        with self.level():
            if node.name == "Inverter":
                return Not(self.condition(node.children[0]))
            if node.children:
                return self.joined(node.children, Or if node.name in FALLBACKS else And)
            return self.calls.read(node, condition=True) or Call("", "")

    def joined(self, nodes: Sequence[TreeNode], kind: type[And | Or] = And) -> Condition:
        """Conditions that are asked one after another, as one."""
        if len(nodes) > MAX_NESTING:
            raise _DepthError
        first, *others = map(self.condition, nodes)
        for other in others:
            first = kind(first, other)
        return first

    # -- actions

    def node(self, node: TreeNode, failure: _Failure) -> list[Instr]:
        """The instructions of a node: behind them it has ended with success, or its failure is of no interest."""
        with self.level():
            if is_condition(node):
                return [_bare_condition(self.condition(node), failure)]
            if node.name in SEQUENCES:
                return self.sequence(_flat(node, SEQUENCES), failure)
            if node.name in FALLBACKS:
                return self.fallback(_flat(node, FALLBACKS), failure)
            if node.name in LOOPS:
                return self.loop(node, failure)
            if node.name in PARALLELS:
                return self.parallel(node)
            return self.other(node, failure)

    def other(self, node: TreeNode, failure: _Failure) -> list[Instr]:
        match node.name:
            case "AlwaysSuccess":
                return []
            case "AlwaysFailure":
                return [Break()] if failure is _Failure.BREAK else []
            case "ForceSuccess":
                return self.node(node.children[0], _Failure.IGNORED)
            case "Sleep":
                return [Wait(self.wait_units(node, "msec"))]
            case "Delay":
                return [Wait(self.wait_units(node, "delay_msec")), *self.node(node.children[0], failure)]
            case "IfThenElse":
                return self.choice(node, failure)
            case "RetryUntilSuccessful":
                return self.event(node)
        call = self.calls.read(node, condition=False)
        return [call] if call is not None else []

    def sequence(self, nodes: Sequence[TreeNode], failure: _Failure) -> list[Instr]:
        made: list[Instr] = []
        for at, node in enumerate(nodes):
            is_last = at == len(nodes) - 1
            if is_last or failure is _Failure.BREAK or not may_fail(node):
                made += self.node(node, failure)
            elif is_condition(node):
                asked = _leading(nodes[at:])
                rest = nodes[at + len(asked) :]
                with self.level():
                    body = self.sequence(rest, failure)
                return [*made, Conditional(self.joined(asked), Seq(body))]
            else:
                self.refuse(
                    node,
                    Sentence("<{node}> can fail, and then what stands behind it would not be done", node.name),
                    refusals.SPLIT_HELP,
                )
        return made

    def fallback(self, nodes: Sequence[TreeNode], failure: _Failure) -> list[Instr]:
        first, *rest = nodes
        if not rest:
            return self.node(first, failure)
        if is_condition(first):
            asked = _leading(nodes)
            if len(asked) == len(nodes):
                return [_bare_condition(self.joined(asked, Or), failure)]
            with self.level():
                then = self.fallback(nodes[len(asked) :], failure)
            return [Conditional(_negated(self.joined(asked, Or)), Seq(then))]
        inside = _flat(first, SEQUENCES) if first.name in SEQUENCES else []
        asked = _leading(inside)
        if not may_fail(first):
            message = Sentence(
                "{node} never fails, so what stands behind it in <Fallback> is never done", shown(first.name)
            )
            self.refuse(first, message, refusals.ASK_FIRST)
        elif not asked or any(may_fail(node) for node in inside[len(asked) :]):
            message = Sentence(
                "<{node}> can fail after it has begun to act, and a program takes no other way then", first.name
            )
            self.refuse(first, message, refusals.ASK_FIRST)
        else:
            with self.level():
                then = self.sequence(inside[len(asked) :], failure)
                return [Conditional(self.joined(asked), Seq(then), Seq(self.fallback(rest, failure)))]
        return []

    def choice(self, node: TreeNode, failure: _Failure) -> list[Instr]:
        asked, then, *orelse = node.children
        if not is_condition(asked):
            message = Sentence("the first node in <IfThenElse> must be a condition, found {node}", shown(asked.name))
            self.refuse(asked, message, refusals.ASK_FIRST)
            return []
        made = Conditional(self.condition(asked), Seq(self.node(then, failure)))
        if orelse:
            made.orelse = Seq(self.node(orelse[0], failure))
        elif failure is _Failure.BREAK:
            made.orelse = Seq([Break()])
        return [made]

    def event(self, node: TreeNode) -> list[Instr]:
        """`RetryUntilSuccessful` that asks until it is so."""
        (child,) = node.children
        inside = _flat(child, SEQUENCES) if child.name in SEQUENCES and not is_condition(child) else [child]
        asked = _leading(inside)
        rest = inside[len(asked) :]
        if self.times(node) is not None or not asked or any(map(may_fail, rest)):
            reason = refusals.FAILURE.reason
            help = Sentence('to wait for something, put a condition alone into it, with num_attempts="-1"')
            self.refuse(node, Sentence("<{node}> {reason}", node.name, reason), help)
            return []
        return [Event(self.joined(asked), Seq(self.sequence(rest, _Failure.IGNORED)))]

    def loop(self, node: TreeNode, failure: _Failure) -> list[Instr]:
        (child,) = node.children
        times = self.times(node) if node.name in COUNTS else None
        can_fail = may_fail(child)
        if times is not None:
            if can_fail and failure is _Failure.BREAK:
                message = Sentence("<{node}> can fail, and then the loop around it would end too", node.name)
                self.refuse(node, message, Sentence("put it into <ForceSuccess>"))
            return [Repeat(times, Seq(self.node(child, _Failure.BREAK)))]
        inside = _flat(child, SEQUENCES) if child.name in SEQUENCES and not is_condition(child) else [child]
        asked = _leading(inside)
        body = Seq(self.sequence(inside[len(asked) :], _Failure.BREAK))
        made: list[Instr] = [While(self.joined(asked) if asked else None, body)]
        return [*made, Break()] if can_fail and failure is _Failure.BREAK else made

    def parallel(self, node: TreeNode) -> list[Instr]:
        count = str(len(node.children))
        if node.name == "Parallel" and node.ports.get("success_count", FOREVER).strip() not in (FOREVER, count):
            message = Sentence(
                "<Parallel> would stop branches before their end: expected success_count {expected}", FOREVER
            )
            self.refuse(node, message, Sentence("let each branch end by itself"), "success_count")
        for child in node.children:
            if may_fail(child):
                message = Sentence(
                    "{node} can fail, and then <{parallel}> would fail too", shown(child.name), node.name
                )
                self.refuse(child, message, Sentence("put it into <ForceSuccess>"))
        branches = [Seq(self.node(child, _Failure.IGNORED)) for child in node.children]
        return [Parallel([branch for branch in branches if branch.items])]

    # -- numbers

    def times(self, node: TreeNode) -> int | None:
        """How often a node repeats; None for ever."""
        port = COUNTS[node.name]
        text = node.ports.get(port, "").strip()
        if text == FOREVER:
            return None
        return self.number(node, port, text, 1)

    def wait_units(self, node: TreeNode, port: str) -> int:
        return self.number(node, port, node.ports.get(port, "").strip(), self.robot.wait_unit_ms)

    def number(self, node: TreeNode, port: str, text: str, unit: int) -> int:
        """A whole number of units in a port."""
        help: Help
        most = MAX_NUMBER * unit
        if text.isascii() and text.isdigit() and len(text) <= 9 and int(text) <= most:
            if int(text) % unit == 0:
                return int(text) // unit
            near = round(int(text) / unit) * unit
            message = Sentence("expected a multiple of {unit} in {attribute}, found {found}", unit, port, shown(text))
            help = Sentence(
                "write {number}: the robot `{robot}` waits in steps of {unit} ms", near, self.robot.name, unit
            )
        else:
            expected = Sentence("a whole number from {least} to {most}", 0, most)
            message = Sentence("expected {expected} in {attribute}, found {found}", expected, port, shown(text))
            help = Sentence("{forever} is for ever", FOREVER) if node.name in COUNTS else ""
        self.refuse(node, message, help, port, rules.FORM)
        return 0


def _bare_condition(asked: Condition, failure: _Failure) -> Conditional:
    """A question behind which nothing is done but what its failure leads to."""
    if failure is _Failure.BREAK:
        return Conditional(_negated(asked), Seq([Break()]))
    return Conditional(asked, Seq())


def _negated(condition: Condition) -> Condition:
    return condition.condition if isinstance(condition, Not) else Not(condition)


def _flat(node: TreeNode, kinds: Sequence[str]) -> list[TreeNode]:
    """The children of a node, with those of nodes of its kind inside. What only asks stays as it is, and so does a last
    <Fallback> in a <Fallback>: it is translated by itself.
    """
    made: list[TreeNode] = []
    for child in node.children:
        opens = (
            child.name in kinds and not is_condition(child) and (kinds is SEQUENCES or child is not node.children[-1])
        )
        made += _flat(child, kinds) if opens else [child]
    return made


def _leading(nodes: Sequence[TreeNode]) -> list[TreeNode]:
    """The conditions at the beginning."""
    for at, node in enumerate(nodes):
        if not is_condition(node):
            return [*nodes[:at]]
    return [*nodes]
