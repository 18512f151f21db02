"""A fleet does what the simulator does with the same team, whatever the network does."""

from __future__ import annotations

import random

import pytest

from tests.effort import THOROUGH
from tests.fleet.network import LEASE, Faults
from tests.fleet.teams import FleetTeam
from tests.sim.team_building import random_team_program
from tests.team_programs.hosting import TooLarge
from tests.team_programs.reference import Meaning, TooLong

MOST_TICKS = 3000


def fleet_and_meaning(seed: int, spares: int, lease: int = LEASE, asks: bool = False) -> tuple[FleetTeam, Meaning]:
    """The first random team from a seed on that is not too large, as a fleet, and what it is to do."""
    while True:
        maker, program = random_team_program(seed, spares, asks)
        roles = {name: role for name, (_, role) in maker.agents.items() if role}
        meaning = Meaning(roles, maker.sets(program), maker.programs, left=dict(maker.works))
        try:
            meaning.seq(program.seq, list(roles))
            if meaning.steps < 150:
                return FleetTeam(maker, program, seed, lease), meaning
        except (TooLong, TooLarge):
            pass
        seed += 1


def finish(team: FleetTeam) -> None:
    while team.run.outcome is None:
        assert team.run.tick < MOST_TICKS
        team.step()


@pytest.mark.parametrize("rough", [False, True])
@pytest.mark.parametrize("seed", range(60 if THOROUGH else 2))
def test_every_robot_does_its_lines_although_messages_are_lost_doubled_and_late(seed: int, rough: bool) -> None:
    # Nobody is to be missed for messages that are lost: there are no spare ones.
    team, meaning = fleet_and_meaning(seed, 0, 1000, asks=True)
    if rough:
        team.fleet.faults = Faults(loss=10, doubled=10, delay=40)
    finish(team)
    assert team.run.outcome == "done", team.run.sentence
    assert team.lines_of_roles() == meaning.lines
    assert team.left() == meaning.left


@pytest.mark.parametrize("seed", range(60 if THOROUGH else 2))
def test_a_substitute_goes_on_where_a_process_died_or_a_body_failed(seed: int) -> None:
    team, meaning = fleet_and_meaning(10 * seed, 2)
    chance = random.Random(seed)
    moments = [chance.randrange(60) for _ in range(3)]
    if chance.random() < 0.5:
        team.fleet.faults = Faults(loss=10, doubled=10, delay=40)
    left = {"ant": 2, "bee": 2}
    kinds = {agent.name: agent.robot.name for agent in team.run.members}
    for steps in moments:
        for _ in range(steps):
            if team.run.outcome is None:
                team.step()
        there = [name for name in team.playing() if team.names.index(name) in team.fleet.hosts]
        going = [name for name in there if left[kinds[name]]]
        if going and team.run.outcome is None and len(team.fleet.hosts) > len(team.names) // 2 + 1:
            name = chance.choice(going)
            left[kinds[name]] -= 1
            what = chance.choice(("kill", "mute", "fail"))
            if what == "kill":
                team.fleet.kill(team.names.index(name))
            else:
                team.run.inject_fault(name, what)
    finish(team)
    assert team.run.outcome == "done", team.run.sentence
    assert team.lines_of_roles() == meaning.lines
    assert all(0 <= team.left()[work] <= left for work, left in meaning.left.items())


@pytest.mark.parametrize("cut", [0, 1])
def test_a_half_that_is_cut_off_waits_and_everything_is_done_once_when_the_network_heals(cut: int) -> None:
    team, meaning = fleet_and_meaning(5 if cut else 3, 0)
    fleet = team.fleet
    for _ in range(20):
        team.step()
    half = frozenset(range(len(team.names) // 2)) if cut else frozenset(range(len(team.names) // 2 + 1, 99))
    slots = {i: host.replica.slot for i, host in fleet.hosts.items()}
    fleet.faults = Faults(side=half, bodies_too=bool(cut))
    while fleet.now < 1500:
        fleet.step()
    assert not all(host.may_act(fleet.now) for host in fleet.hosts.values())
    assert all(host.replica.slot >= slots[i] for i, host in fleet.hosts.items())
    assert fleet.run.outcome is None
    fleet.faults = Faults()
    while team.run.outcome is None and fleet.now < 60_000:
        fleet.step()
    assert team.run.outcome in ("done", "failed")
    for name, lines in team.lines_of_roles().items():
        whole = meaning.lines[name]
        assert lines == (whole if team.run.outcome == "done" else whole[: len(lines)])
    # Who was missed may have left units undone; who plays its role again begins its block anew, and takes others there.
    again = any(event.text == "plays its role again" for event in fleet.events)
    assert all(team.left()[work] >= (0 if again else left) for work, left in meaning.left.items())
