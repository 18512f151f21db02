"""Notes for trying a part of a robot by hand: what is called, what to expect, and what to look for when nothing
happens; and how a kit is measured.

They are read from `shipped/bench.xml`, by device, and from kits. A part whose device has no note is tried with all its
procedures and their usual values, and is described by its own texts. Left to others: running it (bench, calibration).
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.primitives.attribute_kinds import IDENTIFIER
from kitrobot.primitives.robot import Category, RobotObject, Texts
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import Kind, needed, one, optional, version, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXTS

VERSION = 1
"""The newest version of the list that is read."""

_SHIPPED = Path(__file__).parent / "shipped" / "bench.xml"
_CALL = re.compile(r"([^\W\d]\w*)\(((-?[0-9]{1,6})(, ?-?[0-9]{1,6})*)?\)")


@dataclass(frozen=True)
class BenchNote:
    """Of parts of these devices; `procedure` with `arguments` is what is called, "" for a sensor, which is looked at.

    `seen`: what happens then; `trouble`: what to look for when it does not. Where it is for measuring, `measures` says
    what, `part` of which part, `lasts` for how many units of WAIT (0: until it is done by itself), and `seen` asks.
    """

    category: Category
    devices: tuple[str, ...]
    procedure: str
    arguments: tuple[int, ...]
    seen: Texts
    trouble: Texts
    measures: str = ""
    part: str = ""
    lasts: int = 0


def _note(element: Element) -> BenchNote:
    call = _CALL.fullmatch(element.matching("call")) if element.name != "sensor" else None
    measures = element.choice("of") if element.name == "measure" else ""
    return BenchNote(
        Category.SENSOR if element.name == "sensor" else Category.ACTUATOR,
        tuple(element.required("device").split()),
        call[1] if call else "",
        tuple(int(number) for number in call[2].split(",")) if call and call[2] else (),
        element.texts.get("label", {}),
        element.texts.get("help", {}),
        measures,
        element.optional("part") if measures else "",
        element.integer("lasts", 0) if measures else 0,
    )


MEASURES = ("left", "right", "distance", "turn")
"""What can be measured: which way each wheel turns, how far it drives, how far it turns."""

LONGEST_WAIT = 100
"""Units of WAIT that something to be measured lasts, at most."""

_WORDS = Kind(longest=400, pattern=r"[^\s]+( [^\s]+)*", words=Sentence("one or more words with spaces between them"))
_CALLED = Kind(
    longest=80,
    pattern=r"[\p{L}_][\p{L}\p{M}\p{N}_]*\((-?[0-9]{1,6}(, ?-?[0-9]{1,6})*)?\)",
    fits=_CALL.fullmatch,
    words=Sentence("a procedure and its numbers, such as Advance(40),"),
)
_DEVICE = {"device": needed(_WORDS, about="Names of devices of robots, with spaces between them.")}
_TRIED = {**_DEVICE, "call": needed(_CALLED, about="What is called to try the part.")}
BENCH = {
    "bench": Tag(
        None,
        {"version": version(VERSION)},
        {
            "actuator": Tag(
                _note,
                _TRIED,
                TEXTS,
                about="label: what is seen then. help: what to look for when nothing happens.",
            ),
            "sensor": Tag(
                _note,
                _DEVICE,
                TEXTS,
                about="label: what to do, and what its value does then. help: what to look for when it does not.",
            ),
            "measure": Tag(
                _note,
                {
                    **_TRIED,
                    "of": needed(one(*MEASURES), about="What is measured."),
                    "part": optional(IDENTIFIER, about="The name of the part."),
                    "lasts": optional(
                        whole(0, LONGEST_WAIT), "0", about="Units of WAIT; 0: until it is done by itself."
                    ),
                },
                TEXTS,
                about="What a kit is measured with. label: what is asked. help: what to do before.",
            ),
        },
        open=lambda root: root.version(VERSION),
    )
}


def read_bench(data: bytes, name: str) -> tuple[tuple[BenchNote, ...] | None, list[Diagnostic]]:
    """Reads a list of notes; None when it has an error, which the diagnostics tell."""
    reader = Reader(data, name)
    root = reader.read(BENCH)
    if root is None or any(one.is_error for one in reader.diagnostics):
        return None, reader.diagnostics
    return tuple(root.found(BenchNote)), reader.diagnostics


@cache
def shipped_notes() -> tuple[BenchNote, ...]:
    """Those that come with KitRobot."""
    made, problems = read_bench(_SHIPPED.read_bytes(), _SHIPPED.name)
    assert made is not None, problems
    return made


def notes_for(part: RobotObject, notes: tuple[BenchNote, ...] | None = None) -> list[BenchNote]:
    """How a part is tried, in the order of the list; in its own words where the list says nothing of its device."""
    known = shipped_notes() if notes is None else notes
    found = [
        note
        for note in known
        if not note.measures
        and note.category is part.category
        and part.device in note.devices
        and (not note.procedure or fits(part, note))
    ]
    return found or _own_words(part)


def fits(part: RobotObject, note: BenchNote) -> bool:
    """Whether the part has that procedure, with as many parameters, in whose ranges the numbers lie."""
    method = part.method(note.procedure)
    return (
        method is not None
        and len(method.parameters) == len(note.arguments)
        and all(
            one.minimum <= value <= one.maximum for one, value in zip(method.parameters, note.arguments, strict=True)
        )
    )


def _own_words(part: RobotObject) -> list[BenchNote]:
    """Every procedure with its usual values, but for those that only end another one."""
    if part.category is Category.SENSOR:
        return [BenchNote(part.category, (part.device,), "", (), part.help, {})]
    ends = {method.stop for method in part.methods}
    called = [method for method in part.methods if method.name not in ends] or list(part.methods)
    return [
        BenchNote(
            part.category,
            (part.device,),
            method.name,
            tuple(parameter.default for parameter in method.parameters),
            method.help or part.help,
            {},
        )
        for method in called
    ]
