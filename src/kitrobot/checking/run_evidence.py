"""What a run shows of the goals of an exercise: its end, contacts, paths, lines, and properties that are watched."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from kitrobot.exercise.evidence import CheckEvidence, Contact, PathPoint, RunEvidence
from kitrobot.sim.recorder import strokes_now
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.pens import pens_of
from kitrobot.trace.drawing import Drawing
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.report.replay import RunObserver

STRETCH: Final = 250
"""Steps of the simulator between two looks at `stop`."""
LEAST_MOVE_MM: Final = 1.0
"""Points of a path are at least so far apart."""


def collect_run_evidence(
    simulation: Simulation,
    seed: int,
    with_paths: bool,
    stop: Callable[[], bool] = lambda: False,
    watched: Mapping[str, Property] | None = None,
) -> RunEvidence | None:
    """Runs a simulation that has a time limit to its end; None when `stop` said so before. `watched` are the properties
    that are judged by it, by their names in the evidence.
    """
    # Compiling takes longer than the runs of an exercise.
    simulation.stays_plain = True
    names = [agent.name for agent in simulation.members]
    paths: list[list[PathPoint]] = [[PathPoint(x, y, 0.0)] for x, y, *_ in simulation.poses()]
    contacts: list[Contact] = []
    drawing = Drawing(pens_of(simulation.members))
    watch = _PropertyWatch(watched or {}, simulation, seed)
    while simulation.outcome is None:
        if simulation.tick % STRETCH == 0 and stop():
            return None
        simulation.advance(1 if with_paths or watched else STRETCH)
        watch.after_step()
        for event in simulation.events:
            if event.kind == "collision":
                contacts.append(Contact(event.agent, event.tick * simulation.tick_ms / 1000, event.text))
        if with_paths:
            drawing.add(simulation.drawn)
            _follow(simulation, paths)
    if with_paths:
        for path, (x, y, *_) in zip(paths, simulation.poses(), strict=True):
            path.append(PathPoint(x, y, simulation.seconds))
    return RunEvidence(
        seed,
        simulation.outcome,
        simulation.sentence,
        simulation.seconds,
        tuple(contacts),
        {name: tuple(path) for name, path in zip(names, paths, strict=True)} if with_paths else None,
        _lines(simulation, drawing) if with_paths else None,
        watch.at_end(simulation.outcome),
    )


class _PropertyWatch:
    """Watches a run, before its first step, for properties."""

    def __init__(self, properties: Mapping[str, Property], run: Simulation, seed: int) -> None:
        self._properties, self._run, self._seed = properties, run, seed
        self._open = {name: RunObserver(one, run) for name, one in properties.items()}
        self._found: dict[str, CheckEvidence] = {}

    def after_step(self) -> None:
        """Looks at the step that was just made."""
        for name, one in tuple(self._open.items()):
            broken_at = one.violation()
            if broken_at >= 0 or one.is_kept:
                self._decide(name, broken_at)

    def at_end(self, outcome: str) -> dict[str, CheckEvidence]:
        """What the run, which ended so, says of each property."""
        for name, one in tuple(self._open.items()):
            self._decide(name, self._run.tick if one.is_broken_by_end(outcome) else -1)
        return self._found

    def _decide(self, name: str, broken_at: int) -> None:
        is_vacuous, words = self._open.pop(name).is_vacuous, self._properties[name].sentence
        if broken_at >= 0:
            seconds = broken_at * self._run.tick_ms / 1000
            self._found[name] = CheckEvidence("broken", words, self._seed, seconds)
        else:
            self._found[name] = CheckEvidence("vacuous" if is_vacuous else "holds", words, self._seed)


def _lines(simulation: Simulation, drawing: Drawing) -> dict[str, tuple[tuple[PathPoint, ...], ...]]:
    """What each agent's pens drew."""
    found: dict[str, tuple[tuple[PathPoint, ...], ...]] = {agent.name: () for agent in simulation.members}
    for stroke in strokes_now(simulation, drawing):
        name = simulation.members[drawing.pens[stroke.pen].agent].name
        found[name] += (tuple(PathPoint(x, y, simulation.seconds) for x, y in stroke.points),)
    return found


def _follow(simulation: Simulation, paths: list[list[PathPoint]]) -> None:
    for path, (x, y, *_) in zip(paths, simulation.poses(), strict=True):
        last = path[-1]
        if abs(x - last.x) + abs(y - last.y) >= LEAST_MOVE_MM:
            path.append(PathPoint(x, y, simulation.seconds))
