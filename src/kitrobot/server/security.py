"""Access control of the studio: ASGI middleware around the whole application.

Other pages in the same browser are the danger, and other people on the same machine. So, for every request and every
WebSocket:

- `Host` must name this machine (a foreign name that was bent to 127.0.0.1, DNS rebinding, is refused);
- `Origin`, when a browser sends one, must be the studio itself;
- the token that `kitrobot` printed must come along: as `?token=` or as the header `X-KitRobot-Token`. Only the page's
  own built files, which hold nothing of the user's, are served without, and what a page that lost its studio asks
  (handshake). For the page itself the cookie of the first load serves too. It serves for nothing else: a browser shows
  the cookies of a machine to every server on it, whoever's they are;
- a body larger than `LARGEST_BODY_BYTES` (for a recording `LARGEST_TRACE_BYTES`) is refused, whether or not its length
  was announced.

Every answer carries headers that keep the page to itself. An exception that nobody expected becomes one sentence.
"""

from __future__ import annotations

import hashlib
import hmac
import logging
import os
from typing import Any
from urllib.parse import parse_qs

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from starlette.websockets import WebSocketDisconnect

from kitrobot.server import fallback_pages
from kitrobot.server.hosts import is_loopback, named_host
from kitrobot.text.json_text import to_json
from kitrobot.text.sentences import Sentence
from kitrobot.wire.sentences import spoken

LARGEST_BODY_BYTES = 16 * 1024 * 1024
"""A mission of 100 000 vertices is half of it."""
LARGEST_TRACE_BYTES = 512 * 1024 * 1024
"""Of a recording, which goes to the disk as it comes: a day of ten robots."""
TRACE_PATH = "/api/trace"

RECONNECT_PATHS = ("/api/again", "/api/again/token")

TOKEN_HEADER = "x-kitrobot-token"

_log = logging.getLogger("kitrobot.server")

# Styles may be inline: the editor and the canvas make theirs while they run. Scripts may not.
CONTENT_POLICY = (
    "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "font-src 'self'; connect-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'"
)
_HEADERS = {
    "content-security-policy": CONTENT_POLICY,
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "camera=(), geolocation=(), microphone=()",
    "referrer-policy": "no-referrer",
    "x-content-type-options": "nosniff",
    "x-frame-options": "DENY",
}


class BodyTooLarge(Exception):
    """More of a request's body came than the studio takes."""


class SecurityMiddleware:
    """Refuses forbidden requests, and adds security headers to answers."""

    def __init__(
        self,
        app: ASGIApp,
        token: str,
        largest_body_bytes: int = LARGEST_BODY_BYTES,
        largest_trace_bytes: int = LARGEST_TRACE_BYTES,
    ) -> None:
        self.app = app
        self.largest_trace_bytes = largest_trace_bytes
        self.token = token
        self.largest_body_bytes = largest_body_bytes

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "websocket":
            await self._websocket(scope, receive, send)
        elif scope["type"] == "http":
            await self._http(scope, receive, send)
        else:
            await self.app(scope, receive, send)

    async def _websocket(self, scope: Scope, receive: Receive, send: Send) -> None:
        headers = Headers(scope=scope)
        is_ours = is_loopback(named_host(headers)) and _is_own_origin(headers)
        if not is_ours or not self._has_valid_token(scope, headers):
            await receive()
            await send({"type": "websocket.close", "code": 1008, "reason": "not allowed"})
            return
        gone = False

        async def tracked_receive() -> Message:
            nonlocal gone
            message = await receive()
            gone = gone or message["type"] == "websocket.disconnect"
            return message

        async def tracked_send(message: Message) -> None:
            nonlocal gone
            try:
                if not gone:
                    await send(message)
            except (OSError, RuntimeError):
                gone = True
            if gone and message["type"] == "websocket.send":
                raise OSError("the page is gone")

        try:
            await self.app(scope, tracked_receive, tracked_send)
        except (WebSocketDisconnect, OSError):
            # A page may close while a message is sent to it, whatever the socket is for.
            if not gone:
                raise

    async def _http(self, scope: Scope, receive: Receive, send: Send) -> None:
        headers = Headers(scope=scope)
        started = False

        async def with_headers(message: Message) -> None:
            nonlocal started
            if message["type"] == "http.response.start":
                started = True
                add_security_headers(message, scope)
            await send(message)

        if not is_loopback(named_host(headers)):
            host = headers.get("host", "")[:80]
            await refuse(
                scope, with_headers, 403, Sentence("the studio does not answer to the name `{host}`", host), _ADDRESS
            )
            return
        if not _is_own_origin(headers):
            await refuse(scope, with_headers, 403, Sentence("this request comes from another page"), _ADDRESS)
            return
        if not _is_public(scope) and not self._has_valid_token(scope, headers):
            if scope["path"] == "/":
                await refuse(
                    scope,
                    with_headers,
                    403,
                    Sentence("the studio that this address belongs to has ended"),
                    _START_AGAIN,
                )
            else:
                await refuse(
                    scope, with_headers, 403, Sentence("the token of this request is missing or wrong"), _ADDRESS
                )
            return
        most = self.largest_trace_bytes if scope["path"] == TRACE_PATH else self.largest_body_bytes
        if _announced_too_much(headers, most):
            await _refuse_body(scope, with_headers, most)
            return
        if self._has_query_token(scope):
            scope.setdefault("state", {})["kitrobot_cookie"] = page_cookie(headers, self.token)
        try:
            await self.app(scope, _limited(receive, most), with_headers)
        except BodyTooLarge:
            if not started:
                await _refuse_body(scope, with_headers, most)
        except Exception as error:
            _log.error("%s: %s", type(error).__name__, error, exc_info=bool(os.environ.get("KITROBOT_DEBUG")))
            if not started:
                await refuse(scope, with_headers, 500, Sentence("something went wrong inside KitRobot"), _REPORT)

    def _has_valid_token(self, scope: Scope, headers: Headers) -> bool:
        right = False
        # All are compared, always, so the time that this takes reveals nothing.
        for value in (*_query_tokens(scope), headers.get(TOKEN_HEADER, "")):
            right |= _equal_in_constant_time(self.token, value)
        if scope["path"] == "/" and scope["type"] == "http":
            for value in _cookies(headers):
                right |= _equal_in_constant_time(_page_token(self.token), value)
        return right

    def _has_query_token(self, scope: Scope) -> bool:
        return scope["path"] == "/" and any(
            _equal_in_constant_time(self.token, value) for value in _query_tokens(scope)
        )


_ADDRESS = Sentence("open the address that `kitrobot` printed")
_START_AGAIN = Sentence(
    "run `kitrobot` in the same folder: it opens the page of the studio that runs there, with the "
    "work that was not saved"
)
_REPORT = Sentence("start it with KITROBOT_DEBUG=1 to see where, and please report it")


def _equal_in_constant_time(one: str, other: str) -> bool:
    return hmac.compare_digest(one.encode(), other.encode())


def _is_own_origin(headers: Headers) -> bool:
    origin = headers.get("origin")
    return origin is None or origin.lower() == f"http://{headers.get('host', '').lower()}"


def _is_public(scope: Scope) -> bool:
    """The built page's files, and how a page and a studio know each other again; not the page itself, so that a wrong
    address is noticed at once.
    """
    path = scope["path"]
    if scope["method"] == "POST" and path in RECONNECT_PATHS:
        return True
    return scope["method"] in ("GET", "HEAD") and path != "/" and path != "/api" and not path.startswith("/api/")


def _query_tokens(scope: Scope) -> list[str]:
    query = scope.get("query_string", b"").decode("latin-1")
    try:
        return parse_qs(query, max_num_fields=100).get("token", [])
    except ValueError:
        return []


def _cookie_name(headers: Headers) -> str:
    """One name a port: the browser shows a machine's cookies to all of its servers."""
    port = headers.get("host", "").rpartition(":")[2]
    return f"kitrobot-{port}" if port.isdecimal() else "kitrobot"


def page_cookie(headers: Headers, token: str) -> str:
    """What is set when a page comes with the token, so that it can be loaded again."""
    return f"{_cookie_name(headers)}={_page_token(token)}; Path=/; HttpOnly; SameSite=Strict"


def _page_token(token: str) -> str:
    """What shows that a browser had the token, and is not the token."""
    return hmac.new(token.encode(), b"the page", hashlib.sha256).hexdigest()


def _cookies(headers: Headers) -> list[str]:
    """Every value of our cookie, whatever other servers of this machine put beside it."""
    wanted = _cookie_name(headers)
    pairs = [pair.partition("=") for line in headers.getlist("cookie") for pair in line.split(";")]
    return [value.strip().strip('"') for name, _, value in pairs if name.strip() == wanted]


def add_security_headers(message: Message, scope: Scope) -> None:
    """Adds the security headers, and the page's cookie, to an answer."""
    headers = MutableHeaders(scope=message)
    for name, value in _HEADERS.items():
        headers.setdefault(name, value)
    if scope["path"].startswith("/api/") or scope["path"] == "/":
        headers["cache-control"] = "no-store"
    cookie = scope.get("state", {}).get("kitrobot_cookie")
    if cookie:
        headers.append("set-cookie", cookie)


async def refuse(scope: Scope, send: Send, status: int, message: str, help: str) -> None:
    """An answer without the application: a page for people, JSON for the page's own requests."""
    if scope["path"].startswith("/api"):
        body, kind = (
            to_json({"message": spoken(message), "help": spoken(help)}),
            "application/json",
        )
    else:
        body, kind = fallback_pages.sentence(message, help).encode(), "text/html; charset=utf-8"
    head: dict[str, Any] = {
        "type": "http.response.start",
        "status": status,
        "headers": [(b"content-type", kind.encode()), (b"content-length", str(len(body)).encode())],
    }
    await send(head)
    await send({"type": "http.response.body", "body": b"" if scope["method"] == "HEAD" else body})


def _limited(receive: Receive, most: int) -> Receive:
    """The same, until more than so many bytes came."""
    taken = 0

    async def limited() -> Message:
        nonlocal taken
        message = await receive()
        taken += len(message.get("body", b""))
        if taken > most:
            raise BodyTooLarge
        return message

    return limited


def _announced_too_much(headers: Headers, most: int) -> bool:
    announced = headers.get("content-length", "0")
    return announced.isdecimal() and int(announced[:20]) > most


async def _refuse_body(scope: Scope, send: Send, most: int) -> None:
    limit = most // (1024 * 1024)
    await refuse(scope, send, 413, Sentence("that is more than the {limit} MB that the studio takes", limit), "")
