"""Admission to a class: with its code, with the pupil's word, or by the teacher's consent; guesses are limited."""

from __future__ import annotations

import hmac
import secrets
from dataclasses import dataclass
from typing import Final

from kitrobot.classroom.class_room import ClassError, ClassRoom
from kitrobot.classroom.names import clean_code, clean_name
from kitrobot.classroom.pupil import Pupil
from kitrobot.classroom.rate_limits import GuessLimit, RateLimits
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

WORDS_A_MINUTE: Final = 10
"""Wrong words of one pupil, from one address."""
MOST_ASKING: Final = 20
ASKING_S: Final = 15 * 60
"""Seconds after which a request for the teacher's consent expires."""


class AdmissionRefusedError(KitRobotError):
    """A wrong code, word or key, or too many of them."""


class NameTakenError(KitRobotError):
    """A pupil of that name is in the class: it may be the same one at another computer."""


@dataclass
class _Request:
    """A request to join again as that pupil; `yes` is the teacher's answer, `key` the key that was made for it."""

    pupil: str
    at: float
    yes: bool | None = None
    key: str = ""


class Admission:
    """Lets pupils into a class. Safe to use from many threads."""

    def __init__(self, room: ClassRoom) -> None:
        self._room = room
        self._guesses = GuessLimit()
        self._words = RateLimits(WORDS_A_MINUTE / 60, WORDS_A_MINUTE)
        self._requests: dict[str, _Request] = {}

    def join(self, code: str, name: str, word: str, who: str) -> tuple[Pupil, str]:
        """Lets a pupil in, new or with the word from another computer; gives the key for the browser.

        Args:
            code: the code of the class.
            name: as the pupil typed it.
            word: the pupil's own, "" for a new pupil.
            who: the address that asks.

        Raises:
            AdmissionRefusedError: a wrong code or word, or too many wrong ones.
            NameTakenError: there is a pupil of that name, and no word.
            ClassError: the class is full.
        """
        with self._room.lock:
            self._expect_code(code, who)
            name = clean_name(name)
            known = self._room.find_pupil(name)
            if known is None:
                key = secrets.token_urlsafe(24)
                return self._enter(name, key, who), key
            if not word.strip():
                raise NameTakenError(
                    Sentence("`{name}` is in this class already", name),
                    Sentence("if that is you, type your word or ask your teacher; else add a letter to your name"),
                )
            self._expect_word(known, word, who)
            self._guesses.record_success(who)
            return known, self._room.let_in(known, "came back with the word")

    def request(self, code: str, name: str, who: str) -> str:
        """Asks the teacher to let somebody in as an existing pupil; returns the id of the request.

        Raises:
            AdmissionRefusedError: as for `join`.
            ClassError: there is no such pupil, or too many ask.
        """
        with self._room.lock:
            self._expect_code(code, who)
            known = self._room.find_pupil(clean_name(name))
            if known is None:
                raise ClassError(Sentence("there is no `{name}` in this class", name[:80]), Sentence("join the class"))
            now = self._room.clock()
            self._requests = {key: one for key, one in self._requests.items() if now - one.at < ASKING_S}
            if len(self._requests) >= MOST_ASKING:
                raise ClassError(Sentence("too many ask to be let in"), Sentence("tell your teacher"))
            asked = secrets.token_urlsafe(16)
            self._requests[asked] = _Request(known.folder, now)
            self._room.log.write(f"asked to be let in as {known.record.name}, from {who}")
            return asked

    def pending(self) -> dict[str, str]:
        """The pending requests by their ids, each with the folder of its pupil."""
        with self._room.lock:
            now = self._room.clock()
            return {
                key: one.pupil for key, one in self._requests.items() if one.yes is None and now - one.at < ASKING_S
            }

    def answer(self, asked: str, yes: bool) -> None:
        """Answers a request for the teacher; does nothing if it was answered or has expired."""
        with self._room.lock:
            one = self._requests.get(asked)
            pupil = self._room.pupils.get(one.pupil) if one is not None else None
            if one is None or one.yes is not None:
                return
            one.yes = yes and pupil is not None
            if one.yes and pupil is not None:
                one.key = self._room.let_in(pupil, "let in by the teacher")

    def take_answer(self, asked: str) -> tuple[bool | None, Pupil | None, str]:
        """The answer to a request, returned once: None while it is pending, else whether the pupil is let in,
        the pupil, and the key.

        Raises:
            AdmissionRefusedError: nobody asked that.
        """
        with self._room.lock:
            one = self._requests.get(asked)
            if one is None:
                raise AdmissionRefusedError(Sentence("this question is not known any more"), Sentence("join again"))
            if one.yes is None:
                return None, None, ""
            del self._requests[asked]
            return one.yes, self._room.pupils.get(one.pupil), one.key

    def _enter(self, name: str, key: str, who: str) -> Pupil:
        """A new pupil, as long as not too many come from one address."""
        self._room.expect_place()
        if not self._room.newcomers.take(who, self._room.clock()):
            self._room.log.write(f"too many new pupils from {who}")
            raise AdmissionRefusedError(
                Sentence("very many new pupils came in from this computer or network"),
                Sentence("wait a minute, or ask your teacher"),
            )
        made = self._room.add_pupil(name, key)
        self._guesses.record_success(who)
        return made

    def _expect_word(self, pupil: Pupil, word: str, who: str) -> None:
        now, guesses = self._room.clock(), f"{who} {pupil.folder}"
        if not self._words.has(guesses, now):
            raise AdmissionRefusedError(
                Sentence("too many wrong words of `{name}` came from here", pupil.record.name),
                Sentence("wait a minute, or ask your teacher"),
            )
        if not _same(clean_code(word), pupil.record.word):
            self._words.take(guesses, now)
            self._wrong(Sentence("that is not the word of `{name}`", pupil.record.name), who)

    def _expect_code(self, code: str, who: str) -> None:
        if not self._guesses.is_allowed(who, self._room.clock()):
            self._room.log.write(f"too many wrong codes from {who}")
            raise AdmissionRefusedError(Sentence("too many wrong codes came from here"), Sentence("wait a minute"))
        if not self._room.record.code:
            raise AdmissionRefusedError(
                Sentence("nobody can join this class now"), Sentence("ask your teacher for a code")
            )
        if not _same(clean_code(code), self._room.record.code):
            self._guesses.record_failure(who, self._room.clock())
            self._wrong(Sentence("that is not the code of this class"), who)

    def _wrong(self, message: Sentence, who: str) -> None:
        self._room.log.write(f"{message} (from {who})")
        raise AdmissionRefusedError(message, Sentence("look at the letters again, or ask your teacher"))


def _same(one: str, other: str) -> bool:
    return hmac.compare_digest(one.encode(errors="replace"), other.encode())
