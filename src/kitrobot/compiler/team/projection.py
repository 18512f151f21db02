"""Projection: a team's program → for each kind of robot one ordinary program that does its part.

What the robots of a team do together becomes calls of the robot object `Team`, with the numbers of the points
(`team_points`) at which they agree:

| in the team's program | in the program of a kind of robot |
|---|---|
| a block of members | `Team.Enter(n); [Team.Answer()](…)` around its lines, and a meeting of all who came to it |
| a line of a `SeqOfPar` | the line, and a meeting of the members |
| a condition around blocks | `Team.Ask(n, test)`, then `Team.Answer()` in its place |
| `n*(…)` around blocks | a question that is yes n times |
| `//(…, …)` around blocks | the branch in which the robot is, and a meeting |
| `PROGRAM name` | that program, in its place |

`Team.Join()` comes first: it waits until the robot is wanted, at the start or as a substitute. A block stands only in
the programs of kinds that its members can be; who is a member when it is reached, `Team` says, so nothing is loaded
anew when a role changes hands. All kinds pass the same points in the same order.

Mistakes are diagnostics; what they stand at is left out. Left to others: whether names are known (team_check), what the
lines mean for each robot (checker).
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from kitrobot.compiler.graph.expansion_limit import oversize_for_kinds
from kitrobot.compiler.rules import TOO_LARGE
from kitrobot.compiler.team import rules
from kitrobot.compiler.team.inlining import Report, inlined
from kitrobot.compiler.team.lines import Lines, answer, append, come_from, has_blocks, loose_break, team_call
from kitrobot.compiler.team.names import Atom
from kitrobot.compiler.team.points import ALL, ONE, NameSet, Point, PointKind, TeamPlan
from kitrobot.compiler.team.sets import TeamSets
from kitrobot.diagnostics.model import Diagnostic, Rule, Source
from kitrobot.lll.tree import (
    MAX_NUMBER,
    And,
    Block,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Instr,
    Instruction,
    Joint,
    Members,
    Move,
    Node,
    Not,
    Number,
    Or,
    Parallel,
    ParOfSeq,
    Quantifier,
    Repeat,
    Seq,
    SeqOfPar,
    Wait,
    Where,
    While,
)
from kitrobot.lll.walk import bodies, nodes
from kitrobot.primitives.crew import Crew
from kitrobot.text.sentences import Help, Sentence

Shared = Callable[[Call], bool]


@dataclass(frozen=True)
class Projection:
    """What became of a team's program: of each kind of robot its program, the points, and what is wrong.

    `whole` is the team's program with every `PROGRAM` in its place; empty where that cannot be.
    """

    programs: dict[str, Seq]
    plan: TeamPlan
    diagnostics: list[Diagnostic] = field(default_factory=list)
    whole: Seq = field(default_factory=Seq)


def project(
    program: Seq, crew: Crew, programs: Mapping[str, Seq], source: Source, name: str = "", shared: Shared | None = None
) -> Projection:
    """The programs of all kinds of robots in a team.

    Args:
        program: what the team does together; it is not changed.
        crew: what the team declares, and its agents.
        programs: the mission's other programs by name, those of groups and those of one robot.
        source: the text that the places in `program` point into.
        name: the program's name in its mission.
        shared: whether what a call tells is known to all alike; without it nothing is.
    """
    found: list[Diagnostic] = []

    def report(rule: Rule, message: Sentence, node: Node, help: Help = "") -> None:
        vertices = (node.vertex,) if node.vertex else ()
        program = (node.program if isinstance(node, Instruction) else None) or name
        place = source.place(node.start, node.end) if program == name else None
        found.append(rule(message, place, help=help, program=program, vertices=vertices))

    whole = inlined(program, name, programs, report)
    sets = TeamSets(crew, whole)
    large = oversize_for_kinds(whole, len(sets.kinds(ALL)))
    if large is not None:
        report(TOO_LARGE, large, whole.items[0], Sentence("split the program, or let fewer kinds of robots run it"))
    if found:
        return Projection({}, TeamPlan((), {}), found)
    projector = _Projector(sets, report, shared or (lambda call: False))
    lines = projector.seq(whole, ALL)
    made = {kind: Seq([team_call("Join"), *items]) for kind, items in sorted(lines.items())}
    return Projection(made, TeamPlan(tuple(projector.points), projector.sets.groups), found, whole)


class _Projector:
    """One pass over a team's program; `points` grow in reading order.

    `context` are those who come to an instruction; `lockstep` says that they do each line at the same time.
    """

    def __init__(self, sets: TeamSets, report: Report, shared: Shared) -> None:
        self.sets = sets
        self.shared = shared
        self.points: list[Point] = []
        self.report = report
        self.loops = 0
        """How many loops of the team are around, in the same branch."""

    # -- points

    def point(self, kind: PointKind, members: NameSet, node: Instruction, **more: Any) -> int:
        self.points.append(Point(kind, members, program=node.program or "", vertex=node.vertex, **more))
        return len(self.points) - 1

    def lead(self, number: int, first: int, last: int | None = None) -> None:
        """A yes at a point leads to the points from `first` on, to the newest one or to `last`."""
        last = len(self.points) - 1 if last is None else last
        self.points[number] = replace(self.points[number], leads=(first, last))

    def call(self, node: Instruction, method: str, *params: Number | Call) -> Call:
        return come_from(node, team_call(method, *params))

    def for_each(self, context: NameSet, node: Instruction, method: str, *params: Number | Call) -> Lines:
        return {kind: [self.call(node, method, *params)] for kind in self.sets.kinds(context)}

    def meeting(self, context: NameSet, node: Instruction) -> Lines:
        return self.for_each(context, node, "Meet", Number(self.point(PointKind.MEET, context, node)))

    # -- instructions

    def seq(self, seq: Seq, context: NameSet, *, lockstep: bool = False) -> Lines:
        lines: Lines = {kind: [] for kind in self.sets.kinds(context)}
        for node in seq.items:
            append(lines, self.instruction(node, context, lockstep))
        return lines

    def instruction(self, node: Instr, context: NameSet, lockstep: bool) -> Lines:
        match node:
            case SeqOfPar() | ParOfSeq() | Where():
                return self.block(node, context)
            case Parallel() if not lockstep or has_blocks(node):
                return self.branches(node, context)
            case While() | Conditional() | Event() if lockstep and not has_blocks(node) and not self.is_joint(node):
                return self.own_line(node, context)
            case Repeat():
                return self.repeat(node, context, lockstep)
            case While():
                return self.loop(node, context, lockstep)
            case Conditional():
                return self.conditional(node, context, lockstep)
            case Event():
                return self.event(node, context, lockstep)
            case Move():
                number = self.point(PointKind.MOVE, context, node, times=node.count, moves=(node.source, node.target))
                return self.for_each(context, node, "Move", Number(number))
            case Break():
                return self.line(node, context)
            case Wait() if not lockstep:
                return self.line(node, context)
            case _ if lockstep:
                return self.own_line(node, context)
        self.report(
            rules.NO_BLOCK,
            Sentence("this stands in no block, so nobody knows which robots do it"),
            node,
            Sentence("put it into a SeqOfPar or a ParOfSeq"),
        )
        return {}

    def is_joint(self, node: While | Conditional | Event) -> bool:
        """Whether all are to go the same way: the condition asks the team, or looks at what all know alike."""
        inside = [] if node.condition is None else nodes(node.condition)
        calls = [one for one in inside if isinstance(one, Call)]
        return any(isinstance(one, Joint) for one in inside) or all(map(self.shared, calls))

    def own_line(self, node: Instr, context: NameSet) -> Lines:
        """A line of a `SeqOfPar`, which each does for itself, and the meeting behind it."""
        self.leaves_no_loop(Seq([node]))
        lines = self.line(node, context)
        append(lines, self.meeting(context, node))
        return lines

    def line(self, node: Instr, context: NameSet) -> Lines:
        return {kind: [copy.deepcopy(node)] for kind in self.sets.kinds(context)}

    def block(self, node: Block, context: NameSet) -> Lines:
        """Lines of members; all who came to the block go on when it is over."""
        assert isinstance(node.members, Members), "no template"
        members = frozenset(node.members.names)
        number = self.point(PointKind.BLOCK, members, node)
        if isinstance(node, SeqOfPar):
            inside = self.seq(node.body, members, lockstep=True)
        else:
            self.alone(node)
            kinds = self.sets.kinds(members)
            if isinstance(node, ParOfSeq):
                inside = {kind: copy.deepcopy(node.body.items) for kind in kinds}
            else:
                one = come_from(node, Conditional(node.condition, node.then, node.orelse))
                inside = {kind: [copy.deepcopy(one)] for kind in kinds}
        self.lead(number, number + 1)
        lines: Lines = {kind: [] for kind in self.sets.kinds(context)}
        for kind, items in inside.items():
            if items and kind in lines:
                entered = come_from(node, Conditional(answer(), Seq(items)))
                lines[kind] = [self.call(node, "Enter", Number(number)), entered]
        ends = self.points[-1]
        if not (isinstance(node, SeqOfPar) and ends.kind is PointKind.MEET and ends.members == members == context):
            append(lines, self.meeting(context, node))
        return lines

    def alone(self, node: ParOfSeq | Where) -> None:
        """What each member does on its own holds nothing that members do together, and leaves no loop of the team."""
        for inner in nodes(node)[1:]:
            if isinstance(inner, Block | Move):
                self.report(
                    rules.NOT_WITHIN,
                    Sentence("here each robot does the lines on its own, and this one needs several at the same time"),
                    inner,
                    Sentence("put it before or behind this block, or make the block around it a SeqOfPar"),
                )
                return
        for body in bodies(node):
            self.leaves_no_loop(body)

    def leaves_no_loop(self, body: Seq) -> None:
        """What a robot does on its own leaves no loop of the team."""
        left = loose_break(body)
        if left is None:
            return
        message = Sentence("this BREAK would take one robot out of a loop that the team goes through together")
        help = Sentence("ask the team in the condition around it, or put it into a loop of this robot's own")
        if not self.loops:
            message = Sentence("this BREAK stands in no loop, so it would take one robot out of the team's program")
            help = Sentence("take it away, or put it into a loop of this robot's own")
        self.report(rules.ONE_LEAVES, message, left, help)

    def branches(self, node: Parallel, context: NameSet) -> Lines:
        """Each branch is for the members of its blocks; who is in one is in no other."""
        taken: set[Atom] = set()
        found: list[tuple[int, Lines]] = []
        for branch in node.branches:
            names = frozenset(
                name
                for block in nodes(branch)
                if isinstance(block, Block) and isinstance(block.members, Members)
                for name in block.members.names
            )
            first = self.sets.first_members(names)
            if not names or taken & first:
                both = sorted(atom.name for atom in taken & first)
                self.report(
                    rules.TWO_PLACES if both else rules.NO_BLOCK,
                    Sentence("{name} cannot be in two branches at the same time", both[0])
                    if both
                    else Sentence("this branch has no block, so nobody knows which robots do it"),
                    branch.items[0] if branch.items else node,
                    Sentence("give each robot one branch, in a block that names it"),
                )
                continue
            taken |= first
            number = self.point(PointKind.BRANCH, names, node)
            around, self.loops = self.loops, 0
            lines = self.seq(branch, names)
            self.loops = around
            self.lead(number, number + 1)
            if loose_break(branch) is not None:
                lines = {kind: [Parallel([Seq(items)])] for kind, items in lines.items()}
            found.append((number, lines))
        chosen: Lines = {kind: [] for kind in self.sets.kinds(context)}
        for number, lines in reversed(found):
            for kind, items in lines.items():
                if kind in chosen:
                    orelse = Seq(chosen[kind]) if chosen[kind] else None
                    enter = self.call(node, "Enter", Number(number))
                    chosen[kind] = [enter, Conditional(answer(), Seq(items), orelse)]
        append(chosen, self.meeting(context, node))
        return chosen

    # -- what is decided together

    def repeat(self, node: Repeat, context: NameSet, lockstep: bool) -> Lines:
        number = self.point(PointKind.COUNT, context, node, times=node.count)
        body = self.passed(node.body, context, lockstep)
        self.lead(number, number + 1)
        first, again = (self.for_each(context, node, "Ask", Number(number), Number(after)) for after in (0, 1))
        return self.passes(node, first, body, again)

    def passed(self, body: Seq, context: NameSet, lockstep: bool) -> Lines:
        """The body of a loop of the team."""
        self.loops += 1
        lines = self.seq(body, context, lockstep=lockstep)
        self.loops -= 1
        return lines

    def loop(self, node: While, context: NameSet, lockstep: bool) -> Lines:
        if node.condition is None:
            body = self.passed(node.body, context, lockstep)
            return {kind: [come_from(node, While(None, Seq(items)))] for kind, items in body.items()}
        asked, asks = self.ask(node.condition, context, node)
        first = len(self.points)
        body = self.passed(node.body, context, lockstep)
        self.lead_to(asks, first)
        return self.passes(node, asked, body, copy.deepcopy(asked))

    def passes(self, node: Instruction, first: Lines, body: Lines, again: Lines) -> Lines:
        """A question before each pass; the body as long as it is answered with yes."""
        return {
            kind: [*items, come_from(node, While(answer(), Seq(body[kind] + again[kind])))]
            for kind, items in first.items()
        }

    def conditional(self, node: Conditional, context: NameSet, lockstep: bool) -> Lines:
        lines, asks = self.ask(node.condition, context, node)
        first = len(self.points)
        then = self.seq(node.then, context, lockstep=lockstep)
        self.lead_to(asks, first)
        orelse = self.seq(node.orelse, context, lockstep=lockstep) if node.orelse is not None else {}
        for kind, items in lines.items():
            other = Seq(orelse[kind]) if orelse.get(kind) else None
            items.append(come_from(node, Conditional(answer(), Seq(then[kind]), other)))
        return lines

    def event(self, node: Event, context: NameSet, lockstep: bool) -> Lines:
        lines, asks = self.ask(node.condition, context, node)
        first = len(self.points)
        body = self.seq(node.body, context, lockstep=lockstep)
        # Whoever is led past an event does not wait for it again.
        self.lead_to(asks, first, MAX_NUMBER)
        for kind, items in lines.items():
            again = come_from(node, While(Not(answer()), Seq(copy.deepcopy(items))))
            lines[kind] = [*items, again, *body[kind]]
        return lines

    def lead_to(self, asks: list[tuple[int, int | None]], first: int, last: int | None = None) -> None:
        for number, earlier in asks:
            self.lead(number, first if earlier is None else earlier, last)

    def ask(
        self, condition: Condition, context: NameSet, node: Instruction, *, negated: bool = False
    ) -> tuple[Lines, list[tuple[int, int | None]]]:
        """Questions, after which `Answer` is the condition; of each, where a yes leads to if not to the body."""
        quantifier: Quantifier | Literal["one"] = ONE
        asked, test = context, condition
        match condition:
            case Not():
                return self.ask(condition.condition, context, node, negated=not negated)
            case And() | Or():
                lines, asks = self.ask(condition.left, context, node, negated=negated)
                first = len(self.points)
                right, more = self.ask(condition.right, context, node, negated=negated)
                goes_on_at_yes = isinstance(condition, And) is not negated
                for kind, items in right.items():
                    lines[kind].append(Conditional(answer() if goes_on_at_yes else Not(answer()), Seq(items)))
                if goes_on_at_yes:
                    asks = [(number, first if earlier is None else earlier) for number, earlier in asks]
                return lines, asks + more
            case Joint():
                assert isinstance(condition.members, Members), "no template"
                asked, test = frozenset(condition.members.names), condition.condition
                quantifier = condition.quantifier
        number = self.point(PointKind.ASK, context, node, asked=asked, quantifier=quantifier, negated=negated)
        lines = self.for_each(context, node, "Ask", Number(number), Number(0))
        for kind in self.sets.kinds(asked):
            if kind in lines:
                lines[kind] = [self.question(node, number, copy.deepcopy(test))]
        return lines, [(number, None)]

    def question(self, node: Instruction, number: int, test: Condition) -> Instr:
        if isinstance(test, Call):
            return self.call(node, "Ask", Number(number), test)
        yes, no = (self.call(node, "Ask", Number(number), Number(answer)) for answer in (1, 0))
        return come_from(node, Conditional(test, Seq([yes]), Seq([no])))
