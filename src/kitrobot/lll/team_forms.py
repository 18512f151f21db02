"""The part of the grammar that only a team's programs have: declarations, blocks, and what they stand for.

Every word of it is one only where no dot follows, so that an object may have its name. In the program of one robot a
form is read whole and kept in the tree, and told as one mistake, whatever else is wrong with it.
"""

from __future__ import annotations

from typing import cast

from kitrobot.lll import rules
from kitrobot.lll.cursor import Mistake
from kitrobot.lll.expressions import Expressions
from kitrobot.lll.tokens import END, HOLE, NAME, NUMBER, OTHER, QUOTED, TEAM_DECLARATIONS, TEAM_FORMS
from kitrobot.lll.tree import (
    FAILURES,
    QUANTIFIERS,
    Condition,
    Failure,
    GroupDeclaration,
    Hole,
    Joint,
    Members,
    Move,
    ParOfSeq,
    ProgramCall,
    Quantifier,
    RoleDeclaration,
    Seq,
    SeqOfPar,
    TeamInstr,
    TeamProgram,
    Where,
    WorkDeclaration,
)
from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import Help, Sentence

_SET = Sentence("a set is a name, or several: {a, b}")
_WAY_OUT = Sentence("put it into the team's program, and what one robot does into the program of that robot")
_ON_FAILURE = Sentence("write on failure drop, on failure substitute or on failure abort")


class TeamForms(Expressions):
    """Reads the forms of a team's programs; each method is a line of the grammar."""

    team: TeamProgram | None = None
    """Where declarations go; None in a program of one robot."""

    in_form = told = False
    """Whether a form that is a mistake is being read; whether one was reported."""

    def body(self) -> Seq:
        """What stands in `( )`."""
        raise NotImplementedError  # given by the parser

    # -- forms

    def is_form(self) -> bool:
        """Whether an instruction of a team begins here; the next token is a name that no dot follows."""
        return self.tokens[self.at][3] in TEAM_FORMS and (self.team is not None or self.names_follow())

    def is_joint(self) -> bool:
        """Whether a joint condition begins here."""
        kind, _, _, value = self.tokens[self.at]
        return kind == NAME and value in QUANTIFIERS and not self.follows(".") and self.names_follow()

    def names_follow(self) -> bool:
        """Whether a name or a set, or a number, stands behind the next token."""
        kind, _, _, value = self.tokens[self.at + 1]
        return kind in (NAME, QUOTED, HOLE, NUMBER) or (kind == OTHER and value == "{")

    def form(self) -> TeamInstr:
        """The instruction of a team that begins here."""
        known = self.begin_form()
        try:
            return self.team_instruction()
        finally:
            self.end_form(known)

    def begin_form(self) -> int | None:
        """In the program of one robot, reports the first form of a team; how many mistakes there are then."""
        if self.team is not None or self.template or self.in_form:
            return None
        _, start, end, word = self.tokens[self.at]
        message = Sentence("`{form}` stands in a team's program; this is the program of one robot", word)
        if not self.told:
            self.report(rules.TEAM_FORM, message, start, end, _WAY_OUT)
        self.in_form = self.told = True
        return len(self.diagnostics)

    def end_form(self, known: int | None) -> None:
        """Forgets what is wrong with a form that is a mistake itself."""
        if known is not None:
            self.in_form = False
            del self.diagnostics[known:]

    def team_instruction(self) -> TeamInstr:
        _, start, _, word = self.take()
        if word == "PROGRAM":
            name = self.name(Sentence("write PROGRAM and the name of a program"))
            return ProgramCall(name, start=start, end=self.last_end)
        if word == "MOVE":
            return self.move(start)
        members = self.members()
        if word == "Where":
            if not self.is_symbol("["):
                raise self.mistake("`[`", Sentence("write Where carriers [test]( … )"))
            condition = self.guard("[")
            then, orelse = self.body(), None
            if self.is_symbol("!"):
                self.take()
                orelse = self.body()
            return Where(members, condition, then, orelse, start=start, end=self.last_end)
        made = SeqOfPar if word == "SeqOfPar" else ParOfSeq
        body = self.body()
        return made(members, body, start=start, end=self.last_end)

    def move(self, start: int) -> Move:
        help = Sentence("write MOVE 1 helpers -> carriers")
        if self.tokens[self.at][0] not in (NUMBER, HOLE):
            raise self.mistake(Sentence("a number of members"), help)
        count: int | Hole = self.hole() if self.tokens[self.at][0] == HOLE else self.number()
        source = self.name(help)
        if not (self.shown() == "-" and self.follows(">")):
            raise self.mistake("`->`", help)
        self.take()
        self.take()
        target = self.name(help)
        return Move(count, source, target, start=start, end=self.last_end)

    def joint(self) -> Joint:
        known = self.begin_form()
        try:
            _, start, _, word = self.take()
            members = self.members()
            opened = self.tokens[self.at]
            if not self.is_symbol("("):
                raise self.mistake("`(`", Sentence("write {quantifier} carriers (test)", word))
            self.expect("(")
            self.deeper(opened)
            condition: Condition = self.condition()
            self.depth -= 1
            self.expect(")", opened)
            self.height += 1
            return Joint(cast("Quantifier", word), members, condition, start=start, end=self.last_end)
        finally:
            self.end_form(known)

    # -- names

    def name(self, help: Help) -> str | Hole:
        if self.tokens[self.at][0] == HOLE and self.template:
            return self.hole()
        return self.plain_name(help)

    def plain_name(self, help: Help) -> str:
        kind, _, _, value = self.tokens[self.at]
        if kind not in (NAME, QUOTED):
            raise self.mistake(Sentence("a name"), help)
        self.take()
        return str(value)

    def members(self) -> Members | Hole:
        if self.tokens[self.at][0] == HOLE and self.template:
            return self.hole()
        return self.set_of_names()

    def set_of_names(self) -> Members:
        kind, start, end, value = self.tokens[self.at]
        if kind == HOLE:
            self.take()
            return Members([value], start=start, end=end)
        if not (kind == OTHER and value == "{"):
            name = self.plain_name(_SET)
            return Members([name], braced=False, start=start, end=self.last_end)
        self.take()
        names = [self.plain_name(_SET)]
        while self.is_symbol(","):
            self.take()
            names.append(self.plain_name(_SET))
        if self.shown() != "}":
            raise self.mistake(Sentence("`,` or `}`"), _SET)
        self.take()
        return Members(names, start=start, end=self.last_end)

    def whole_set(self) -> Members | None:
        """The set that is the whole text; None if it is none."""
        try:
            members = self.set_of_names()
        except Mistake:
            return None
        return members if self.tokens[self.at][0] == END else None

    # -- declarations

    def is_declaration(self) -> bool:
        """Whether a declaration begins here."""
        kind, _, _, value = self.tokens[self.at]
        if kind != NAME or value not in TEAM_DECLARATIONS or self.follows("."):
            return False
        return self.team is not None or self.tokens[self.at + 1][0] in (NAME, QUOTED)

    def declarations(self) -> None:
        """All that stand here, each with its comments."""
        while True:
            while self.is_symbol(";"):
                self.take()
            if not self.is_declaration():
                return
            self.declaration()

    def declaration(self) -> None:
        """One declaration, up to its `;`. Its mistakes are reported, and it is kept if it has a meaning."""
        known = self.begin_form()
        above = [comment.text for comment in self.comments_before(self.at)]
        _, start, _, word = self.take()
        try:
            made = self.role() if word == "role" else self.group() if word == "group" else self.work()
            made.start, made.end, made.above = start, self.last_end, above
        except Mistake:
            self.skip(";")
            made = None
        self.end_form(known)
        if made is not None and not self.is_symbol(";") and self.tokens[self.at][0] != END:
            self.mistake("`;`", Sentence("put a `;` where it ends"))
            self.skip(";")
        if self.is_symbol(";"):
            self.take()
        if made is None or self.team is None:
            return
        self.take_comment_after(made)
        rows: list[object] = getattr(self.team, f"{word}s")
        rows.append(made)

    def role(self) -> RoleDeclaration:
        help = Sentence("write role carriers: carrier 2..5")
        name = self.plain_name(help)
        self.sign(":", help)
        robot = self.plain_name(help)
        if self.tokens[self.at][0] != NUMBER:
            return RoleDeclaration(name, robot)
        at = self.tokens[self.at]
        least = most = self.number()
        if self.is_symbol("."):
            self.take()
            self.expect(".")
            most = self.number()
        if least > most:
            message = Sentence("expected the smaller number first, found {least}..{most}", least, most)
            self.report(rules.SYNTAX, message, at[1], self.last_end, help)
        return RoleDeclaration(name, robot, min(least, most), most)

    def group(self) -> GroupDeclaration:
        help = Sentence("write group helpers = {carriers, loader}")
        name = self.plain_name(help)
        self.sign("=", help)
        members = self.set_of_names()
        if self.shown() != "on":
            return GroupDeclaration(name, members)
        self.take()
        if self.shown() != "failure":
            raise self.mistake("`failure`", _ON_FAILURE)
        self.take()
        if self.shown() not in FAILURES:
            raise self.mistake(one_of(f"`{word}`" for word in FAILURES), _ON_FAILURE)
        return GroupDeclaration(name, members, cast("Failure", self.take()[3]))

    def work(self) -> WorkDeclaration:
        help = Sentence("write work Boxes = 12, or work Boxes = 12 lease 60 for units that are free again after 60 s")
        kind, _, _, name = self.tokens[self.at]
        if kind != NAME or "-" in name:
            raise self.mistake(Sentence("a name that calls can have"), help)
        self.take()
        self.sign("=", help)
        units = self.number()
        if self.shown() != "lease":
            return WorkDeclaration(name, units)
        self.take()
        return WorkDeclaration(name, units, self.number())

    def sign(self, sign: str, help: Help) -> None:
        if self.shown() != sign:
            raise self.mistake(f"`{sign}`", help)
        self.take()
