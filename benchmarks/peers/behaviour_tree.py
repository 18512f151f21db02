"""The loop `i+=1; x+=3; act(x); until i=1000` as a py_trees behaviour tree: one tick of the tree is one trip.

A sequence of four behaviours without memory. Kind to py_trees: their numbers are plain attributes (its blackboard is
slower), nothing is logged, and `act` keeps the number.
"""

from __future__ import annotations

from importlib.metadata import version

import py_trees
from py_trees.common import Status

NAME = f"py_trees {version('py_trees')}"


class _State:
    def __init__(self, until: int) -> None:
        self.until = until
        self.i = 0
        self.x = 0
        self.acted = 0
        self.last = 0


class _Step(py_trees.behaviour.Behaviour):
    def __init__(self, state: _State) -> None:
        super().__init__(type(self).__name__)
        self.state = state


class _Count(_Step):
    def update(self) -> Status:
        self.state.i += 1
        return Status.SUCCESS


class _Grow(_Step):
    def update(self) -> Status:
        self.state.x += 3
        return Status.SUCCESS


class _Act(_Step):
    def update(self) -> Status:
        self.state.acted += 1
        self.state.last = self.state.x
        return Status.SUCCESS


class _Until(_Step):
    def update(self) -> Status:
        return Status.SUCCESS if self.state.i == self.state.until else Status.RUNNING


def run(laps: int, until: int) -> None:
    """So many laps of the loop, each from i = x = 0."""
    state = _State(until)
    steps = [step(state) for step in (_Count, _Grow, _Act, _Until)]
    tree = py_trees.trees.BehaviourTree(py_trees.composites.Sequence("loop", memory=False, children=steps))
    for _ in range(laps):
        state.i = state.x = 0
        tree.tick()
        while tree.root.status is Status.RUNNING:
            tree.tick()
    assert (state.acted, state.last) == (laps * until, 3 * until)
