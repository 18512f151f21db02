"""A selection becomes a part, a part is edited, parts are shared; rubbish gives sentences."""

from __future__ import annotations

import copy
import json
from typing import Any

import pytest

from kitrobot.primitives.constructors_xml import read_constructors


@pytest.fixture
def mission(transport, page):
    return page.get("/api/mission", params={"path": "transport.krt"}).json()["mission"]


@pytest.fixture
def loop(mission):
    """The first loop of the first program and what stands in it."""
    program = mission["programs"][0]
    return next(one["id"] for one in program["vertices"] if one["element"] in ("While", "Forever", "Repetition"))


def body(mission, vertices, **more):
    return {
        "mission": mission,
        "path": "transport.krt",
        "program": mission["programs"][0]["name"],
        "vertices": vertices,
        **more,
    }


def test_a_loop_becomes_a_part_and_means_the_same(page, mission, loop):
    offered = page.post("/api/part/offer", json=body(mission, [loop])).json()["offered"]
    assert offered["vertices"] == [loop]
    assert offered["problems"] == []
    numbers = [one for one in offered["offers"] if one["kind"] in ("value", "number") and one["value"]]
    chosen = [{"vertex": one["vertex"], "slot": one["slot"], "name": one["name"]} for one in numbers]
    made = page.post("/api/part", json=body(mission, [loop], name="Trip", colour="loop", chosen=chosen)).json()["part"]
    assert made["constructor"]["name"] == "Trip"
    assert made["constructor"]["group"] == "Own"
    after = copy.deepcopy(mission)
    after["constructors"] = [made["constructor"]]
    after["programs"][0] = made["program"]
    assert [one["element"] for one in made["program"]["vertices"]].count("Trip") == 1
    lll = [
        "\n".join(line.split("#")[0].strip() for line in one.splitlines())
        for one in (
            page.post("/api/check", json={"mission": which, "path": "transport.krt"}).json()["programs"][0]["lll"]
            for which in (mission, after)
        )
    ]
    assert "".join(lll[0].split()) == "".join(lll[1].split())
    again = page.post("/api/part", json=body(after, [made["vertex"]], name="Trip", chosen=[]))
    assert again.json()["part"] is None
    assert "already" in again.json()["refused"]["message"]


@pytest.mark.parametrize("vertices", [[], ["nobody"], ["start"], [""] * 3])
def test_a_selection_that_is_none_is_told(page, mission, vertices):
    for url, more in (("/api/part/offer", {}), ("/api/part", {"name": "X", "chosen": []})):
        answer = page.post(
            url,
            content=json.dumps(body(mission, vertices, **more)),
            headers={"Content-Type": "application/json"},
        )
        assert answer.status_code == 200
        assert answer.json()["refused"]["message"]
        assert answer.json()["refused"]["help"]


@pytest.mark.parametrize(
    "more",
    [
        {"name": "", "chosen": []},
        {"name": "Start", "chosen": []},
        {"name": "a.b", "chosen": []},
        {"name": "While", "chosen": []},
        {"name": "X" * 100_000, "chosen": [{"vertex": "nobody", "slot": "n", "name": "n"}]},
        {"name": "X", "icon": "<svg>", "chosen": []},
        {"name": "X", "colour": "pink", "chosen": []},
        {"name": "X", "chosen": [{"vertex": "nobody", "slot": "", "name": "n"}]},
        {"name": "X", "chosen": "all"},
    ],
)
def test_a_wish_that_cannot_be_is_told(page, mission, loop, more):
    answer = page.post("/api/part", json=body(mission, [loop], **more)).json()
    assert answer.get("refused", answer)["message"]


def test_a_program_that_is_not_there_is_told(page, mission, loop):
    answer = page.post("/api/part/offer", json={**body(mission, [loop]), "program": "nobody"})
    assert answer.status_code == 422
    assert "no program `nobody`" in answer.json()["message"]


OWN: dict[str, Any] = {
    "name": "Own",
    "group": "",
    "icon": "",
    "colour": "action",
    "label": {},
    "help": {},
    "slots": [],
    "role": "instruction",
    "adds": None,
    "code": "",
}


def read(page, mission, code, **more):
    wanted = {"mission": mission, "path": "transport.krt", "robot": mission["programs"][0]["robot"]}
    return page.post("/api/part/read", json={**wanted, "constructor": {**OWN, "code": code, **more}})


def test_an_edited_text_gets_its_slots_and_its_drawing(page, mission):
    answer = read(page, mission, "{n}*({body}; WAIT({pause});)").json()
    assert answer["problems"] == []
    assert [one["name"] for one in answer["constructor"]["slots"]] == ["n", "body", "pause"]
    assert answer["lll"] == "{n}*(\n  {body};\n  WAIT({pause});\n);\n"
    assert [one["element"] for one in answer["drawing"]["vertices"]] == [
        "Start",
        "Repetition",
        "{body}",
        "Wait",
        "Stop",
    ]


@pytest.mark.parametrize("code", ["", "{", "*[", "\x00", "();" * 50, "WAIT(1);" * 1300, "(" * 5000, "{a}"])
def test_rubbish_gives_problems_and_no_part(page, mission, code):
    answer = read(page, mission, code)
    assert answer.status_code == 200
    assert answer.json()["constructor"] is None
    assert answer.json()["problems"]


def test_a_text_without_end_is_refused(page, mission):
    answer = read(page, mission, "WAIT(1);" * 10_000)
    assert answer.status_code == 422
    assert "at most" in answer.json()["message"]


def test_parts_are_shared_as_a_file_of_constructors(page, mission):
    made = read(page, mission, "{n}*( {body}; );").json()["constructor"]
    text = page.post("/api/part/file", json={"constructors": [made]}).json()["text"]
    groups, problems = read_constructors(text.encode(), "mine.constructors.xml")
    assert problems == []
    assert [(group.name, [one.name for one in group.constructors]) for group in groups] == [("Own", ["Own"])]
