"""The laws of what a slot of the log does to a replica; those of states are in `agent_laws`."""

from __future__ import annotations

from dataclasses import dataclass

from kitrobot.fleet import notes
from kitrobot.fleet.replica import Effect, Replica
from kitrobot.sim.tables.columns import ENDED
from kitrobot.sim.tables.team_columns import (
    ANY,
    ASK,
    BRANCH,
    EVERY,
    HAS_UNIT,
    MOST,
    MOVE,
    P_KIND,
    P_MEMBERS,
    P_NEGATED,
    P_QUANTIFIER,
    P_VOTERS,
    T_ANSWER,
    T_AT,
    T_GIVEN,
    T_HOLDER,
    T_LED,
    T_MISSED,
    T_REPLAYED,
    T_ROLE,
    T_TO_REPLAY,
    W_LEFT,
    W_TAKEN,
)
from kitrobot.team.changes import AppliedNote


@dataclass(frozen=True)
class Before:
    """What a replica held before an effect."""

    robots: tuple[tuple[int, ...], ...]
    holds: tuple[tuple[int, ...], ...]
    left: tuple[int, ...]
    epochs: tuple[int, ...]
    ended: tuple[int, ...]


def before_effect(replica: Replica) -> Before:
    """What the laws compare with."""
    team = replica.state.team
    return Before(
        tuple(map(tuple, team.robots)),
        tuple(map(tuple, team.holds)),
        tuple(team.works[W_LEFT]),
        tuple(replica.epochs),
        tuple(replica.state.robots.ints[ENDED]),
    )


def slot_breaks(before: Before, effect: Effect, replica: Replica) -> str:
    """The law that an effect breaks, "" if none."""
    return _meeting_breaks(before, effect, replica) or _work_breaks(before, effect, replica)


def _note(before: Before, effect: Effect) -> tuple[int, notes.ReplicatedNote] | None:
    """The robot that speaks and its note, if it has an effect."""
    note = notes.decode_note(effect.numbers) if isinstance(effect, AppliedNote) else None
    if note is None or not isinstance(effect, AppliedNote):
        return None
    i = effect.seat.member
    return (i, note) if note.epoch == before.epochs[i] and not before.ended[i] else None


def _meeting_breaks(before: Before, effect: Effect, replica: Replica) -> str:
    team = replica.state.team
    robots, points = team.robots, team.points
    at, given = list(before.robots[T_AT]), list(before.robots[T_GIVEN])
    said = _note(before, effect)
    if said is not None and said[1].kind == notes.COME:
        i, note = said
        is_led = before.robots[T_LED][i] >= 0 or before.robots[T_REPLAYED][i] < before.robots[T_TO_REPLAY][i]
        if not is_led and at[i] < 0 and points[P_KIND][note.first] > BRANCH and before.robots[T_ROLE][i] >= 0:
            at[i], given[i] = note.first, note.second
    gone_on: dict[int, set[int]] = {}
    for i, p in enumerate(at):
        if p >= 0 and robots[T_AT][i] != p and not robots[T_MISSED][i]:
            gone_on.setdefault(p, set()).add(i)
    for p, robots_there in gone_on.items():
        members = team.members[points[P_MEMBERS][p]]
        if points[P_KIND][p] != MOVE and {i for i, is_member in enumerate(members) if is_member} != robots_there:
            return "a meeting is over for all who come to it when all have come or left"
        answers = {robots[T_ANSWER][i] for i in robots_there}
        if len(answers) > 1:
            return "a question has one answer"
        if points[P_KIND][p] == ASK:
            asked = team.members[points[P_VOTERS][p]]
            seats = [i for i in robots[T_HOLDER] if i in robots_there and asked[i]]
            if answers != {_combined(points[P_QUANTIFIER][p], [bool(given[i]) for i in seats]) ^ points[P_NEGATED][p]}:
                return "the answer to a question is that of those who came"
    return ""


def _combined(quantifier: int, answers: list[bool]) -> int:
    if quantifier == ANY:
        return int(any(answers))
    if quantifier == EVERY:
        return int(all(answers))
    if quantifier == MOST:
        return int(2 * sum(answers) > len(answers))
    return int(bool(answers) and answers[0])


def _work_breaks(before: Before, effect: Effect, replica: Replica) -> str:
    team = replica.state.team
    said = _note(before, effect)
    for w, holds in enumerate(team.holds):
        left, taken = team.works[W_LEFT][w], team.works[W_TAKEN][w]
        if taken != sum(one == HAS_UNIT for one in holds) or taken > left:
            return "a unit has one holder"
        done = before.left[w] - left
        is_its_own = (
            said is not None
            and (said[1].kind, said[1].first) == (notes.DONE, w)
            and before.holds[w][said[0]] == HAS_UNIT
        )
        if done != int(is_its_own):
            return "a unit is counted once and for its holder"
    return ""
