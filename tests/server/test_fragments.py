"""Pasted text becomes a piece of a graph, or sentences about why not."""

from __future__ import annotations

import json

import pytest

URL = "/api/fragment"


def ask(page, text, robot="carrier", path="transport.krt"):
    return page.post(URL, json={"text": text, "robot": robot, "path": path})


@pytest.fixture(autouse=True)
def _transport(transport):
    """The mission whose robots the texts are for."""


def elements(answer):
    return [vertex["element"] for vertex in answer.json()["program"]["vertices"]]


def test_instructions_become_a_chain_from_start_to_stop(page):
    answer = ask(page, "*[Run.IsTrue()](Lamp.LightOn(););WAIT(5);")
    assert answer.status_code == 200
    assert elements(answer) == ["Start", "While", "Run.IsTrue", "Lamp.LightOn", "Wait", "Stop"]
    assert answer.json()["problems"] == []


def test_comments_come_along_as_notes(page):
    answer = ask(page, "# why\nWAIT(5);\n")
    assert answer.json()["program"]["vertices"][1]["notes"] == [{"text": "why", "at": ""}]


def test_a_condition_alone_hangs_on_nothing(page):
    answer = ask(page, "Sign.EqualTo(0) & Run.IsTrue()")
    assert sorted(elements(answer)) == ["And", "Run.IsTrue", "Sign.EqualTo"]
    assert {arc["at"] for arc in answer.json()["program"]["arcs"]} == {"left", "right"}


@pytest.mark.parametrize("text", ["hello world", "*[", "<kitrobot/>", "\x00\ud800", "();" * 10])
def test_rubbish_gives_problems_and_no_graph(page, text):
    body = json.dumps({"text": text, "robot": "carrier", "path": "transport.krt"})
    answer = page.post(URL, content=body, headers={"Content-Type": "application/json"})
    assert answer.status_code == 200
    assert answer.json()["program"] is None
    assert answer.json()["problems"]


def test_a_text_nested_ten_thousand_deep_is_told_and_not_read(page):
    answer = ask(page, "*[Run.IsTrue()](" * 10_000 + ");" * 10_000)
    assert answer.status_code == 200
    assert answer.json()["program"] is None
    assert answer.json()["problems"]


def test_more_than_a_program_can_hold_is_refused_with_a_sentence(page):
    answer = ask(page, "#" * 1_000_001)
    assert answer.status_code == 422
    assert answer.json()["message"]


def test_an_unknown_robot_is_refused_with_a_sentence(page):
    answer = ask(page, "WAIT(1);", robot="nobody")
    assert 400 <= answer.status_code < 500
    assert "nobody" in answer.json()["message"]


def test_a_stranger_is_refused(stranger):
    assert ask(stranger, "WAIT(1);").status_code in (401, 403)


TREE = """<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
<RetryUntilSuccessful num_attempts="-1"><Condition ID="Sign.EqualTo" value="3"/></RetryUntilSuccessful>
<Action ID="Lamp.LightOn"/>{more}
</Sequence></BehaviorTree></root>"""


def test_a_behaviour_tree_becomes_a_graph(page):
    answer = ask(page, TREE.format(more=""))
    assert answer.json()["problems"] == []
    assert elements(answer) == ["Start", "Wait Until", "Sign.EqualTo", "Lamp.LightOn", "Stop"]


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ('<Action ID="Lamp.Explode"/>', "Explode"),
        ("<Action", ""),
        ('<include path="other.xml"/>', "include"),
        ("<Sequence>" * 100 + "</Sequence>" * 100, ""),
    ],
)
def test_a_tree_that_is_no_program_gives_its_problems_with_their_lines_and_no_graph(page, more, said):
    answer = ask(page, TREE.format(more="\n" + more))
    assert answer.status_code == 200
    assert answer.json()["program"] is None
    [problem, *_] = answer.json()["problems"]
    assert said in problem["message"]
    assert problem["line"] >= 1
