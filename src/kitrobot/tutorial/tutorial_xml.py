"""Tutorial XML → a `Tutorial`.

A mistake in a step is a mistake of the tutorial: it would leave a person stuck, so a tutorial with an error is not
used, and its diagnostics say where it is wrong. Left to others: whether `start` is there (workspace).
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple, cast, get_args

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.lll.tree import FAILURES, Failure, Node
from kitrobot.lll.walk import children
from kitrobot.primitives.attribute_kinds import IDENTIFIER
from kitrobot.primitives.robot import Texts
from kitrobot.primitives.template_xml import Template, read_template
from kitrobot.primitives.templates import holes
from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import Sentence, Series, Word
from kitrobot.tutorial import rules
from kitrobot.tutorial.model import (
    EVENTS,
    GroupWant,
    Pattern,
    Point,
    PointKind,
    Range,
    SpareWant,
    Step,
    TeacherPage,
    Tutorial,
)
from kitrobot.xml.attributes import NAME, needed, one, optional, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.lessons import lesson_tag, require_label
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXT, TEXTS

VERSION = 1
"""The newest version of the format that is read."""

MOST_STEPS = 50
MOST_PROGRAMS = 100
DEEPEST_PATTERN = 20
"""Levels of a pattern, at most: what is looked for is small, and looking for it recurs into it."""

BUTTONS = (
    *("run", "pause", "step", "stop", "speed", "undo", "redo", "add-program", "problems", "file-menu"),
    *("team-tab", "team-side", "parts-side", "members", "projection"),
)
PANELS = ("palette", "canvas", "inspector", "code", "arena", "roster", "spare", "members")
_POINTS = get_args(PointKind)
_INNER = {"setting": "vertex", "slot": "vertex", "failure": "group"}

_Hole = tuple[str, Range]
_LARGEST = 65_535


class _Alternatives(tuple[Pattern, ...]):
    """Patterns of which one is enough."""

    __slots__ = ()


class _Event(str):
    __slots__ = ()


def read_tutorial(data: bytes, name: str) -> tuple[Tutorial | None, list[Diagnostic]]:
    """Reads a tutorial; None when it has an error, which the diagnostics tell."""
    reader = Reader(data, name)
    root = reader.read(TUTORIAL)
    if root is None:
        return None, reader.diagnostics
    start = root.matching("start")
    icon = root.matching("icon", "graduation-cap")
    steps = root.found(Step)
    require_label(root, rules.START, Sentence("say what the tutorial is called"))
    if not 1 <= len(steps) <= MOST_STEPS:
        root.report(rules.START, Sentence("expected 1 to {most} steps, found {count}", MOST_STEPS, len(steps)))
    if root.faulty:
        return None, reader.diagnostics
    label, help = root.texts.get("label", {}), root.texts.get("help", {})
    teacher = next(iter(root.found(TeacherPage)), None)
    return Tutorial(start, label, help, icon, tuple(steps), root.integer("order"), teacher), reader.diagnostics


def _code(element: Element) -> Template | None:
    template = read_template(element)
    if template is not None and _depth(template) > DEEPEST_PATTERN:
        element.report(rules.PATTERN, Sentence("expected at most {deepest} levels, found more", DEEPEST_PATTERN))
        return None
    return template


def _depth(root: Node) -> int:
    """Levels of a tree, its root included."""
    deepest, waiting = 0, [(root, 1)]
    while waiting:
        node, depth = waiting.pop()
        deepest = max(deepest, depth)
        waiting += [(child, depth + 1) for child in children(node)]
    return deepest


def _hole(element: Element) -> _Hole:
    name = element.matching("name")
    least = element.integer("min")
    most = element.integer("max")
    if least > most:
        element.report(
            rules.PATTERN, Sentence("expected min at most max, found {least} and {most}", least, most), "min"
        )
    return name, (least, most)


def _pattern(element: Element) -> Pattern | None:
    codes = [value for value, inner in element.values if inner.name == "code"]
    found = [(value, inner) for value, inner in element.values if inner.name == "hole"]
    written = sum(inner.name == "code" for _, inner in element.values)
    if written != 1:
        if not element.faulty:
            element.report(
                rules.PATTERN, Sentence("expected one <code> in <{element}>, found {found}", element.name, written)
            )
        return None
    code = codes[0]
    assert isinstance(code, Node)
    known = {hole.name for hole, _, _ in holes(code)}
    ranges: dict[str, Range] = {}
    for value, inner in found:
        assert isinstance(value, tuple)
        name, bounds = value
        if name not in known:
            inner.report(
                rules.PATTERN, Sentence("the code has no hole {{hole}}", name), "name", inner.did_you_mean(name, known)
            )
        elif name in ranges:
            inner.report(rules.PATTERN, Sentence("the range of {{hole}} is given already", name), "name")
        ranges[name] = bounds
    programs = element.integer("programs")
    program = element.optional("program")
    if program and programs > 1:
        element.report(rules.PATTERN, Sentence("expected either program or programs, found both"), "programs")
    return Pattern(code, element.name == "matches", program, programs, ranges)  # type: ignore[arg-type]


def _any(element: Element) -> _Alternatives | None:
    patterns = element.found(Pattern)
    if not patterns and not element.faulty:
        element.report(rules.PATTERN, Sentence("expected <contains> or <matches> in <any>, found none"))
    return _Alternatives(patterns) if patterns else None


def _event(element: Element) -> _Event:
    return _Event(element.choice("name"))


def _point(element: Element) -> Point | None:
    kinds: list[PointKind] = [kind for kind in _POINTS if kind in element.attributes]
    inner = [kind for kind in _INNER if kind in element.attributes]
    if len(kinds) != 1:
        element.report(
            rules.POINT,
            Sentence(
                "expected {points} on <point>, found {found}",
                one_of(_POINTS),
                Series(Sentence(" and "), kinds) or Word("none"),
            ),
        )
        return None
    [kind] = kinds
    name = element.choice(kind) if kind in ("button", "panel") else ""
    if [_INNER[one] for one in inner] not in ([], [kind]):
        element.report(rules.POINT, Sentence("expected no {element} here, found one", inner[-1]), inner[-1])
        return None
    name = name or element.required(kind)
    if kind == "group":
        return Point(kind, name, element.choice("failure") if inner else "")
    return Point(kind, name, element.required(inner[0]) if inner else "")


def _group(element: Element) -> GroupWant:
    return GroupWant(cast("Failure", element.choice("failure")), element.optional("name"))


def _spare(element: Element) -> SpareWant:
    return SpareWant(element.integer("robots"))


class _TeacherText(NamedTuple):
    """A text of a teacher's page, and which of its lists it is of."""

    kind: str
    texts: Texts


def _teacher_text(element: Element) -> _TeacherText:
    return _TeacherText(element.name, element.texts.get("label", {}))


def _teacher(element: Element) -> TeacherPage:
    found = element.found(_TeacherText)
    return TeacherPage(
        element.integer("minutes"),
        element.texts.get("aim", {}),
        tuple(one.texts for one in found if one.kind == "trouble"),
        tuple(one.texts for one in found if one.kind == "question"),
    )


def _step(element: Element) -> Step:
    if "" not in element.texts.get("label", {}):
        element.report(rules.START, Sentence("expected a <label> in English in the step, found none"))
    wants: list[tuple[Pattern, ...]] = []
    for value, _ in element.values:
        if isinstance(value, Pattern):
            wants.append((value,))
        elif isinstance(value, _Alternatives):
            wants.append(tuple(value))
    texts = element.texts
    return Step(
        texts.get("label", {}),
        texts.get("help", {}),
        texts.get("hint", {}),
        tuple(element.found(Point)),
        tuple(wants),
        tuple(map(str, element.found(_Event))),
        (*element.found(GroupWant), *element.found(SpareWant)),
    )


_NUMBER = whole(0, _LARGEST, "lll-number")
_HOLE = Tag(
    _hole,
    {
        "name": needed(replace(IDENTIFIER, words=Sentence("the name of a hole"))),
        "min": optional(_NUMBER, "0"),
        "max": optional(_NUMBER, str(_LARGEST)),
    },
    about="Which numbers may stand there; for a body, how many instructions; min=0 lets a test be missing.",
)
_PATTERN = Tag(
    _pattern,
    {
        "program": optional(NAME, about="The program that is meant; any, when left out."),
        "programs": optional(whole(1, MOST_PROGRAMS), "1", about="How many programs have to be like that."),
    },
    {"code": Tag(_code, text=True, about="LLL with holes {name}."), "hole": _HOLE},
    least=1,
)
_PATTERNS = {
    "contains": replace(_PATTERN, about="The code stands somewhere in a program."),
    "matches": replace(_PATTERN, about="The code is the whole program."),
}
_POINT = Tag(
    _point,
    {
        "part": optional(NAME),
        "vertex": optional(NAME),
        "setting": optional(NAME),
        "slot": optional(NAME),
        "button": optional(one(*BUTTONS)),
        "panel": optional(one(*PANELS)),
        "program": optional(NAME),
        "group": optional(NAME),
        "failure": optional(one(*FAILURES)),
    },
    about="What the step points at: one of part, vertex, button, panel, program, group.",
)
_STEP = Tag(
    _step,
    children={
        **TEXTS,
        **_PATTERNS,
        "hint": replace(TEXT, about="What is said when somebody asks to be shown."),
        "any": Tag(_any, children=_PATTERNS, least=1, about="Several right ways."),
        "group": Tag(
            _group,
            {
                "failure": needed(one(*FAILURES)),
                "name": optional(NAME, about="The group that is meant; any, when left out."),
            },
            about="A group of the team has this rule on failure.",
        ),
        "spare": Tag(
            _spare,
            {"robots": optional(whole(1, MOST_PROGRAMS), "1", about="How many, at least.")},
            about="Robots of the team play no role when a run begins.",
        ),
        "event": Tag(_event, {"name": needed(one(*EVENTS))}),
        "point": _POINT,
    },
    least=1,
    about="One thing to do: done when all patterns, one of each any and all that is said of the team hold, and an "
    "event came. A step with none of these is read.",
)
_TEACHER = Tag(
    _teacher,
    {"minutes": needed(whole(1, 240), about="How long it takes.")},
    {
        "aim": replace(TEXT, about="What a child knows afterwards."),
        "trouble": Tag(_teacher_text, children=TEXTS, least=1, about="What goes wrong, and what helps."),
        "question": Tag(_teacher_text, children=TEXTS, least=1, about="What to ask afterwards."),
    },
    about="For teachers; one is enough.",
)
TUTORIAL = {
    "tutorial": lesson_tag(
        VERSION,
        {"step": _STEP, "teacher": _TEACHER},
        {},
        about="A tutorial: steps, and what a program has to be like so that each is done.",
    )
}
"""The first element of a tutorial's file."""
