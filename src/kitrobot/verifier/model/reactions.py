"""The input values of an agent, and the effect of a reaction of its program on the agent and on the shared state."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kitrobot.sim.devices.base import Discrete
from kitrobot.verifier.model.abstraction import AgentModel, InputModel
from kitrobot.verifier.model.programs import Reaction
from kitrobot.verifier.model.team_agreement import TeamCommand
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.bodies import FAILED, Inside

Change = tuple[tuple[tuple[int, int], ...], tuple[TeamCommand, ...]]
"""The change of the shared state by a tick: the variables that it changes, with their values, and its team commands."""

_AS_BEFORE = -2
"""The wheels' command if there is none."""


def idle_actuators(part: AgentModel) -> tuple[int, ...]:
    """The value of `Inside.busy` of an idle agent."""
    return (0,) * sum(act.busy >= 0 for act in part.acts)


def is_store(sense: InputModel) -> bool:
    """Whether an input reads how many boxes are in a storehouse."""
    return sense.discrete is Discrete.EXACT and sense.store >= 0


def is_shared(sense: InputModel) -> bool:
    """Whether an input reads a value of the shared state."""
    return is_store(sense) or (sense.discrete is Discrete.TEAM and sense.agreed >= 0)


def read(inside: Inside, sense: InputModel, there: int) -> int | None:
    """The value of an input; None where it may be any of its choices."""
    if sense.discrete is Discrete.ANY:
        return None
    if sense.discrete is Discrete.BUSY:
        return 0 if inside.busy[sense.actuator] else 1
    value = inside.load if sense.discrete is Discrete.EXACT and sense.store < 0 else there
    return min(max(value, sense.least), sense.most)


def team_commands(part: AgentModel, reaction: Reaction) -> tuple[TeamCommand, ...]:
    """The commands of a reaction to the team, in the order of the actuators."""
    return tuple(
        TeamCommand(part.acts[actuator].agrees, part.acts[actuator].ways[command], first, second)
        for (actuator, command, first), second in zip(reaction.commands, reaction.seconds, strict=True)
        if part.acts[actuator].agrees >= 0
    )


def change_by(part: AgentModel, inside: Inside, shared: tuple[int, ...], reaction: Reaction) -> Change:
    """The change of the shared state by a reaction; without a radio it changes no shared variable."""
    if inside.is_muted:
        return (), team_commands(part, reaction)
    held = zip(part.shared, shared, reaction.shared, strict=True)
    return tuple((at, now) for at, was, now in held if was != now), team_commands(part, reaction)


def after_silence(part: AgentModel, inside: Inside, key: int, seen: tuple[int, ...]) -> Inside:
    """The agent once it hears nobody (`state_decoding.find_silenced`), with its own copy of the shared variables."""
    down = FAILED if key >> v.S_VIEW & 1 else inside.down
    return inside._replace(own=seen[: len(part.shared)], down=down, is_muted=True)


def after_reaction(part: AgentModel, inside: Inside, reaction: Reaction) -> tuple[int, Inside]:
    """The command of a reaction to the wheels, and the state of the agent after it."""
    want, busy = _AS_BEFORE, list(inside.busy)
    for actuator, command, argument in reaction.commands:
        act = part.acts[actuator]
        if actuator == part.drive:
            want = act.ways[command] if argument else 0
        elif act.busy >= 0 and command in act.later:
            busy[act.busy] = 1 + act.ways[command]
    own = reaction.shared if inside.is_muted else ()
    stopped, left = reaction.stops
    loose = inside.loose & ~stopped | left
    return want, inside._replace(local=reaction.local, busy=tuple(busy), own=own, loose=loose)


def external_values(
    part: AgentModel, signs: Sequence[tuple[int, ...]], key: int, shared: tuple[int, ...]
) -> Iterator[int]:
    """Yields the value that each input of an agent reads outside the agent itself; 0 if there is none.

    Args:
        part: the agent.
        signs: what its sensors for signs read in the classes of zones; none on no road.
        key: what it senses (`state_decoding.sense_key`).
        shared: what it senses of what is shared.
    """
    gaps = sum(sense.discrete is Discrete.GAP for sense in part.senses)
    view = key >> v.S_VIEW & v.MOST_VIEWS - 1
    its_signs = iter(signs[view >> gaps] if signs else ())
    visits = key >> v.S_VISITS & v.MOST_VISITS - 1
    left = iter(shared)
    for sense in part.senses:
        if sense.discrete is Discrete.SECTION:
            yield next(its_signs)
        elif sense.discrete is Discrete.GAP:
            gaps -= 1
            yield view >> gaps & 1
        elif sense.discrete is Discrete.VISIT:
            yield visits & 1
            visits >>= 1
        else:
            yield next(left) if is_shared(sense) else 0
