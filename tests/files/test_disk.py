"""Files: read whole or refused with a sentence, written whole or not at all."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from kitrobot.files.disk import FileError, decode, read_bytes, read_text, same_file, write_atomic


def names(folder):
    return sorted(entry.name for entry in folder.iterdir())


def test_what_is_written_is_read(tmp_path):
    write_atomic(tmp_path / "a", b"one")
    write_atomic(tmp_path / "a", b"two")
    assert read_bytes(tmp_path / "a") == b"two"
    assert names(tmp_path) == ["a"]


def test_a_write_that_breaks_off_leaves_the_old_file_and_no_litter(tmp_path, monkeypatch):
    write_atomic(tmp_path / "a", b"old")

    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(FileError, match="no space left on device"):
        write_atomic(tmp_path / "a", b"new")
    assert read_bytes(tmp_path / "a") == b"old"
    assert names(tmp_path) == ["a"]


def test_a_write_does_not_change_the_mode_nor_replace_a_link(tmp_path):
    (tmp_path / "a").write_bytes(b"old")
    (tmp_path / "a").chmod(0o604)
    (tmp_path / "link").symlink_to("a")
    write_atomic(tmp_path / "link", b"new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "a").read_bytes() == b"new"
    assert (tmp_path / "a").stat().st_mode & 0o777 == 0o604


def test_a_new_file_has_the_usual_mode(tmp_path):
    before = os.umask(0o027)
    try:
        write_atomic(tmp_path / "a", b"")
    finally:
        os.umask(before)
    assert (tmp_path / "a").stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize("name", ["none", "none/below", ".", "a\0b", "x" * 300])
def test_what_cannot_be_read_is_a_sentence(tmp_path, name):
    with pytest.raises(FileError) as caught:
        read_bytes(tmp_path / name)
    assert caught.value.message
    assert caught.value.as_diagnostic().place is not None


@pytest.mark.parametrize("name", [".", "none/below", "a\0b", "x" * 300])
def test_what_cannot_be_written_is_a_sentence(tmp_path, name):
    with pytest.raises(FileError):
        write_atomic(tmp_path / name, b"x")
    assert names(tmp_path) == []


@pytest.mark.parametrize(
    ("data", "line", "column"),
    [(b"\xff", 1, 1), (b"ab\xff", 1, 3), (b"a\nb\n\xc3", 3, 1), ("é\né".encode() + b"\x80", 2, 2)],
)
def test_bytes_that_are_not_utf_8_have_a_place(tmp_path, data, line, column):
    with pytest.raises(FileError) as caught:
        decode(data, tmp_path / "a")
    place = caught.value.place
    assert place is not None
    assert (place.line, place.column) == (line, column)


def test_a_byte_order_mark_is_no_part_of_the_text(tmp_path):
    (tmp_path / "a").write_bytes(b"\xef\xbb\xbfx")
    assert read_text(tmp_path / "a") == "x"


def test_one_file_has_many_names(tmp_path):
    (tmp_path / "a").write_bytes(b"")
    (tmp_path / "link").symlink_to("a")
    os.link(tmp_path / "a", tmp_path / "hard")
    for name in ("a", "link", "hard", "./a"):
        assert same_file(tmp_path / "a", tmp_path / name)
    assert not same_file(tmp_path / "a", tmp_path / "b")


@pytest.mark.skipif(sys.platform == "win32", reason="files of POSIX")
def test_a_pipe_and_a_device_are_sentences_and_nobody_waits_for_them(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for path, what in ((tmp_path / "pipe", "a pipe"), (Path("/dev/zero"), "a device"), (tmp_path, "a folder")):
        with pytest.raises(FileError, match=what):
            read_bytes(path)
