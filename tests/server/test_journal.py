"""The journal over the wire: kept while a page is open, free when it is gone, and news of the disk."""

from __future__ import annotations

import copy

import pytest
from starlette.websockets import WebSocketDisconnect

from tests.server.conftest import SHORT, SOCKET, TOKEN
from tests.server.test_missions import opened

WATCH = f"{SOCKET}/api/watch?token={TOKEN}"


@pytest.fixture(autouse=True)
def state(tmp_path, monkeypatch):
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))


def claim(page, tab, path="blink.krt", journal=""):
    return page.post("/api/journal/claim", json={"tab": tab, "path": path, "journal": journal})


def whole(page, tab, *records, path="blink.krt", unsaved=True):
    sent = {"tab": tab, "path": path, "name": "blink.krt", "records": records, "unsaved": unsaved}
    return page.put("/api/journal", json=sent)


def append(page, tab, first, *records):
    return page.post("/api/journal", json={"tab": tab, "first": first, "records": records, "unsaved": True})


def test_what_a_closed_page_did_is_given_to_the_next(page):
    with page.websocket_connect(WATCH) as socket:
        tab = socket.receive_json()["tab"]
        assert claim(page, tab).json()["records"] == []
        assert whole(page, tab, "base").status_code == 200
        assert append(page, tab, 1, "one", "tw😀o").json()["bytes"] > 0
        assert page.get("/api/journal/left").json() == []
    assert [left["path"] for left in page.get("/api/journal/left").json()] == ["blink.krt"]
    with page.websocket_connect(WATCH) as socket:
        found = claim(page, socket.receive_json()["tab"]).json()
    assert (found["records"], found["path"]) == (["base", "one", "tw😀o"], "blink.krt")


def test_two_pages_write_two_journals_and_know_of_each_other(page):
    with page.websocket_connect(WATCH) as one, page.websocket_connect(WATCH) as two:
        first, second = one.receive_json()["tab"], two.receive_json()["tab"]
        journals = {claim(page, first).json()["journal"], claim(page, second).json()["journal"]}
        assert len(journals) == 2
        news = [one.receive_json()]
        while news[-1]["others"] == 0:
            news.append(one.receive_json())
        assert (news[-1]["type"], news[-1]["path"], news[-1]["others"]) == ("news", "blink.krt", 1)


def test_a_page_hears_that_its_file_changed(page, folder):
    before = opened(page)["revision"]
    with page.websocket_connect(WATCH) as socket:
        claim(page, socket.receive_json()["tab"])
        news = socket.receive_json()
        while news["revision"] != before:
            news = socket.receive_json()
        (folder / "blink.krt").write_text(SHORT.replace(">2<", ">77<"))
        assert socket.receive_json()["revision"] == opened(page)["revision"] != before


def test_records_that_do_not_follow_are_refused_with_a_sentence(page):
    with page.websocket_connect(WATCH) as socket:
        tab = socket.receive_json()["tab"]
        claim(page, tab)
        for answer in (append(page, tab, 1, "x"), append(page, "nobody", 0, "x"), whole(page, "nobody", "x")):
            assert answer.status_code == 422
            assert answer.json()["message"].endswith(".")


@pytest.mark.parametrize("path", ["../secret.krt", "/etc/passwd", "x.txt", "example:../x.krt"])
def test_no_journal_is_about_a_path_outside_the_folder(page, path):
    with page.websocket_connect(WATCH) as socket:
        tab = socket.receive_json()["tab"]
        assert claim(page, tab, path).status_code == 403
        claim(page, tab)
        assert whole(page, tab, "base", path=path).status_code == 403


@pytest.mark.parametrize("journal", ["../../x", "0" * 16, "", "x" * 5000])
def test_a_journal_that_is_not_there_is_a_new_one(page, journal):
    with page.websocket_connect(WATCH) as socket:
        found = claim(page, socket.receive_json()["tab"], "blink.krt", journal).json()
    assert found["records"] == []
    assert found["journal"] != journal
    assert page.post("/api/journal/forget", json={"journal": journal}).json() == []


def test_nobody_watches_without_the_token(stranger):
    with pytest.raises(WebSocketDisconnect), stranger.websocket_connect(f"{SOCKET}/api/watch"):
        pass


def test_the_difference_from_the_file_is_told_in_words(page):
    file = opened(page)
    vertices = file["mission"]["programs"][0]["vertices"]
    next(vertex for vertex in vertices if vertex["id"] == "v2")["settings"]["duration"] = "9"
    answer = page.post("/api/mission/difference", json={"path": "blink.krt", "mission": file["mission"]}).json()
    assert answer == {"revision": file["revision"], "changes": ["blink: the duration of Wait (v2): 2 → 9"]}


def test_the_difference_from_a_damaged_or_missing_file_is_a_sentence(page, folder):
    mission = opened(page)["mission"]
    (folder / "blink.krt").write_text("<kitrobot")
    for path, status in (("blink.krt", 422), ("none.krt", 404)):
        answer = page.post("/api/mission/difference", json={"path": path, "mission": mission})
        assert answer.status_code == status
        assert answer.json()["message"].endswith(".")


def test_a_mission_and_its_file_are_merged_and_conflicts_are_told_and_decided(page, folder):
    base = opened(page)["mission"]
    ours = copy.deepcopy(base)
    vertices = ours["programs"][0]["vertices"]
    next(vertex for vertex in vertices if vertex["id"] == "v2")["settings"]["duration"] = "9"
    file = folder / "blink.krt"
    file.write_text(file.read_text().replace('name="duration">2<', 'name="duration">7<', 1))
    wanted = {"path": "blink.krt", "base": base, "mission": ours, "taken": []}
    found = page.post("/api/mission/merge", json=wanted).json()
    [conflict] = found["conflicts"]
    assert conflict["what"] == "Blink: the duration of Wait (v2)"
    assert (conflict["ours"], conflict["theirs"], conflict["taken"], conflict["open"]) == ("9", "7", False, True)
    assert found["mission"] == ours
    assert found["revision"] == opened(page)["revision"]
    found = page.post("/api/mission/merge", json=wanted | {"taken": [conflict["name"]]}).json()
    assert found["mission"] == found["theirs"] == opened(page)["mission"]
    # Nothing is written, and nothing leads out of the folder.
    assert page.post("/api/mission/merge", json=wanted | {"path": "../x.krt"}).status_code == 403
    assert page.post("/api/mission/merge", json=wanted | {"path": "none.krt"}).status_code == 404
