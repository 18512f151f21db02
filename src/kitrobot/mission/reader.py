"""Missions from XML: own parts, programs, team, and the world or the name of its file."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import NamedTuple

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.graph.graph_xml import PROGRAM
from kitrobot.graph.model import Program
from kitrobot.lll.tree import GroupDeclaration, RoleDeclaration, WorkDeclaration
from kitrobot.mission import rules
from kitrobot.mission.breakdown import BREAKDOWN, the_breakdown
from kitrobot.mission.declarations import DECLARATIONS
from kitrobot.mission.migrations import migrate
from kitrobot.mission.model import ALL, VERSION, Agent, Goal, Mission, Team
from kitrobot.mission.property_forms import PROPERTIES, AskedProperty
from kitrobot.mission.radio import RADIO, Radio
from kitrobot.mission.trial import TRIAL, Breakpoint, Failure, check_trial
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.own_xml import OWN, OwnVariable
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.world.model import World
from kitrobot.world.parts import PARTS
from kitrobot.world.xml_reader import ATTRIBUTES, keep_unknown, read_plan, with_things
from kitrobot.xml.attributes import Kind, needed, one, optional, version, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXTS

LARGEST_GOAL = 65535
"""The largest stock that a goal may ask for."""


class _Where(NamedTuple):
    """Where a mission takes place: in the world of a file, or in one of its own."""

    href: str
    own: World | None = None
    seen: int = 0
    """How many diagnostics there were when the world had been read."""


class _Version(int):
    """The version that a mission's file says, as far as it is one."""


def _open(element: Element) -> None:
    element.values.append((_Version(element.version(VERSION)), element))


def _agent(element: Element) -> Agent:
    start, robot = element.optional("start"), element.optional("robot")
    return Agent(element.required("name"), element.required("program"), start, robot)


def is_goal_stock(stock: str) -> bool:
    """Whether a goal may ask for this stock: a whole number up to `LARGEST_GOAL`, or all."""
    return stock == ALL or (stock.isascii() and stock.isdigit() and len(stock) < 9 and int(stock) <= LARGEST_GOAL)


def describe_goal_stock(stock: str) -> Sentence:
    """What is wrong with another one."""
    return Sentence('expected a whole number from 0 to 65535 or "{all}" in stock, found {stock}', ALL, shown(stock))


def _goal(element: Element) -> Goal | None:
    stock = element.optional("stock", ALL)
    if not is_goal_stock(stock):
        element.report(rules.GOAL, describe_goal_stock(stock), "stock")
        return None
    storehouse = element.required("storehouse")
    return Goal(storehouse, stock) if storehouse else None


def _team(element: Element) -> Team:
    agents = element.distinct(Agent, lambda agent: agent.name, "agent")
    return Team(
        [agent for agent in agents if agent.name],
        element.found(Goal),
        element.distinct(RoleDeclaration, lambda role: role.name, "role"),
        element.distinct(GroupDeclaration, lambda group: group.name, "group"),
        element.distinct(WorkDeclaration, lambda work: work.name, "work"),
    )


def _world(element: Element) -> _Where | None:
    if not element.attributes and not element.values and not element.texts:
        element.required("href")
        return None
    if "href" not in element.attributes:
        own = read_plan(element)
        return None if own is None else _Where("", own, len(element.reader.diagnostics))
    if element.values or element.texts or any(name in element.attributes for name in ATTRIBUTES):
        message = Sentence('expected href="…" on <world> or the world itself, found both')
        element.report(rules.WORLD, message, help=Sentence("take one of the two away"))
        return None
    href = element.required("href")
    return _Where(href) if href else None


class _Unknown(str):
    """XML of a mission that we do not know."""

    __slots__ = ()


def _keep(element: Element, raw: str) -> None:
    element.values.append((_Unknown(raw), element))


_GOAL = Tag(_goal, {"storehouse": needed(), "stock": optional(Kind(either=(one(ALL), whole(0, LARGEST_GOAL))), ALL)})
_AGENT = Tag(
    _agent,
    {
        "name": needed(),
        "program": needed(),
        "start": optional(about="A start of the world; else the one with the agent's name."),
        "robot": optional(about="Its kind of robot, where its program is the whole team's."),
    },
)
_WORLD = Tag(
    _world,
    {"href": optional(), **{name: replace(attribute, needed=False) for name, attribute in ATTRIBUTES.items()}},
    {**TEXTS, **PARTS},
    keep=keep_unknown,
    kept_whole=True,
    keeps_foreign=True,
    about="The name of a world's file in href, or a world of this mission's own.",
)
MISSION = {
    "kitrobot": Tag(
        attributes={"version": version(VERSION)},
        children={
            **TEXTS,
            **OWN,
            **TRIAL,
            **PROPERTIES,
            **RADIO,
            **BREAKDOWN,
            "program": PROGRAM,
            "team": Tag(_team, children={"agent": _AGENT, "goal": _GOAL, **DECLARATIONS}),
            "world": _WORLD,
        },
        open=_open,
        keep=_keep,
        keeps_foreign=True,
        unique=("program",),
        about="A mission, the .krt file: programs as graphs, the team that runs them, and where.",
    )
}
"""The first element of a mission's file."""


def read_mission(data: bytes, name: str) -> tuple[Mission | None, list[Diagnostic]]:
    """A mission and what is wrong with it; None when nothing of the file can be used.

    Args:
        data: the file as it is.
        name: what people call it, for messages.
    """
    reader = Reader(data, name)
    root = reader.read(MISSION)
    if root is None:
        return None, reader.diagnostics
    version = next(iter(root.found(_Version)), VERSION)
    mission = Mission(int(version), root.distinct(Program, lambda program: program.name, "program"))
    for team in root.found(Team):
        for part in fields(Team):
            getattr(mission.team, part.name).extend(getattr(team, part.name))
    places = root.found_at(_Where)
    for where, _ in places[:1]:
        mission.world_href, mission.own_world = where.href, where.own
    for _, element in places[1:]:
        element.report(
            rules.WORLD,
            Sentence("this mission has a world already; this one is left out"),
            help=Sentence("take one away"),
        )
    mission.label, mission.help = root.texts.get("label", {}), root.texts.get("help", {})
    mission.constructors, mission.variables = root.found(Constructor), root.found(OwnVariable)
    mission.breakpoints, mission.failures = root.found(Breakpoint), root.found(Failure)
    radios = root.found_at(Radio)
    mission.radio = radios[0][0] if radios else None
    for _, element in radios[1:]:
        message = Sentence("this mission has a radio already; this one is left out")
        element.report(rules.RADIO, message, help=Sentence("take one away"))
    mission.breakdown = the_breakdown(root)
    mission.properties = root.distinct(AskedProperty, lambda asked: asked.name, "property")
    mission.unknown = [*(str(raw) for raw in root.found(_Unknown)), *reader.epilog]
    mission.prolog, mission.attributes = reader.prolog, root.foreign
    _check(mission, root)
    diagnostics = reader.diagnostics
    for where, element in places[:1]:
        diagnostics[: where.seen] = with_things(element, diagnostics[: where.seen])
    return migrate(mission), diagnostics


def _check(mission: Mission, root: Element) -> None:
    """That every agent runs a program of this mission."""
    names = dict.fromkeys(program.name for program in mission.programs)
    check_trial([agent.name for agent in mission.team.agents], mission.radio is not None, root)
    for _, team in root.found_at(Team):
        for agent, element in team.found_at(Agent):
            if agent.program and agent.program not in names:
                message = Sentence(
                    "{agent} runs the program {program}, which is not in this mission", agent.name, shown(agent.program)
                )
                element.report(rules.NO_PROGRAM, message, "program", element.did_you_mean(agent.program, names))
