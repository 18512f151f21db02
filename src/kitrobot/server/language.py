"""The language of a request: which one its sentences are translated into."""

from __future__ import annotations

from starlette.datastructures import Headers, QueryParams
from starlette.types import ASGIApp, Receive, Scope, Send

from kitrobot.translation.reader_language import best_language, override_language


class LanguageMiddleware:
    """ASGI middleware: sentences are translated into the language that a request or a WebSocket requests.

    `?language=` counts before `Accept-Language`: a browser lets no page write the headers of a WebSocket.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        asked = QueryParams(scope["query_string"][:4096]).get("language", "")
        with override_language(best_language(asked or Headers(scope=scope).get("accept-language", ""))):
            await self.app(scope, receive, send)
