"""What a tree and a program do, each by its own rules: the calls and the questions in their order, without time.

Trees go by the documents of BehaviorTree.CPP with actions that succeed, programs by docs/language.md. Answers are drawn
from a source of chance in the order of the questions, so that both are asked the same.
"""

from __future__ import annotations

import random
from collections.abc import Callable

from kitrobot.behaviour_trees.model import TreeNode
from kitrobot.lll.tree import (
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Not,
    Or,
    Repeat,
    Seq,
    While,
)

MOST_EVENTS = 60
MOST_STEPS = 400


class EndError(Exception):
    """Enough was done."""


class BreakError(Exception):
    """A BREAK."""


class Record:
    """What was called and asked, and the answers."""

    def __init__(self, seed: int) -> None:
        self.answers = random.Random(seed)
        self.events: list[str] = []
        self.steps = 0

    def step(self) -> None:
        self.steps += 1
        if self.steps > MOST_STEPS or len(self.events) >= MOST_EVENTS:
            raise EndError

    def call(self, name: str) -> bool:
        self.step()
        self.events.append(name)
        return True

    def ask(self, name: str) -> bool:
        self.step()
        answer = self.answers.random() < 0.6
        self.events.append(f"{name}? {answer}")
        return answer


def events_of(run: Callable[[Record], object], seed: int) -> tuple[list[str], bool]:
    """The events of a run, and whether it came to its end."""
    record = Record(seed)
    try:
        run(record)
    except EndError:
        return record.events, False
    return record.events, True


def run_tree(node: TreeNode, record: Record) -> bool:
    """Whether a node ends with success."""
    record.step()
    inside = node.children
    match node.name:
        case "Sequence":
            return all(run_tree(child, record) for child in inside)
        case "Fallback":
            return any(run_tree(child, record) for child in inside)
        case "Inverter":
            return not run_tree(inside[0], record)
        case "ForceSuccess":
            run_tree(inside[0], record)
            return True
        case "IfThenElse":
            if run_tree(inside[0], record):
                return run_tree(inside[1], record)
            return len(inside) == 3 and run_tree(inside[2], record)
        case "Repeat":
            count, done = int(node.ports["num_cycles"]), 0
            while done != count:
                record.step()
                if not run_tree(inside[0], record):
                    return False
                done += 1
            return True
        case "RetryUntilSuccessful":
            while not run_tree(inside[0], record):
                record.step()
            return True
        case "AlwaysSuccess" | "AlwaysFailure":
            return node.name == "AlwaysSuccess"
    return record.ask(node.name) if node.role == "Condition" else record.call(node.name)


def run_program(seq: Seq, record: Record) -> None:
    """The instructions of a body, one after another."""
    for node in seq.items:
        _run_instruction(node, record)


def _run_instruction(node: Instr, record: Record) -> None:
    record.step()
    match node:
        case Call():
            record.call(f"{node.object}.{node.method}")
        case Conditional():
            if _holds(node.condition, record):
                run_program(node.then, record)
            elif node.orelse is not None:
                run_program(node.orelse, record)
        case Event():
            while not _holds(node.condition, record):
                record.step()
            run_program(node.body, record)
        case Repeat() | While():
            _run_loop(node, record)
        case Break():
            raise BreakError
        case _:
            raise AssertionError(node)


def _run_loop(node: Repeat | While, record: Record) -> None:
    done = 0
    try:
        while done != node.count if isinstance(node, Repeat) else _goes_on(node, record):
            record.step()
            run_program(node.body, record)
            done += 1
    except BreakError:
        pass


def _goes_on(node: While, record: Record) -> bool:
    return node.condition is None or _holds(node.condition, record)


def _holds(node: Condition, record: Record) -> bool:
    match node:
        case And():
            return _holds(node.left, record) and _holds(node.right, record)
        case Or():
            return _holds(node.left, record) or _holds(node.right, record)
        case Not():
            return not _holds(node.condition, record)
        case Call():
            return record.ask(f"{node.object}.{node.method}")
    raise AssertionError(node)


def random_tree(rng: random.Random, depth: int = 4) -> TreeNode:
    """A tree of any nodes; many are refused."""
    name = rng.choice(_NODES if depth else [*_LEAVES])
    count = 1 if name in _DECORATORS else rng.choice((2, 3)) if name == "IfThenElse" else rng.choice((1, 2, 2, 3))
    if name in _LEAVES:
        return _LEAVES[name]
    inside = tuple(random_tree(rng, depth - 1) for _ in range(count))
    if name in ("Inverter", "RetryUntilSuccessful"):
        inside = (_LEAVES["ask"],)
    elif name == "IfThenElse":
        inside = (_LEAVES["ask"], *inside[1:])
    ports = {
        "Repeat": {"num_cycles": rng.choice(("-1", "0", "2", "3"))},
        "RetryUntilSuccessful": {"num_attempts": "-1"},
    }
    return TreeNode(name, ports.get(name, {}), inside)


_DECORATORS = ("Inverter", "ForceSuccess", "Repeat", "RetryUntilSuccessful")
_LEAVES = {
    "act": TreeNode("Wheel.Stop", role="Action"),
    "act too": TreeNode("Light.LightOn", role="Action"),
    "ask": TreeNode("Button.IsPressed", role="Condition"),
    "ask too": TreeNode("Light.IsGreen", role="Condition"),
    "AlwaysSuccess": TreeNode("AlwaysSuccess"),
    "AlwaysFailure": TreeNode("AlwaysFailure"),
}
_NODES = [*_LEAVES, *("Sequence",) * 4, *("Fallback",) * 3, *_DECORATORS, "IfThenElse"]
