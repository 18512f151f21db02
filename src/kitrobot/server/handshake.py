"""How a page and a studio that started anew know each other, without a word that anybody else could use.

A page got the folder's secret from the studio that it was opened from, and keeps it in its memory only. When the
connection is lost, whoever listens at the address next may be anybody: another user of the machine may have taken the
port. So the page sends a number, the studio answers with one of its own and the proof that it knows the secret, and
only then the page proves the same and gets the token of the new studio. A proof holds both numbers and the address that
the studio listens on, so it can neither be used again nor be fetched from a studio at another address.
"""

from __future__ import annotations

import hmac
import secrets
import threading
from typing import Annotated

from fastapi import Request, Response
from pydantic import BaseModel, StringConstraints

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.server.handshake_proof import compute_proof
from kitrobot.server.routes.api_router import api_router
from kitrobot.server.security import page_cookie
from kitrobot.text.sentences import Sentence

MOST_ASKED = 64
"""Numbers of ours that wait for a proof; the oldest goes when there are more."""

Number = Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{32,128}$")]

handshake_routes = api_router("/api/again")


class StrangerError(KitRobotError):
    """The sender does not know the folder's secret."""


class AgainAskShape(BaseModel):
    """A page that lost its studio: a number that was never used."""

    asked: Number


class AgainShape(BaseModel):
    """The studio's own number, and the proof that it is one of the same folder."""

    answered: str
    proof: str


class AgainProofShape(BaseModel):
    """Both numbers, and the proof that the page is one of the same folder."""

    asked: Number
    answered: Number
    proof: Number


class AgainTokenShape(BaseModel):
    """What every request must bring along from now on."""

    token: str


class Handshake:
    """What one studio knows: the folder's `secret`, and its own `token`. Safe to use from many threads."""

    def __init__(self, secret: str, token: str) -> None:
        self.secret = secret
        self._token = token
        self._open: dict[str, None] = {}
        self._lock = threading.Lock()

    def answer(self, address: str, asked: str) -> tuple[str, str]:
        """A number of ours, and the proof for the page."""
        answered = secrets.token_hex(32)
        with self._lock:
            self._open[answered] = None
            while len(self._open) > MOST_ASKED:
                del self._open[next(iter(self._open))]
        return answered, compute_proof(self.secret, "studio", address, asked, answered)

    def token_for(self, address: str, asked: str, answered: str, proof: str) -> str:
        """The token, for the proof of a page.

        Raises:
            StrangerError: it is none, or the number was used.
        """
        with self._lock:
            fresh = answered in self._open
            self._open.pop(answered, None)
        if hmac.compare_digest(compute_proof(self.secret, "page", address, asked, answered), proof) and fresh:
            return self._token
        raise StrangerError(
            Sentence("this page is not one of this folder"), Sentence("open the address that `kitrobot` printed")
        )


def _handshake(request: Request) -> Handshake:
    handshake = request.app.state.handshake
    assert isinstance(handshake, Handshake)
    return handshake


def _address(request: Request) -> str:
    """The address at which the connection really ends, whatever the request claims."""
    name, port = request.scope["server"]
    return f"[{name}]:{port}" if ":" in name else f"{name}:{port}"


@handshake_routes.post("")
async def again(request: Request, wanted: AgainAskShape) -> AgainShape:
    """Proves to a page that this studio is one of its folder."""
    answered, proof = _handshake(request).answer(_address(request), wanted.asked)
    return AgainShape(answered=answered, proof=proof)


@handshake_routes.post("/token")
async def again_token(request: Request, response: Response, wanted: AgainProofShape) -> AgainTokenShape:
    """Gives a page of the same folder the token."""
    token = _handshake(request).token_for(_address(request), wanted.asked, wanted.answered, wanted.proof)
    response.headers.append("set-cookie", page_cookie(request.headers, token))
    return AgainTokenShape(token=token)
