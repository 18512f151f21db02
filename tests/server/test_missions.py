"""Missions over the wire: opened, checked, saved, and nothing outside the folder."""

from __future__ import annotations

import json
import os

import pytest

from tests.server.conftest import SHORT


def opened(page, path="blink.krt"):
    answer = page.get("/api/mission", params={"path": path})
    assert answer.status_code == 200, answer.text
    return answer.json()


def test_the_session_names_the_mission_and_the_folder_but_not_where_it_is(page, folder):
    session = page.get("/api/session").json()
    assert session["path"] == "blink.krt"
    assert session["workspace"] == "missions"
    assert str(folder.parent) not in page.get("/api/session").text


def test_missions_are_listed_with_the_examples_after_them(page, folder):
    (folder / "sub").mkdir()
    (folder / "sub" / "line-follower_two.krt").write_text(SHORT)
    (folder / ".hidden.krt").write_text(SHORT)
    (folder / "note.txt").write_text("no mission")
    listed = page.get("/api/missions").json()
    own = [entry for entry in listed if not entry["example"]]
    assert [entry["path"] for entry in own] == ["blink.krt", "sub/line-follower_two.krt"]
    assert own[1]["title"] == "Line follower two"
    assert own[0]["modified"].endswith("+00:00")
    examples = [entry for entry in listed if entry["example"]]
    assert examples[-1]["path"] == "example:transport-team/transport-team.krt"  # the easiest first
    assert all(entry["label"]["fr"] and entry["help"]["ur"] for entry in examples)
    transport = next(entry for entry in examples if entry["path"] == "example:transport/transport.krt")
    assert transport["title"] == transport["label"][""] == "Transport as a team"
    assert own[0]["label"] == {}


def test_a_mission_opens_with_its_world_and_catalogue(page):
    file = opened(page)
    assert file["name"] == "blink.krt"
    assert file["mission"]["programs"][0]["vertices"][2]["settings"] == {"duration": "2"}
    assert file["mission"]["agents"] == [{"name": "robot-1", "program": "blink", "start": "", "robot": ""}]
    assert file["world"]["name"] == "empty"
    assert file["problems"] == []
    assert "mini-robot" in [robot["name"] for robot in file["catalogue"]["robots"]]


def test_what_only_a_page_needs_of_a_catalogue_is_not_made_for_a_list(page, monkeypatch):
    made = []
    monkeypatch.setattr("kitrobot.live.studio.catalogue_shape", lambda catalogue: made.append(catalogue))
    assert page.get("/api/missions").status_code == 200
    assert made == []


def test_the_example_opens_and_is_free_of_errors(page):
    file = opened(page, "example:transport/transport.krt")
    assert file["problems"] == []
    report = page.post("/api/check", json={"mission": file["mission"], "path": file["path"]}).json()
    assert [problem for problem in report["problems"] if problem["severity"] == "error"] == []


@pytest.mark.parametrize("stock", ["x", "", "-1", "65536", "1.5", "٣", "9" * 5000])
def test_a_goal_that_asks_for_no_number_of_boxes_is_told_in_a_sentence(page, stock):
    file = opened(page, "example:transport/transport.krt")
    file["mission"]["goals"][0]["stock"] = stock
    answer = page.post("/api/check", json={"mission": file["mission"], "path": file["path"]})
    assert answer.status_code == 422
    assert 'expected a whole number from 0 to 65535 or "all" in stock, found' in answer.json()["message"]
    assert "goals.0" in answer.json()["message"]


def test_a_new_mission_is_start_and_stop_and_can_run(page):
    file = page.get("/api/mission/new").json()
    assert (file["path"], file["revision"]) == ("", "")
    program = file["mission"]["programs"][0]
    assert [vertex["element"] for vertex in program["vertices"]] == ["Start", "Stop"]
    assert page.post("/api/check", json={"mission": file["mission"], "path": ""}).json()["problems"] == []


def test_the_bytes_of_a_file_open_without_a_path(page):
    file = page.post("/api/mission/read", params={"name": "mine.krt"}, content=SHORT.encode()).json()
    assert (file["path"], file["name"], file["revision"]) == ("", "mine.krt", "")


@pytest.mark.parametrize("kind", ["application/json", "text/plain", "application/octet-stream", None])
def test_what_a_page_calls_the_bytes_does_not_matter(page, kind):
    headers = {"Content-Type": kind} if kind else {}
    assert page.post("/api/mission/read", content=SHORT.encode(), headers=headers).status_code == 200


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\xff\xfe\x00junk",
        b"<kitrobot",
        b"<robot/>",
        b'<!DOCTYPE x [<!ENTITY a "b">]><kitrobot version="1"/>',
        b"<kitrobot version='1'>" + b"<a>" * 10_000,
        SHORT.encode()[:200],
    ],
)
def test_a_damaged_file_is_refused_with_its_problems(page, data):
    answer = page.post("/api/mission/read", content=data)
    assert answer.status_code == 422
    failure = answer.json()
    assert failure["message"]
    assert failure["problems"][0]["severity"] == "error"
    assert failure["problems"][0]["line"] >= 1


NO_MISSIONS = [
    b"<html><body>hello</body></html>",
    b'<robot name="r" version="1"/>',
    b'<kitrobot version="1"/>',
    b'<kitrobot version="1"><later/></kitrobot>',
    b'<kitrobot version="1"><team><agent name="a" program="p"/></team></kitrobot>',
    b'<kitrobot version="1"><program/></kitrobot>',
    b'<world version="1" name="w" width="100" height="100"/>',
    b"\xff\xd8\xff\xe0 a photo",
]


@pytest.mark.parametrize("data", NO_MISSIONS)
def test_a_file_that_gives_no_program_is_refused_with_a_sentence(page, folder, data):
    (folder / "odd.krt").write_bytes(data)
    for answer in (
        page.get("/api/mission", params={"path": "odd.krt"}),
        page.post("/api/mission/read", params={"name": "odd.krt"}, content=data),
    ):
        assert answer.status_code == 422
        assert "odd.krt" in answer.json()["message"]
        assert answer.json()["help"] or answer.json()["problems"]


def test_saving_writes_what_was_sent_and_gives_the_new_revision(page, folder):
    file = opened(page)
    file["mission"]["programs"][0]["vertices"][2]["settings"]["duration"] = "7"
    sent = {"path": "blink.krt", "revision": file["revision"], "mission": file["mission"]}
    saved = page.put("/api/mission", json=sent)
    assert saved.status_code == 200
    assert '<set name="duration">7</set>' in (folder / "blink.krt").read_text()
    assert opened(page)["revision"] == saved.json()["revision"] != file["revision"]


def test_what_is_opened_and_saved_unchanged_stays_as_it_was(page, folder):
    file = opened(page)
    sent = {"path": "blink.krt", "revision": file["revision"], "mission": file["mission"]}
    assert page.put("/api/mission", json=sent).json()["revision"] == file["revision"]
    assert (folder / "blink.krt").read_text() == SHORT


def test_xml_that_nobody_knows_survives_the_page(page, folder):
    text = SHORT.replace(
        '<vertex id="v1" element="Light.LightOn"/>', '<vertex id="v1" element="Light.LightOn"><x/></vertex>'
    )
    text = text.replace("</kitrobot>", '  <later a="1"/>\n</kitrobot>')
    (folder / "later.krt").write_text(text)
    file = opened(page, "later.krt")
    page.put("/api/mission", json={"path": "later.krt", "revision": file["revision"], "mission": file["mission"]})
    assert (folder / "later.krt").read_text() == text


def test_a_file_that_changed_meanwhile_is_not_overwritten(page, folder):
    file = opened(page)
    changed = SHORT.replace(">2<", ">9<")
    (folder / "blink.krt").write_text(changed)
    sent = {"path": "blink.krt", "revision": file["revision"], "mission": file["mission"]}
    answer = page.put("/api/mission", json=sent)
    assert answer.status_code == 409
    assert (folder / "blink.krt").read_text() == changed
    sent["revision"] = answer.json()["revision"]
    assert page.put("/api/mission", json=sent).status_code == 200


def test_a_file_that_was_removed_meanwhile_is_said(page, folder):
    file = opened(page)
    (folder / "blink.krt").unlink()
    sent = {"path": "blink.krt", "revision": file["revision"], "mission": file["mission"]}
    answer = page.put("/api/mission", json=sent)
    assert (answer.status_code, answer.json()["revision"]) == (409, "")


def test_a_new_file_does_not_overwrite_one_that_is_there(page):
    file = opened(page)
    answer = page.put("/api/mission", json={"path": "blink.krt", "revision": "", "mission": file["mission"]})
    assert answer.status_code == 409
    assert answer.json()["revision"] == file["revision"]


def test_a_new_file_is_made(page, folder):
    mission = opened(page)["mission"]
    assert page.put("/api/mission", json={"path": "neu.krt", "revision": "", "mission": mission}).status_code == 200
    assert (folder / "neu.krt").is_file()


def test_a_file_in_a_folder_that_is_not_there_is_refused_with_a_sentence(page):
    mission = opened(page)["mission"]
    answer = page.put("/api/mission", json={"path": "no/such.krt", "revision": "", "mission": mission})
    assert answer.status_code == 422
    assert "cannot be saved" in answer.json()["message"]


def test_an_example_is_not_written_to(page):
    file = opened(page, "example:transport/transport.krt")
    answer = page.put(
        "/api/mission", json={"path": file["path"], "revision": file["revision"], "mission": file["mission"]}
    )
    assert answer.status_code == 403
    assert "your own" in answer.json()["help"]


def test_a_mission_that_is_not_there_is_404(page):
    answer = page.get("/api/mission", params={"path": "blimk.krt"})
    assert answer.status_code == 404
    assert "blink.krt" in answer.json()["help"]


def test_a_check_gives_the_text_and_the_spans_of_each_program(page):
    report = page.post("/api/check", json={"mission": opened(page)["mission"], "path": "blink.krt"}).json()
    program = report["programs"][0]
    assert program["lll"] == "Light.LightOn();\nWAIT(2);\n"
    assert program["spans"] == [
        {"vertex": "v1", "start": 0, "end": 15, "line": 1},
        {"vertex": "v2", "start": 17, "end": 24, "line": 2},
    ]
    assert program["instructions"] > 0
    assert report["problems"] == []


def test_a_mistake_names_its_program_and_vertex_and_the_others_still_get_their_text(page):
    mission = opened(page)["mission"]
    mission["programs"].append({**mission["programs"][0], "name": "other"})
    mission["programs"][0] = {
        **mission["programs"][0],
        "vertices": [
            {**vertex, "element": "Light.Glow"} if vertex["id"] == "v1" else vertex
            for vertex in mission["programs"][0]["vertices"]
        ],
    }
    report = page.post("/api/check", json={"mission": mission, "path": "blink.krt"}).json()
    errors = [problem for problem in report["problems"] if problem["severity"] == "error"]
    assert {(problem["program"], *problem["vertices"]) for problem in errors} == {("blink", "v1")}
    assert report["programs"][1]["lll"]


def test_problems_between_the_parts_of_a_mission_are_told(page):
    mission = opened(page)["mission"]
    mission["agents"] = [
        {"name": "a", "program": "blink", "start": "nowhere"},
        {"name": "a", "program": "blink", "start": "robot-1"},
        {"name": "b", "program": "none", "start": "robot-1"},
    ]
    mission["goals"] = [{"storehouse": "Z", "stock": "all"}]
    mission["programs"][0]["robot"] = "mini-robo"
    codes = {
        problem["code"] for problem in page.post("/api/check", json={"mission": mission, "path": ""}).json()["problems"]
    }
    assert codes >= {
        "mission-no-robot",
        "mission-same-name",
        "mission-no-start",
        "mission-no-program",
        "mission-no-storehouse",
    }


@pytest.mark.parametrize("href", ["nowhere.world.xml", "../../etc/passwd", "/etc/passwd", "..\\x.world.xml"])
def test_a_world_that_is_not_there_is_a_problem_and_the_rest_is_still_looked_at(page, href):
    mission = {**opened(page)["mission"], "world": href}
    report = page.post("/api/check", json={"mission": mission, "path": ""}).json()
    assert [problem["code"] for problem in report["problems"]] == ["mission-no-world"]
    assert report["programs"][0]["lll"]


def test_a_world_that_a_link_fetches_from_outside_is_not_read(page, folder):
    outside = folder.parent / "outside.world.xml"
    outside.write_text('<world version="1" name="outside" width="9" height="9"/>')
    os.symlink(outside, folder / "in.world.xml")
    mission = {**opened(page)["mission"], "world": "in.world.xml"}
    report = page.post("/api/check", json={"mission": mission, "path": ""}).json()
    assert "mission-no-world" in [problem["code"] for problem in report["problems"]]


def test_a_robot_dropped_into_the_folder_is_there_at_once_and_gone_when_removed(page, folder):
    assert "my-robot" not in [robot["name"] for robot in opened(page)["catalogue"]["robots"]]
    (folder / "my.robot.xml").write_text('<robot name="my-robot" version="1"/>')
    assert "my-robot" in [robot["name"] for robot in opened(page)["catalogue"]["robots"]]
    (folder / "my.robot.xml").unlink()
    assert "my-robot" not in [robot["name"] for robot in opened(page)["catalogue"]["robots"]]


def test_a_bad_robot_file_is_told_and_stands_in_nobodys_way(page, folder):
    (folder / "bad.robot.xml").write_text("<robot")
    file = opened(page)
    assert [problem["severity"] for problem in file["catalogue"]["problems"]] == ["error"]
    report = page.post("/api/check", json={"mission": file["mission"], "path": "blink.krt"}).json()
    assert report["problems"] == []


def test_the_text_of_a_mission_is_canonical(page):
    assert page.post("/api/mission/text", json={"mission": opened(page)["mission"]}).json() == {"text": SHORT}


@pytest.mark.parametrize(
    "body", [b"", b"null", b"[]", b"{}", b"{", b'{"mission":{},"path":""}', b"\xff", b'{"mission":1,"path":2}']
)
def test_a_request_that_is_not_understood_is_a_sentence(page, body):
    answer = page.post("/api/check", content=body, headers={"Content-Type": "application/json"})
    assert answer.status_code in (400, 422)
    assert answer.json()["message"].endswith(".")


def test_a_request_that_is_cut_off_is_refused(page):
    sent = page.build_request("POST", "/api/check", json={"mission": opened(page)["mission"], "path": ""}).content
    for end in (1, len(sent) // 2, len(sent) - 1):
        answer = page.post("/api/check", content=sent[:end], headers={"Content-Type": "application/json"})
        assert answer.status_code == 422
        assert answer.json()["message"]


def test_a_request_nested_deeply_is_a_sentence(page):
    answer = page.post("/api/check", content=b"[" * 100_000, headers={"Content-Type": "application/json"})
    assert answer.status_code == 422
    assert answer.json()["message"].endswith(".")


def test_what_is_not_there_is_said_in_json_under_api_and_on_a_page_elsewhere(page):
    assert page.get("/api/nothing").json()["message"]
    assert "<h1>" in page.get("/nothing").text
    assert page.delete("/api/mission").status_code == 405


@pytest.mark.parametrize("text", ["\\ud800", "\\u0000", "a\\u0001b", "\\ufffe", "x\\udc00y"])
@pytest.mark.parametrize("field", ["element", "id"])
def test_characters_that_no_file_can_hold_are_no_mistake_of_ours(page, folder, text, field):
    mission = opened(page)["mission"]
    mission["programs"][0]["vertices"][1][field] = "@@"
    body = json.dumps({"mission": mission, "path": "x.krt", "revision": ""}).replace("@@", text)
    for method, address in (("POST", "/api/check"), ("POST", "/api/mission/text"), ("PUT", "/api/mission")):
        assert (
            page.request(method, address, content=body, headers={"Content-Type": "application/json"}).status_code == 200
        )
    assert page.get("/api/mission", params={"path": "x.krt"}).status_code == 200


def test_what_would_not_open_again_is_not_saved(page, folder):
    file = opened(page)
    file["mission"]["programs"][0]["vertices"][1]["unknown"] = "<a>" * 70 + "</a>" * 70
    sent = {"path": "blink.krt", "revision": file["revision"], "mission": file["mission"]}
    assert page.put("/api/mission", json=sent).status_code == 422
    assert (folder / "blink.krt").read_text() == SHORT


@pytest.mark.parametrize("unknown", ["</vertex><", "<", "<a>", "&nothing;", "<!DOCTYPE x>"])
def test_what_is_no_xml_is_saved_in_a_comment(page, folder, unknown):
    file = opened(page)
    file["mission"]["programs"][0]["vertices"][1]["unknown"] = unknown
    sent = {"path": "blink.krt", "revision": file["revision"], "mission": file["mission"]}
    assert page.put("/api/mission", json=sent).status_code == 200
    assert f"<!-- {unknown} -->" in (folder / "blink.krt").read_text()
    assert opened(page)["mission"]["programs"][0]["vertices"][1]["unknown"] == f"<!-- {unknown} -->"
