"""Breakpoints: who comes to which vertex, how often, and under which condition; the same on every way there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest

import kitrobot
from kitrobot.compiler.compilation import compile_text
from kitrobot.image.machine import Machine
from kitrobot.mission.trial import Breakpoint
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.image_name import ImageName
from kitrobot.sim.breakpoints import Breakpoints, Condition, ConditionError, Hit
from kitrobot.sim.recorder import Recorder
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.timeline import Timeline
from kitrobot.trace.model import Place

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
TRANSPORT = kitrobot.open(EXAMPLES / "transport" / "transport.krt")
MINI = load_catalogue().robot("mini-robot")


def vertex(program: str, element: str) -> str:
    return next(one.id for one in TRANSPORT.program(program).vertices if one.element == element)


def places(simulation: Simulation) -> Mapping[ImageName, Sequence[Place]]:
    return Recorder(simulation).header.places


def run(*breakpoints: Breakpoint, steps: int = 3000) -> list[tuple[int, Hit]]:
    """Every hit of a run and the step after which it was."""
    simulation = TRANSPORT.simulation(seed=1)
    simulation.watch_programs()
    armed = Breakpoints(breakpoints, simulation.members, places(simulation))
    found = []
    while simulation.outcome is None and simulation.tick < steps:
        simulation.step()
        found += [(simulation.tick, hit) for hit in armed.after_step(simulation.tick)]
    return found


def test_each_visit_of_each_agent_is_a_hit() -> None:
    light = vertex("carrier", "Lamp.LightOn")
    hits = [hit for _, hit in run(Breakpoint("carrier", light))]
    assert {hit.agent for hit in hits} == {"carrier-1", "carrier-2", "carrier-3"}
    for agent in ("carrier-1", "carrier-2", "carrier-3"):
        visits = [hit.visit for hit in hits if hit.agent == agent]
        assert visits == list(range(1, len(visits) + 1))


def test_waiting_at_a_vertex_is_one_visit() -> None:
    simulation_hits = run(Breakpoint("unloader", vertex("unloader", "Arm.Unload")))
    assert 1 <= len(simulation_hits) <= 12


def test_only_the_agents_that_are_meant() -> None:
    light = vertex("carrier", "Lamp.LightOn")
    hits = [hit for _, hit in run(Breakpoint("carrier", light, agents=("carrier-2",)))]
    assert hits
    assert {hit.agent for hit in hits} == {"carrier-2"}


def test_from_the_third_visit_on() -> None:
    light = vertex("carrier", "Lamp.LightOn")
    plain = run(Breakpoint("carrier", light, agents=("carrier-1",)))
    counted = run(Breakpoint("carrier", light, agents=("carrier-1",), hits=3))
    assert len(plain) >= 3
    assert counted == plain[2:]


def test_a_condition_is_tested_with_what_the_agent_knows() -> None:
    light = vertex("carrier", "Lamp.LightOff")
    assert run(Breakpoint("carrier", light, when="Cargo.IsReleased()"))
    assert run(Breakpoint("carrier", light, when="Cargo.IsPressed()")) == []


def test_every_agent_stands_there() -> None:
    waits = vertex("carrier", "While")
    hits = run(Breakpoint("carrier", waits, every=True))
    assert hits
    assert len({tick for tick, _ in hits}) <= len(hits)


def test_who_runs_a_team_s_program_comes_to_places_of_programs_that_stand_in_it() -> None:
    team = kitrobot.open(EXAMPLES / "transport-team" / "transport-team.krt")
    simulation = team.simulation(seed=1)
    simulation.watch_programs()
    docks = [one.id for one in team.program("carry").vertices if one.element == "Dock.Set"]
    points = [
        *(Breakpoint("carry", one, when="Cargo.IsPressed()") for one in docks),
        Breakpoint("load", team.program("load").vertices[1].id),
        Breakpoint("transport-team", docks[0]),
    ]
    armed = Breakpoints(points, simulation.members, places(simulation))
    hits: list[Hit] = []
    while simulation.tick < 2000:
        simulation.step()
        hits += armed.after_step(simulation.tick)
    carried = {hit.vertex: hit.agent for hit in hits if hit.program == "carry"}
    assert list(carried) == docks[:1], "only who has a box goes on to B"
    assert {hit.agent for hit in hits if hit.program == "load"} == {"loader-1"}
    assert {hit.program for hit in hits} == {"carry", "load"}


def test_what_is_off_or_gone_does_nothing() -> None:
    light = vertex("carrier", "Lamp.LightOn")
    gone = (
        Breakpoint("carrier", light, enabled=False),
        Breakpoint("carrier", "nothing"),
        Breakpoint("nobody", light),
        Breakpoint("carrier", light, agents=("nobody",)),
    )
    assert run(*gone, steps=600) == []


def test_visits_are_the_same_on_every_way_there() -> None:
    light = vertex("carrier", "Lamp.LightOn")
    simulation = TRANSPORT.simulation(seed=1)
    simulation.watch_programs()
    timeline = Timeline(simulation)
    armed = Breakpoints([Breakpoint("carrier", light)], simulation.members, places(simulation))

    def on(to: int) -> list[tuple[int, Hit]]:
        found = []
        while simulation.tick < to:
            timeline.advance(1)
            found += [(simulation.tick, hit) for hit in armed.after_step(simulation.tick)]
        return found

    first = on(2500)
    timeline.go_to(700)
    armed.went_to(700)
    assert on(2500) == [one for one in first if one[0] > 700]


@pytest.mark.parametrize(
    ("text", "count", "wanted"),
    [
        ("Count.GreaterThan(3)", 4, True),
        ("Count.GreaterThan(3)", 3, False),
        ("Count.GreaterThan(3) & Run.IsFalse()", 4, False),
        ("!(Count.GreaterThan(3))", 3, True),
        ("Captor.LessThan(Count.Value())", 1, True),
    ],
)
def test_conditions_mean_what_they_mean_in_a_program(text: str, count: int, wanted: bool) -> None:
    image = compile_text("WAIT(1);", MINI).image
    assert image is not None
    machine = Machine(image, MINI)
    machine.set_variable("Count", count)
    condition = Condition(text, MINI)
    before = machine.snapshot()
    assert condition.holds(machine) is wanted
    assert condition.holds(machine) is wanted
    assert machine.snapshot() == before


@pytest.mark.parametrize(
    "text",
    ["", "Count.", "Wheel.Stop()", "Count.Value()", "Cuont.IsTrue()", "Run.IsTrue()](BREAK);[Run.IsTrue()", "(" * 5000],
)
def test_what_is_no_condition_is_said(text: str) -> None:
    with pytest.raises(ConditionError) as raised:
        Condition(text, MINI)
    assert raised.value.message
