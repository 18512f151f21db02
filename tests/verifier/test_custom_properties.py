"""Properties that a mission asks for: their four forms, whom they speak of, and the simulator's word on them."""

from __future__ import annotations

import pytest

from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.properties.conditions import PropertyError, parse_condition
from kitrobot.verifier.properties.custom_properties import build_custom_properties, property_variables
from kitrobot.verifier.properties.properties import Condition, SensedCondition
from kitrobot.verifier.properties.run_conditions import team_of
from kitrobot.verifier.properties.verdicts import Verdict, check_properties
from kitrobot.verifier.report.replay import confirm
from kitrobot.verifier.tables.state_decoding import decode, sense_key
from tests.sim.building import transport

LOADED, EMPTY = "any carrier-1 (Cargo.IsPressed())", "any carrier-1 (Cargo.IsReleased())"
AT_A, AT_B = "any carrier-1 (Sign.EqualTo(0))", "any carrier-1 (Sign.EqualTo(3))"
NEVER_3 = "any loader (StockA.GreaterThan(3))"
ASKED = {
    "holds": [
        AskedProperty("n1", Form.NEVER, f"{AT_A} & {AT_B}"),
        AskedProperty("n2", Form.NEVER, "all {carrier-1, carrier-2} (Sign.EqualTo(0) & Collision.IsPressed())"),
        AskedProperty("a1", Form.AFTER, LOADED, EMPTY),
        AskedProperty("e1", Form.EVENTUALLY, "any store-manager-B (Goal.EqualTo(2))"),
        AskedProperty("s1", Form.STAYS, LOADED, AT_B),
    ],
    "broken": [
        AskedProperty("n3", Form.NEVER, LOADED),
        AskedProperty("n4", Form.NEVER, f"{AT_A} | any carrier-2 (Cargo.IsPressed())"),
        AskedProperty("a2", Form.AFTER, LOADED, NEVER_3),
        AskedProperty("e2", Form.EVENTUALLY, NEVER_3),
        AskedProperty("s2", Form.STAYS, LOADED, AT_A),
    ],
    "vacuous": [
        AskedProperty("n5", Form.NEVER, f"{NEVER_3} & any store-manager-B (Goal.GreaterThan(7))"),
        AskedProperty("a3", Form.AFTER, NEVER_3, LOADED),
        AskedProperty("s3", Form.STAYS, NEVER_3, LOADED),
    ],
}


def holds(model: Model, condition: Condition | None, state: State) -> bool:
    """Whether a condition of what agents sense holds in a state."""
    assert isinstance(condition, SensedCondition)
    decode(model.t, *model.layout.key(state))
    return condition.test(tuple(sense_key(model.t, i) for i in condition.agents))


def fresh(seed: int = 1) -> Simulation:
    return transport(stock=2, carriers=2, seed=seed, seconds=200.0)


@pytest.fixture(scope="module")
def judged() -> tuple[Model, dict[str, Verdict]]:
    run, asked = fresh(), [one for ones in ASKED.values() for one in ones]
    model = Model(run, abstract_run(run, property_variables(run, asked)))
    properties, left_out = build_custom_properties(model, asked)
    assert left_out == []
    made = check_properties(model, properties, Budget())
    assert made.complete
    return model, {verdict.property.name: verdict for verdict in made.verdicts}


@pytest.mark.parametrize("answer", list(ASKED))
def test_each_form_is_answered(judged, answer: str) -> None:
    _, verdicts = judged
    assert {one.name: verdicts[one.name].answer.value for one in ASKED[answer]} == {
        one.name: answer for one in ASKED[answer]
    }


@pytest.mark.parametrize("one", ASKED["broken"], ids=lambda one: one.name)
def test_what_is_broken_has_a_run_that_breaks_it_and_the_simulator_confirms_it(judged, one: AskedProperty) -> None:
    model, verdicts = judged
    verdict = verdicts[one.name]
    assert verdict.counterexample is not None
    properties, _ = build_custom_properties(model, [one])
    [mine] = properties
    states = verdict.counterexample.states
    assert all(step.state == state for step, state in zip(verdict.counterexample.steps, states[1:], strict=True))
    if mine.never is not None:
        assert [holds(model, mine.never, state) for state in states] == [False] * (len(states) - 1) + [True]
    elif mine.breaks is not None:
        before, after = mine.breaks
        assert holds(model, before, states[-2])
        assert holds(model, after, states[-1])
    else:
        assert mine.waits is not None
        assert verdict.counterexample.repeats_from >= 0
        assert all(holds(model, mine.waits, state) for state in states[verdict.counterexample.repeats_from :])
    assert confirm(verdict.property, verdict.counterexample, model, fresh, lambda: False) is not None


def test_a_run_of_the_simulator_does_not_break_what_holds(judged) -> None:
    _, verdicts = judged
    run = fresh()
    monitors = {
        one.name: monitor(run) for one in ASKED["holds"] if (monitor := verdicts[one.name].property.monitor) is not None
    }
    assert len(monitors) == len(ASKED["holds"])
    while run.outcome is None:
        run.advance(1)
        assert not any(monitor.after_step() for monitor in monitors.values())
    assert run.outcome == "done"
    assert {name: monitor.at_end("done") for name, monitor in monitors.items()} == dict.fromkeys(monitors, False)


@pytest.mark.parametrize(
    ("text", "words", "help"),
    [
        ("", "expected a condition", ""),
        ("any carrier-1 (Cargo.IsPressed()", "expected", ""),
        ("Cargo.IsPressed()", "does not say whose it is", "any carrier-1 (…)"),
        ("any carrier-9 (Cargo.IsPressed())", "no agent of this team", "carrier-2"),
        ("any carrier-1 (Cargo.IsPresed())", "IsPresed", "IsPressed"),
        ("any loader (Cargo.IsPressed())", "Cargo", ""),
        ("any carrier-1 (any carrier-2 (Cargo.IsPressed()))", "inside another one", ""),
        ("any carrier-1 (Cargo.IsPressed())](WAIT(1)); [any carrier-1 (Cargo.IsPressed())", "is no condition", ""),
        ("!(" * 200 + LOADED + ")" * 200, "levels deep", ""),
        ("any carrier-1 (Sign.EqualTo(99999999))", "number", ""),
        ("\x00", "expected", ""),
    ],
)
def test_a_condition_that_is_none_is_refused_in_a_sentence(text: str, words: str, help: str) -> None:
    with pytest.raises(PropertyError) as refused:
        parse_condition(text, team_of(fresh()))
    assert words in refused.value.message
    assert help in refused.value.help
