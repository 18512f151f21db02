"""A run of the model in words: who does what, where."""

from __future__ import annotations

from collections.abc import Iterator

from kitrobot.text import Sentence
from kitrobot.verifier.events import Event, What
from kitrobot.verifier.judging import Way
from kitrobot.verifier.model import Model, State
from kitrobot.verifier.motion import Move


def told(model: Model, way: Way) -> Iterator[tuple[int, Sentence]]:
    """What happens in a run, one sentence for each event of the world, with the number of its step."""
    for number, (step, state) in enumerate(zip(way.steps, way.states[1:], strict=True)):
        for event in step.events:
            if event.what is not What.TICK:
                yield number, say(model, event, state)
        for sentence in _of_team(model, way.states[number], state):
            yield number, sentence


def _of_team(model: Model, before: State, after: State) -> Iterator[Sentence]:
    """What a team that misses somebody makes of that in a step: who takes a role over, and whether it gives up."""
    if model.watch is None:
        return
    was, now = (model.watch.standing(model.agreed(model.shareds()[state[0]])) for state in (before, after))
    for part in model.parts:
        if now.plays >> part.agent.index & 1 and not was.plays >> part.agent.index & 1:
            yield Sentence("{agent} takes over a role", part.agent.name)
    if now.is_over and not was.is_over:
        yield Sentence("the team cannot go on")


def say(model: Model, event: Event, after: State) -> Sentence:
    """One event in words; `after` is the state at the end of its step."""
    name = model.parts[event.agent].agent.name
    world = model.run.world
    if event.what is Move.ZONE:
        return Sentence("{agent} comes to {place}", name, _place(model, event.agent, after))
    if isinstance(event.what, Move):
        other = model.parts[event.other].agent.name if event.other >= 0 else ""
        if event.what is Move.BEGIN:
            return Sentence("{agent} begins to roll", name)
        if event.what is Move.HALT:
            return Sentence("{agent} comes to stand at {place}", name, _place(model, event.agent, after))
        if event.what is Move.TOUCH:
            return Sentence("{agent} drives into {other}", name, other)
        if event.what is Move.CLOSER:
            return Sentence("{agent} comes near {other}", name, other)
        return Sentence("{other} gets away from {agent}", other, name)
    if event.what is What.LOADED:
        return Sentence("{agent} puts a box on {other}", name, model.parts[event.other].agent.name)
    if event.what is What.UNLOADED:
        return Sentence("{agent} takes the box of {other}", name, model.parts[event.other].agent.name)
    if event.what is What.NO_BOX:
        return Sentence("{agent} reaches into the empty storehouse {house}", name, world.storehouses[event.other].name)
    if event.what is What.NO_EMPTY_CARRIER:
        return Sentence("{agent} finds no empty carrier in dock {dock}", name, world.docks[event.other].name)
    if event.what is What.NO_LOADED_CARRIER:
        return Sentence("{agent} finds no loaded carrier in dock {dock}", name, world.docks[event.other].name)
    if event.what is What.FAIL:
        return Sentence("{agent} fails", name)
    if event.what is What.STALL:
        return Sentence("{agent} stalls: it misses its ticks", name)
    if event.what is What.MUTE:
        return Sentence("{agent} loses its radio", name)
    if event.what is What.MISSED:
        return Sentence("the team misses {agent}", name)
    if event.what is What.FREED:
        return Sentence("the lease of {agent} is over: its unit of work is free again", name)
    if event.what is What.RESUME:
        return Sentence("{agent} has its ticks again", name)
    return Sentence("{agent} has done what takes it longer", name)


def _place(model: Model, agent: int, state: State) -> str:
    """Where an agent is along its road: the millimetres of its zone."""
    part = model.parts[agent]
    assert part.track is not None
    begin, end = part.track.zones.ends(model.zone(state, agent))
    return f"{model.run.world.roads[part.road].name} {begin:.0f}–{end:.0f} mm"
