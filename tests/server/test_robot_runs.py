"""Real robots as a run: told over the channel of runs to the page that has them and to others, held, gone back in."""

from __future__ import annotations

from pathlib import Path

from kitrobot.trace.reader import TraceReader
from tests.boards.host import host_board, write_pulse
from tests.server.conftest import SOCKET, TOKEN
from tests.server.pages import RunPage


def name_of(address: str) -> str:
    return address.removeprefix("socket://")


def held(page, address: str) -> None:
    """The robot runs, held by this page."""
    page.give("connect", address)
    page.board(phase="open")
    page.send("start", address, held=True)
    page.board(state="running", held=True)


def test_it_is_told_like_every_run_by_the_programs_names(visit, robot) -> None:
    with visit() as page:
        held(page, robot.address)
        with page.run(robot.address) as run:
            (agent,) = run.begun["agents"]
            assert (agent["name"], agent["program"], agent["robot"]) == (name_of(robot.address), "pulse", "pulser")
            assert (agent["placed"], run.begun["recording"]) == (False, False)
            assert run.begun["abilities"] == ["force", "seek", "set", "step"]
            told = run.report(lambda said: said["values"]["Count"] > 0 and said["active"])
            assert {vertex for _, vertex in told["active"]} <= {f"v{n}" for n in range(1, 11)}
            assert (told["inputs"], told["forced"], told["state"]) == ({"ButtonA": 0}, [], "running")


def test_a_variable_is_set_and_a_sensor_forced_and_let_go_and_what_it_has_not_is_refused(visit, robot) -> None:
    name = name_of(robot.address)
    with visit() as page:
        held(page, robot.address)
        with page.run(robot.address) as run:
            run.send(type="set", agent=name, variable="Count", value=500)
            run.report(lambda said: said["values"]["Count"] >= 500)
            run.send(type="force", agent=name, sensor="ButtonA", value=1)
            assert run.report(lambda said: said["forced"])["inputs"] == {"ButtonA": 1}
            run.send(type="force", agent=name, sensor="ButtonA", value=None)
            run.report(lambda said: not said["forced"] and said["inputs"] == {"ButtonA": 0})
            for bad, word in (
                ({"type": "set", "agent": name, "variable": "Nothing", "value": 1}, "`Nothing`"),
                ({"type": "set", "agent": name, "variable": "Count", "value": 2**39}, "no room for the number"),
                ({"type": "force", "agent": "nobody", "sensor": "ButtonA", "value": 1}, "Nobody talks with"),
                ({"type": "harm", "agent": name, "kind": "fail"}, "only be done in the simulator"),
                ({"type": "jump"}, "not understood"),
                ({"type": "seek", "tick": -1}, "not understood"),
            ):
                run.send(**bad)
                said = run.until("error")
                assert (word in said["message"], said["ended"]) == (True, False), said
            run.send(type="set", agent=name, variable="Run", value=0)
            ended = run.until("state", status="done")
            assert ended["sentence"] == "The program of each robot has ended."


def test_what_was_forced_is_let_go_with_the_page(visit, robot) -> None:
    with visit() as page:
        page.give("connect", robot.address)
        page.board(phase="open")
        with page.run(robot.address) as run:
            run.send(type="force", agent=name_of(robot.address), sensor="ButtonA", value=1)
            run.report(lambda said: said["forced"] == ["ButtonA"])
    with visit() as page:
        page.give("connect", robot.address)
        page.board(phase="open", holder=page.you)
        with page.run(robot.address) as run:
            told = run.report(lambda said: said["values"]["Count"] > 0)
            assert (told["inputs"]["ButtonA"], told["forced"]) == (0, [])


def test_another_window_watches_it_and_may_do_nothing(visit, robot) -> None:
    with visit() as page, visit() as other:
        held(page, robot.address)
        with page.run(robot.address) as run, other.client.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}") as line:
            watcher = RunPage(line)
            watcher.send(type="watch", run=run.begun["run"], mission=other.mission)
            started = watcher.until("started")
            assert (started["watching"], started["another"], started["abilities"]) == (True, False, [])
            run.send(type="force", agent=name_of(robot.address), sensor="ButtonA", value=1)
            watcher.report(lambda said: said["forced"] == ["ButtonA"])
            watcher.send(type="force", agent=name_of(robot.address), sensor="ButtonA", value=None)
            assert "steers it" in watcher.until("error")["message"]
            run.send(type="stop")
            for window in (run, watcher):
                window.until("state", status="stopped")
            page.board(state="ready")
            # Started again, it is the same run, which begins anew.
            page.send("start", robot.address, held=True)
            for window in (run, watcher):
                assert window.restart()["latest"] < 50


def test_it_is_paused_and_gone_back_in_while_the_robot_goes_on(visit, robot) -> None:
    with visit() as page:
        held(page, robot.address)
        with page.run(robot.address) as run:
            run.report(lambda said: said["values"]["Count"] >= 3)
            run.send(type="pause")
            at = run.until("state", status="paused")["tick"]
            later = run.until("tick", tick=at)
            while later["latest"] < at + 50:
                later = run.until("tick", tick=at)
            run.send(type="step")
            assert run.until("state", tick=at + 1)["status"] == "paused"
            run.send(type="seek", tick=0)
            assert run.report(lambda said: said["values"]["Count"] <= 2)["values"]["Run"] == 1
            assert run.until("state", tick=0)["status"] == "paused"
            run.send(type="step", by="vertex")
            assert run.until("state", status="paused")["tick"] > 0
            run.send(type="resume", latest=True)
            assert run.until("state", status="running")["tick"] >= at + 50
            run.report(lambda said: said["values"]["Count"] >= 5)


def test_it_is_held_at_a_breakpoint_and_the_robot_goes_on(visit, robot) -> None:
    with visit() as page:
        held(page, robot.address)
        with page.run(robot.address) as run:
            when = "Count.GreaterThan(3)"
            point = {"program": "pulse", "vertex": "v10", "when": when, "after": 1, "enabled": True}
            run.send(type="breakpoints", breakpoints=[point])
            said = run.until("state", status="paused")
            assert [(hit["vertex"], hit["agent"]) for hit in said["hits"]] == [("v10", name_of(robot.address))]
            told = run.until("tick", tick=said["tick"])
            while told["latest"] < said["tick"] + 30:
                told = run.until("tick", tick=said["tick"])
            run.send(type="breakpoints", breakpoints=[])
            run.send(type="resume")
            run.until("state", status="running")
            # What was missed is gone through at the pace of the robot.
            assert run.until("tick")["tick"] < said["tick"] + 30


def test_it_is_followed_again_from_its_beginning_when_the_robot_is_started_anew(visit, robot) -> None:
    with visit() as page:
        held(page, robot.address)
        with page.run(robot.address) as run:
            point = {"program": "pulse", "vertex": "v10", "when": "", "after": 1, "enabled": True}
            run.send(type="breakpoints", breakpoints=[point])
            for _ in range(2):
                said = run.until("state", status="paused")
                assert [(hit["vertex"], hit["visit"]) for hit in said["hits"]] == [("v10", 1)]
                assert "v10" in [vertex for _, vertex in run.agents[name_of(robot.address)]["active"]]
                page.send("stop", robot.address)
                page.board(state="ready")
                page.send("start", robot.address, held=True)
                run.until("state", status="running")
            run.until("state", status="paused")
            run.send(type="breakpoints", breakpoints=[])
            page.send("stop", robot.address)
            page.board(state="ready")
            page.send("start", robot.address, held=True)
            run.until("state", status="running")
            run.report(lambda said: said["values"]["Count"] >= 3)


def test_it_is_saved_as_a_recording(visit, robot, tmp_path: Path) -> None:
    with visit() as page:
        held(page, robot.address)
        with page.run(robot.address) as run:
            run.report(lambda said: said["values"]["Count"] > 1)
            answer = page.client.get("/api/run/trace", params={"run": run.begun["run"]})
            path = tmp_path / "run.krtrace"
            path.write_bytes(answer.content)
            with TraceReader(path) as reader:
                last = reader.seek(reader.last_tick).values(reader.header)
                assert (reader.header.real, reader.cut) == (True, False)
                assert last[name_of(robot.address)]["variable Count"] > 1


def test_the_link_is_lost_and_back_while_it_is_watched(visit, folder) -> None:
    write_pulse(folder)
    with visit() as page, host_board(folder / "pulse.krt", "pulse", waits=True) as robot:
        page.give("connect", robot.address)
        page.send("start", robot.address, held=False)
        page.board(state="running", held=False)
        with page.run(robot.address) as run:
            run.report(lambda said: said["values"]["Count"] > 0)
            robot.pull()
            lost = run.until("state", status="failed")
            assert "is lost; it runs on by itself" in lost["sentence"]
            run.report(lambda said: said["state"] == "stalled" and not said["active"])
            run.send(type="seek", tick=0)
            run.until("state", status="paused")
            run.send(type="resume", latest=True)
            run.until("state", status="failed")


def test_two_that_are_called_alike_are_told_apart_in_one_run(visit, app, folder) -> None:
    write_pulse(folder)
    with (
        visit() as page,
        host_board(folder / "pulse.krt", "pulse", waits=True) as one,
        host_board(folder / "pulse.krt", "pulse", waits=True) as two,
    ):
        for board in (one, two):
            held(page, board.address)
        for session in app.state.studio.boards._sessions.values():
            session.name = "micro:bit"
        with page.run(one.address, two.address, one.address) as run:
            assert [agent["name"] for agent in run.begun["agents"]] == ["micro:bit 1", "micro:bit 2"]
            run.send(type="set", agent="micro:bit 2", variable="Count", value=700)
            run.report(lambda said: said["values"]["Count"] >= 700, "micro:bit 2")
            assert run.agents["micro:bit 1"]["values"]["Count"] < 700
            run.send(type="stop")
            run.until("state", status="stopped")


def test_who_does_not_have_the_robot_cannot_begin_its_run(visit, robot) -> None:
    with visit() as page, visit() as other, visit("192.168.1.7") as away:
        held(page, robot.address)

        def refused(who, **more) -> str:
            with who.client.websocket_connect(f"{SOCKET}/api/run?token={TOKEN}") as line:
                window = RunPage(line)
                request = {"mission": page.mission, "path": "pulse.krt", "holder": who.you, "speed": 1}
                window.send(**{"type": "robots", **request, "addresses": [robot.address], **more})
                said: str = window.until("error")["message"]
                return said

        assert "Another page" in refused(other)
        assert "another machine" in refused(away, holder=page.you)
        assert "Nobody talks with" in refused(page, addresses=["socket://127.0.0.1:1"])
        for odd in ([], ["x"] * 33, [""], "x", None):
            assert "not understood" in refused(page, addresses=odd)
        page.mission["programs"][0]["name"] = "other"
        page.send("connect", robot.address, mission=page.mission, path="", program="nobody")
        page.board(phase="open", program="")
        assert "another program" in refused(page)
