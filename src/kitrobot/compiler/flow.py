"""Which ways lead through a piece of a program, and whether they block.

A loop's back edge is free only where every way round through its body surely blocks; this is how that is found out.
BREAK inside an inner loop is a way through that loop, so it counts for the loops around it.
"""

from __future__ import annotations

from typing import NamedTuple

from kitrobot.lll import Break, Call, Conditional, Event, Instr, Interrupt, Parallel, Repeat, Seq, Wait, While
from kitrobot.primitives import Robot


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


class FlowAnalysis:
    """Flows of the pieces of one program, each worked out once. The tree must not change meanwhile."""

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._known: dict[int, Flow] = {}

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
            case Wait() | Parallel():
                return _BLOCKS
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
                return Flow(True, True, False, False)

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
