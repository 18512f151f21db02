"""A lock of the system: one has it, whoever that is; a folder that knows no locks is told from one that is busy."""

from __future__ import annotations

import errno
import subprocess
import sys
import threading

import pytest

from kitrobot.diagnostics.regular import lock_handle
from kitrobot.files import disk, file_lock
from kitrobot.files.disk import LOCK_NAME, FileError, replace_file, saving_in, sweep, write_atomic
from kitrobot.files.file_lock import FileLock
from kitrobot.files.folder import MissionFolder
from kitrobot.files.layout import lay_out_file
from tests.patience import PATIENCE_S


@pytest.fixture
def no_locks(monkeypatch):
    """A file system that knows no locks."""

    def none(handle: int) -> bool:
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(file_lock, "lock_handle", none)


def test_one_has_it_and_when_it_is_given_back_nothing_is_left(tmp_path):
    lock = FileLock.take(tmp_path / "lock")
    assert lock is not None
    assert FileLock.take(tmp_path / "lock") is None
    lock.release()
    assert list(tmp_path.iterdir()) == []
    assert FileLock.take(tmp_path / "lock") is not None


def test_a_lock_on_a_file_that_was_removed_meanwhile_is_no_lock(tmp_path, monkeypatch):
    path = tmp_path / "lock"
    right = lock_handle
    passed: list[int] = []

    def late(handle: int) -> bool:
        if not passed:
            passed.append(handle)
            path.unlink()  # as the one who had it does before we lock what is gone
        return right(handle)

    monkeypatch.setattr(file_lock, "lock_handle", late)
    lock = FileLock.take(path)
    assert lock is not None
    assert FileLock.take(path) is None


def test_many_threads_have_it_one_after_the_other(tmp_path):
    inside, most = [], []

    def work() -> None:
        for _ in range(20):
            with saving_in(tmp_path / "a"):
                inside.append(1)
                most.append(len(inside))
                inside.pop()

    threads = [threading.Thread(target=work) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert set(most) == {1}


def test_who_waits_too_long_is_told(tmp_path, monkeypatch):
    monkeypatch.setattr(disk, "LONGEST_WAIT_S", 0.0)
    with saving_in(tmp_path / "a"), pytest.raises(FileError, match="another KitRobot"):
        write_atomic(tmp_path / "b", b"")
    write_atomic(tmp_path / "b", b"")


def test_where_there_are_no_locks_files_are_written_all_the_same_and_that_is_known(tmp_path, no_locks):
    write_atomic(tmp_path / "a.krt", b"one")
    hold = MissionFolder(tmp_path).hold("a.krt", MissionFolder(tmp_path).read("a.krt")[1])
    with hold as path:
        replace_file(path, b"two")
    assert not hold.alone
    assert not FileLock.is_possible(tmp_path)
    assert (tmp_path / "a.krt").read_bytes() == b"two"


def test_a_text_that_was_changed_since_it_was_read_is_not_written_over(tmp_path):
    path = tmp_path / "a.lll"
    path.write_text("Motor.Stop( ) ;")
    layout = lay_out_file(path)
    path.write_text("Motor.Stop();Motor.Stop();")
    with pytest.raises(FileError, match="changed by somebody else"):
        layout.write()
    assert path.read_text() == "Motor.Stop();Motor.Stop();"


KILLED = """
import os, sys
from pathlib import Path
os.replace = lambda *_: os.kill(os.getpid(), 9)
if sys.argv[2] == "mission":
    from kitrobot.mission.model import Mission; from kitrobot.mission.writer import save
    save(Path(sys.argv[1]), Mission())
else:
    from kitrobot.files.disk import write_atomic
    write_atomic(Path(sys.argv[1]), b"new")
"""


@pytest.mark.parametrize("kind", ["mission", "file"])
@pytest.mark.parametrize("name", ["a.krt", "x" * 200 + ".krt"])
def test_what_a_killed_save_left_is_swept_up_but_never_while_somebody_saves(tmp_path, kind, name):
    path = tmp_path / "inner" / name
    path.parent.mkdir()
    path.write_bytes(b"old")
    others = {".a.krt.12345678.part", ".notes", "a.kitrobot-part"}
    for other in others:
        (path.parent / other).write_bytes(b"theirs")
    subprocess.run([sys.executable, "-c", KILLED, str(path), kind], timeout=PATIENCE_S, check=False)
    left = {entry.name for entry in path.parent.iterdir()} - others - {name, LOCK_NAME}
    assert left
    with saving_in(path):
        assert sweep(path.parent) == 0
    assert MissionFolder(tmp_path).sweep() == len(left)
    assert {entry.name for entry in path.parent.iterdir()} == others | {name}
    assert path.read_bytes() == b"old"
