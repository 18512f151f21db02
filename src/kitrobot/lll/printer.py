"""Tree → text, in the one true layout.

Two spaces a level; every instruction ends with `;`; a body that is one simple instruction without comments stays on the
line of its head when that line fits `LINE_WIDTH`; branches are separated by a `,` behind the last `;`. Parentheses in
conditions stand only where the tree needs them. Printing sets `start` and `end` (and `method_start`) of every node to
its place in the new text, so that what is found out about the tree can be shown in the text.
"""

from __future__ import annotations

from kitrobot.lll.tokens import MARK, team_name
from kitrobot.lll.tree import (
    FAILURES,
    And,
    AnyDeclaration,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    GroupDeclaration,
    Hole,
    Instr,
    Interrupt,
    Joint,
    Members,
    Move,
    Not,
    Number,
    Or,
    Parallel,
    Param,
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

LINE_WIDTH = 60
"""Characters a line may have for a body to stay on it; the studio shows this many without wrapping."""

_SIMPLE = (Call, Interrupt, Wait, Break, ProgramCall, Move)


def print_program(program: Seq) -> str:
    """The text of a program. Sets the places of its nodes. Ends with a line break unless the program is empty."""
    printer = _Printer()
    printer.seq(program, 0)
    for comment in program.below:
        printer.comment(comment, 0)
    program.start, program.end = 0, printer.at
    return "".join(printer.parts)


def print_team_program(program: TeamProgram) -> str:
    """The text of a team's program: a line a declaration, an empty line, and the instructions. Sets all places."""
    printer = _Printer()
    for declaration in program.declarations:
        printer.declaration(declaration)
    if program.declarations and (program.seq.items or program.seq.below):
        printer.write("\n")
    program.seq.start = printer.at
    printer.seq(program.seq, 0)
    for comment in program.seq.below:
        printer.comment(comment, 0)
    program.start, program.end = 0, printer.at
    program.seq.end = printer.at
    return "".join(printer.parts)


def print_declaration(declaration: AnyDeclaration) -> str:
    """One declaration, without its comments and its `;`."""
    printer = _Printer()
    printer.declared(declaration)
    return "".join(printer.parts)


def print_members(members: Members) -> str:
    """A set as it is written."""
    names = ", ".join(map(team_name, members.names))
    return f"{{{names}}}" if members.braced or len(members.names) != 1 else names


def print_template(template: Seq | Instr | Condition) -> str:
    """The text of a template: instructions as a program, a condition on one line without a line break."""
    if isinstance(template, (And, Or, Not, Joint, Hole)):
        printer = _Printer()
        printer.condition(template, 0)
        return "".join(printer.parts)
    return print_program(template if isinstance(template, Seq) else Seq([template]))


class _Printer:
    def __init__(self) -> None:
        self.parts: list[str] = []
        self.at = 0

    def write(self, text: str) -> None:
        self.parts.append(text)
        self.at += len(text)

    def comment(self, text: str, level: int) -> None:
        self.write("  " * level + (f"# {text}".rstrip()) + "\n")

    def seq(self, seq: Seq, level: int, separator: str = "") -> None:
        """The lines of a body. `separator` follows the last instruction's `;` (the `,` between branches)."""
        last = len(seq.items) - 1
        indent = "  " * level
        for index, node in enumerate(seq.items):
            if seq.hole is not None and seq.hole_at == index:
                self.write(f"{indent}{{{seq.hole.name}}};\n")
            for comment in node.above:
                self.comment(comment, level)
            self.write(indent)
            self.instruction(node, level)
            self.write(";" + separator if index == last else ";")
            if node.after is not None:
                self.write(f"  # {node.after}".rstrip())
            self.write("\n")
        if seq.hole is not None and seq.hole_at > last:
            self.write(f"{indent}{{{seq.hole.name}}};{separator}\n")

    def instruction(self, node: Instr, level: int) -> None:
        node.start = self.at
        match node:
            case Call():
                self.call(node)
            case Interrupt():
                self.write(MARK)
                self.param(node.call)
                self.write(MARK)
            case Repeat():
                self.write(f"{_number(node.count)}*(")
                self.body(node.body, level)
                self.write(")")
            case While():
                if node.condition is not None:
                    self.guarded("*[", node.condition, "](", node.body, level)
                else:
                    self.write("*(")
                    self.body(node.body, level)
                    self.write(")")
            case Event():
                self.guarded("<", node.condition, ">(", node.body, level)
            case Conditional():
                self.conditional(node, level)
            case Parallel():
                self.parallel(node, level)
            case Wait():
                self.write(f"WAIT({_number(node.duration)})")
            case Break():
                self.write("BREAK")
            case SeqOfPar() | ParOfSeq():
                self.block("SeqOfPar " if isinstance(node, SeqOfPar) else "ParOfSeq ", node.members)
                self.write(" (")
                self.body(node.body, level)
                self.write(")")
            case Where():
                self.block("Where ", node.members)
                self.write(" ")
                self.conditional(node, level)
            case ProgramCall():
                self.write(f"PROGRAM {_name(node.name)}")
            case Move():
                self.write(f"MOVE {_number(node.count)} {_name(node.source)} -> {_name(node.target)}")
        node.end = self.at

    def block(self, word: str, members: Members | Hole) -> None:
        """A word and the set that it is for."""
        self.write(word)
        members.start = self.at
        self.write(print_members(members) if isinstance(members, Members) else f"{{{members.name}}}")
        members.end = self.at

    def declaration(self, node: AnyDeclaration) -> None:
        for comment in node.above:
            self.comment(comment, 0)
        node.start = self.at
        self.declared(node)
        node.end = self.at
        self.write(";" if node.after is None else f";  # {node.after}".rstrip())
        self.write("\n")

    def declared(self, node: AnyDeclaration) -> None:
        match node:
            case RoleDeclaration():
                self.write(f"role {team_name(node.name)}: {team_name(node.robot)}")
                if node.least != node.most:
                    self.write(f" {node.least}..{node.most}")
                elif node.most != 1:
                    self.write(f" {node.most}")
            case GroupDeclaration():
                self.block(f"group {team_name(node.name)} = ", node.members)
                self.write("" if node.failure == FAILURES[0] else f" on failure {node.failure}")
            case WorkDeclaration():
                lease = "" if node.lease is None else f" lease {node.lease}"
                self.write(f"work {team_name(node.name)} = {node.units}{lease}")

    def guarded(self, opener: str, condition: Condition, between: str, body: Seq, level: int) -> None:
        self.write(opener)
        self.condition(condition, 0)
        self.write(between)
        self.body(body, level)
        self.write(")")

    def conditional(self, node: Conditional | Where, level: int) -> None:
        self.write("[")
        self.condition(node.condition, 0)
        self.write("](")
        if node.orelse is None:
            self.body(node.then, level)
        else:
            both = len(")!(") + len(");") + self.at - self.line_start()
            sides = [_inline(side) for side in (node.then, node.orelse)]
            texts = [side for side in sides if side is not None]
            together = len(texts) == 2 and both + sum(map(len, texts)) <= LINE_WIDTH
            self.body(node.then, level, inline=together)
            self.write(")!(")
            self.body(node.orelse, level, inline=together)
        self.write(")")

    def parallel(self, node: Parallel, level: int) -> None:
        self.write("//(")
        if node.branches:
            self.write("\n")
            last = len(node.branches) - 1
            for index, branch in enumerate(node.branches):
                branch.start = self.at
                separator = "" if index == last else ","
                self.seq(branch, level + 1, "" if branch.below else separator)
                for comment in branch.below:
                    self.comment(comment, level + 1)
                if branch.below and separator:  # behind the comments, or they would belong to the next branch
                    self.write("  " * (level + 1) + separator + "\n")
                branch.end = self.at
            self.write("  " * level)
        self.write(")")

    def line_start(self) -> int:
        """Where the current line begins; it was begun by one of the last few parts."""
        back = self.at
        for part in reversed(self.parts):
            if part.endswith("\n"):
                return back
            back -= len(part)
        return 0

    def body(self, seq: Seq, level: int, inline: bool | None = None) -> None:
        seq.start = self.at
        if seq.hole is not None and not seq.items:
            self.write(f"{{{seq.hole.name}}}")
        elif seq.items or seq.below:
            text = _inline(seq)
            if inline is None:
                inline = text is not None and self.at - self.line_start() + len(text) + len(");") <= LINE_WIDTH
            if inline and text is not None:
                if seq.items:
                    self.write(" ")
                    self.instruction(seq.items[0], level)
                    self.write("; ")
            else:
                self.write("\n")
                self.seq(seq, level + 1)
                for comment in seq.below:
                    self.comment(comment, level + 1)
                self.write("  " * level)
        seq.end = self.at

    def condition(self, node: Condition, binding: int) -> None:
        """`binding`: 0 nothing around, 1 left or right of `|`, 2 right of `|` or beside `&`, 3 right of `&`."""
        if isinstance(node, (Or, And)):
            own = 1 if isinstance(node, Or) else 2
            if binding > own:
                self.write("(")
            node.start = self.at
            self.condition(node.left, own)
            self.write(" | " if own == 1 else " & ")
            self.condition(node.right, own + 1)
            node.end = self.at
            if binding > own:
                self.write(")")
        elif isinstance(node, (Not, Joint)):
            node.start = self.at
            if isinstance(node, Joint):
                self.block(f"{node.quantifier} ", node.members)
                self.write(" (")
            else:
                self.write("!(")
            self.condition(node.condition, 0)
            self.write(")")
            node.end = self.at
        else:
            self.param(node)

    def param(self, node: Param) -> None:
        node.start = self.at
        if isinstance(node, Call):
            self.call(node)
        elif isinstance(node, Number):
            self.write(str(node.value))
        else:
            self.write(f"{{{node.name}}}")
        node.end = self.at

    def call(self, node: Call) -> None:
        node.start = self.at
        node.method_start = self.at + len(node.object) + 1
        params = node.params
        if not node.object:
            self.write("")  # a place that nothing fills yet
        elif not params:
            self.write(f"{node.object}.{node.method}()")
        elif len(params) == 1 and isinstance(number := params[0], Number):
            text = f"{node.object}.{node.method}({number.value})"
            self.write(text)
            number.end = self.at - 1
            number.start = number.end - len(str(number.value))
        else:
            self.write(f"{node.object}.{node.method}(")
            for index, param in enumerate(params):
                if index:
                    self.write(", ")
                self.param(param)
            self.write(")")
        node.end = self.at


def _number(value: int | Hole) -> str:
    return str(value) if isinstance(value, int) else f"{{{value.name}}}"


def _name(name: str | Hole) -> str:
    return team_name(name) if isinstance(name, str) else f"{{{name.name}}}"


def _inline(seq: Seq) -> str | None:
    """The text of a body that may stay on its head's line, or None."""
    if seq.below or seq.hole is not None or len(seq.items) > 1:
        return None
    if not seq.items:
        return ""
    node = seq.items[0]
    if not isinstance(node, _SIMPLE) or node.above or node.after is not None:
        return None
    trial = _Printer()
    trial.instruction(node, 0)
    return f" {''.join(trial.parts)}; "
