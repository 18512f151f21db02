"""Commands that have no effect, because their actuator gets another one in the same tick.

The search goes from a command to where its thread may block: an actuator takes one command a tick, and the last wins. A
command that is overridden on some paths only is not reported: a choice may override it on purpose.
"""

from __future__ import annotations

from kitrobot.compiler.program.flow import FlowAnalysis
from kitrobot.compiler.team.lines import has_blocks
from kitrobot.lll.tree import (
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Interrupt,
    Joint,
    Repeat,
    Seq,
    SeqOfPar,
    Wait,
    While,
)
from kitrobot.lll.walk import bodies, nodes
from kitrobot.primitives.robot import Category, Kind, Robot

_SHORT = (Call, Interrupt, Wait)
"""Holds no body."""

Pairs = list[tuple[Call, Call]]
"""Commands, and those to which they give way."""


def find_overridden_commands(program: Seq, robot: Robot) -> Pairs:
    """Each command that surely gives way, and the one it gives way to, in no order."""
    return _OverrideSearch(robot).body(program, False)


class _OverrideSearch:
    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.flow = FlowAnalysis(robot)

    def body(self, seq: Seq, goes_round: bool) -> Pairs:
        """Those of a body, with all in it."""
        found: Pairs = []
        given = _row(seq.items, {}, self.robot, self.flow, found)
        if goes_round:
            told = {id(call) for call, _ in found}
            more: Pairs = []
            _row(seq.items, dict(given), self.robot, self.flow, more)
            last = {id(call) for call in given.values()}
            found += [pair for pair in more if id(pair[0]) in last - told and pair[0] is not pair[1]]
        for node in seq.items:
            if not isinstance(node, _SHORT):
                found += self.inside(node)
        return found

    def inside(self, node: Instr) -> Pairs:
        """Those in an instruction."""
        if isinstance(node, SeqOfPar):
            return self.in_step(node.body)
        endless = isinstance(node, While) and node.condition is None and self.flow.back_edge_is_free(node.body)
        return [pair for one in bodies(node) for pair in self.body(one, endless)]

    def in_step(self, seq: Seq) -> Pairs:
        """Those in lines between which the members of a SeqOfPar meet, in passes and choices of all of them too."""
        found: Pairs = []
        for node in seq.items:
            joint = isinstance(node, Repeat) or (
                isinstance(node, While | Conditional | Event) and (has_blocks(node) or self.is_joint(node.condition))
            )
            for part in bodies(node) if joint else ():
                found += self.in_step(part)
            if not joint:
                found += self.body(Seq([node]), False)
        return found

    def is_joint(self, condition: Condition | None) -> bool:
        """Whether a condition asks the team, or looks at what all know alike."""
        inside = nodes(condition) if condition is not None else []
        calls = [self.robot.calls.get((one.object, one.method)) for one in inside if isinstance(one, Call)]
        asks = any(isinstance(one, Joint) for one in inside)
        return asks or all(meaning is not None and meaning[0].shared for meaning in calls)


def _row(items: list[Instr], given: dict[str, Call], robot: Robot, flow: FlowAnalysis, found: Pairs) -> dict[str, Call]:
    """Goes through a body; `given` are the last commands of the tick in which it begins, then of that at its end."""
    for node in items:
        call = node.call if isinstance(node, Interrupt) else node
        if isinstance(call, Call):
            meaning = robot.calls.get((call.object, call.method))
            if meaning is None or meaning[1].kind is not Kind.PROCEDURE or meaning[0].category is not Category.ACTUATOR:
                continue
            if call.object in given:
                found.append((given[call.object], call))
            given[call.object] = call
            if meaning[1].completes_later:
                given.clear()
        elif not _is_immediate(node, flow):
            given.clear()
    return given


def _is_immediate(node: Instr, flow: FlowAnalysis) -> bool:
    """Whether what follows surely runs in the tick in which an instruction begins."""
    if isinstance(node, Repeat):
        return node.count == 0
    return isinstance(node, Conditional) and flow.instruction(node) == (True, False, False, False)
