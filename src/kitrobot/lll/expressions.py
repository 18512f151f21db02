"""Conditions, parameters and calls: the part of the grammar inside the brackets."""

from __future__ import annotations

from kitrobot.lll import habits, rules
from kitrobot.lll.cursor import PARTNER, Mistake
from kitrobot.lll.foreign import Foreign
from kitrobot.lll.tokens import CALL, END, HOLE, MARK, NAME, NUMBER, RESERVED, SYMBOL, Token
from kitrobot.lll.tree import (
    MAX_NESTING,
    MAX_NUMBER,
    And,
    Call,
    Condition,
    Conditional,
    Hole,
    Joint,
    Not,
    Number,
    Or,
    Param,
)
from kitrobot.text.sentences import Help, Sentence

_BEHIND_A_CALL = frozenset((";", ",", ")", "]", ">", "&", "|", MARK))


class Expressions(Foreign):
    """Reads what stands in `[ ]`, `< >` and `( )` of calls; each method is a line of the grammar."""

    def conditional(self) -> Conditional:
        """The instruction; here only because people write one where a condition belongs."""
        raise NotImplementedError  # given by the parser

    def is_joint(self) -> bool:
        """Whether a joint condition begins here."""
        raise NotImplementedError  # given by the forms of teams

    def joint(self) -> Joint:
        """A condition that a team is asked."""
        raise NotImplementedError  # given by the forms of teams

    for_ever_at = -1
    """The token at which the condition of a `*[ ]( )` begins, if one was begun."""

    # -- conditions

    def whole_condition(self) -> Condition | None:
        try:
            condition = self.condition()
            if self.tokens[self.at][0] != END:
                raise self.mistake(Sentence("the end of the condition"))
        except Mistake:
            return None
        return condition

    def guard(self, opener: str) -> Condition:
        opened = self.tokens[self.at]
        self.expect(opener)
        depth, closer, around = self.depth, PARTNER[opener], self.guard_closer
        self.guard_closer = closer
        try:
            condition = self.condition()
            self.height = 0
            compared = closer == ">" and self.is_symbol(">") and self.tokens[self.at + 1][0] == NUMBER
            if compared or (not self.is_symbol(closer) and self.tokens[self.at][0] != END):
                raise self.behind_a_test(condition, closer)
        except Mistake:
            self.skip_guard(closer, self.depth - depth)
            self.depth, self.height = depth, 0
            if not self.is_symbol(closer):
                raise
            condition = Call("", "", start=opened[1], end=self.last_end)
        finally:
            self.guard_closer = around
        self.expect(closer, opened)
        return condition

    def behind_a_test(self, test: Condition, closer: str) -> Mistake:
        """Something else than a sign that joins tests or closes the guard."""
        name = test.object if isinstance(test, Call) and test.object else "Object"
        found = habits.comparison(name, self.text, self.tokens[self.at][1])
        help, end = found if found is not None else (habits.joint(self.shown()), 0)
        mistake = self.mistake(Sentence("`&`, `|` or `{closer}`", closer), help)
        self.go_to(end)
        return mistake

    def condition(self) -> Condition:
        return self.chain("|")

    def chain(self, operator: str) -> Condition:
        start = self.tokens[self.at][1]
        left = self.chain("&") if operator == "|" else self.unary()
        height = self.height
        while self.is_symbol(operator):
            opened = self.take()
            if self.is_symbol(operator):
                self.mistake(Sentence("a condition"), Sentence("one {operator} is enough", operator))
                self.take()
            right = self.chain("&") if operator == "|" else self.unary()
            height = max(height, self.height) + 1
            self.height = 0
            if self.depth + height > MAX_NESTING:
                self.deeper_condition(opened)
            made = Or if operator == "|" else And
            left = made(left, right, start=start, end=self.last_end)
        self.height = height
        return left

    def deeper_condition(self, opened: Token) -> None:
        self.report(
            rules.TOO_DEEP,
            Sentence("this condition joins tests more than {most} levels deep", MAX_NESTING),
            opened[1],
            opened[2],
            Sentence("split it, or keep a part of it in a variable"),
        )
        raise Mistake

    def unary(self) -> Condition:
        self.height = 0
        kind, start, _, value = self.tokens[self.at]
        if kind == NAME and not self.follows("."):
            if self.is_joint():
                return self.joint()
            if value.lower() in habits.TRUTH:
                raise self.mistake(Sentence("a condition"), self.no_condition())
            if value.lower() in ("not", "non"):
                raise self.mistake(Sentence("a condition"), Sentence("write !( … ) around the test"))
        if kind in (CALL, NAME):
            call = self.call()
            self.height = _levels(call)
            return call
        if kind == HOLE:
            return self.hole()
        if kind == SYMBOL:
            if value in ("!", "("):
                if value == "!":
                    self.take()
                opened = self.tokens[self.at]
                if not self.is_symbol("("):
                    raise self.mistake("`(`", Sentence("write !( … ) around the test"))
                self.expect("(")
                self.deeper(opened)
                condition = self.condition()
                self.depth -= 1
                self.expect(")", opened)
                if value == "(":
                    return condition
                self.height += 1
                return Not(condition, start=start, end=self.last_end)
            if value == "[":
                return self.conditional_as_condition()
        raise self.mistake(Sentence("a condition"), self.no_condition())

    def no_condition(self) -> Help:
        """What to write where no condition stands."""
        if self.at == self.for_ever_at and self.shown() not in ("0", "false"):
            return Sentence("leave the [ ] out to repeat for ever: *( … )")
        return Sentence("a condition is a test such as Button.IsPressed(), joined with & and |")

    def conditional_as_condition(self) -> Condition:
        """Table 1 uses one name for two things, so people may try this; the test inside is what they meant."""
        self.deeper(self.tokens[self.at])
        whole = self.conditional()
        self.depth -= 1
        self.report(
            rules.CONDITIONAL_AS_CONDITION,
            Sentence("a whole conditional `[…](…)` cannot be a condition"),
            whole.start,
            whole.end,
            Sentence("write only the test that stands in its [ ]"),
        )
        return whole.condition

    # -- calls

    def call(self) -> Call:
        kind, start, end, value = self.tokens[self.at]
        if kind == CALL:
            self.at += 1
            self.last_end = end
            name, method, method_start, numbers, numbers_start = value
            literals = self.numbers(numbers, numbers_start) if numbers else []
            call = Call(name, method, literals, start=start, end=end, method_start=method_start)
            if name in RESERVED or method in RESERVED:
                self.reserved(name if name in RESERVED else method, start, end)
            return call
        if kind != NAME:
            raise self.mistake(Sentence("a call"), Sentence("a call is Object.Method(parameters)"))
        self.take()
        if value in RESERVED:
            self.reserved(value, start, end)
        if not self.is_symbol("."):
            compared = habits.comparison(value, self.text, end)
            if compared is not None:
                mistake = self.mistake(Sentence("`.` and a method"), compared[0])
                self.go_to(compared[1])
                raise mistake
            if self.is_symbol("("):
                raise self.mistake(
                    Sentence("`.` and a method"), Sentence("say whose method it is, as in Object.{method}()", value)
                )
            raise self.mistake(Sentence("`.` and a method"), Sentence("write {object}.Method()", value))
        self.take()
        if self.tokens[self.at][0] == CALL:  # `A.B.c()`: what follows the dot was read as a call of its own
            raise self.mistake(
                Sentence("a method's name and its parameters"), Sentence("a call has one dot: Object.Method()")
            )
        _, method_start, method_end, method = self.tokens[self.at]
        if self.tokens[self.at][0] != NAME:
            raise self.mistake(Sentence("a method's name"))
        self.take()
        if method in RESERVED:
            self.reserved(method, method_start, method_end)
        after = self.tokens[self.at]
        if after[0] == SYMBOL and after[3] in _BEHIND_A_CALL:  # as if `()` were there
            self.mistake("`(`", Sentence("write {object}.{method}()", value, method))
            return Call("", "", start=start, end=self.last_end, method_start=start)
        if not self.is_symbol("("):
            raise self.mistake("`(`", Sentence("write {object}.{method}( … )", value, method))
        params = self.params()
        if params is None:
            return Call("", "", start=start, end=self.last_end, method_start=start)
        return Call(value, method, params, start=start, end=self.last_end, method_start=method_start)

    def reserved(self, word: str, start: int, end: int) -> None:
        self.report(
            rules.RESERVED_WORD,
            Sentence("`{word}` is a word of the language, not a name", word),
            start,
            end,
            Sentence("choose another name"),
        )

    def numbers(self, numbers: str, start: int) -> list[Param]:
        """The parameters of a CALL token: `50`, or `25, 50`."""
        if numbers.isdigit():
            return [self.literal(numbers, start)]
        params: list[Param] = []
        for number in numbers.split(","):
            digits = number.strip()
            at = self.text.index(digits, start)
            params.append(self.literal(digits, at))
            start = at + len(digits)
        return params

    def literal(self, digits: str, start: int) -> Number:
        end = start + len(digits)
        value = int(digits) if len(digits) < 5 else self.value(digits, start, end)
        return Number(value, start=start, end=end)

    def value(self, digits: str, start: int, end: int) -> int:
        significant = digits.lstrip("0")
        if len(significant) <= 5 and (value := int(significant or "0")) <= MAX_NUMBER:
            return value
        shown = digits if len(digits) <= 20 else digits[:17] + "…"
        self.report(
            rules.NUMBER_TOO_LARGE,
            Sentence("expected a number from 0 to {largest}, found {found}", MAX_NUMBER, shown),
            start,
            end,
        )
        return 1  # what was meant is not known; this offends no other rule

    def number(self) -> int:
        self.whole()
        kind, start, end, value = self.tokens[self.at]
        if kind != NUMBER:
            raise self.mistake(Sentence("a number"))
        self.take()
        return self.value(value, start, end)

    def params(self) -> list[Param] | None:
        """None when they could not be read (already reported)."""
        opened = self.tokens[self.at]
        self.expect("(")
        params: list[Param] = []
        if self.is_symbol(")"):
            self.take()
            return params
        self.deeper(opened)
        depth = self.depth
        try:
            while True:
                params.append(self.param())
                if not self.is_symbol(","):
                    break
                self.take()
            if not self.is_symbol(")") and self.tokens[self.at][0] != END:
                raise self.mistake(Sentence("`,` or `)` after a parameter"), habits.behind_a_number(self.shown()))
        except Mistake:
            if self.tokens[self.at][0] == END:
                raise
            self.depth = depth - 1
            self.recover(")")
            return None
        self.depth -= 1
        self.expect(")", opened)
        return params

    def param(self) -> Param:
        self.whole()
        kind, start, _, value = self.tokens[self.at]
        if kind == NAME and not self.follows("."):
            self.refuse_word(value)
        if kind == NUMBER:
            self.take()
            return self.literal(value, start)
        if kind in (CALL, NAME):
            return self.call()
        if kind == HOLE:
            return self.hole()
        usual = Sentence("a parameter is a number from 0 to 65535 or a call such as Captor.Value()")
        raise self.mistake(Sentence("a parameter"), habits.number_sign(self.shown()) or usual)

    def hole(self) -> Hole:
        _, start, end, name = self.take()
        if not self.template:
            self.report(
                rules.HOLE_IN_PROGRAM,
                Sentence("`{{hole}}` is a hole, and only a constructor's template has holes", name),
                start,
                end,
                Sentence("write what should stand here"),
            )
        return Hole(name, start=start, end=end)


def _levels(call: Call) -> int:
    """How deep calls nest in the parameters of a call."""
    return max((1 + _levels(param) for param in call.params if isinstance(param, Call)), default=0)
