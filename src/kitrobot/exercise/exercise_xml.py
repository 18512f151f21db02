"""Exercise XML → an `Exercise`.

An exercise with an error is not used: its goals would be judged wrongly. Its diagnostics say where it is wrong. Left to
others: whether `start` is there, and whether the parts and agents that goals name exist (workspace).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.exercise import rules
from kitrobot.exercise.goals import (
    AvoidanceGoal,
    CheckGoal,
    DoneGoal,
    DrawingGoal,
    Goal,
    NoContactGoal,
    Parts,
    TimeLimitGoal,
    UseGoal,
    VisitGoal,
)
from kitrobot.exercise.model import Exercise, Seed
from kitrobot.mission.property_forms import FORMS, has_form, read_form
from kitrobot.text.sentences import Sentence
from kitrobot.xml.attributes import NAME, YES_NO, Attribute, decimal, needed, one, optional, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.lessons import lesson_tag, require_label
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXT

VERSION = 1
"""The newest version of the format that is read."""

MOST_GOALS = 30
MOST_SEEDS = 50
LONGEST_S = 600.0
"""Simulated seconds that a run of an exercise may take."""
MOST_STATES = 1_000_000
USUAL_SECONDS = "120"
TIMINGS = ("lockstep", "prompt", "free")
PROPERTIES = (
    *("contact", "empty-storehouse", "empty-swing", "stock", "deadlock", "delivered", "served", "meets", "stopped"),
    "end",
)
_LARGEST_SEED = 2**31 - 1
_FAR = 100_000.0


def read_exercise(data: bytes, name: str) -> tuple[Exercise | None, list[Diagnostic]]:
    """Reads an exercise; None when it has an error, which the diagnostics tell."""
    reader = Reader(data, name)
    root = reader.read(EXERCISE)
    if root is None:
        return None, reader.diagnostics
    start = root.matching("start")
    icon = root.matching("icon", "target")
    seconds = root.decimal("seconds")
    goals, seeds = root.found(Goal), root.distinct(Seed, lambda seed: str(seed.value), "seed") or [Seed(1)]
    require_label(root, rules.START, Sentence("say what the exercise is called"))
    if not root.faulty and all(goal.hidden for goal in goals):
        root.report(rules.START, Sentence("expected a goal that is not hidden, found none"))
    if len(goals) > MOST_GOALS:
        root.report(rules.START, Sentence("expected at most {most} goals, found {found}", MOST_GOALS, len(goals)))
    if not root.faulty and all(seed.hidden for seed in seeds):
        root.report(rules.START, Sentence("expected a seed that is not hidden, found none"))
    if len(seeds) > MOST_SEEDS:
        root.report(rules.START, Sentence("expected at most {most} seeds, found {found}", MOST_SEEDS, len(seeds)))
    for goal, element in root.found_at(TimeLimitGoal):
        if goal.seconds > seconds:
            words = Sentence("expected at most the {seconds} seconds of a run, found more", f"{seconds:g}")
            element.report(rules.GOAL, words, "seconds")
    for check, element in root.found_at(CheckGoal):
        if check.asked is not None and check.asked.seconds >= seconds:
            # A run that ends with the deadline does not show what comes too late.
            words = Sentence("expected less than the {seconds} seconds of a run, found no less", f"{seconds:g}")
            element.report(rules.GOAL, words, "within" if "within" in element.attributes else "for")
    if root.faulty:
        return None, reader.diagnostics
    label, help = root.texts.get("label", {}), root.texts.get("help", {})
    order = root.integer("order")
    return Exercise(start, label, help, icon, seconds, tuple(goals), tuple(seeds), order), reader.diagnostics


def _goal(kind: Callable[..., Goal], own: dict[str, Attribute]) -> Callable[[Element], Goal]:
    """Reads the goal of that class, whose own fields are the attributes `own`."""

    def read(element: Element) -> Goal:
        if "" not in element.texts.get("label", {}):
            words = Sentence("expected a <label> in English in <{element}>, found none", element.name)
            element.report(rules.GOAL, words, help=Sentence("say the goal in words that a child reads"))
        values = {name: _value(element, name, attribute) for name, attribute in own.items()}
        return kind(
            label=element.texts.get("label", {}),
            points=element.integer("points"),
            hidden=element.flag("hidden"),
            **values,
        )

    return read


def _check_goal(element: Element) -> Goal:
    """Reads a goal whose property is a ready one, or has a form of a mission's."""
    asked = read_form(element, "asked") if has_form(element) else None
    if has_form(element) and "property" in element.attributes:
        words = Sentence("expected a ready property or one of your own in <{element}>, found both", element.name)
        help = Sentence('leave out property="…", or make two goals of it')
        element.report(rules.GOAL, words, "property", help)
    name = str(asked.words) if asked is not None else "" if has_form(element) else element.choice("property")
    made = _goal(partial(CheckGoal, property=name, asked=asked, place=element.place()), _OF_CHECKS)(element)
    used = [word for word in _OF_CHECKS if word in element.attributes]
    if used and asked is not None and asked.counts_seconds:
        words = Sentence("{attribute} is of a check, and this property counts seconds, so runs judge it", used[0])
        element.report(rules.GOAL, words, used[0], Sentence("leave it out"))
    return made


def _value(element: Element, name: str, attribute: Attribute) -> str | int | float:
    kind = attribute.kind
    if kind is YES_NO:
        return element.flag(name)
    if kind.options:
        return element.choice(name)
    if kind.base == "integer":
        return element.integer(name)
    if kind.base == "double":
        return element.decimal(name)
    return element.required(name) if attribute.needed else element.optional(name)


def _seed(element: Element) -> Seed:
    return Seed(element.integer("value"), element.flag("hidden"))


def _tag(kind: Callable[..., Goal], about: str, own: dict[str, Attribute] | None = None) -> Tag:
    own = own or {}
    common = {
        "points": optional(whole(0, 100), "1", about="How many points it counts."),
        "hidden": optional(YES_NO, "no", about="Judged for the teacher only."),
    }
    label = replace(TEXT, about="The goal in words that a child reads.")
    return Tag(_goal(kind, own), {**own, **common}, {"label": label}, least=1, about=about)


_LENGTH = decimal(1, _FAR)
_PLACE = decimal(-_FAR, _FAR)
_AGENT = optional(NAME, about="The agent that is meant.")
_PROGRAM = optional(NAME, about="The program that is meant; all together, when left out.")
_PART = needed(NAME, about="A constructor, such as Parallelism, or a part's method, such as Wheel.Advance.")
_OF_CHECKS = {
    "timing": optional(one(*TIMINGS), "lockstep", about="The assumption about time."),
    "failures": optional(whole(0, 1), "0", about="Up to so many failures."),
    "states": optional(whole(1000, MOST_STATES), "100000", about="Where the exact search is cut."),
    "approximate": optional(
        YES_NO, "no", about="Whether it is enough that an approximate search behind it finds nothing."
    ),
}
KINDS = {
    "done": _tag(DoneGoal, "Every run ends as done: the mission's goals are reached, or all programs ended."),
    "within": _tag(TimeLimitGoal, "Every run is done after that time.", {"seconds": needed(decimal(0.1, LONGEST_S))}),
    "no-contact": _tag(NoContactGoal, "Nothing is touched.", {"agent": _AGENT}),
    "visits": _tag(
        VisitGoal,
        "The agent comes near that place of the world, in mm.",
        {
            "x": needed(_PLACE),
            "y": needed(_PLACE),
            "radius": optional(_LENGTH, "50", about="How near, in mm."),
            "agent": _AGENT,
            "when": optional(one("ever", "end"), "ever", about="At any time, or when the run ends."),
        },
    ),
    "draws": _tag(
        DrawingGoal,
        "The driven way is a regular figure, once around, back to where it began.",
        {
            "corners": needed(whole(3, 12)),
            "side": optional(_LENGTH, "100", about="Each side is at least so long, in mm."),
            "tolerance": optional(decimal(1, 1000), "30", about="In mm; see the documentation."),
            "agent": _AGENT,
            "by": optional(one("way", "pen"), "way", about="The driven way, or what the pen drew in one line."),
        },
    ),
    "uses": _tag(
        UseGoal,
        "A part is used.",
        {"part": _PART, "times": optional(whole(1, 100), "1", about="How often, at least."), "program": _PROGRAM},
    ),
    "avoids": _tag(AvoidanceGoal, "A part is not used.", {"part": _PART, "program": _PROGRAM}),
    "parts": _tag(Parts, "There are not more parts.", {"most": needed(whole(1, 1000)), "program": _PROGRAM}),
    "holds": replace(
        _tag(
            CheckGoal,
            "A property holds: a ready one of `kitrobot verify`, or one in a form of a mission's properties.",
            {"property": optional(one(*PROPERTIES), about="A ready one."), **FORMS, **_OF_CHECKS},
        ),
        close=_check_goal,
    ),
}
"""The element of each kind of goal."""

EXERCISE = {
    "exercise": lesson_tag(
        VERSION,
        {
            **KINDS,
            "seed": Tag(
                _seed,
                {
                    "value": needed(whole(0, _LARGEST_SEED)),
                    "hidden": optional(YES_NO, "no", about="For the teacher only."),
                },
                about="Where chance begins in one of the runs; without any there is one run, of seed 1.",
            ),
        },
        {"seconds": optional(decimal(1, LONGEST_S), USUAL_SECONDS, about="The simulated time that each run may take.")},
        about="An exercise: a mission to begin with, and goals that are decided by running and checking what was made "
        "of it.",
    )
}
"""The first element of an exercise's file."""
