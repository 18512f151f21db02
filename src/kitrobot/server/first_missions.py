"""What a static site draws before Python is there: the mission that a new studio begins with, as the page gets it."""

from __future__ import annotations

import tempfile
from pathlib import Path

from kitrobot.files.examples import first_example
from kitrobot.live.studio import Studio
from kitrobot.server.routes.missions import mission
from kitrobot.translation.languages import LANGUAGES
from kitrobot.translation.reader_language import override_language


def first_missions() -> dict[str, bytes]:
    """A file for each language, by its name in the folder of a site: the answer to `GET /api/mission` (JSON).

    It holds nothing of this machine. None where there is no example to begin with.
    """
    example = first_example()
    if example is None:
        return {}
    with tempfile.TemporaryDirectory() as folder:
        studio = Studio(Path(folder), example)
        return {f"first/{language}.json": _first(studio, language) for language in LANGUAGES}


def _first(studio: Studio, language: str) -> bytes:
    with override_language(language):
        made = mission(studio, studio.first or "")
        # The state of files on this machine.
        return made.model_copy(update={"parts": ""}).model_dump_json(by_alias=True).encode()
