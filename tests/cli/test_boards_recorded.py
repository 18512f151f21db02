"""What robots do, recorded for the studio."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys

import pytest

from tests.boards.host import host_board
from tests.boards.watching import LONG_S, line_with
from tests.cli.watched_lines import counts_of, objects, vertices_of

pytestmark = pytest.mark.usefixtures("no_boards")


def test_watching_records_what_the_studio_plays(kitrobot, watch, robot, pulse, here):
    def enough(given):
        return len(counts_of(objects(given))) > 1 and vertices_of(objects(given)[-1:])

    said = watch(
        *("--to", robot.address, "--mission", pulse, "--trace", here / "r.krtrace", "--json"),
        until=enough,
    )
    assert said.status == 0
    assert "recorded in" in said.err
    assert {line["board"] for line in said.lines} == {robot.address}
    played = kitrobot("replay", here / "r.krtrace", "--json").json
    assert played["real"]
    assert not played["cut"]
    assert played["agents"] == [
        {"name": robot.address.removeprefix("socket://"), "program": "pulse", "robot": "pulser"}
    ]
    last = kitrobot("replay", here / "r.krtrace", "--at", "99", "--json").json
    agent = next(iter(last["agents"].values()))
    assert agent["state"] == "running"
    # The very last values that were told stand at the end.
    assert agent["values"]["Count"] == counts_of(said.lines)[-1]
    assert agent["vertices"]
    assert agent["x_mm"] is None
    assert "nobody knows where it was" in kitrobot("replay", here / "r.krtrace", "--at", "99").out


def test_a_fault_stands_in_the_recording_with_its_vertex_and_line(kitrobot, broken, here):
    kitrobot("watch", "--to", broken.address, "--mission", "pulse.krt", "--seconds", "2", "--trace", here / "r.krtrace")
    played = kitrobot("replay", here / "r.krtrace", "--json").json
    failures = [event for event in played["events"] if event["kind"] == "failure"]
    assert len(failures) == 1
    assert re.search(r"fault 1: a driver failed \(Display: .*\); at the vertex v3, line 2", failures[0]["text"])
    assert (failures[0]["cause"], played["outcome"]) == ("robot", "failed")


@pytest.mark.skipif(sys.platform == "win32", reason="Ctrl-C reaches no single process there")
def test_several_robots_are_recorded_together_and_ctrl_c_or_a_lost_link_leaves_a_whole_file(
    kitrobot, robot, pulse, here
):
    with host_board(pulse, "pulse") as second:
        addresses = [robot.address, second.address]
        command = [sys.executable, "-m", "kitrobot", "watch", "--mission", str(pulse), "--trace", "r.krtrace", "--json"]
        for address in addresses:
            command += ["--to", address]
        process = subprocess.Popen(command, cwd=here, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        assert process.stdout is not None
        heard: set[str] = set()
        while heard != set(addresses):
            heard.add(json.loads(process.stdout.readline())["board"])
        second.pull()
        assert process.stderr is not None
        assert line_with("broke", process.stderr)
        while json.loads(process.stdout.readline())["board"] != robot.address:
            continue
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=LONG_S)
    assert process.returncode == 1
    assert "recorded in r.krtrace" in err
    played = kitrobot("replay", here / "r.krtrace", "--json").json
    names = [address.removeprefix("socket://") for address in addresses]
    assert [agent["name"] for agent in played["agents"]] == names
    assert not played["cut"]
    lost = [event for event in played["events"] if event["kind"] == "failure"]
    assert [(event["agent"], event["text"], event["cause"]) for event in lost] == [
        (names[1], "the link is lost", "link")
    ]
    last = kitrobot("replay", here / "r.krtrace", "--at", "9999", "--json").json["agents"]
    assert [last[name]["state"] for name in names] == ["running", "stalled"]
    assert last[names[0]]["vertices"]
    assert not last[names[1]]["vertices"]


def test_what_cannot_be_recorded_is_refused_in_a_sentence(kitrobot, robot, pulse, here):
    before = pulse.read_bytes()
    unknown = kitrobot("watch", "--to", robot.address, "--trace", here / "r.krtrace", "--seconds", "1")
    assert unknown.status == 1
    assert "a recording brings its mission along" in unknown.err
    assert "--mission" in unknown.err
    over = kitrobot("watch", "--to", robot.address, "--mission", pulse, "--trace", pulse, "--seconds", "1")
    assert over.status == 1
    assert "written over" in over.err
    assert pulse.read_bytes() == before
    nowhere = kitrobot("watch", "--to", robot.address, "--mission", pulse, "--trace", here / "no" / "r.krtrace")
    assert nowhere.status == 1
    assert "cannot be written" in nowhere.err
    assert not (here / "r.krtrace").exists()
