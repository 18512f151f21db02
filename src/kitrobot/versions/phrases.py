"""Phrases of differences: how they name vertices, places and values."""

from __future__ import annotations

from typing import Any

from kitrobot.graph.model import START, STOP, Vertex
from kitrobot.text.sentences import Sentence, Word
from kitrobot.versions.outline import PARKED, Outline

_LONGEST_QUOTE = 60


def where(outline: Outline, id: str) -> str:
    """Where a vertex stands, as the end of a sentence."""
    spot = outline.spots.get(id)
    if spot is None:
        return ""
    holder, slot = spot.chain
    after = Sentence(" after {vertex}", named(outline.vertices[spot.after])) if spot.after else ""
    if slot == PARKED:
        return Sentence("{after}, parked", after)
    if not holder:
        return after or Sentence(" after Start")
    if not after and len(outline.chains[spot.chain]) > 1:
        after = Sentence(" first")
    return Sentence("{after} in the {slot} of {holder}", after, Word(slot), named(outline.vertices[holder]))


def named(vertex: Vertex) -> Sentence:
    """A vertex: its element and id."""
    element = Word(vertex.element)
    return element if element in (START, STOP) else Sentence("{element} ({id})", element, vertex.id)


def value(value: str | None) -> str:
    """A setting's value; None: there is none."""
    return (
        Word("nothing") if value is None else quoted(value) if value == "" or " " in value else value[:_LONGEST_QUOTE]
    )


def quoted(text: str) -> str:
    """A text in quotation marks, shortened."""
    line = " ".join(text.split())
    return f"“{line if len(line) <= _LONGEST_QUOTE else line[: _LONGEST_QUOTE - 1] + '…'}”"


def short(value: Any) -> str:
    """Any value of a mission as a short text."""
    if isinstance(value, dict):
        value = value.get("") or next(iter(value.values()), "")
    if isinstance(value, list):
        value = " ".join(map(str, value))
    return quoted(str(value)) if value else Word("nothing")
