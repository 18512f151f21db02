"""The pieces of the model, each against a plain way to say the same."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from kitrobot.compiler.compilation import compile_text
from kitrobot.image.machine import Machine
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.programs import AbstractionError, ProgramTable, value_classes
from kitrobot.verifier.properties.properties import AgentFact, Property, ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from kitrobot.verifier.tables.roads import Gaps, possible, possible_everywhere, zones_of
from tests.effort import examples
from tests.sim.building import WHEEL, avatar, catalogue, empty_world, run_of, shipped_world


def table(text: str, robot: str = "mini-robot") -> ProgramTable:
    image = compile_text(text, catalogue().robots[robot], "test.lll").image
    assert image is not None
    return ProgramTable(image, catalogue().robots[robot])


@settings(max_examples=examples(100), deadline=None)
@given(
    st.lists(st.floats(0, 1000), max_size=6),
    st.booleans(),
    st.floats(0, 999.9),
    st.floats(0, 999.9),
    st.lists(st.floats(1, 400), max_size=2),
)
def test_a_gap_that_there_is_is_possible(
    cuts: list[float], closed: bool, mine: float, theirs: float, reaches: list[float]
) -> None:
    zones = zones_of(1000.0, closed, cuts)
    gaps = Gaps(tuple(sorted(set(reaches))), 100.0)
    way = theirs - mine
    if way < 0:
        assume(closed)
        way += 1000.0
    assume(way >= 100.0)
    one, other = zones.zone_at(mine), zones.zone_at(theirs)
    ahead = (other - one) % len(zones)
    if ahead == 0 and theirs < mine:
        ahead = len(zones)
    assert possible(zones, gaps, one, ahead)[gaps.class_of(way - gaps.lengths_mm)]


def test_all_gaps_at_once_are_those_one_by_one() -> None:
    for closed in (False, True):
        zones, gaps = zones_of(1000.0, closed, [10.5, 70.25, 333.0, 900.125]), Gaps((150.0,), 100.0)
        one_by_one = [
            can
            for zone in range(len(zones))
            for ahead in range(len(zones) + 1)
            for can in possible(zones, gaps, zone, ahead)
        ]
        assert possible_everywhere(zones, gaps) == one_by_one


def test_classes_are_cut_by_the_constants_that_a_sensor_is_compared_with() -> None:
    made = table("*[Run.IsTrue()]( [Captor.LessThan(30)]( Light.LightOn(); )!( Light.LightOff(); ); );")
    layout = made.machine.layout
    part = layout.ranges["Captor"]
    classes = value_classes(made.machine.image, layout.sensors["Captor"], part.minimum, part.maximum)
    assert [value for value in classes if value < 30]
    assert [value for value in classes if value >= 30]
    assert len(classes) <= 4


def test_a_sensor_that_is_not_read_makes_no_difference_and_a_copied_one_all_the_difference() -> None:
    made = table("Light.LightOn(); Light.LightOff();")
    choices = {at: range(100) for at in range(made.inputs)}
    assert len(made.react(made.first, (None,) * made.inputs, made.first_shared, choices)) == 1


def test_a_value_of_very_many_that_is_copied_is_refused_in_words() -> None:
    made = table("*[Run.IsTrue()]( Count.Set(Captor.Value()); );")
    choices = {at: range(65_536) for at in range(made.inputs)}
    with pytest.raises(AbstractionError, match="may read too many different values at once"):
        made.react(made.first, (None,) * made.inputs, made.first_shared, choices)


@settings(max_examples=examples(20), deadline=None)
@given(st.integers(0, 10_000))
def test_a_table_says_what_the_interpreter_says(seed: int) -> None:
    """Local states drop what is dead; what a program does does not change by that."""
    text = """
    3*( [Captor.LessThan(30)]( Light.LightOn(); WAIT(1); )!( Light.LightOff(); ); );
    //( <Captor.LessThan(10)>( Light.LightOn(); );, °Wheel.Advance(50)°; WAIT(2); );
    """
    made = table(text)
    chance = random.Random(seed)
    machine = Machine(made.machine.image, made.machine.robot)
    local = made.first
    for _ in range(60):
        sensed = tuple(chance.choice((0, 1, 20, 50)) for _ in range(made.inputs))
        for at, value in enumerate(sensed):
            machine.cells[1 + at] = value
        commands = [(command.actuator, command.procedure) for command in machine.tick()]
        (reaction,) = made.react(local, sensed, made.first_shared, {})
        local = reaction.local
        names = made.machine.layout.commands
        assert [names[command][1:] for _, command, _ in reaction.commands] == commands
        assert reaction.ended == machine.ended == made.has_ended(local)
        assert len(made) <= 40


def test_who_ticks_more_slowly_may_miss_a_moment_of_lockstep_and_never_all_of_them() -> None:
    fast, slow = avatar(WHEEL.format(settings=""), name="fast"), avatar(WHEEL.format(settings=""), tick=40, name="slow")
    world = empty_world(a=(500, 500, 0), b=(900, 900, 0))
    run = run_of({"a": (fast, "3*( WAIT(1); );"), "b": (slow, "3*( WAIT(1); );")}, world)
    parts = abstract_run(run)

    def answer(over: bool) -> str:
        model = Model(run, parts)
        waits = ((AgentFact(1, lambda inside: model.has_ended(1, inside) != over),),)
        made = check_properties(
            model, [Property("over", Sentence("in the end both end, or not"), waits=waits)], Budget()
        )
        return made.verdicts[0].answer.value

    assert answer(True) == "holds"
    assert answer(False) == "broken"


def test_a_distance_and_an_angle_are_done_at_any_time_and_have_no_length_on_a_road() -> None:
    robot = catalogue().robots["mini-robot"]
    text = "Wheel.DriveBy(30); Motor.LeftBy(90); Motor.AbsoluteTurn(25, 50); Wheel.BackBy(5); Motor.RightBy(1);"
    run = run_of({"a": (robot, text)}, empty_world(a=(200.0, 200.0, 0.0)))
    parts = abstract_run(run)
    made = check_properties(Model(run, parts), ready_properties(Model(run, parts)), Budget(10_000))
    assert {one.property.name: one.answer.value for one in made.verdicts}["deadlock"] == "holds"
    for act in parts.parts[0].acts:
        if act.busy >= 0:
            assert min(act.ways[command] for command in act.later) >= 0  # one more is what is busy; 0 is done
    by = '<procedure name="DriveBy" completes="later"><parameter name="distance" min="0" max="100"/></procedure>'
    guided = WHEEL.format(settings='guide="road"').replace("</actuator>", f"{by}</actuator>")
    ring = shipped_world("ring")
    start = next(one for one in ring.starts if one.road)
    world = replace(ring, starts=(replace(start, name="a"),))
    run = run_of({"a": (avatar(guided), "Wheel.DriveBy(30);")}, world)
    with pytest.raises(AbstractionError, match=r"`a` drives a distance or turns on a road \(`Wheel\.DriveBy`\)"):
        abstract_run(run)
