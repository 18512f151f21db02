"""Addresses: what can vary in a mission, and what is said of one that cannot."""

from __future__ import annotations

from dataclasses import replace

import pytest

import kitrobot
from kitrobot.experiments.addresses import ExperimentError, find_address
from kitrobot.experiments.mission_addresses import mission_addresses
from kitrobot.experiments.variant import open_variant, variant_of
from kitrobot.mission.writer import write_mission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.world.xml_writer import write_world
from tests.effort import cases

MISSIONS = cases(["transport-team"], ["transport", "exchange", "search", "sumo", "line-follower", "tidy-up"])


def _text(variant) -> bytes:
    robots = repr(sorted(variant.robots.items())).encode()
    return write_mission(variant.mission) + write_world(variant.world) + robots + str(variant.fail_rate).encode()


@pytest.mark.parametrize("name", MISSIONS)
def test_every_address_takes_another_value_and_only_that_address_then_has_it(name):
    opened = kitrobot.open_mission(name)
    before = _text(variant_of(opened, 0.0))
    for address in mission_addresses(opened).values():
        if address.any_word:
            continue
        variant = variant_of(opened, 0.0)
        others = [word for word in address.words if word != address.current]
        ends = [end for end in (address.least, address.most) if address.takes_numbers and end != address.current]
        value = address.check(ends[0] if ends else others[0])
        address.put(variant, value)
        assert _text(variant) != before, address.name
    assert _text(variant_of(opened, 0.0)) == before, "the mission itself was changed"


def test_a_mission_with_the_values_that_it_has_already_gives_the_run_that_it_gave():
    opened = kitrobot.open_mission("transport-team")
    variant = variant_of(opened, 0.0)
    known = mission_addresses(opened)
    for name in ("carry.v10.speed", "agents.carrier", "storehouse.A.stock", "variable.carrier.Dock", "role.movers"):
        if name in known:
            now = known[name].current
            assert now is not None
            known[name].put(variant, now)
    first = opened.run(seed=3, seconds=20)
    again = open_variant(variant, opened).run(seed=3, seconds=20)
    assert replace(again, timing=first.timing) == first


@pytest.mark.parametrize(
    ("name", "value", "found"),
    [
        ("agents.carrier", 2, lambda run: len([a for a in run.members if a.robot.name == "carrier"]) == 2),
        ("agents.carrier", 5, lambda run: len([a for a in run.members if a.robot.name == "carrier"]) == 5),
        ("storehouse.A.stock", 7, lambda run: run.stock["A"] == 7),
        ("radio.loss", 10, lambda run: run.mission.radio.loss == 10),
        ("breakdown.after", 9.5, lambda run: run.mission.breakdown.after_s == 9.5),
        ("fail-rate", 0.25, lambda run: run.fail_rate == 0.25),
        ("fail.carrier-1", 4, lambda run: run.mission.failures[-1].at_s == 4),
        ("variable.carrier.Dock", 3, lambda run: run.members[0].machine.variables()["Dock"] == 3),
    ],
)
def test_a_value_is_in_the_run(name, value, found):
    opened = kitrobot.open_mission("transport-team")
    address = find_address(mission_addresses(opened), name)
    variant = variant_of(opened, 0.0)
    address.put(variant, address.check(value))
    run = open_variant(variant, opened).prepare(RunOptions(fail_rate=variant.fail_rate)).simulation
    assert found(run)


def test_of_an_address_that_is_not_there_the_nearest_is_named():
    known = mission_addresses(kitrobot.open_mission("transport"))
    with pytest.raises(ExperimentError, match=r"no `agents\.carier` that could vary") as told:
        find_address(known, "agents.carier")
    assert told.value.help == "did you mean agents.carrier?"


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("carrier.v10.speed", "101", "expected a whole number from 0 to 100, found `101`"),
        ("carrier.v10.speed", "50.5", "expected a whole number from 0 to 100"),
        ("carrier.v10.speed", "nan", "found `nan`"),
        ("carrier.v10.speed", "fast", "found `fast`"),
        ("fail-rate", "inf", "from 0 to 1"),
        ("breakdown.rule", "push", "expected stay, tow or pass"),
        ("storehouse.A.stock", "-1", "from 0 to 65535"),
    ],
)
def test_a_value_outside_the_range_of_its_address_is_refused_with_the_range(name, text, words):
    address = find_address(mission_addresses(kitrobot.open_mission("transport")), name)
    with pytest.raises(ExperimentError, match=words):
        address.read(text)
