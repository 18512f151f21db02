"""The language in which a command gives what files of kits and robots say, and what is wrong with them.

What a command says of itself is English: `used`, `missing`, its keys.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from kitrobot.primitives.robot import Texts


def _known(language: str) -> str:
    from kitrobot.translation.translator import LANGUAGES

    if language not in LANGUAGES:
        raise typer.BadParameter(f"expected {', '.join(LANGUAGES[:-1])} or {LANGUAGES[-1]}, found {language[:40]!r}")
    return language


Language = Annotated[
    str,
    typer.Option(
        "--language",
        metavar="en|fr|ur",
        callback=_known,
        help="The language of what kits and parts say, and of what is wrong with them.",
    ),
]


def translated(texts: Texts) -> str:
    """The text in the reader's language (`kitrobot.translation`), else in English, else ""."""
    from kitrobot.text.sentences import Label
    from kitrobot.translation.reader_language import translate

    return translate(Label("", texts))
