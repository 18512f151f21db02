"""Recordings: what the replay shows is what the run showed; opened, steered, saved, refused."""

from __future__ import annotations

import struct
import threading
import zlib
from pathlib import Path
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kitrobot
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.live.recordings import Recordings
from kitrobot.live.run_encoder import MOST_REPORTED
from kitrobot.live.watched_recording import WatchedRecording
from kitrobot.live.watched_simulation import WatchedSimulation
from kitrobot.server.security import SecurityMiddleware
from kitrobot.trace import layout
from kitrobot.trace.header import header_to_json
from kitrobot.trace.model import Threads
from kitrobot.trace.reader import TraceReader
from kitrobot.trace.source import walk
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.traces import open_trace
from tests.patience import PATIENCE_S

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
TRANSPORT = kitrobot.open(EXAMPLES / "transport" / "transport.krt")


def watched(ticks: int, random: Random) -> WatchedSimulation:
    """A run of so many ticks, with things done to it on the way; it stands at its first tick again."""
    watch = WatchedSimulation(TRANSPORT.prepare(RunOptions(seed=random.randrange(100))))
    while watch.tick < ticks and watch.outcome is None:
        watch.advance(random.randrange(1, 60), 1e9, lambda: 0.0)
        match random.randrange(4):
            case 0:
                watch.force("carrier-1", "Collision", random.choice([None, 0, 1]))
            case 1:
                watch.set_variable("carrier-2", "Dock", random.randrange(6))
            case 2:
                watch.inject_fault("carrier-3", random.choice(["stall", "mute", "revive"]))
    watch.advance(1, 1e9, lambda: 0.0)
    return watch


def go(one: WatchedSimulation | WatchedRecording) -> None:
    one.advance(1, 1e9, lambda: 0.0)


def told(one: WatchedSimulation | WatchedRecording) -> tuple[bytes, dict[str, Any], float]:
    frame, news = one.encode_update()
    news["events"] = []
    return frame, news, one.seconds


@settings(max_examples=4, deadline=None)
@given(st.integers(0, 2**32))
def test_the_player_shows_at_every_tick_what_the_run_showed(
    tmp_path_factory: pytest.TempPathFactory, seed: int
) -> None:
    random = Random(seed)
    watch = watched(400, random)
    path = tmp_path_factory.mktemp("play") / "a.krtrace"
    watch.record_to(path)
    latest = watch.tick
    walk(watch.seek(0))
    watch._run._again = True
    # A page that has just begun to watch: nobody was told of yet.
    watch._encoder._before = [None] * len(watch._encoder._before)
    replay = WatchedRecording(open_trace(path))
    apart = {"recording", "abilities"}
    assert replay.started("x").model_dump(exclude=apart) == watch.started("x").model_dump(exclude=apart)
    events = replay._reader.events
    assert [(e.tick, e.kind, e.text) for _, e in events] == [
        (e.tick, e.kind, e.text) for e in watch._run.timeline.events
    ]
    assert told(replay) == told(watch)
    while replay.tick < latest:
        go(replay)
        go(watch)
        assert told(replay) == told(watch)
    for _ in range(6):
        match random.randrange(3):
            case 0:
                tick = random.randrange(latest + 1)
                walk(replay.seek(tick))
                walk(watch.seek(tick))
            case 1:
                agent = random.choice(["", "carrier-1", "loader"])
                walk(replay.step_back(agent))
                walk(watch.step_back(agent))
            case _:
                walk(replay.seek(latest // 2))
                walk(watch.seek(latest // 2))
                walk(replay.step("carrier-1"))
                walk(watch.step("carrier-1"))
                if watch.tick > latest:
                    # A run goes on beyond what was recorded of it; the recording stands at its end.
                    assert replay.tick == latest
                    break
        assert told(replay) == told(watch)
    replay.close()


def test_a_recording_refuses_what_would_change_it(tmp_path: Path) -> None:
    TRANSPORT.run(seed=1, seconds=1, trace=tmp_path / "a.krtrace")
    replay = WatchedRecording(open_trace(tmp_path / "a.krtrace"))
    for act in (
        lambda: replay.force("carrier-1", "Collision", 1),
        lambda: replay.set_variable("carrier-1", "Dock", 1),
        lambda: replay.inject_fault("carrier-1", "fail"),
    ):
        with pytest.raises(KitRobotError, match="recording"):
            act()
    replay.close()


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The bytes of a whole recording of the transport mission."""
    path = tmp_path_factory.mktemp("recorded") / "transport.krtrace"
    TRANSPORT.run(seed=5, trace=path)
    return path.read_bytes()


def opened(page, data: bytes, name: str = "mine.krtrace") -> dict[str, Any]:
    answer = page.post("/api/trace", params={"name": name}, content=data)
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def test_a_recording_brings_its_mission_along_and_plays_to_its_end(page, connect, recorded):
    found = opened(page, recorded)
    assert (found["seed"], found["cut"]) == (5, False)
    file = found["file"]
    assert file["path"] == f"recording:{found['recording']}/mine.krt"
    assert file["mission"]["programs"][0]["name"] == "carrier"
    assert file["problems"] == []
    assert file["world"]["name"] == "ring"
    report = page.post("/api/check", json={"mission": file["mission"], "path": file["path"]}).json()
    assert report["problems"] == []
    with connect() as watcher:
        watcher.send(type="replay", recording=found["recording"], speed=0)
        started = watcher.until("started")
        assert (started["recording"], started["seed"], started["total"]) == (True, 5, 12)
        first = watcher.until("tick")
        assert (first["tick"], first["again"]) == (0, True)
        assert {event["kind"] for event in first["events"]} >= {"load", "unload", "message", "end"}
        assert first["latest"] > 2000
        end = watcher.until("state", status="done")
        assert (end["tick"], end["sentence"][:10]) == (first["latest"], "Done after")
        watcher.send(type="seek", tick=100)
        assert watcher.until("tick", tick=100)["latest"] == first["latest"]
        watcher.send(type="step", back=True)
        assert watcher.until("tick")["tick"] == 99
        watcher.send(type="force", agent="loader", sensor="Presence", value=1)
        assert "recording" in watcher.until("error")["message"]
        watcher.send(type="start", mission=file["mission"], path=file["path"], seed=found["seed"], speed=0)
        watcher.send(type="stop")
        watcher.until("state", status="stopped")
        watcher.send(type="start", mission=file["mission"], path=file["path"], seed=found["seed"], speed=0)
        assert watcher.until("started")["recording"] is False
        assert watcher.until("state", status="done")["tick"] == end["tick"]


def test_the_run_so_far_is_saved_with_what_was_done_to_it(page, connect, mission, transport):
    with connect() as watcher:
        run = watcher.start(mission(transport), path=transport, seed=2, speed=0.1)["run"]
        watcher.send(type="pause")
        watcher.until("state", status="paused")
        for _ in range(3):
            watcher.send(type="step")
        watcher.send(type="set", agent="carrier-1", variable="Dock", value=4)
        while not watcher.until("tick")["again"]:
            pass
        answer = page.get("/api/run/trace", params={"run": run})
        assert answer.status_code == 200
        watcher.send(type="stop")
        watcher.until("state", status="stopped")
        assert page.get("/api/run/trace", params={"run": run}).content == answer.content
        found = opened(page, answer.content)
        watcher.send(type="replay", recording=found["recording"], speed=0)
        said = watcher.until("tick")
        assert [event["text"] for event in said["events"] if event["kind"] == "outside"] == ["Dock set by hand: 4"]
        end = watcher.until("state", status="end")
        assert "still on" in end["sentence"]
        again = page.get("/api/run/trace", params={"run": f"run-{int(run.split('-')[1]) + 1}"})
        assert again.content == answer.content
    missing = page.get("/api/run/trace", params={"run": run})
    assert (missing.status_code, "no such run" in missing.json()["message"]) == (422, True)


def test_properties_are_judged_in_all_of_a_run_with_what_was_done_to_it(page, connect, mission, transport):
    """Of a run that has ended, and again after somebody went back in it and changed what follows."""
    asked = {
        **mission(transport),
        "properties": [
            {"name": "once", "form": "at-most", "first": "any carrier-1 (Cargo.IsPressed())", "times": 1},
            {"name": "dock four", "form": "never", "first": "any carrier-1 (Dock.EqualTo(4))"},
        ],
    }
    with connect() as watcher:
        run = watcher.start(asked, path=transport, speed=0)["run"]
        watcher.until("state", status="done")
        first = {one["name"]: one for one in page.get("/api/run/judgements", params={"run": run}).json()}
        assert (first["once"]["ruling"], first["dock four"]["ruling"]) == ("broken", "kept")
        assert first["once"]["tick"] > 0
        assert "carrier-1" in first["once"]["sentence"]
        watcher.send(type="seek", tick=50)
        watcher.until("tick", tick=50)
        watcher.send(type="set", agent="carrier-1", variable="Dock", value=4)
        watcher.until("tick", again=True)
        second = {one["name"]: one for one in page.get("/api/run/judgements", params={"run": run}).json()}
        assert (second["once"]["ruling"], second["dock four"]["ruling"]) == ("kept", "broken")
        found = opened(page, page.get("/api/run/trace", params={"run": run}).content)
        watcher.send(type="stop")
        watcher.until("state", status="stopped")
        watcher.send(type="replay", recording=found["recording"], speed=0)
        run = watcher.until("started")["run"]
        watcher.until("state", status="end")
        played = page.get("/api/run/judgements", params={"run": run}).json()
        assert played == list(second.values())
    missing = page.get("/api/run/judgements", params={"run": run})
    assert (missing.status_code, "no such run" in missing.json()["message"]) == (422, True)


def test_a_mission_without_properties_asks_nothing_of_its_run(page, connect, mission):
    with connect() as watcher:
        run = watcher.start(mission())["run"]
        watcher.until("state", status="done")
        assert page.get("/api/run/judgements", params={"run": run}).json() == []


def test_recordings_of_the_folder_are_listed_and_opened(page, folder, recorded):
    (folder / "deep").mkdir()
    (folder / "deep" / "bug.krtrace").write_bytes(recorded)
    (entry,) = page.get("/api/traces").json()
    assert (entry["path"], entry["name"]) == ("deep/bug.krtrace", "bug")
    found = page.get("/api/trace", params={"path": entry["path"]}).json()
    assert found["file"]["name"].endswith("bug.krt")


@pytest.mark.parametrize(
    "path", ["../a.krtrace", "/etc/passwd", "none.krtrace", "blink.krt", "", "recording:x/a.krtrace"]
)
def test_what_is_no_recording_of_the_folder_is_refused(page, path):
    answer = page.get("/api/trace", params={"path": path})
    assert answer.status_code in (403, 404, 422)
    assert answer.json()["message"].endswith(".")


def test_a_recording_is_read_only(page, recorded):
    file = opened(page, recorded)["file"]
    answer = page.put(
        "/api/mission", json={"path": file["path"], "revision": file["revision"], "mission": file["mission"]}
    )
    assert answer.status_code == 403
    assert "recording" in answer.json()["message"]


def test_a_cut_recording_plays_up_to_the_cut(page, connect, recorded):
    found = opened(page, recorded[: len(recorded) * 2 // 3])
    assert found["cut"] is True
    with connect() as watcher:
        watcher.send(type="replay", recording=found["recording"], speed=0)
        end = watcher.until("state", status="end")
        assert end["tick"] % 500 == 499
        assert "cut off" in end["sentence"]


def test_a_recording_that_is_damaged_inside_is_told_when_it_comes_to_it(page, connect, recorded):
    at = recorded.rindex(b"KRCH") + layout.CHUNK.size + 20
    found = opened(page, recorded[:at] + bytes([recorded[at] ^ 255]) + recorded[at + 1 :])
    with connect() as watcher:
        watcher.send(type="replay", recording=found["recording"], speed=0)
        failure = watcher.until("error")
        assert "damaged" in failure["message"]
        assert failure["ended"] is True


@pytest.mark.parametrize(
    "data",
    [b"", b"<kitrobot/>", b"KRTRACE\n", layout.MAGIC + struct.pack("<HII", 1, 0, 0), layout.MAGIC + b"\xff" * 100],
)
def test_what_is_no_recording_is_refused_with_a_sentence(page, data):
    answer = page.post("/api/trace", content=data)
    assert answer.status_code == 422
    assert answer.json()["message"].endswith(".")


def changed(data: bytes, tmp_path: Path, **fields: Any) -> bytes:
    """The recording with another header."""
    path = tmp_path / "was.krtrace"
    path.write_bytes(data)
    with TraceReader(path) as reader:
        text = layout.as_json({**header_to_json(reader.header), **fields})
    packed = zlib.compress(text)
    head = layout.VERSION_HEAD.pack(2) + layout.HEAD.pack(len(text), len(packed), zlib.crc32(packed))
    return layout.MAGIC + head + packed + data[data.index(b"KRCH") :]


@pytest.mark.parametrize(
    "fields",
    [
        {"mission": "no mission"},
        {"mission": "<kitrobot version='1'>"},
        {"world": "<world/>"},
        {"world": "<!DOCTYPE a [<!ENTITY b 'c'>]><world>&b;</world>"},
        {"mission": "<" * 100_000},
    ],
)
def test_a_mission_or_world_that_cannot_be_used_is_refused(page, recorded, tmp_path, fields):
    answer = page.post("/api/trace", content=changed(recorded, tmp_path, **fields))
    assert answer.status_code == 422
    assert answer.json()["message"].endswith(".")


def test_files_that_a_recording_brings_along_stay_in_its_folder(page, recorded, tmp_path, app):
    names = ["../out.xml", "/tmp/out.xml", "a/b.xml", "..\\out.xml", "no.txt", ".xml", "x" * 300 + ".xml", "\0.xml"]
    parts = [[name, "<robot/>"] for name in names] + [["fine.robot.xml", "<robot/>"]]
    found = opened(page, changed(recorded, tmp_path, parts=parts), name="../../evil.krtrace")
    place = app.state.studio.recordings.folder() / found["recording"]
    assert sorted(path.name for path in place.iterdir()) == ["evil.krt", "fine.robot.xml", "ring.world.xml"]


def test_numbers_beyond_all_sense_are_cut_to_what_a_page_can_hold(page, connect, recorded, tmp_path):
    from kitrobot.trace.model import TickRecord, TraceEvent
    from kitrobot.trace.writer import TraceWriter

    path = tmp_path / "wild.krtrace"
    path.write_bytes(recorded)
    with TraceReader(path) as reader:
        header, first = reader.header, reader.seek(0)
    wild = tmp_path / "b.krtrace"
    with TraceWriter(wild, header) as writer:
        for tick, number in enumerate((2**600, -(2**600), 2**64, 7)):
            event = TraceEvent(tick, "nonsense", -1, "x" * 100_000, "?")
            active: list[Threads] = [((5, 999_999),) for _ in first.active]
            writer.record(TickRecord(tick, [number] * len(first.numbers), active, [], [event]))
    found = opened(page, wild.read_bytes())
    with connect() as watcher:
        watcher.send(type="replay", recording=found["recording"], speed=0)
        events = watcher.until("tick")["events"]
        assert {event["kind"] for event in events} == {"message"}
        assert max(len(event["text"]) for event in events) < 600
        assert watcher.until("state", status="end")["tick"] == 3


def test_own_robots_and_constructors_travel_with_the_recording(page, folder, connect):
    from tests.server.conftest import SHORT

    shipped = (Path(kitrobot.__file__).parent / "primitives" / "shipped" / "mini-robot.robot.xml").read_text()
    own = folder.parent / "elsewhere"
    own.mkdir()
    (own / "odd.robot.xml").write_text(shipped.replace('name="mini-robot"', 'name="odd-robot"', 1))
    (own / "odd.xml").write_text(
        '<?xml version="1.0"?>\n<constructors version="1"><group name="Odd" colour="loop"><constructor name="Pause">'
        "<help>Waits.</help><code>WAIT(1)</code></constructor></group></constructors>"
    )
    (own / "unused.robot.xml").write_text(shipped.replace('name="mini-robot"', 'name="unused"', 1))
    text = SHORT.replace("mini-robot", "odd-robot").replace('"Light.LightOn"', '"Pause"')
    (own / "odd.krt").write_text(text)
    kitrobot.open(own / "odd.krt").run(seed=1, trace=own / "odd.krtrace")
    with TraceReader(own / "odd.krtrace") as reader:
        assert [part.file for part in reader.header.parts] == ["odd.robot.xml", "odd.xml"]
    found = opened(page, (own / "odd.krtrace").read_bytes())
    file = found["file"]
    assert "odd-robot" in {robot["name"] for robot in file["catalogue"]["robots"]}
    with connect() as watcher:
        watcher.start(file["mission"], path=file["path"])
        assert watcher.until("state", status="done")


def test_only_so_many_recordings_stay_open(tmp_path, recorded, monkeypatch):
    from kitrobot.live import recordings

    monkeypatch.setattr(recordings, "MAX_OPEN", 2)
    kept = Recordings(lambda folder: None)
    names = []
    for _ in range(3):
        path = kept.new_file("a.krtrace")
        path.write_bytes(recorded)
        name, _, trace = kept.add(path)
        trace.reader.close()
        names.append(name)
    with pytest.raises(KitRobotError, match="not open any more"):
        kept.open(names[0])
    kept.open(names[2]).reader.close()
    assert len(list(kept.folder().iterdir())) == 4


def test_a_recording_may_be_larger_than_a_mission(app):
    guard = SecurityMiddleware(app, "", largest_body_bytes=10, largest_trace_bytes=1000)
    assert guard.largest_trace_bytes > guard.largest_body_bytes


def test_two_saves_at_once_both_come(page, connect, forever):
    with page, connect() as watcher:  # in one loop, as in a server
        run = watcher.start(forever, speed=0.1)["run"]
        answers: list[bytes] = []
        threads = [
            threading.Thread(target=lambda: answers.append(page.get("/api/run/trace", params={"run": run}).content))
            for _ in range(2)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(PATIENCE_S)
        assert len(answers) == 2
        assert all(answer.startswith(layout.MAGIC) for answer in answers)


def test_of_a_crowd_all_are_drawn_and_those_looked_at_are_told(tmp_path, monkeypatch):
    from kitrobot.sim.recorder import simulate
    from tests.sim.teams import random_team

    monkeypatch.setattr("kitrobot.sim.recorder.PROGRESS_STEPS", 20)
    path = tmp_path / "crowd.krtrace"
    simulate(random_team(3, 130), path, lambda run: run.tick >= 20)
    replay = WatchedRecording(open_trace(path))
    header = replay._reader.header
    frame, news = replay.encode_update()
    assert struct.unpack_from("<2f", frame) == (0, len(header.agents))
    assert len(header.agents) > MOST_REPORTED
    first = {agent.program: agent.name for agent in reversed(header.agents)}
    assert set(news["agents"]) == set(first.values())
    other = next(agent.name for agent in reversed(header.agents) if agent.name not in first.values())
    replay.look_at([other, "nobody"])
    assert other in replay.encode_update()[1]["agents"]
    replay.close()
