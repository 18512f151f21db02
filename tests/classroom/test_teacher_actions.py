"""What the teacher does with some of a class: freezes them, edits with them, sees their arena."""

from __future__ import annotations

import pytest

from kitrobot.classroom.class_room import ClassError
from kitrobot.classroom.record import read_record
from kitrobot.classroom.teacher_actions import TeacherActions
from tests.classroom.conftest import join


def test_some_are_frozen_and_all(room, admission):
    join(room, admission)
    join(room, admission, "Ben")
    actions = TeacherActions(room)

    def frozen():
        return [room.status_of(one).frozen for one in room.pupils.values()]

    actions.set_frozen(True, ["Ben", "nobody"])
    assert frozen() == [False, True]
    # It outlives the process.
    kept = read_record(room.folder)
    assert kept is not None
    assert [one.frozen for one in kept.pupils] == [False, True]
    actions.set_frozen(False, ["Ben"])
    assert frozen() == [False, False]
    # Of all some go on; who comes later is not frozen then.
    actions.set_frozen(True)
    actions.set_frozen(True, ["Ada"])
    assert frozen() == [True, True]
    actions.set_frozen(False, ["Ada"])
    join(room, admission, "Cem")
    assert frozen() == [False, True, False]
    actions.set_frozen(True)
    actions.set_frozen(False)
    assert frozen() == [False, False, False]
    assert "not frozen any more: Ada" in (room.folder / "log.txt").read_text()


def test_the_teacher_edits_only_when_the_pupil_lets_in(room, admission):
    ada, _ = join(room, admission)
    actions = TeacherActions(room)
    with pytest.raises(ClassError, match="`Ada` is not here"):
        actions.request_turn(ada)
    room.open_page(ada)
    # Who was not asked lets nobody in.
    room.give_turn(ada, yes=True)
    assert room.status_of(ada).turn == "pupil"
    actions.request_turn(ada)
    assert room.status_of(ada).turn == "asked"
    room.give_turn(ada, yes=False)
    assert room.status_of(ada).turn == "pupil"
    actions.request_turn(ada)
    room.give_turn(ada, yes=True)
    assert room.status_of(ada).turn == "teacher"
    actions.request_turn(ada)
    assert room.status_of(ada).turn == "teacher"
    actions.return_turn(ada)
    assert room.status_of(ada).turn == "pupil"
    actions.request_turn(ada)
    room.give_turn(ada, yes=True)
    room.give_turn(ada, yes=False)
    assert room.status_of(ada).turn == "pupil"


def test_what_a_page_shows_is_kept_only_while_the_teacher_looks_on(room, admission):
    ada, _ = join(room, admission)
    room.show_arena(ada, "{}")
    assert ada.arena == ""
    TeacherActions(room).view_pupil(ada)
    room.show_arena(ada, "{}")
    assert ada.arena == "{}"
    TeacherActions(room).view_pupil(None)
    assert ada.arena == ""


def test_a_comment_stays_with_its_exercise_and_the_pupil_is_told(room, admission):
    join(room, admission)
    ada = room.pupils["Ada"]
    actions = TeacherActions(room)
    with pytest.raises(ClassError):
        actions.comment(ada, "square", "", "Good")
    with pytest.raises(ClassError):
        actions.comment(ada, "", "", "Good")
    actions.set_exercise("square")
    actions.comment(ada, "square", "A square", " =Good\n\twork " + "x" * 600)
    assert room.status_of(ada).comments == {"square": ("=Good work " + "x" * 600)[:500]}
    # Another exercise has its own, and what was written before stays and can be changed.
    actions.set_exercise("line")
    actions.comment(ada, "line", "", "Straight")
    actions.comment(ada, "square", "", "Round")
    assert room.status_of(ada).comments == {"square": "Round", "line": "Straight"}
    found = read_record(room.folder)
    assert found is not None
    assert [(one.label, one.comment, one.points) for one in found.pupils[0].marks] == [
        ("A square", "Round", None),
        ("line", "Straight", None),
    ]
    actions.comment(ada, "line", "", "  ")
    assert room.status_of(ada).comments == {"square": "Round"}
