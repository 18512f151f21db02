"""The parser's hand on the tokens: taking, expecting, reporting, skipping, and the comments between them."""

from __future__ import annotations

from kitrobot.diagnostics.model import Diagnostic, Fix, Rule, Source
from kitrobot.lll import rules
from kitrobot.lll.tokens import CALL, END, HOLE, NAME, NUMBER, OTHER, QUOTED, SYMBOL, Comment, Token, tokenise
from kitrobot.lll.tree import MAX_NESTING, Declaration, Instr
from kitrobot.text.forms import line_feeds
from kitrobot.text.sentences import Help, Sentence

PARTNER = {"(": ")", "[": "]", "<": ">"}
_NAMES = {
    CALL: Sentence("a call"),
    NAME: Sentence("a name"),
    QUOTED: Sentence("a name"),
    NUMBER: Sentence("a number"),
    HOLE: Sentence("a hole"),
    END: Sentence("the end of the text"),
}


class Mistake(Exception):
    """Leaves the construct being read for the nearest place that recovers; already reported.

    `recovered`: what is wrong was gone past already, and reading goes on right here.
    """

    recovered = False


class Cursor:
    """Where the reader stands in a text, how deep, and what it has found wrong so far."""

    def __init__(self, text: str, name: str, *, template: bool, team: bool | None = None) -> None:
        text = line_feeds(text)
        self.source = Source(name, text)
        self.text = text
        self.template = template
        self.tokens, self.comments, lookalikes = tokenise(text, team=team)
        self.braces = _braces(self.tokens)
        self.next_comment = 0
        self.comment_at = self.comments[0].before if self.comments else len(self.tokens)
        self.at = 0
        self.depth = 0
        self.height = 0
        self.last_end = 0
        self.found_unclosed = False
        self.guard_closer = ""
        self.diagnostics: list[Diagnostic] = []
        for start, end, meant in lookalikes:
            message = Sentence("expected `{meant}`, found `{found}`", meant, text[start:end])
            help = Sentence("these are other characters that look like it; write `{meant}`", meant)
            self.report(rules.SYNTAX, message, start, end, help, Fix(meant))

    # -- tokens

    def is_symbol(self, symbol: str) -> bool:
        token = self.tokens[self.at]
        return token[0] == SYMBOL and token[3] == symbol

    def take(self) -> Token:
        token = self.tokens[self.at]
        if token[0] != END:
            self.at += 1
        self.last_end = token[2]
        return token

    def report(
        self, rule: Rule, message: Sentence, start: int, end: int, help: Help = "", fix: Fix | None = None
    ) -> None:
        self.diagnostics.append(rule(message, self.source.place(start, end), help=help, fix=fix))

    def found(self) -> str:
        kind, start, end, _ = self.tokens[self.at]
        if kind in (END, CALL):
            return _NAMES[kind]
        shown = f"`{self.text[start : min(end, start + 24)]}`"
        return Sentence("{kind} {text}", _NAMES[kind], shown) if kind in _NAMES else shown

    def mistake(self, expected: str, help: Help = "") -> Mistake:
        _, start, end, _ = self.tokens[self.at]
        self.report(
            rules.SYNTAX, Sentence("expected {expected}, found {found}", expected, self.found()), start, end, help
        )
        return Mistake()

    def follows(self, symbol: str) -> bool:
        """Whether the token after the next one is that symbol."""
        token = self.tokens[min(self.at + 1, len(self.tokens) - 1)]
        return token[0] == SYMBOL and token[3] == symbol

    def shown(self) -> str:
        """The text of the next token."""
        _, start, end, _ = self.tokens[self.at]
        return self.text[start:end]

    def go_to(self, offset: int) -> None:
        """Goes to the first token that does not begin before an offset."""
        while self.tokens[self.at][0] != END and self.tokens[self.at][1] < offset:
            self.take()

    def past(self, mistake: Mistake, offset: int | None = None) -> Mistake:
        """A mistake that is gone past, up to an offset or as far as reading is."""
        if offset is not None:
            self.go_to(offset)
        mistake.recovered = True
        return mistake

    def go_past_brackets(self) -> None:
        """Goes behind what the next bracket or brace encloses, or to the end of the text."""
        level = 0
        while self.tokens[self.at][0] != END:
            if self.at in self.braces:
                self.at = self.braces[self.at]
            elif self.tokens[self.at][0] == SYMBOL:
                level += (self.tokens[self.at][3] in "([") - (self.tokens[self.at][3] in ")]")
            self.take()
            if level <= 0:
                return

    def expect(self, symbol: str, opened: Token | None = None) -> None:
        token = self.tokens[self.at]
        if token[0] == SYMBOL and token[3] == symbol:
            self.at += 1
            self.last_end = token[2]
            return
        if opened is not None and self.tokens[self.at][0] == END:
            if not self.found_unclosed:
                what = self.text[opened[1] : opened[2]]
                help = Sentence("put a `{symbol}` where it ends", symbol)
                self.report(
                    rules.NOT_CLOSED, Sentence("this `{what}` is never closed", what), opened[1], opened[2], help
                )
            self.found_unclosed = True
            raise Mistake
        raise self.mistake(f"`{symbol}`")

    def skip(self, stops: str) -> None:
        """Goes to the next of `stops` at this level, over whole bracketed stretches; an alien closer ends it too."""
        level = 0
        while True:
            kind, _, _, value = self.tokens[self.at]
            if kind == END:
                return
            if self.at in self.braces:
                self.at = self.braces[self.at]
            if kind == SYMBOL:
                if level == 0 and (value in stops or value == ")"):
                    return
                if value in "([":
                    level += 1
                elif value in ")]":
                    level = max(0, level - 1)
            self.take()

    def skip_guard(self, closer: str, parentheses: int) -> None:
        """Goes to the `closer` of a guard with so many open parentheses, or to what must be behind the guard."""
        brackets = opened = 0
        while True:
            kind, _, _, value = self.tokens[self.at]
            if kind == END:
                return
            if kind == SYMBOL:
                if brackets == 0 and value == closer:
                    return
                if value == ";" and opened == 0:
                    return
                if value == ")" and opened + parentheses == 0:
                    return
                if value == ")":
                    opened, parentheses = (opened - 1, parentheses) if opened else (0, parentheses - 1)
                opened += value == "("
                brackets += (value == "[") - (value == "]" and brackets > 0)
            self.take()

    def recover(self, closer: str) -> None:
        """After a mistake between brackets: goes on behind `closer`, or before `;` or the end of the guard."""
        self.skip(f"{closer};{self.guard_closer}")
        if self.is_symbol(closer):
            self.take()

    # -- comments

    # `comment_at` is the token before which the next comment stands, so that most questions are one comparison.

    def comments_before(self, index: int) -> list[Comment]:
        if self.comment_at > index:
            return []
        first = self.next_comment
        while self.comment_at <= index:
            self.go_past_comment()
        return self.comments[first : self.next_comment]

    def go_past_comment(self) -> None:
        self.next_comment += 1
        more = self.next_comment < len(self.comments)
        self.comment_at = self.comments[self.next_comment].before if more else len(self.tokens)

    def take_comment_after(self, node: Instr | Declaration) -> None:
        """Gives an instruction the comment that follows it on its line."""
        if self.comment_at > self.at or node.after is not None:
            return
        index = self.next_comment
        while index < len(self.comments) and self.comments[index].before <= self.at:
            comment = self.comments[index]
            if comment.before == self.at and comment.start >= node.end:
                if "\n" not in self.text[node.end : comment.start]:
                    node.after = comment.text
                    if index == self.next_comment:
                        self.go_past_comment()
                    else:
                        del self.comments[index]
                return
            index += 1

    def deeper(self, opened: Token) -> None:
        self.depth += 1
        if self.depth + self.height <= MAX_NESTING:
            return
        self.depth -= 1
        self.report(
            rules.TOO_DEEP,
            Sentence("the program nests more than {most} levels deep here", MAX_NESTING),
            opened[1],
            opened[2],
            Sentence("split it into parts"),
        )
        self.skip("")
        if self.tokens[self.at][0] != END:
            self.take()
        self.found_unclosed = True  # whatever stays open now was open on the way down here
        raise Mistake


def _braces(tokens: list[Token]) -> dict[int, int]:
    """Each `{` that is closed → the place of its `}` among the tokens."""
    found: dict[int, int] = {}
    opened: list[int] = []
    for at, (kind, _, _, value) in enumerate(tokens):
        if kind == OTHER and value == "{":
            opened.append(at)
        elif kind == OTHER and value == "}" and opened:
            found[opened.pop()] = at
    return found
