"""What is different between two kits, in words: a line for each part, setting, and fact of the board.

Left to others: what the settings mean (deploy).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields

from kitrobot.primitives.kit import Kit, KitPart
from kitrobot.primitives.robot import Texts
from kitrobot.text.sentences import Sentence, Word
from kitrobot.translation.languages import ENGLISH, LANGUAGES

_TEXTS = ("label", "help")
_PARTS = (*_TEXTS, "parts", "measured", "place")
"""Fields of a kit that are compared by themselves, or not at all."""


def kit_differences(before: Kit, after: Kit) -> Iterator[tuple[str, str]]:
    """What makes `after` of `before`, as kind and words."""
    for field in fields(Kit):
        one, other = getattr(before, field.name), getattr(after, field.name)
        if field.name not in _PARTS and one != other:
            if isinstance(one, str) and isinstance(other, str):
                yield (
                    "board",
                    Sentence("the kit: {what} {before} → {after}", Word(field.name), one or "–", other or "–"),
                )
            else:
                yield "board", Sentence("the kit: its {what} changed", Word(field.name))
    for what in _TEXTS:
        for language in _other_texts(getattr(before, what), getattr(after, what)):
            yield "board", Sentence("the kit: its {what} in {language} changed", Word(what), language)
    parts, others = _by_name(before), _by_name(after)
    for name, part in parts.items():
        if name not in others:
            yield "part", Sentence("the kit: {part} removed", name)
            continue
        other_part = others[name]
        if part.is_missing != other_part.is_missing:
            missing = Sentence("the kit: {part} is missing now", name)
            yield "part", missing if other_part.is_missing else Sentence("the kit: {part} is there now", name)
        elif part.board.driver != other_part.board.driver:
            drivers = (part.board.driver or "–", other_part.board.driver or "–")
            yield "part", Sentence("the kit: {part} has another driver: {before} → {after}", name, *drivers)
        yield from _settings("setting", name, part.board.settings, other_part.board.settings)
        for language in _other_texts(part.help, other_part.help):
            yield "part", Sentence("the kit: {part}: its {what} in {language} changed", name, Word("help"), language)
    for name in sorted(others.keys() - parts.keys()):
        yield "part", Sentence("the kit: {part} added", name)
    measured, measured_now = _measured(before), _measured(after)
    for device in sorted(measured.keys() | measured_now.keys()):
        yield from _settings("measured", device, measured.get(device, {}), measured_now.get(device, {}))


def named_part(part: KitPart) -> str:
    """Of which parts of robots it speaks, in words."""
    return " ".join(filter(None, (part.category, *part.devices, *part.names, part.when)))


def _by_name(kit: Kit) -> dict[str, KitPart]:
    return {named_part(part): part for part in kit.parts}


def _measured(kit: Kit) -> dict[str, Mapping[str, str]]:
    return {device: one.settings for one in kit.measured for device in one.devices}


def _other_texts(before: Texts, after: Texts) -> Iterator[Word]:
    """The languages in which two texts are not the same."""
    for language in dict.fromkeys([*before, *after]):
        if before.get(language) != after.get(language):
            known = LANGUAGES.get(language or ENGLISH)
            yield Word(language if known is None else known.english)


def _settings(kind: str, name: str, before: Mapping[str, str], after: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    for setting in dict.fromkeys([*before, *after]):
        one, other = before.get(setting), after.get(setting)
        if one != other:
            values = (setting, one or "–", other or "–")
            if kind == "measured":
                yield kind, Sentence("the kit: {part} as measured: {setting} {before} → {after}", name, *values)
            else:
                yield kind, Sentence("the kit: {part}: {setting} {before} → {after}", name, *values)
