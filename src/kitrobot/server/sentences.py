"""Messages as the page shows them: sentences of their own, in the reader's language."""

from __future__ import annotations

import re
from typing import Annotated

from pydantic import PlainSerializer, SkipValidation, ValidationError
from starlette.datastructures import Headers, QueryParams
from starlette.types import ASGIApp, Receive, Scope, Send

from kitrobot.diagnostics import KitRobotError
from kitrobot.text import Sentence, Series
from kitrobot.translation import STOPS, best_language, reading_in, said, said_in


def readable(words: str) -> str:
    """The same as text that can be sent: a file's name may hold what is no UTF-8."""
    return words.encode(errors="surrogatepass").decode(errors="replace")


def clause(words: str) -> str:
    """A message in the reader's language."""
    return readable(said(words))


def spoken(words: str) -> str:
    """A message in the reader's language as a sentence of its own: a capital letter and a full stop.

    A name with which it begins keeps its first letter: `square.krt` is no `Square.krt`.
    """
    text = clause(words)
    first = text[:1] if _begins_with_name(text, words) else text[:1].upper()
    return text and first + text[1:] + ("" if text[-1] in _ENDS else STOPS[said_in()])


def _begins_with_name(text: str, words: str) -> bool:
    """Whether a text begins with one of the values of its sentence that are no sentences: names, numbers, code."""
    if isinstance(words, Series):
        return any(_begins_with_name(text, part) for part in words.parts)
    if isinstance(words, Sentence):
        return any(_begins_with_name(text, one) for one in words.values.values() if isinstance(one, str))
    return words != "" and re.match(rf"{re.escape(words)}(?!\w)", text) is not None


_ENDS = (*STOPS.values(), "?", "!", "؟")

FileName = Annotated[str, PlainSerializer(readable, return_type=str)]
"""A field for the name of a file on the disk, which the page shows."""
Clause = Annotated[str, SkipValidation, PlainSerializer(clause, return_type=str)]
"""A field for people, said in the language of the request that it answers when it is sent. It takes the message as it
is, for checking it would make a plain `str` of a `kitrobot.text.Sentence`."""
Spoken = Annotated[str, SkipValidation, PlainSerializer(spoken, return_type=str)]
"""The same as a sentence of its own."""


def not_understood(error: ValidationError) -> KitRobotError:
    """What is wrong with a request over a WebSocket: the first mistake in it."""
    first = error.errors(include_url=False, include_input=False)[0]
    where = ".".join(str(part) for part in first["loc"])
    return KitRobotError(
        Sentence("the request was not understood: {reason}{where}", first["msg"], f" ({where})" if where else ""),
        Sentence("load the page again: it may be older than the studio"),
    )


class InReadersLanguage:
    """An ASGI shell: what is said while a request or a WebSocket is served is said in the language that it asks for.

    `?language=` counts before `Accept-Language`: a browser lets no page write the headers of a WebSocket.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        asked = QueryParams(scope["query_string"][:4096]).get("language", "")
        with reading_in(best_language(asked or Headers(scope=scope).get("accept-language", ""))):
            await self.app(scope, receive, send)
