"""Experiments over HTTP and their WebSocket: choices, plans, studies that grow and go on, and the run behind a dot."""

from __future__ import annotations

import contextlib
import json
from typing import Any

import pytest
from pydantic import TypeAdapter

from kitrobot.experiments.plan import StudyRequest, plan_study
from kitrobot.experiments.study import Study
from kitrobot.experiments.study_folder import begin_study
from kitrobot.experiments.study_run import run_study
from kitrobot.live import study_work
from kitrobot.wire.experiment import ExperimentMessage
from kitrobot.workspace.mission_loader import open_mission
from tests.server.conftest import SOCKET, TOKEN

MESSAGE: TypeAdapter[Any] = TypeAdapter(ExperimentMessage)
WAITS = {"address": "blink.v2.duration", "values": "1,2,3"}


class Experimenter:
    """The page's end of a socket. Every message is held against its published shape."""

    def __init__(self, socket) -> None:
        self.socket = socket

    def send(self, **message) -> None:
        self.socket.send_text(json.dumps(message))

    def until(self, *kinds: str) -> dict[str, Any]:
        while True:
            said: dict[str, Any] = json.loads(self.socket.receive_text())
            MESSAGE.validate_python(said)
            if said["type"] in kinds:
                return said
            assert said["type"] == "progress", said


@pytest.fixture
def experimenting(page):
    @contextlib.contextmanager
    def connected(language="en"):
        with page.websocket_connect(f"{SOCKET}/api/experiment?language={language}&token={TOKEN}") as socket:
            yield Experimenter(socket)

    return connected


@pytest.fixture
def asked(mission):
    """A study of blink, which waits one second, two or three, with two seeds."""

    def made(**more) -> dict[str, Any]:
        ask = {"mission": mission(), "path": "blink.krt", "axes": [WAITS], "seeds": "1-2"}
        return {**ask, "measures": ["seconds", "done"], "seconds": 60, **more}

    return made


@pytest.fixture
def studied(folder):
    """A complete study beside the mission, made without the studio."""
    request = StudyRequest([("blink.v2.duration", "1,2,3")], seeds="1-2", measures=["seconds", "done"], seconds=60)
    begin_study(folder / "blink-study", plan_study(open_mission(folder / "blink.krt"), request))
    run_study(folder / "blink-study")
    return Study(folder / "blink-study")


def test_a_mission_offers_its_numbers_and_measures_with_values_that_can_stand_there(page, mission, asked):
    told = page.post("/api/experiment/choices", json={"mission": mission(), "path": "blink.krt"}).json()
    assert told["measures"] == ["seconds", "done", "collisions", "distance", "energy"], "there are no boxes to deliver"
    assert told["studies"] == []
    offered = {one["address"]: one for one in told["addresses"]}
    assert offered["blink.v2.duration"]["current"] == "2"
    assert not any(name.startswith("program.") for name in offered), "their values are files"
    for one in told["addresses"]:
        axis = {"address": one["address"], "values": one["example"]}
        answer = page.post("/api/experiment/plan", json=asked(axes=[axis]))
        assert answer.status_code == 200, (one, answer.json())


def test_a_mission_with_errors_still_shows_its_studies(page, mission, studied):
    broken = {**mission(), "agents": [{"name": "robot-1", "program": "missing", "start": ""}]}
    told = page.post("/api/experiment/choices", json={"mission": broken, "path": "blink.krt"}).json()
    assert told == {"addresses": [], "measures": [], "studies": [{"study": "blink-study", "runs": 6}]}


def test_a_plan_counts_its_runs_and_names_the_command_that_makes_the_same_study(page, asked):
    told = page.post("/api/experiment/plan", json=asked(fail_rate=0.5)).json()
    assert told["points"] == 3
    assert told["runs"] == 6
    assert told["command"] == (
        "kitrobot sweep blink.krt --vary blink.v2.duration=1,2,3 --seeds 1-2 "
        "--measure seconds --measure done --seconds 60 --fail-rate 0.5"
    )


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ({"axes": [{"address": "blink.v2.durations", "values": "1"}]}, "`blink.v2.durations`"),
        ({"axes": [{"address": "blink.v2.duration", "values": "1:2:0"}]}, "no range"),
        ({"axes": [{"address": "blink.v2.duration", "values": "nan"}]}, "expected a whole number"),
        ({"axes": [WAITS, WAITS]}, "varies twice"),
        ({"axes": [{"address": "program.blink", "values": "/etc/hostname"}]}, "which a page cannot name"),
        ({"axes": [{"address": " program.blink", "values": "plan.toml"}]}, "which a page cannot name"),
        ({"seeds": "1-"}, "seeds such as 1-1000"),
        ({"seeds": "1-20000"}, "the studio begins at most 20000"),
        ({"measures": ["second"]}, "is no measure"),
        ({"measures": ["time all nobody (x)"]}, "The measure"),
        ({"measures": []}, "not understood"),
        ({"seconds": 0}, "not understood"),
        ({"axes": [WAITS] * 7}, "not understood"),
    ],
)
def test_what_makes_no_sense_is_said_before_a_run_is_made(page, folder, experimenting, asked, more, words):
    answer = page.post("/api/experiment/plan", json=asked(**more))
    assert answer.status_code == 422
    assert words in answer.json()["message"]
    with experimenting() as experiment:
        experiment.send(type="start", **asked(**more))
        assert words in experiment.until("refused")["message"]
    assert not list(folder.glob("*-study*"))


def test_a_study_of_the_page_is_that_of_the_command_line_and_the_very_same_is_made_once(
    page, folder, experimenting, asked, studied
):
    rows = (studied.folder / "rows.jsonl").read_bytes()
    with experimenting() as experiment:
        experiment.send(type="start", **asked())
        found = experiment.until("study")["study"]
        assert (found["study"], found["done"], found["total"]) == ("blink-study", 6, 6)
        assert (studied.folder / "rows.jsonl").read_bytes() == rows
        experiment.send(type="start", **asked(seeds="1-3"))
        found = experiment.until("study")["study"]
        assert (found["study"], found["done"], found["total"]) == ("blink-study-2", 9, 9)
    assert [point["values"] for point in found["points"]] == [[1], [2], [3]]
    assert [point["cells"][0]["estimate"] for point in found["points"]] == pytest.approx([0.12, 0.22, 0.32])
    assert found["points"][0]["outcomes"] == {"done": 3}
    assert page.get("/api/experiment/study", params={"path": "blink.krt", "study": "blink-study-2"}).json() == found
    assert found["command"] == "kitrobot sweep blink-study-2 --resume"
    assert len(Study(folder / "blink-study-2").rows) == 9


def test_a_study_that_was_cut_short_goes_on(experimenting, studied):
    rows = studied.folder / "rows.jsonl"
    whole = rows.read_bytes()
    rows.write_bytes(whole[: len(whole) // 2])
    with experimenting() as experiment:
        experiment.send(type="resume", path="blink.krt", study="blink-study")
        found = experiment.until("study")["study"]
    assert (found["done"], found["total"]) == (6, 6)
    assert sorted(rows.read_bytes().splitlines()) == sorted(whole.splitlines())


def test_it_is_stopped_keeps_what_ended_and_a_studio_is_at_one_at_a_time(experimenting, folder, asked, forever):
    with experimenting() as first, experimenting() as second:
        first.send(type="start", **asked(mission=forever, axes=[], seeds="1", seconds=36_000))
        first.send(type="nothing")
        assert "not understood" in first.until("refused")["message"]
        second.send(type="resume", path="blink.krt", study="blink-study")
        assert "at an experiment already" in second.until("refused")["message"]
        first.send(type="stop")
        found = first.until("study")["study"]
        assert (found["done"], found["total"], found["points"]) == (0, 1, [])


def test_the_run_behind_each_dot_is_that_run(page, studied):
    where = {"path": "blink.krt", "study": "blink-study"}
    told = page.get("/api/experiment/runs", params={**where, "first": 2, "count": 2}).json()
    assert [(one["row"], one["seed"], one["outcome"], one["measures"][1]) for one in told] == [
        (2, 1, "done", 1),
        (3, 2, "done", 1),
    ]
    opened = page.post("/api/experiment/replay", params={**where, "row": 3}).json()
    assert opened["seed"] == 2
    [wait] = [one for one in opened["file"]["mission"]["programs"][0]["vertices"] if one["id"] == "v2"]
    assert wait["settings"]["duration"] == "2"
    with page.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}") as socket:
        socket.send_text(
            json.dumps({"type": "replay", "recording": opened["recording"], "speed": 0, "breakpoints": []})
        )
        said = json.loads(socket.receive_text())
        assert (said["type"], said["seed"], said["recording"]) == ("started", 2, True)
    assert page.get("/api/experiment/table", params=where).text.startswith("row,id,seed,blink.v2.duration,outcome")


ELSEWHERE = ["", ".", "..", "../missions", "/etc", "blink.krt", "nothing", "a\x00b", "link", "x" * 900]


@pytest.mark.parametrize("study", ELSEWHERE)
def test_no_name_leads_to_a_study_elsewhere(page, folder, studied, study, tmp_path):
    studied.folder.rename(tmp_path / "elsewhere")
    (folder / "link").symlink_to(tmp_path / "elsewhere")
    for method, what in (("GET", "study"), ("GET", "table"), ("GET", "runs"), ("POST", "replay")):
        params = {"path": "blink.krt", "study": study, "first": 0, "count": 1, "row": 0}
        answer = page.request(method, f"/api/experiment/{what}", params=params)
        assert answer.status_code == 422, (what, answer.text)
        assert "There is no study" in answer.json()["message"]


def test_a_torn_plan_or_row_is_a_sentence_and_hides_no_other_study(page, folder, mission, studied):
    (folder / "torn").mkdir()
    (folder / "torn" / "plan.toml").write_bytes(b"\xff\x00format = ")
    told = page.post("/api/experiment/choices", json={"mission": mission(), "path": "blink.krt"}).json()
    assert told["studies"] == [{"study": "blink-study", "runs": 6}]
    answer = page.get("/api/experiment/study", params={"path": "blink.krt", "study": "torn"})
    assert answer.status_code == 422
    with (studied.folder / "rows.jsonl").open("ab") as file:
        file.write(b'{"row": 99}\n')
    answer = page.get("/api/experiment/study", params={"path": "blink.krt", "study": "blink-study"})
    assert "no row of its study" in answer.json()["message"]
    answer = page.get("/api/experiment/runs", params={"path": "blink.krt", "study": "blink-study", "first": -1})
    assert answer.status_code == 422


def test_larger_studies_are_shown_a_part_at_a_time(page, studied, monkeypatch):
    monkeypatch.setattr(study_work, "MOST_RUNS_TOLD", 4)
    where = {"path": "blink.krt", "study": "blink-study", "first": 0, "count": 2**53}
    assert len(page.get("/api/experiment/runs", params=where).json()) == 4


def test_refusals_are_in_the_readers_language(page, asked, experimenting):
    with experimenting("fr") as experiment:
        experiment.send(type="start", **asked(axes=[{"address": "program.blink", "values": "x"}]))
        assert "une page" in experiment.until("refused")["message"]
