"""`kitrobot merge`: alone, and as the merge driver of git."""

from __future__ import annotations

import shutil
import subprocess
import sys

import pytest

from tests.cli.test_diff import MISSION
from tests.patience import PATIENCE_S

SLOW = MISSION.replace(">50<", ">10<")
FAST = MISSION.replace(">50<", ">90<")
LONG = MISSION.replace(">5<", ">70<")


@pytest.fixture
def merge(kitrobot, here):
    def call(base, ours, theirs, *options):
        for name, text in (("base", base), ("ours", ours), ("theirs", theirs)):
            (here / f"{name}.krt").write_text(text, encoding="utf-8")
        return kitrobot("merge", "base.krt", "ours.krt", "theirs.krt", *options)

    return call


def test_edits_of_different_instructions_both_stand(merge, here):
    said = merge(MISSION, SLOW, LONG)
    assert (said.status, said.out, said.err) == (0, "", "")
    assert (here / "ours.krt").read_text() == SLOW.replace(">5<", ">70<")


def test_the_result_can_go_elsewhere(merge, here):
    assert merge(MISSION, SLOW, LONG, "-o", "out.krt").status == 0
    assert (here / "ours.krt").read_text() == SLOW
    assert (here / "out.krt").read_text() == SLOW.replace(">5<", ">70<")


def test_a_conflict_keeps_ours_and_is_a_sentence(merge, here):
    said = merge(MISSION, SLOW, FAST)
    assert said.status == 1
    assert said.err == "conflict: p: the speed of Wheel.Advance (v3) was changed in both: ours is kept\n"
    assert (here / "ours.krt").read_text() == SLOW


@pytest.mark.parametrize(
    "text", ["<kitrobot", "rubbish", MISSION.replace('version="1"', 'version="99"'), MISSION[:-40]]
)
@pytest.mark.parametrize("place", [0, 1, 2])
def test_a_file_that_cannot_be_used_is_trouble_and_nothing_is_written(merge, here, text, place):
    texts = [MISSION, SLOW, LONG]
    texts[place] = text
    said = merge(*texts)
    assert said.status == 2
    assert "error" in said.err
    assert (here / "ours.krt").read_text() == texts[1]


def test_an_empty_base_is_none(merge, here):
    assert merge("", MISSION, MISSION).status == 0
    assert (here / "ours.krt").read_text() == MISSION


def test_a_missing_file_is_trouble(kitrobot, here):
    assert kitrobot("merge", "a.krt", "b.krt", "c.krt").status == 2
    assert list(here.iterdir()) == []


@pytest.mark.skipif(shutil.which("git") is None, reason="needs git")
def test_git_merges_two_branches_with_it(here):
    def git(*arguments):
        names = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"]
        return subprocess.run(["git", *names, *arguments], cwd=here, capture_output=True, text=True, timeout=PATIENCE_S)

    def commit(text):
        (here / "p.krt").write_text(text)
        assert git("add", ".").returncode == 0
        assert git("commit", "-m", "x").returncode == 0

    git("init", "-b", "main")
    git("config", "merge.kitrobot.driver", f'"{sys.executable}" -m kitrobot merge %O %A %B')
    (here / ".gitattributes").write_text("*.krt merge=kitrobot\n")
    commit(MISSION)
    git("checkout", "-b", "theirs")
    commit(LONG)
    git("checkout", "main")
    commit(MISSION.replace('<set name="speed">50</set><note>slowly</note>', '<set name="speed">10</set>'))
    merged = git("merge", "theirs")
    assert merged.returncode == 0, merged.stdout + merged.stderr
    text = (here / "p.krt").read_text()
    assert ">70<" in text
    assert ">10<" in text
