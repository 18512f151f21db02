"""The pages of a class: `/` for pupils, `/teacher` for the teacher, `/studio` for the teacher's own studio.

All are the built page, with a word in its head that names its user. With a static site (`kitrobot site`) the
page of pupils is that of the site: Python runs in it, and the class only keeps its work.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

from fastapi import FastAPI, Request, Response
from fastapi.responses import HTMLResponse
from starlette.exceptions import HTTPException
from starlette.types import Scope

from kitrobot.server import fallback_pages
from kitrobot.server.page_files import PageFiles
from kitrobot.server.security import CONTENT_POLICY
from kitrobot.text.sentences import Sentence

PUPIL: Final = "pupil"
ROLES: Final = {"/": PUPIL, "/index.html": PUPIL, "/teacher": "teacher", "/studio": ""}
POLICY: Final = CONTENT_POLICY.replace("script-src 'self'", "script-src 'self' 'wasm-unsafe-eval'")
"""The files of a site may compile WebAssembly, which Python is there."""


def serve_pages(app: FastAPI, static: Path, site: Path | None) -> None:
    """Adds the pages and their files to an application.

    Args:
        app: the class.
        static: the built page.
        site: the folder of a static site, None where the studios of pupils are in this process.
    """

    def page(request: Request) -> Response:
        role = ROLES[request.url.path]
        source = site if site is not None and role == PUPIL else static
        index = source / "index.html"
        if not index.is_file():
            message = Sentence("The studio's page has not been built")
            help = Sentence("run `python tools/page.py build` and load this page again")
            return HTMLResponse(fallback_pages.sentence(message, help), status_code=503)
        text = index.read_text(encoding="utf-8")
        if role:
            text = text.replace("<head>", f'<head><meta name="kitrobot-class" content="{role}">', 1)
        headers = {"cache-control": "no-store"} | ({"content-security-policy": POLICY} if source is site else {})
        return HTMLResponse(text, headers=headers)

    for path in ROLES:
        app.get(path, include_in_schema=False)(page)
    app.mount("/", PageFiles(static) if site is None else _FilesOfBoth(static, site))


class _FilesOfBoth(PageFiles):
    """The files of the built page, and those of a site that it has not.

    Both name the page's assets by what is in them; those of the built page are compressed.
    """

    def __init__(self, static: Path, site: Path) -> None:
        super().__init__(static)
        self._site = PageFiles(site)

    async def get_response(self, path: str, scope: Scope) -> Response:
        """The file, which may compile WebAssembly."""
        try:
            response = await super().get_response(path, scope)
        except HTTPException:
            response = await self._site.get_response(path, scope)
        response.headers["content-security-policy"] = POLICY
        return response
