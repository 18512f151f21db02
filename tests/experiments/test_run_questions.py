"""What is asked of a run: the forms of a question, and what runs answer."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

from kitrobot import OpenMission, RunOptions
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.run_question import RunAnswer, RunJudge
from kitrobot.mission.property_forms import AskedProperty, Form, VisitOrder
from kitrobot.mission.property_text import QuestionError, read_property
from kitrobot.workspace.mission_loader import open_mission


def answer(opened: OpenMission, question: str, seed: int = 1, fail_rate: float = 0.0) -> RunAnswer:
    spec = opened.prepare(RunOptions(seed, 30.0, fail_rate)).spec
    found = RunJudge(read_property(question), spec).answer(seed, lambda: False)
    assert found is not None
    return found


A, B, C = "any a (B.C())", "all b (C.D())", "any {before, until} (D.E())"


@pytest.mark.parametrize(
    ("text", "asked", "within"),
    [
        (f"never {A}", AskedProperty("asked", Form.NEVER, A), None),
        (f"never {A} within 12", AskedProperty("asked", Form.NEVER, A), 12),
        (f"never {A} while {C}", AskedProperty("asked", Form.NEVER, A, C), None),
        ("eventually  any a\n(B.C()) within 1.5s", AskedProperty("asked", Form.EVENTUALLY, A, seconds=1.5), None),
        (f"{A} within 3 s", AskedProperty("asked", Form.EVENTUALLY, A, seconds=3), None),
        (f"after {A} eventually {B}", AskedProperty("asked", Form.AFTER, A, B), None),
        (f"after {A} eventually {B} within 5", AskedProperty("asked", Form.AFTER, A, B, 5), None),
        (f"stays {A} until {C} within 9", AskedProperty("asked", Form.STAYS, A, C), 9),
        (f"holds {A} for 2 s", AskedProperty("asked", Form.HOLDS, A, seconds=2), None),
        (f"at most 3 times {A}", AskedProperty("asked", Form.AT_MOST, A, times=3), None),
        (f"{A} before {C}", AskedProperty("asked", Form.BEFORE, A, C), None),
        (
            "any before (B.C()) before any until (C.D())",
            AskedProperty("asked", Form.BEFORE, "any before (B.C())", "any until (C.D())"),
            None,
        ),
        (f"again and again {A}; {B} within 7", AskedProperty("asked", Form.AGAIN, f"{A}; {B}", seconds=7), None),
        (f"visit {A}; {B}", AskedProperty("asked", Form.VISIT, f"{A}; {B}"), None),
        (
            f"visit {A}; {B} in this order",
            AskedProperty("asked", Form.VISIT, f"{A}; {B}", order=VisitOrder.GIVEN),
            None,
        ),
        (
            f"visit {A}; {B} in turn within 8",
            AskedProperty("asked", Form.VISIT, f"{A}; {B}", seconds=8, order=VisitOrder.TURN),
            None,
        ),
    ],
)
def test_a_form_of_a_property_is_read_with_its_conditions_and_its_time(
    text: str, asked: AskedProperty, within: float | None
) -> None:
    found = read_property(text)
    assert (found.name, found.asked, found.within_s) == ("", asked, within)


def test_a_name_is_read_with_its_time() -> None:
    found = read_property(" delivered  within 120 ")
    assert (found.text, found.name, found.asked, found.within_s) == ("delivered within 120", "delivered", None, 120)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "there is no question"),
        ("  \n", "there is no question"),
        ("done within soon", "expected seconds behind within, found “soon”"),
        ("done within -1", "found “-1”"),
        ("done within 0", "found “0”"),
        ("done within nan", "found “nan”"),
        ("done within inf", "found “inf”"),
        (f"holds {A}", "expected `for` behind `holds`"),
        (f"holds {A} for 2 within 3", "`holds` has two times"),
        (f"after {A}", "expected `eventually` behind `after`"),
        (f"stays {A}", "expected `until` behind `stays`"),
        (f"{A} before", "expected a condition behind `before`, at character 15"),
        (f"after eventually {A}", "expected a condition before `eventually`, at character 7"),
        (f"at most 3 {A}", "expected `times` behind `at most`"),
        (f"at most many times {A}", "found “many” at character 9"),
        (f"at most 9999999 times {A}", "found “9999999” at character 9"),
        (f"again {A}", "expected `and again` behind `again`"),
        (f"visit {A}; ; {B}", "condition 2 of the list is empty"),
        (f"visit {A}; {B}; {A} in turn", "condition 3 of the list, “any a .B.C...”, is there already"),
        (f"visit {'; '.join(f'any a (B.C({n}))' for n in range(17))}", "at most 16 conditions in a list, found 17"),
        ("never " + "x" * 5000, "expected at most 2100 characters in a question, found 5006"),
    ],
)
def test_a_text_that_is_no_question_is_an_error_with_a_way_out(text: str, sentence: str) -> None:
    with pytest.raises(QuestionError, match=sentence) as raised:
        read_property(text)
    assert raised.value.help


@pytest.mark.parametrize(
    ("question", "holds"),
    [
        ("done", True),
        ("done within 1", False),
        ("time within 1", True),
        ("stuck", False),
        ("deadlock", True),
        ("counted", True),
        ("counted within 1.5", False),
        ("any ada (Count.EqualTo(1))", True),
        ("eventually any ada (Count.EqualTo(2)) within 1.5", False),
        ("eventually any count (Count.GreaterThan(2))", False),
        ("never any ada (Count.EqualTo(2))", False),
        ("never any ada (Count.EqualTo(2)) within 1.5", True),
        ("after any ada (Count.EqualTo(1)) eventually any ada (Count.EqualTo(2))", True),
        ("after any ada (Count.EqualTo(1)) eventually any ada (Count.EqualTo(2)) within 1.2", True),
        ("after any ada (Count.EqualTo(1)) eventually any ada (Count.EqualTo(2)) within 0.5", False),
        ("after any ada (Count.EqualTo(1)) eventually any ada (Count.EqualTo(7)) within 100", False),
        ("stays any ada (Count.EqualTo(1)) until any ada (Count.EqualTo(2))", True),
        ("eventually any ada (Count.EqualTo(7)) within 100", False),
        ("never any ada (Count.EqualTo(1)) while any ada (Count.GreaterThan(0))", False),
        ("holds any ada (Count.EqualTo(1)) for 0.9", True),
        ("holds any ada (Count.EqualTo(1)) for 1.5", False),
        ("at most 1 times any ada (Count.EqualTo(1))", True),
        ("at most 0 times any ada (Count.EqualTo(1))", False),
        ("any ada (Count.EqualTo(1)) before any ada (Count.EqualTo(2))", True),
        ("any ada (Count.EqualTo(2)) before any ada (Count.EqualTo(1))", False),
        ("again and again any ada (Count.EqualTo(1)); any ada (Count.EqualTo(2))", False),
        ("again and again any ada (Count.GreaterThan(1))", True),
        ("visit any ada (Count.EqualTo(2)); any ada (Count.EqualTo(1))", True),
        ("visit any ada (Count.EqualTo(1)); any ada (Count.EqualTo(2)) in this order", True),
        ("visit any ada (Count.EqualTo(2)); any ada (Count.EqualTo(1)) in this order", False),
        ("visit any ada (Count.EqualTo(1)); any ada (Count.EqualTo(2)) in turn within 1.5", False),
        ("stays any ada (Count.EqualTo(0)) until any ada (Count.EqualTo(2))", False),
    ],
)
def test_a_run_answers_what_a_person_reads_in_it(counter: OpenMission, question: str, holds: bool) -> None:
    assert answer(counter, question).holds is holds


def test_what_is_asked_is_said_in_a_sentence(counter: OpenMission) -> None:
    spec = counter.prepare(RunOptions(1, 30.0)).spec

    def words(question: str) -> str:
        return RunJudge(read_property(question), spec).words

    assert words("done within 5") == "a run ends with the outcome done, within 5 s"
    assert words("counted") == "eventually `any ada (Count.EqualTo(2))`"
    assert words("deadlock") == "the mission never comes to a standstill before it is done"


def test_a_run_that_is_decided_goes_no_further_and_says_when(counter: OpenMission) -> None:
    found = answer(counter, "any ada (Count.EqualTo(1))")
    assert (found.tick, found.sentence) == (51, "")
    assert answer(counter, "done").sentence.startswith("Done after 2.0")


def test_a_mission_that_brings_boxes_is_asked_for_its_ready_properties() -> None:
    opened = open_mission(Path("transport"))
    spec = opened.prepare(RunOptions(1, 100.0)).spec
    holding = [
        name
        for name in ("delivered within 59", "delivered within 60", "contact", "served-carrier-1", "end", "stock")
        if (found := RunJudge(read_property(name), spec).answer(1, lambda: False)) is not None and found.holds
    ]
    assert holding == ["delivered within 60", "contact", "served-carrier-1", "end", "stock"]


@pytest.mark.parametrize(
    ("question", "sentence", "help"),
    [
        ("deadlok", "this mission has no property deadlok", "did you mean deadlock?"),
        ("zzzzzz", "this mission has no property zzzzzz", "its properties are: done, failed, stuck, time, counted"),
        ("delivered", "this mission has no property delivered", "its properties are"),
        ("never any bob (Count.EqualTo(1))", "`bob` is no agent of this team", "it has: ada"),
        ("never any ada (Count.Equal(1))", "Equal", ""),
        ("never any ada (", "expected", ""),
        ("never Count.EqualTo(1)", "does not say whose it is", "write any"),
        ("never never", "", ""),
    ],
)
def test_a_question_that_the_mission_cannot_answer_is_an_error(
    counter: OpenMission, question: str, sentence: str, help: str
) -> None:
    with pytest.raises(KitRobotError) as raised:
        answer(counter, question)
    assert sentence in raised.value.message
    assert help in raised.value.help


def test_a_stopped_run_answers_nothing(counter: OpenMission) -> None:
    spec = counter.prepare(RunOptions(1, 30.0)).spec
    assert RunJudge(read_property("done"), spec).answer(1, lambda: True) is None
    assert RunJudge(read_property("any ada (Count.EqualTo(9))"), spec).answer(1, lambda: True) is None


def test_a_question_keeps_what_other_processes_need(counter: OpenMission) -> None:
    asked = read_property("after any a (B.C()) eventually any a (D.E()) within 5")
    assert pickle.loads(pickle.dumps(asked)) == asked
