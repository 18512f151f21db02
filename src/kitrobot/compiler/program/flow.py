"""Which ways lead through a piece of a program, and whether they block.

A loop's back edge is free only where every way round through its body surely blocks; this is how that is found out.
BREAK inside an inner loop is a way through that loop, so it counts for the loops around it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from kitrobot.compiler.program.slots import is_marked
from kitrobot.lll.tree import (
    Break,
    Call,
    Conditional,
    Event,
    Instr,
    Interrupt,
    Move,
    Parallel,
    ParOfSeq,
    ProgramCall,
    Repeat,
    Seq,
    SeqOfPar,
    Wait,
    Where,
    While,
)
from kitrobot.primitives.robot import Robot


class Flow(NamedTuple):
    """Whether a way exists: on to what follows, without and with blocking; to a BREAK, without and with blocking."""

    passes: bool
    passes_blocking: bool
    breaks: bool
    breaks_blocking: bool

    @property
    def goes_on(self) -> bool:
        """Whether what follows can be reached at all."""
        return self.passes or self.passes_blocking


_NOTHING = Flow(True, False, False, False)
_BLOCKS = Flow(False, True, False, False)
_BREAK = Flow(False, False, True, False)
_NOWHERE = Flow(False, False, False, False)


class FlowAnalysis:
    """Flows of the pieces of one program, each worked out once. The tree must not change meanwhile.

    `endless`: which loops go on for ever unless a BREAK leaves them. Without it the flow is the one of the language's
    definition, by which passes of loops are timed: there every `*[ ]( )` and `*( )` may be passed.
    """

    def __init__(self, robot: Robot, endless: Callable[[While], bool] | None = None) -> None:
        self._robot = robot
        self._endless = endless
        self._known: dict[int, Flow] = {}
        """Flows by the `id` of their body."""

    def seq(self, seq: Seq) -> Flow:
        """The flow of a body."""
        known = self._known.get(id(seq))
        if known is None:
            known = self._known[id(seq)] = self._sequence(seq)
        return known

    def back_edge_is_free(self, body: Seq) -> bool:
        """Whether every way round through a loop's body surely blocks."""
        return not self.seq(body).passes

    def instruction(self, node: Instr) -> Flow:
        """The flow of one instruction."""
        match node:
            case Call():
                return self._call(node)
            case Interrupt():
                return self._call(node.call) if isinstance(node.call, Call) else _NOTHING
            case Wait() | SeqOfPar() | ParOfSeq() | Where() | ProgramCall() | Move():
                return _BLOCKS
            case Parallel():
                return _NOWHERE if self._endless is not None and self._never_ends(node) else _BLOCKS
            case Break():
                return _BREAK
            case Conditional():
                then = self.seq(node.then)
                orelse = self.seq(node.orelse) if node.orelse is not None else _NOTHING
                return Flow(*(one or other for one, other in zip(then, orelse, strict=True)))
            case Event():
                body = self.seq(node.body)
                return Flow(body.passes, body.goes_on, body.breaks, body.breaks or body.breaks_blocking)
            case Repeat():
                if node.count == 0:
                    return _NOTHING
                body = self.seq(node.body)
                blocking = body.passes_blocking or body.breaks_blocking
                return Flow(body.passes or body.breaks, blocking, False, False)
            case While():
                if self._endless is None or not self._endless(node):
                    return Flow(True, True, False, False)
                body = self.seq(node.body)
                return Flow(body.breaks, body.breaks_blocking, False, False)

    def _never_ends(self, node: Parallel) -> bool:
        """Whether so many branches of a parallel never end that it is never over."""
        endless = [not any(self.seq(branch)) for branch in node.branches]
        marked = [is_marked(branch) for branch in node.branches]
        if all(marked):
            return sum(endless) > (len(endless) > 1)
        return any(never and not mark for never, mark in zip(endless, marked, strict=True))

    def _call(self, call: Call) -> Flow:
        meaning = self._robot.calls.get((call.object, call.method))
        return _BLOCKS if meaning is not None and meaning[1].completes_later else _NOTHING

    def _sequence(self, seq: Seq) -> Flow:
        passes, passes_blocking, breaks, breaks_blocking = _NOTHING
        for node in seq.items:
            flow = self.instruction(node)
            breaks_blocking = (
                breaks_blocking
                or (passes and flow.breaks_blocking)
                or (passes_blocking and (flow.breaks or flow.breaks_blocking))
            )
            breaks = breaks or (passes and flow.breaks)
            passes_blocking = (passes and flow.passes_blocking) or (passes_blocking and flow.goes_on)
            passes = passes and flow.passes
        return Flow(passes, passes_blocking, breaks, breaks_blocking)
