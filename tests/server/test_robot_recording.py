"""Real robots recorded while a page has them in its session, saved, and played as a recording like any other."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.boards.programs import load_board_program
from kitrobot.live.last_run_recorder import LastRunRecorder
from kitrobot.primitives.image_name import ImageName
from kitrobot.robots.session import RobotSession
from kitrobot.robots.state import Activity
from kitrobot.trace.model import TraceError
from kitrobot.trace.reader import TraceReader
from tests.boards.host import host_board, write_pulse
from tests.robots.twin import Twin
from tests.server.conftest import HOST, SOCKET, TOKEN, TestClient

HEADERS = {"X-KitRobot-Token": TOKEN}


@pytest.fixture
def saved(app, tmp_path):
    """Saves the recording of a robot, opens it, and gives its reader."""
    client = TestClient(app, base_url=HOST, headers=HEADERS, client=("127.0.0.1", 50000))

    def save(address: str) -> TraceReader:
        answer = client.get("/api/board/trace", params={"address": address})
        assert answer.status_code == 200, answer.text
        path = Path(tmp_path / "saved.krtrace")
        path.write_bytes(answer.content)
        return TraceReader(path)

    return save


def events_of(reader: TraceReader) -> list[tuple[str, str, str]]:
    return [(event.kind, event.text, event.cause) for _, event in reader.events]


def test_a_run_is_recorded_with_what_was_done_to_it_and_saved_on_the_way_and_after(visit, robot, saved) -> None:
    with visit() as page:
        page.give("connect", robot.address)
        page.board(phase="open", recorded=True)
        page.send("stop", robot.address)
        page.board(state="ready")
        page.send("start", robot.address, held=True)
        page.board(state="running", held=True)
        with page.run(robot.address) as run:
            name = robot.address.removeprefix("socket://")
            run.send(type="force", agent=name, sensor="ButtonA", value=1)
            run.send(type="set", agent=name, variable="Count", value=500)
            run.report(lambda said: said["values"]["Count"] >= 510)
            for vertex in ("v5", "v10"):
                run.report(lambda said, at=vertex: said["active"] == [[0, at]])
        done = [
            ("outside", "its program was started from here", "person"),
            ("outside", "ButtonA held by hand: true", "person"),
            ("outside", "Count set by hand: 500", "person"),
        ]
        with saved(robot.address) as reader:
            assert not reader.cut
            assert events_of(reader) == done
            last = reader.seek(reader.last_tick).values(reader.header)
            (name,) = (agent.name for agent in reader.header.agents)
            assert name == robot.address.removeprefix("socket://")
            assert last[name]["variable Count"] >= 510
            assert (last[name]["input ButtonA"], last[name]["forced"], last[name]["doing"]) == (1, 1, 2)
            stood = {reader.header.vertices[ImageName("pulse")][at] for record in reader for _, at in record.active[0]}
            assert {"v5", "v10"} <= stood
            given = {(one.actuator, one.procedure) for record in reader for one in record.commands}
            assert given == {("Display", "Image"), ("Display", "Clear")}
        page.send("stop", robot.address)
        page.board(state="ready")
        with saved(robot.address) as reader:
            assert events_of(reader) == [*done, ("outside", "it was stopped from here", "person")]
            assert reader.seek(reader.last_tick).active == [()]
            assert reader.outcome["outcome"] == "stopped"


def test_a_fault_ends_the_recording_where_it_happened(visit, folder, saved) -> None:
    write_pulse(folder, broken=True)
    with host_board(folder / "pulse.krt", "pulse") as board, visit(broken=True) as page:
        page.give("connect", board.address)
        page.board(phase="open")
        page.send("stop", board.address)
        page.board(state="ready")
        page.send("start", board.address, held=True)
        page.until("board", lambda said: said["fault"] is not None and said["state"] == "fault")
        with saved(board.address) as reader:
            *_, (kind, text, cause) = events_of(reader)
            assert (kind, cause) == ("failure", "robot")
            assert text.startswith("fault 1: a driver failed (Display")
            assert "at the vertex v3, line 2" in text
            (threads,) = reader.seek(reader.last_tick).active
            assert [reader.header.vertices[ImageName("pulse")][at] for _, at in threads] == ["v3"]
            assert reader.outcome["outcome"] == "failed"


def test_a_lost_link_stands_in_the_recording(visit, robot, saved) -> None:
    with visit() as page:
        page.give("connect", robot.address)
        page.board(phase="open")
        page.send("start", robot.address, held=True)
        page.board(state="running", held=True)
        with page.run(robot.address) as run:
            run.report(lambda said: said["values"]["Count"] > 0)
        robot.pull()
        page.board(phase="lost", recorded=True)
        with saved(robot.address) as reader:
            assert not reader.cut
            *_, (kind, text, cause) = events_of(reader)
            assert (kind, cause) == ("failure", "link")
            assert "is lost: its motors stop within one second" in text


def test_without_a_run_there_is_nothing_to_save_and_strangers_get_nothing(visit, app, folder, tmp_path, robot) -> None:
    here = TestClient(app, base_url=HOST, headers=HEADERS, client=("127.0.0.1", 50000))
    away = TestClient(app, base_url=HOST, headers=HEADERS, client=("192.168.1.7", 50000))
    ask = {"params": {"address": robot.address}}
    assert here.get("/api/board/trace", **ask).json()["message"] == "Nobody talks with this robot."
    path = folder / "pulse.krt"
    with visit() as page:
        page.mission["programs"][0]["name"] = "other"
        page.send("connect", robot.address, mission=page.mission, path="", program="nobody")
        page.board(phase="open", program="")
        assert here.get("/api/board/trace", **ask).json()["message"] == "This robot was not recorded yet."
        assert away.get("/api/board/trace", **ask).json()["message"] == "The robots are plugged into another machine."
    assert path.is_file()


def test_a_robot_of_which_nothing_is_known_is_not_recorded(tmp_path) -> None:
    session, twin = RobotSession(), Twin()
    last = LastRunRecorder("a", session)
    session.open(twin, twin.hello, None)
    session.start()
    session.poll(0)
    session.lose("")
    session.replaced()
    assert not last.is_there
    with pytest.raises(TraceError, match="not recorded"):
        last.save(tmp_path / "a.krtrace")
    last.close()


def test_the_socket_of_runs_plays_it(visit, robot, saved, app, tmp_path) -> None:
    with visit() as page:
        page.give("connect", robot.address)
        page.board(phase="open")
        with page.run(robot.address) as run:
            run.report(lambda said: said["values"]["Count"] > 0)
        saved(robot.address).close()
    client = TestClient(app, base_url=HOST, headers=HEADERS)
    opened = client.post("/api/trace?name=r.krtrace", content=(tmp_path / "saved.krtrace").read_bytes()).json()
    assert opened["real"]
    with client.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}") as socket:
        socket.send_json({"type": "replay", "recording": opened["recording"], "speed": 0})
        started = socket.receive_json()
        assert [agent["placed"] for agent in started["agents"]] == [False]
        assert started["recording"]


def test_a_link_that_comes_back_goes_on_with_the_recording_of_the_same_program(tmp_path) -> None:
    program = load_board_program(write_pulse(tmp_path))
    session = RobotSession()
    last = LastRunRecorder("a", session)

    def found(doing: Activity, installed: str = "12345678") -> None:
        twin = Twin(doing, program=installed)
        session.open(twin, twin.hello, program.known)

    def kinds() -> list[str]:
        last.save(tmp_path / "a.krtrace")
        with TraceReader(tmp_path / "a.krtrace") as reader:
            assert not reader.cut
            return [event.kind for _, event in reader.events]

    found("running")
    session.lose("the link is lost")
    found("running")
    assert kinds() == ["failure", "revival"]
    session.lose("the link is lost")
    found("ready")
    session.poll(0)
    # It was found standing: the recording has ended, and can be saved until the next run.
    assert kinds() == ["failure", "revival", "failure", "revival"]
    session.force("ButtonA", 1)
    session.start()
    assert kinds() == ["outside", "outside"]
    session.lose("the link is lost")
    found("running", "87654321")
    assert kinds() == []
    last.close()
    assert not last.is_there
