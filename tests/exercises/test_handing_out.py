"""What pupils get of an exercise holds nothing that is hidden, and is the same exercise otherwise."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.classroom.grader_process import shipped_exercises
from kitrobot.exercise.exercise_xml import read_exercise
from kitrobot.exercise.hidden_parts import remove_hidden_parts

GOALS = [
    "<done{}><label>{}</label></done>",
    '<uses part="Wait" {}><label>{}<!-- {} --></label></uses>',
    '<parts most="6"{}>\n  <label>{}</label><label xml:lang="fr">&lt;{}/></label></parts>',
    '<draws corners="4" side="150" {}><label><![CDATA[a > b {}]]></label></draws>',
]


def made(dice: random.Random) -> tuple[str, int]:
    """An exercise with hidden goals and seeds between others, whose words are `secret`; and how many are shown."""
    rows = ["<done><label>It ends</label></done>", '<seed value="1"/>']
    shown = 1
    for number in range(dice.randrange(8)):
        hidden = dice.random() < 0.5
        shown += not hidden
        quote = dice.choice("\"'")
        mark = f" hidden={quote}yes{quote}" if hidden else ""
        word = "secret" if hidden else "shown"
        rows.append(dice.choice(GOALS).format(mark, word, word))
        rows.append(dice.choice(["", "<!-- secret -->", "<?secret ?>", f'<seed value="{number + 10}" hidden="yes" />']))
    dice.shuffle(rows)
    text = '<exercise version="1" start="a.krt"><label>A</label>\n  ' + "\n  ".join(rows) + "\n</exercise>"
    return text, shown


@given(st.integers(0, 10**9), st.sampled_from(["utf-8", "utf-8-sig", "utf-16"]))
def test_nothing_hidden_is_left_and_all_else_is(seed, encoding):
    text, shown = made(random.Random(seed))
    before, problems = read_exercise(text.encode(encoding), "e.exercise.xml")
    assert before is not None, problems
    data = remove_hidden_parts(text.encode(encoding), "e.exercise.xml")
    after, problems = read_exercise(data, "e.exercise.xml")
    assert problems == []
    assert after is not None
    assert after == replace(before, goals=before.goals_for(hidden=False), seeds=after.seeds)
    assert [one.value for one in after.seeds] == list(before.seeds_for(hidden=False))
    assert len(after.goals) == shown
    for word in (b"secret", b"hidden", b"<!--"):
        assert word not in data


def test_an_exercise_without_anything_hidden_stays_as_it_is():
    for path in shipped_exercises():
        data = path.read_bytes()
        if b"hidden" not in data and b"<!--" not in data:
            assert remove_hidden_parts(data, path.name) == data


@pytest.mark.parametrize("data", [b"", b"<exercise", b"\xff\xfe<", b"<!DOCTYPE a><a/>", b"\xff"])
def test_what_is_no_exercise_is_refused(data):
    with pytest.raises(ValueError):
        remove_hidden_parts(data, "x")
