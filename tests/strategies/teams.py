"""Random programs of teams: any instruction of a robot's program, blocks around them, joint conditions, declarations.

Names are those that have to be quoted, and those that do not. What is left out: what the check of a team's program
calls an error is not avoided.
"""

from __future__ import annotations

import random

from kitrobot.lll.tree import (
    FAILURES,
    QUANTIFIERS,
    Condition,
    GroupDeclaration,
    Instr,
    Joint,
    Members,
    Move,
    ParOfSeq,
    ProgramCall,
    RoleDeclaration,
    SeqOfPar,
    TeamProgram,
    Where,
    WorkDeclaration,
)
from kitrobot.primitives.robot import Robot
from tests.strategies.programs import Maker, Making, Shape

NAMES = (
    "carriers",
    "carrier-2",
    "drive-to-A",
    "WAIT",
    "all",
    "Étage",
    "big one",
    '"x"',
    "2nd",
    "a--b",
    "-",
    "work",
    "é-2",
)


def random_team_program(rng: random.Random, robot: Robot, shape: Shape | None = None) -> TeamProgram:
    """A team's program whose calls are the robot's."""
    maker = _TeamMaker(rng, robot, shape or Shape())
    roles = [maker.role() for _ in range(rng.randint(0, 3))]
    groups = [maker.group() for _ in range(rng.randint(0, 3))]
    works = [maker.work() for _ in range(rng.randint(0, 2))]
    for one in (*roles, *groups, *works):
        if maker.shape.comments and rng.random() < 0.3:
            one.above = maker.some_comments()
        if maker.shape.comments and rng.random() < 0.3:
            one.after = maker.some_comments()[0]
    return TeamProgram(roles, groups, works, maker.program())


class _TeamMaker(Maker):
    def more_makers(self, nested: float) -> dict[Making, float]:
        return {
            self.block: nested * 2,
            self.where: nested,
            self.run: 1,
            self.move: 1,
        }

    def name(self) -> str:
        return self.rng.choice(NAMES)

    def members(self) -> Members:
        if self.rng.random() < 0.5:
            return Members([self.name()], braced=False)
        return Members([self.name() for _ in range(self.rng.randint(1, 3))])

    def block(self, depth: int, *_: object) -> Instr:
        made = self.rng.choice((SeqOfPar, ParOfSeq))
        return made(self.members(), self.seq(depth, in_loop=False, in_parallel=False, least=0))

    def where(self, depth: int, *_: object) -> Instr:
        condition = Maker.condition(self, depth)
        then = self.seq(depth, in_loop=False, in_parallel=False, least=0)
        orelse = self.seq(depth, in_loop=False, in_parallel=False, least=0) if self.rng.random() < 0.5 else None
        return Where(self.members(), condition, then, orelse)

    def run(self, *_: object) -> Instr:
        return ProgramCall(self.name())

    def move(self, *_: object) -> Instr:
        return Move(self.rng.choice((0, 1, 2, 65535)), self.name(), self.name())

    def condition(self, depth: int) -> Condition:
        if self.rng.random() < 0.3 and depth < self.shape.depth:
            return Joint(self.rng.choice(QUANTIFIERS), self.members(), super().condition(depth + 1))
        return super().condition(depth)

    def role(self) -> RoleDeclaration:
        least = self.rng.choice((0, 1, 1, 2))
        return RoleDeclaration(self.name(), self.name(), least, least + self.rng.choice((0, 0, 1, 3)))

    def group(self) -> GroupDeclaration:
        return GroupDeclaration(self.name(), self.members(), self.rng.choice(FAILURES))

    def work(self) -> WorkDeclaration:
        return WorkDeclaration(
            self.rng.choice(("Boxes", "work", "Étage")), self.rng.choice((0, 12)), self.rng.choice((None, 0, 30))
        )
