"""The transport mission: it is done for any stock, any number of carriers and any seed, without a collision."""

from __future__ import annotations

import random

import pytest

from kitrobot.mission.radio import Radio
from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.setup.limits import SimulationError
from kitrobot.sim.simulation import Simulation
from tests.effort import cases
from tests.sim.building import transport

CASES = cases(
    [(0, 1), (1, 3), (2, 2), (5, 1), (12, 3)],
    [(0, 2), (0, 3), (1, 1), (1, 2), (2, 1), (2, 3), (5, 2), (5, 3), (12, 1), (12, 2)],
)
RNG = random.Random(7)


def finished(run: Simulation) -> Simulation:
    while run.outcome is None:
        before = (run.total, sum(run.stock.values()) + sum(run.stage.bodies.load))
        run.step()
        assert (run.total, sum(run.stock.values()) + sum(run.stage.bodies.load)) == before
        for event in run.events:
            # An arm that moves without reason says so.
            assert "no empty carrier" not in event.text
            assert "no loaded carrier" not in event.text
            assert "no box" not in event.text
    return run


@pytest.mark.parametrize(("stock", "carriers"), CASES)
def test_all_stock_arrives_and_nobody_collides(stock: int, carriers: int) -> None:
    run = finished(transport(RNG.randrange(10**6), stock, carriers))
    assert (run.outcome, run.collisions) == ("done", 0), run.sentence
    assert run.stock == {"A": 0, "B": stock}
    assert sum(run.delivered.values()) == stock
    assert len(run.delivered) == carriers
    assert all(agent.active == () and agent.state != "waiting" for agent in run.agents)
    assert not any(agent.load for agent in run.agents)
    assert not any(agent.fault for agent in run.agents)


@pytest.mark.parametrize("seed", cases([0, 1], list(range(2, 8))))
def test_any_seed_is_done_and_carriers_keep_apart(seed: int) -> None:
    run = transport(seed)
    nearest = 1e9
    while run.outcome is None:
        run.step()
        nearest = min(nearest, *run.stage.bodies.gap_ahead[:3])
    assert (run.outcome, run.collisions) == ("done", 0)
    assert nearest > 50
    assert run.seconds < 80


def test_seeds_give_different_runs() -> None:
    assert len({finished(transport(seed)).tick for seed in range(4)}) > 1


def test_the_sentence_says_what_was_reached() -> None:
    assert finished(transport(1)).sentence.endswith("B holds all 12 boxes.")


def test_the_time_runs_out_in_a_sentence_and_nothing_goes_on() -> None:
    run = finished(transport(1, seconds=20))
    assert (run.outcome, run.tick) == ("time", 1000)
    assert run.sentence == "The time of 20 s ran out: B holds 3 of 12 boxes."
    assert run.advance(1) == 0
    with pytest.raises(SimulationError, match="the run has ended, so there is no step after 1000"):
        run.step()
    assert run.tick == 1000


def test_the_first_messages_say_how_many_boxes_there_are() -> None:
    run = transport(1)
    run.step()
    assert [(event.agent, event.text) for event in run.events if event.kind == "message"] == [
        ("store-manager-A", "StockA = 12"),
        ("store-manager-A", "Order = 12"),
    ]
    run.step()
    assert [(event.agent, event.text) for event in run.events] == [("store-manager-B", "Counted = true")]


@pytest.mark.parametrize(
    ("kind", "moment"),
    cases(
        [(FailureKind.FAIL, 52), (FailureKind.STALL, 1), (FailureKind.MUTE, 52)],
        [(FailureKind.FAIL, 1), (FailureKind.STALL, 52), (FailureKind.MUTE, 1)],
    ),
)
def test_a_loader_that_hears_no_more_of_the_stock_does_not_reach_into_an_empty_storehouse(
    kind: FailureKind, moment: float
) -> None:
    run = finished(transport(1, 12, failures=[Failure("store-manager-A", moment, kind)]))
    assert run.outcome == "done"
    assert run.stock == {"A": 0, "B": 12}


@pytest.mark.parametrize("manager", ["store-manager-A", "store-manager-B"])
def test_whichever_manager_comes_late_the_other_waits_and_no_box_is_counted_twice(manager: str) -> None:
    """So it does not matter either which of their messages arrives first."""
    late = [Failure(manager, 0, FailureKind.STALL), Failure(manager, 11, FailureKind.REVIVE)]
    run = finished(transport(1, 2, failures=late))
    assert (run.outcome, run.stock) == ("done", {"A": 0, "B": 2})
    assert all(agent.active == () for agent in run.agents), run.sentence


def test_an_order_that_arrives_after_what_announces_it_is_waited_for() -> None:
    """As on a network, whose messages overtake each other."""
    late = [Failure("store-manager-A", 0, FailureKind.STALL), Failure("store-manager-A", 5, FailureKind.REVIVE)]
    run = transport(1, 2, failures=late)
    run.step()
    run.set_variable("store-manager-B", "Counted", 1)
    assert (finished(run).outcome, run.stock) == ("done", {"A": 0, "B": 2})


@pytest.mark.parametrize("stock", [0, 2])
def test_messages_that_come_late_or_not_at_all_change_nothing(stock: int) -> None:
    run = finished(transport(1, stock, radio=Radio(delay_ms=700, loss=30)))
    assert (run.outcome, run.stock) == ("done", {"A": 0, "B": stock})


def test_who_takes_part_has_a_kind_and_a_number_of_its_kind() -> None:
    assert [(agent.name, agent.kind, agent.number) for agent in transport().agents] == [
        ("carrier-1", "carrier", 1),
        ("carrier-2", "carrier", 2),
        ("carrier-3", "carrier", 3),
        ("loader", "loader", 1),
        ("unloader", "unloader", 1),
        ("store-manager-A", "store-manager", 1),
        ("store-manager-B", "store-manager", 2),
    ]


def test_the_lamp_is_on_exactly_while_a_carrier_drives_loaded() -> None:
    run = transport(3, 2, 1)
    while run.outcome is None:
        run.step()
        carrier = run.view(0)
        if carrier.flags & 16:
            assert bool(carrier.flags & 1) == bool(carrier.load)
