"""The journal on disk: whatever is cut off or bent, what comes back is the beginning of what was written."""

from __future__ import annotations

import json
import os
import zlib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.files import journal_file
from kitrobot.files.disk import LARGEST_FILE_BYTES, FileError
from kitrobot.files.journal_file import FORMAT, Journal, JournalError, append_records, read_journal, write_journal
from tests.effort import examples

RECORDS = ("first", "зwei ☂", '{"kind":"do"}', "", "x" * 300)


@pytest.fixture
def file(tmp_path):
    return tmp_path / "0123456789abcdef.journal"


def append(file, records, first):
    return append_records(file, first, Journal("a.krt", "a", tuple(records), True))


def written(file, *batches):
    write_journal(file, Journal("a.krt", "a", tuple(batches[0]), True))
    count = len(batches[0])
    for batch in batches[1:]:
        append(file, batch, count)
        count += len(batch)
    return file.read_bytes()


def found(file):
    journal_file = read_journal(file)
    assert journal_file is not None
    return journal_file


def test_what_is_written_and_appended_is_read(file):
    written(file, RECORDS[:2], RECORDS[2:3], RECORDS[3:])
    assert read_journal(file) == Journal("a.krt", "a", RECORDS, True)


@settings(max_examples=examples(5))
@given(st.lists(st.text(max_size=12), min_size=1, max_size=4))
def test_cut_at_any_byte_the_first_records_come_back_and_nothing_else(tmp_path_factory, records):
    file = tmp_path_factory.mktemp("cut") / "0123456789abcdef.journal"
    whole = written(file, records[:1], records[1:]) if len(records) > 1 else written(file, records)
    seen = set()
    for end in range(len(whole) + 1):
        file.write_bytes(whole[:end])
        journal_file = read_journal(file)
        if journal_file is not None:
            assert journal_file.records == tuple(records[: len(journal_file.records)])
            assert not journal_file.damaged
            seen.add(len(journal_file.records))
    assert seen == set(range(len(records) + 1))


@given(st.data())
def test_a_bent_byte_costs_one_record_and_is_noticed(tmp_path_factory, data):
    file = tmp_path_factory.mktemp("bent") / "0123456789abcdef.journal"
    whole = bytearray(written(file, RECORDS))
    at = data.draw(st.integers(0, len(whole) - 1))
    whole[at] ^= data.draw(st.integers(1, 255))
    file.write_bytes(whole)
    journal_file = found(file)
    assert (journal_file.path, journal_file.name) == ("a.krt", "a")
    assert journal_file.cut
    expected = [(one, journal_file.records[number]) for number, one in enumerate(RECORDS[: len(journal_file.records)])]
    assert sum(one != there for one, there in expected) + len(RECORDS) - len(journal_file.records) <= 1
    assert all(there in (one, "") for one, there in expected)


def frames(data):
    """Where the frames begin and end."""
    at = len(FORMAT)
    while at < len(data):
        end = at + 8 + int.from_bytes(data[at : at + 4], "big")
        yield at, end
        at = end


@given(st.lists(st.text(min_size=1, max_size=40), min_size=1, max_size=12), st.data())
def test_damages_cost_at_most_the_records_that_they_touch(tmp_path_factory, records, data):
    """Anywhere, of any length, several of them: noise, zeros, or bytes that are missing or too many."""
    file = tmp_path_factory.mktemp("damaged") / "0123456789abcdef.journal"
    whole = written(file, records[:1], records[1:]) if len(records) > 1 else written(file, records)
    touched, bent, most = set(), whole, len(whole)
    places = st.tuples(st.integers(0, len(whole) - 1), st.integers(1, 200))
    for begin, length in sorted(data.draw(st.lists(places, min_size=1, max_size=3)), reverse=True):
        length, most = min(length, most - begin), begin
        noise = data.draw(st.one_of(st.binary(min_size=length, max_size=length), st.just(bytes(length)), st.binary()))
        bent = bent[:begin] + noise + bent[begin + length :]
        touched |= {at for at, (one, end) in enumerate(frames(whole)) if one < begin + length and begin < end}
    file.write_bytes(bent)
    journal_file = read_journal(file)
    untouched = {number - 1: records[number - 1] for number in range(1, len(records) + 1) if number not in touched}
    if journal_file is None:
        assert not untouched
        return
    assert {number: journal_file.records[number] for number in untouched} == untouched
    assert all(there in (one, "") for one, there in zip(records, journal_file.records, strict=False))
    assert journal_file.path == "a.krt" or not untouched
    if bent != whole and journal_file.records != tuple(records):
        assert journal_file.cut


def test_without_its_beginning_a_journal_has_all_its_records(file):
    whole = written(file, RECORDS[:2], RECORDS[2:])
    begins = next(frames(whole))[1]
    file.write_bytes(b"\0" * begins + whole[begins:])
    assert found(file) == Journal("a.krt", "a", RECORDS, True, cut=True, damaged=True)


@pytest.mark.parametrize("tail", [b"\0" * 5000, b"\0" * 3, b"\xff" * 5000])
def test_a_tail_that_was_never_written_costs_nothing(file, tail):
    file.write_bytes(written(file, RECORDS) + tail)
    assert (found(file).records, found(file).cut) == (RECORDS, True)


@pytest.mark.parametrize("record", ["x" * 11_000_000, "é" * 5_500_000, "\ud800", "\0" * 1_000_000])
def test_what_is_taken_comes_back_however_large_or_odd(file, record):
    written(file, [record], [record])
    assert found(file).records == (record, record)


def test_a_record_at_the_limit_comes_back_and_one_over_it_is_refused_before_anything_is_written(file, monkeypatch):
    monkeypatch.setattr(journal_file, "LARGEST_RECORD_BYTES", 1000)
    whole = written(file, ["base"])
    room = 1000 - len(
        json.dumps({"format": 1, "path": "a.krt", "name": "a", "unsaved": True, "number": 1, "record": ""})
    )
    for write in (lambda one: append(file, [one], 1), lambda one: written(file, ["base", one])):
        with pytest.raises(JournalError, match="too large") as caught:
            write("x" * (room + 1))
        assert "save" in caught.value.help
        assert file.read_bytes() == whole
        write("x" * room)
        assert found(file).records == ("base", "x" * room)
        file.write_bytes(whole)


def test_a_journal_that_would_be_too_large_to_be_read_is_refused(file, monkeypatch):
    whole = written(file, ["base"])
    monkeypatch.setattr(journal_file, "LARGEST_JOURNAL_BYTES", len(whole) + 50)
    for write in (lambda one: append(file, [one], 1), lambda one: written(file, ["base", one])):
        with pytest.raises(JournalError, match="full"):
            write("".join(map(chr, range(300))))
        assert file.read_bytes() == whole
    assert journal_file.LARGEST_JOURNAL_BYTES <= LARGEST_FILE_BYTES


def test_a_version_that_is_only_damaged_is_not_taken_for_a_later_one(file):
    file.write_bytes(written(file, RECORDS).replace(FORMAT, FORMAT.replace(b"1", b"9"), 1))
    assert found(file).records == RECORDS


def test_bytes_that_look_like_many_frames_are_given_up_soon(file):
    length = 400_000
    file.write_bytes(FORMAT + (length.to_bytes(4, "big") + b"sums" + b"\x78\x01") * 100_000)
    assert read_journal(file) is None


def test_frames_in_another_order_are_not_believed(file):
    written(file, RECORDS)
    written_again = file.read_bytes()
    write_journal(file, Journal("a.krt", "a", (), True))
    head = file.read_bytes()
    file.write_bytes(head + written_again[len(head) :][::-1])
    assert found(file).records == ()
    append(file, ["a"], 0)
    file.write_bytes(head)
    append(file, ["b"], 1)
    assert found(file).records == ("", "b")
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
        append(file, ["more"], len(RECORDS))
    assert file.read_bytes() == whole
