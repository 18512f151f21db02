"""A counterexample as pictures: the position of every robot and its program in each state, and the culprits.

A robot on a road is drawn in the middle of its zone, several in one zone one behind the other; a robot on no road is
drawn at its start. Not here: sentences (`counterexample_text`) and the vertex of an instruction (`image.DebugMap`).
"""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.image.instructions import FORK, JOIN
from kitrobot.sim.tables import columns as c
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.properties.properties import AgentFact, Condition, DockFact, SensedCondition
from kitrobot.verifier.properties.verdicts import Counterexample, Verdict
from kitrobot.verifier.report.counterexample_text import describe_event
from kitrobot.verifier.tables.bodies import FAILED
from kitrobot.verifier.tables.events import EventKind

MOST_SCENES = 120
"""Scenes of one run; of a longer one the first and the last."""
_MOST_CULPRITS = 6

Vertex = tuple[str, str]
"""A program and one of its vertices."""


@dataclass(frozen=True)
class SceneRobot:
    """One robot in a scene: its pose (mm, radians; rounded), and the vertices at which its program is."""

    x_mm: float
    y_mm: float
    heading_rad: float
    at: tuple[Vertex, ...]


@dataclass(frozen=True)
class Scene:
    """The picture before a step (the last one: after all steps). Robots are in the order of the team."""

    step: int
    robots: tuple[SceneRobot, ...]


@dataclass(frozen=True)
class Culprit:
    """A vertex at which a property is broken: its agent, what happens there, and whether it repeats for ever."""

    agent: str
    program: str
    vertex: str
    sentence: Sentence
    repeats: bool


def draw_scenes(model: Model, counterexample: Counterexample) -> tuple[Scene, ...]:
    """The scenes of a run."""
    count = len(counterexample.states)
    numbers = list(range(count))
    if count > MOST_SCENES:
        numbers = [*numbers[: MOST_SCENES // 2], *numbers[count - MOST_SCENES // 2 :]]
    return tuple(Scene(number, _robots(model, counterexample.states[number])) for number in numbers)


def find_culprits(model: Model, verdict: Verdict) -> tuple[Culprit, ...]:
    """Finds the vertices at which a property is broken; empty if no program is at any vertex."""
    counterexample = verdict.counterexample
    if counterexample is None:
        return ()
    if counterexample.repeats_from >= 0:
        return tuple(_for_ever(model, verdict, counterexample)[:_MOST_CULPRITS])
    before = counterexample.states[-2] if len(counterexample.states) > 1 else counterexample.states[-1]
    event = (
        next((one for one in reversed(counterexample.steps[-1].events) if one.what is not EventKind.TICK), None)
        if counterexample.steps
        else None
    )
    broken = verdict.property
    condition = (
        broken.never or (broken.breaks or (None,))[0] or (broken.history.conditions[-1] if broken.history else None)
    )
    if isinstance(condition, SensedCondition):
        return _at(model, before, condition.agents, verdict.property.sentence)
    if event is None:
        return ()
    return _at(model, before, (event.agent,), describe_event(model, event, counterexample.states[-1]))


def _at(model: Model, state: State, agents: tuple[int, ...], sentence: Sentence) -> tuple[Culprit, ...]:
    return tuple(
        Culprit(model.parts[i].agent.name, *vertex, sentence, False)
        for i in agents[:_MOST_CULPRITS]
        for vertex in _vertices(model, state, i)[:1]
    )


def _for_ever(model: Model, verdict: Verdict, counterexample: Counterexample) -> list[Culprit]:
    """The agents that stay at one vertex in the repeated part; if there are none, the agents that go round."""
    states = counterexample.states[counterexample.repeats_from :]
    concerned = _agents_of(verdict.property.waits)
    agents = [
        i
        for i in range(model.count)
        if (not concerned or i in concerned)
        and not model.has_ended(i, inside := model.inside(i, states[0][1 + i]))
        and inside.down != FAILED
    ]
    waits, rounds = [], []
    for i in agents:
        name = model.parts[i].agent.name
        places = [_vertices(model, state, i) for state in states]
        if not places[0]:
            continue
        if all(one == places[0] for one in places):
            waits.append(Culprit(name, *places[0][0], Sentence("{agent} waits here for ever", name), True))
        else:
            rounds.append(Culprit(name, *places[0][0], Sentence("{agent} goes round here for ever", name), True))
    return waits or rounds


def _agents_of(condition: Condition | None) -> set[int]:
    """The agents that a condition names; empty for all."""
    if condition is None:
        return set()
    if isinstance(condition, SensedCondition):
        return set(condition.agents)
    return {fact.agent for clause in condition for fact in clause if isinstance(fact, (AgentFact, DockFact))}


def _vertices(model: Model, state: State, i: int) -> tuple[Vertex, ...]:
    """The vertices of an agent's threads, except those that wait for others."""
    part = model.parts[i]
    debug, code = model.run.debug[part.agent.image_name], part.table.machine.image.code
    found: dict[Vertex, None] = {}
    for _, pc in part.table.places(model.inside(i, state[1 + i]).local):
        origin = debug.origins[pc] if pc < len(debug.origins) else None
        if origin is not None and origin.vertex and code[4 * pc] not in (FORK, JOIN):
            found[origin.program or part.agent.program, origin.vertex] = None
    return tuple(found)


def _robots(model: Model, state: State) -> tuple[SceneRobot, ...]:
    floats = model.run.state.robots.floats
    found = []
    for i, part in enumerate(model.parts):
        k = part.agent.index
        pose = float(floats[c.X][k]), float(floats[c.Y][k]), float(floats[c.HEADING][k])
        if part.track is not None:
            begin, end = part.track.zones.ends(model.zone(state, i))
            ahead, behind = _neighbours(model, state, i)
            at = begin + (end - begin) * (behind + 1) / (ahead + behind + 2)
            place = model.run.world.roads[part.road].line.pose_at(at)
            pose = place.x_mm, place.y_mm, place.heading_rad
        found.append(SceneRobot(round(pose[0], 1), round(pose[1], 1), round(pose[2], 3), _vertices(model, state, i)))
    return tuple(found)


def _neighbours(model: Model, state: State, i: int) -> tuple[int, int]:
    """How many robots are in the same zone ahead of one, and behind it."""
    found = []
    for side in ("leader", "follower"):
        count, other = 0, getattr(model.parts[i], side)
        while 0 <= other != i and model.zone(state, other) == model.zone(state, i) and count < model.count:
            count, other = count + 1, getattr(model.parts[other], side)
        found.append(count)
    return found[0], found[1]
