"""What is different between two missions, or two LLL texts, in words.

Programs are found again by name, or by what they hold when they were renamed; vertices by their id. What stands in a
chain is held against the same chain, so one instruction put in is one difference and not one for each that follows.
Nothing different is ever left out: where no words fit better, the part that differs is named.
"""

from __future__ import annotations

import difflib
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from kitrobot.diagnostics import KitRobotError, Source
from kitrobot.graph import START, STOP, Note, Program, Vertex
from kitrobot.mission import NO_PROGRAM, Agent, Goal, Mission, read_mission
from kitrobot.workspace.layout import lay_out_file
from kitrobot.workspace.opening import read_carried
from kitrobot.workspace.outline import PARKED, Outline
from kitrobot.workspace.own_parts import TOLD_HERE, own_part_differences
from kitrobot.workspace.own_worlds import world_differences
from kitrobot.workspace.problems import ProblemsError

_LONGEST_QUOTE = 60
_ALIKE = 0.6
"""So much of two programs' vertices must be the same for one to be the other renamed."""


class CompareError(KitRobotError):
    """Two files that cannot be held against each other."""


@dataclass(frozen=True)
class Difference:
    """One difference. `kind` is one of a few words for programs to read; `vertex` is "" when it is about none."""

    kind: str
    words: str
    program: str = ""
    vertex: str = ""

    @property
    def sentence(self) -> str:
        """The words, after the program that they are about."""
        return f"{self.program}: {self.words}" if self.program else self.words


def differences(before: Mission, after: Mission) -> list[Difference]:
    """What makes `after` of `before`; empty when they are equal."""
    found = list(_programs(before, after))
    found += _agents(before.team.agents, after.team.agents)
    found += _goals(before.team.goals, after.team.goals)
    found += [Difference(kind, words) for kind, words in world_differences(before, after)]
    found += [Difference(kind, words) for kind, words in own_part_differences(before, after)]
    for field in fields(Mission):
        one, other = getattr(before, field.name), getattr(after, field.name)
        if field.name not in ("programs", "team", "world_href", "own_world", *TOLD_HERE) and one != other:
            found.append(Difference("mission", f"the {field.name} of the mission: {_short(one)} → {_short(other)}"))
    return found


def text_differences(before: str, after: str) -> list[Difference]:
    """What is different between two LLL texts, both in the true layout, by their lines."""
    old, new = before.splitlines(), after.splitlines()
    found = []
    for kind, i, j, k, m in difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if kind == "equal":
            continue
        pairs = min(j - i, m - k)
        for step in range(pairs):
            words = f"line {k + step + 1}: `{old[i + step].strip()}` → `{new[k + step].strip()}`"
            found.append(Difference("line-changed", words))
        found += [
            Difference("line-removed", f"line {at + 1} removed: `{old[at].strip()}`") for at in range(i + pairs, j)
        ]
        found += [Difference("line-added", f"line {at + 1} added: `{new[at].strip()}`") for at in range(k + pairs, m)]
    return found


def renamed_programs(before: Mission, after: Mission) -> dict[str, str]:
    """Old name → new name of the programs that only go by another name, as far as what they hold tells."""
    old_names = {program.name for program in before.programs}
    new_names = {program.name for program in after.programs}
    free = [program for program in after.programs if program.name not in old_names]
    found: dict[str, str] = {}
    for program in before.programs:
        if program.name in new_names or not free:
            continue
        best = max(free, key=lambda other: _likeness(program, other))
        if _likeness(program, best) >= _ALIKE:
            found[program.name] = best.name
            free.remove(best)
    return found


def _likeness(one: Program, other: Program) -> float:
    old, new = _marks(one), _marks(other)
    if not old and not new:
        return float(one.robot == other.robot)
    return len(old & new) / max(len(old), len(new))


def _marks(program: Program) -> set[tuple[str, str]]:
    return {(vertex.id, vertex.element) for vertex in program.vertices if vertex.element not in (START, STOP)}


def _programs(before: Mission, after: Mission) -> Iterator[Difference]:
    renamed = renamed_programs(before, after)
    came_from = {new: old for old, new in renamed.items()}
    kept = {renamed.get(program.name, program.name) for program in before.programs}
    for program in before.programs:
        name = renamed.get(program.name, program.name)
        if after.program(name) is None:
            yield Difference("program-removed", f"the program {program.name} removed")
    for program in after.programs:
        old = before.program(came_from.get(program.name, program.name))
        if old is None:
            yield Difference("program-added", f"the program {program.name} added, for the robot {program.robot}")
            continue
        if old.name != program.name:
            yield Difference("program-renamed", f"the program {old.name} renamed to {program.name}")
        yield from _program(old, program)
    order = [name for name in (renamed.get(one.name, one.name) for one in before.programs) if after.program(name)]
    if order != [program.name for program in after.programs if program.name in kept]:
        yield Difference("order", "the programs stand in another order")


def _program(before: Program, after: Program) -> Iterator[Difference]:
    name = after.name
    if before.robot != after.robot:
        yield Difference("robot", f"the robot: {before.robot} → {after.robot}", name)
    old, new = Outline(before), Outline(after)
    told = False
    for found in _vertices(old, new, name):
        told = told or found.kind in ("added", "removed", "moved")
        yield found
    if told or (before.arcs == after.arcs and [v.id for v in before.vertices] == [v.id for v in after.vertices]):
        return
    arcs = [{(arc.source, arc.out, arc.target, arc.at) for arc in program.arcs} for program in (before, after)]
    for source, out, target, at in sorted(arcs[0] - arcs[1]):
        yield Difference("arc-removed", f"the arc {source}.{out} → {target}.{at} removed", name, source)
    for source, out, target, at in sorted(arcs[1] - arcs[0]):
        yield Difference("arc-added", f"the arc {source}.{out} → {target}.{at} added", name, source)
    if arcs[0] == arcs[1]:
        yield Difference("order", "the same vertices and arcs in another order of the file", name)


def _vertices(old: Outline, new: Outline, name: str) -> Iterator[Difference]:
    for id, vertex in old.vertices.items():
        if id not in new.vertices:
            yield Difference("removed", f"{_named(vertex)} removed, it stood{_where(old, id)}", name, id)
    moved = _moved(old, new)
    for id, vertex in new.vertices.items():
        before = old.vertices.get(id)
        if before is None:
            yield Difference("added", f"{_named(vertex)} added{_where(new, id)}", name, id)
            yield from _inside(Vertex(id, vertex.element, vertex.settings), vertex, name)
            continue
        if id in moved:
            yield Difference("moved", f"{_named(vertex)} moved{_where(new, id)}", name, id)
        yield from _inside(before, vertex, name)


def _inside(before: Vertex, after: Vertex, name: str) -> Iterator[Difference]:
    """What is different in a vertex itself."""
    what = _named(after)
    if before.element != after.element:
        yield Difference("element", f"{_named(before)} became {after.element}", name, after.id)
    for setting in dict.fromkeys((*before.settings, *after.settings)):
        one, other = before.settings.get(setting), after.settings.get(setting)
        if one != other:
            words = f"the {setting} of {what}: {_value(one)} → {_value(other)}"
            yield Difference("setting", words, name, after.id)
    for old_note, new_note in _note_pairs(before.notes, after.notes):
        if old_note is None and new_note is not None:
            yield Difference("note-added", f"a note at {what} added: {_quoted(new_note.text)}", name, after.id)
        elif old_note is not None and new_note is None:
            yield Difference("note-removed", f"the note {_quoted(old_note.text)} at {what} removed", name, after.id)
        elif old_note is not None and new_note is not None:
            words = f"the note at {what}: {_quoted(old_note.text)} → {_quoted(new_note.text)}"
            yield Difference("note", words, name, after.id)
    for field in fields(Vertex):
        one_value, other_value = getattr(before, field.name), getattr(after, field.name)
        if field.name not in ("id", "element", "settings", "notes") and one_value != other_value:
            words = f"the {field.name} of {what}: {_short(one_value)} → {_short(other_value)}"
            yield Difference("vertex", words, name, after.id)
    if before.settings == after.settings and list(before.settings) != list(after.settings):
        yield Difference("order", f"the settings of {what} stand in another order", name, after.id)


def _note_pairs(before: Sequence[Note], after: Sequence[Note]) -> list[tuple[Note | None, Note | None]]:
    """The notes that differ, old beside new where they stand at one place."""
    old = [note for note in before if note not in after]
    new = [note for note in after if note not in before]
    pairs: list[tuple[Note | None, Note | None]] = []
    for note in old:
        same = next((other for other in new if other.at == note.at), None)
        if same is not None:
            new.remove(same)
        pairs.append((note, same))
    pairs += [(None, note) for note in new]
    if not pairs and list(before) != list(after):
        pairs = [(note, None) for note in before] + [(None, note) for note in after]
    return pairs


def _moved(old: Outline, new: Outline) -> set[str]:
    """Vertices that stand in another chain now, or before or behind others than they did; as few as explain it."""
    both = old.spots.keys() & new.spots.keys()
    home = {id: _home(old, id) for id in both}
    moved = {id for id in both if home[id] != _home(new, id)}
    for members in new.chains.values():
        stayed = [id for id in members if id in both and id not in moved]
        places = [old.spots[id].index for id in stayed]
        if len({old.spots[id].chain for id in stayed}) == 1:
            keep = _longest_rising(places)
            moved |= {id for at, id in enumerate(stayed) if at not in keep}
    return moved


def _home(outline: Outline, id: str) -> tuple[str, str]:
    holder, slot = outline.spots[id].chain
    return ("", PARKED) if slot == PARKED else (holder, slot)


def _longest_rising(places: Sequence[int]) -> set[int]:
    """The indices of a longest rising selection."""
    ends: list[int] = []
    values: list[int] = []
    before: list[int] = []
    for at, place in enumerate(places):
        length = bisect_left(values, place)
        before.append(ends[length - 1] if length else -1)
        ends[length : length + 1] = [at]
        values[length : length + 1] = [place]
    found: set[int] = set()
    at = ends[-1] if ends else -1
    while at >= 0:
        found.add(at)
        at = before[at]
    return found


def _agents(before: Sequence[Agent], after: Sequence[Agent]) -> Iterator[Difference]:
    old, new = {agent.name: agent for agent in before}, {agent.name: agent for agent in after}
    for name in old.keys() - new.keys():
        yield Difference("agent-removed", f"the team: {name} removed")
    for name, agent in new.items():
        was = old.get(name)
        if was is None:
            yield Difference("agent-added", f"the team: {name} added, runs {agent.program}")
            continue
        for field in fields(Agent):
            one, other = getattr(was, field.name), getattr(agent, field.name)
            if one != other:
                yield Difference("agent", f"the team: the {field.name} of {name}: {one or 'none'} → {other or 'none'}")
    if list(before) != list(after) and old == new:
        yield Difference("order", "the team: its agents stand in another order")


def _goals(before: Sequence[Goal], after: Sequence[Goal]) -> Iterator[Difference]:
    for goal in before:
        if goal not in after:
            yield Difference("goal-removed", f"the goals: {goal.storehouse} holds {goal.stock} removed")
    for goal in after:
        if goal not in before:
            yield Difference("goal-added", f"the goals: {goal.storehouse} holds {goal.stock} added")
    if list(before) != list(after) and all(goal in after for goal in before) and all(goal in before for goal in after):
        yield Difference("order", "the goals stand in another order")


def _where(outline: Outline, id: str) -> str:
    """Where a vertex stands, as the end of a sentence."""
    spot = outline.spots.get(id)
    if spot is None:
        return ""
    holder, slot = spot.chain
    after = f" after {_named(outline.vertices[spot.after])}" if spot.after else ""
    if slot == PARKED:
        return f"{after}, parked"
    if not holder:
        return after or " after Start"
    if not after and len(outline.chains[spot.chain]) > 1:
        after = " first"
    return f"{after} in the {slot} of {_named(outline.vertices[holder])}"


def _named(vertex: Vertex) -> str:
    return vertex.element if vertex.element in (START, STOP) else f"{vertex.element} ({vertex.id})"


def _value(value: str | None) -> str:
    return "nothing" if value is None else _quoted(value) if value == "" or " " in value else value[:_LONGEST_QUOTE]


def _quoted(text: str) -> str:
    line = " ".join(text.split())
    return f"“{line if len(line) <= _LONGEST_QUOTE else line[: _LONGEST_QUOTE - 1] + '…'}”"


def _short(value: Any) -> str:
    if isinstance(value, dict):
        value = value.get("") or next(iter(value.values()), "")
    if isinstance(value, list):
        value = " ".join(map(str, value))
    return _quoted(str(value)) if value else "nothing"


def compare_files(before: Path, after: Path) -> list[Difference]:
    """What is different between two `.krt` (or pictures that carry one), or two `.lll` by their true layout.

    Raises:
        CompareError: they are not two of a kind.
        ProblemsError: what one of them says cannot be used.
        FileError: one of them cannot be read.
    """
    kinds = {before.suffix.lower(), after.suffix.lower()}
    if kinds == {".lll"}:
        return text_differences(_laid_out(before), _laid_out(after))
    if ".lll" in kinds:
        raise CompareError("expected two missions or two LLL texts, found one of each", "convert one of them first")
    return differences(mission_whole(read_carried(before), before), mission_whole(read_carried(after), after))


def mission_whole(data: bytes, path: Path) -> Mission:
    """The mission in the bytes of a file, all of which can be used.

    Raises:
        ProblemsError: some of it cannot.
    """
    mission, diagnostics = read_mission(data, str(path))
    if mission is None or any(item.is_error and item.code != NO_PROGRAM.code for item in diagnostics):
        source = Source(str(path), data.decode("utf-8-sig", errors="replace"))
        raise ProblemsError(f"`{path}` cannot be used", "mend it first", tuple(diagnostics), (source,))
    return mission


def _laid_out(path: Path) -> str:
    layout = lay_out_file(path)
    if layout.text is None:
        raise ProblemsError(f"`{path}` cannot be used", "mend it first", layout.diagnostics, (layout.source,))
    return layout.text
