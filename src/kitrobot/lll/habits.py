"""What people write who know another language, and how LLL says it: the help for a mistake in place of the usual one.

Everything here looks at the text from an offset on and gives a sentence; nothing is read and nothing reported.
"""

from __future__ import annotations

import re

from kitrobot.text.sentences import Help, Sentence

_CHANGE = re.compile(r"\s*(?P<sign>\+\+|--|[-+*/]=|:=|=(?!=))[ \t]*(?P<value>[^;#\n]*)")
_NUMBER = re.compile(r"[0-9]{1,5}")
_COMPARED = re.compile(r"\s*(<=|>=|==|!=|=|<|>|≤|≥|≠)\s*([0-9]{0,5})")
_MORE = re.compile(r"(?P<name>\w+)\s*(?P<sign>[-+])\s*(?P<number>[0-9]{1,5})\s*")
_TESTS = {"<": "LessThan", ">": "GreaterThan", "==": "EqualTo", "=": "EqualTo"}
_NEGATED = {"<=": "GreaterThan", "≤": "GreaterThan", ">=": "LessThan", "≥": "LessThan", "!=": "EqualTo", "≠": "EqualTo"}

TRUTH = frozenset(("true", "false"))
"""Words that LLL has none for, in small letters."""


def keyword(word: str) -> Help:
    """How LLL says what a word of another language begins; "" for any other word."""
    match word.lower():
        case "if" | "elif" | "elsif" | "unless" | "switch" | "si":
            return Sentence(
                "write [test]( … ) to do something if a test is true, and [test]( … )!( … ) for the other case too"
            )
        case "else" | "sinon":
            return Sentence("write !( … ) right after the body: [test]( … )!( … )")
        case "while" | "until" | "do":
            return Sentence("write *[test]( … ) to repeat while a test is true, or *( … ) to repeat for ever")
        case "loop" | "forever":
            return Sentence("write *( … ) to repeat for ever")
        case "for" | "repeat" | "times" | "foreach":
            return Sentence("write 3*( … ) to do something three times")
        case "when" | "on":
            return Sentence("write <test>( … ) to wait for a test, and then do something")
        case "sleep" | "delay" | "pause":
            return Sentence("write WAIT(10) to wait; on most robots that is one second")
        case "return" | "exit" | "continue":
            return Sentence("write BREAK to leave a loop, or to end the branch or the program")
        case "def" | "function" | "fn" | "void" | "func":
            return Sentence("LLL has no functions; in the studio, make a part of your own from a selection")
        case "var" | "let" | "const" | "int" | "bool" | "float":
            return Sentence("variables belong to the robot: add one in the studio, or in the robot's XML")
        case "import" | "include" | "from" | "using":
            return Sentence("everything that the robot has is there already: write its calls")
    return ""


def is_reserved_in_other_letters(word: str) -> bool:
    """Whether a word is one of the language but for capitals."""
    return word.upper() in ("WAIT", "BREAK") and word not in ("WAIT", "BREAK")


def change(name: str, text: str, at: int) -> tuple[Sentence, int] | None:
    """How a variable is changed, where an offset behind its name begins a change; and where that ends."""
    found = _CHANGE.match(text, at)
    if found is None:
        return None
    sign, value = found["sign"], found["value"].strip()
    number = _NUMBER.fullmatch(value)
    sum_ = _MORE.fullmatch(value)
    if sign in ("++", "--"):
        method, given = "Add" if sign == "++" else "Sub", "1"
    elif sign in ("+=", "-="):
        method, given = "Add" if sign == "+=" else "Sub", value if number else "…"
    elif sum_ is not None and sum_["name"] == name:
        method, given = "Add" if sum_["sign"] == "+" else "Sub", sum_["number"]
    else:
        method, given = "Set", value if number else "…"
    return Sentence(
        "a variable is changed by its methods: write {variable}.{method}({given})", name, method, given
    ), found.end()


def comparison(name: str, text: str, at: int) -> tuple[Sentence, int] | None:
    """How something is compared, where an offset behind its name begins a comparison; and where its sign ends."""
    found = _COMPARED.match(text, at)
    if found is None:
        return None
    sign, number = found[1], found[2] or "…"
    end = found.end(1)
    if sign in _TESTS:
        return Sentence(
            "compare by a test of it, if it has one, such as {object}.{test}({number})", name, _TESTS[sign], number
        ), end
    return Sentence(
        "compare by a test of it, if it has one, such as !({object}.{test}({number}))", name, _NEGATED[sign], number
    ), end


def joint(word: str) -> Help:
    """The sign for a word that joins tests elsewhere; "" for any other word."""
    match word.lower():
        case "and" | "et":
            return Sentence("join tests with &: [a & b]( … )")
        case "or" | "ou":
            return Sentence("join tests with |: [a | b]( … )")
    return ""


def number_sign(shown: str) -> Help:
    """What is wrong with something that was to be a number; "" where nobody knows."""
    if re.fullmatch(r"[-−][0-9]+", shown):
        return Sentence("numbers have no sign: use a method that goes the other way, such as Sub in place of Add")
    if shown[:1] in tuple("\"'`“”«„"):
        return Sentence("LLL has no texts, only whole numbers from 0 to 65535")
    return ""


def behind_a_number(shown: str) -> Help:
    """What is wrong where something stands behind a parameter; "" where nobody knows."""
    if shown[:1] in "+-/*":
        return Sentence(
            "LLL does not calculate in parameters: change a variable with Add or Sub, then give its Value()"
        )
    if shown[:1] in "%°":
        return Sentence("write the number alone, without a unit")
    return ""


def comment_end(text: str, at: int) -> int | None:
    """Where a comment of another language that begins at an offset ends; None where none does."""
    if text.startswith("/*", at):
        end = text.find("*/", at)
        return len(text) if end < 0 else end + 2
    if text.startswith(("//", "--", "'''", '"""'), at):
        end = text.find("\n", at)
        return len(text) if end < 0 else end
    return None
