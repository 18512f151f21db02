"""How commands end that cannot do what was asked: as JSON where that was asked for, and whatever the streams are."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import subprocess
import sys

import pytest

from kitrobot.cli.app import app
from tests.cli.conftest import EXAMPLE, MISTAKEN
from tests.cli.test_process import KITROBOT, call
from tests.effort import cases
from tests.patience import PATIENCE_S

COMMANDS = sorted(command.name for command in app.registered_commands if command.name)
posix = pytest.mark.skipif(sys.platform == "win32", reason="streams and signals of POSIX")


def shell(command: str, *arguments: object) -> subprocess.CompletedProcess[bytes]:
    """The output of a line of the shell; `$K` is the command."""
    env = {**os.environ, "K": " ".join(KITROBOT)}
    words = ["sh", "-c", command, "sh", *map(str, arguments)]
    return subprocess.run(words, capture_output=True, timeout=PATIENCE_S, env=env, check=False)


@pytest.mark.parametrize(
    ("arguments", "status", "error"),
    [
        (["run", "none.krt"], 1, "there is no file"),
        (["run", "bad.krt"], 1, "which is not in this mission"),
        (["replay", "none.krtrace"], 1, "cannot be read"),
        (["diff", "none.krt", "other.krt"], 2, "there is no file"),
        (["exec", "bad.lll", "--robot", "mini-robot"], 1, "expected"),
        (["exec", "none.lll", "--robot", "nobody"], 1, "no robot named nobody"),
        (["check", "x.lll", "--robot", "nobody"], 1, "no robot named nobody"),
        (["run", "none.krt", "--seed", "x"], 2, "Invalid value"),
        (["run", "none.krt", "--seconds", "0"], 2, "more than 0"),
        (["run"], 2, "Missing argument"),
        (["run", "none.krt", "--none"], 2, "No such option"),
        (["convert", "a", "b"], 2, "No such option"),
        (["nonsense"], 2, "is no command"),
    ],
)
def test_who_asks_for_json_gets_an_object_of_what_went_wrong(kitrobot, here, arguments, status, error):
    (here / "bad.lll").write_text(MISTAKEN)
    (here / "bad.krt").write_text('<kitrobot version="1"><team><agent name="a" program="p"/></team></kitrobot>')
    said = kitrobot(*arguments, "--json")
    assert said.status == status
    found = said.json["error"]
    assert set(found) == {"message", "help", "diagnostics"}
    assert error in json.dumps(found)
    assert found["message"]


def test_what_the_program_has_wrong_is_in_the_object(kitrobot, here):
    (here / "bad.lll").write_text(MISTAKEN)
    found = kitrobot("exec", "bad.lll", "--robot", "mini-robot", "--json").json["error"]
    assert found["diagnostics"][0]["line"] == 1
    assert found["diagnostics"][0]["code"] == "syntax"


def test_where_data_was_given_there_is_no_second_object(kitrobot, here):
    (here / "bad.lll").write_text(MISTAKEN)
    said = kitrobot("check", "bad.lll", "--json")
    assert said.status == 1
    assert isinstance(said.json, list)


def test_behind_two_dashes_json_is_the_name_of_a_file(kitrobot):
    said = kitrobot("format", "--", "--json")
    assert (said.status, said.out) == (1, "")


def test_a_mistake_of_ours_is_an_object_too(kitrobot, here, monkeypatch):
    def broken(*arguments: object) -> None:
        raise ZeroDivisionError("x")

    monkeypatch.setattr("kitrobot.versions.file_comparison.compare_files", broken)
    said = kitrobot("diff", "a.krt", "b.krt", "--json")
    assert said.status == 70
    assert "ZeroDivisionError" in said.json["error"]["message"]


def test_the_list_of_commands_is_that_of_the_commands(kitrobot):
    said = " ".join(kitrobot("zzzzzzz", studio=print).err.replace("│", " ").split())
    assert f"commands: {', '.join(COMMANDS)}" in said


@posix
@pytest.mark.parametrize("arguments", cases(["check --json"], ["check none.krt", "exec --ticks 5 --program carrier"]))
def test_on_a_full_disk_a_sentence_is_said(arguments):
    ended = shell(f'$K {arguments} "$1" > /dev/full', EXAMPLE)
    assert ended.returncode == 1
    assert ended.stderr.startswith(b"error: No space left on device") or b"\nerror: No space" in ended.stderr
    assert b"Traceback" not in ended.stderr
    assert b"Exception ignored" not in ended.stderr


@posix
@pytest.mark.parametrize(
    "arguments", cases(["check --json"], ["check none.krt", "exec --ticks 5 --program carrier", "run"])
)
def test_a_closed_output_is_said(arguments):
    ended = shell(f'$K {arguments} "$1" >&-', EXAMPLE)
    assert ended.returncode == 1
    assert b"standard output is closed" in ended.stderr
    assert b"Traceback" not in ended.stderr


@posix
@pytest.mark.parametrize(
    "arguments", cases(["check none.krt", "zzzzzz"], ["run none.krt", "run --none", "format none.lll"])
)
def test_a_closed_error_output_leaves_the_data_clean(arguments):
    ended = shell(f"$K {arguments} 2>&-")
    assert ended.returncode in (1, 2)
    assert ended.stdout == b"" or arguments.startswith("check")


WORK = cases(
    [
        "run $1 --seconds 5 --trace made.krtrace",
        "grade hand --exercise $2 --html made.html",
        "convert $1 made.lll --program carrier",
        "nonsense",
    ],
    ["check $1", "verify $1 --seconds 1", "replay made.krtrace", "run --none"],
)
EXERCISE = EXAMPLE.parents[1] / "exercises" / "03-square.exercise.xml"


@posix
def test_what_cannot_be_told_changes_no_work(tmp_path):
    """Whatever a command does: the same status and files where standard error is closed or full."""

    def done(place: str, how: str, works: list[str]) -> tuple[list[int], dict[str, bool]]:
        folder = tmp_path / place
        (folder / "hand").mkdir(parents=True)
        (folder / "hand" / "ada.krt").write_bytes((EXERCISE.parent / "03-square.krt").read_bytes())
        line = "; ".join(f'$K {work} {how}; echo "status $?"' for work in works)
        ended = shell(f'cd "$3" && {line}', EXAMPLE, EXERCISE, folder)
        said = ended.stdout.splitlines()
        status = [int(one.split()[1]) for one in said if one.startswith(b"status ")]
        made = {one.name: one.stat().st_size > 0 for one in folder.iterdir() if one.is_file()}
        return status, made

    made: set[str] = set()
    for half, how in enumerate(cases(["2>&-", "2>/dev/full"], ["2>/dev/full", "2>&-"])):
        works = WORK[half % 2 :: 2]
        usual = done(f"usual {half}", "2>/dev/null", works)
        assert 70 not in usual[0]
        made |= set(usual[1])
        assert done(f"told {half}", how, works) == usual
    assert {"made.krtrace", "made.html", "made.lll"} <= made


@posix
@pytest.mark.parametrize(
    ("command", "how"),
    cases(
        [("studio --no-browser", "2>&- >&-")],
        [(f"{door} --no-browser", f"2>{how} >{how}") for door in ("studio", "class") for how in ("/dev/full", "&-")],
    ),
)
def test_servers_open_whatever_the_streams_are(command: str, how: str, tmp_path):
    """A page is there, and Ctrl-C ends it."""
    folder, probe = tmp_path / "Folder", socket.create_server(("127.0.0.1", 0))
    folder.mkdir()
    port = probe.getsockname()[1]
    probe.close()
    env = {**os.environ, "KITROBOT_STATE": str(tmp_path / "state")}
    line = f"exec {' '.join(KITROBOT)} {command} --port {port} '{folder}' {how}"
    with subprocess.Popen(["sh", "-c", line], env=env, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as server:
        answer = b""
        while not answer:
            assert server.poll() is None, "it ended"
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port), PATIENCE_S) as asking:
                asking.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n".encode())
                answer = asking.recv(100)
        assert answer.startswith(b"HTTP/1.1 ")
        server.send_signal(signal.SIGINT)
        assert server.wait(PATIENCE_S) in (0, 1, 130)


INTERRUPTED = """
import os, signal, sys
sys.argv = ["kitrobot", *sys.argv[2:]]
left = int({left!r})
class Interrupting:
    def find_spec(self, name, path=None, target=None):
        global left
        left -= 1
        if left == 0:
            os.kill(os.getpid(), signal.SIGINT)
        return None
sys.meta_path.insert(0, Interrupting())
from kitrobot.__main__ import run
run()
"""


@posix
@pytest.mark.parametrize("left", [1, 10, 200])
def test_ctrl_c_while_a_command_is_still_being_imported_ends_it_with_one_line(left: int):
    """Python's own start, before the first line of ours, is not ours to change."""
    script = INTERRUPTED.replace("{left!r}", str(left + 3))
    ended = subprocess.run(
        [sys.executable, "-c", script, "", "run", str(EXAMPLE)], capture_output=True, timeout=PATIENCE_S, check=False
    )
    assert (ended.returncode, ended.stderr) == (130, b"broken off\n")


@posix
def test_a_closed_input_is_said():
    ended = shell("$K format - <&-")
    assert ended.returncode == 1
    assert b"standard input is closed" in ended.stderr


@posix
def test_who_stops_reading_in_the_middle_of_much_output_ends_it(tmp_path):
    file = tmp_path / "many.lll"
    file.write_text("Wheel.Stop()\n" * 5000)
    with subprocess.Popen([*KITROBOT, "check", str(file)], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.readline()
        process.stdout.close()
        assert process.stderr.read() == b""
        assert process.wait(PATIENCE_S) == 141


@posix
@pytest.mark.parametrize("locale", cases(["C"], ["POSIX"]))
def test_a_name_that_is_no_utf_8_is_read_and_named(tmp_path, locale):
    name = os.fsencode(tmp_path) + b"/b\xff.lll"
    with open(name, "wb") as file:
        file.write(MISTAKEN.encode())
    env = {"LANG": locale, "LC_ALL": locale, "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    ended = call("check", os.fsdecode(name), env=env)
    assert ended.returncode == 1
    assert name + b":1:" in ended.stdout
    ended = call("check", os.fsdecode(name), "--json", env=env)
    assert json.loads(ended.stdout.decode("utf-8"))[0]["file"] == os.fsdecode(name)


@posix
def test_a_signal_to_end_ends_with_its_status(tmp_path):
    with subprocess.Popen(
        [*KITROBOT, "format", "-"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        waiting = f"/proc/{process.pid}/wchan"
        assert process.stdin is not None
        while os.path.exists(waiting) and b"SigCgt" not in _caught(process.pid):
            pass
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=PATIENCE_S)
    assert (process.returncode, out, err) == (143, b"", b"")


def _caught(pid: int) -> bytes:
    """`SigCgt` when the process handles SIGTERM by itself."""
    with open(f"/proc/{pid}/status", "rb") as file:
        for line in file:
            if line.startswith(b"SigCgt") and int(line.split()[1], 16) >> (signal.SIGTERM - 1) & 1:
                return b"SigCgt"
    return b""
