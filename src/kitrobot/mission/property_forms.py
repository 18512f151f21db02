"""What a mission demands of its runs, both ways: `<property name="alone" never="…"/>`, in one of nine forms.

    <property name="alone" never="all {carrier-1, carrier-2} (Sign.EqualTo(3))"/>
    <property name="served" after="any carrier-1 (Cargo.IsPressed())" eventually="any carrier-1 (Cargo.IsReleased())"/>
    <property name="brought" eventually="any store-manager-B (Goal.EqualTo(12))" within="90"/>
    <property name="keeps" stays="any carrier-1 (Cargo.IsPressed())" until="any carrier-1 (Sign.EqualTo(3))"/>
    <property name="round" visit="any carrier-1 (Sign.EqualTo(0)); any carrier-1 (Sign.EqualTo(3))" order="turn"/>

Goals of exercises have the same attributes (`FORMS`), and no name. Left to others: the same as a line of text
(property_text); what the conditions mean, and whether they hold (verifier); that their names are there (workspace).
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated, NamedTuple

from annotated_types import Ge, Le, MaxLen, MinLen

from kitrobot.mission import rules
from kitrobot.mission.trial import LONGEST_CONDITION, LONGEST_S
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.xml.attributes import Attribute, decimal, needed, one, optional, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.writer import attributes


class Form(StrEnum):
    """How a property speaks of its conditions; the value names the first attribute of its form."""

    NEVER = "never"
    AFTER = "after"
    EVENTUALLY = "eventually"
    STAYS = "stays"
    HOLDS = "holds"
    AT_MOST = "at-most"
    BEFORE = "first"
    AGAIN = "again"
    VISIT = "visit"


class VisitOrder(StrEnum):
    """In which order the conditions of a visit come: any; each for the first time in this one; only in this one, over
    and over.
    """

    ANY = "any"
    GIVEN = "given"
    TURN = "turn"


class _Shape(NamedTuple):
    """The attributes of a form: those of its conditions, others that it needs, and others that it may have."""

    conditions: tuple[str, ...]
    needed: tuple[str, ...] = ()
    allowed: tuple[str, ...] = ()


_SHAPES: dict[Form, _Shape] = {
    Form.NEVER: _Shape(("never",), allowed=("while",)),
    Form.AFTER: _Shape(("after", "eventually"), allowed=("within",)),
    Form.EVENTUALLY: _Shape(("eventually",), allowed=("within",)),
    Form.STAYS: _Shape(("stays", "until")),
    Form.HOLDS: _Shape(("holds",), ("for",)),
    Form.AT_MOST: _Shape(("at-most",), ("times",)),
    Form.BEFORE: _Shape(("first", "before")),
    Form.AGAIN: _Shape(("again",), allowed=("within",)),
    Form.VISIT: _Shape(("visit",), allowed=("order", "within")),
}
LISTS = (Form.AGAIN, Form.VISIT)
"""The forms with a list of conditions, with semicolons between them."""
TIMED = (Form.AFTER, Form.EVENTUALLY, Form.HOLDS, Form.AGAIN, Form.VISIT)
"""The forms that can have a time of their own."""
READY = ("contact", "empty-storehouse", "empty-swing", "stock", "deadlock", "delivered", "stopped", "end")
"""Names of properties that are checked unasked (`verifier.properties.properties`), and so are no names of others."""
READY_OF_AGENTS = ("served", "meets")
"""The same of those that are asked of each agent: the agent's name follows, behind a hyphen."""


def is_ready(name: str) -> bool:
    """Whether a name is that of a property that is checked unasked."""
    return name in READY or name.startswith(tuple(f"{one}-" for one in READY_OF_AGENTS))


LONGEST_NAME = 100
MOST_TIMES = 100
MOST_PLACES = 16
"""Conditions in a list at most."""


@dataclass(frozen=True, slots=True)
class AskedProperty:
    """One property.

    Attributes:
        name: its name in the mission.
        form: how it speaks of its conditions.
        first: the condition of its first attribute; of a form with a list, all of them with semicolons between them.
        second: the condition behind *eventually*, *until*, *before* or *while*; "" where there is none.
        seconds: the time behind *within* or *for*, in simulated seconds; 0 where there is none.
        times: how often at most; 0 where the form does not say.
        order: of a visit.
    """

    name: Annotated[str, MinLen(1), MaxLen(LONGEST_NAME)]
    form: Form
    first: Annotated[str, MaxLen(LONGEST_CONDITION)]
    second: Annotated[str, MaxLen(LONGEST_CONDITION)] = ""
    seconds: Annotated[float, Ge(0), Le(LONGEST_S)] = 0.0
    times: Annotated[int, Ge(0), Le(MOST_TIMES)] = 0
    order: VisitOrder = VisitOrder.ANY

    @property
    def texts(self) -> tuple[tuple[str, str], ...]:
        """What its attributes with conditions say, each with the attribute's name."""
        names = _SHAPES[self.form].conditions
        if self.form is Form.NEVER and self.second:
            names = ("never", "while")
        return tuple(zip(names, (self.first, self.second), strict=False))

    @property
    def conditions(self) -> tuple[tuple[str, str], ...]:
        """Its conditions, each with the name of its attribute; those of a list one by one."""
        if self.form in LISTS:
            return tuple((self.form.value, one) for one in split_conditions(self.first))
        return self.texts

    @property
    def counts_seconds(self) -> bool:
        """Whether it counts seconds, which the states of a check do not have."""
        return self.seconds > 0 or self.form is Form.HOLDS

    @property
    def words(self) -> Sentence:
        """What it demands."""
        plain = self._plain_words
        if self.seconds and self.form is not Form.HOLDS:
            time = f"{self.seconds:g}"
            if self.form is Form.AGAIN:
                return Sentence("{property}, each at most {seconds} s after the last time", plain, time)
            return Sentence("{question}, within {seconds} s", plain, time)
        return plain

    @property
    def _plain_words(self) -> Sentence:
        match self.form:
            case Form.NEVER if self.second:
                return Sentence("never `{condition}` while `{other}`", self.first, self.second)
            case Form.NEVER:
                return Sentence("never `{condition}`", self.first)
            case Form.AFTER:
                return Sentence("after `{first}` always eventually `{second}`", self.first, self.second)
            case Form.EVENTUALLY:
                return Sentence("eventually `{condition}`", self.first)
            case Form.STAYS:
                return Sentence("once `{first}`, it stays so until `{second}`", self.first, self.second)
            case Form.HOLDS:
                return Sentence("once `{first}`, it stays so for {seconds} s", self.first, f"{self.seconds:g}")
            case Form.AT_MOST:
                return Sentence.counted(
                    "`{condition}` at most {count} time", "`{condition}` at most {count} times", self.first, self.times
                )
            case Form.BEFORE:
                return Sentence("`{first}` comes before `{second}`", self.first, self.second)
            case Form.AGAIN:
                return Sentence("again and again {conditions}", self._listed)
            case Form.VISIT if self.order is VisitOrder.TURN:
                return Sentence("in turn {conditions}", self._listed)
            case Form.VISIT if self.order is VisitOrder.GIVEN:
                return Sentence("in this order {conditions}", self._listed)
            case Form.VISIT:
                return Sentence("in any order {conditions}", self._listed)

    @property
    def _listed(self) -> Series:
        return Series(COMMA, [Sentence("`{condition}`", text) for _, text in self.conditions])


def split_conditions(text: str) -> list[str]:
    """The conditions of a list: what stands between semicolons outside brackets."""
    parts, depth = [""], 0
    for sign in text:
        depth += (sign in "({[") - (sign in ")}]")
        if sign == ";" and depth == 0:
            parts.append("")
        else:
            parts[-1] += sign
    return [part.strip() for part in parts]


def has_form(element: Element) -> bool:
    """Whether an element has one of the attributes `FORMS` at all."""
    return any(word in element.attributes for word in FORMS)


def read_form(element: Element, name: str) -> AskedProperty | None:
    """Reads the property of that name from an element with the attributes `FORMS`; None if it has a mistake."""
    found = tuple(word for word in FORMS if word in element.attributes)
    form = next((form for form, shape in _SHAPES.items() if _is_shape(shape, found)), None)
    if form is None:
        message = Sentence(
            "the attributes of <{element}> are of none of the forms of a property: {found}",
            *(element.name, Series(COMMA, found)),
        )
        if not found:
            message = Sentence("expected what the <property> demands")
        help = Sentence('write one of these forms, such as never="any carrier (Collision.IsPressed())"')
        element.report(rules.PROPERTY_FORM, message, found[0] if found else None, help)
        return None
    shape = _SHAPES[form]
    conditions = shape.conditions + (("while",) if "while" in found else ())
    for word, longest in (("name", LONGEST_NAME), *((word, LONGEST_CONDITION) for word in conditions)):
        if len(element.optional(word)) > longest:
            message = Sentence(
                "expected at most {longest} characters in {attribute}, found {count}",
                *(longest, word, len(element.optional(word))),
            )
            element.report(rules.PROPERTY_FORM, message, word)
    time = next((word for word in ("within", "for") if word in found), "")
    seconds = element.decimal(time) if time else 0.0
    times = element.between("times", 0, MOST_TIMES) if "times" in found else 0
    order = VisitOrder(element.choice("order"))
    if time == "within" and seconds == 0 and not element.faulty:
        element.bad_value(time, Sentence("a number of seconds larger than 0"))
    first, second = [*(element.optional(word) for word in conditions), ""][:2]
    return None if element.faulty else AskedProperty(name, form, first, second, seconds, times, order)


def _is_shape(shape: _Shape, found: tuple[str, ...]) -> bool:
    wanted = {*shape.conditions, *shape.needed}
    return wanted <= set(found) <= wanted | set(shape.allowed)


_SECONDS = decimal(0.0, LONGEST_S)
FORMS: dict[str, Attribute] = {
    "never": optional(about="A condition that never holds."),
    "while": optional(about="Beside never: only while this condition holds."),
    "after": optional(about="A condition after which that of eventually comes, always."),
    "eventually": optional(about="A condition that comes in the end."),
    "stays": optional(about="A condition that, once it holds, holds on until that of until comes."),
    "until": optional(),
    "holds": optional(about="A condition that, once it holds, holds on for so many seconds."),
    "for": optional(_SECONDS),
    "at-most": optional(about="A condition that begins to hold at most so many times."),
    "times": optional(whole(0, MOST_TIMES)),
    "first": optional(about="A condition that comes before that of before."),
    "before": optional(),
    "again": optional(about="Conditions that each come again and again, with semicolons between them."),
    "visit": optional(about="Conditions that each come, with semicolons between them."),
    "order": optional(one(*VisitOrder), VisitOrder.ANY, about="Of a visit: the order in which they come."),
    "within": optional(_SECONDS, about="In how many simulated seconds what is expected comes."),
}
"""The attributes of an element that says a property."""
PROPERTIES: dict[str, Tag] = {
    "property": Tag(
        lambda element: read_form(element, element.required("name")),
        {"name": needed(), **FORMS},
        kept_whole=True,
        about="What is demanded of every run. Conditions are LLL such as any carrier (Cargo.IsPressed()).",
    )
}
"""Goes among the children of an element with `keep`."""


def write_property(one: AskedProperty) -> str:
    """One line without its break."""
    more = []
    if one.form is Form.AT_MOST:
        more.append(("times", str(one.times)))
    if one.form is Form.VISIT and one.order is not VisitOrder.ANY:
        more.append(("order", one.order.value))
    if one.form is Form.HOLDS or (one.form in TIMED and one.seconds):
        more.append(("for" if one.form is Form.HOLDS else "within", str(one.seconds).removesuffix(".0")))
    return f"<property{attributes(('name', one.name), *one.texts, *more)}/>"
