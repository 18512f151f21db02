"""`kitrobot deploy | boards | start | stop | watch | log`, as far as no board of metal or in QEMU is needed.

The board is the loop of real boards in a process of its own, with TCP for its serial line.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import socket
import subprocess
import sys

import pytest

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.line import repl
from kitrobot.deploy.line.line import Line
from tests.boards.host import ROOT, host_board
from tests.boards.watching import LONG_S
from tests.cli.watched_lines import counts_of, objects, vertices_of

pytestmark = pytest.mark.usefixtures("no_boards")


@pytest.fixture
def nobody(monkeypatch):
    """The address of somebody who never says a word; the clock of a line there goes fast, those of others do not."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        address = f"socket://127.0.0.1:{listener.getsockname()[1]}"
        now = Line.now
        monkeypatch.setattr(Line, "now", lambda line: now(line) * (50 if line.address == address else 1))
        yield address


def state_of(kitrobot, address: str) -> dict:
    found: dict = kitrobot("boards", "--to", address, "--json").json[0]
    return found


# ---- before anything is sent


def test_errors_of_the_program_are_shown_as_check_shows_them(kitrobot, pulse):
    pulse.write_text(pulse.read_text().replace("Count.Add", "Count.Jump"))
    checked = kitrobot("check", pulse)
    sent = kitrobot("deploy", pulse, "--to", "socket://127.0.0.1:1")
    assert sent.status == 1
    shown = checked.err.rpartition("\n1 error")[0] or checked.out
    first = next(line for line in (checked.out + checked.err).splitlines() if "Jump" in line)
    assert first in sent.err
    assert shown
    assert "has errors" in sent.err


def test_a_missing_driver_names_the_files_that_were_looked_for(kitrobot, here, pulse):
    robot = here / "pulser.robot.xml"
    robot.write_text(robot.read_text().replace("<board/>", '<board driver="sonar-9"/>'))
    said = kitrobot("deploy", pulse, "--to", "socket://127.0.0.1:1")
    assert said.status == 1
    assert "`Display` of the robot `pulser` wants the driver `sonar-9`" in said.err
    assert "sonar_9.driver.py" in said.err
    assert str(here) in said.err


def test_a_robot_without_drivers_says_which_part_needs_one(kitrobot, here, pulse):
    robot = here / "pulser.robot.xml"
    robot.write_text(robot.read_text().replace('device="display"', "").replace("<board/>", ""))
    said = kitrobot("deploy", pulse, "--to", "socket://127.0.0.1:1")
    assert said.status == 1
    assert "`Display`" in said.err


def test_without_a_robot_it_says_how_to_name_one(kitrobot, pulse):
    said = kitrobot("deploy", pulse)
    assert said.status == 1
    assert "no robot is plugged in" in said.err
    assert "--to" in said.err


def test_with_several_robots_it_asks_which(kitrobot, pulse, monkeypatch):
    monkeypatch.setenv("KITROBOT_BOARDS", "socket://127.0.0.1:1 socket://127.0.0.1:2")
    said = kitrobot("start")
    assert said.status == 1
    assert "2 robots may be meant" in said.err
    assert "--to" in said.err


def test_an_address_that_cannot_be_opened_is_told(kitrobot, pulse):
    with socket.create_server(("127.0.0.1", 0)) as listener:
        closed = listener.getsockname()[1]
    said = kitrobot("deploy", pulse, "--to", f"socket://127.0.0.1:{closed}", "--to", "nonsense://x")
    assert said.status == 1
    assert said.err.count("cannot be opened") == 2


def test_somebody_who_never_answers_is_told(kitrobot, pulse, nobody, monkeypatch):
    monkeypatch.setattr(repl, "RESET_S", 1.0)  # nobody presses a button
    said = kitrobot("deploy", pulse, "--to", nobody, "--json")
    assert said.status == 1
    assert said.json[0]["ok"] is False
    assert "no MicroPython answers" in said.json[0]["error"]["message"]


def test_what_a_program_shares_with_its_team_is_warned_of_with_vertex_and_line(kitrobot, here, pulse):
    robot = here / "pulser.robot.xml"
    robot.write_text(
        robot.read_text().replace('name="Count" type="integer"', 'name="Count" shared="yes" type="integer"')
    )
    said = kitrobot("deploy", pulse, "--to", "nonsense://x")
    assert said.err.count("[shared-on-board]") == 1
    assert "warning: `Count` is shared with the team" in said.err
    assert "line 3, vertex `v4`" in said.err
    assert "cannot be opened" in said.err, "it is sent all the same"


@pytest.mark.parametrize("command", ["start", "stop", "watch", "log", "deploy"])
def test_as_json_a_failure_is_an_object_with_a_sentence_and_a_way_out(kitrobot, pulse, command):
    given = [pulse] if command == "deploy" else []
    said = kitrobot(command, *given, "--json")
    assert said.status == 1
    assert said.json == {
        "error": {
            "message": "no robot is plugged in",
            "help": "plug one in with a USB cable that carries data, or name its address with --to",
            "diagnostics": [],
        }
    }


def test_as_json_errors_of_the_program_are_in_the_failure(kitrobot, pulse):
    pulse.write_text(pulse.read_text().replace("Count.Add", "Count.Jump"))
    error = kitrobot("deploy", pulse, "--to", "nonsense://x", "--json").json["error"]
    assert "has errors" in error["message"]
    assert {"file", "line", "severity", "code"} <= set(error["diagnostics"][0])


@pytest.mark.parametrize("command", ["start", "stop", "deploy", "boards"])
def test_as_json_each_robot_that_fails_has_its_error(kitrobot, pulse, command):
    given = [pulse] if command == "deploy" else []
    said = kitrobot(command, *given, "--to", "nonsense://x", "--json")
    assert said.status == (0 if command == "boards" else 1)
    (found,) = said.json
    assert found["address"] == "nonsense://x"
    assert "cannot be opened" in found["error"]["message"]
    assert found["error"]["help"]


@pytest.mark.parametrize("command", [["watch"], ["log"], ["boards", "--identify", "nonsense://x"]])
def test_as_json_a_robot_that_cannot_be_reached_is_an_error(kitrobot, command):
    more = [] if "--identify" in command else ["--to", "nonsense://x"]
    said = kitrobot(*command, *more, "--json")
    assert said.status == 1
    assert "cannot be opened" in said.json["error"]["message"]


# ---- a robot that runs


def test_boards_tells_what_runs(kitrobot, robot, monkeypatch):
    monkeypatch.setenv("KITROBOT_BOARDS", robot.address)
    said = kitrobot("boards")
    assert said.status == 0
    assert re.search(rf"{robot.address}\s+named\s+running\s+[0-9a-f]{{8}}", said.out)
    found = kitrobot("boards", "--json").json[0]
    assert found["answers"]
    assert found["state"] == "running"
    assert found["free"] > 0
    assert found["generation"] == 1


def test_who_does_not_answer_is_listed_as_that(kitrobot, nobody, robot):
    said = kitrobot("boards", "--to", nobody, "--to", robot.address)
    assert said.status == 0
    assert re.search(rf"{nobody}\s+no answer", said.out)
    assert "running" in said.out


def test_identify_lets_it_show_itself(kitrobot, robot):
    said = kitrobot("boards", "--identify", robot.address)
    assert said.status == 0
    assert robot.address in said.err


def test_stop_and_start(kitrobot, robot, monkeypatch):
    monkeypatch.setenv("KITROBOT_BOARDS", robot.address)
    assert kitrobot("stop").status == 0
    assert state_of(kitrobot, robot.address)["state"] == "ready"
    assert kitrobot("start", "--all").status == 0
    assert state_of(kitrobot, robot.address)["state"] == "running"


def test_one_that_fails_does_not_hold_up_the_others(kitrobot, robot, nobody):
    said = kitrobot("stop", "--to", nobody, "--to", robot.address)
    assert said.status == 1
    assert f"{robot.address}: stopped" in said.err
    assert f"{nobody}:" in said.err
    assert state_of(kitrobot, robot.address)["state"] == "ready"


def test_all_and_to_are_not_both(kitrobot):
    assert kitrobot("stop", "--all", "--to", "x").status == 2


def test_watch_tells_values_and_places(watch, robot, pulse):
    def enough(given):
        lines = objects(given)
        pressed = any(line.get("inputs", {}).get("ButtonA") == 0 for line in lines)
        return pressed and len(counts_of(lines)) > 1 and vertices_of(lines) & {"v5", "v7"}

    said = watch("--to", robot.address, "--mission", pulse, "--period", "50", "--json", until=enough)
    assert said.status == 0
    assert counts_of(said.lines) == sorted(counts_of(said.lines))
    assert all(place["line"] for line in said.lines for place in line["active"])


def test_watch_without_the_mission_tells_numbers_and_says_so(watch, robot):
    said = watch("--to", robot.address, until=lambda given: "instruction" in given)
    assert said.status == 0
    assert "--mission" in said.err


def test_watching_ends_by_itself_after_the_seconds_that_were_named(kitrobot, robot):
    assert kitrobot("watch", "--to", robot.address, "--seconds", "0.1").status == 0


def test_watch_with_another_mission_is_refused(kitrobot, robot, pulse):
    pulse.write_text(pulse.read_text().replace('<set name="value">1</set>', '<set name="value">2</set>'))
    said = kitrobot("watch", "--to", robot.address, "--mission", pulse, "--seconds", "1")
    assert said.status == 1
    assert "runs another program" in said.err


def test_an_lll_is_watched_when_its_robot_is_named(watch, kitrobot, here, pulse):
    kitrobot("convert", pulse, here / "pulse.lll")
    data = load_board_program(here / "pulse.lll", robot=str(here / "pulser.robot.xml")).file.to_bytes()
    assert data == load_board_program(pulse).file.to_bytes()
    with host_board(pulse, "pulse") as robot:
        unnamed = kitrobot("watch", "--to", robot.address, "--mission", here / "pulse.lll")
        assert unnamed.status == 1
        assert "--robot" in unnamed.err
        named = ("--mission", here / "pulse.lll", "--robot", here / "pulser.robot.xml")
        said = watch("--to", robot.address, *named, "--json", until=lambda given: counts_of(objects(given)))
        assert said.status == 0
        assert kitrobot("log", "--to", robot.address, *named).status == 0


def test_the_robot_goes_on_when_watching_ends(kitrobot, robot):
    kitrobot("watch", "--to", robot.address, "--seconds", "0.5")
    before = state_of(kitrobot, robot.address)["tick"]
    while state_of(kitrobot, robot.address)["tick"] == before:
        pass


@pytest.mark.skipif(sys.platform == "win32", reason="no terminals of our own there")
def test_the_table_stays_in_its_place_until_ctrl_c(robot, pulse):
    import pty

    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "kitrobot", "watch", "--to", robot.address, "--mission", str(pulse)]
    with open(ours, "rb", buffering=0) as terminal:
        process = subprocess.Popen(
            command,
            stdout=theirs,
            stderr=theirs,
            cwd=ROOT,
            env={**os.environ, "COLUMNS": "100"},
            # Who runs the tests in the background has it ignored, and children inherit that.
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
        )
        os.close(theirs)
        drawn = b""
        with contextlib.suppress(OSError):  # how the end of a terminal is told
            while b"Count = " not in drawn:
                drawn += terminal.read(4096)
            process.send_signal(signal.SIGINT)
            while piece := terminal.read(4096):
                drawn += piece
        assert process.wait(LONG_S) == 0
    assert b"pulse: running" in drawn
    assert b"Traceback" not in drawn


def test_log_without_a_fault(kitrobot, robot):
    said = kitrobot("log", "--to", robot.address)
    assert said.status == 0
    assert "no fault" in said.out


def test_log_tells_number_device_vertex_and_line(kitrobot, broken, here):
    said = kitrobot("log", "--to", broken.address, "--mission", here / "pulse.krt")
    assert said.status == 0
    assert "fault 1" in said.out
    assert "a driver failed" in said.out
    assert "Display" in said.out
    assert "v3, line" in said.out
    found = kitrobot("log", "--to", broken.address, "--mission", here / "pulse.krt", "--json").lines[0]
    assert found["number"] == 1
    assert found["vertex"] == "v3"
    assert json.dumps(found)


def test_a_protocol_that_differs_says_what_to_update(kitrobot):
    import threading

    from kitrobot_onboard.link import unwrap, wrap

    with socket.create_server(("127.0.0.1", 0)) as listener:

        def answer() -> None:
            peer, _ = listener.accept()
            with peer:
                heard = b""
                while data := peer.recv(100):
                    heard += data
                    for piece in heard.split(b"~"):
                        found = unwrap(piece)
                        if found:
                            peer.sendall(wrap("H", found[1], bytes((0,)) + bytes(20)))
                            heard = b""

        threading.Thread(target=answer, daemon=True).start()
        said = kitrobot("start", "--to", f"socket://127.0.0.1:{listener.getsockname()[1]}")
    assert said.status == 1
    assert "version 0" in said.err
    assert "kitrobot deploy" in said.err


def test_the_command_line_starts_without_what_talks_to_boards():
    code = "import sys, kitrobot.cli; print([one for one in sys.modules if one.startswith(('serial', 'mpremote'))])"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=LONG_S, check=True)
    assert ended.stdout.strip() == b"[]"
    code = "import sys, kitrobot.cli; print('kitrobot.deploy' in sys.modules, 'python_minifier' in sys.modules)"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=LONG_S, check=True)
    assert ended.stdout.strip() == b"False False"


# ---- recorded
