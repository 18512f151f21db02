"""How agents come to a run: they wait for each other as long as it takes, and one name is one process."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest

from kitrobot.fleet import envelopes as kinds
from kitrobot.fleet.charter import FleetError
from kitrobot.fleet.envelopes import EVERYBODY
from kitrobot.fleet.roster import Answer, Roster
from tests.fleet.bus import Bus

FIVE_MINUTES = 5 * 60 * 50
"""In turns."""


def turns(count: int) -> Iterator[None]:
    for _ in range(count):
        yield


def test_agents_wait_for_the_last_one_and_each_says_at_once_who_is_missing(bus: Bus) -> None:
    early = [bus.agent(i) for i in range(3)]

    def late() -> Iterator[None]:
        yield from turns(FIVE_MINUTES)
        assert all(one.is_there for one in early)
        early.append(bus.agent(3))
        yield from turns(50)

    bus.meanwhile(late)
    team = bus.team()
    team.gather(None)
    assert bus.said[0] == "waits for robot-1, robot-2, robot-3, robot-4"
    assert bus.said[-1] == "waits for robot-4; there: robot-1, robot-2, robot-3"
    assert len(bus.said) <= 4
    assert early[0].said[-1] == "is there; the team waits for robot-4"
    assert not bus.stopping
    team.run()
    assert all("takes part" in one.said for one in early)
    assert all(one.ended is not None for one in early)


def test_a_limit_that_the_user_sets_is_told_when_it_is_over(bus: Bus) -> None:
    for i in range(3):
        bus.agent(i)
    with pytest.raises(FleetError, match=r"did not come within 60 s: robot-4"):
        bus.team().gather(60)


def test_an_agent_ends_at_the_limit_that_the_user_sets_and_without_one_waits(bus: Bus) -> None:
    limited, patient = bus.agent(0, 30), bus.agent(1)
    bus.pass_by(30 * 50 - 1)
    assert limited.is_there
    bus.pass_by(2)
    assert limited.error is not None
    assert limited.error.message == "the run did not begin within 30 s"
    bus.pass_by(FIVE_MINUTES)
    assert patient.is_there


def test_who_goes_while_the_others_wait_is_missing_again(bus: Bus) -> None:
    there = [bus.agent(i) for i in range(3)]

    def goes() -> Iterator[None]:
        yield from turns(20)
        bus.kill(there[1])
        yield from turns(200)
        assert bus.said[-1] == "waits for robot-2, robot-4; there: robot-1, robot-3"
        bus.agent(3)
        yield from turns(20)
        assert bus.said[-1] == "waits for robot-2; there: robot-1, robot-3, robot-4"
        bus.agent(1)
        yield from turns(100)

    bus.meanwhile(goes)
    bus.team().gather(None)
    assert not bus.stopping


def test_an_agent_that_waits_finds_the_next_team_when_its_team_is_gone(bus: Bus) -> None:
    waiting = bus.agent(0)
    bus.meanwhile(lambda: turns(50))
    bus.team().gather(None)
    bus.pass_by(FIVE_MINUTES)
    assert waiting.is_there
    assert waiting.said[-1] == "its team is not heard any more; looks for it"
    for i in (1, 2, 3):
        bus.agent(i)
    bus.meanwhile(lambda: turns(200))
    bus.team().gather(None)
    assert not bus.stopping


def test_a_second_process_of_a_name_is_refused_before_the_run_and_in_it(bus: Bus) -> None:
    first = [bus.agent(i) for i in range(3)]
    second = bus.agent(0)

    def comes() -> Iterator[None]:
        yield from turns(200)
        assert not second.is_there
        first.append(bus.agent(3))
        yield from turns(30)
        third.append(bus.agent(1))
        yield from turns(200)

    third = [second]
    bus.meanwhile(comes)
    team = bus.team()
    team.gather(None)
    ended = team.run()
    why = "the team refused this agent: another process takes part as `robot-{}`; one name is one process"
    assert [str(one.error) for one in third] == [why.format(1), why.format(2)]
    assert sum("one name is one process" in line for line in bus.said) == 2
    assert all(one.ended is not None and one.ended.stopped for one in first)
    assert sorted(ended.stopped_ms) == ["robot-1", "robot-2", "robot-3", "robot-4"]


def test_a_new_process_takes_part_in_the_place_of_one_that_was_killed_and_the_old_one_stays_out(bus: Bus) -> None:
    for i in range(4):
        bus.agent(i)
    killed = bus.processes[1]

    def killing() -> Iterator[None]:
        yield from turns(100)
        bus.kill(killed)
        anew = bus.agent(1)
        yield from turns(300)
        assert "takes part" in anew.said
        assert anew.agent.host is not None
        assert anew.agent.host.state.seat.life == 1
        # The old one was only cut off: it is heard again.
        bus.processes.append(killed)
        bus.channels.append(killed.agent.channel)  # type: ignore[arg-type]
        yield from turns(300)
        assert "one name is one process" in str(killed.error)
        assert anew.is_there

    bus.meanwhile(killing)
    team = bus.team()
    team.gather(None)
    team.run()
    assert "robot-2: comes anew" in bus.said


def test_who_took_no_part_is_told_so_when_the_run_ends(bus: Bus) -> None:
    late = bus.agent(0)
    bus.meanwhile(lambda: turns(20))
    team = bus.team()
    team.gather(None)
    team.channel.send(EVERYBODY, kinds.BYE, json.dumps(["done", "Done."]).encode())
    bus.pass_by()
    assert late.error is not None
    assert late.error.message == "this agent took no part in the run, which is over: Done."


# The rules, without processes.


def test_a_roster_lets_the_second_in_only_when_the_first_is_silent() -> None:
    roster = Roster(2, 1000)
    assert roster.missing(0) == [0, 1]
    assert roster.hello(0, 0, 11, False) is Answer.COMES
    assert roster.hello(200, 0, 11, False) is Answer.KNOWN
    assert roster.missing(1199) == [1]
    assert roster.missing(1200) == [0, 1]
    assert roster.hello(1199, 0, 12, True) is Answer.WAITS
    assert not roster.heard(1200, 0, 12)
    assert roster.hello(1200, 0, 12, True) is Answer.REPLACES
    assert roster.places[0].life == 1
    assert roster.hello(1201, 0, 11, True) is Answer.REFUSED, "once replaced, it stays out"
    assert roster.heard(1900, 0, 12)
    assert roster.hello(1900, 0, 13, True) is Answer.WAITS
    assert roster.heard(2899, 0, 12)
    assert roster.hello(2900, 0, 13, True) is Answer.WAITS
    assert roster.heard(2900, 0, 12)
    assert roster.hello(2901, 0, 13, True) is Answer.REFUSED
    assert roster.hello(9000, 0, 13, True) is Answer.REFUSED, "also when the first one is silent later"
    assert not roster.heard(0, 7, 11)


def test_a_crowd_of_one_name_is_bounded() -> None:
    roster = Roster(1, 1000)
    for process in range(1, 10_000):
        roster.hello(0, 0, process, False)
    assert roster.places[0].process == 1
    assert len(roster.places[0].rivals) < 20
    assert len(roster.places[0].out) < 100
