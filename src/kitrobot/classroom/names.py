"""Names of pupils and of what they hand in, codes and words that can be said aloud.

A name may be in any script. It is kept as it was typed (NFC, one space between words); two names are the same when they
are alike whatever their case and form (`key_of`). A folder or a file gets the nearest name that every system takes.
"""

from __future__ import annotations

import re
import secrets
import unicodedata
from collections.abc import Iterable
from typing import Final

from kitrobot.diagnostics import KitRobotError
from kitrobot.text import Sentence

LONGEST_NAME: Final = 40
"""Characters of a pupil's name, and of a file's without its ending."""
ENDING: Final = ".krt"
_CONSONANTS: Final = "BDFGHJKLMNPRSTVWZ"
_VOWELS: Final = "AEIOU"
# What Windows takes in no name, and the names that are its devices.
_NEVER = re.compile(r'[\\/:*?"<>|]')
_DEVICES = re.compile(r"(con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(\..*)?", re.IGNORECASE)
_BYTES: Final = 160
"""Of a folder's name in UTF-8; systems take 255, and a temporary file's name is longer."""


class WrongNameError(KitRobotError):
    """A name that nobody can have."""


def clean_name(given: str) -> str:
    """A pupil's name as it is kept.

    Raises:
        WrongNameError: nothing of it can be read, or it is too long.
    """
    # Marks that turn the direction of what follows would turn the teacher's list, too.
    shown = "".join(" " if unicodedata.category(one) in ("Zs", "Zl", "Zp", "Cc") else one for one in given[:1000])
    kept = "".join(one for one in shown if not unicodedata.category(one).startswith("C") or one in "\u200c\u200d")
    name = unicodedata.normalize("NFC", " ".join(kept.split()))
    if not any(unicodedata.category(one)[0] in "LN" for one in name):
        raise WrongNameError(
            Sentence("this name has no letters"), Sentence("type the name that your teacher knows you by")
        )
    if len(name) > LONGEST_NAME or len(given) > 1000:
        raise WrongNameError(
            Sentence("this name is longer than {most} characters", LONGEST_NAME), Sentence("a shorter one will do")
        )
    return name


def key_of(name: str) -> str:
    """What is the same for names that a person takes for one."""
    return unicodedata.normalize("NFKC", unicodedata.normalize("NFKC", name).casefold())


def as_file_name(name: str) -> str:
    """The nearest name that every file system takes; never empty, never hidden, never one that leads elsewhere."""
    kept = _NEVER.sub("-", "".join(one for one in name if unicodedata.category(one) not in ("Cc", "Cs", "Cn", "Co")))
    kept = kept.strip().strip(".~").strip()
    while len(kept.encode()) > _BYTES:
        kept = kept[:-1]
    kept = kept.rstrip(". ") or "-"
    return f"{kept}-" if _DEVICES.fullmatch(kept) else kept


def free_name(wanted: str, taken: Iterable[str]) -> str:
    """The name, or with a number behind it where a name like it is taken."""
    keys = {key_of(one) for one in taken}
    found, number = wanted, 1
    while key_of(found) in keys:
        number += 1
        found = f"{wanted} {number}"
    return found


def work_name(shown: str) -> str:
    """The name of a file that is handed in, without its ending: of a mission as its page shows it."""
    name = unicodedata.normalize("NFC", shown[:1000].replace("\\", "/").split("/")[-1])
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
