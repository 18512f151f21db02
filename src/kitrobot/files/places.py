"""Where the vertices, arcs and agents of a mission stand in the text of its `.krt`.

The compiler speaks of vertices and arcs; a person with the file in an editor wants a line. The start tags of the file
are looked up by one scan; what the file does not hold has no place. A mission with mistakes in its XML was refused
before.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

from kitrobot.diagnostics.model import ArcName, Diagnostic, Place, Source
from kitrobot.graph.model import IN, NEXT
from kitrobot.text.forms import name_form

_TAG = re.compile(
    r"<!--.*?(?:-->|\Z)|<!\[CDATA\[.*?(?:\]\]>|\Z)|<\?.*?(?:\?>|\Z)"
    r"""|<(?P<name>program|vertex|arc|agent|goal|role|group|work|world|start|breakpoint|property)(?P<attributes>(?:\s+[^\s=/>]+\s*=\s*(?:"[^"]*"|'[^']*'))*)\s*/?>""",
    re.DOTALL,
)
_ATTRIBUTE = re.compile(r"""([^\s=]+)\s*=\s*(?:"([^"]*)"|'([^']*)')""")
_ENTITIES = {"&gt;": ">", "&lt;": "<", "&quot;": '"', "&apos;": "'", "&amp;": "&"}
"""In the order in which they are read; `&amp;` last, so that `&amp;lt;` is `&lt;`."""


def _unescaped(text: str) -> str:
    for entity, character in _ENTITIES.items():
        text = text.replace(entity, character)
    return text


class Places:
    """The places of one file; `source` is its text."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self._programs: dict[str, Place] = {}
        self._vertices: dict[tuple[str, str], Place] = {}
        self._arcs: dict[tuple[str, ArcName], Place] = {}
        self._agents: dict[str, Place] = {}
        self._declarations: dict[str, Place] = {}
        self._goals: list[Place] = []
        self._starts: list[Place] = []
        self._breakpoints: list[Place] = []
        self._properties: dict[str, tuple[Place, dict[str, Place]]] = {}
        self.world: Place | None = None
        program = ""
        for match in _TAG.finditer(source.text):
            name = match.group("name")
            if not name:
                continue
            words = {
                name_form(key): name_form(_unescaped(one or other))
                for key, one, other in _ATTRIBUTE.findall(match["attributes"])
            }
            place = source.place(match.start(), match.end())
            match name:
                case "program":
                    program = words.get("name", "")
                    self._programs.setdefault(program, place)
                case "vertex":
                    self._vertices.setdefault((program, words.get("id", "")), place)
                case "arc":
                    arc = (words.get("from", ""), words.get("out", NEXT), words.get("to", ""), words.get("at", IN))
                    self._arcs.setdefault((program, arc), place)
                case "agent":
                    self._agents.setdefault(words.get("name", ""), place)
                case "role" | "group" | "work":
                    self._declarations.setdefault(words.get("name", ""), place)
                case "start":
                    self._starts.append(place)
                case "breakpoint":
                    self._breakpoints.append(place)
                case "goal":
                    self._goals.append(place)
                case "property":
                    begin = match.start("attributes")
                    spots = {
                        found[1]: source.place(begin + found.start(), begin + found.end())
                        for found in _ATTRIBUTE.finditer(match["attributes"])
                    }
                    self._properties.setdefault(words.get("name", ""), (place, spots))
                case "world":
                    self.world = self.world or place

    def program(self, name: str) -> Place | None:
        """Where a program begins."""
        return self._programs.get(name)

    def agent(self, name: str) -> Place | None:
        """Where an agent of the team is named."""
        return self._agents.get(name)

    def declaration(self, name: str) -> Place | None:
        """Where a role, a group or a work of the team is declared."""
        return self._declarations.get(name)

    def goal(self, index: int) -> Place | None:
        """Where the goal of that number, from 0, stands."""
        return self._goals[index] if index < len(self._goals) else None

    def start(self, index: int) -> Place | None:
        """Where the start of that number, from 0, of the mission's own world stands."""
        return self._starts[index] if index < len(self._starts) else None

    def breakpoint(self, index: int) -> Place | None:
        """Where the breakpoint of that number, from 0, stands."""
        return self._breakpoints[index] if index < len(self._breakpoints) else None

    def asked(self, name: str, attribute: str) -> Place | None:
        """Where an attribute of a property stands; the property itself where it has none of that name."""
        place, spots = self._properties.get(name, (None, {}))
        return spots.get(attribute, place)

    def placed(self, diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
        """The diagnostics, those about vertices and arcs with their place in this file instead of one in the LLL."""
        return [self._placed(item) for item in diagnostics]

    def _placed(self, item: Diagnostic) -> Diagnostic:
        if not item.program or (item.place is not None and item.place.file == self.source.name):
            return item
        found: list[Place | None] = [self._vertices.get((item.program, vertex)) for vertex in item.vertices]
        found += [self._arcs.get((item.program, arc)) for arc in item.arcs]
        found.append(self._programs.get(item.program))
        place = next((place for place in found if place is not None), Place(self.source.name))
        return replace(item, place=place)
