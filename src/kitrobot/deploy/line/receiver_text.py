"""The text of the receiver (`kitrobot_onboard.receiver`) as it is sent to a board, over its prompt."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from functools import cache
from importlib.resources import files

from kitrobot.deploy.line.repl import LONGEST
from kitrobot.deploy.minification.minifier import parsed, shortened


@cache
def texts(is_2016: bool) -> Sequence[str]:
    """The text that is sent to the board: the frames, then the receiver without its import of them."""
    found = []
    for name in ("link", "receiver", *(["flash"] if is_2016 else [])):
        source = files("kitrobot_onboard").joinpath(f"{name}.py").read_text(encoding="utf-8")
        tree = parsed(source, f"{name}.py")
        tree.body = [
            one
            for one in tree.body
            if not (isinstance(one, ast.ImportFrom) and (one.module or "").startswith("kitrobot_onboard"))
        ]
        found.append(shortened(tree))
    return found


def laid_down(number: int, piece: str) -> str:
    """The command that lays a piece down in the board's list `t`."""
    return f"t[{number}]={piece!r}"


def pieces_of(text: str) -> list[str]:
    """A text in pieces, each of which can be laid down by one command."""
    found: list[str] = []
    at = 0
    while at < len(text):
        size = LONGEST
        while len(laid_down(len(found), text[at : at + size])) >= LONGEST:
            size -= 1
        found.append(text[at : at + size])
        at += size
    return found
