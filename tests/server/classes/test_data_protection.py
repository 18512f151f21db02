"""What `docs/data-protection.md` promises of a class: where it writes, that it calls nobody, that it sets no cookie."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any
from urllib.request import Request, urlopen

from tests.patience import PATIENCE_S
from tests.server.classes.conftest import hand_in
from tests.server.classes.test_class_start import a_class_that_opens_says_what_a_teacher_has_to_tell

WATCH = """
import os, sys
def watch(event, given):
    if event in ("socket.connect", "socket.sendto", "socket.getaddrinfo", "socket.gethostbyname"):
        called = given[-1] if event == "socket.connect" else given[:2]
        os.write(watch.file, (event + " " + repr(called) + "\\n").encode())
watch.file = os.open(os.environ["WATCHED"], os.O_WRONLY | os.O_CREAT | os.O_APPEND)
sys.addaudithook(watch)
"""
"""Notes each call to another machine, before anything else of Python runs."""


def ask(address: str, key: str = "", **given: Any) -> bytes:
    """Asks the class as a pupil's page does."""
    headers = {"Content-Type": "application/json", "X-KitRobot-Token": key}
    body = json.dumps(given).encode() if given else None
    with urlopen(Request(address, body, headers), timeout=PATIENCE_S) as answer:
        assert answer.headers["set-cookie"] is None
        found: bytes = answer.read()
    return found


def test_a_class_says_how_it_is_reached_writes_only_into_its_folder_and_the_state_folder_and_calls_nobody(
    tmp_path: Path,
) -> None:
    folder, home, watched = tmp_path / "Class 5b", tmp_path / "home", tmp_path / "watched"
    for made in (home, tmp_path / "watch"):
        made.mkdir()
    (tmp_path / "watch" / "sitecustomize.py").write_text(WATCH)
    search = os.pathsep.join([str(tmp_path / "watch"), *sys.path])
    places = {"KITROBOT_STATE": "state", "KITROBOT_CONFIG": "config", "KITROBOT_CACHE": "cache", "TMPDIR": "home"}
    environment = {
        **os.environ,
        **{name: str(tmp_path / place) for name, place in places.items()},
        **{
            "KITROBOT_LANGUAGE": "en",
            "LC_ALL": "C",
            "HOME": str(home),
            "PYTHONPATH": search,
            "WATCHED": str(watched),
            "PYTHONDONTWRITEBYTECODE": "1",
        },
    }
    command = [sys.executable, "-m", "kitrobot", "class", str(folder), "--no-browser", "--port", "0"]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment, cwd=home
    ) as process:
        try:
            address = a_class_that_opens_says_what_a_teacher_has_to_tell(process, folder)
            code = tomllib.loads((folder / "class.toml").read_text())["code"]
            key = json.loads(ask(f"{address}api/class/join", code=code, name="Ada"))["key"]
            ask(address)
            ask(f"{address}api/exercises", key)
        finally:
            process.kill()
            process.wait(PATIENCE_S)
    written = {path.relative_to(tmp_path).parts[0] for path in tmp_path.rglob("*") if path.is_file()}
    assert written - {"state"} == {"Class 5b", "watch", "watched"}
    # To learn this machine's own number a datagram's socket is pointed at an address for documents; nothing is sent.
    calls = watched.read_text().splitlines()
    assert any("192.0.2.1" in call for call in calls), "the watch notes calls"
    assert [call for call in calls if "192.0.2.1" not in call and "127.0.0.1" not in call] == []
    if os.name == "posix":
        assert (folder / "class.toml").stat().st_mode & 0o077 == 0


def test_pages_load_from_the_class_alone(school):
    for client in (school.teacher(), school.client()):
        policy = client.get("/").headers["content-security-policy"]
        assert "default-src 'self'" in policy
        assert "connect-src 'self'" in policy
        assert "http" not in policy


def test_a_pupil_who_is_taken_out_is_in_class_toml_no_more(school, mission):
    teacher = school.teacher()
    zoe, _ = school.join("Zoé")
    hand_in(zoe, mission)
    exercise = "example:exercises/03-square.exercise.xml"
    teacher.post("/api/class/teacher/exercise", json={"exercise": exercise})
    given = {"folder": "Zoé", "exercise": exercise, "text": "A secret comment"}
    assert teacher.post("/api/class/teacher/comment", json=given).status_code == 200
    assert "A secret comment" in (school.room.folder / "class.toml").read_text()
    teacher.post("/api/class/teacher/remove", json={"folder": "Zoé"})
    left = (school.room.folder / "class.toml").read_text()
    assert "Zoé" not in left
    assert "secret comment" not in left
    assert (school.room.folder / "Zoé" / "blink.krt").is_file()
