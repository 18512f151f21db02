"""`NAME.board.xml` → `Kit`, and back.

A file with an error gives no kit: with a part left out, a program would find another one at its pins.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.primitives import rules
from kitrobot.primitives.attribute_kinds import ROBOT_NAME
from kitrobot.primitives.board_xml import BOARD, read_board
from kitrobot.primitives.kit import (
    CHIPS,
    FAMILIES_OF_BOARDS,
    LARGEST_PIN,
    Kit,
    KitEvidence,
    KitPart,
    Measurement,
    Module,
    Source,
    Wire,
)
from kitrobot.primitives.robot import Category, Texts
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.xml import rules as xml_rules
from kitrobot.xml.attributes import Kind, needed, one, optional, version
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.foreign import fragment, head, remark
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import LANGUAGE, TEXTS, read_text_element, report_duplicate_text
from kitrobot.xml.writer import attributes, escape_text, text_element

VERSION = 1
"""The newest version of the format that is read."""

KIT_SUFFIX = ".board.xml"
"""How the name of a kit's file ends."""

MOST_PINS = 200
"""Pins of a board, at most."""

LONGEST_LABEL = 100
LONGEST_TEXT = 1000
"""Characters of a kit's name for people, and of what else it says in one text, at most."""

_RANGE = re.compile(r"([0-9]{1,3})\.\.([0-9]{1,3})")
_PIN = re.compile(r"[0-9]{1,3}|[A-Za-z][A-Za-z0-9_]{0,39}")
_WORDS = Kind(longest=400, pattern=r"[^\s]+( [^\s]+)*", words=Sentence("one or more words with spaces between them"))
_SETTING = Kind(
    longest=120,
    pattern=r"[a-z\-]+=[^\s=]+",
    fits=re.compile(r"[a-z-]+=[^\s=]+").fullmatch,
    words=Sentence("a setting and its value, such as guide=road,"),
)
_VERSION = Kind(
    pattern=r"[0-9]{1,3}(\.[0-9]{1,3}){1,2}(-preview)?",
    fits=re.compile(r"[0-9]{1,3}(\.[0-9]{1,3}){1,2}(-preview)?").fullmatch,
    words=Sentence("a version such as 1.20"),
)
_PAGE = Kind(
    longest=200,
    pattern=r"https://[!-~]+",
    fits=re.compile(r"https://[!-~]+").fullmatch,
    words=Sentence("an address that begins with https://"),
)
_NUMBER = re.compile(r"[0-9]{1,6}(\.[0-9]{1,4})?")
_OURS = frozenset({"device", "part", "when", "driver"})
"""Attributes of a part that are no settings of its driver."""


@dataclass(frozen=True)
class _Line:
    """A text of the parts list or of the steps, in one language."""

    kind: str
    language: str
    text: str


class _Unknown(str):
    """XML of a kit that nobody knows."""

    __slots__ = ()


@dataclass(frozen=True)
class _Trial:
    tried: KitEvidence
    by: str


def read_kit(data: bytes, name: str) -> tuple[Kit | None, list[Diagnostic]]:
    """Reads a kit's file; None when it has an error."""
    reader = Reader(data, name)
    root = reader.read(KIT)
    kits = root.found(Kit) if root is not None and not root.faulty else []
    if not kits:
        return None, reader.diagnostics
    unknown = (*kits[0].unknown, *reader.epilog)
    return replace(kits[0], unknown=unknown, prolog=tuple(reader.prolog)), reader.diagnostics


def _devices(element: Element) -> tuple[str, ...]:
    return tuple(dict.fromkeys(element.required("device").split()))


def _part(element: Element) -> KitPart:
    return KitPart(
        Category(element.name),
        _devices(element),
        tuple(dict.fromkeys(element.optional("part").split())),
        element.matching("when", ""),
        read_board(element, _OURS),
        help=element.texts.get("help", {}),
        place=element.place("device"),
    )


def _missing(element: Element) -> KitPart:
    category = Category(element.choice("kind"))
    names = tuple(dict.fromkeys(element.optional("part").split()))
    help = element.texts.get("help", {})
    when = element.matching("when", "")
    return KitPart(category, _devices(element), names, when, is_missing=True, help=help, place=element.place("device"))


def _source(element: Element) -> Source:
    return Source(element.required("href"), element.words)


def _measured(element: Element) -> Measurement:
    settings = {name: value for name, value in element.attributes.items() if name not in element.tag.attributes}
    for name, value in settings.items():
        if not _NUMBER.fullmatch(value):
            element.bad_value(name, Sentence("a number such as 310 or 2.5,"))
    return Measurement(_devices(element), settings)


def _wire(element: Element) -> Wire:
    return Wire(element.matching("terminal"), element.matching("to"))


def _module(element: Element) -> Module:
    return Module(element.matching("name"), tuple(element.found(Wire)), element.texts.get("label", {}))


def _line(element: Element) -> _Line:
    return _Line(element.name, *read_text_element(element))


def _lines(element: Element, kind: str) -> tuple[Texts, ...]:
    """Texts in their order; one in another language belongs to the English one before it."""
    found: list[dict[str, str]] = []
    for line, around in element.found_at(_Line):
        if line.kind != kind:
            continue
        if line.language == "" or not found:
            found.append({line.language: line.text})
        elif line.language in found[-1]:
            report_duplicate_text(around)
        else:
            found[-1][line.language] = line.text
    return tuple(found)


def _trial(element: Element) -> _Trial:
    tried, by = KitEvidence(element.choice("how")), element.optional("by")
    if tried is KitEvidence.HAND and not by:
        element.report(
            xml_rules.MISSING,
            Sentence('expected by="…" beside how="hand", found none'),
            None,
            Sentence("say who tried it, or that it is from its documents"),
        )
    return _Trial(tried, by)


def _pins(element: Element) -> tuple[str, ...]:
    found: dict[str, None] = {}
    for word in element.optional("pins").split():
        ends = _RANGE.fullmatch(word)
        if ends and int(ends[1]) <= int(ends[2]) <= LARGEST_PIN:
            found.update(dict.fromkeys(map(str, range(int(ends[1]), int(ends[2]) + 1))))
        elif _PIN.fullmatch(word) and not (word.isdigit() and int(word) > LARGEST_PIN):
            found[str(int(word)) if word.isdigit() else word] = None
        else:
            expected = Sentence("numbers, ranges and names of pins, such as 0..22 26 LED,")
            message = Sentence("expected {expected} in {attribute}, found {found}", expected, "pins", shown(word))
            element.report(xml_rules.BAD_VALUE, message, "pins")
    if len(found) > MOST_PINS:
        message = Sentence("expected at most {most} pins, found {count}", MOST_PINS, len(found))
        element.report(xml_rules.BAD_VALUE, message, "pins")
    return tuple(found)


def _kit(element: Element) -> Kit:
    seen: set[tuple[Category, str, str, str]] = set()
    parts = []
    for part, around in element.found_at(KitPart):
        parts.append(part)
        for key in {
            (part.category, device, name, part.when) for device in part.devices for name in part.names or ("",)
        }:
            if key in seen:
                message = Sentence("what stands for {device} is there already", " ".join(key[1:]).strip())
                around.report(rules.BOARD, message, "device")
            seen.add(key)
    trials = element.found(_Trial) or [_Trial(KitEvidence.DOCUMENTS, "")]
    return Kit(
        element.matching("name"),
        element.choice("family"),
        _pins(element),
        element.matching("micropython", ""),
        tuple(parts),
        trials[0].tried,
        trials[0].by,
        tuple(element.found(Source)),
        _lines(element, "supply"),
        _lines(element, "step"),
        tuple(element.distinct(Module, lambda module: module.name, Sentence("module"))),
        tuple(element.found(Measurement)),
        element.matching("firmware", ""),
        element.choice("chip", ""),
        element.texts.get("label", {}),
        element.texts.get("help", {}),
        element.place("name"),
        tuple(str(raw) for raw in element.found(_Unknown)),
        attributes=element.foreign,
    )


def _keep(element: Element, raw: str) -> None:
    element.values.append((_Unknown(raw), element))


_HELP = {"help": replace(TEXTS["help"], longest=LONGEST_TEXT)}
_LABEL = {"label": replace(TEXTS["label"], longest=LONGEST_LABEL, type_name="label")}
_WHICH = {
    "device": needed(_WORDS, about="Names of devices of robots, with spaces between them."),
    "when": optional(_SETTING, about="A setting of the robot's part, as guide=road; without it, whatever they are."),
    "part": optional(_WORDS, about="Names of parts of robots; without any it stands for every part of these devices."),
}
_TERMINAL = Kind(
    longest=40,
    pattern=r"[^\s]+( [^\s]+)*",
    fits=re.compile(r"[^\s]+( [^\s]+)*").fullmatch,
    words=Sentence("a terminal as printed on it, such as AIN1,"),
)
_TEXT_LINE = {LANGUAGE: optional()}
_WIRED = Tag(
    _part,
    {**_WHICH, "driver": BOARD.attributes["driver"]},
    _HELP,
    free_attributes=True,
    about="How parts of these devices are wired. Attributes beside device, part and driver are settings of the driver.",
)
KIT = {
    "board": Tag(
        _kit,
        {
            "name": needed(ROBOT_NAME),
            "version": version(VERSION),
            "family": optional(one(*FAMILIES_OF_BOARDS), "machine", about="The kind of board."),
            "micropython": optional(_VERSION, about="The least version of MicroPython, such as 1.20."),
            "chip": optional(
                one(*CHIPS),
                about="The kind of chip, where its pins are not alike or share what makes square waves; nrf52833: the"
                " kit is for a micro:bit V2 alone.",
            ),
            "firmware": optional(_PAGE, about="The page of its maker from which its MicroPython is fetched."),
            "pins": optional(about="The pins that there are: numbers, ranges and names, such as 0..22 26 LED."),
        },
        {
            **_HELP,
            **_LABEL,
            "actuator": _WIRED,
            "sensor": replace(_WIRED),
            "missing": Tag(
                _missing,
                {"kind": optional(one("actuator", "sensor"), "sensor"), **_WHICH},
                _HELP,
                about="That the kit has nothing for these devices, and why.",
            ),
            "source": Tag(_source, {"href": needed()}, text=True, about="A document that the file is made from."),
            "tried": Tag(
                _trial,
                {"how": optional(one(*KitEvidence), "documents"), "by": optional(about="Who reported it.")},
                about="How it is known that the kit works as the file says.",
            ),
            "measured": Tag(
                _measured,
                {"device": _WHICH["device"]},
                free_attributes=True,
                about="How parts of these devices were measured on the floor (kitrobot calibrate). Attributes beside"
                " device are settings of the simulator's devices, such as speed, rate and noise.",
            ),
            "supply": Tag(
                _line, _TEXT_LINE, text=True, longest=LONGEST_TEXT, about="What is needed to build it, one thing each."
            ),
            "step": Tag(
                _line, _TEXT_LINE, text=True, longest=LONGEST_TEXT, about="What is done to build it, in its order."
            ),
            "module": Tag(
                _module,
                {"name": needed(ROBOT_NAME)},
                {
                    **_LABEL,
                    "wire": Tag(
                        _wire,
                        {
                            "terminal": needed(_TERMINAL, about="The terminal of the module, as printed on it."),
                            "to": needed(_TERMINAL, about="A pin of the board, or a module's name and its terminal."),
                        },
                        about="A wire from the module.",
                    ),
                },
                about="What is wired to the board, for whoever builds the kit.",
            ),
        },
        open=lambda element: element.version(VERSION),
        keep=_keep,
        keeps_foreign=True,
        about="A kit: how the parts of robots are wired on a board, and what is missing.",
    )
}
"""The first element of a kit's file."""


def write_kit(kit: Kit) -> str:
    """A kit's file; reading it gives the kit."""
    foreign, remarks = head(kit.attributes, kit.unknown)
    ours = attributes(
        ("name", kit.name),
        ("version", VERSION),
        ("family", kit.family),
        ("chip", kit.chip or None),
        ("micropython", kit.micropython or None),
        ("firmware", kit.firmware or None),
        ("pins", _pins_written(kit.pins) or None),
    )
    lines = [f"<board{ours}{foreign}>"]
    lines += [text_element("label", language, text) for language, text in kit.label.items()]
    lines += [text_element("help", language, text) for language, text in kit.help.items()]
    lines.append(f"<tried{attributes(('how', kit.tried), ('by', kit.tried_by or None))}/>")
    for source in kit.sources:
        lines.append(f"<source{attributes(('href', source.href))}>{escape_text(source.text)}</source>")
    for name, texts in (("supply", kit.supplies), ("step", kit.steps)):
        lines += [text_element(name, language, text) for each in texts for language, text in each.items()]
    for module in kit.modules:
        lines.append(f"<module{attributes(('name', module.name))}>")
        lines += [f"  {text_element('label', language, text)}" for language, text in module.label.items()]
        lines += [f"  <wire{attributes(('terminal', wire.terminal), ('to', wire.to))}/>" for wire in module.wires]
        lines.append("</module>")
    for part in kit.parts:
        lines += _part_written(part)
    for known in kit.measured:
        lines.append(f"<measured{attributes(('device', ' '.join(known.devices)), *known.settings.items())}/>")
    lines += [*map(fragment, kit.unknown), *remarks]
    inside = [f"  {line}" for line in lines[1:]]
    return "\n".join([*map(remark, kit.prolog), lines[0], *inside, "</board>"]) + "\n"


def _part_written(part: KitPart) -> list[str]:
    which = [("device", " ".join(part.devices)), ("part", " ".join(part.names) or None), ("when", part.when or None)]
    if part.is_missing:
        name, told = "missing", attributes(("kind", part.category.value), *which)
    else:
        name = part.category.value
        told = attributes(*which, ("driver", part.board.driver or None), *part.board.settings.items())
    if not part.help:
        return [f"<{name}{told}/>"]
    inside = [f"  {text_element('help', language, text)}" for language, text in part.help.items()]
    return [f"<{name}{told}>", *inside, f"</{name}>"]


def _pins_written(pins: tuple[str, ...]) -> str:
    """Numbers that follow one another as a range."""
    words: list[str] = []
    first = last = -2
    for pin in (*pins, ""):
        if pin.isdigit() and int(pin) == last + 1:
            last += 1
            continue
        if first >= 0:
            words.append(f"{first}..{last}" if last > first else str(first))
        first = last = int(pin) if pin.isdigit() else -2
        if pin and not pin.isdigit():
            words.append(pin)
    return " ".join(words)
