"""Access control of a class: ASGI middleware in front of the class, the teacher's studio and the studios of pupils.

- `Host` must be a number, or a name of this machine: a foreign name that was bent to it is refused. `Origin`, when a
  browser sends one, must be that host.
- The teacher's key counts on the teacher's machine only: from elsewhere it is no key.
- A pupil's key leads to that pupil and nowhere else: it is looked up, and the application behind gets the pupil.
- Without a key one can load the page, see the name of the class and come in (`admission` limits guessing).
- Each pupil, and each address without a key, has a rate limit.

Each application behind has a token of its own, which this gateway puts in the place of the key; so nothing that a page
sends can name another pupil's studio. `SecurityMiddleware` around each of them limits bodies and adds headers.
"""

from __future__ import annotations

import hmac
import ipaddress
import secrets
import time
from collections import Counter, OrderedDict
from collections.abc import Callable
from typing import Any, Final
from urllib.parse import parse_qs

from starlette.datastructures import Headers
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from kitrobot.classroom.class_room import ClassRoom
from kitrobot.classroom.pupil import Pupil
from kitrobot.classroom.rate_limits import RateLimit
from kitrobot.files.folder_quota import writing_within
from kitrobot.server.classroom.studios import PupilStudios
from kitrobot.server.hosts import host_number, is_loopback, machine_names, named_host
from kitrobot.server.security import TOKEN_HEADER, add_security_headers, refuse
from kitrobot.text.sentences import Sentence

A_SECOND: Final = 40.0
AT_ONCE: Final = 300.0
"""Requests of one pupil: loading the page takes some sixty."""
STRANGERS_A_SECOND: Final = 20.0
STRANGERS_AT_ONCE: Final = 200.0
JOINS_A_SECOND: Final = 5.0
JOINS_AT_ONCE: Final = 120.0
"""Of those who come in from one address; loading pages and asking takes nothing from it. A class may sit behind one."""
MOST_SOCKETS: Final = 40
"""Sockets of one pupil at a time: six pages have as many."""
MOST_KNOWN: Final = 2000
TEACHER_PATH: Final = "/api/class/teacher"
JOINING: Final = ("/api/class/join", "/api/class/ask")
_ASK = Sentence("ask your teacher")


class ClassGateway:
    """The gateway. `behind` is the class, which takes `token`; `studio` the teacher's studio, which takes `key`, as the
    teacher's page does; `studios` those of pupils, None where they are in the pupils' pages.
    """

    def __init__(
        self,
        room: ClassRoom,
        behind: ASGIApp,
        token: str,
        studio: ASGIApp,
        key: str,
        studios: PupilStudios | None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._room = room
        self._behind = behind
        self._token = token
        self._studio = studio
        self._key = key
        self._studios = studios
        self._clock = clock
        self._names = frozenset(("localhost", *machine_names()))
        self._allowances: OrderedDict[str, RateLimit] = OrderedDict()
        self._sockets: Counter[str] = Counter()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self._behind(scope, receive, send)
            return
        headers, path = Headers(scope=scope), scope["path"]
        client = scope["client"][0] if scope.get("client") else ""
        if not self._is_own_host(headers) or not _is_own_origin(headers, scope["scheme"]):
            await _refuse(scope, receive, send, 403, Sentence("this request comes from another page"), _ASK)
            return
        key = _key_of(scope, headers)
        is_api = path == "/api" or path.startswith("/api/")
        teacher = bool(key) and _is_local(scope) and hmac.compare_digest(self._key.encode(), key.encode())
        pupil = None if teacher or not is_api else self._room.pupil_of(key)
        if is_api and not teacher and not self._is_within_rate(pupil, client, path):
            await _refuse(scope, receive, send, 429, Sentence("that was too much at once"), Sentence("wait a moment"))
        elif pupil is not None and scope["type"] == "websocket":
            if self._sockets[pupil.folder] >= MOST_SOCKETS:
                await _refuse(
                    scope, receive, send, 429, Sentence("that was too much at once"), Sentence("wait a moment")
                )
                return
            self._sockets[pupil.folder] += 1
            try:
                await self._dispatch(path, key, False, pupil, scope, receive, send)
            finally:
                self._sockets[pupil.folder] -= 1
        else:
            await self._dispatch(path, key, teacher, pupil, scope, receive, send)

    async def _dispatch(
        self, path: str, key: str, teacher: bool, pupil: Pupil | None, scope: Scope, receive: Receive, send: Send
    ) -> None:
        """Passes an allowed request on to the application that its path belongs to."""
        is_api = path == "/api" or path.startswith("/api/")
        if teacher and is_api and not _below(path, "/api/class"):
            await self._studio(rewrite_scope(scope, key, {}, keep_client=True), receive, send)
        elif _below(path, TEACHER_PATH) and not teacher:
            await _refuse(scope, receive, send, 403, Sentence("this is for the teacher"), _ASK)
        elif not is_api or _below(path, "/api/class"):
            await self._behind(
                rewrite_scope(scope, self._token, {"class_pupil": pupil}, keep_client=True), receive, send
            )
        elif pupil is None:
            await _refuse(scope, receive, send, 403, _NOT_IN, _JOIN)
        elif self._studios is None:
            await _refuse(scope, receive, send, 403, Sentence("the studio of a pupil is in the pupil's page"), _LOAD)
        else:
            await self._to_studio(self._studios, pupil, scope, receive, send)

    async def _to_studio(self, studios: PupilStudios, pupil: Pupil, scope: Scope, receive: Receive, send: Send) -> None:
        studio = studios.of(pupil.folder)
        if studios.refuses(scope["path"]):
            await _refuse(scope, receive, send, 403, Sentence("a class does not do this"), _NOT_HERE)
        else:
            # Without an address: ports and processes of this machine are for those who sit at it.
            with writing_within(studio.quota):
                await studio.app(rewrite_scope(scope, studio.token, {}, keep_client=False), receive, send)

    def _is_within_rate(self, pupil: Pupil | None, client: str, path: str) -> bool:
        joins = pupil is None and path in JOINING
        who = f"pupil {pupil.folder}" if pupil is not None else f"{'joining' if joins else 'address'} {client}"
        known = self._allowances.get(who)
        if known is None:
            rate = (A_SECOND, AT_ONCE) if pupil is not None else (STRANGERS_A_SECOND, STRANGERS_AT_ONCE)
            rate = (JOINS_A_SECOND, JOINS_AT_ONCE) if joins else rate
            known = self._allowances[who] = RateLimit(*rate)
        self._allowances.move_to_end(who)
        while len(self._allowances) > MOST_KNOWN:
            self._allowances.popitem(last=False)
        return known.take(self._clock())

    def _is_own_host(self, headers: Headers) -> bool:
        name = named_host(headers)
        try:
            ipaddress.ip_address(host_number(name))
        except ValueError:
            return name in self._names
        return True


_NOT_IN, _JOIN = Sentence("you are not in this class"), Sentence("join it with the code")
_LOAD = Sentence("load this page again")
_NOT_HERE = Sentence("use a KitRobot of your own for it")


def _is_own_origin(headers: Headers, scheme: str) -> bool:
    origin = headers.get("origin")
    secure = "https" if scheme in ("https", "wss") else "http"
    return origin is None or origin.lower() == f"{secure}://{headers.get('host', '').lower()}"


def _is_local(scope: Scope) -> bool:
    """Whether the request comes from this very machine, by whichever of its addresses."""
    (client, *_), (server, *_) = scope.get("client") or ("",), scope.get("server") or ("",)
    return is_loopback(client) or (bool(client) and client == server)


def _below(path: str, place: str) -> bool:
    return path == place or path.startswith(f"{place}/")


def _key_of(scope: Scope, headers: Headers) -> str:
    """The key that came along; of several there is none."""
    try:
        query = parse_qs(scope.get("query_string", b"").decode("latin-1"), max_num_fields=100)
    except ValueError:
        return ""
    given = [*query.get("token", []), *headers.getlist(TOKEN_HEADER)]
    return given[0] if len(set(given)) == 1 else ""


_OWN_HEADERS: Final = (b"host", b"origin", b"cookie", TOKEN_HEADER.encode(), b"x-forwarded-for", b"forwarded")


def rewrite_scope(scope: Scope, token: str, state: dict[str, Any], keep_client: bool) -> Scope:
    """The request for the application behind: with that one's token, from this machine, and with the pupil."""
    headers = [(name, value) for name, value in scope["headers"] if name.lower() not in _OWN_HEADERS]
    headers += [(b"host", b"127.0.0.1"), (TOKEN_HEADER.encode(), token.encode())]
    query = b"&".join(
        part for part in scope.get("query_string", b"").split(b"&") if part.partition(b"=")[0] != b"token"
    )
    return {
        **scope,
        "headers": headers,
        "query_string": query,
        "state": {**scope.get("state", {}), **state},
        "client": scope.get("client") if keep_client else None,
    }


async def _refuse(scope: Scope, receive: Receive, send: Send, status: int, message: Sentence, help: Sentence) -> None:
    if scope["type"] == "websocket":
        await receive()
        await send({"type": "websocket.close", "code": 1008, "reason": "not allowed"})
        return

    async def with_headers(answer: Message) -> None:
        if answer["type"] == "http.response.start":
            add_security_headers(answer, scope)
        await send(answer)

    await refuse(scope, with_headers, status, message, help)


def new_key() -> str:
    """A secret of one process."""
    return secrets.token_urlsafe(24)
