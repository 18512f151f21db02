"""A behaviour tree as BehaviorTree.CPP 4 has it: nodes with ports, several trees in a file, and models of nodes.

Representation: frozen values. A node is named by what it does: the kind of a standard node (`Sequence`), the ID of an
action or a condition, `SubTree`. Places do not take part in equality: two trees are equal when they say the same.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kitrobot.diagnostics.model import Place

MAIN_TREE = "main_tree_to_execute"
FOREVER = "-1"
"""How many times a node repeats that repeats for ever."""

COUNTS = {"Repeat": "num_cycles", "RetryUntilSuccessful": "num_attempts"}
"""The port of a decorator that says how often."""
SEQUENCES = ("Sequence", "AsyncSequence", "ReactiveSequence")
FALLBACKS = ("Fallback", "AsyncFallback", "ReactiveFallback")
"""Nodes that try one child after another: those whose name begins with `Reactive` ask the first ones again."""
PARALLELS = ("Parallel", "ParallelAll")
LOOPS = ("Repeat", "KeepRunningUntilFailure")


@dataclass(frozen=True)
class TreeNode:
    """A node: its name, its ports in the order of the file, and the nodes inside.

    `role` is `Action` or `Condition` where the file says so; `places` are those of the ports' values.
    """

    name: str
    ports: Mapping[str, str] = field(default_factory=dict)
    children: tuple[TreeNode, ...] = ()
    role: str = ""
    place: Place | None = field(default=None, compare=False)
    places: Mapping[str, Place] = field(default_factory=dict, compare=False)


@dataclass(frozen=True)
class NodeModel:
    """What a file says of a kind of action or condition: the call of the robot that it stands for, "" where it says
    none, and the values of ports that are not given.
    """

    call: str = ""
    defaults: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class TreeFile:
    """The trees of a file by their ID, the ID of the one that runs, and the models of nodes by their ID."""

    trees: Mapping[str, TreeNode]
    main: str
    models: Mapping[str, NodeModel] = field(default_factory=dict)


def may_fail(node: TreeNode) -> bool:
    """Whether a node without subtrees may end with FAILURE, where actions never fail."""
    if node.name in ("ForceSuccess", "RetryUntilSuccessful", "AlwaysSuccess", "Sleep"):
        return False
    if node.name == "AlwaysFailure" or is_condition(node):
        return True
    if node.name in FALLBACKS:
        return bool(node.children) and may_fail(node.children[-1])
    if node.name == "IfThenElse":
        return len(node.children) < 3 or any(may_fail(child) for child in node.children[1:])
    return any(may_fail(child) for child in node.children)


def is_condition(node: TreeNode) -> bool:
    """Whether a node only asks: a condition, or several joined by nodes that ask one after another."""
    if node.name == "Inverter" or node.name in SEQUENCES or node.name in FALLBACKS:
        return bool(node.children) and all(is_condition(child) for child in node.children)
    return node.role == "Condition"
