"""Going past, or reading all the same, what belongs to another language; `habits` has the sentences for it."""

from __future__ import annotations

from kitrobot.lll import habits, rules
from kitrobot.lll.cursor import Cursor, Mistake
from kitrobot.lll.tokens import CALL, END, NAME, NUMBER, OTHER, SYMBOL
from kitrobot.text.sentences import Sentence

_WHOLE = Sentence("numbers are whole; where one is too coarse, look for a smaller unit")


class Foreign(Cursor):
    """What the reader does where it meets another language."""

    def go_past_construct(self) -> None:
        """Goes past a construct of another language: its head, and its bodies that are in brackets."""
        line_end = self.text.find("\n", self.tokens[self.at][2])
        self.take()
        grouped = False
        while True:
            kind, start, _, value = self.tokens[self.at]
            is_opener = (kind == SYMBOL and value in "([") or self.at in self.braces
            if kind == END or (kind == SYMBOL and value in ";),"):
                return
            if not is_opener and -1 < line_end < start:
                return
            if kind == OTHER and value.endswith(":"):
                self.take()
                return
            if is_opener:
                in_braces = self.at in self.braces
                self.go_past_brackets()
                follows = self.tokens[self.at]
                if follows[0] == NAME and follows[3] in ("else", "elif"):
                    line_end = self.text.find("\n", follows[2])
                elif in_braces:
                    return
                grouped = True
                continue
            if grouped and kind in (CALL, NAME, NUMBER) and value not in ("else", "elif", "then"):
                return
            self.take()

    def refuse_sign(self, start: int, sign: str) -> None:
        """Refuses what no instruction begins with, where it is known what was meant."""
        end = habits.comment_end(self.text, start)
        if end is not None:
            raise self.past(self.mistake(Sentence("an instruction"), Sentence("a comment begins with #")), end)
        if self.at in self.braces:
            mistake = self.mistake(
                Sentence("an instruction"), Sentence("a body stands in ( ), behind what it belongs to")
            )
            self.go_past_brackets()
            raise self.past(mistake)
        if sign == "}":
            mistake = self.mistake(Sentence("an instruction"), Sentence("take it away, or open what it should close"))
            self.take()
            raise self.past(mistake)

    def mend_braces(self) -> None:
        """Reads the braces around a body as parentheses."""
        close = self.braces.pop(self.at)
        self.mistake("`(`", Sentence("a body stands in ( ), not in { }"))
        for at, sign in ((self.at, "("), (close, ")")):
            _, start, end, _ = self.tokens[at]
            self.tokens[at] = (SYMBOL, start, end, sign)

    def whole(self, help: Sentence = _WHOLE) -> None:
        """Refuses a decimal number that stands next."""
        (kind, start, _, _), behind = self.tokens[self.at], self.tokens[min(self.at + 2, len(self.tokens) - 1)]
        if kind == NUMBER and self.follows(".") and behind[0] == NUMBER:
            message = Sentence("expected a whole number, found `{found}`", self.text[start : behind[2]])
            self.report(rules.SYNTAX, message, start, behind[2], help)
            self.go_to(behind[2])
            raise Mistake

    def refuse_word(self, word: str) -> None:
        """Refuses a name alone as a parameter, where it is known what was meant."""
        if word.lower() in habits.TRUTH:
            raise self.mistake(Sentence("a parameter"), Sentence("write 1 for true and 0 for false"))
        behind = self.tokens[self.at + 1]
        shown = self.text[behind[1] : behind[2]]
        if behind[0] == OTHER and shown[:1] == "=" and shown[:2] != "==":
            raise self.mistake(Sentence("a parameter"), Sentence("write what is given alone, without its name"))
        if behind[0] == OTHER or shown in ("*", "/"):
            help = habits.behind_a_number(shown)
            self.take()
            raise self.mistake(Sentence("`.` and a method"), help or Sentence("write {object}.Method()", word))
        if shown in (",", ")"):
            self.take()
            raise self.mistake(
                Sentence("`.` and a method"), Sentence("write {object}.Value() for the number that it holds", word)
            )
