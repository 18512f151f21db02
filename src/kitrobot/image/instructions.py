"""The instruction set: one table that assembler, disassembler and verifier share.

Three-address code, four bytes an instruction: `op a b c`. An operand is the number of a cell unless its role says
otherwise; a jump's target takes the place of b and c, in instructions, low byte first. The meaning of each op is in
`kitrobot_onboard.interpreter`, and only there.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property


class Role(StrEnum):
    """What an operand byte is."""

    WRITTEN = "written"
    READ = "read"
    CONSTANT = "constant"
    TARGET = "target"
    COMMAND = "command"
    FIRST = "first"
    COUNT = "count"
    STOP = "stop"
    PARALLEL = "parallel"
    UNUSED = "unused"


@dataclass(frozen=True)
class Op:
    """An instruction's number, its name, what its operands are, and whether it gives up the tick."""

    number: int
    name: str
    a: Role = Role.UNUSED
    b: Role = Role.UNUSED
    c: Role = Role.UNUSED
    blocks: bool = False
    falls_through: bool = True

    @cached_property
    def jumps(self) -> bool:
        """Whether b and c hold a target."""
        return self.b is Role.TARGET


OPS = (
    Op(1, "MOV", Role.WRITTEN, Role.READ),
    Op(2, "ADD", Role.WRITTEN, Role.READ, Role.READ),
    Op(3, "SUB", Role.WRITTEN, Role.READ, Role.READ),
    Op(4, "CLAMP", Role.WRITTEN, Role.CONSTANT, Role.CONSTANT),
    Op(5, "EQ", Role.WRITTEN, Role.READ, Role.READ),
    Op(6, "LT", Role.WRITTEN, Role.READ, Role.READ),
    Op(7, "NOT", Role.WRITTEN, Role.READ),
    Op(8, "JMP", Role.UNUSED, Role.TARGET, falls_through=False),
    Op(9, "JZ", Role.READ, Role.TARGET),
    Op(10, "JNZ", Role.READ, Role.TARGET),
    Op(11, "LOOP", Role.UNUSED, Role.TARGET, blocks=True, falls_through=False),
    Op(12, "YIELD", blocks=True),
    Op(13, "WAIT", Role.READ, blocks=True),
    Op(14, "END", blocks=True, falls_through=False),
    Op(15, "ACT", Role.COMMAND, Role.FIRST, Role.COUNT),
    Op(16, "ARM", Role.STOP),
    Op(17, "FORK", Role.PARALLEL, blocks=True),
    Op(18, "JOIN", Role.PARALLEL),
)

BY_NUMBER = {op.number: op for op in OPS}
BY_NAME = {op.name: op for op in OPS}

MOV, ADD, SUB, CLAMP, EQ, LT, NOT, JMP, JZ, JNZ, LOOP, YIELD, WAIT, END, ACT, ARM, FORK, JOIN = (
    op.number for op in OPS
)
