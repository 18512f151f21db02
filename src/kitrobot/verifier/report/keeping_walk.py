"""Walks at random that show that a property can still be kept, where there are too many states to look at all of them.

A walk takes steps that break nothing and are no failures. Where it has come to a good end, or to its last state, the
few states behind that are looked at as a whole: if a run can stay there for ever, the walk shows that it can be kept.
A walk that fails shows nothing.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import NamedTuple

from kitrobot.verifier.properties.verdicts import Step
from kitrobot.verifier.report.property_graph import FAULTS, Node, Successor, Successors
from kitrobot.verifier.report.property_memory import PropertyMemory

WALKS = 6
MOST_STEPS = 5_000
"""Steps of one walk."""
_PAUSE = 4
_SEED = 1


class KeepingWalk(NamedTuple):
    """Steps that break nothing, and whether they come to a good end."""

    steps: tuple[Step, ...]
    ends_well: bool


def find_keeping_walk(
    successors: Successors, memory: PropertyMemory, first: Node, can_stay: Callable[[Node], bool]
) -> KeepingWalk | None:
    """A walk from a node to one where a run can stay for ever; None if none was found.

    Args:
        successors: the steps of the model.
        memory: the property, followed along the walk.
        first: where it begins.
        can_stay: whether a run can stay behind a node for ever and keep the property.
    """
    rng = random.Random(_SEED)
    for _ in range(WALKS):
        walked: list[tuple[Node, Successor]] = []
        node, was_good = first, False
        while len(walked) < MOST_STEPS:
            if len(walked) % _PAUSE == 0 and successors.space.interruption():
                return None
            following = _next_nodes(successors, memory, node)
            is_good = successors.has_good_end(node[0])
            if ((is_good and not was_good) or not following) and can_stay(node):
                steps = (Step(successors.events(before[0], step), step.state) for before, step in walked)
                return KeepingWalk(tuple(steps), is_good)
            if not following:
                break
            was_good = is_good
            step, after = rng.choice(following)
            walked.append((node, step))
            node = after
    return None


def _next_nodes(successors: Successors, memory: PropertyMemory, node: Node) -> list[tuple[Successor, Node]]:
    """The steps out of a node that break nothing, are no failures and lead to another node, with those."""
    found = []
    for step in successors.of(node[0]):
        if not step.kinds & FAULTS and step.state != node[0]:
            following = memory.after(node[1], node[0], step.kinds, step.state)
            if following is not None:
                found.append((step, (step.state, following)))
    return found
