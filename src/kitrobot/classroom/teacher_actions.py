"""Actions of the teacher: add and remove pupils, change the code, freeze, hand out, send notes, view a pupil's work."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from typing import Final

from kitrobot.classroom.admission import NameTakenError
from kitrobot.classroom.class_room import STUDIOS, ClassError, ClassRoom
from kitrobot.classroom.marks import LONGEST_COMMENT, Mark, find_mark, put_mark
from kitrobot.classroom.names import clean_name, new_code, work_name
from kitrobot.classroom.pupil import Pupil
from kitrobot.files.disk import write_atomic
from kitrobot.files.folder import HANDED_OUT
from kitrobot.text.sentences import Sentence

LONGEST_NOTE: Final = 500


class TeacherActions:
    """The actions of a class's teacher. Safe to use from many threads."""

    def __init__(self, room: ClassRoom) -> None:
        self._room = room

    def add(self, name: str) -> Pupil:
        """A pupil who comes later, with the word.

        Raises:
            NameTakenError: there is one of that name.
        """
        with self._room.lock:
            name = clean_name(name)
            if self._room.find_pupil(name) is not None:
                raise NameTakenError(Sentence("`{name}` is in this class already", name), "")
            return self._room.add_pupil(name, "")

    def remove(self, *pupils: Pupil) -> None:
        """Nobody comes in as these pupils any more; their folders stay, but for those in which there is nothing."""
        with self._room.lock:
            gone = {pupil.folder for pupil in pupils}
            for pupil in pupils:
                self._room.pupils.pop(pupil.folder, None)
                pupil.record.keys = []
            self._room.record.pupils = [one for one in self._room.record.pupils if one.folder not in gone]
            self._room.notify(kept=True)
            for pupil in pupils:
                # Who has the same name next would get the studio with the folder.
                if not (self._room.folder / STUDIOS / pupil.folder).exists():
                    with suppress(OSError):
                        (self._room.folder / pupil.folder).rmdir()
                self._room.log.write(f"{pupil.record.name} was taken out of the class; what is in {pupil.folder} stays")

    def remove_idle(self) -> int:
        """Takes those out of the class who came in, handed nothing in and are not here; gives how many."""
        with self._room.lock:
            idle = [one for one in self._room.pupils.values() if one.record.keys and one.pages == 0 and one.work == ""]
            if idle:
                self.remove(*idle)
            self._room.newcomers.clear()
            return len(idle)

    def set_places(self, places: int) -> None:
        """The class takes so many pupils from now on."""
        with self._room.lock:
            self._room.record.places = places
            self._room.newcomers.clear()
            self._room.notify(kept=True)
            self._room.log.write(f"the class has room for {places} pupils")

    def set_code(self, on: bool) -> None:
        """A new code; or none, and nobody can join. Who is in stays in."""
        with self._room.lock:
            self._room.record.code = new_code() if on else ""
            self._room.newcomers.clear()
            self._room.notify(kept=True)
            self._room.log.write("the class has a new code" if on else "the code was revoked")

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
                self._room.log.write("everybody was frozen" if on else "everybody goes on")
            else:
                if record.frozen and not on:
                    record.frozen = False
                    for one in record.pupils:
                        one.frozen = True
                chosen = [one for one in record.pupils if one.folder in who]
                for one in chosen:
                    one.frozen = on and not record.frozen
                names = ", ".join(one.name for one in chosen)
                self._room.log.write(f"{'frozen' if on else 'not frozen any more'}: {names}")
            self._room.notify(kept=True)

    def set_exercise(self, name: str) -> None:
        """The exercise of the class from now on; "" for none."""
        with self._room.lock:
            self._room.record.exercise = name
            self._room.notify(kept=True)
            self._room.log.write(f"the exercise is {name}" if name else "there is no exercise")

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
            self._room.notify(kept=True)
            self._room.log.write(f"{name} was handed out to {len(chosen)}")
            return name, len(chosen)

    def send_note(self, pupil: Pupil, text: str) -> None:
        """A few words for one pupil."""
        with self._room.lock:
            pupil.record.note += 1
            pupil.record.note_text = " ".join(text.split())[:LONGEST_NOTE]
            self._room.notify(kept=True)

    def comment(self, pupil: Pupil, exercise: str, label: str, text: str) -> None:
        """Writes a line on the pupil's work of an exercise, which stays; "" takes it back.

        Args:
            pupil: who.
            exercise: the exercise of the class, or one that the pupil has a mark of.
            label: what it is called, in English; "" where that is not known.
            text: the line.

        Raises:
            ClassError: it is neither.
        """
        with self._room.lock:
            before = find_mark(pupil.record.marks, exercise)
            if before is None and (not exercise or exercise != self._room.record.exercise):
                raise ClassError(Sentence("the class has another exercise by now"), Sentence("write it once more"))
            mark = before or Mark(exercise, label or exercise)
            comment = " ".join(text.split())[:LONGEST_COMMENT]
            pupil.record.marks = put_mark(pupil.record.marks, replace(mark, comment=comment))
            self._room.notify(kept=True)

    def request_turn(self, pupil: Pupil) -> None:
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
                self._room.notify()

    def return_turn(self, pupil: Pupil) -> None:
        """The pupil edits again, and gets what the teacher saved; also: it is not asked for any more."""
        with self._room.lock:
            if pupil.turn != "pupil":
                pupil.turn = "pupil"
                self._room.notify()

    def view_pupil(self, pupil: Pupil | None) -> None:
        """The teacher looks on, or at nobody."""
        with self._room.lock:
            looked = "" if pupil is None else pupil.folder
            if looked != self._room.looked:
                for one in self._room.pupils.values():
                    one.arena = ""
                self._room.looked = looked
                self._room.notify()
