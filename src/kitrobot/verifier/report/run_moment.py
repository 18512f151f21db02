"""Where in a run of the simulator the moment lies that decided a run of the model.

The two runs have the same events for a while, but not the same times. So the moment is where the same happens to the
same robot, counted from the end; where the simulator does not tell that event, there is none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.properties.verdicts import Counterexample
from kitrobot.verifier.report.replay import FAULT_KINDS, ConfirmedRun
from kitrobot.verifier.tables.events import Event, EventKind
from kitrobot.verifier.tables.motion import Move

_SWINGS: dict[int, int] = {
    EventKind.LOADED: c.LOADED,
    EventKind.UNLOADED: c.UNLOADED,
    EventKind.NO_EMPTY_CARRIER: c.NO_EMPTY_CARRIER,
    EventKind.NO_LOADED_CARRIER: c.NO_LOADED_CARRIER,
    EventKind.NO_BOX: c.NO_BOX,
}


def find_run_moment(
    model: Model,
    run: Counterexample,
    step: int,
    events: list[Event],
    confirmed: ConfirmedRun,
    fresh: Callable[[int], Simulation],
    stop: Callable[[], bool],
) -> int:
    """The step of the simulator before which the deciding events come; -1 where that cannot be told.

    Args:
        model: the model.
        run: the run of the model.
        step: the step of it that decided.
        events: its deciding events.
        confirmed: the run of the simulator.
        fresh: makes the run of a seed, before its first step.
        stop: polled now and then; True stops the search.
    """
    if run.repeats_from < 0 and step == len(run.steps) - 1:
        return max(0, confirmed.tick - 1)
    for event in events:
        if event.what in FAULT_KINDS:
            number = sum(one.what in FAULT_KINDS for each in run.steps[:step] for one in each.events)
            return confirmed.faults[number].tick if number < len(confirmed.faults) else -1
    for event in events:
        if event.what in _SWINGS or isinstance(event.what, Move):
            later = sum(
                _is_alike(model, run, number, one, step, event)
                for number in range(step + 1, len(run.steps))
                for one in run.steps[number].events
            )
            zone = model.zone(run.states[step + 1], event.agent) if isinstance(event.what, Move) else -1
            ticks = list(_ticks_of(model, event, zone, confirmed, fresh(confirmed.seed), stop))
            return ticks[-1 - later] if later < len(ticks) else -1
    return -1


def _is_alike(model: Model, run: Counterexample, number: int, one: Event, step: int, event: Event) -> bool:
    """Whether an event of a step is the same as another one of another step."""
    if not isinstance(event.what, Move):
        return one == event
    zone, there = model.zone(run.states[step + 1], event.agent), model.zone(run.states[number + 1], event.agent)
    return one.what is Move.ZONE and one.agent == event.agent and zone == there


def _ticks_of(
    model: Model, event: Event, zone: int, confirmed: ConfirmedRun, run: Simulation, stop: Callable[[], bool]
) -> Iterator[int]:
    """The steps of a run before which an event comes: a robot comes into a zone (-1: an arm has swung)."""
    part, left = model.parts[event.agent], list(confirmed.faults)
    was = -1
    while run.tick < confirmed.tick and run.outcome is None and not stop():
        while left and run.tick >= left[0].tick:
            fault = left.pop(0)
            run.inject_fault(fault.agent, fault.kind)
        run.advance(1)
        if zone < 0:
            if _has_swung(run, part.agent.index, _SWINGS[event.what]):
                yield run.tick - 1
        elif part.track is not None:
            now = part.track.zones.zone_at(float(run.state.robots.floats[c.AT][part.agent.index]))
            if now == zone != was:
                yield run.tick - 1
            was = now


def _has_swung(run: Simulation, robot: int, kind: int) -> bool:
    events = run.state.events
    return any(
        events[at] == kind and events[at + 1] == robot
        for at in range(0, c.EVENT * int(run.state.clock[c.EVENTS]), c.EVENT)
    )
