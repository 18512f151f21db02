"""The key of a team: from a file, from the environment, or made for one run."""

from __future__ import annotations

import os
import secrets
from collections.abc import Mapping
from hashlib import blake2b
from pathlib import Path

from kitrobot.diagnostics.read_files import note_read
from kitrobot.fleet.charter import FleetError
from kitrobot.text.sentences import Sentence

VARIABLE = "KITROBOT_TEAM_KEY"
"""The environment variable in which a team gives its key to the agents that it starts."""

LEAST_LETTERS, MOST_LETTERS = 16, 4096


def new_key() -> str:
    """A key that nobody can guess."""
    return secrets.token_hex(32)


def key_of(text: str, where: str) -> bytes:
    """The 32 bytes that a key's text stands for; white space around it does not count.

    Raises:
        FleetError: it is too short to be a secret, or too long.
    """
    letters = text.strip()
    if not LEAST_LETTERS <= len(letters) <= MOST_LETTERS:
        raise FleetError(
            Sentence(
                "expected a team key of {least} to {most} letters in {where}, found {count}",
                LEAST_LETTERS,
                MOST_LETTERS,
                where,
                len(letters),
            ),
            Sentence("let all agents of the team read one file with a long random text"),
        )
    return blake2b(letters.encode(), digest_size=32, person=b"kitrobot-team").digest()


def find_key(file: Path | None, environment: Mapping[str, str] = os.environ) -> bytes | None:
    """The key in a file, or in the environment; None where there is neither.

    Raises:
        FleetError: it is no key, or the file cannot be read.
    """
    if file is None:
        text = environment.get(VARIABLE)
        return None if text is None else key_of(text, VARIABLE)
    try:
        with file.open(encoding="utf-8") as stream:
            note_read(file, stream.fileno())
            return key_of(stream.read(2 * MOST_LETTERS), f"`{file}`")
    except (OSError, UnicodeDecodeError) as error:
        why = getattr(error, "strerror", None) or Sentence("it is no text")
        raise FleetError(Sentence("the team key in `{file}` cannot be read: {why}", str(file), why)) from error
