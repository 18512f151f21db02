"""The rules of behaviour trees: why a tree is no program, or a program no tree."""

from __future__ import annotations

from kitrobot.diagnostics.model import Severity, rule

FORM = rule(
    "tree-form",
    Severity.ERROR,
    "A behaviour tree is not built as BehaviorTree.CPP 4 builds it",
    'The first element is `<root BTCPP_format="4">`, `main_tree_to_execute` names the tree that runs where there are'
    " several, and each node has as many nodes inside as its kind needs.",
)
NODE = rule(
    "tree-node",
    Severity.ERROR,
    "A node is no call of the robot",
    'An action is a procedure of the robot, and a condition is one of its tests: `<Action ID="Wheel.Advance"'
    ' speed="50"/>`. Ports have the names of the method\'s parameters, and hold whole numbers or values of the robot.',
)
MEANING = rule(
    "tree-meaning",
    Severity.ERROR,
    "A node means something that no program says",
    "The actions of a KitRobot never fail, nothing but a marked action is stopped before its end, and there is no"
    " blackboard. A tree that counts on one of these is refused, because a program would do something else.",
)
SIZE = rule(
    "tree-size",
    Severity.ERROR,
    "A behaviour tree is too large",
    "Trees inside trees are put in their places. What comes of that has a largest number of nodes and of levels.",
)
PROGRAM = rule(
    "tree-program",
    Severity.ERROR,
    "A part of a program cannot be said in a behaviour tree",
    "Marked actions, a `BREAK` outside a loop, and programs of teams have no counterpart in a behaviour tree.",
)
