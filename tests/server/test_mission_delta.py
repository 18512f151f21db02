"""An edit sends only what changed: the answer is that of the whole mission, and a studio that forgot says so."""

from __future__ import annotations

import copy
import random
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kitrobot.server.app import create_app
from kitrobot.wire.mission import MOST_VERTICES
from kitrobot.workspace.compile_cache import MOST_NAMED, MOST_STATES, CompileCache
from tests.effort import examples
from tests.server.conftest import HOST, TOKEN, TestClient, whole, whole_report

Mission = dict[str, Any]
PATH = "blink.krt"
KNOWN: dict[str, Mission] = {}
"""Programs of reports by the names that they were given."""


@pytest.fixture
def mission(page: TestClient) -> Mission:
    """The mission of the workspace: `Light.LightOn(); WAIT(2);`."""
    opened: Mission = page.get("/api/mission", params={"path": PATH}).json()["mission"]
    return opened


def check(page: TestClient, mission: Mission) -> Mission:
    answer = page.post("/api/check", json={"mission": mission, "path": PATH})
    assert answer.status_code == 200, answer.text
    return whole_report(answer.json(), KNOWN)


def name_in(report: Mission) -> str:
    name: str = report["programs"][0]["known"]
    assert name
    return name


def rows(mission: Mission, of: str, vertices: list[Any], arcs: list[Any] | None = None) -> Mission:
    """The mission with its program as rows of the one that is known as `of`."""
    program = mission["programs"][0]
    all_arcs = [[0, len(program["arcs"])]] if arcs is None else arcs
    sent = {"name": program["name"], "robot": program["robot"], "of": of, "vertices": vertices, "arcs": all_arcs}
    return mission | {"programs": [sent]}


def said(report: Mission) -> Mission:
    """A report without the name that it gives."""
    found = copy.deepcopy(report)
    for program in found["programs"]:
        del program["known"]
    return found


def waiting(mission: Mission, duration: str) -> Mission:
    """The mission with another duration, whole; its vertices are start, v1, v2 and stop."""
    found = copy.deepcopy(mission)
    found["programs"][0]["vertices"][2]["settings"] = {"duration": duration}
    return found


def test_what_changed_is_answered_like_the_whole(page: TestClient, mission: Mission) -> None:
    name = name_in(check(page, mission))
    after = waiting(mission, "7")
    sent = rows(mission, name, [[0, 2], after["programs"][0]["vertices"][2], [3, 4]])
    report = check(page, sent)
    assert "WAIT(7);" in report["programs"][0]["lll"]
    assert said(report) == said(check(page, after))
    assert name_in(report) != name


def test_a_program_that_stayed_keeps_its_name(page: TestClient, mission: Mission) -> None:
    first = check(page, mission)
    assert check(page, rows(mission, name_in(first), [[0, 4]])) == first


def test_vertices_and_arcs_move_come_and_go(page: TestClient, mission: Mission) -> None:
    name = name_in(check(page, mission))
    program = mission["programs"][0]
    # Without v1: start leads to v2.
    arc = program["arcs"][0] | {"target": "v2"}
    sent = rows(mission, name, [[0, 1], [2, 4]], [arc, [2, 3]])
    assert check(page, sent)["programs"][0]["lll"].strip() == "WAIT(2);"
    turned = rows(mission, name, [[3, 4], [0, 3]])
    assert check(page, turned)["programs"][0]["lll"] == check(page, mission)["programs"][0]["lll"]


def test_a_renamed_program_is_sent_as_what_it_was(page: TestClient, mission: Mission) -> None:
    sent = rows(mission, name_in(check(page, mission)), [[0, 4]])
    sent["programs"][0]["name"] = "anew"
    sent["agents"] = [agent | {"program": "anew"} for agent in mission["agents"]]
    report = check(page, sent)
    assert report["programs"][0]["name"] == "anew"
    assert report["problems"] == []


def test_what_is_known_is_not_changed_by_an_edit_of_it(page: TestClient, mission: Mission) -> None:
    first = check(page, mission)
    new = waiting(mission, "much")["programs"][0]["vertices"][2]
    assert check(page, rows(mission, name_in(first), [[0, 2], new, [3, 4]]))["problems"]
    assert check(page, rows(mission, name_in(first), [[0, 4]])) == first


def test_a_text_is_typed_over_a_program_that_is_only_named(page: TestClient, mission: Mission) -> None:
    name = name_in(check(page, mission))
    wanted = {"mission": rows(mission, name, [[0, 4]]), "path": PATH, "program": "blink"}
    answer = page.post("/api/text", json=wanted | {"text": "Light.LightOn();\nWAIT(8);"}).json()
    stayed = [row for row in answer["program"]["vertices"] if isinstance(row, list)]
    assert stayed == [[0, 2], [3, 4]]
    drawn = whole(mission["programs"][0], answer["program"])
    assert drawn == waiting(mission, "8")["programs"][0]
    assert said(whole_report(answer["report"], KNOWN)) == said(check(page, mission | {"programs": [drawn]}))
    # The next key starts from the program that was drawn.
    after = rows(mission, name_in(answer["report"]), [[0, 4]])
    again = page.post("/api/text", json=wanted | {"mission": after, "text": "Light.LightOn();\nWAIT(89);"}).json()
    assert whole(drawn, again["program"]) == waiting(mission, "89")["programs"][0]


def test_a_name_that_is_not_known_is_gone(page: TestClient, mission: Mission) -> None:
    sent = rows(mission, "nobody-1", [[0, 4]])
    for address, more in (("check", {}), ("text", {"program": "blink", "text": ""})):
        answer = page.post(f"/api/{address}", json={"mission": sent, "path": PATH} | more)
        assert answer.status_code == 410
        assert "does not know the program `blink`" in answer.json()["message"]


def test_a_studio_that_was_started_anew_knows_no_name_of_the_one_before(
    page: TestClient, mission: Mission, folder: Path
) -> None:
    name = name_in(check(page, mission))
    anew = TestClient(create_app(folder, None, TOKEN), base_url=HOST, headers={"X-KitRobot-Token": TOKEN})
    assert name_in(check(anew, mission)) != name
    sent = {"mission": rows(mission, name, [[0, 4]]), "path": PATH}
    assert anew.post("/api/check", json=sent).status_code == 410


def test_two_windows_that_edit_the_same_program_are_each_answered_for_their_own(
    page: TestClient, mission: Mission
) -> None:
    names = [name_in(check(page, mission))] * 2
    for turn in range(2 * MOST_STATES):
        for window in range(2):
            duration = str(10 * turn + window)
            new = waiting(mission, duration)["programs"][0]["vertices"][2]
            report = check(page, rows(mission, names[window], [[0, 2], new, [3, 4]]))
            assert f"WAIT({duration});" in report["programs"][0]["lll"]
            names[window] = name_in(report)


def test_a_window_that_was_left_alone_goes_on_while_another_edits(page: TestClient, mission: Mission) -> None:
    name = name_in(check(page, mission))
    for number in range(2 * MOST_STATES):
        check(page, waiting(mission, str(number)))
    assert "WAIT(2);" in check(page, rows(mission, name, [[0, 4]]))["programs"][0]["lll"]


def test_names_are_forgotten_at_last_the_oldest_first(page: TestClient, mission: Mission) -> None:
    page.app.state.studio.programs = CompileCache(most_vertices=4)  # type: ignore[attr-defined]
    names = [name_in(check(page, waiting(mission, str(number)))) for number in range(MOST_NAMED + 1)]
    wanted = [{"mission": rows(mission, name, [[0, 4]]), "path": PATH} for name in reversed(names)]
    assert [page.post("/api/check", json=one).status_code for one in wanted[-2:]] == [200, 410]


@pytest.mark.parametrize(
    ("vertices", "sentence"),
    [
        ([[0, 5]], "A list of 4 has no stretch from 0 to 5"),
        ([[3, 2]], "no stretch from 3 to 2"),
        ([[1, 1]], "no stretch from 1 to 1"),
        ([[-1, 2]], "not understood"),
        ([[0, 1, 2]], "not understood"),
        ([[0]], "not understood"),
        ([["0", "x"]], "not understood"),
        ([7], "not understood"),
        ([{"id": "v9"}], "not understood"),
        ([[0, 4]] * (MOST_VERTICES // 4 + 1), f"more than {MOST_VERTICES}"),
        ([[0, 1]] * (MOST_VERTICES + 1), "not understood"),
    ],
)
def test_rows_that_make_no_sense_are_refused_with_a_sentence(
    page: TestClient, mission: Mission, vertices: list[Any], sentence: str
) -> None:
    sent = rows(mission, name_in(check(page, mission)), vertices)
    answer = page.post("/api/check", json={"mission": sent, "path": PATH})
    assert answer.status_code == 422
    assert sentence in answer.json()["message"]


def test_stretches_of_nothing_are_refused(page: TestClient, mission: Mission) -> None:
    answer = page.post("/api/check", json={"mission": rows(mission, "", [[0, 4]]), "path": PATH})
    assert answer.status_code == 422
    assert "A list of 0 has no stretch" in answer.json()["message"]


def test_a_request_that_is_cut_off_is_refused(page: TestClient, mission: Mission) -> None:
    sent = page.build_request("POST", "/api/check", json={"mission": rows(mission, "", []), "path": PATH}).content
    for end in (0, 1, len(sent) // 2, len(sent) - 1):
        answer = page.post("/api/check", content=sent[:end], headers={"content-type": "application/json"})
        assert answer.status_code == 422
        assert answer.json()["message"]


def test_a_program_that_is_too_large_for_what_is_kept_has_no_name(page: TestClient, mission: Mission) -> None:
    page.app.state.studio.programs = CompileCache(most_vertices=0)  # type: ignore[attr-defined]
    assert check(page, mission)["programs"][0]["known"] == ""


def test_a_program_whose_robot_is_not_at_hand_has_no_name(page: TestClient, mission: Mission) -> None:
    mission["programs"][0]["robot"] = "nobody"
    assert check(page, mission)["programs"][0]["known"] == ""


@settings(max_examples=examples(15), deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.randoms(use_true_random=True))
def test_what_is_told_by_what_is_different_is_the_whole(
    page: TestClient, mission: Mission, folder: Path, rng: random.Random
) -> None:
    report = check(page, mission)
    text = report["programs"][0]["lll"]
    for _ in range(6):
        lines = text.splitlines(keepends=True)
        at = rng.randrange(len(lines) + 1)
        lines[at : at + rng.randrange(2)] = rng.choice(
            [
                ["WAIT(7);\n"],
                ["2*(\n", "  WAIT(1);\n", "  Light.LightOn();\n", ");\n"],
                ["# é🙂\n", "Light.LightOff();\n"],
                [],
            ]
        )
        text = "".join(lines)
        sent = rows(mission, name_in(report), [[0, len(mission["programs"][0]["vertices"])]])
        wanted = {"mission": sent, "path": PATH, "program": "blink", "text": text}
        answer = page.post("/api/text", json=wanted).json()
        if answer["program"] is None:
            text = report["programs"][0]["lll"]
            continue
        report = whole_report(answer["report"], KNOWN)
        mission = mission | {"programs": [whole(mission["programs"][0], answer["program"])]}
        fresh = TestClient(create_app(folder, None, TOKEN), base_url=HOST, headers={"X-KitRobot-Token": TOKEN})
        assert said(report) == said(check(fresh, mission))
        text = report["programs"][0]["lll"]
