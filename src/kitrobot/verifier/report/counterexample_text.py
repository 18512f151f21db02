"""A counterexample in sentences: which agent does what, where, and the values of sensors that may read anything."""

from __future__ import annotations

from collections.abc import Iterator

from kitrobot.primitives.value_format import in_words
from kitrobot.sim.devices.base import Discrete
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.properties.verdicts import Counterexample, Step
from kitrobot.verifier.tables.bodies import RUNS
from kitrobot.verifier.tables.events import Event, EventKind
from kitrobot.verifier.tables.motion import Move


def describe_run(model: Model, counterexample: Counterexample) -> Iterator[tuple[int, Sentence]]:
    """What happens in a run, one sentence for each event of the world, with the number of its step."""
    said: dict[tuple[int, str], int] = {}
    for number, (step, state) in enumerate(zip(counterexample.steps, counterexample.states, strict=False)):
        for sentence in describe_step(model, state, step, said):
            yield number, sentence
    if counterexample.repeats_from >= len(counterexample.steps) > 0:
        last = counterexample.states[-1]
        for i, part in enumerate(model.parts):
            inside = model.inside(i, last[1 + i])
            if inside.down == RUNS and not model.has_ended(i, inside):
                yield len(counterexample.steps), Sentence("{agent} waits", part.agent.name)


def describe_step(model: Model, before: State, step: Step, said: dict[tuple[int, str], int]) -> Iterator[Sentence]:
    """What happens in a step, except ticks.

    Args:
        model: the model.
        before: the state before the step.
        step: the step.
        said: the values of readings that were said last, by agent and sensor: they are not said again. It is changed.
    """
    for event in step.events:
        if event.what is not EventKind.TICK:
            yield describe_event(model, event, step.state)
    for i, sensor, value in readings(model, before, step.state):
        if said.get((i, sensor)) != value:
            said[i, sensor] = value
            agent = model.parts[i].agent
            yield Sentence("{agent} reads {sensor} = {value}", agent.name, *in_words(agent.robot, sensor, value))
    yield from _of_team(model, before, step.state)


def describe_any_step(model: Model, before: State, step: Step) -> list[Sentence]:
    """What happens in a step; where that are ticks only, whose program goes on."""
    said = list(describe_step(model, before, step, {}))
    if said:
        return said
    return [
        Sentence("{agent} goes on in its program", part.agent.name)
        for i, part in enumerate(model.parts)
        if before[1 + i] != step.state[1 + i]
    ]


def free_readings(model: Model, counterexample: Counterexample) -> Sentence | None:
    """What a run takes for granted of sensors that may read anything; None where it needs none of them."""
    found = {
        Sentence("{agent}: {sensor}", agent.name, in_words(agent.robot, sensor, value)[0]): None
        for before, after in zip(counterexample.states, counterexample.states[1:], strict=False)
        for i, sensor, value in readings(model, before, after)
        for agent in [model.parts[i].agent]
    }
    if not found:
        return None
    return Sentence("this run needs readings that may never come so: {sensors}", Series(COMMA, found))


def readings(model: Model, before: State, after: State) -> Iterator[tuple[int, str, int]]:
    """Of a step that brought programs further what they read from sensors that may read anything: the number of the
    agent, the sensor, the value. Nothing of an agent whose tick cannot be told from its states.
    """
    for i, part in enumerate(model.parts):
        was, now = model.inside(i, before[1 + i]), model.inside(i, after[1 + i])
        if was.local == now.local or all(sense.discrete is not Discrete.ANY for sense in part.senses):
            continue
        for at, value in _chosen(model, i, before, after).items():
            yield i, part.agent.robot.sensors[at].name, value


def _chosen(model: Model, i: int, before: State, after: State) -> dict[int, int]:
    """Values of inputs with which a tick of agent i leads from one state to the other, as the world is in either."""
    part, local = model.parts[i], model.inside(i, after[1 + i]).local
    choices = {at: sense.choices for at, sense in enumerate(part.senses)}
    for world in (before, after):
        sensed, shared = model.sensed(i, (*world[: 1 + i], before[1 + i], *world[2 + i :]))
        rests = tuple(
            1 if sense.discrete is Discrete.BUSY else one for sense, one in zip(part.senses, sensed, strict=True)
        )
        for values in dict.fromkeys((sensed, rests)):
            for reaction, chosen in part.table.tries(model.inside(i, before[1 + i]).local, values, shared, choices):
                if reaction.local == local:
                    return chosen
    return {}


def _of_team(model: Model, before: State, after: State) -> Iterator[Sentence]:
    """The effects of an absence on a team in a step: roles taken over, and whether the team gives up."""
    if model.absence is None:
        return
    was, now = (model.absence.status(model.agreed(model.shareds()[state[0]])) for state in (before, after))
    for part in model.parts:
        if now.plays >> part.agent.index & 1 and not was.plays >> part.agent.index & 1:
            yield Sentence("{agent} takes over a role", part.agent.name)
    if now.is_over and not was.is_over:
        yield Sentence("the team cannot go on")


def describe_event(model: Model, event: Event, after: State) -> Sentence:
    """One event in words; `after` is the state at the end of its step."""
    name = model.parts[event.agent].agent.name
    world = model.run.world
    if event.what is Move.ZONE:
        return Sentence("{agent} comes to {place}", name, place_name(model, event.agent, after))
    if isinstance(event.what, Move):
        other = model.parts[event.other].agent.name if event.other >= 0 else ""
        if event.what is Move.BEGIN:
            return Sentence("{agent} begins to roll", name)
        if event.what is Move.HALT:
            return Sentence("{agent} comes to stand at {place}", name, place_name(model, event.agent, after))
        if event.what is Move.TOUCH:
            return Sentence("{agent} drives into {other}", name, other)
        if event.what is Move.CLOSER:
            return Sentence("{agent} comes near {other}", name, other)
        return Sentence("{other} gets away from {agent}", other, name)
    if event.what is EventKind.LOADED:
        return Sentence("{agent} puts a box on {other}", name, model.parts[event.other].agent.name)
    if event.what is EventKind.UNLOADED:
        return Sentence("{agent} takes the box of {other}", name, model.parts[event.other].agent.name)
    if event.what is EventKind.NO_BOX:
        return Sentence("{agent} reaches into the empty storehouse {house}", name, world.storehouses[event.other].name)
    if event.what is EventKind.NO_EMPTY_CARRIER:
        return Sentence("{agent} finds no empty carrier in dock {dock}", name, world.docks[event.other].name)
    if event.what is EventKind.NO_LOADED_CARRIER:
        return Sentence("{agent} finds no loaded carrier in dock {dock}", name, world.docks[event.other].name)
    if event.what is EventKind.FAIL:
        return Sentence("{agent} fails", name)
    if event.what is EventKind.STALL:
        return Sentence("{agent} stalls: it misses its ticks", name)
    if event.what is EventKind.MUTE:
        return Sentence("{agent} loses its radio", name)
    if event.what is EventKind.MISSED:
        return Sentence("the team misses {agent}", name)
    if event.what is EventKind.FREED:
        return Sentence("the lease of {agent} is over: its unit of work is free again", name)
    if event.what is EventKind.RESUME:
        return Sentence("{agent} has its ticks again", name)
    return Sentence("{agent} has done what takes it longer", name)


def place_name(model: Model, agent: int, state: State) -> str:
    """Where an agent on a road is: the road and the millimetres of its zone."""
    part = model.parts[agent]
    assert part.track is not None
    begin, end = part.track.zones.ends(model.zone(state, agent))
    return f"{model.run.world.roads[part.road].name} {begin:.0f}–{end:.0f} mm"
