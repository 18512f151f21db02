r"""Reading the JSON body of a request, so that every string of it can be written again.

JSON can contain half of a character (`"\ud800"`, a lone surrogate), which no file and no answer can hold. An editor
sends it when a text is cut in the middle of a character: it is read as U+FFFD, as a text in UTF-16 would be.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Coroutine
from typing import Any

from fastapi import Request, Response
from fastapi.routing import APIRoute

from kitrobot.text.json_text import from_json


def read_json(body: bytes) -> Any:
    """The value of a JSON text by RFC 8259, in UTF-8; lone surrogates are U+FFFD.

    Raises:
        json.JSONDecodeError: it is no JSON, or nested too deeply.
    """
    try:
        return from_json(body)
    except json.JSONDecodeError:
        if rb"\u" not in body:
            raise
        try:
            text = json.dumps(json.loads(body), ensure_ascii=False)
        except (ValueError, RecursionError):
            text = ""
        if not text:
            raise
        return from_json(text.encode("utf-16", "surrogatepass").decode("utf-16", "replace"))


class _JsonRequest(Request):
    async def json(self) -> Any:
        return read_json(await self.body())


class JsonRoute(APIRoute):
    """A route whose body is read by `read_json`; what is no JSON is a request that was not understood."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        handle = super().get_route_handler()

        async def read(request: Request) -> Response:
            return await handle(_JsonRequest(request.scope, request.receive))

        return read
