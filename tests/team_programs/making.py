"""Random programs of teams that can be shared out: every line is in a block, and who waits for whom makes sense."""

from __future__ import annotations

import random

from kitrobot.lll.tree import (
    QUANTIFIERS,
    And,
    Break,
    Call,
    Condition,
    Conditional,
    GroupDeclaration,
    Instr,
    Joint,
    Members,
    Move,
    Not,
    Number,
    Or,
    Parallel,
    ParOfSeq,
    ProgramCall,
    Repeat,
    RoleDeclaration,
    Seq,
    SeqOfPar,
    TeamProgram,
    Wait,
    Where,
    While,
    WorkDeclaration,
)
from kitrobot.lll.walk import nodes

KINDS = ("ant", "bee")
WORKS = ("Boxes", "Balls")
ROLES = {"scout": "ant", "digger": "ant", "flier": "bee"}


class TeamMaker:
    """Makes a team and its program.

    Attributes:
        agents: agent → kind, role; the last ones are spare, with the role "".
        groups: group → its roles and agents.
        programs: what PROGRAM may name.
        works: work → its units. A robot that takes one does a line and has it done, whether it was given one or not.
        asks: whether ways depend on what is left of a work. When somebody fails, more may have been done than is said.
    """

    def __init__(self, rng: random.Random, spares: int = 0, asks: bool = True) -> None:
        self.rng = rng
        self.lines = 0
        self.agents: dict[str, tuple[str, str]] = {}
        for role, kind in ROLES.items():
            for number in range(rng.randint(1, 3)):
                self.agents[f"{role}-{number}"] = kind, role
        for number in range(spares):
            for kind in KINDS:
                self.agents[f"spare-{kind}-{number}"] = kind, ""
        active = [name for name, (_, role) in self.agents.items() if role]
        self.groups = {
            "ants": ["scout", "digger"],
            "some": rng.sample(active, rng.randint(1, len(active))),
            "everyone": ["ants", "flier"],
        }
        self.moves = rng.random() < 0.3
        self.works = {name: rng.randint(0, 8) for name in WORKS}
        self.usable = [*self.works]
        self.asks = asks
        self.programs = {"own": Seq([self.line() for _ in range(rng.randint(1, 3))])}

    def program(self) -> TeamProgram:
        """A program of the team."""
        roles = [RoleDeclaration(role, kind) for role, kind in ROLES.items()]
        groups = [GroupDeclaration(name, Members(list(names)), "substitute") for name, names in self.groups.items()]
        works = [WorkDeclaration(name, units) for name, units in self.works.items()]
        return TeamProgram(roles, groups, works, self.seq(0, [*ROLES, *self.groups]))

    def sets(self, program: TeamProgram) -> dict[str, list[str]]:
        """The groups, and the roles that are groups too because robots move from or to them."""
        moves = [node for node in nodes(program.seq) if isinstance(node, Move)]
        ends = {str(end) for move in moves for end in (move.source, move.target)}
        return {**self.groups, **{role: [role] for role in ROLES if role in ends}}

    def seq(self, depth: int, names: list[str], lockstep: bool = False, in_loop: bool = False) -> Seq:
        """Instructions that those of `names` come to together."""
        items = [self.joint(depth, names, lockstep, in_loop) for _ in range(self.rng.randint(1, 3))]
        if lockstep and self.rng.random() < 0.3:
            at = self.rng.randint(0, len(items))
            items[at:at] = self.unit(self.work())
        return Seq(items)

    def joint(self, depth: int, names: list[str], lockstep: bool, in_loop: bool) -> Instr:
        rng = self.rng
        choice = rng.random()
        if depth > 3 or choice < 0.35:
            return self.line_of_each() if lockstep and rng.random() < 0.8 else self.block(depth, names)
        if choice < 0.5:
            return Repeat(rng.randint(0, 3), self.seq(depth + 1, names, lockstep, True))
        if choice < 0.52 and self.asks:
            work = self.work()
            body = self.seq(depth + 1, names, lockstep, True)
            body.items.append(ParOfSeq(Members(names[:1]), Seq(self.unit(work))))
            return While(Not(Call(work, "IsEmpty", [])), body)
        if choice < 0.6:
            body = self.seq(depth + 1, names, lockstep, True)
            body.items.append(ParOfSeq(Members(names[:1]), Seq([self.count()])))
            return While(self.condition(depth, names), body)
        if choice < 0.75:
            then = self.seq(depth + 1, names, lockstep, in_loop)
            orelse = self.seq(depth + 1, names, lockstep, in_loop) if rng.random() < 0.6 else None
            return Conditional(self.condition(depth, names), then, orelse)
        if choice < 0.85 and not lockstep and {"ants", "flier"} <= set(names) and not self.moves:
            return self.parallel(depth + 1)
        if choice < 0.9 and in_loop:
            return Conditional(self.condition(depth, names), Seq([Break()]))
        if choice < 0.94 and self.moves and len(names) > 3:
            return Move(rng.randint(0, 2), *rng.sample(("ants", "some", "scout"), 2))
        return self.block(depth, names)

    def parallel(self, depth: int) -> Parallel:
        """What two parts of the team do at the same time, each with a work of its own, so that both are sure."""
        branches = []
        for names, work in zip((["ants", "scout", "digger"], ["flier"]), WORKS, strict=True):
            self.usable = [work]
            branches.append(self.branch(depth, names))
        self.usable = [*self.works]
        return Parallel(branches)

    def branch(self, depth: int, names: list[str]) -> Seq:
        made = self.seq(depth, names)
        made.items.append(ParOfSeq(Members(names[:1]), self.own()))
        return made

    def block(self, depth: int, names: list[str]) -> Instr:
        rng = self.rng
        inner = rng.sample(names, rng.randint(1, min(2, len(names))))
        choice = rng.random()
        if choice < 0.5 and depth <= 3:
            return SeqOfPar(Members(inner), self.seq(depth + 1, inner, lockstep=True))
        if choice < 0.8:
            return ParOfSeq(Members(inner), self.own())
        return Where(Members(inner), self.test(), self.own(), self.own() if rng.random() < 0.5 else None)

    def own(self) -> Seq:
        """Lines that a robot does on its own."""
        items: list[Instr] = [self.line() for _ in range(self.rng.randint(0, 2))]
        if self.rng.random() < 0.3:
            items.append(Repeat(self.rng.randint(0, 2), Seq([self.line()])))
        if self.rng.random() < 0.3:
            items.append(Conditional(self.test(), Seq([self.line()]), None))
        if self.rng.random() < 0.3:
            items.append(ProgramCall("own"))
        if self.rng.random() < 0.3:
            items += self.unit(self.work())
        if self.rng.random() < 0.05:
            work = self.work()
            items.append(While(Not(Call(work, "IsEmpty", [])), Seq([Call(work, "Take", []), Call(work, "Done", [])])))
        return Seq(items)

    def line_of_each(self) -> Instr:
        """A line that each does for itself, some with a test of their own."""
        choice = self.rng.random()
        if choice < 0.7:
            return self.line()
        if choice < 0.85:
            return Conditional(self.test(), self.own(), self.own() if self.rng.random() < 0.5 else None)
        return While(self.test(), Seq([self.line(), self.count()]))

    def line(self) -> Instr:
        if self.rng.random() < 0.2:
            return self.rng.choice((self.count(), Wait(self.rng.randint(0, 3))))
        self.lines += 1
        return Call("Arm", "Do", [Number(self.lines)])

    def work(self) -> str:
        return self.rng.choice(self.usable)

    def unit(self, work: str) -> list[Instr]:
        """A unit is taken, a line done, and so the unit."""
        return [Call(work, "Take", []), self.line(), Call(work, "Done", [])]

    def count(self) -> Instr:
        return Call("Count", "Add", [Number(self.rng.randint(1, 2))])

    def test(self) -> Condition:
        return Call("Count", "LessThan", [Number(self.rng.randint(0, 6))])

    def condition(self, depth: int, names: list[str]) -> Condition:
        rng = self.rng
        choice = rng.random()
        if self.asks and choice < 0.12:
            return Call(self.work(), "IsEmpty", [])
        if depth > 5 or choice < 0.6:
            return Joint(rng.choice(QUANTIFIERS), Members(rng.sample(names, 1)), self.test())
        if choice < 0.75:
            return Not(self.condition(depth + 1, names))
        both = self.condition(depth + 1, names), self.condition(depth + 1, names)
        return And(*both) if choice < 0.88 else Or(*both)
