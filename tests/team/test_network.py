"""The laws of the protocol, on random runs of two to seven members with every fault that it tolerates.

`network` holds those that are true at every moment: one decision for each slot, each note once and in its order, no
right to act that outlives a view. Here: what is true after healing, and that faults change no outcome.
"""

from __future__ import annotations

from hypothesis import Phase as Stage
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.effort import cases, examples
from tests.team.network import HEALING, Network, Phase, team

IDLE = 4_000

# A failing run is short enough to read; to look for a shorter one takes minutes.
_PHASES = (Stage.explicit, Stage.reuse, Stage.generate)


def _phases(members: int) -> st.SearchStrategy[list[Phase]]:
    some = st.frozensets(st.integers(0, members - 1), max_size=members)
    one = st.integers(-1, members - 1)
    phase = st.builds(
        Phase,
        ms=st.sampled_from((300, 1500, 3000, 5000)),
        loss=st.sampled_from((0, 10, 40)),
        doubled=st.sampled_from((0, 20)),
        delay=st.sampled_from((0, 50, 400)),
        side=st.one_of(st.just(frozenset[int]()), some),
        stopped=st.one_of(st.just(frozenset[int]()), some),
        crash=st.one_of(st.just(-1), one),
        starts=one,
    )
    return st.lists(phase, min_size=1, max_size=4)


_RUNS = st.integers(2, 7).flatmap(lambda members: st.tuples(st.just(members), st.integers(0, 9999), _phases(members)))


@settings(max_examples=examples(4, 300), phases=_PHASES)
@given(_RUNS)
def test_whatever_fails_the_laws_hold_and_after_healing_all_copies_are_equal_and_the_team_goes_on(
    run: tuple[int, int, list[Phase]],
) -> None:
    members, seed, phases = run
    network = Network(team(members), seed)
    for phase in phases:
        network.run(phase)
    before = max((robot.state.log.slot for robot in network.robots.values()), default=0)
    network.run(Phase(HEALING - IDLE))
    network.run(Phase(IDLE, idle=True))
    if network.robots and network.can_heal():
        network.check_healed()
        assert network.robots[min(network.robots)].state.log.slot > before


@settings(max_examples=examples(3, 100), phases=_PHASES)
@given(st.integers(2, 5), st.integers(0, 9999))
def test_loss_doubling_reordering_and_delay_change_no_outcome(members: int, seed: int) -> None:
    calm, rough = Network(team(members), seed, rounds=3), Network(team(members), seed, rounds=3)
    calm.run(Phase(4_000))
    calm.run(Phase(1_000, idle=True))
    rough.run(Phase(8_000, loss=15, doubled=30, delay=200))
    rough.run(Phase(2_000))
    rough.run(Phase(2_000, idle=True))
    calm.check_healed()
    rough.check_healed()
    if rough.robots[0].state.tables.view.number == 0:
        assert rough.robots[0].state.tables.applied == calm.robots[0].state.tables.applied


def test_one_that_was_stopped_for_five_seconds_does_not_act_until_it_is_in_a_view_again() -> None:
    network = Network(team(4), 1)
    network.run(Phase(2_000))
    network.run(Phase(5_000, stopped=frozenset({0})))
    assert [seat.member for seat in network.robots[1].state.tables.view.seats] == [1, 2, 3]
    # Its letters of five seconds come at once, before it hears the present view; check_rights looks at every moment.
    network.run(Phase(HEALING - IDLE))
    network.run(Phase(IDLE, idle=True))
    network.check_healed()


def test_two_halves_never_both_go_on_and_the_smaller_one_is_told() -> None:
    network = Network(team(5), 3)
    network.run(Phase(2_000))
    network.run(Phase(4_000, side=frozenset({0, 1})))
    small, large = network.robots[0].state, network.robots[2].state
    assert (small.membership.heard, large.membership.heard) == (False, True)
    assert small.tables.view.number == 0 < large.tables.view.number
    slot = small.log.slot
    network.run(Phase(4_000, side=frozenset({0, 1})))
    assert network.robots[0].state.log.slot == network.robots[1].state.log.slot == slot
    network.run(Phase(HEALING - IDLE))
    network.run(Phase(IDLE, idle=True))
    network.check_healed()


def test_any_one_member_may_crash_at_any_moment_and_the_others_go_on() -> None:
    every = [(moment, member) for moment in range(0, 2_000, 900) for member in range(3)]
    for moment, member in cases([(0, 0), (900, 1), (1_800, 2)], every):
        network = Network(team(3), moment + member)
        network.run(Phase(moment))
        network.run(Phase(9_000, crash=member))
        network.run(Phase(3_000, idle=True))
        network.check_healed()


def test_a_member_that_starts_again_without_its_memory_joins_as_somebody_new() -> None:
    network = Network(team(3), 5)
    network.run(Phase(1_000))
    network.run(Phase(200, crash=0))
    network.run(Phase(6_000, starts=0))
    network.run(Phase(2_000, idle=True))
    network.check_healed()
    assert network.robots[0].state.seat == (0, 1)
