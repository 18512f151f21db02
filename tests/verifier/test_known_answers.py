"""What is known of the shipped missions, and of ones that were made wrong on purpose."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.checking.verification import VerificationOptions, verify
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.custom_properties import build_custom_properties, property_variables
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from kitrobot.verifier.report.replay import confirm
from tests.sim.building import transport
from tests.verifier.check_fixtures import EXAMPLES, answers, judged, mutant, prepared

SAFE = ("contact", "empty-storehouse", "empty-swing", "stock", "deadlock", "stopped")
COUNTS = '<vertex id="v11" element="Loaded.Add"><set name="value">1</set></vertex>'
UNCOUNTED = (COUNTS, COUNTS.replace("1</set>", "0</set>"))
LIVE = ("delivered", "served-carrier-1", "served-carrier-2", "end")


@pytest.mark.parametrize("timing", [Timing.LOCKSTEP, Timing.PROMPT])
def test_the_transport_mission_is_right_as_long_as_nobody_lags(timing: Timing) -> None:
    made = judged(transport(stock=2, carriers=2), timing)
    assert made.complete
    assert answers(made) == dict.fromkeys((*SAFE, *LIVE), "holds")


def test_nor_is_it_wrong_where_agents_may_lag_as_they_like() -> None:
    made = judged(transport(stock=2, carriers=1), Timing.FREE)
    assert made.complete
    assert set(answers(made).values()) == {"holds"}


def test_a_loader_that_does_not_wait_until_b_has_counted_is_found_out(tmp_path: Path) -> None:
    """B may then count a box that was delivered, and waits for one more than there are."""
    old = '<vertex id="v7" element="Counted.IsTrue"/>'
    run = mutant(tmp_path, (old, old.replace("Counted", "Run")), carriers=1, stock=1).again()
    assert answers(judged(run, Timing.FREE))["end"] == "broken"


@pytest.mark.parametrize(
    ("old", "new", "broken"),
    [
        pytest.param(
            '<vertex id="v15" element="Wheel.Stop"/>',
            '<vertex id="v15" element="Lamp.LightOn"/>',
            "contact",
            id="a carrier that does not stop for the one ahead",
        ),
        pytest.param(
            *UNCOUNTED,
            "empty-storehouse",
            id="a loader that does not count",
        ),
        pytest.param(
            '<vertex id="v4" element="Presence.IsPressed"/>\n    <vertex id="v5" element="Arm.Unload"/>',
            '<vertex id="v4" element="Run.IsTrue"/>\n    <vertex id="v5" element="Arm.Unload"/>',
            "empty-swing",
            id="an unloader that does not look",
        ),
        pytest.param(
            '<vertex id="v7" element="Goal.Add"/>\n    <vertex id="v8" element="Order.Value"/>',
            '<vertex id="v7" element="Goal.Add"/>\n    <vertex id="v8" element="Goal.Value"/>',
            "delivered",
            id="a store-manager that miscounts",
        ),
        pytest.param(
            '<vertex id="v25" element="Cargo.IsPressed"/>',
            '<vertex id="v25" element="Cargo.IsReleased"/>',
            "delivered",
            id="a carrier that takes no box along",
        ),
    ],
)
def test_a_mission_made_wrong_is_found_out(tmp_path: Path, old: str, new: str, broken: str) -> None:
    # A promise is only known to be broken once all states are known: one carrier has few.
    fewer = {"carriers": 1, "stock": 2} if broken == "delivered" else {}
    run = mutant(tmp_path, (old, new), **fewer).again()
    made = judged(run, Timing.LOCKSTEP)
    verdict = next(verdict for verdict in made.verdicts if verdict.property.name == broken)
    assert verdict.answer.value == "broken"
    assert verdict.counterexample is not None
    assert len(verdict.counterexample.states) == len(verdict.counterexample.steps) + 1
    assert all(
        step.state == state
        for step, state in zip(verdict.counterexample.steps, verdict.counterexample.states[1:], strict=True)
    )


FALL = (
    '<arc from="v11" to="v3" at="return"/>\n    <arc from="v3" to="v1" at="return"/>\n    <arc from="v1" to="stop"/>\n'
    '  </program>\n  <program name="unloader"',
    """<vertex id="v12" element="When"/>
    <vertex id="v13" element="Presence.IsReleased"/>
    <arc from="v11" to="v12"/>
    <arc from="v13" to="v12" at="condition"/>
    <arc from="v12" out="body" to="v12" at="return"/>
    <arc from="v12" to="v3" at="return"/>
    <arc from="v3" to="v1" at="return"/>
    <arc from="v1" to="stop"/>
  </program>
  <program name="unloader\"""",
)
"""A loader that waits, after each box, until nobody stands before it any more."""


@pytest.mark.parametrize("timing", list(Timing))
def test_a_loader_that_waits_for_presence_to_fall_misses_it_only_where_it_may_lag(
    tmp_path: Path, timing: Timing
) -> None:
    made = judged(mutant(tmp_path, FALL, carriers=1, stock=2).again(), timing)
    assert made.complete
    broken = {name for name, answer in answers(made).items() if answer == "broken"}
    assert broken == ({"deadlock", "delivered", "served-carrier-1", "end"} if timing is Timing.FREE else set())


NARROW = "Sign.EqualTo(5) | Sign.EqualTo(0)"
ALONE = AskedProperty("alone", Form.NEVER, f"any carrier-1 ({NARROW}) & any carrier-2 ({NARROW})")
"""That never both carriers of `merge` are on the way that their roads share; contact on different roads is not in the
model."""


@pytest.mark.parametrize("minded", [True, False], ids=["with a gate", "with the collision sensor alone"])
def test_the_narrow_way_of_merge_needs_its_gate(tmp_path: Path, minded: bool) -> None:
    text = (EXAMPLES / "merge" / "merge.krt").read_text(encoding="utf-8")
    for turn in (1, 2):
        old = f'<vertex id="v12" element="Turn.EqualTo"><set name="value">{turn}</set></vertex>'
        assert text.count(old) == 1
        text = text if minded else text.replace(old, '<vertex id="v12" element="Run.IsTrue"/>')
    path = tmp_path / "merge.krt"
    path.write_text(text, encoding="utf-8")
    fresh = prepared(path).spec.simulation
    run = fresh(1)
    model = Model(run, abstract_run(run, property_variables(run, [ALONE])))
    [alone], left_out = build_custom_properties(model, [ALONE])
    assert left_out == []
    # With its gate the mission is right in all else too, which is looked at in the same search.
    made = check_properties(model, [alone, *(ready_properties(model) if minded else [])], Budget(200_000))
    verdict = made.verdicts[0]
    assert verdict.answer.value == ("holds" if minded else "broken")
    if minded:
        assert made.complete
        assert set(answers(made).values()) == {"holds"}
    else:
        assert verdict.counterexample is not None
        assert confirm(alone, verdict.counterexample, model, fresh, lambda: False) is not None


def test_a_loader_that_does_not_count_is_confirmed_in_the_simulator(tmp_path: Path) -> None:
    made = verify(
        mutant(tmp_path, UNCOUNTED, stock=1),
        VerificationOptions(("empty-storehouse",), (Timing.LOCKSTEP,), seconds=None),
    )
    finding = made.columns[0].findings[0]
    assert finding.confirmed is not None
    assert finding.confirmed.faults == ()
    assert str(finding.story[-1][1]) == "loader reaches into the empty storehouse A"


def test_a_carrier_that_fails_stops_the_others_and_the_simulator_shows_it(tmp_path: Path) -> None:
    made = verify(
        mutant(tmp_path, stock=1),
        VerificationOptions(("deadlock",), (Timing.LOCKSTEP,), failures=1, states=1_000, seconds=None),
    )
    assert [column.judged.failures for column in made.columns] == [0, 1]
    holds, broken = (column.findings[0] for column in made.columns)
    assert holds.verdict.answer.value == "holds"
    assert broken.verdict.answer.value == "broken"
    assert broken.confirmed is not None
    assert broken.confirmed.faults


def test_a_mission_with_two_roads_is_right_in_lockstep() -> None:
    """`merge` is another: `test_the_narrow_way_of_merge_needs_its_gate`."""
    made = judged(prepared(EXAMPLES / "passing-loop" / "passing-loop.krt").again(), Timing.LOCKSTEP)
    assert made.complete
    assert set(answers(made).values()) == {"holds"}


def test_more_robots_than_can_be_followed_end_in_an_answer(tmp_path: Path) -> None:
    """Nine on one road, bumper to bumper: they all wait, which is found though not all is looked at."""
    text = (EXAMPLES / "transport" / "transport.krt").read_text(encoding="utf-8")
    agent = '    <agent name="carrier-3" program="carrier"/>\n'
    more = "".join(agent.replace("carrier-3", f"carrier-{number}") for number in range(4, 10))
    ring = (EXAMPLES.parent / "src" / "kitrobot" / "world" / "shipped" / "ring.world.xml").read_text(encoding="utf-8")
    start = '  <start name="carrier-3" road="ring" at="1100"/>\n'
    starts = "".join(
        start.replace("carrier-3", f"carrier-{number}").replace("1100", str(1100 - 140 * (number - 3)))
        for number in range(4, 10)
    )
    (tmp_path / "full.world.xml").write_text(ring.replace(start, start + starts), encoding="utf-8")
    path = tmp_path / "full.krt"
    path.write_text(text.replace(agent, agent + more).replace("ring.world.xml", "full.world.xml"), encoding="utf-8")
    made = verify(prepared(path), VerificationOptions((), (Timing.LOCKSTEP,), states=500, seconds=None, confirms=False))
    assert not made.columns[0].judged.complete
    assert {answer.value for answer in made.answers} == {"broken", "not finished"}
