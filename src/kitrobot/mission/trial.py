"""What a mission says about trying it out, both ways: where a run pauses, and what goes wrong when.

A `<breakpoint>` pauses a run when an agent comes to a vertex; a `<failure>` makes an agent fail, stall, lose its radio
or come back at a moment of simulated time. Both are kept in the `.krt`, so they are there before the run starts and
travel with it. A breakpoint of a vertex that is gone stays in the file and
does nothing; whoever checks the mission says so.

Left to others: doing it (sim and whoever steers a run).
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated

from annotated_types import Ge, Le, MaxLen

from kitrobot.mission import rules
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import YES_NO, decimal, needed, one, optional, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.writer import attributes

MOST_HITS = 1_000_000
LONGEST_S = 1_000_000.0
"""The latest moment of a failure, in simulated seconds."""
LONGEST_CONDITION = 1_000
"""Characters of a breakpoint's condition."""


@dataclass(frozen=True)
class Breakpoint:
    """Where a run pauses.

    `agents` are those it watches, all that run the program when empty; with `every` it pauses only when all of them
    stand there. `when` is a condition of LLL, tested with what that agent knows; it pauses at the visit number `hits`
    and at each one after it.
    """

    program: str
    vertex: str
    agents: tuple[str, ...] = ()
    every: bool = False
    when: Annotated[str, MaxLen(LONGEST_CONDITION)] = ""
    hits: Annotated[int, Ge(1), Le(MOST_HITS)] = 1
    enabled: bool = True


class FailureKind(StrEnum):
    """What happens to an agent: it stops for good, misses its ticks, loses its radio, is well again, or is cut off: it
    hears, and is heard by, only those that are cut off too.
    """

    FAIL = "fail"
    STALL = "stall"
    MUTE = "mute"
    REVIVE = "revive"
    APART = "apart"


@dataclass(frozen=True)
class Failure:
    """What happens to an agent, and when, in simulated seconds."""

    agent: str
    at_s: Annotated[float, Ge(0), Le(LONGEST_S)]
    kind: FailureKind = FailureKind.FAIL


class _WatchedAgent(str):
    """An agent that a breakpoint watches."""

    __slots__ = ()


def _watched(element: Element) -> _WatchedAgent:
    return _WatchedAgent(element.required("name"))


def _breakpoint(element: Element) -> Breakpoint | None:
    program, vertex = element.required("program"), element.required("vertex")
    when = element.optional("when")
    if len(when) > LONGEST_CONDITION:
        message = Sentence("expected at most {longest} characters in when, found {count}", LONGEST_CONDITION, len(when))
        element.report(rules.BREAKPOINT, message, "when")
    every, hits = element.flag("every"), element.integer("hits")
    enabled = not element.flag("off")
    if element.faulty:
        return None
    return Breakpoint(program, vertex, tuple(element.found(_WatchedAgent)), every, when, hits, enabled)


def _failure(element: Element) -> Failure | None:
    agent = element.required("agent")
    at_s = round(element.decimal("at"), 3)
    kind = FailureKind(element.choice("kind"))
    return None if element.faulty else Failure(agent, at_s, kind)


TRIAL: dict[str, Tag] = {
    "breakpoint": Tag(
        _breakpoint,
        {
            "program": needed(),
            "vertex": needed(),
            "every": optional(YES_NO, "no", about="Whether all of them must stand there."),
            "when": optional(about="A condition of LLL."),
            "hits": optional(whole(1, MOST_HITS), "1", about="The first visit that counts."),
            "off": optional(YES_NO, "no"),
        },
        {"agent": Tag(_watched, {"name": needed()}, about="Whom it watches; without any, all that run the program.")},
        kept_whole=True,
        about="A run pauses when an agent comes to this vertex.",
    ),
    "failure": Tag(
        _failure,
        {
            "agent": needed(),
            "at": needed(decimal(0.0, LONGEST_S)),
            "kind": optional(one(*(kind.value for kind in FailureKind)), FailureKind.FAIL.value),
        },
        kept_whole=True,
        about="What happens to an agent at so many simulated seconds.",
    ),
}
"""Goes among the children of an element with `keep`."""


def write_breakpoint(breakpoint: Breakpoint) -> str:
    """One line without its break."""
    head = attributes(
        ("program", breakpoint.program),
        ("vertex", breakpoint.vertex),
        ("every", "yes" if breakpoint.every else None),
        ("when", breakpoint.when or None),
        ("hits", breakpoint.hits if breakpoint.hits != 1 else None),
        ("off", None if breakpoint.enabled else "yes"),
    )
    watched = "".join(f"<agent{attributes(('name', name))}/>" for name in breakpoint.agents)
    return f"<breakpoint{head}>{watched}</breakpoint>" if watched else f"<breakpoint{head}/>"


def write_failure(failure: Failure) -> str:
    """One line without its break."""
    at = f"{failure.at_s:.3f}".rstrip("0").rstrip(".")
    return f"<failure{attributes(('agent', failure.agent), ('at', at), ('kind', failure.kind.value))}/>"


def check_trial(agents: list[str], has_radio: bool, root: Element) -> None:
    """That every failure happens to somebody of the team, and that who is cut off has a radio."""
    names = dict.fromkeys(agents)
    for failure, element in root.found_at(Failure):
        if failure.agent not in names:
            message = Sentence("{agent}, which is to {kind}, is not in the team", shown(failure.agent), failure.kind)
            element.report(rules.FAILURE, message, "agent", element.did_you_mean(failure.agent, agents))
        elif failure.kind is FailureKind.APART and not has_radio:
            message = Sentence("{agent} cannot be cut off from others: this mission has no radio", shown(failure.agent))
            element.report(rules.FAILURE, message, "kind", Sentence("write <radio/> into the mission"))
