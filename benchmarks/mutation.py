"""Missions with one mistake each, made from a mission at the level of its programs' trees.

A mutant is a mission that still compiles, and whose images are others than those of the mission it was made from. The
same seed gives the same mutants in the same order.
"""

from __future__ import annotations

import copy
import difflib
import random
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any

from kitrobot.compiler.graph.graph_to_lll import Translation, graph_to_lll
from kitrobot.compiler.target import print_for
from kitrobot.compiler.text.text_edit import follow_text
from kitrobot.graph.model import Program
from kitrobot.lll.tree import (
    MAX_NUMBER,
    Call,
    Conditional,
    Event,
    Joint,
    Move,
    Node,
    Not,
    Number,
    Repeat,
    Seq,
    Wait,
    Where,
    While,
)
from kitrobot.lll.walk import nodes
from kitrobot.primitives.robot import Category, Robot
from kitrobot.workspace.mission_loader import OpenMission, with_mission
from kitrobot.workspace.search_path import SearchPath


class Operator(StrEnum):
    """What is done to a program, each to one place of it."""

    DROP = "drop"
    """An action or a construct is left out."""
    DONE = "missing done"
    """A change of a variable, or what is said to the team, is left out."""
    WAIT = "missing wait"
    """A wait is left out, or what follows an event no longer waits for it."""
    SWAP = "swap"
    """Two neighbours change places."""
    CONSTANT = "constant"
    """Another number stands in the place of one: one more, half, or twice."""
    NAME = "name"
    """Another part, or another method of the same part, of the same kind and with as many parameters, is called."""
    NEGATION = "negation"
    """A condition becomes its opposite."""


@dataclass(frozen=True)
class Mutation:
    """What is done to a tree: at which node, in reading order, and to which of its items or with which choice."""

    operator: Operator
    node: int
    choice: int


@dataclass(frozen=True)
class Mutant:
    """A mission with one mistake. `change` is the lines of the program's text that are no longer there (`-`) or new
    (`+`).
    """

    program: str
    operator: Operator
    change: str
    opened: OpenMission


_NUMBERS: dict[type, str] = {Number: "value", Repeat: "count", Wait: "duration", Move: "count"}
_CONDITIONED = (While, Conditional, Event, Where, Joint)


def mutations(tree: Seq, robot: Robot) -> list[Mutation]:
    """All that can be done to a program for a robot; not all of it compiles."""
    found: list[Mutation] = []
    for at, node in enumerate(nodes(tree)):
        if isinstance(node, Seq):
            found += [Mutation(_left_out(item, robot), at, n) for n, item in enumerate(node.items)]
            found += [Mutation(Operator.SWAP, at, n) for n in range(len(node.items) - 1)]
        elif isinstance(node, Call):
            found += [Mutation(Operator.NAME, at, n) for n in range(len(_other_calls(node, robot)))]
        number = getattr(node, _NUMBERS.get(type(node), ""), None)
        if isinstance(number, int):
            found += [Mutation(Operator.CONSTANT, at, value) for value in _other_numbers(number)]
        if isinstance(node, _CONDITIONED) and node.condition is not None:
            found.append(Mutation(Operator.NEGATION, at, 0))
    return found


def mutate(tree: Seq, robot: Robot, mutation: Mutation) -> Seq:
    """A copy of the tree with that mutation."""
    made = copy.deepcopy(tree)
    node: Any = nodes(made)[mutation.node]
    at = mutation.choice
    match mutation.operator:
        case Operator.DROP | Operator.DONE | Operator.WAIT:
            item = node.items[at]
            node.items[at : at + 1] = item.body.items if isinstance(item, Event) else []
        case Operator.SWAP:
            node.items[at : at + 2] = node.items[at : at + 2][::-1]
        case Operator.CONSTANT:
            setattr(node, _NUMBERS[type(node)], at)
        case Operator.NAME:
            node.object, node.method = _other_calls(node, robot)[at]
        case Operator.NEGATION:
            condition = node.condition
            node.condition = condition.condition if isinstance(condition, Not) else Not(condition)
    return made


def mutants(opened: OpenMission, seed: int) -> Iterator[Mutant]:
    """The mutants of a mission without errors, in an order by chance in which all operators have their turn."""
    rng = random.Random(seed)
    translations = {one.name: graph_to_lll(one, opened.catalogue) for one in opened.mission.programs}
    rows: dict[Operator, list[tuple[Program, Mutation]]] = {one: [] for one in Operator}
    for program in opened.mission.programs:
        translation = translations[program.name]
        for mutation in mutations(translation.program, translation.wiring.robot):
            rows[mutation.operator].append((program, mutation))
    for row in rows.values():
        rng.shuffle(row)
    # Of few mutants of each of many missions, all operators are to be among them.
    turns = list(rows.values())
    rng.shuffle(turns)
    texts: set[tuple[str, str]] = set()
    while any(turns):
        for row in turns:
            # The next one of this operator that is a mutant.
            while row:
                program, mutation = row.pop()
                made = _mutant(opened, program, translations[program.name], mutation, texts)
                if made is not None:
                    yield made
                    break


def _mutant(
    opened: OpenMission,
    program: Program,
    translation: Translation,
    mutation: Mutation,
    texts: set[tuple[str, str]],
) -> Mutant | None:
    """The mission with that mutation; None where it does not compile, is the same, or was there (`texts`)."""
    robot, crew = translation.wiring.robot, opened.catalogue.crew
    before = print_for(copy.deepcopy(translation.program), robot, crew)
    text = print_for(mutate(translation.program, robot, mutation), robot, crew)
    if text == before or (program.name, text) in texts:
        return None
    texts.add((program.name, text))
    changed = follow_text(translation, text, opened.catalogue).program
    if changed is None:
        return None
    programs = [changed if one is program else one for one in opened.mission.programs]
    folder = opened.files[0].parent
    made = with_mission(
        replace(opened.mission, programs=programs), opened.name, SearchPath(folder, known=opened.common)
    )
    if any(one.is_error for one in made.diagnostics) or not made.report.ok or _images(made) == _images(opened):
        return None
    lines = difflib.ndiff(before.splitlines(), text.splitlines())
    change = " ".join(f"{line[0]} {line[2:].strip()}" for line in lines if line[0] in "+-")
    return Mutant(program.name, mutation.operator, change, made)


def _images(opened: OpenMission) -> dict[str, Any]:
    return {str(name): one.image for name, one in opened.images.items()}


def _left_out(item: Node, robot: Robot) -> Operator:
    """What it is called to leave an instruction out."""
    if isinstance(item, Wait | Event):
        return Operator.WAIT
    called = robot.calls.get((item.object, item.method)) if isinstance(item, Call) else None
    is_word = called is not None and called[0].category in (Category.VARIABLE, Category.SYSTEM)
    return Operator.DONE if is_word else Operator.DROP


def _other_numbers(number: int) -> list[int]:
    """The numbers that are put in the place of one."""
    return [one for one in dict.fromkeys((number + 1, number // 2, 2 * number)) if one not in (number, MAX_NUMBER + 1)]


def _other_calls(call: Call, robot: Robot) -> list[tuple[str, str]]:
    """What else of the same kind could be called: another part's method, or another method of the same part."""
    own = robot.calls.get((call.object, call.method))
    if own is None:
        return []
    return [
        name
        for name, (part, method) in robot.calls.items()
        if name != (call.object, call.method)
        and (part.category, method.kind) == (own[0].category, own[1].kind)
        and len(method.parameters) == len(own[1].parameters)
        and (name[0] == call.object) != (name[1] == call.method)
    ]
