"""Why a property broke, in plain values: what the doors show of an explanation of the verifier.

Left to others: what is needed and what could be avoided (`verifier.report.explanation`), when there is time for it
(`verification`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.properties.verdicts import Counterexample, Verdict
from kitrobot.verifier.report.avoidance import Certainty, decisive_events
from kitrobot.verifier.report.counterexample_text import describe_any_step, describe_run
from kitrobot.verifier.report.explanation import Explanation, explain_run
from kitrobot.verifier.report.explanation_text import describe_explanation
from kitrobot.verifier.report.kept_run import KeptRun, find_kept_run
from kitrobot.verifier.report.replay import ConfirmedRun
from kitrobot.verifier.report.run_moment import find_run_moment
from kitrobot.verifier.report.storyboard import Scene, draw_scenes

MOST_EVENTS = 600
"""Events of another way that are told: the first ones."""

Story = tuple[tuple[int, Sentence], ...]
"""The events of a run in sentences, each with its step."""


@dataclass(frozen=True)
class OtherWay:
    """A run that keeps a property, the same as the broken one up to the deciding step.

    Attributes:
        story: its events from there on.
        ends_well: whether it comes to where every goal is reached, or every program has ended.
        scenes: its pictures from there on, where they are wanted.
    """

    story: Story
    ends_well: bool
    scenes: tuple[Scene, ...] = ()


@dataclass(frozen=True)
class RunExplanation:
    """Why a property broke.

    Attributes:
        sentences: three at most: what happened, what decided it, what would have avoided it.
        certainty: what is known of the moment that decided it.
        step: the step that decided it, from 0; -1: there is none, or none is known.
        left_out: how many events of the run that was found first are left out, since they are not needed.
        other: another way from there; None without a step.
        tick: of the run of the simulator that confirms it, the step before which it was decided; -1 if that is not
            known.
        kept: a run of the simulator that keeps the property and is the same up to its `tick`; None where none is known.
    """

    sentences: tuple[Sentence, ...]
    certainty: Certainty
    step: int = -1
    left_out: int = 0
    other: OtherWay | None = None
    tick: int = -1
    kept: KeptRun | None = None

    def to_json(self, tick_ms: int) -> dict[str, Any]:
        """As plain values."""
        other = self.other
        return {
            "sentences": [str(sentence) for sentence in self.sentences],
            "certainty": self.certainty.value,
            "step": self.step if self.step >= 0 else None,
            "left_out": self.left_out,
            "seconds": self.tick * tick_ms / 1000 if self.tick >= 0 else None,
            "other_way": other
            and {
                "run": [{"step": step, "text": str(text)} for step, text in other.story],
                "ends_well": other.ends_well,
            },
            "kept": self.kept and self.kept.to_json(tick_ms),
        }


def explain_verdict(
    model: Model, verdict: Verdict, states: int | None, budget: Budget, draws: bool
) -> tuple[Verdict, Explanation, RunExplanation] | None:
    """The verdict with a smaller run, and why it is broken; None where it is not, or its first state breaks it."""
    if verdict.counterexample is None:
        return None
    found = explain_run(model, verdict.property, verdict.counterexample, states, budget)
    if found is None:
        return None
    avoidance = found.avoidance
    explanation = RunExplanation(
        describe_explanation(model, verdict.property, found.run, avoidance),
        avoidance.certainty,
        avoidance.step,
        found.left_out,
        _other_way(model, found, draws),
    )
    return replace(verdict, counterexample=found.run), found, explanation


def _other_way(model: Model, found: Explanation, draws: bool) -> OtherWay | None:
    run, at = found.avoidance.other, found.avoidance.step
    if run is None:
        return None
    story = tuple((step, text) for step, text in describe_story(model, run, at) if step >= at)
    rest = Counterexample(run.states[at:], run.steps[at:])
    scenes = tuple(replace(scene, step=scene.step + at) for scene in draw_scenes(model, rest)) if draws else ()
    return OtherWay(story[:MOST_EVENTS], found.avoidance.ends_well, scenes)


def describe_story(model: Model, run: Counterexample, decided: int = -1) -> Story:
    """The events of a run in sentences; the step that decided it has one though it is but a tick."""
    story = list(describe_run(model, run))
    if 0 <= decided < len(run.steps) and all(step != decided for step, _ in story):
        place = next((at for at, (step, _) in enumerate(story) if step > decided), len(story))
        said = describe_any_step(model, run.states[decided], run.steps[decided])
        story[place:place] = [(decided, text) for text in said]
    return tuple(story)


def place_explanation(
    model: Model,
    found: Explanation,
    verdict: Verdict,
    explanation: RunExplanation,
    confirmed: ConfirmedRun,
    fresh: Callable[[int], Simulation],
    stop: Callable[[], bool],
) -> RunExplanation:
    """An explanation with its moment in the run of the simulator that confirms it, and a run that keeps it."""
    run, step = found.run, found.avoidance.step
    if not 0 <= step < len(run.steps):
        return explanation
    events = decisive_events(run, found.avoidance)
    tick = find_run_moment(model, run, step, events, confirmed, fresh, stop)
    agents = dict.fromkeys(model.parts[event.agent].agent.name for event in events or run.steps[step].events)
    moment = confirmed.tick if tick < 0 else tick
    kept = find_kept_run(verdict.property, confirmed, moment, tuple(agents), fresh, stop)
    return replace(explanation, tick=tick, kept=kept)
