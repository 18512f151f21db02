"""Which loops give up the tick at their back edge: the row "passes" of the meaning table, as a static analysis.

A way through a body is told by two facts: how it leaves (at the end of the body, or by BREAK) and whether it surely
blocked on the way. `ways` gives the set of all of them; the conditions are not looked at, both sides are possible. A
loop's back edge is free when no way that comes to the end of the body is without blocking.
"""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.lll.tree import Break, Call, Conditional, Event, Instr, Interrupt, Parallel, Repeat, Seq, Wait, While
from kitrobot.primitives.robot import Robot


class Way(NamedTuple):
    """One kind of way through a piece of program."""

    by_break: bool
    blocked: bool


THROUGH = Way(by_break=False, blocked=False)
BLOCKING = Way(by_break=False, blocked=True)


def ways(node: Instr | Seq, robot: Robot) -> set[Way]:
    """All ways through an instruction or a body."""
    match node:
        case Seq():
            return _ways_of_sequence(node, robot)
        case Interrupt():
            assert isinstance(node.call, Call)
            return ways(node.call, robot)
        case Call():
            _, method = robot.calls[node.object, node.method]
            return {BLOCKING if method.completes_later else THROUGH}
        case Wait() | Parallel():
            # A BREAK inside a branch never crosses the parallel, so the branches do not matter here.
            return {BLOCKING}
        case Break():
            return {Way(by_break=True, blocked=False)}
        case Conditional():
            return ways(node.then, robot) | (ways(node.orelse, robot) if node.orelse is not None else {THROUGH})
        case Event():
            # The condition may hold at once, so the waiting itself is not sure to block.
            return ways(node.body, robot)
        case Repeat():
            # Left at its end or by its own BREAK, the loop is over; a back edge that costs a tick does not count.
            return {THROUGH} if node.count == 0 else {Way(False, way.blocked) for way in ways(node.body, robot)}
        case While():
            # No pass at all is one of its ways.
            return {THROUGH} | {Way(False, way.blocked) for way in ways(node.body, robot) if way.by_break}
    raise AssertionError(node)


def _ways_of_sequence(seq: Seq, robot: Robot) -> set[Way]:
    left: set[Way] = set()
    here = {THROUGH}
    for item in seq.items:
        reached: set[Way] = set()
        for before in here:
            for way in ways(item, robot):
                (left if way.by_break else reached).add(Way(way.by_break, before.blocked or way.blocked))
        here = reached
    return left | here


def back_edge_costs_a_tick(body: Seq, robot: Robot) -> bool:
    """Whether a loop around this body gives up the tick after each pass."""
    return THROUGH in ways(body, robot)
