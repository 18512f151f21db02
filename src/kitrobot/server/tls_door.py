"""The door of a server over TLS: it lets in who encrypts, and tells the address to who speaks plain HTTP.

An address that is typed without `https://` is asked in plain HTTP. A server over TLS closes such a connection, and the
browser says no more than that. The door looks at the first byte of each connection and leaves it there: a record of
TLS begins with 22 (RFC 8446, 5.1), no request of HTTP does. Its thread holds few connections, each for a short time.
"""

from __future__ import annotations

import errno
import re
import select
import selectors
import socket
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

TLS_RECORD: Final = b"\x16"
MOST_WAITING: Final = 200
"""Connections that have sent nothing yet; the oldest makes room for one more."""
LONGEST_WAIT_S: Final = 15.0
LARGEST_REQUEST_BYTES: Final = 16 * 1024
"""Of what a plain request says until its head ends."""

CERTIFICATE_PATH: Final = "/certificate"


def certificate_address(address: str) -> str:
    """Where plain HTTP gives the certificate of a server whose address over TLS is `https://HOST:PORT/`."""
    return "http" + address.removeprefix("https").removesuffix("/") + CERTIFICATE_PATH


@dataclass(frozen=True)
class PlainReply:
    """What is said in plain HTTP: a page (HTML), made from `Accept-Language`; and at `CERTIFICATE_PATH` the certificate
    (PEM) that makes other machines trust this one, `b""` for none.
    """

    page: Callable[[str], str]
    certificate: bytes = b""


@dataclass
class _Visitor:
    """A connection that has not begun with TLS: until when it may stay, and what it has sent."""

    until_s: float
    head: bytes = b""


class TlsDoor(threading.Thread):
    """Accepts connections until it is closed; `admit` gets each that begins with TLS, from the door's thread."""

    def __init__(
        self, listening: Sequence[socket.socket], admit: Callable[[socket.socket], None], greeting: PlainReply
    ) -> None:
        super().__init__(name="tls-door", daemon=True)
        self._listening = listening
        self._admit = admit
        self._greeting = greeting
        self._wake, self._woken = socket.socketpair()
        self._waiting: dict[socket.socket, _Visitor] = {}

    def close(self) -> None:
        """Ends it: nobody is accepted any more."""
        self._wake.close()
        self.join()

    def run(self) -> None:
        with selectors.DefaultSelector() as selector, self._woken:
            for one in (*self._listening, self._woken):
                one.setblocking(False)
                selector.register(one, selectors.EVENT_READ, one)
            while True:
                ready = [key.data for key, _ in selector.select(1.0 if self._waiting else None)]
                if self._woken in ready:
                    break
                for one in ready:
                    if one in self._waiting:
                        self._serve(selector, one)
                    elif one in self._listening:
                        self._accept(selector, one)
                self._drop_silent(selector)
            for one in self._waiting:
                one.close()

    def _accept(self, selector: selectors.BaseSelector, listening: socket.socket) -> None:
        try:
            connection, _ = listening.accept()
        except OSError as error:
            if error.errno in (errno.EMFILE, errno.ENFILE):
                # It stays ready; without a pause this would turn as fast as it can.
                select.select([self._woken], [], [], 1.0)
            return
        connection.setblocking(False)
        if len(self._waiting) >= MOST_WAITING:
            self._leave(selector, next(iter(self._waiting)))
        self._waiting[connection] = _Visitor(time.monotonic() + LONGEST_WAIT_S)
        selector.register(connection, selectors.EVENT_READ, connection)

    def _drop_silent(self, selector: selectors.BaseSelector) -> None:
        now = time.monotonic()
        for one in [one for one, visitor in self._waiting.items() if visitor.until_s < now]:
            self._leave(selector, one)

    def _leave(self, selector: selectors.BaseSelector, connection: socket.socket, *, close: bool = True) -> None:
        selector.unregister(connection)
        del self._waiting[connection]
        if close:
            connection.close()

    def _serve(self, selector: selectors.BaseSelector, connection: socket.socket) -> None:
        visitor = self._waiting[connection]
        try:
            if not visitor.head and connection.recv(1, socket.MSG_PEEK) == TLS_RECORD:
                self._leave(selector, connection, close=False)
                self._admit(connection)
                return
            said = connection.recv(LARGEST_REQUEST_BYTES)
            visitor.head += said
            if b"\r\n\r\n" in visitor.head:
                connection.send(_answer(visitor.head, self._greeting))
                connection.shutdown(socket.SHUT_WR)
            elif said and len(visitor.head) < LARGEST_REQUEST_BYTES:
                return  # the rest is on its way
        except OSError:
            pass  # it left
        self._leave(selector, connection)


def _answer(request: bytes, greeting: PlainReply) -> bytes:
    """What a plain request gets: the certificate, or the page, and that it takes TLS (RFC 9110, 15.5.22)."""
    if greeting.certificate and re.match(rb"(GET|HEAD) %b(\?\S*)? " % CERTIFICATE_PATH.encode(), request):
        body = greeting.certificate
        # Devices begin to install what has this type; as an attachment it would be a file like any other.
        head = (
            "200 OK\r\nConnection: close\r\nContent-Type: application/x-x509-ca-cert\r\n"
            'Content-Disposition: inline; filename="kitrobot-class.crt"\r\nX-Content-Type-Options: nosniff'
        )
    else:
        wish = re.search(rb"\r\naccept-language:[ \t]*([^\r]*)", request, re.IGNORECASE)
        body = greeting.page("" if wish is None else wish[1].decode("latin-1")).encode()
        head = (
            "426 Upgrade Required\r\nUpgrade: TLS/1.2, HTTP/1.1\r\nConnection: Upgrade, close\r\n"
            "Content-Type: text/html; charset=utf-8\r\n"
            "Content-Security-Policy: default-src 'none'; style-src 'unsafe-inline'"
        )
    head = f"HTTP/1.1 {head}\r\nContent-Length: {len(body)}\r\nCache-Control: no-store\r\n\r\n"
    return head.encode() + (b"" if request.startswith(b"HEAD ") else body)
