"""How commands end that cannot do what was asked: as JSON where that was asked for, and whatever the streams are."""

from __future__ import annotations

import json
import os
import signal
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

    monkeypatch.setattr("kitrobot.versions.compare_files", broken)
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
