"""Other names in a text of LLL that need not be right: by its tokens, the rest of it stays as it was typed."""

from __future__ import annotations

from collections.abc import Mapping

from kitrobot.lll.tokens import CALL, HOLE, NAME, QUOTED, TEAM_WORDS, team_name, tokenise

_PROGRAM = "PROGRAM"
_NONE: Mapping[str, str] = {}


def renamed_text(
    text: str,
    *,
    objects: Mapping[str, str] = _NONE,
    members: Mapping[str, str] = _NONE,
    programs: Mapping[str, str] = _NONE,
    sets: bool = False,
) -> str:
    """A text in which names are others; each mapping is old name → new name.

    Args:
        text: a program, a condition, a template, or what is typed into a field that names a set or a program.
        objects: names before a dot.
        members: names of roles, groups and agents.
        programs: names behind PROGRAM.
        sets: whether `{name}` is a set of one; in a template it is a hole, which stays.
    """
    if not (objects or members or programs):
        return text
    tokens = tokenise(text, team=True).tokens
    pieces, done = [], 0
    for at, (kind, start, end, value) in enumerate(tokens):
        before, after = (
            tokens[at - 1][3] if at else "",
            tokens[at + 1][3] if kind != CALL and at + 1 < len(tokens) else "",
        )
        new: str | None = None
        if kind == CALL:
            new, end = objects.get(value[0]), start + len(value[0])
            value = value[0]
        elif kind == HOLE and sets and value in members:
            new = "{" + team_name(members[value]) + "}"
            value = text[start:end]
        elif kind == QUOTED or (kind == NAME and value not in TEAM_WORDS and before != "." and after != "."):
            found = (programs if before == _PROGRAM else members).get(value)
            new = None if found is None else team_name(found)
            value = text[start:end]
        elif kind == NAME and after == "." and before != ".":
            new = objects.get(value)
        # What only looks like a name stands in the tokens as what it looks like.
        if new is not None and text[start:end] == value:
            pieces += [text[done:start], new]
            done = end
    return "".join([*pieces, text[done:]])
