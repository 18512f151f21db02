"""A walk through the states of a model by hand: the state, the steps that are possible in it, one of them taken, back.

It steps through the same model that *Check* explores, and follows the same properties. Left to others: making the
model (`checking.mission_walk`), showing it (the command line, the page).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.verdicts import Counterexample, Step
from kitrobot.verifier.report.counterexample_text import describe_any_step, place_name
from kitrobot.verifier.report.property_graph import FAULTS, Successor, Successors
from kitrobot.verifier.report.property_memory import Memory, PropertyMemory
from kitrobot.verifier.report.storyboard import Scene, Vertex, draw_scenes
from kitrobot.verifier.tables.bodies import FAILED, RUNS, Inside
from kitrobot.verifier.tables.events import RESUME, EventKind, ModelTooLargeError

MOST_STEPS = 5_000
"""Steps of one walk."""
MOST_POSSIBLE = 200
"""Steps out of one state that are described: the first ones."""
MOST_AT_ONCE = 500
"""Steps that `go_on` takes."""


class StateWalkError(KitRobotError):
    """A step that is not possible, or a walk that does not fit the mission."""


@dataclass(frozen=True)
class PossibleStep:
    """A step out of a state.

    Attributes:
        place: its number among the steps out of that state, from 0.
        sentences: what happens in it; at least one.
        is_failure: whether a robot fails in it, or recovers.
        returns_to: the state of this walk, by number, that it leads back to; -1 for a new one.
        breaks: the names of the properties that it breaks.
    """

    place: int
    sentences: tuple[Sentence, ...]
    is_failure: bool
    returns_to: int
    breaks: tuple[str, ...]


@dataclass(frozen=True)
class RobotFacts:
    """One robot in a state.

    Attributes:
        agent: its name.
        place: the piece of its road, in millimetres; "" off the roads.
        at: the vertices at which its program is; none after its end.
        facts: what else there is to say of it.
    """

    agent: str
    place: str
    at: tuple[Vertex, ...]
    facts: tuple[Sentence, ...]


class StateWalk:
    """A walk through the states of a model, from the first one on.

    Attributes:
        model: the model; nothing else may explore it meanwhile.
        places: the steps that were taken, by their numbers among the possible ones of their states.
    """

    def __init__(self, model: Model, properties: Sequence[Property]) -> None:
        """Begins in the first state.

        Raises:
            StateWalkError: the mission is too large for a model.
        """
        self.model = model
        self.places: list[int] = []
        self._properties = properties
        self._followed = [PropertyMemory(model, one) for one in properties]
        self._steps: list[Step] = []
        try:
            first = model.begin()
        except ModelTooLargeError as error:
            raise _too_large() from error
        self._successors = Successors(model, lambda: None)
        self._states: list[State] = [first]
        self._memories: list[list[Memory | None]] = [[one.first(first) for one in self._followed]]

    @property
    def state(self) -> State:
        """The state that the walk has come to."""
        return self._states[-1]

    def list_steps(self) -> tuple[PossibleStep, ...]:
        """The possible steps that are described, at most `MOST_POSSIBLE`; none of a step in which only time passes.

        Raises:
            StateWalkError: a step goes in too many ways.
        """
        return tuple(self._describe(one) for one in self._changes()[:MOST_POSSIBLE])

    def count_steps(self) -> int:
        """The number of possible steps; 0 where nothing more can happen."""
        return len(self._changes())

    def take_step(self, place: int) -> None:
        """Takes a possible step.

        Raises:
            StateWalkError: there is no such step, the walk is too long, or a step goes in too many ways.
        """
        following = self._following()
        if len(self.places) >= MOST_STEPS:
            raise StateWalkError(
                Sentence("a walk takes {most} steps at most", MOST_STEPS), Sentence("go back, or begin anew")
            )
        if not 0 <= place < len(following):
            raise StateWalkError(
                Sentence(
                    "there is no step {place} out of state {number}: {count} are possible",
                    *(place + 1, len(self.places), len(following)),
                ),
                Sentence("the mission may have changed since: begin anew"),
            )
        step = following[place]
        before = self.state
        memories = self._memories_after(step)
        self._steps.append(Step(self._successors.events(before, step), step.state))
        self._states.append(step.state)
        self._memories.append(memories)
        self.places.append(place)

    def go_on(self) -> int:
        """Takes steps while only one is possible, failures aside, and it breaks nothing; returns how many."""
        count = 0
        while count < MOST_AT_ONCE and len(self.places) < MOST_STEPS:
            ordinary = [one for one in self._changes() if not self._is_failure(one)]
            if len(ordinary) != 1 or ordinary[0].state in self._states or self._broken_names(ordinary[0]):
                break
            self.take_step(ordinary[0].place)
            count += 1
        return count

    def go_back(self, count: int = 1) -> None:
        """Takes back the last steps; at the beginning nothing happens."""
        for _ in range(min(count, len(self.places))):
            for history in (self.places, self._steps, self._states, self._memories):
                history.pop()

    def describe_last_step(self) -> tuple[Sentence, ...]:
        """What happened in the last step; nothing at the beginning."""
        if not self._steps:
            return ()
        return self._sentences(self._states[-2], self._steps[-1])

    def describe_situation(self) -> tuple[Sentence, ...]:
        """What there is to say of the state as a whole: what is broken, and whether anything can still happen."""
        said = []
        for number, one in self._broken_before():
            if number == 0:
                said.append(Sentence("the first state breaks `{property}`: {sentence}", one.name, one.sentence))
            else:
                said.append(Sentence("step {step} broke `{property}`: {sentence}", number, one.name, one.sentence))
        if all(self._is_failure(one) for one in self._changes()):
            if self._successors.has_good_end(self.state):
                said.append(Sentence("the mission is done"))
            else:
                said.append(Sentence("nothing more happens by itself, and the mission is not done"))
        elif self.state in self._states[:-1]:
            said.append(Sentence("this is state {number} again", self._states.index(self.state)))
        return tuple(said)

    def describe_robots(self) -> tuple[RobotFacts, ...]:
        """The robots in the state, in the order of the team."""
        model, state = self.model, self.state
        vertices = [robot.at for robot in self.draw().robots]
        return tuple(
            RobotFacts(
                part.agent.name,
                "" if part.track is None else place_name(model, i, state),
                () if model.has_ended(i, inside) else vertices[i],
                tuple(_facts_of(inside, model.has_ended(i, inside))),
            )
            for i, part in enumerate(model.parts)
            for inside in [model.inside(i, state[1 + i])]
        )

    def describe_shared(self) -> tuple[Sentence, ...]:
        """What is in the storehouses, and the shared variables."""
        model = self.model
        stock = model.shareds()[self.state[0]][1 : 1 + model.houses]
        houses = [
            Sentence("{storehouse}: {count}", house.name, count)
            for house, count in zip(model.run.world.storehouses, stock, strict=True)
        ]
        variables = [
            Sentence("{variable} = {value}", name, value) for name, value in self._shared_values(self.state).items()
        ]
        return (*houses, *variables)

    def draw(self) -> Scene:
        """The picture of the state."""
        (scene,) = draw_scenes(self.model, Counterexample((self.state,), ()))
        return Scene(len(self.places), scene.robots)

    # -- steps

    def _following(self) -> list[Successor]:
        try:
            return self._successors.of(self.state)
        except ModelTooLargeError as error:
            raise _too_large() from error

    def _changes(self) -> list[Successor]:
        """The steps except ticks that change nothing."""
        return [one for one in self._following() if one.state != self.state or one.kinds & ~(1 << EventKind.TICK)]

    def _is_failure(self, step: Successor) -> bool:
        return bool(step.kinds & (FAULTS | 1 << RESUME))

    def _describe(self, step: Successor) -> PossibleStep:
        taken = Step(self._successors.events(self.state, step), step.state)
        returns_to = self._states.index(step.state) if step.state in self._states else -1
        return PossibleStep(
            step.place,
            self._sentences(self.state, taken),
            self._is_failure(step),
            returns_to,
            tuple(self._broken_names(step)),
        )

    def _sentences(self, before: State, step: Step) -> tuple[Sentence, ...]:
        """What happens in a step, then what it changes of the shared variables."""
        said = describe_any_step(self.model, before, step) or [
            Sentence("{agent} goes on in its program", self.model.parts[event.agent].agent.name)
            for event in step.events
            if event.what is EventKind.TICK and self.model.timing is not Timing.LOCKSTEP
        ]
        was, now = self._shared_values(before), self._shared_values(step.state)
        said += [Sentence("{variable} = {value}", name, value) for name, value in now.items() if value != was[name]]
        return tuple(said) or (Sentence("time passes"),)

    def _shared_values(self, state: State) -> dict[str, int]:
        """The shared variables in a state."""
        values = self.model.shareds()[state[0]][1 + self.model.houses :]
        names = (one.name for one in self.model.run.shared_variables)
        return dict(zip(names, values, strict=False))

    def _memories_after(self, step: Successor) -> list[Memory | None]:
        return [
            None if memory is None else one.after(memory, self.state, step.kinds, step.state)
            for one, memory in zip(self._followed, self._memories[-1], strict=True)
        ]

    def _broken_names(self, step: Successor) -> list[str]:
        after = self._memories_after(step)
        return [
            one.name
            for one, was, now in zip(self._properties, self._memories[-1], after, strict=True)
            if was is not None and now is None
        ]

    def _broken_before(self) -> list[tuple[int, Property]]:
        """The properties that are broken, each with the number of the state that broke it."""
        found = []
        for at, one in enumerate(self._properties):
            if self._memories[-1][at] is None:
                found.append((next(n for n, memory in enumerate(self._memories) if memory[at] is None), one))
        return sorted(found, key=lambda pair: pair[0])


def _facts_of(inside: Inside, has_ended: bool) -> Iterator[Sentence]:
    if inside.load:
        yield Sentence("carries a box")
    if inside.down == FAILED:
        yield Sentence("has failed")
    elif inside.down != RUNS:
        yield Sentence("misses its ticks")
    elif has_ended:
        yield Sentence("its program has ended")
    if inside.is_muted:
        yield Sentence("hears nobody")


def _too_large() -> StateWalkError:
    return StateWalkError(
        Sentence("a step of this mission goes in too many ways to be listed"),
        Sentence("take fewer robots, or let them tick one by one"),
    )


def find_places(model: Model, run: Counterexample) -> tuple[int, ...]:
    """The numbers of the steps of a run of the model, with which a walk takes it.

    The model is explored anew, so no state space of it may be used afterwards.
    """
    successors = Successors(model, lambda: None)
    places = []
    for before, step in zip(run.states, run.steps, strict=False):
        same = [one for one in successors.of(before) if one.state == step.state]
        taken = next((one for one in same if successors.events(before, one) == step.events), same[0])
        places.append(taken.place)
    return tuple(places)
