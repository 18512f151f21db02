"""The built page's files, as small as the browser takes them.

Beside a file that gets smaller lie the same bytes compressed (`.br`, `.gz`), made when the page was built: nothing is
compressed while somebody waits. The names of assets hold a hash of what is in them, so a browser may keep them.
"""

from __future__ import annotations

import mimetypes
from pathlib import Path

from starlette.datastructures import Headers
from starlette.exceptions import HTTPException
from starlette.responses import Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

_ENCODING_SUFFIXES = {"br": ".br", "gzip": ".gz"}
"""Encodings and the endings of their files, the smallest first."""
_IMMUTABLE = "public, max-age=31536000, immutable"


class PageFiles(StaticFiles):
    """A folder of files, with their compressed twins where the request takes them."""

    def __init__(self, directory: Path) -> None:
        super().__init__(directory=directory, check_dir=False)

    async def get_response(self, path: str, scope: Scope) -> Response:
        """The file, or its smallest twin that the browser can read."""
        response = await self._compressed_response(path, scope) or await super().get_response(path, scope)
        if response.status_code in (200, 304):
            response.headers["vary"] = "accept-encoding"
            if Path(path).parts[:1] == ("assets",):
                response.headers["cache-control"] = _IMMUTABLE
        return response

    async def _compressed_response(self, path: str, scope: Scope) -> Response | None:
        taken = accepted_encodings(Headers(scope=scope).get("accept-encoding", ""))
        for encoding, ending in _ENCODING_SUFFIXES.items():
            if encoding not in taken:
                continue
            try:
                response = await super().get_response(path + ending, scope)
            except HTTPException:
                continue
            response.headers["content-encoding"] = encoding
            response.headers["content-type"] = mimetypes.guess_type(path)[0] or "application/octet-stream"
            return response
        return None


def accepted_encodings(header: str) -> set[str]:
    """The encodings that an Accept-Encoding names, without those it forbids by `q=0`."""
    found = set()
    for part in header.lower().split(","):
        name, _, weight = part.partition(";")
        weight = weight.strip().removeprefix("q=").strip()
        try:
            wanted = weight == "" or float(weight) > 0
        except ValueError:
            wanted = False
        if wanted and name.strip():
            found.add(name.strip())
    return found
