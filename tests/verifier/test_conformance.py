"""Every step of the simulator is one that the model allows in lockstep: the plain model of `tests.verifier.reference`,
whose states and answers `test_equality` holds the tables to.

The model's hidden flags (whether a robot is new in its zone, since when it brakes) cannot be read off the simulator, so
all model states that fit what was seen are followed side by side; there must always be one.
"""

from __future__ import annotations

import random
from collections.abc import Collection, Sequence
from typing import Any

import pytest

from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.world.geometry import Corner
from kitrobot.world.model import Dock, Road, Start, Storehouse, World
from tests.effort import cases
from tests.sim.building import WHEEL, avatar, catalogue, empty_world, run_of, transport
from tests.verifier.check_fixtures import EXAMPLES, prepared
from tests.verifier.reference.model import Model, State
from tests.verifier.reference.timing import Clock, Timing

KINDS = (FailureKind.FAIL, FailureKind.STALL)
ALL_KINDS = (*KINDS, FailureKind.MUTE)


def seen(run: Simulation, model: Model) -> Any:
    """What can be seen of a run that is also in a state of the model."""
    state = run.state
    floats, ints = state.robots.floats, state.robots.ints
    agents = []
    for i, part in enumerate(model.parts):
        table, machine = part.table, run.members[i].machine
        table.machine.restore(machine.snapshot())
        motion: tuple[object, ...] = ()
        if part.track is not None and ints[c.ROAD][i] >= 0:
            zones = part.track.zones
            gap = part.track.gaps.class_of(floats[c.GAP_AHEAD][i])
            motion = zones.zone_at(floats[c.AT][i]), _sign(floats[c.SPEED][i]), _sign(floats[c.TARGET][i]), gap
        # Of who failed or has ended nobody can tell whether it has a radio.
        is_alone = ints[c.MUTED][i] and ints[c.DOWN][i] != c.FAILED and not ints[c.ENDED][i]
        own = tuple(int(machine.cells[cell]) for cell in table.shared) if is_alone else ()
        agents.append((table.current(), ints[c.LOAD][i], ints[c.DOWN][i], motion, own))
    return tuple(agents), tuple(state.docks.stock), tuple(state.shared.ints[0])


def shown(state: State, model: Model) -> Any:
    """The same of a state of the model."""
    agents = []
    for i in range(model.count):
        inside = model.inside(state, i)
        motion: tuple[object, ...] = ()
        for at, road in enumerate(model.traffic):
            if i in road.agents:
                body = road.body(state[model.roads_at + at], i)
                track = model.parts[i].track
                assert track is not None
                motion = body.zone, body.way, body.want, min(body.gap, track.gaps.beyond)
        own = inside.own if inside.down != c.FAILED and not model.ended(state, i) else ()
        agents.append((inside.local, inside.load, inside.down, motion, own))
    return tuple(agents), state[model.stock_at : model.shared_at], state[model.shared_at : model.failures_at]


def _sign(number: float) -> int:
    return int(number > 0) - int(number < 0)


def follow(
    run: Simulation,
    steps: int,
    failures: int = 0,
    kinds: Collection[FailureKind] = KINDS,
    harms: Sequence[tuple[int, str, FailureKind]] = (),
) -> int:
    """Follows a run, and all states of the model that fit; gives how many different things were seen.

    `harms` is what is done by hand: before which step, to whom, and what.
    """
    model = Model(run, abstract_run(run), failures, kinds)
    clock = Clock(model, Timing.LOCKSTEP)
    fitting = {model.first}
    different = set()
    for _ in range(steps):
        if run.outcome is not None:
            break
        before = run.tick
        for _, agent, kind in [harm for harm in harms if harm[0] == before]:
            run.inject_fault(agent, kind)
        run.advance(1)
        now = seen(run, model)
        different.add(now)
        befallen = {state for one in fitting for state in injected_faults(one, now, model)}
        ticked = {after for state in befallen for after in model.after_all(state)}
        fitting = {moved for state in ticked for moved, _, _ in clock.moments(state) if shown(moved, model) == now}
        assert fitting, f"step {before}: {now}"
    return len(different)


def injected_faults(state: State, now: Any, model: Model) -> set[State]:
    """A state of the model, and those after failures that agents were seen to have."""
    down = [agent[2] for agent in now[0]]
    found = {state}
    waiting = [state]
    while waiting:
        for _, after in model.failures(waiting.pop()):
            if after not in found:
                found.add(after)
                waiting.append(after)
    return {one for one in found if [model.inside(one, i).down for i in range(model.count)] == down}


@pytest.mark.parametrize("seed", cases([1, 2], list(range(3, 60))))
def test_the_transport_mission_does_nothing_that_the_model_does_not(seed: int) -> None:
    assert follow(transport(seed, stock=3, carriers=3), 4000) > 50


def test_distances_and_angles_take_a_while_in_the_model_too() -> None:
    robot = catalogue().robots["mini-robot"]
    program = "2*( Wheel.DriveBy(5); Wheel.BackBy(3); Motor.LeftBy(20); Motor.RightBy(5); );"
    assert follow(run_of({"a": (robot, program)}, empty_world(a=(1000, 1000, 0))), 400) > 8


@pytest.mark.parametrize("name", ["merge", "passing-loop"])
def test_missions_on_two_roads_do_nothing_that_the_model_does_not(name: str) -> None:
    assert follow(prepared(EXAMPLES / name / f"{name}.krt").again(), 3000) > 50


@pytest.mark.parametrize("seed", cases([2], [1, *range(3, 60)]))
def test_failures_do_nothing_that_the_model_does_not(seed: int) -> None:
    chance = random.Random(seed)
    harms = [
        Failure(f"carrier-{chance.randint(1, 3)}", chance.randint(1, 300) / 10, chance.choice(KINDS)) for _ in range(2)
    ]
    follow(transport(seed, stock=3, carriers=3, failures=harms), 3000, failures=2)


@pytest.mark.parametrize("seed", cases([1], list(range(2, 60))))
def test_robots_without_a_radio_do_nothing_that_the_model_does_not(seed: int) -> None:
    """Those that share variables lose it at any moment; what else befalls anybody comes then or later."""
    chance = random.Random(seed)
    first = chance.randint(1, 100) / 10
    who = chance.choice(("store-manager-A", "store-manager-B", "loader", "unloader"))
    other = chance.choice((who, "carrier-1", "loader"))
    harms = [
        Failure(who, first, chance.choice((FailureKind.STALL, FailureKind.MUTE))),
        Failure(who, first, FailureKind.MUTE),
        Failure(other, first + chance.randint(0, 100) / 10, chance.choice(ALL_KINDS)),
    ]
    follow(transport(seed, stock=3, carriers=2, failures=harms), 3000, 3, ALL_KINDS)


@pytest.mark.parametrize(
    ("name", "seed"),
    cases(
        [("passing-loop", 3)],
        [("merge", 3), *((name, seed) for seed in (*range(3), *range(4, 60)) for name in ("merge", "passing-loop"))],
    ),
)
def test_failures_on_two_roads_do_nothing_that_the_model_does_not(name: str, seed: int) -> None:
    """On `passing-loop` with 3, a carrier stalls, rolls to the end of its road and stands there."""
    chance = random.Random(seed)
    run = prepared(EXAMPLES / name / f"{name}.krt").again()
    sharing = [agent.name for agent in run.members if any(one.shared for one in agent.robot.variables)]
    harms = sorted((chance.randint(0, 1500), chance.choice(sharing), chance.choice(ALL_KINDS)) for _ in range(2))
    if name == "passing-loop" and seed == 3:
        harms[0] = (487, "carrier-2", FailureKind.STALL)
    follow(run, 1500, 2, ALL_KINDS, harms)


@pytest.mark.parametrize("way", ["Advance", "Reverse"])
@pytest.mark.parametrize("cut", [(), (450.0,)])
def test_at_the_end_of_an_open_road_a_robot_stands_in_the_model_too(way: str, cut: tuple[float, ...]) -> None:
    """On a road that is one zone, and on one that a dock cuts into three."""
    road = Road("lane", 100, False, (Corner(100, 100), Corner(600, 100)))
    houses = tuple(Storehouse("A", 700, 700, 100, 100, 5, 2) for _ in cut)
    docks = tuple(Dock("in", "lane", at, 30, "A", "load") for at in cut)
    start = Start("a", road="lane", at_mm=300)
    world = World("lane", 1000, 1000, roads=(road,), docks=docks, storehouses=houses, starts=(start,))
    guided = avatar(WHEEL.format(settings='guide="road"'))
    assert follow(run_of({"a": (guided, f"Wheel.{way}(100); WAIT(600);")}, world), 200) > 2
