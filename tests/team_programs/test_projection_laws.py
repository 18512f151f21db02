"""Random programs of teams: projected, compiled and run, each robot does what the team's program says, in its order."""

from __future__ import annotations

import random

from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.effort import examples
from tests.team_programs.hosting import Team, TooLarge
from tests.team_programs.making import TeamMaker
from tests.team_programs.reference import Meaning, TooLong

SEEDS = st.integers(0, 10**9)


def team_and_meaning(seed: int, spares: int = 0, asks: bool = True) -> tuple[Team, Meaning]:
    """A random team that is ready to run, and what it is to do."""
    maker = TeamMaker(random.Random(seed), spares, asks)
    program = maker.program()
    roles = {name: role for name, (_, role) in maker.agents.items() if role}
    meaning = Meaning(roles, maker.sets(program), maker.programs, left=dict(maker.works))
    try:
        meaning.seq(program.seq, list(roles))
        return Team(program, maker.agents, maker.programs, seed), meaning
    except (TooLong, TooLarge):
        assume(False)
        raise


@given(SEEDS)
@settings(max_examples=examples(12))
def test_every_robot_does_its_lines_and_nobody_goes_on_before_all_are_there(seed: int) -> None:
    team, meaning = team_and_meaning(seed)
    team.run()
    assert team.lines() == meaning.lines
    assert team.left == meaning.left
    for moment in meaning.before:
        logs = [(team.robots[name].log, count) for name, count in moment.items()]
        over = [log[count - 1].ended for log, count in logs if count]
        begun = [log[count].began for log, count in logs if count < len(log)]
        assert not over or not begun or max(over) <= min(begun)


@given(SEEDS, st.lists(st.integers(0, 60), min_size=1, max_size=5))
@settings(max_examples=examples(12))
def test_a_substitute_goes_on_with_the_block_in_which_a_role_was_lost(seed: int, moments: list[int]) -> None:
    team, meaning = team_and_meaning(seed, spares=2, asks=False)
    chance = random.Random(seed)
    for ticks in moments:
        for _ in range(ticks):
            if not team.ended:
                team.step()
        spare = {one.kind for one in team.robots.values() if one.alive and not one.role}
        going = [one for one in team.robots.values() if one.alive and one.role and one.kind in spare]
        if going and not team.ended:
            team.fail(chance.choice(going).name)
    team.run()
    assert team.lines() == meaning.lines
    # Who was lost may have done units of its block that another does again, with units that are left.
    assert not team.held
    assert all(0 <= team.left[work] <= left for work, left in meaning.left.items())
