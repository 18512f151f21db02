"""What a mission demands of its runs, both ways: `<property name="alone" never="…"/>`, in one of four forms.

    <property name="alone" never="all {carrier-1, carrier-2} (Sign.EqualTo(3))"/>
    <property name="served" after="any carrier-1 (Cargo.IsPressed())" eventually="any carrier-1 (Cargo.IsReleased())"/>
    <property name="brought" eventually="any store-manager-B (Goal.EqualTo(12))"/>
    <property name="keeps" stays="any carrier-1 (Cargo.IsPressed())" until="any carrier-1 (Sign.EqualTo(3))"/>

Left to others: what the conditions mean, and whether they hold (verifier); that their names are there (workspace).
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated

from annotated_types import MaxLen, MinLen

from kitrobot.mission import rules
from kitrobot.mission.trial import LONGEST_CONDITION
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import needed, optional
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.writer import attributes


class Form(StrEnum):
    """How a property speaks of its one or two conditions; the value names the first attribute of its form."""

    NEVER = "never"
    AFTER = "after"
    EVENTUALLY = "eventually"
    STAYS = "stays"


_ATTRIBUTES: dict[Form, tuple[str, ...]] = {
    Form.NEVER: ("never",),
    Form.AFTER: ("after", "eventually"),
    Form.EVENTUALLY: ("eventually",),
    Form.STAYS: ("stays", "until"),
}
READY = ("contact", "empty-storehouse", "empty-swing", "stock", "deadlock", "delivered", "stopped", "end")
"""Names of properties that are checked unasked (`verifier.properties.properties`), and so are no names of others."""
READY_OF_AGENTS = ("served", "meets")
"""The same of those that are asked of each agent: the agent's name follows, behind a hyphen."""


def is_ready(name: str) -> bool:
    """Whether a name is that of a property that is checked unasked."""
    return name in READY or name.startswith(tuple(f"{one}-" for one in READY_OF_AGENTS))


LONGEST_NAME = 100


@dataclass(frozen=True, slots=True)
class AskedProperty:
    """One property: `second` is the condition behind *eventually* or *until*, "" where the form has one only."""

    name: Annotated[str, MinLen(1), MaxLen(LONGEST_NAME)]
    form: Form
    first: Annotated[str, MaxLen(LONGEST_CONDITION)]
    second: Annotated[str, MaxLen(LONGEST_CONDITION)] = ""

    @property
    def conditions(self) -> tuple[tuple[str, str], ...]:
        """Its conditions, each with the name of its attribute."""
        return tuple(zip(_ATTRIBUTES[self.form], (self.first, self.second), strict=False))

    @property
    def words(self) -> Sentence:
        """What it demands."""
        match self.form:
            case Form.NEVER:
                return Sentence("never `{condition}`", self.first)
            case Form.AFTER:
                return Sentence("after `{first}` always eventually `{second}`", self.first, self.second)
            case Form.EVENTUALLY:
                return Sentence("eventually `{condition}`", self.first)
            case Form.STAYS:
                return Sentence("once `{first}`, it stays so until `{second}`", self.first, self.second)


def _property(element: Element) -> AskedProperty | None:
    name = element.required("name")
    given = {word: element.optional(word) for words in _ATTRIBUTES.values() for word in words}
    found = tuple(word for word in given if word in element.attributes)
    form = next((form for form, words in _ATTRIBUTES.items() if sorted(words) == sorted(found)), None)
    if form is None:
        message = Sentence("expected never, eventually, after and eventually, or stays and until on <property>")
        help = Sentence('write one of these forms, such as never="any carrier (Collision.IsPressed())"')
        element.report(rules.PROPERTY_FORM, message, found[0] if found else None, help)
        return None
    conditions = [given[word] for word in _ATTRIBUTES[form]]
    for word, condition in zip(_ATTRIBUTES[form], conditions, strict=True):
        if len(condition) > LONGEST_CONDITION:
            message = Sentence(
                "expected at most {longest} characters in {attribute}, found {count}",
                *(LONGEST_CONDITION, word, len(condition)),
            )
            element.report(rules.PROPERTY_FORM, message, word)
    if len(name) > LONGEST_NAME:
        message = Sentence(
            "expected at most {longest} characters in {attribute}, found {count}", LONGEST_NAME, "name", len(name)
        )
        element.report(rules.PROPERTY_FORM, message, "name")
    return None if element.faulty else AskedProperty(name, form, *conditions)


PROPERTIES: dict[str, Tag] = {
    "property": Tag(
        _property,
        {
            "name": needed(),
            "never": optional(about="A condition that never holds."),
            "after": optional(about="A condition after which that of eventually comes, always."),
            "eventually": optional(about="A condition that comes in the end."),
            "stays": optional(about="A condition that, once it holds, holds on until that of until comes."),
            "until": optional(),
        },
        kept_whole=True,
        about="What is demanded of every run. Conditions are LLL such as any carrier (Cargo.IsPressed()).",
    )
}
"""Goes among the children of an element with `keep`."""


def write_property(one: AskedProperty) -> str:
    """One line without its break."""
    return f"<property{attributes(('name', one.name), *one.conditions)}/>"
