"""Properties that speak of roles, groups and works: who is in them is what the team has agreed on at that moment."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from kitrobot.lll.parse_results import parse_team
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.properties.conditions import PropertyError, parse_condition
from kitrobot.verifier.properties.custom_properties import build_custom_properties, property_variables
from kitrobot.verifier.properties.run_conditions import declared_of, team_of
from kitrobot.verifier.properties.verdicts import check_properties
from kitrobot.verifier.report.replay import confirm
from tests.sim.team_building import RunningTeam

PROGRAM = """role scout: ant 2; role helper: ant; group ahead = scout; group behind = {helper};
group whole = {ahead, behind}; work Boxes = 2;
Where ahead [Count.LessThan(1)]( Count.Add(1); ) ! ( );
MOVE 2 ahead -> behind;
Where behind [Count.LessThan(3)]( Count.Add(1); ) ! ( );
ParOfSeq whole ( Boxes.Take(); Arm.Do(1); Boxes.Done(); );
"""
AGENTS = {"scout-0": ("ant", "scout"), "scout-1": ("ant", "scout"), "helper-0": ("ant", "helper")}
ASKED = {
    "e1": ("holds", AskedProperty("e1", Form.EVENTUALLY, "all scout (Count.EqualTo(2))")),
    "e2": ("holds", AskedProperty("e2", Form.EVENTUALLY, "all whole (Boxes.IsEmpty())")),
    "e3": ("holds", AskedProperty("e3", Form.EVENTUALLY, "most behind (Count.EqualTo(2))")),
    "n1": ("holds", AskedProperty("n1", Form.NEVER, "any ahead (Count.GreaterThan(1))")),
    "a1": ("holds", AskedProperty("a1", Form.AFTER, "any ahead (Count.EqualTo(1))", "any behind (Count.EqualTo(2))")),
    "s1": ("holds", AskedProperty("s1", Form.STAYS, "all ahead (Count.LessThan(2))", "any behind (Count.EqualTo(9))")),
    "n2": ("broken", AskedProperty("n2", Form.NEVER, "any behind (Count.EqualTo(2))")),
    "n3": ("broken", AskedProperty("n3", Form.NEVER, "any {helper, scout-0} (Count.EqualTo(2))")),
    "e4": ("broken", AskedProperty("e4", Form.EVENTUALLY, "all whole (Count.EqualTo(2))")),
    "n4": ("broken", AskedProperty("n4", Form.NEVER, "any helper (Boxes.IsEmpty())")),
}


@pytest.fixture(scope="module")
def fresh() -> Callable[[int], Simulation]:
    parsed = parse_team(PROGRAM)
    assert parsed.diagnostics == []
    maker: Any = SimpleNamespace(agents=AGENTS, programs={})
    team = RunningTeam(maker, parsed.program, 1)
    return lambda seed: team.anew()


@pytest.mark.parametrize("name", ASKED)
def test_roles_groups_and_works_are_asked_as_they_are_at_that_moment(
    fresh: Callable[[int], Simulation], name: str
) -> None:
    answer, one = ASKED[name]
    run = fresh(1)
    model = Model(run, abstract_run(run, property_variables(run, [one])))
    properties, left_out = build_custom_properties(model, [one])
    assert left_out == []
    made = check_properties(model, properties, Budget(50_000))
    assert made.complete
    [verdict] = made.verdicts
    assert verdict.answer.value == answer
    if verdict.counterexample is not None:
        assert confirm(verdict.property, verdict.counterexample, model, fresh, lambda: False) is not None
    else:
        run = fresh(1)
        assert verdict.property.monitor is not None
        monitor = verdict.property.monitor(run)
        while run.outcome is None:
            run.advance(1)
            assert not monitor.after_step()
        assert not monitor.at_end("done")


def test_what_is_no_role_and_no_group_is_refused_and_so_is_a_part_that_a_member_lacks(
    fresh: Callable[[int], Simulation],
) -> None:
    run = fresh(1)
    with pytest.raises(PropertyError, match="`scouts` is no agent") as refused:
        parse_condition("any scouts (Count.EqualTo(1))", team_of(run), declared_of(run))
    assert "scout" in refused.value.help
    with pytest.raises(PropertyError, match="Cargo"):
        parse_condition("any whole (Cargo.IsPressed())", team_of(run), declared_of(run))
    with pytest.raises(PropertyError, match="`whole` is no agent"):
        parse_condition("any whole (Count.EqualTo(1))", team_of(run))
