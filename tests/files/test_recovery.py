"""Whose journal is whose: left behind, taken over, never written by two."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from kitrobot.files.folder import MissionFolder
from kitrobot.files.journal_file import Journal, JournalError
from kitrobot.files.recovery import Journals
from tests.patience import PATIENCE_S


@pytest.fixture
def folder(tmp_path):
    root = tmp_path / "missions"
    root.mkdir()
    (root / "a.krt").write_text('<kitrobot version="1"/>')
    return MissionFolder(root)


@pytest.fixture
def journals(folder, tmp_path):
    return Journals(folder, tmp_path / "state")


def working(journals, path="a.krt", records=("base", "one"), unsaved=True):
    """A tab that has work in its journal."""
    tab = journals.join()
    claimed = journals.claim(tab, path)
    journals.replace(tab, Journal(path, path or "untitled", records, unsaved))
    return tab, claimed.journal


def test_what_a_page_left_behind_is_given_to_the_next_on_that_mission(journals):
    tab, journal = working(journals)
    journals.append(tab, 2, ["two"], True)
    journals.leave(tab)
    claimed = journals.claim(journals.join(), "a.krt")
    assert (claimed.journal, claimed.records) == (journal, ("base", "one", "two"))


def test_a_second_page_gets_a_journal_of_its_own(journals):
    _, journal = working(journals)
    second = journals.claim(journals.join(), "a.krt")
    assert second.journal != journal
    assert second.records == ()


def test_a_page_is_told_how_many_others_have_its_mission(journals):
    first, _ = working(journals)
    second = journals.join()
    assert journals.status_of(first).others == 0
    journals.claim(second, "a.krt")
    assert (journals.status_of(first).others, journals.status_of(second).others) == (1, 1)
    journals.leave(second)
    assert journals.status_of(first).others == 0


def test_pages_on_new_missions_are_strangers(journals):
    first, _ = working(journals, "")
    second, _ = working(journals, "")
    assert (journals.status_of(first).others, journals.status_of(second).others) == (0, 0)


def test_news_follow_the_file(journals, folder):
    tab, _ = working(journals)
    before = journals.status_of(tab).revision
    assert before == folder.read("a.krt")[1]
    (folder.root / "a.krt").write_text('<kitrobot version="1">  </kitrobot>')
    assert journals.status_of(tab).revision == folder.read("a.krt")[1] != before
    (folder.root / "a.krt").unlink()
    assert journals.status_of(tab).revision == ""


def test_a_new_mission_begins_empty_and_its_work_is_listed_when_it_is_left(journals):
    tab, journal = working(journals, "")
    assert journals.orphaned() == []
    journals.leave(tab)
    assert [(left.journal, left.path) for left in journals.orphaned()] == [(journal, "")]
    fresh = journals.join()
    assert journals.claim(fresh, "").records == ()
    assert journals.claim(fresh, "", journal).records == ("base", "one")


def test_saved_work_is_not_listed_but_its_history_comes_back(journals):
    tab, _ = working(journals, unsaved=False)
    journals.leave(tab)
    assert journals.orphaned() == []
    assert journals.claim(journals.join(), "a.krt").records == ("base", "one")


def test_a_journal_without_records_is_gone(journals, folder):
    tab, _ = working(journals)
    journals.replace(tab, Journal("a.krt", "a", (), False))
    assert list((folder.root / ".kitrobot" / "journal").glob("*.journal")) == []
    journals.leave(tab)
    assert journals.claim(journals.join(), "a.krt").records == ()


def test_what_is_forgotten_is_gone_and_what_is_written_stays(journals):
    tab, journal = working(journals)
    journals.discard(journal)
    journals.leave(tab)
    assert len(journals.orphaned()) == 1
    journals.discard(journal)
    assert journals.orphaned() == []


def test_records_that_do_not_follow_are_refused_and_a_whole_journal_mends_it(journals):
    tab, _ = working(journals)
    for first in (0, 1, 3):
        with pytest.raises(JournalError, match="do not follow"):
            journals.append(tab, first, ["x"], True)
    journals.replace(tab, Journal("a.krt", "a", ("base",), True))
    journals.append(tab, 1, ["x"], True)


def test_an_unknown_page_is_told_to_load_again(journals):
    for ask in (lambda: journals.claim("nobody", "a.krt"), lambda: journals.append("nobody", 0, ["x"], True)):
        with pytest.raises(JournalError) as caught:
            ask()
        assert "load the page again" in caught.value.help


def test_work_on_an_example_is_kept_in_the_state_folder_and_moves_when_it_is_saved(journals, folder, tmp_path):
    tab, journal = working(journals, "example:transport/transport.krt")
    assert not (folder.root / ".kitrobot").exists()
    assert [file.stem for file in (tmp_path / "state").rglob("*.journal")] == [journal]
    journals.replace(tab, Journal("a.krt", "a", ("base",), False))
    assert list((tmp_path / "state").rglob("*.journal")) == []
    assert [file.stem for file in (folder.root / ".kitrobot").rglob("*.journal")] == [journal]
    journals.append(tab, 1, ["x"], True)


def test_git_does_not_see_the_journals(journals, folder):
    working(journals)
    assert (folder.root / ".kitrobot" / ".gitignore").read_text() == "*\n"


def test_a_folder_that_cannot_be_written_to_has_its_journals_in_the_state_folder(folder, tmp_path, monkeypatch):
    (folder.root / ".kitrobot").write_text("in the way")
    journals = Journals(folder, tmp_path / "state")
    tab, journal = working(journals)
    journals.leave(tab)
    assert journals.claim(journals.join(), "a.krt").journal == journal


def test_another_process_on_the_same_folder_takes_nothing_that_is_being_written(journals, folder, tmp_path):
    working(journals)
    code = (
        "import sys; from pathlib import Path; from kitrobot.files.recovery import Journals\n"
        "from kitrobot.files.folder import MissionFolder\n"
        "journals = Journals(MissionFolder(Path(sys.argv[1])), Path(sys.argv[2]))\n"
        "print(len(journals.orphaned()), len(journals.claim(journals.join(), 'a.krt').records))"
    )
    command = [sys.executable, "-c", code, str(folder.root), str(tmp_path / "state")]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S, check=True)
    assert ended.stdout.split() == ["0", "0"]


def test_what_a_killed_process_was_writing_is_free_for_the_next(folder, tmp_path):
    code = (
        "import os, sys; from pathlib import Path; from kitrobot.files.journal_file import Journal\n"
        "from kitrobot.files.recovery import Journals; from kitrobot.files.folder import MissionFolder\n"
        "journals = Journals(MissionFolder(Path(sys.argv[1])), Path(sys.argv[2])); tab = journals.join()\n"
        "journals.claim(tab, 'a.krt'); journals.replace(tab, Journal('a.krt', 'a', ('base', 'one'), True))\n"
        "os.kill(os.getpid(), 9)"
    )
    command = [sys.executable, "-c", code, str(folder.root), str(tmp_path / "state")]
    subprocess.run(command, capture_output=True, timeout=PATIENCE_S, check=False)
    journals = Journals(folder, tmp_path / "state")
    assert len(journals.orphaned()) == 1
    assert journals.claim(journals.join(), "a.krt").records == ("base", "one")


def test_a_journal_damaged_in_the_middle_gives_what_is_whole_and_is_kept_aside(journals, folder):
    tab, journal = working(journals, records=("base", "one", "two"))
    journals.leave(tab)
    file = next(folder.root.rglob("*.journal"))
    whole = bytearray(file.read_bytes())
    whole[-3] ^= 1
    file.write_bytes(whole)
    claimed = journals.claim(journals.join(), "a.krt")
    assert (claimed.records, claimed.damaged) == (("base", "one"), True)
    assert file.with_suffix(".damaged").read_bytes() == whole
    assert journal == claimed.journal


def test_a_cut_journal_is_written_on_behind_what_is_whole(journals, folder):
    tab, _ = working(journals, records=("base", "one", "two"))
    journals.leave(tab)
    file = next(folder.root.rglob("*.journal"))
    file.write_bytes(file.read_bytes()[:-4])
    tab = journals.join()
    assert journals.claim(tab, "a.krt").records == ("base", "one")
    journals.append(tab, 2, ["three"], True)
    journals.leave(tab)
    assert journals.claim(journals.join(), "a.krt").records == ("base", "one", "three")


@pytest.mark.parametrize("data", [b"", b"rubbish", b"kitrobot journal 9\nlater"])
def test_files_that_are_no_journals_stand_in_nobodys_way_and_stay(journals, folder, data):
    tab, _ = working(journals)
    journals.leave(tab)
    odd = folder.root / ".kitrobot" / "journal" / "00000000000000aa.journal"
    odd.write_bytes(data)
    os.utime(odd)
    closed = [str(one.problem) for one in journals.orphaned() if one.problem]
    assert closed == (["this journal was written by a later KitRobot"] if b"journal 9" in data else [])
    assert journals.claim(journals.join(), "a.krt").records == ("base", "one")
    assert odd.read_bytes() == data
    journals.discard(odd.stem)
    assert not odd.exists()
