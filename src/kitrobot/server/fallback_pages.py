"""The few pages that the studio writes itself: a sentence and a way out, for when the real page cannot be shown."""

from __future__ import annotations

import html
import re
from collections.abc import Mapping

from kitrobot.server.tls_door import certificate_address
from kitrobot.text.sentences import Sentence
from kitrobot.translation.languages import LANGUAGES
from kitrobot.translation.reader_language import reader_language
from kitrobot.wire.sentences import spoken

_PAGE = """<!doctype html>
<html lang="{language}" dir="{direction}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>KitRobot</title>
<style>
:root {{ color-scheme: light dark; }}
body {{ font: 16px/1.5 system-ui, sans-serif; max-width: 36rem; margin: 20vh auto 0; padding: 0 1.5rem; }}
h1 {{ font-size: 1.25rem; }}
code {{ direction: ltr; unicode-bidi: isolate; }}
code {{ font-family: ui-monospace, monospace; padding: 0.1em 0.35em; border-radius: 6px; background: #8882; }}
</style>
</head>
<body>
<h1>{message}</h1>
{help}
</body>
</html>
"""


def sentence(message: str, help: str) -> str:
    """A page with one sentence; `words` in back quotes are set as code."""
    return _page(_words(message), _words(help))


def secure_address(address: str, *paragraphs: str) -> str:
    """A page for who asked a server over TLS in plain HTTP: where it is, and what comes there; the word `{certificate}`
    of a paragraph becomes the link to its certificate.
    """
    links = {"{address}": address, "{certificate}": certificate_address(address)}
    return _page(*(_linked(one, links) for one in (Sentence("The class is at {address}", "{address}"), *paragraphs)))


def _page(message: str, *paragraphs: str) -> str:
    language = reader_language()
    return _PAGE.format(
        language=language,
        direction=LANGUAGES[language].direction,
        message=message,
        help="\n".join(f"<p>{one}</p>" for one in paragraphs if one),
    )


def _linked(text: str, links: Mapping[str, str]) -> str:
    made = _words(text)
    for word, address in links.items():
        shown = html.escape(address)
        made = made.replace(word, f'<a href="{shown}"><bdi>{shown}</bdi></a>')
    return made


def redirect(address: str) -> str:
    """A page that leads on to an address at once."""
    shown = html.escape(address)
    return (
        '<!doctype html>\n<meta charset="utf-8">\n<meta name="referrer" content="no-referrer">\n'
        f'<title>KitRobot</title>\n<meta http-equiv="refresh" content="0; url={shown}">\n'
        f'<a href="{shown}">KitRobot</a>\n'
    )


def _words(text: str) -> str:
    return re.sub(r"`([^`]*)`", r"<code>\1</code>", html.escape(spoken(text)))
