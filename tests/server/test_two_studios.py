"""Two studios on one folder, each a process of its own: whoever was told that a save is done finds it in the file."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import httpx
import pytest

from tests.effort import THOROUGH, cases
from tests.patience import PATIENCE_S
from tests.server.conftest import SHORT

ROUNDS = 40 if THOROUGH else 4


@contextlib.contextmanager
def studio(folder: Path, state: Path) -> Iterator[httpx.Client]:
    """A client of a studio that runs in a process of its own."""
    command = [sys.executable, "-m", "kitrobot", "studio", str(folder), "--no-browser", "--port", "0", "--new"]
    env = {**os.environ, "KITROBOT_STATE": str(state)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=env) as process:
        assert process.stdout is not None
        try:
            address, _, token = process.stdout.readline().strip().partition("/?token=")
            headers = {"X-KitRobot-Token": token}
            with httpx.Client(base_url=address, headers=headers, trust_env=False, timeout=PATIENCE_S) as client:
                yield client
        finally:
            process.kill()


@pytest.mark.parametrize("paths", cases([("missions", "missions")], [("missions", ".")]), ids=":".join)
def test_of_saves_that_race_none_is_lost_that_was_answered_as_done(tmp_path: Path, paths: tuple[str, str]) -> None:
    mission = tmp_path / "missions" / "blink.krt"
    mission.parent.mkdir()
    mission.write_text(SHORT)
    together = threading.Barrier(2, timeout=PATIENCE_S)

    def work(client: httpx.Client, path: str, who: int) -> list[str]:
        try:
            return saved(client, path, who)
        except BaseException:
            together.abort()  # the other one does not wait for us
            raise

    def saved(client: httpx.Client, path: str, who: int) -> list[str]:
        done = []
        for number in range(ROUNDS):
            name = f"agent-{who}-{number}"
            together.wait()
            file = client.get("/api/mission", params={"path": path}).json()
            file["mission"]["agents"].append({"name": name, "program": "blink", "start": ""})
            sent = {"path": path, "revision": file["revision"], "mission": file["mission"]}
            answer = client.put("/api/mission", json=sent)
            assert answer.status_code in (200, 409), answer.text
            if answer.status_code == 200:
                assert answer.json()["locked"]
                done.append(name)
        return done

    state = tmp_path / "state"
    with contextlib.ExitStack() as both, ThreadPoolExecutor(2) as pool:
        jobs, addresses = [], set()
        for who, path in enumerate(paths):
            folder = tmp_path / path
            client = both.enter_context(studio(folder, state))
            addresses.add(client.base_url)
            jobs.append(pool.submit(work, client, mission.relative_to(folder).as_posix(), who))
        assert len(addresses) == 2, "with --new a studio is another one, on the same folder too"
        done = [name for job in jobs for name in job.result()]
    text = mission.read_text()
    lost = [name for name in done if f'"{name}"' not in text]
    assert len(done) >= ROUNDS, "in each round one of the two saves"
    assert lost == []
    assert sorted(entry.name for entry in mission.parent.iterdir()) == ["blink.krt", "blink.krt~"]
