"""A text that is nearly a program has few problems, and each says where, what, and what to do, in each language."""

from __future__ import annotations

import os
import random

import pytest

from kitrobot.compiler.compilation import compile_text
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.diagnostics.problems import with_help
from kitrobot.lll.printer import print_program
from kitrobot.lll.tokens import END, tokenise
from kitrobot.translation.languages import TRANSLATED
from kitrobot.translation.translator import translate_to
from tests.strategies import Shape, random_program, shipped_robots

BUDGET = int(os.environ.get("KITROBOT_BUDGET", "200"))

MOST_PROBLEMS = 5
"""Errors that one changed token may cause: what it opened or closed may change its meaning in several places."""

WORDS = [
    *("if", "while", "else", "true", "Count", "=", "==", "&&", "||", "!", "{", "}", "(", ")", "[", "]", "<", ">", "°"),
    *("//", "*", ";", ",", ".", "3", "-5", "1.5", "99999", '"hi"', "WAIT", "BREAK", "wait", "۵", "（", "；", "×", "+"),
    *("Wheel.Stop()", "WAIT(1)", "Count++", "BREAK", "// x", "%", "#"),
]


def errors(text: str) -> list[Diagnostic]:
    found = compile_text(text, shipped_robots()["mini-robot"]).diagnostics
    return [one for one in found if one.is_error]


def changed(rng: random.Random, text: str) -> str:
    """The text with one token taken out, put in, or put in the place of another."""
    tokens = [token for token in tokenise(text).tokens if token[0] != END]
    _, start, end, _ = rng.choice(tokens)
    match rng.randrange(3):
        case 0:
            return text[:start] + text[end:]
        case 1:
            return f"{text[:start]}{rng.choice(WORDS)} {text[start:]}"
        case _:
            return f"{text[:start]}{rng.choice(WORDS)}{text[end:]}"


@pytest.mark.timeout(0 if BUDGET > 1000 else 300)
def test_one_changed_token_causes_few_problems() -> None:
    for seed in range(BUDGET * 2):
        rng = random.Random(seed)
        text = print_program(random_program(rng, shipped_robots()["mini-robot"], Shape(10, 4)))
        if errors(text):
            continue
        near = changed(rng, text)
        found = errors(near)
        assert len(found) <= MOST_PROBLEMS, f"seed {seed}\n{near}\n" + "\n".join(
            f"{one.place} {one.message}" for one in found
        )


@pytest.mark.timeout(0 if BUDGET > 1000 else 300)
def test_each_problem_has_a_place_a_message_and_a_help_in_each_language() -> None:
    for seed in range(BUDGET * 2):
        rng = random.Random(seed)
        text = print_program(random_program(rng, shipped_robots()["mini-robot"], Shape(10, 4)))
        near = changed(rng, changed(rng, text))
        for one in with_help(compile_text(near, shipped_robots()["mini-robot"]).diagnostics):
            assert one.place is not None
            assert 1 <= one.place.line <= near.count("\n") + 1
            for language in TRANSLATED:
                for sentence in (one.message, one.help):
                    assert sentence
                    assert translate_to(sentence, language) != sentence, (language, sentence)
