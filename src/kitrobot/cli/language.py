"""The language in which a command gives what files of kits and robots say, and what is wrong with them.

What a command says of itself is English: `used`, `missing`, its keys.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.translation.languages import LANGUAGES

if TYPE_CHECKING:
    from kitrobot.primitives.robot import Texts


def _known(language: str) -> str:
    from kitrobot.text.phrases import one_of

    if language not in LANGUAGES:
        raise typer.BadParameter(f"expected {one_of(LANGUAGES)}, found {language[:40]!r}")
    return language


Language = Annotated[
    str,
    typer.Option(
        "--language",
        metavar="|".join(LANGUAGES),
        callback=_known,
        help="The language of what kits and parts say, and of what is wrong with them.",
    ),
]


def translated(texts: Texts) -> str:
    """The text in the reader's language (`kitrobot.translation`), else in English, else ""."""
    from kitrobot.text.sentences import Label
    from kitrobot.translation.reader_language import translate

    return translate(Label("", texts))
