"""What is wrong with a team's program beyond its names: whether those who are to meet can come.

The walk goes down the program with the set of those who are there: everybody at first, in a block its members. All that
is said about a program is said of its text; circles of programs are looked for among all programs of a mission.

Left to others: names of objects and methods (checker), declarations (compiler.team.names), groups that robots move
out of (compiler.team.moves), what a program becomes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from kitrobot.compiler.program.checker import check
from kitrobot.compiler.target import Target
from kitrobot.compiler.team import rules
from kitrobot.compiler.team.names import Atom, Atoms, Names
from kitrobot.diagnostics.model import Diagnostic, Rule, Source, in_reading_order
from kitrobot.lll.tree import (
    And,
    Block,
    Call,
    Conditional,
    Event,
    Instr,
    Joint,
    Members,
    Move,
    Node,
    Not,
    Or,
    Parallel,
    ParOfSeq,
    ProgramCall,
    Repeat,
    Seq,
    SeqOfPar,
    Where,
    While,
)
from kitrobot.lll.walk import bodies, children, nodes
from kitrobot.primitives.crew import Crew
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Help, Sentence, Word


def check_program(program: Seq, target: Target, crew: Crew, source: Source, name: str = "") -> list[Diagnostic]:
    """All that is wrong or odd about a program for a target, in reading order; see `check`.

    `crew` is the team that the program of a team speaks of.
    """
    found = check(program, target, source, name)
    if target.level.is_team:
        found += _CheckWalk(Names(crew), target, source, name).whole(program)
    return in_reading_order(found)


def program_circles(programs: Mapping[str, Seq]) -> list[Diagnostic]:
    """Each `PROGRAM` by which a program of a team comes into its own place, by its vertex and without a place."""
    calls = {name: [one for one in nodes(seq) if isinstance(one, ProgramCall)] for name, seq in programs.items()}
    found: list[Diagnostic] = []
    for name, own in calls.items():
        for call in own:
            way = _way(str(call.name), name, calls)
            if way is None:
                continue
            message = Sentence("`{program}` would stand in its own place: {way}", name, " → ".join((name, *way)))
            vertices = (call.vertex,) if call.vertex else ()
            help = Sentence("write a loop around what is to be done again")
            found.append(rules.PROGRAM_CIRCLE(message, help=help, program=name, vertices=vertices))
    return found


def _way(start: str, goal: str, calls: Mapping[str, Sequence[ProgramCall]]) -> tuple[str, ...] | None:
    """The names on a shortest way from one program to another; None where there is none."""
    waiting: list[tuple[str, ...]] = [(start,)]
    seen = {start}
    for way in waiting:
        if way[-1] == goal:
            return way
        for call in calls.get(way[-1], ()):
            if str(call.name) not in seen:
                seen.add(str(call.name))
                waiting.append((*way, str(call.name)))
    return None


class _CheckWalk:
    def __init__(self, names: Names, target: Target, source: Source, program: str) -> None:
        self.names = names
        self.target = target
        self.source = source
        self.program = program
        self.blocks: dict[int, bool] = {}
        self.found: list[Diagnostic] = []

    def report(self, rule: Rule, message: Sentence, node: Node, help: Help = "", vertex: str | None = None) -> None:
        vertices = (vertex,) if (vertex := vertex or node.vertex) else ()
        place = self.source.place(node.start, node.end)
        self.found.append(rule(message, place, help=help, program=self.program, vertices=vertices))

    def whole(self, program: Seq) -> list[Diagnostic]:
        self.seq(program, None)
        return self.found

    # -- who is there

    def seq(self, seq: Seq, there: Atoms | None) -> None:
        for node in seq.items:
            self.instruction(node, there)

    def instruction(self, node: Instr, there: Atoms | None) -> None:
        """`there`: who does the instruction; None where that is everybody."""
        match node:
            case SeqOfPar() | ParOfSeq():
                self.seq(node.body, self.block(node, node.members, there))
            case Where():
                members = self.block(node, node.members, there)
                self.condition(node.condition, members)
                for side in bodies(node):
                    self.side(node, side, members)
            case ProgramCall():
                self.run(node, there)
            case Move():
                for name in (node.source, node.target):
                    self.group(node, str(name))
            case Parallel():
                self.two_places(node)
                for branch in node.branches:
                    self.seq(branch, there)
            case While() | Conditional() | Event():
                if node.condition is not None:
                    self.condition(node.condition, there)
                    if self.has_block(node):
                        self.one_answer(node.condition)
                for body in bodies(node):
                    self.seq(body, there)
            case Repeat():
                self.seq(node.body, there)

    def block(self, node: Node, members: Any, there: Atoms | None) -> Atoms:
        """The members of a block or a question, after a look at whether they are there."""
        if not isinstance(members, Members):
            return frozenset()
        known = True
        for name in members.names:
            told = self.names.unknown(name)
            if told is not None:
                self.report(rules.UNKNOWN_MEMBER, told[0], members, told[1], node.vertex)
                known = False
        atoms = self.names.atoms(members.names)
        strangers = [one for one in sorted(atoms) if there is not None and not _is_among(one, there)]
        if known and strangers:
            message = Sentence("{strangers} are not among those who do this", _names(strangers))
            help = Sentence("name members of the block around it, or put it outside of that block")
            self.report(rules.NOT_WITHIN, message, members, help, node.vertex)
        return atoms if there is None or not strangers else atoms & there

    def side(self, node: Where, side: Seq, members: Atoms) -> None:
        """A side of `Where`: nobody knows before who is there, so nobody can be waited for."""
        for inner in nodes(side):
            if isinstance(inner, Block):
                message = Sentence("a block stands on a side of Where, and who is on that side is not known before")
                help = Sentence("put the block outside of the Where, or write its lines alone")
                self.report(rules.NOT_WITHIN, message, inner, help)
                return
        self.seq(side, members)

    def two_places(self, node: Parallel) -> None:
        """Members of blocks in two branches."""
        first: dict[Atom, int] = {}
        for index, branch in enumerate(node.branches):
            for block in (one for one in nodes(branch) if isinstance(one, Block)):
                names = block.members.names if isinstance(block.members, Members) else []
                both = [one for one in sorted(self.names.atoms(names)) if first.setdefault(one, index) != index]
                if both:
                    message = Sentence("{members} are in another branch of this parallel too", _names(both))
                    help = Sentence("let each branch have members of its own, or write one after the other")
                    self.report(rules.TWO_PLACES, message, block.members, help, block.vertex)
                    return

    def has_block(self, node: Node) -> bool:
        """Whether members meet inside of an instruction."""
        known = self.blocks.get(id(node))
        if known is None:
            known = isinstance(node, Block | Move) or (
                isinstance(node, ProgramCall)
                and (program := self.names.programs.get(str(node.name))) is not None
                and program.level.is_team
            )
            known = known or any(self.has_block(child) for child in children(node))
            self.blocks[id(node)] = known
        return known

    # -- conditions

    def condition(self, node: Any, there: Atoms | None) -> None:
        match node:
            case Joint():
                self.condition(node.condition, self.block(node, node.members, there))
            case And() | Or():
                self.condition(node.left, there)
                self.condition(node.right, there)
            case Not():
                self.condition(node.condition, there)

    def one_answer(self, node: Any) -> None:
        """That a condition around blocks has one answer for all."""
        match node:
            case And() | Or():
                self.one_answer(node.left)
                self.one_answer(node.right)
            case Not():
                self.one_answer(node.condition)
            case Call() if not self.is_shared(node):
                message = Sentence(
                    "`{call}` can be true for one member and false for another, and here all go the same way",
                    f"{node.object}.{node.method}",
                )
                text = self.source.text[node.start : node.end]
                help = Sentence("ask the team: any {members} ({test})", self.somebody(), text)
                self.report(rules.BARE_TEST, message, node, help)

    def is_shared(self, call: Call) -> bool:
        """Whether a call is of shared variables and work only, or of nothing that is known."""
        meaning = self.target.calls.get((call.object, call.method))
        known = meaning is None or meaning[0].shared
        return known and all(self.is_shared(param) for param in call.params if isinstance(param, Call))

    def somebody(self) -> str:
        """A name for a help: the first that the team has."""
        return self.names.members[0] if self.names.members else "carriers"

    # -- programs and moves

    def run(self, node: ProgramCall, there: Atoms | None) -> None:
        name = str(node.name)
        program = self.names.programs.get(name)
        if program is None:
            known = list(self.names.programs)
            near = self.names.suggestions.did_you_mean(name, known)
            there_is = Sentence("there is {known}", listed(known)) if known else Sentence("draw it in the studio")
            message = Sentence("there is no program `{program}` in this mission", name)
            self.report(rules.UNKNOWN_PROGRAM, message, node, near or there_is)
        elif not self.target.level.holds(program.level):
            message = Sentence(
                "`{program}` is a program of the level {level}, which is wider", name, Word(program.level)
            )
            help = Sentence("name a program of the level group, or of a robot")
            self.report(rules.UNKNOWN_PROGRAM, message, node, help)
        elif not program.level.is_team:
            others = [one for one in sorted(there or ()) if one.kind not in ("", program.target)]
            if others:
                message = Sentence(
                    "`{program}` is for the robot `{robot}`, and {members} are others",
                    name,
                    program.target,
                    _names(others),
                )
                help = Sentence("name a program for their robot, or let others do this")
                self.report(rules.PROGRAM_KIND, message, node, help)

    def group(self, node: Move, name: str) -> None:
        """That members can move out of, or into, what a MOVE names."""
        told = self.names.unknown(name)
        if told is not None:
            self.report(rules.UNKNOWN_MEMBER, told[0], node, told[1])
        elif name not in self.names.groups and name not in self.names.roles:
            message = Sentence("`{name}` is an agent, and members move between groups", name)
            self.report(rules.UNKNOWN_MEMBER, message, node, Sentence("name a group or a role"))


def _names(atoms: Sequence[Atom]) -> str:
    return listed([f"`{one.name}`" for one in atoms])


def _is_among(one: Atom, there: Atoms) -> bool:
    """Whether a role or an agent can be among others: an agent can play any role for its kind of robot."""
    if one in there:
        return True
    return not one.is_role and any(other.is_role and one.kind in ("", other.kind) for other in there)
