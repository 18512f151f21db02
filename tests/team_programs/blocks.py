"""Random programs of teams of which it is sure who does which line, and how often: blocks, branches and passes only.

A set names agents, a role or a group, so that robots of one role are in different blocks. Nothing depends on what
anybody senses, so a run ends, and its end can be told from the lines that were done.
"""

from __future__ import annotations

import random

from kitrobot.lll.tree import (
    Call,
    Failure,
    GroupDeclaration,
    Instr,
    Members,
    Number,
    Parallel,
    ParOfSeq,
    Repeat,
    RoleDeclaration,
    Seq,
    SeqOfPar,
    TeamProgram,
    Wait,
    WorkDeclaration,
)
from tests.team_programs.making import ROLES, TeamMaker


class BlocksMaker(TeamMaker):
    """Makes a team and its program.

    Attributes:
        members: line → the agents in the innermost block around it.
    """

    def __init__(self, rng: random.Random, spares: int, failure: Failure) -> None:
        super().__init__(rng, spares, asks=False)
        self.failure = failure
        self.active = [name for name, (_, role) in self.agents.items() if role]
        self.groups = {"some": self.groups["some"], "everyone": [*ROLES]}
        self.works = {}
        self.members: dict[int, set[str]] = {}

    def program(self) -> TeamProgram:
        roles = [RoleDeclaration(role, kind) for role, kind in ROLES.items()]
        groups = [GroupDeclaration(name, Members(list(names)), self.failure) for name, names in self.groups.items()]
        works: list[WorkDeclaration] = []
        return TeamProgram(roles, groups, works, self.blocks(0, self.active))

    def blocks(self, depth: int, who: list[str], lockstep: bool = False) -> Seq:
        """What those of `who` come to together."""
        items: list[Instr] = []
        for _ in range(self.rng.randint(1, 3)):
            choice = self.rng.random()
            if lockstep and choice < 0.5:
                items += self.lines_of(set(who), 1)
            elif depth < 3 and choice < 0.6:
                items.append(Repeat(self.rng.randint(1, 2), self.blocks(depth + 1, who, lockstep)))
            elif depth < 3 and choice < 0.75 and len(who) > 1:
                items.append(self.parted(depth, who))
            else:
                items.append(self.one_block(depth, who))
        return Seq(items)

    def parted(self, depth: int, who: list[str]) -> Parallel:
        """Two branches of different agents."""
        mixed = self.rng.sample(who, len(who))
        cut = self.rng.randint(1, len(who) - 1)
        return Parallel([self.blocks(depth + 1, part) for part in (mixed[:cut], mixed[cut:])])

    def one_block(self, depth: int, who: list[str]) -> Instr:
        inner = self.rng.sample(who, self.rng.randint(1, len(who)))
        if depth < 3 and self.rng.random() < 0.5:
            return SeqOfPar(self.named(inner), self.blocks(depth + 1, inner, lockstep=True))
        body = self.lines_of(set(inner), self.rng.randint(1, 3))
        return ParOfSeq(self.named(inner), Seq(body))

    def named(self, who: list[str]) -> Members:
        """A set of these agents: by a name of them all, else one by one or by roles."""
        for name, inside in self.groups.items():
            if (name == "some" and set(who) == set(inside)) or (name == "everyone" and set(who) == set(self.active)):
                return Members([name])
        left, names = set(who), []
        for role in ROLES:
            players = {name for name in self.active if self.agents[name][1] == role}
            if players <= left and self.rng.random() < 0.7:
                left -= players
                names.append(role)
        return Members(names + sorted(left))

    def lines_of(self, who: set[str], count: int) -> list[Instr]:
        items: list[Instr] = []
        for _ in range(count):
            self.lines += 1
            self.members[self.lines] = who
            if self.rng.random() < 0.4:
                items.append(Wait(self.rng.choice((1, 10, 60))))
            items.append(Call("Arm", "Do", [Number(self.lines)]))
        return items
