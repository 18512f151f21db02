"""The syntax tree of the Low Level Language: one small class for each line of the grammar.

A program, a body and a branch are all a `Seq`. An instruction knows the comments that belong to it: `above` (whole
lines before it) and `after` (the rest of its own line). Places (`start`, `end`: character offsets into the text, end
exclusive) and the graph vertex a node came from (`vertex`) do not take part in equality, so two programs are equal
when they say the same thing in the same shape, comments included.

`Hole` stands in constructor templates only (`*[{condition}]({body})`); a program never holds one.

The forms of a team's programs are at the end; a program of one robot holds none of them.

What the tree leaves to others: meaning of names (compiler), layout of text (printer).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, TypeAlias

MAX_NUMBER = 65535
"""The largest number the language can write (NB in the grammar)."""

MAX_NESTING = 100
"""How deep bodies, conditions and parameters together may nest; a limit of ours, far below the host's recursion."""


@dataclass(slots=True)
class Node:
    """What every node has: its place in the text and the vertex it came from, if any."""

    start: int = field(default=0, compare=False, kw_only=True)
    end: int = field(default=0, compare=False, kw_only=True)
    vertex: str | None = field(default=None, compare=False, kw_only=True)


@dataclass(slots=True)
class Hole(Node):
    """`{name}` in a template, in the place of a number, a body, a condition, a parameter or an action."""

    name: str


@dataclass(slots=True)
class Number(Node):
    """A whole number 0…65535 as a parameter."""

    value: int


@dataclass(slots=True)
class Instruction(Node):
    """An instruction and the comments that belong to it; `program` is the program that it was copied from, if any."""

    program: str | None = field(default=None, compare=False, kw_only=True)
    above: list[str] = field(default_factory=list, kw_only=True)
    after: str | None = field(default=None, kw_only=True)


@dataclass(slots=True)
class Call(Instruction):
    """`Object.Method(params)`: an instruction, a condition or a value, as the robot's XML says.

    `method_start` is the offset of the method's name, for messages that point at it. A call that could not be read
    (already reported) has an empty `object`.
    """

    object: str
    method: str
    params: list[Param] = field(default_factory=list)
    method_start: int = field(default=0, compare=False, kw_only=True)


@dataclass(slots=True)
class Interrupt(Instruction):
    """`°Object.Method(params)°`: a marked action."""

    call: Call | Hole


@dataclass(slots=True)
class Repeat(Instruction):
    """`n*(body)`."""

    count: int | Hole
    body: Seq


@dataclass(slots=True)
class While(Instruction):
    """`*[condition](body)` or, without a condition, `*(body)`, which goes on for ever."""

    condition: Condition | None
    body: Seq


@dataclass(slots=True)
class Conditional(Instruction):
    """`[condition](then)` or, with `orelse`, `[condition](then)!(orelse)`."""

    condition: Condition
    then: Seq
    orelse: Seq | None = None


@dataclass(slots=True)
class Event(Instruction):
    """`<condition>(body)`."""

    condition: Condition
    body: Seq


@dataclass(slots=True)
class Parallel(Instruction):
    """`//(branch, …)`; branches that held nothing were dropped when read."""

    branches: list[Seq]


@dataclass(slots=True)
class Wait(Instruction):
    """`WAIT(duration)`, in the robot's wait units."""

    duration: int | Hole


@dataclass(slots=True)
class Break(Instruction):
    """`BREAK`."""


@dataclass(slots=True)
class And(Node):
    """`left & right`."""

    left: Condition
    right: Condition


@dataclass(slots=True)
class Or(Node):
    """`left | right`."""

    left: Condition
    right: Condition


@dataclass(slots=True)
class Not(Node):
    """`!(condition)`."""

    condition: Condition


@dataclass(slots=True)
class Seq(Node):
    """Instructions one after another: a program, a body or a branch.

    `below` holds the comments after which nothing follows in this body. In a template `hole` may stand for
    instructions of the body: all of them, or those before the item `hole_at`.
    """

    items: list[Instr] = field(default_factory=list)
    below: list[str] = field(default_factory=list)
    hole: Hole | None = None
    hole_at: int = 0


@dataclass(slots=True)
class Members(Node):
    """A set of roles, groups and agents: `{a, b}`, or `a` alone where it is not `braced`."""

    names: list[str]
    braced: bool = True


@dataclass(slots=True)
class SeqOfPar(Instruction):
    """`SeqOfPar members (body)`: all members do each line at the same time."""

    members: Members | Hole
    body: Seq


@dataclass(slots=True)
class ParOfSeq(Instruction):
    """`ParOfSeq members (body)`: each member does the lines on its own."""

    members: Members | Hole
    body: Seq


@dataclass(slots=True)
class Where(Instruction):
    """`Where members [condition](then)` or, with `orelse`, `… !(orelse)`: each member asks for itself."""

    members: Members | Hole
    condition: Condition
    then: Seq
    orelse: Seq | None = None


@dataclass(slots=True)
class ProgramCall(Instruction):
    """`PROGRAM name`: the program of that name, in its place."""

    name: str | Hole


@dataclass(slots=True)
class Move(Instruction):
    """`MOVE count source -> target`: so many members of one group go over to the other."""

    count: int | Hole
    source: str | Hole
    target: str | Hole


Quantifier: TypeAlias = Literal["any", "all", "most"]
"""How many members must say yes: one, each of them, more than half."""

QUANTIFIERS: tuple[Quantifier, ...] = ("any", "all", "most")


@dataclass(slots=True)
class Joint(Node):
    """`quantifier members (condition)`: a condition that is asked of each member, and answered once for all."""

    quantifier: Quantifier
    members: Members | Hole
    condition: Condition


@dataclass(slots=True)
class Declaration(Node):
    """A line before a team's instructions, and the comments that belong to it, as with an instruction."""

    above: list[str] = field(default_factory=list, kw_only=True)
    after: str | None = field(default=None, kw_only=True)


@dataclass(slots=True)
class RoleDeclaration(Declaration):
    """`role name: robot least..most;`: the kind of robot that can play a role, and how many are wanted."""

    name: str
    robot: str
    least: int = 1
    most: int = 1


Failure: TypeAlias = Literal["drop", "substitute", "abort"]
"""What a group does when a member fails: goes on without it, takes a substitute, or ends."""

FAILURES: tuple[Failure, ...] = ("drop", "substitute", "abort")


@dataclass(slots=True)
class GroupDeclaration(Declaration):
    """`group name = members on failure …;`."""

    name: str
    members: Members
    failure: Failure = "drop"


@dataclass(slots=True)
class WorkDeclaration(Declaration):
    """`work name = units lease seconds;`: after its lease an unfinished unit is free again; without one, never."""

    name: str
    units: int
    lease: int | None = None


AnyDeclaration: TypeAlias = RoleDeclaration | GroupDeclaration | WorkDeclaration


@dataclass(slots=True)
class TeamProgram(Node):
    """A team's program: what it declares, each kind in its order, and its instructions."""

    roles: list[RoleDeclaration] = field(default_factory=list)
    groups: list[GroupDeclaration] = field(default_factory=list)
    works: list[WorkDeclaration] = field(default_factory=list)
    seq: Seq = field(default_factory=Seq)

    @property
    def declarations(self) -> list[AnyDeclaration]:
        """All declarations in the order in which they are printed."""
        return [*self.roles, *self.groups, *self.works]


Param: TypeAlias = Number | Call | Hole
Condition: TypeAlias = Call | And | Or | Not | Joint | Hole
Block: TypeAlias = SeqOfPar | ParOfSeq | Where
"""What says which robots of a team do its lines."""
TeamInstr: TypeAlias = SeqOfPar | ParOfSeq | Where | ProgramCall | Move
Instr: TypeAlias = Call | Interrupt | Repeat | While | Conditional | Event | Parallel | Wait | Break | TeamInstr
