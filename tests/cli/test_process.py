"""The command as a process: locale, pipes, signals, start-up, and the studio behind a real socket."""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import socket
import stat
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit

import httpx
import pytest
import websockets

from kitrobot.__main__ import _open_studio
from tests import coroutines
from tests.cli.conftest import EXAMPLE
from tests.patience import PATIENCE_S

KITROBOT = [sys.executable, "-m", "kitrobot"]


def call(*arguments, env=None, **options):
    return subprocess.run(
        [*KITROBOT, *map(str, arguments)],
        capture_output=True,
        timeout=PATIENCE_S,
        env={**os.environ, **(env or {})},
        check=False,
        **options,
    )


@pytest.mark.parametrize("locale", ["C", "POSIX", "en_US.ISO-8859-1"])
def test_output_is_utf_8_whatever_the_locale(tmp_path, locale):
    (tmp_path / "p.lll").write_text("# é درائیو\nموٹر.چلاؤ(5);\n°A.b()°;\n", encoding="utf-8")
    env = {"LANG": locale, "LC_ALL": locale, "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    ended = call("format", tmp_path / "p.lll", env=env)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout == (tmp_path / "p.lll").read_bytes()


def test_a_reader_that_stops_reading_is_no_mistake(tmp_path):
    (tmp_path / "p.lll").write_text("WAIT(1);")
    command = [*KITROBOT, "exec", str(tmp_path / "p.lll"), "--robot", "mini-robot", "--ticks", "200000", "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        assert json.loads(process.stdout.readline())["tick"] == 0
        process.stdout.close()
        said = process.stderr.read()
        status = process.wait(PATIENCE_S)
    assert said == b""
    assert status in (1, 141)


@pytest.mark.skipif(sys.platform == "win32", reason="no terminals of our own there")
def test_a_bar_is_drawn_while_a_person_watches_and_the_data_stays_clean():
    import pty

    ours, theirs = pty.openpty()
    with open(ours, "rb", buffering=0) as terminal:
        command = [*KITROBOT, "run", str(EXAMPLE), "--json"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=theirs) as process:
            os.close(theirs)
            drawn = b""
            with contextlib.suppress(OSError):  # how the end of a terminal is told
                while piece := terminal.read(4096):
                    drawn += piece
            assert process.stdout is not None
            assert json.loads(process.stdout.read())["outcome"] == "done"
    assert b"s simulated" in drawn


def test_laying_out_a_text_loads_neither_the_simulator_nor_the_server(tmp_path):
    (tmp_path / "p.lll").write_text("WAIT(1);")
    ended = call("format", tmp_path / "p.lll", env={"PYTHONPROFILEIMPORTTIME": "1"})
    loaded = set(re.findall(rb"\|\s+([\w.]+)\n", ended.stderr))
    assert b"kitrobot.lll" in loaded
    heavy = {b"numpy", b"numba", b"fastapi", b"uvicorn", b"kitrobot.sim", b"kitrobot.server", b"kitrobot.compiler"}
    assert not loaded & (heavy | {b"pydantic", b"secrets", b"tempfile"})


def test_a_shell_completes_every_command():
    asked = {"_KITROBOT_COMPLETE": "complete_bash", "COMP_CWORD": "1"}
    assert call(env={**asked, "COMP_WORDS": "kitrobot st"}).stdout.split() == [b"studio", b"start", b"stop"]
    assert call("check", env={**asked, "COMP_WORDS": "kitrobot dep"}).stdout.split() == [b"deploy"]


def test_importing_the_package_imports_nothing_else():
    code = "import sys, kitrobot; print([name for name in sys.modules if name.startswith('kitrobot.')])"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=PATIENCE_S, check=True)
    assert ended.stdout.strip() == b"[]"


def test_a_mistake_of_ours_shows_where_only_when_asked(tmp_path):
    code = (
        "import kitrobot.cli.format as f, kitrobot.cli.app\n"
        "def broken(*a): raise ZeroDivisionError('x')\n"
        "f._format = broken\n"
        "kitrobot.cli.app.main(['format', 'x.lll'])\n"
    )
    for debug in ("", "1"):
        env = {**os.environ, "KITROBOT_DEBUG": debug}
        ended = subprocess.run(
            [sys.executable, "-c", code], capture_output=True, timeout=PATIENCE_S, env=env, check=False
        )
        assert ended.returncode == 70
        assert (b"Traceback" in ended.stderr) == bool(debug)


@contextlib.contextmanager
def opened(folder, browser: Path | None = None) -> Iterator[tuple[str, str, subprocess.Popen[str]]]:
    """A studio on a copy of the example: its address without the token, the token, the process.

    `browser`: what it opens its page in.
    """
    (folder / "transport.krt").write_bytes(EXAMPLE.read_bytes())
    command = [*KITROBOT, str(folder / "transport.krt"), "--port", "0"]
    env = {**os.environ, "BROWSER": str(browser), "DISPLAY": ":0"}
    if browser is None:
        command, env = [*command, "--no-browser"], dict(os.environ)
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=env) as process:
        assert process.stdout is not None
        address, _, token = process.stdout.readline().strip().partition("/?token=")
        try:
            yield address, token, process
        finally:
            if process.poll() is None:
                process.kill()


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    """A studio that is only talked to."""
    with opened(tmp_path_factory.mktemp("studio")) as made:
        yield made


async def watched(address: str, token: str, frames: int) -> websockets.ClientConnection:
    """A socket with a run on it, from which so many frames were received."""
    with httpx.Client(base_url=address, headers={"X-KitRobot-Token": token}, trust_env=False) as client:
        file = client.get("/api/mission", params={"path": "transport.krt"}).json()
    url = f"{address.replace('http', 'ws')}/api/run?token={token}"
    ws = await websockets.connect(url, proxy=None, max_size=None)
    start = {"type": "start", "mission": file["mission"], "path": file["path"], "seed": 1, "speed": 1}
    await ws.send(json.dumps(start))
    while frames:
        frames -= isinstance(await ws.recv(), bytes)
    return ws


def test_the_printed_address_is_on_this_machine_and_has_a_token(studio):
    address, token, _ = studio
    assert re.fullmatch(r"http://127\.0\.0\.1:[0-9]+", address)
    assert len(token) >= 32


def test_the_studio_answers_over_a_real_socket(studio):
    address, token, _ = studio
    with httpx.Client(base_url=address, trust_env=False) as client:
        assert client.get("/api/session").status_code == 403
        assert client.get("/api/session", params={"token": token}).json()["path"] == "transport.krt"
        assert client.get("/api/session", params={"token": token}, headers={"Host": "evil"}).status_code == 403


def test_a_port_that_is_taken_is_said(studio, tmp_path):
    address, _, _ = studio
    port = address.rpartition(":")[2]
    ended = call(tmp_path, "--no-browser", "--port", port)
    assert ended.returncode == 1
    assert b"already in use" in ended.stderr
    assert b"--port" in ended.stderr


@pytest.mark.parametrize("host", ["0.0.0.0", "192.168.1.1", "example.org", "::", ""])
def test_the_studio_listens_on_this_machine_only(kitrobot, here, host):
    ended = kitrobot(here, "--no-browser", "--port", "0", "--host", host, studio=_open_studio)
    assert ended.status == 1
    assert "does not listen" in ended.err


def test_where_no_studio_is_served_no_web_server_is_loaded(tmp_path):
    ended = call(tmp_path, "--no-browser", "--host", "0.0.0.0", env={"PYTHONPROFILEIMPORTTIME": "1"})
    assert ended.returncode == 1
    assert b"does not listen" in ended.stderr
    loaded = set(re.findall(rb"\|\s+([\w.]+)\n", ended.stderr))
    assert b"kitrobot.server.studio_server" in loaded
    assert not loaded & {b"numpy", b"fastapi", b"uvicorn", b"kitrobot.sim", b"kitrobot.server.app"}


def test_a_second_kitrobot_on_a_folder_opens_a_page_of_the_first_and_after_a_kill_there_is_another_token(
    kitrobot, tmp_path
):
    """With `--new` it does not: `server/test_two_studios.py`."""
    missions = tmp_path / "missions"
    missions.mkdir()
    with opened(missions) as (address, token, process):
        for target, named in ((missions, ""), (missions / "transport.krt", "transport.krt")):
            ended = kitrobot(target, "--no-browser", studio=_open_studio)
            assert ended.status == 0
            assert ended.out.strip() == f"{address}/?token={token}&open={named}"
            assert "runs already" in ended.err
        process.kill()
        process.wait(PATIENCE_S)
    said, browser = tmp_path / "said", None
    if sys.platform != "win32":  # a browser of our own is a script
        os.mkfifo(said)
        browser = tmp_path / "browser"
        browser.write_text(f'#!/bin/sh\nprintf "%s\\n" "$@" > "{said}"\n')
        browser.chmod(0o700)
    with opened(missions, browser) as (again, other, process):
        assert (again, other == token) == (address, False), "at the same address, with another token"
        page = the_token_is_in_no_command_line_of_a_browser(said, again, other) if browser else None
        ctrl_c_ends_it_in_the_middle_of_runs_and_pages_that_left_leave_no_trace(again, other, process)
        assert page is None or not page.exists()


def the_token_is_in_no_command_line_of_a_browser(said: Path, address: str, token: str) -> Path:
    told = urlsplit(said.read_text().strip())
    page = Path(told.path)
    assert told.scheme == "file"
    assert token not in told.geturl()
    assert stat.S_IMODE(page.stat().st_mode) == 0o600
    assert f"url={address}/?token={token}" in page.read_text()
    return page


def ctrl_c_ends_it_in_the_middle_of_runs_and_pages_that_left_leave_no_trace(address: str, token: str, process) -> None:
    async def watch() -> None:
        left = await watched(address, token, 3)
        left.transport.abort()
        stayed = await watched(address, token, 3)
        process.send_signal(signal.SIGINT)
        with contextlib.suppress(websockets.ConnectionClosed):
            async for _ in stayed:
                pass

    coroutines.run(watch())
    assert process.wait(PATIENCE_S) == 0
    assert process.stderr is not None
    assert process.stderr.read() == "Ctrl-C ends the studio.\n"


def test_a_usual_port_that_is_taken_is_passed_over():
    from kitrobot.server.studio_server import USUAL_PORT, listen

    with socket.socket() as taken:
        taken.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            taken.bind(("127.0.0.1", USUAL_PORT))
            taken.listen()
        except OSError:
            pass  # somebody else has it: just as well
        with listen("127.0.0.1", None) as found:
            assert found.getsockname()[1] != USUAL_PORT
