"""Names of pupils and of what they hand in, codes and words that can be said aloud.

A name may be in any script. It is stored as it was typed (NFC, one space between words); two names are the same when
they are alike whatever their case and form (`key_of`), or look alike (`same_name`). A folder or a file gets the nearest
name that every system takes (`as_file_name`), which is then its own nearest name.
"""

from __future__ import annotations

import re
import secrets
import unicodedata
from collections.abc import Iterable
from typing import Final

from kitrobot.classroom.confusables import INVISIBLE, visible_form
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

LONGEST_NAME: Final = 40
"""Characters of a pupil's name, and of a file's without its ending."""
ENDING: Final = ".krt"
_CONSONANTS: Final = "BDFGHJKLMNPRSTVWZ"
_VOWELS: Final = "AEIOU"
# What Windows takes in no name, and the names that are its devices, whatever follows behind a dot.
_NEVER = re.compile(r'[\\/:*?"<>|]')
_DEVICE = re.compile(r"^(con|prn|aux|nul|conin\$|conout\$|com[0-9¹²³]|lpt[0-9¹²³])\s*(?=\.|$)", re.IGNORECASE)
_EDGE = r"[\s.~\u200c\u200d]+"
"""What no name begins or ends with: hidden files, copies of older ones, what Windows leaves off."""
_EDGES = re.compile(rf"^{_EDGE}|{_EDGE}$")
_BYTES: Final = 160
"""Of a folder's name in UTF-8; systems take 255, and a temporary file's name is longer."""
_MOST_BYTES: Final = 255


class InvalidNameError(KitRobotError):
    """A name that nobody can have."""


def clean_name(given: str) -> str:
    """A pupil's name as it is kept.

    Raises:
        InvalidNameError: nothing of it can be read, or it is too long.
    """
    # Marks that turn the direction of what follows would turn the teacher's list, too; joiners belong to some scripts.
    shown = "".join(" " if unicodedata.category(one) in ("Zs", "Zl", "Zp", "Cc") else one for one in given[:1000])
    clean = "".join(one for one in shown if not unicodedata.category(one).startswith("C") or one in "\u200c\u200d")
    name = unicodedata.normalize("NFC", " ".join(word for word in clean.split() if INVISIBLE.sub("", word)))
    if not any(unicodedata.category(one)[0] in "LN" for one in INVISIBLE.sub("", name)):
        raise InvalidNameError(
            Sentence("this name has no letters"), Sentence("type the name that your teacher knows you by")
        )
    if len(name) > LONGEST_NAME or len(given) > 1000:
        raise InvalidNameError(
            Sentence("this name is longer than {most} characters", LONGEST_NAME), Sentence("a shorter one will do")
        )
    return name


def key_of(name: str) -> str:
    """What is the same for names that a person takes for one."""
    return unicodedata.normalize("NFKC", unicodedata.normalize("NFKC", name).casefold())


def same_name(one: str, other: str) -> bool:
    """Whether a person takes both for one name: written the same whatever their case and form, or looking the same."""
    return key_of(one) == key_of(other) or visible_form(one) == visible_form(other)


def as_file_name(name: str) -> str:
    """The nearest name that every file system takes; never empty, never hidden, never one that leads elsewhere.

    What it gives is its own nearest name.
    """
    # Surrogates, private and unknown characters, and marks that turn the direction or are not seen, but for joiners.
    clean = "".join(one for one in name if unicodedata.category(one)[0] != "C" or one in "\u200c\u200d")
    inner = _EDGES.sub("", _NEVER.sub("-", unicodedata.normalize("NFC", clean)))
    # Short first: what is cut off may leave the name of a device.
    short = _shortened(inner, _BYTES)
    return _shortened(_DEVICE.sub(r"\1-", short), _BYTES)


def _shortened(name: str, most: int) -> str:
    """The first bytes of a file's name as whole characters, without what no name ends with."""
    return _EDGES.sub("", name.encode()[:most].decode(errors="ignore")) or "-"


def is_file_name(name: str) -> bool:
    """Whether a name leads to something in the same folder that is not hidden; more than `as_file_name` gives.

    What was written once is read again, also where another KitRobot, another Unicode or a person has named it.
    """
    return (
        bool(name.strip())
        and not name.startswith(".")
        and not any(one in '/\\:"<>|*?' or unicodedata.category(one) in ("Cc", "Cs") for one in name)
        and len(name.encode(errors="replace")) <= _MOST_BYTES
    )


def free_name(wanted: str, taken: Iterable[str]) -> str:
    """The name, or with a number behind it where a name like it is taken."""
    keys = {key_of(one) for one in taken}
    found, number = wanted, 1
    while key_of(found) in keys:
        number += 1
        found = f"{_shortened(wanted, _BYTES - len(f' {number}'))} {number}"
    return found


def work_name(shown: str) -> str:
    """The name of a file that is handed in, without its ending: of a mission as its page shows it."""
    name = shown[:1000].replace("\\", "/").split("/")[-1]
    if name.lower().endswith(ENDING):
        name = name[: -len(ENDING)]
    return as_file_name(name[: 2 * LONGEST_NAME])


def new_code() -> str:
    """Six letters that can be said aloud and typed in any keyboard's capital letters: some two million of them."""
    parts = (_CONSONANTS, _VOWELS, _CONSONANTS) * 2
    return "".join(secrets.choice(letters) for letters in parts)


def clean_code(given: str) -> str:
    """A code or a word as it is compared: without spaces and dashes, in capitals."""
    return re.sub(r"[\s\-–·.]", "", given[:100]).upper()
