"""What the teacher does with some of a class: freezes them, edits with them, sees their arena."""

from __future__ import annotations

import pytest

from kitrobot.classroom import ClassError, Desk, read_record
from tests.classroom.conftest import join


def test_some_are_frozen_and_all(room, entrance):
    join(room, entrance)
    join(room, entrance, "Ben")
    desk = Desk(room)

    def frozen():
        return [room.told(one).frozen for one in room.pupils.values()]

    desk.set_frozen(True, ["Ben", "nobody"])
    assert frozen() == [False, True]
    # It outlives the process.
    kept = read_record(room.folder)
    assert kept is not None
    assert [one.frozen for one in kept.pupils] == [False, True]
    desk.set_frozen(False, ["Ben"])
    assert frozen() == [False, False]
    # Of all some go on; who comes later is not frozen then.
    desk.set_frozen(True)
    desk.set_frozen(True, ["Ada"])
    assert frozen() == [True, True]
    desk.set_frozen(False, ["Ada"])
    join(room, entrance, "Cem")
    assert frozen() == [False, True, False]
    desk.set_frozen(True)
    desk.set_frozen(False)
    assert frozen() == [False, False, False]
    assert "not frozen any more: Ada" in (room.folder / "log.txt").read_text()


def test_the_teacher_edits_only_when_the_pupil_lets_in(room, entrance):
    ada, _ = join(room, entrance)
    desk = Desk(room)
    with pytest.raises(ClassError, match="`Ada` is not here"):
        desk.ask_turn(ada)
    room.comes(ada)
    # Who was not asked lets nobody in.
    room.give_turn(ada, yes=True)
    assert room.told(ada).turn == "pupil"
    desk.ask_turn(ada)
    assert room.told(ada).turn == "asked"
    room.give_turn(ada, yes=False)
    assert room.told(ada).turn == "pupil"
    desk.ask_turn(ada)
    room.give_turn(ada, yes=True)
    assert room.told(ada).turn == "teacher"
    desk.ask_turn(ada)
    assert room.told(ada).turn == "teacher"
    desk.give_back(ada)
    assert room.told(ada).turn == "pupil"
    desk.ask_turn(ada)
    room.give_turn(ada, yes=True)
    room.give_turn(ada, yes=False)
    assert room.told(ada).turn == "pupil"


def test_what_a_page_shows_is_kept_only_while_the_teacher_looks_on(room, entrance):
    ada, _ = join(room, entrance)
    room.show_arena(ada, "{}")
    assert ada.arena == ""
    Desk(room).look_on(ada)
    room.show_arena(ada, "{}")
    assert ada.arena == "{}"
    Desk(room).look_on(None)
    assert ada.arena == ""
