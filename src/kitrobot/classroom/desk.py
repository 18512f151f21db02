"""What the teacher does with a class: lets nobody in, freezes, hands out, writes, looks on."""

from __future__ import annotations

from typing import Final

from kitrobot.classroom.entrance import TakenNameError
from kitrobot.classroom.names import clean_name, new_code, work_name
from kitrobot.classroom.pupil import Pupil
from kitrobot.classroom.room import ClassError, ClassRoom
from kitrobot.files import HANDED_OUT, write_atomic
from kitrobot.text import Sentence

LONGEST_NOTE: Final = 500


class Desk:
    """The teacher's desk. Safe to use from many threads."""

    def __init__(self, room: ClassRoom) -> None:
        self._room = room

    def add(self, name: str) -> Pupil:
        """A pupil who comes later, with the word.

        Raises:
            TakenNameError: there is one of that name.
        """
        with self._room.lock:
            name = clean_name(name)
            if self._room.named(name) is not None:
                raise TakenNameError(Sentence("`{name}` is in this class already", name), "")
            return self._room.enter(name, "")

    def remove(self, pupil: Pupil) -> None:
        """Nobody comes in as this pupil any more; the folder stays."""
        with self._room.lock:
            self._room.pupils.pop(pupil.folder, None)
            pupil.record.keys = []
            self._room.record.pupils = [one for one in self._room.record.pupils if one is not pupil.record]
            self._room.changed(kept=True)
            self._room.log.say(f"{pupil.record.name} was taken out of the class; the folder {pupil.folder} stays")

    def set_code(self, on: bool) -> None:
        """A new code; or none, and nobody can join. Who is in stays in."""
        with self._room.lock:
            self._room.record.code = new_code() if on else ""
            self._room.changed(kept=True)
            self._room.log.say("the class has a new code" if on else "the code was revoked")

    def set_frozen(self, on: bool, who: list[str] | None = None) -> None:
        """Those pupils, or everybody, are to look up, or go on.

        Where everybody is frozen and some are to go on, the others stay frozen; who comes later is not.
        """
        with self._room.lock:
            record = self._room.record
            if who is None:
                record.frozen = on
                for one in record.pupils:
                    one.frozen = False
                self._room.log.say("everybody was frozen" if on else "everybody goes on")
            else:
                if record.frozen and not on:
                    record.frozen = False
                    for one in record.pupils:
                        one.frozen = True
                chosen = [one for one in record.pupils if one.folder in who]
                for one in chosen:
                    one.frozen = on and not record.frozen
                names = ", ".join(one.name for one in chosen)
                self._room.log.say(f"{'frozen' if on else 'not frozen any more'}: {names}")
            self._room.changed(kept=True)

    def set_exercise(self, name: str) -> None:
        """The exercise of the class from now on; "" for none."""
        with self._room.lock:
            self._room.record.exercise = name
            self._room.changed(kept=True)
            self._room.log.say(f"the exercise is {name}" if name else "there is no exercise")

    def hand_out(self, shown: str, data: bytes, to: list[str] | None = None) -> tuple[str, int]:
        """Gives a mission to those pupils, or to all; gives its name and to how many.

        Raises:
            FileError: it cannot be written.
        """
        with self._room.lock:
            folder = self._room.folder / HANDED_OUT
            folder.mkdir(exist_ok=True)
            name = work_name(shown)
            write_atomic(folder / f"{name}.krt", data)
            number = max((one.handed for one in self._room.record.pupils), default=0) + 1
            chosen = [one for one in self._room.record.pupils if to is None or one.folder in to]
            for record in chosen:
                record.handed, record.handed_file = number, name
            self._room.changed(kept=True)
            self._room.log.say(f"{name} was handed out to {len(chosen)}")
            return name, len(chosen)

    def write_to(self, pupil: Pupil, text: str) -> None:
        """A few words for one pupil."""
        with self._room.lock:
            pupil.note = (pupil.note[0] + 1, " ".join(text.split())[:LONGEST_NOTE])
            self._room.changed()

    def ask_turn(self, pupil: Pupil) -> None:
        """Asks a pupil to let the teacher edit.

        Raises:
            ClassError: no page of the pupil is open.
        """
        with self._room.lock:
            if pupil.pages == 0:
                raise ClassError(
                    Sentence("`{name}` is not here", pupil.record.name),
                    Sentence("open a copy in the studio: that changes nothing"),
                )
            if pupil.turn == "pupil":
                pupil.turn = "asked"
                self._room.changed()

    def give_back(self, pupil: Pupil) -> None:
        """The pupil edits again, and gets what the teacher saved; also: it is not asked for any more."""
        with self._room.lock:
            if pupil.turn != "pupil":
                pupil.turn = "pupil"
                self._room.changed()

    def look_on(self, pupil: Pupil | None) -> None:
        """The teacher looks on, or at nobody."""
        with self._room.lock:
            looked = "" if pupil is None else pupil.folder
            if looked != self._room.looked:
                for one in self._room.pupils.values():
                    one.arena = ""
                self._room.looked = looked
                self._room.changed()
