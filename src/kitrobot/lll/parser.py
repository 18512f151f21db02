"""Text → tree: recursive descent over the tokens, going on after every mistake.

The grammar is LL(1) and each method below is one of its lines. Three things make the parser more than the grammar:

- *Recovery.* A mistake is reported where it stands and reading goes on at the next `;`, `,` or `)` of the same level.
- *Comments.* One that follows an instruction on its line belongs to that instruction, any other to the next one, one
  with nothing after it to the body it stands in.
- *Depth.* `depth` counts open bodies, parentheses and parameters; `height` is that of the condition just read.
  Together they stay within `MAX_NESTING`, so recursion here and in every later walk over a tree is bounded by us, not
  by the host.
"""

from __future__ import annotations

from typing import Any

from kitrobot.diagnostics.model import Fix
from kitrobot.lll import habits, rules
from kitrobot.lll.cursor import Mistake
from kitrobot.lll.team_forms import TeamForms
from kitrobot.lll.tokens import CALL, END, HOLE, MARK, NAME, NUMBER, OTHER, SYMBOL, Token
from kitrobot.lll.tree import (
    Break,
    Call,
    Conditional,
    Event,
    Hole,
    Instr,
    Interrupt,
    Parallel,
    Repeat,
    Seq,
    Wait,
    While,
)
from kitrobot.text.sentences import Sentence

_WHOLE_UNITS = Sentence("numbers are whole; on most robots WAIT(10) is one second, and WAIT(1) a tenth")


class Parser(TeamForms):
    """Reads programs; each method is a line of the grammar."""

    # -- program, seq

    def program(self) -> Seq:
        seq = self.seq("")
        while self.tokens[self.at][0] != END:
            _, start, end, value = self.take()
            self.report(
                rules.SYNTAX,
                Sentence("`{symbol}` closes or separates nothing here", value),
                start,
                end,
                Sentence("take it away, or open what it should close"),
            )
            more = self.seq("")
            seq.items += more.items
            seq.below += more.below
        seq.start, seq.end = 0, len(self.text)
        return seq

    def seq(self, separators: str) -> Seq:
        """Instructions up to `)`, a separator of the construct around, or the end. Recovers at `;` by itself."""
        start = self.tokens[self.at][1]
        items: list[Instr] = []
        seq = Seq(items)
        depth, tokens = self.depth, self.tokens
        while True:
            kind, _, _, value = tokens[self.at]
            if kind == CALL:
                above = self.comments_before(self.at)
                call = self.call()
                if above or self.comment_at <= self.at:
                    self.finish(call, above)
                items.append(call)
                after = tokens[self.at]
                if after[0] == SYMBOL and after[3] == ";":
                    self.at += 1
                    self.last_end = after[2]
                    if self.comment_at <= self.at:
                        self.take_comment_after(call)
                    continue
            elif kind == SYMBOL and value == ";":
                self.take()
                if items:
                    self.take_comment_after(items[-1])
                continue
            elif kind == END or (kind == SYMBOL and value in "),"):
                break
            elif kind == HOLE and not (tokens[self.at + 1][0] == SYMBOL and tokens[self.at + 1][3] == "*"):
                self.body_hole(seq)
            else:
                above = self.comments_before(self.at)
                try:
                    node = self.instruction()
                except Mistake as mistake:
                    self.depth, self.height = depth, 0
                    if not mistake.recovered:
                        self.skip(";" + separators)
                    seq.below += [comment.text for comment in above]
                    continue
                self.finish(node, above)
                items.append(node)
            self.hint_semicolon()
        seq.below += [comment.text for comment in self.comments_before(self.at)]
        seq.start, seq.end = start, self.tokens[self.at][1]
        return seq

    def body_hole(self, seq: Seq) -> None:
        hole = self.hole()
        if seq.hole is not None:
            message = Sentence("one hole stands in a body, and `{{hole}}` stands in this one already", seq.hole.name)
            self.report(rules.SYNTAX, message, hole.start, hole.end, Sentence("give the second one a body of its own"))
        seq.hole, seq.hole_at = hole, len(seq.items)

    def finish(self, node: Instr, above: Any) -> None:
        if above:
            node.above = [comment.text for comment in above] + node.above
        self.take_comment_after(node)

    def hint_semicolon(self) -> None:
        kind, _, _, value = self.tokens[self.at]
        if kind == END or (kind == SYMBOL and value in ";),"):
            return
        if value == MARK and self.tokens[self.at + 1][0] not in (CALL, NAME, HOLE):
            return  # one that has no partner
        if kind in (CALL, NAME, NUMBER, HOLE) or value in ("*", "[", "<", "//", MARK):
            self.report(
                rules.MISSING_SEMICOLON,
                Sentence("expected `;` between two instructions"),
                self.last_end,
                self.last_end,
                Sentence("put a `;` here"),
                fix=Fix(";"),
            )

    # -- instructions

    def instruction(self) -> Instr:
        kind, start, end, value = self.tokens[self.at]
        if kind == NAME:
            if value == "WAIT":
                return self.wait()
            if value == "BREAK":
                self.take()
                return Break(start=start, end=end)
            if not self.follows("."):
                return self.without_a_dot()
            return self.call()
        if kind in (NUMBER, HOLE):
            return self.repeat()
        if kind == SYMBOL:
            if value == MARK:
                return self.interrupt()
            if value == "*":
                return self.while_()
            if value == "[":
                return self.conditional()
            if value == "<":
                return self.event()
            if value == "//":
                return self.parallel()
        if value == "!":
            raise self.mistake(
                Sentence("an instruction"), Sentence("`!( )` follows the body of a conditional: [test]( … )!( … )")
            )
        if kind == OTHER:
            self.refuse_sign(start, value)
        raise self.mistake(
            Sentence("an instruction"), Sentence("an instruction begins with a name, a number, or one of * [ < // °")
        )

    def without_a_dot(self) -> Instr:
        """A name that no method follows: a word of a team's, or of another language, or a variable that is changed."""
        _, start, end, name = self.tokens[self.at]
        if self.is_form():
            return self.form()
        if self.is_declaration():
            if self.team is not None:
                message = Sentence("`{word}` stands among instructions", name)
                self.report(rules.SYNTAX, message, start, end, Sentence("put it before the first instruction"))
            self.declaration()
            raise self.past(Mistake())
        if habits.is_reserved_in_other_letters(name):
            word = name.upper()
            message = Sentence("expected `{meant}`, found `{found}`", word, name)
            way_out = Sentence("words of the language are in capitals: {word}", word)
            self.report(rules.SYNTAX, message, start, end, way_out, Fix(word))
            if word == "WAIT":
                return self.wait()
            self.take()
            return Break(start=start, end=end)
        help = habits.keyword(name)
        if help:
            self.report(rules.SYNTAX, Sentence("`{word}` is no word of the language", name), start, end, help)
            self.go_past_construct()
            raise self.past(Mistake())
        changed = habits.change(name, self.text, end)
        if changed is not None:
            self.take()
            raise self.past(self.mistake(Sentence("`.` and a method"), changed[0]), changed[1])
        return self.call()

    def interrupt(self) -> Interrupt:
        opened = self.take()
        if self.tokens[self.at][0] not in (CALL, NAME, HOLE):
            raise self.mistake(Sentence("a call"), Sentence("write °Object.Method()° around the call"))
        action: Call | Hole = self.hole() if self.tokens[self.at][0] == HOLE else self.call()
        if not self.is_symbol(MARK):
            self.report(
                rules.NOT_CLOSED,
                Sentence("this `°` has no partner"),
                opened[1],
                opened[2],
                Sentence("write °Object.Method()° around the call"),
            )
            return Interrupt(action, start=opened[1], end=self.last_end)
        self.take()
        return Interrupt(action, start=opened[1], end=self.last_end)

    def repeat(self) -> Repeat:
        start = self.tokens[self.at][1]
        count: int | Hole = self.hole() if self.tokens[self.at][0] == HOLE else self.number()
        if not self.is_symbol("*"):
            raise self.mistake(
                Sentence("`*` after the number of times"), Sentence("write 3*( … ) to do something three times")
            )
        self.take()
        body = self.body()
        return Repeat(count, body, start=start, end=self.last_end)

    def while_(self) -> While:
        start = self.take()[1]
        if not self.is_symbol("[") and not self.is_symbol("("):
            raise self.mistake(
                Sentence("`[` or `(` after `*`"),
                Sentence("write *[test]( … ) to repeat while a test is true, or *( … ) to repeat for ever"),
            )
        self.for_ever_at = self.at + 1
        condition = self.guard("[") if self.is_symbol("[") else None
        body = self.body()
        return While(condition, body, start=start, end=self.last_end)

    def conditional(self) -> Conditional:
        start = self.tokens[self.at][1]
        condition = self.guard("[")
        then = self.body()
        orelse = None
        kind, at, end, value = self.tokens[self.at]
        if kind == NAME and value in ("else", "sinon") and not self.follows("."):
            help = Sentence("write !( … ) right after the body: [test]( … )!( … )")
            self.report(rules.SYNTAX, Sentence("expected `!`, found `{found}`", value), at, end, help, Fix("!"))
        if self.is_symbol("!") or (kind == NAME and value in ("else", "sinon") and not self.follows(".")):
            self.take()
            orelse = self.body()
        return Conditional(condition, then, orelse, start=start, end=self.last_end)

    def event(self) -> Event:
        start = self.tokens[self.at][1]
        condition = self.guard("<")
        body = self.body()
        return Event(condition, body, start=start, end=self.last_end)

    def parallel(self) -> Parallel:
        start = self.take()[1]
        opened = self.tokens[self.at]
        if not self.is_symbol("("):
            mistake = self.mistake("`(`", Sentence("//( … , … ) does things at the same time; a comment begins with #"))
            end = habits.comment_end(self.text, start)
            raise self.past(mistake, end) if not self.is_symbol(";") else mistake
        self.expect("(")
        self.deeper(opened)
        branches: list[Seq] = []
        above: list[str] = []
        while True:
            branch = self.seq(",")
            if branch.items or branch.hole:
                branches.append(branch)
            else:
                above += branch.below
            if not self.is_symbol(","):
                break
            self.take()
            if branch.items:
                self.take_comment_after(branch.items[-1])
        self.depth -= 1
        self.close(")", opened)
        return Parallel(branches, start=start, end=self.last_end, above=above)

    def wait(self) -> Wait:
        start = self.take()[1]
        opened = self.tokens[self.at]
        if not self.is_symbol("("):
            raise self.mistake("`(`", Sentence("write WAIT(10)"))
        self.expect("(")
        if self.tokens[self.at][0] not in (NUMBER, HOLE):
            self.mistake(
                Sentence("a number of time units"), habits.number_sign(self.shown()) or Sentence("write WAIT(10)")
            )
            self.recover(")")
            return Wait(0, start=start, end=self.last_end)
        try:
            self.whole(_WHOLE_UNITS)
        except Mistake:
            self.recover(")")
            return Wait(0, start=start, end=self.last_end)
        duration: int | Hole = self.hole() if self.tokens[self.at][0] == HOLE else self.number()
        if self.is_symbol(")") or self.tokens[self.at][0] == END:
            self.expect(")", opened)
        else:
            self.mistake("`)`", Sentence("WAIT takes one number"))
            self.recover(")")
        return Wait(duration, start=start, end=self.last_end)

    def body(self) -> Seq:
        if self.at in self.braces:
            self.mend_braces()
        opened = self.tokens[self.at]
        if not self.is_symbol("("):
            raise self.mistake("`(`", Sentence("what belongs to it stands in ( ): write ( … )"))
        self.expect("(")
        self.deeper(opened)
        seq = self.seq("")
        told = False
        while self.is_symbol(","):
            _, start, end, _ = self.take()
            if not told:  # those behind it are there for the same reason
                self.report(
                    rules.SYNTAX,
                    Sentence("`,` separates branches, and this is not a parallel"),
                    start,
                    end,
                    Sentence("write `;`"),
                )
            told = True
            more = self.seq("")
            seq.items += more.items
            seq.below += more.below
        self.depth -= 1
        self.close(")", opened)
        return seq

    def close(self, symbol: str, opened: Token) -> None:
        """Closes a body that was read; at the end of the text this is reported, and what was read is kept."""
        try:
            self.expect(symbol, opened)
        except Mistake:
            if self.tokens[self.at][0] != END:
                raise
