"""What a team declares, both ways: `<role>`, `<group>` and `<work>` in the `<team>` of a `.krt`.

Names in `members` are parted by spaces; one that is not made of letters and digits, joined by single hyphens, stands
between double quotes, as in LLL. A comment is a `<note>`, as those of vertices: above its line, or `after` it. Reading
what was written gives the same declarations. Left to others: whether the names mean anything (compiler).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeVar, cast

from kitrobot.graph.model import Note
from kitrobot.lll.parse_results import parse_names
from kitrobot.lll.tokens import team_name
from kitrobot.lll.tree import (
    FAILURES,
    MAX_NUMBER,
    AnyDeclaration,
    Declaration,
    Failure,
    GroupDeclaration,
    Members,
    RoleDeclaration,
    WorkDeclaration,
)
from kitrobot.primitives.attribute_kinds import IDENTIFIER
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import Kind, needed, one, optional, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.writer import attributes, escape_text

Made = TypeVar("Made", bound=Declaration)

_WANTED = whole(0, MAX_NUMBER)
_MEMBERS = Kind(
    shortest=1,
    fits=lambda text: bool(parse_names(text)),
    words=Sentence('names that are parted by spaces, or stand between double quotes ("),'),
)
_FAILURE = one(*FAILURES)


def _role(element: Element) -> RoleDeclaration | None:
    name, robot = element.required("name"), element.required("robot")
    least = element.integer("least", 1)
    most = element.integer("most", max(1, least))
    if least > most:
        element.bad_value("most", Sentence("a whole number from {least} to {most}", least, MAX_NUMBER))
    if not name or not robot:
        return None
    return _with_notes(RoleDeclaration(name, robot, least, max(least, most)), element)


def _group(element: Element) -> GroupDeclaration | None:
    name, names = element.required("name"), parse_names(element.matching("members"))
    failure = cast("Failure", element.choice("failure"))
    members = Members(names, braced=len(names) != 1)
    return _with_notes(GroupDeclaration(name, members, failure), element) if name and names else None


def _work(element: Element) -> WorkDeclaration | None:
    name, units = element.matching("name"), element.integer("units")
    lease = element.integer("lease") if "lease" in element.attributes else None
    return _with_notes(WorkDeclaration(name, units, lease), element) if name else None


def _with_notes(made: Made, element: Element) -> Made:
    for note in element.found(Note):
        lines = [line.rstrip() for line in note.text.split("\n")]
        if note.at:
            made.after = " ".join([*filter(None, (made.after,)), *lines]).rstrip()
        else:
            made.above += lines
    return made


def _note(element: Element) -> Note:
    return Note(element.text, element.choice("at", ""))


_NOTE = {"note": Tag(_note, {"at": optional(one("after"))}, text=True, about="A comment. at: after (same line).")}
DECLARATIONS = {
    "role": Tag(
        _role,
        {
            "name": needed(),
            "robot": needed(about="The kind of robot that can play it."),
            "least": optional(_WANTED, "1", about="How many of them are wanted at least."),
            "most": optional(_WANTED, about="And at most; else as many as at least, and one."),
        },
        _NOTE,
        about="A role that robots of one kind play.",
    ),
    "group": Tag(
        _group,
        {
            "name": needed(),
            "members": needed(_MEMBERS, about="Names of roles, groups and agents, parted by spaces."),
            "failure": optional(_FAILURE, FAILURES[0], about="What happens when a member fails."),
        },
        _NOTE,
        about="Roles, groups and agents under one name.",
    ),
    "work": Tag(
        _work,
        {
            "name": needed(IDENTIFIER),
            "units": needed(_WANTED),
            "lease": optional(_WANTED, about="Seconds after which an unfinished unit is free again; else never."),
        },
        _NOTE,
        about="Units of work that the robots of the team share out among themselves.",
    ),
}
"""Goes among the children of `<team>`, where `found` gives the declarations."""


def write_declarations(rows: Iterable[Sequence[AnyDeclaration]]) -> list[str]:
    """The elements of declarations, one a line."""
    return [_line(one) for row in rows for one in row]


def _line(declaration: AnyDeclaration) -> str:
    match declaration:
        case RoleDeclaration():
            least, most = declaration.least, declaration.most
            numbers = (("least", least if least != 1 else None), ("most", most if most != max(1, least) else None))
            name, head = "role", attributes(("name", declaration.name), ("robot", declaration.robot), *numbers)
        case GroupDeclaration():
            failure = declaration.failure if declaration.failure != FAILURES[0] else None
            members = " ".join(map(team_name, declaration.members.names))
            name, head = "group", attributes(("name", declaration.name), ("members", members), ("failure", failure))
        case WorkDeclaration():
            lease = ("lease", declaration.lease)
            name, head = "work", attributes(("name", declaration.name), ("units", declaration.units), lease)
    inside = _notes(declaration)
    return f"<{name}{head}>{inside}</{name}>" if inside else f"<{name}{head}/>"


def _notes(declaration: Declaration) -> str:
    above = f"<note>{escape_text(chr(10).join(declaration.above))}</note>" if declaration.above else ""
    after = declaration.after
    return above + ("" if after is None else f'<note at="after">{escape_text(after)}</note>')
