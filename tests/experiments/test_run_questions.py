"""What is asked of a run: the forms of a question, and what runs answer."""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import pytest

from kitrobot import OpenMission, RunOptions
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.run_question import QuestionError, RunAnswer, RunJudge, read_question
from kitrobot.mission.property_forms import Form
from kitrobot.workspace.mission_loader import open_mission


def answer(opened: OpenMission, question: str, seed: int = 1, fail_rate: float = 0.0) -> RunAnswer:
    spec = opened.prepare(RunOptions(seed, 30.0, fail_rate)).spec
    found = RunJudge(read_question(question), spec).answer(seed, lambda: False)
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("text", "form", "conditions", "within"),
    [
        ("never any a (B.C())", Form.NEVER, ("any a (B.C())", ""), None),
        ("never any a (B.C()) within 12", Form.NEVER, ("any a (B.C())", ""), 12),
        ("eventually  any a\n(B.C()) within 1.5s", Form.EVENTUALLY, ("any a (B.C())", ""), 1.5),
        ("any a (B.C()) within 3 s", Form.EVENTUALLY, ("any a (B.C())", ""), 3),
        ("after any a (B.C()) eventually all b (C.D())", Form.AFTER, ("any a (B.C())", "all b (C.D())"), None),
        ("stays any a (B.C()) until any a (D.E()) within 9", Form.STAYS, ("any a (B.C())", "any a (D.E())"), 9),
    ],
)
def test_a_form_of_a_property_is_read_with_its_conditions_and_its_time(
    text: str, form: Form, conditions: tuple[str, str], within: float | None
) -> None:
    found = read_question(text)
    assert found.asked is not None
    assert (found.asked.form, found.asked.first, found.asked.second) == (form, *conditions)
    assert (found.name, found.within_s) == ("", within)


def test_a_name_is_read_with_its_time() -> None:
    found = read_question(" delivered  within 120 ")
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
        ("never " + "x" * 5000, "expected at most 2100 characters in a question, found 5006"),
    ],
)
def test_a_text_that_is_no_question_is_an_error_with_a_way_out(text: str, sentence: str) -> None:
    with pytest.raises(QuestionError, match=sentence) as raised:
        read_question(text)
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
        ("stays any ada (Count.EqualTo(0)) until any ada (Count.EqualTo(2))", False),
    ],
)
def test_a_run_answers_what_a_person_reads_in_it(counter: OpenMission, question: str, holds: bool) -> None:
    assert answer(counter, question).holds is holds


def test_what_is_asked_is_said_in_a_sentence(counter: OpenMission) -> None:
    spec = counter.prepare(RunOptions(1, 30.0)).spec

    def words(question: str) -> str:
        return RunJudge(read_question(question), spec).words

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
        if (found := RunJudge(read_question(name), spec).answer(1, lambda: False)) is not None and found.holds
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
    assert RunJudge(read_question("done"), spec).answer(1, lambda: True) is None
    assert RunJudge(read_question("any ada (Count.EqualTo(9))"), spec).answer(1, lambda: True) is None


def test_a_question_keeps_what_other_processes_need(counter: OpenMission) -> None:
    asked = read_question("after any a (B.C()) eventually any a (D.E()) within 5")
    assert pickle.loads(pickle.dumps(asked)) == asked
    assert asked.run_seconds is None
    assert read_question("done within 5").run_seconds == 5
    assert math.isclose(read_question("done within 2.50").run_seconds or 0, 2.5)
