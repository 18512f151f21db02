"""The journal on disk: whatever is cut off or bent, what comes back is the beginning of what was written."""

from __future__ import annotations

import os
import zlib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.workspace import FileError, Journal, JournalError, read_journal, write_journal
from kitrobot.workspace.journal import FORMAT, append_records

RECORDS = ("first", "зwei ☂", '{"kind":"do"}', "", "x" * 300)


@pytest.fixture
def file(tmp_path):
    return tmp_path / "0123456789abcdef.journal"


def written(file, *batches):
    write_journal(file, Journal("a.krt", "a", tuple(batches[0]), True))
    count = len(batches[0])
    for batch in batches[1:]:
        append_records(file, batch, count, True)
        count += len(batch)
    return file.read_bytes()


def found(file):
    journal = read_journal(file)
    assert journal is not None
    return journal


def test_what_is_written_and_appended_is_read(file):
    written(file, RECORDS[:2], RECORDS[2:3], RECORDS[3:])
    assert read_journal(file) == Journal("a.krt", "a", RECORDS, True)


@settings(max_examples=20)
@given(st.lists(st.text(max_size=30), min_size=1, max_size=6), st.data())
def test_cut_at_any_byte_the_first_records_come_back_and_nothing_else(tmp_path_factory, records, data):
    file = tmp_path_factory.mktemp("cut") / "0123456789abcdef.journal"
    whole = written(file, records[:1], records[1:]) if len(records) > 1 else written(file, records)
    seen = set()
    for end in range(len(whole) + 1):
        file.write_bytes(whole[:end])
        journal = read_journal(file)
        if journal is not None:
            assert journal.records == tuple(records[: len(journal.records)])
            assert not journal.damaged
            seen.add(len(journal.records))
    assert seen == set(range(len(records) + 1))


@given(st.data())
def test_a_bent_byte_leaves_the_records_before_it_and_is_noticed(tmp_path_factory, data):
    file = tmp_path_factory.mktemp("bent") / "0123456789abcdef.journal"
    whole = bytearray(written(file, RECORDS))
    at = data.draw(st.integers(len(FORMAT), len(whole) - 1))
    whole[at] ^= data.draw(st.integers(1, 255))
    file.write_bytes(whole)
    journal = read_journal(file)
    if journal is not None:
        assert journal.records == RECORDS[: len(journal.records)]
        assert len(journal.records) < len(RECORDS)


def test_frames_in_another_order_are_not_believed(file):
    written(file, RECORDS)
    written_again = file.read_bytes()
    write_journal(file, Journal("a.krt", "a", (), True))
    head = file.read_bytes()
    file.write_bytes(head + written_again[len(head) :][::-1])
    assert found(file).records == ()
    append_records(file, ["a"], 0, True)
    file.write_bytes(head)
    append_records(file, ["b"], 1, True)
    assert found(file).records == ()
    assert found(file).damaged


@pytest.mark.parametrize("data", [b"", b"k", FORMAT, FORMAT + b"\0" * 30, b"GIF89a", b"\xff" * 100, FORMAT[:-1]])
def test_what_is_no_journal_is_none(file, data):
    file.write_bytes(data)
    assert read_journal(file) is None


def test_a_journal_of_a_later_version_is_told_and_left_alone(file):
    file.write_bytes(FORMAT.replace(b"1", b"2") + b"whatever")
    with pytest.raises(JournalError, match="later KitRobot"):
        read_journal(file)


def test_a_frame_that_unpacks_to_far_too_much_is_not_unpacked(file):
    write_journal(file, Journal("a.krt", "a", (), True))
    bomb = zlib.compress(b" " * 100_000_000, 9)
    file.write_bytes(file.read_bytes() + len(bomb).to_bytes(4, "big") + zlib.crc32(bomb).to_bytes(4, "big") + bomb)
    assert found(file).records == ()


@pytest.mark.skipif(os.name != "posix", reason="needs limits of the system")
def test_a_full_disk_leaves_the_journal_as_it_was(file, monkeypatch):
    whole = written(file, RECORDS)

    def full(handle):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(FileError, match="no space left"):
        append_records(file, ["more"], len(RECORDS), True)
    assert file.read_bytes() == whole
