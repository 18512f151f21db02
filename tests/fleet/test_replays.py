"""What somebody recorded of a run, sealed with the team's own key, begins, ends and binds nothing in the next one."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from kitrobot.fleet import envelopes as kinds
from kitrobot.fleet.charter import FleetError
from kitrobot.fleet.envelopes import unseal
from tests.fleet.bus import KEY, Bus
from tests.fleet.test_agent_arrival import turns

ALL = (kinds.MEMBER, kinds.HELLO, kinds.WELCOME, kinds.BEGIN, kinds.FRAME, kinds.REPLY, kinds.STOP, kinds.BYE)


@pytest.fixture
def recorded(bus: Bus) -> list[tuple[str, bytes]]:
    """Everything that was sent in a run of the same team with the same key, from the first hello to the end."""
    for i in range(4):
        bus.agent(i)
    bus.meanwhile(lambda: turns(60))
    team = bus.team()
    team.gather(None)
    team.run()
    assert all(one.ended is not None for one in bus.processes)
    recorded = bus.recorded
    found = {unseal(data, KEY).kind for _, data in recorded}
    assert found >= set(ALL)
    bus.recorded, bus.said, bus.processes = [], [], []
    bus.channels.clear()
    return recorded


def replay(bus: Bus, recorded: list[tuple[str, bytes]], *only: int) -> None:
    """All of it once more, or what is of some kinds."""
    for name, data in recorded:
        if not only or unseal(data, KEY).kind in only:
            bus.put(None, name, data)


def test_a_recorded_run_neither_welcomes_nor_begins_nor_ends_who_waits_for_a_team(
    bus: Bus, recorded: list[tuple[str, bytes]]
) -> None:
    waiting = [bus.agent(i) for i in range(4)]
    bus.pass_by(10)
    for kind in ALL:
        replay(bus, recorded, kind)
        bus.pass_by(10)
    replay(bus, recorded)
    bus.pass_by(10)
    for one in waiting:
        assert one.is_there
        assert one.agent.channel.run == 0
        assert one.agent.host is None
        assert not one.agent.lease


def test_a_recorded_hello_is_no_agent_that_is_there(bus: Bus, recorded: list[tuple[str, bytes]]) -> None:
    for i in range(3):
        bus.agent(i)

    def replaying() -> Iterator[None]:
        for _ in range(20):
            yield from turns(5)
            replay(bus, recorded, kinds.HELLO, kinds.REPLY)

    bus.meanwhile(replaying)
    with pytest.raises(FleetError, match="did not come within 1 s: robot-4"):
        bus.team().gather(1)


def test_a_run_goes_on_as_if_nothing_of_an_older_one_were_said(bus: Bus, recorded: list[tuple[str, bytes]]) -> None:
    there = [bus.agent(i) for i in range(4)]

    def replaying() -> Iterator[None]:
        for _ in range(5):
            yield from turns(10)
            replay(bus, recorded)
        yield from turns(100)
        assert all(one.is_there for one in there)
        assert all(one.agent.host is not None and one.agent.host.may_act(bus.now) for one in there)

    bus.meanwhile(replaying)
    team = bus.team()
    team.gather(None)
    ended = team.run()
    assert ended.outcome == "stopped"
    assert team.simulation.tick > 50
    assert [place.life for place in team.roster.places] == [0, 0, 0, 0]
    told = [line for line in bus.said if "refused" in line]
    assert any("a message of another run" in line for line in told)
    assert len(told) < 40, told


def test_a_recorded_hello_of_the_same_run_takes_nobodys_place(bus: Bus) -> None:
    for i in range(4):
        bus.agent(i)
    killed = bus.processes[1]

    def replaying() -> Iterator[None]:
        yield from turns(50)
        bus.kill(killed)
        bus.agent(1)
        yield from turns(200)
        hellos = [(name, data) for name, data in bus.recorded if unseal(data, KEY).kind == kinds.HELLO]
        for _ in range(100):
            for name, data in hellos[:40]:
                bus.put(None, name, data)
            yield
        assert bus.processes[-1].is_there

    bus.meanwhile(replaying)
    team = bus.team()
    team.gather(None)
    team.run()
    assert team.roster.places[1].process == bus.processes[-1].agent.channel.process
    assert [place.life for place in team.roster.places] == [0, 1, 0, 0]
