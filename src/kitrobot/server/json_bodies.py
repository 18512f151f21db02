r"""Reading the JSON body of a request: strictly, so that every string of it can be written again.

Python's `json` takes a lone surrogate (`"\ud800"`) for a character, which no file and no answer can hold.
"""

from __future__ import annotations

from collections.abc import Callable, Coroutine
from typing import Any

import orjson
from fastapi import Request, Response
from fastapi.routing import APIRoute


class _StrictRequest(Request):
    async def json(self) -> Any:
        return orjson.loads(await self.body())


class StrictJsonRoute(APIRoute):
    """A route that refuses a body which is no JSON by RFC 8259 in UTF-8, as a request that was not understood."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        handle = super().get_route_handler()

        async def strict(request: Request) -> Response:
            return await handle(_StrictRequest(request.scope, request.receive))

        return strict
