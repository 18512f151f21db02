"""A py_trees behaviour tree for each robot, ticked once a step: the decisions of our program, and nothing around them.

Kind to py_trees: no world, the sensors are plain attributes that do not change, nothing is logged.
"""

from __future__ import annotations

from importlib.metadata import version

import py_trees
from py_trees.common import Status
from py_trees.composites import Selector, Sequence

NAME = f"py_trees {version('py_trees')}"


class _Rover:
    def __init__(self) -> None:
        self.count = self.near = self.turn = 0
        self.left = self.right = self.front = 100


class _Step(py_trees.behaviour.Behaviour):
    def __init__(self, rover: _Rover) -> None:
        super().__init__(type(self).__name__)
        self.rover = rover


class _Count(_Step):
    def update(self) -> Status:
        self.rover.count = 0 if self.rover.count == 89 else self.rover.count + 1
        return Status.SUCCESS


class _LeftNear(_Step):
    def update(self) -> Status:
        return Status.SUCCESS if self.rover.left < 15 else Status.FAILURE


class _RightNear(_Step):
    def update(self) -> Status:
        return Status.SUCCESS if self.rover.right < 15 else Status.FAILURE


class _FrontNear(_Step):
    def update(self) -> Status:
        return Status.SUCCESS if self.rover.front < 20 else Status.FAILURE


class _Turn(_Step):
    def update(self) -> Status:
        self.rover.turn = 60
        return Status.SUCCESS


class _Straight(_Step):
    def update(self) -> Status:
        self.rover.turn = 0
        return Status.SUCCESS


def forest(robots: int) -> list[py_trees.trees.BehaviourTree]:
    """A tree for each of so many robots."""
    trees = []
    for _ in range(robots):
        rover = _Rover()
        looks = Selector("near", memory=False, children=[kind(rover) for kind in (_LeftNear, _RightNear, _FrontNear)])
        turn = Sequence("turn", memory=False, children=[looks, _Turn(rover)])
        choice = Selector("way", memory=False, children=[turn, _Straight(rover)])
        root = Sequence("rover", memory=False, children=[_Count(rover), choice])
        trees.append(py_trees.trees.BehaviourTree(root))
    return trees


def tick(trees: list[py_trees.trees.BehaviourTree], steps: int) -> None:
    """So many ticks of every tree."""
    for _ in range(steps):
        for tree in trees:
            tree.tick()
