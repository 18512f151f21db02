"""The studio of a folder, as its user's other processes find it: where it listens, and what its pages know it by.

Of each folder there is a place in the user's state folder, which only the user may read. It holds

- `lock`, a lock of the system that the running studio holds: it ends with the process, so a record that was left behind
  by a kill is never taken for a studio;
- `running`, the address and the token of the studio that holds the lock;
- `kept`, data that outlives a studio: its port, and the secret by which its pages know the next one (handshake);
- `open-*.html`, pages that lead the browser to an address with its token, which has no place in the browser's command
  line: other users of the machine can read that.

Where the state folder cannot be used nothing is stored and no studio is found; the studio runs without.
"""

from __future__ import annotations

import contextlib
import hashlib
import hmac
import http.client
import json
import os
import secrets
import socket
import stat
import tempfile
import time
import urllib.request
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.file_lock import FileLock
from kitrobot.server import fallback_pages
from kitrobot.server.handshake_proof import compute_proof
from kitrobot.text.sentences import Sentence
from kitrobot.user_folders import state_folder

_LARGEST_BYTES = 10_000
_STARTS_WITHIN_S = 10.0
_ANSWERS_WITHIN_S = 3.0
_RETRY_INTERVAL_S = 0.05


class PresenceError(KitRobotError):
    """The folder's studio cannot be found."""


@dataclass(frozen=True)
class StudioInfo:
    """A studio that listens: `address` ends with `/`."""

    address: str
    token: str


class Presence:
    """The place of one folder; `secret` is what its pages know its studios by, the same from start to start."""

    def __init__(self, workspace: Path, state: Path | None = None) -> None:
        # A home may be shared by machines, and an address is of one of them.
        name = f"{socket.gethostname()}\0{workspace.resolve()}".encode(errors="surrogateescape")
        self._place = (state or state_folder()) / "studio" / hashlib.sha256(name).hexdigest()[:16]
        self._lock: FileLock | None = None
        kept = self._read("kept")
        self.secret: str = kept.get("secret") or secrets.token_hex(32)
        port = kept.get("port")
        self.port: int | None = port if isinstance(port, int) and 0 < port < 65536 else None
        """Where the folder's last studio listened: its pages look for the next one there."""

    def acquire(self) -> bool:
        """Becomes the folder's studio. False when another process is it; True also where that is unknown."""
        try:
            self._place.mkdir(mode=0o700, parents=True, exist_ok=True)
            self._lock = FileLock.take(self._place / "lock")
        except OSError:
            return True
        if self._lock is None:
            return False
        self._clear()
        return True

    def acquire_or_find(self) -> StudioInfo | None:
        """Becomes the folder's studio (None), or finds the one that is there, waiting for it while it starts.

        Raises:
            PresenceError: there is one, and it does not answer.
        """
        until = time.monotonic() + _STARTS_WITHIN_S
        while not self.acquire():
            found = self._read("running")
            running = StudioInfo(str(found.get("address", "")), str(found.get("token", "")))
            if running.token and self._answers(running.address):
                return running
            if time.monotonic() > until:
                raise PresenceError(
                    Sentence("the studio of this folder runs already, and does not answer"),
                    Sentence("end it in its terminal, or start a second one with --new"),
                )
            time.sleep(_RETRY_INTERVAL_S)
        return None

    def _answers(self, address: str) -> bool:
        """Whether a studio of this folder listens there; no token is sent before it has proved that."""
        secret, asked = self._read("kept").get("secret", ""), secrets.token_hex(32)
        request = urllib.request.Request(
            f"{address}api/again", json.dumps({"asked": asked}).encode(), {"Content-Type": "application/json"}
        )
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        try:
            with opener.open(request, timeout=_ANSWERS_WITHIN_S) as stream:
                said = json.loads(stream.read(_LARGEST_BYTES))
            proof = compute_proof(secret, "studio", urlsplit(address).netloc, asked, said["answered"])
            return hmac.compare_digest(proof, said["proof"])
        except (OSError, ValueError, KeyError, TypeError, http.client.HTTPException):
            return False

    def publish(self, running: StudioInfo, port: int) -> None:
        """Publishes where this process listens, if it is the folder's studio."""
        if self._lock is not None:
            with contextlib.suppress(OSError):
                self._write("kept", json.dumps({"secret": self.secret, "port": port}))
                self._write("running", json.dumps({"address": running.address, "token": running.token}))

    def write_redirect_page(self, address: str) -> Path | None:
        """A file for the user alone that leads a browser on to the address; None where there is no place for it."""
        name = f"open-{secrets.token_hex(8)}.html"
        try:
            self._place.mkdir(mode=0o700, parents=True, exist_ok=True)
            return self._write(name, fallback_pages.redirect(address))
        except OSError:
            return None

    def leave(self) -> None:
        """Ends being the folder's studio."""
        if self._lock is not None:
            self._clear()
            # The file stays: one that is removed while somebody waits for it would be a lock that two can hold.
            os.close(self._lock.handle)
            self._lock = None

    def _clear(self) -> None:
        with contextlib.suppress(OSError):
            for path in [self._place / "running", *self._place.glob("open-*.html")]:
                path.unlink(missing_ok=True)

    def _read(self, name: str) -> dict[str, Any]:
        """The content of a file of ours; empty when it is missing, or when another user could read or write it."""
        flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)
        try:
            with os.fdopen(os.open(self._place / name, flags), "rb") as stream:
                state = os.fstat(stream.fileno())
                strange = os.name != "nt" and (state.st_uid != os.geteuid() or state.st_mode & 0o077)
                if strange or not stat.S_ISREG(state.st_mode):
                    return {}
                found = json.loads(stream.read(_LARGEST_BYTES))
        except (OSError, ValueError):
            return {}
        return found if isinstance(found, dict) else {}

    def _write(self, name: str, text: str) -> Path:
        """Writes a file that only the user may read, whole or not at all."""
        handle, temporary = tempfile.mkstemp(dir=self._place, prefix=".new-")  # mode 0600
        try:
            with os.fdopen(handle, "w", encoding="utf-8") as stream:
                stream.write(text)
            os.replace(temporary, self._place / name)
        except BaseException:
            with contextlib.suppress(OSError):
                os.unlink(temporary)
            raise
        return self._place / name
