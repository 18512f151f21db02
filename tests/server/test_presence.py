"""The studio of a folder is found by its user's other processes, and by nobody else."""

from __future__ import annotations

import os
import stat
import sys

import pytest

from kitrobot.server import presence as module
from kitrobot.server.presence import Presence, PresenceError, StudioInfo
from kitrobot.server.studio_server import listen

RUNNING = StudioInfo("http://127.0.0.1:1/", "secret")


@pytest.fixture
def places(tmp_path):
    made = []

    def place():
        made.append(Presence(tmp_path / "missions", tmp_path / "state"))
        return made[-1]

    yield place
    for one in made:
        one.leave()


def test_one_process_at_a_time_is_the_studio_of_a_folder(places):
    first, second = places(), places()
    assert first.acquire()
    assert not second.acquire()
    first.leave()
    assert second.acquire()


def test_one_that_does_not_answer_is_told(places, monkeypatch):
    monkeypatch.setattr(module, "_STARTS_WITHIN_S", 0)
    first = places()
    first.acquire()
    first.publish(RUNNING, 1)
    with pytest.raises(PresenceError, match="does not answer") as told:
        places().acquire_or_find()
    assert "--new" in told.value.help


def test_a_record_that_was_left_behind_is_no_studio(places):
    first = places()
    first.acquire()
    first.publish(RUNNING, 1)
    assert first._lock is not None
    os.close(first._lock.handle)  # as a kill does
    first._lock = None
    assert places().acquire_or_find() is None


def test_pages_know_the_next_studio_by_the_same_secret_at_the_same_port(places):
    first = places()
    first.acquire()
    with listen("127.0.0.1", 0) as listening:
        port = listening.getsockname()[1]
        first.publish(RUNNING, port)
        first.leave()
        assert (places().secret, places().port) == (first.secret, port)
        with listen("127.0.0.1", 0, port) as other:
            assert other.getsockname()[1] != port
    for wanted in (0, None):
        with listen("127.0.0.1", wanted, port) as again:
            assert again.getsockname()[1] == port


@pytest.mark.skipif(sys.platform == "win32", reason="modes are of POSIX")
def test_what_is_kept_is_for_the_user_alone_and_else_not_believed(places, tmp_path):
    first = places()
    first.acquire()
    first.publish(RUNNING, 1)
    page = first.write_redirect_page(f"{RUNNING.address}?token=a&open=b")
    files = [path for path in (tmp_path / "state").rglob("*") if path.is_file()]
    assert len(files) == 4
    # The lock's file says nothing.
    assert {stat.S_IMODE(path.stat().st_mode) for path in files if path.stat().st_size > 0} == {0o600}
    assert stat.S_IMODE(files[0].parent.stat().st_mode) == 0o700
    assert "url=http://127.0.0.1:1/?token=a&amp;open=b" in page.read_text()
    assert places().secret == first.secret
    page.with_name("kept").chmod(0o644)
    assert places().secret != first.secret


def test_a_folder_for_states_that_cannot_be_used_keeps_nobody_from_working(tmp_path):
    (tmp_path / "file").write_text("")
    place = Presence(tmp_path, tmp_path / "file")
    assert place.acquire_or_find() is None
    place.publish(RUNNING, 1)
    assert place.write_redirect_page("x") is None
    place.leave()
