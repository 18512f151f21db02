"""What of a program is selected: one stretch of a chain with all that it holds, or one condition.

Selections come as vertex ids in any order. Vertices inside others that are selected go with those; gaps in a chain
are filled, as where something is put around a selection. Nothing is judged here but the selection's form.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kitrobot.compiler.graph.wiring import Wiring
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.graph.model import IN, NEXT, START, STOP
from kitrobot.primitives.constructors import Role, SlotKind
from kitrobot.primitives.robot import Kind
from kitrobot.text.sentences import Sentence


class SelectionError(KitRobotError):
    """The selection is not one stretch of a chain, and not one condition."""


@dataclass(frozen=True)
class Selection:
    """`chain`: the vertices that stand in the chain, in order (a condition alone is one). `held` has all that they hold
    too, each vertex before what it holds.
    """

    chain: tuple[str, ...]
    held: tuple[str, ...]
    is_condition: bool


def select(wiring: Wiring, ids: Sequence[str]) -> Selection:
    """The selection that those vertices are.

    Raises:
        SelectionError: nothing is selected, a vertex is not there, or they stand in several chains.
    """
    ends = (START, STOP)
    for name in ids:
        if name not in wiring.vertices:
            raise SelectionError(
                Sentence("the program has no vertex `{vertex}`", name), Sentence("select the parts anew")
            )
    chosen = {name for name in ids if wiring.vertices[name].element not in ends}
    if not chosen:
        raise SelectionError(
            Sentence("nothing is selected that could be saved as a part"), Sentence("select one or more vertices first")
        )
    slots = {filler: owner for owner, filler in wiring.fills.items()}
    for name in list(chosen):
        owner, slot = slots.get(name, ("", ""))
        constructor = wiring.constructor(wiring.vertices[owner]) if owner else None
        around = constructor.slot(slot) if constructor is not None else None
        if around is not None and around.kind is SlotKind.ACTION:
            chosen.add(owner)
    fillers = fillers_of(wiring)
    inside = {one for name in chosen for one in held_by(wiring, fillers, name) if one != name}
    top = [name for name in wiring.vertices if name in chosen and name not in inside]
    in_chain = {arc.target for arc in wiring.out.values() if arc.at == IN}
    alone = [name for name in top if name not in in_chain and _is_filler(wiring, slots, name)]
    if alone:
        chain = _one_condition(wiring, top, alone[0])
    else:
        chain = _stretch(wiring, top)
    held = dict.fromkeys(one for name in chain for one in held_by(wiring, fillers, name))
    return Selection(chain, tuple(held), bool(alone))


def fillers_of(wiring: Wiring) -> dict[str, list[str]]:
    """What fills the slots of each vertex."""
    fillers: dict[str, list[str]] = {}
    for (owner, _), filler in wiring.fills.items():
        fillers.setdefault(owner, []).append(filler)
    return fillers


def held_by(wiring: Wiring, fillers: dict[str, list[str]], vertex: str) -> Iterator[str]:
    """A vertex and all that fills its slots and stands in its bodies, in reading order; each once, rings too."""
    seen: set[str] = set()
    waiting = [vertex]
    while waiting:
        name = waiting.pop()
        if name in seen:
            continue
        seen.add(name)
        yield name
        inner = list(fillers.get(name, ()))
        for port in wiring.ports.get(name, ()):
            if port != NEXT:
                inner += chain_behind(wiring, name, port)
        waiting += [one for one in reversed(inner) if wiring.vertices[one].element not in (START, STOP)]


def chain_behind(wiring: Wiring, vertex: str, port: str) -> list[str]:
    """The vertices of the chain that begins at a port, up to where it ends or comes back."""
    found: list[str] = []
    seen = {vertex}
    arc = wiring.out.get((vertex, port))
    while arc is not None and arc.at == IN and arc.target not in seen:
        seen.add(arc.target)
        found.append(arc.target)
        arc = wiring.out.get((arc.target, NEXT))
    return found


def _is_filler(wiring: Wiring, slots: dict[str, tuple[str, str]], name: str) -> bool:
    """Whether a vertex fills a slot, or is parked and can only do that."""
    if name in slots:
        return True
    vertex = wiring.vertices[name]
    constructor = wiring.constructor(vertex)
    if constructor is not None:
        return constructor.role is Role.CONDITION
    owner, _, method = vertex.element.partition(".")
    meaning = wiring.robot.calls.get((owner, method))
    return meaning is not None and meaning[1].kind is not Kind.PROCEDURE


def _one_condition(wiring: Wiring, top: list[str], filler: str) -> tuple[str, ...]:
    if len(top) > 1:
        raise SelectionError(
            Sentence("the selection holds conditions or values beside other parts"),
            Sentence("select neighbours of one chain, or one condition alone"),
        )
    vertex = wiring.vertices[filler]
    constructor = wiring.constructor(vertex)
    if constructor is None or constructor.role is not Role.CONDITION:
        raise SelectionError(
            Sentence("`{element}` alone cannot be a part of your own", vertex.element),
            Sentence("select a condition made with and, or, not; or the instruction around it"),
        )
    return (filler,)


def _stretch(wiring: Wiring, top: list[str]) -> tuple[str, ...]:
    """The vertices from the first to the last of those, along their chain."""
    before = {arc.target: arc.source for (_, port), arc in wiring.out.items() if port == NEXT and arc.at == IN}
    wanted = set(top)
    first = at = top[0]
    seen = {at}
    while at in before and before[at] not in seen:
        at = before[at]
        seen.add(at)
        if at in wanted:
            first = at
    chain = [first, *chain_behind(wiring, first, NEXT)]
    missing = wanted.difference(chain)
    if missing:
        raise SelectionError(
            Sentence("the selection stands in several chains"),
            Sentence("select neighbours that stand one after another in one chain"),
        )
    last = max(index for index, name in enumerate(chain) if name in wanted)
    return tuple(name for name in chain[: last + 1] if wiring.vertices[name].element not in (START, STOP))
