"""Takes pictures of the warning that browsers show for a certificate of a class's own: `docs/pictures/warning-*.png`.

    python -m tools.warning_pictures

The certificate is the one that `kitrobot class --https` makes, and the buttons are those of the pictures: pressed one
after another they lead to the page. Needs the package `cryptography`, a Firefox, and a whole Chromium (named in
KITROBOT_CHROMIUM): `chromium-headless-shell` has no warning page.
"""

from __future__ import annotations

import http.server
import json
import os
import ssl
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import TimeoutError, sync_playwright

from tests.patience import PATIENCE_S
from tests.studio.firefox import Firefox, Tab
from tools import chromium, firefox

PICTURES = Path(__file__).resolve().parents[1] / "docs" / "pictures"
SIZE = (900, 1000)
_CARD = 'document.querySelector("net-error-card").shadowRoot'
_ADVANCED, _PROCEED = "#advanced-button", "#exception-button"


class _Page(http.server.BaseHTTPRequestHandler):
    """The page behind the warning."""

    def do_GET(self) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(b"<title>The class</title>")

    def log_message(self, *_: object) -> None:
        """Says nothing."""


@contextmanager
def warned_address() -> Iterator[str]:
    """The address of a page with a certificate of its own."""
    from kitrobot.server.classroom.own_certificate import own_certificate

    with tempfile.TemporaryDirectory() as state:
        os.environ["KITROBOT_STATE"] = state
        path = own_certificate("127.0.0.1").path
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        context.load_cert_chain(path)
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), _Page)
        server.socket = context.wrap_socket(server.socket, server_side=True)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            yield f"https://127.0.0.1:{server.server_port}/"
        finally:
            server.shutdown()


def take_in_chromium(address: str, path: Path) -> bool:
    """Takes the picture; gives whether this Chromium has a warning page."""
    with sync_playwright() as driver:
        browser = driver.chromium.launch(
            executable_path=chromium.find(),
            args=[*chromium.FLAGS, "--headless=new"],
            ignore_default_args=["--headless"],
        )
        page = browser.new_page(viewport={"width": SIZE[0], "height": 600})
        try:
            page.goto(address)
        except Exception as error:
            if "ERR_CERT_AUTHORITY_INVALID" not in str(error):
                raise
        try:
            page.wait_for_selector("#details-button", timeout=10_000)
        except TimeoutError:
            return False
        page.click("#details-button")
        page.wait_for_selector("#proceed-link")
        page.wait_for_timeout(500)  # it glides
        page.screenshot(path=path)
        page.click("#proceed-link")
        page.wait_for_function("document.title === 'The class'")
        browser.close()
        return True


def take_in_firefox(address: str, path: Path) -> None:
    """Takes the picture."""
    with Firefox(firefox.find() or "firefox") as browser:
        try:
            browser.tab(address)
        except AssertionError as error:
            if "SELF_SIGNED" not in str(error):
                raise
        tree: list[Any] = browser.tell("browsingContext.getTree")["contexts"]
        tab = Tab(browser, tree[-1]["context"])
        tab.size(*SIZE)
        _press(tab, _ADVANCED)
        # It cannot be pressed at first.
        _until(tab, f"{_CARD}.querySelector('{_PROCEED}')?.disabled === false")
        _ask(tab, f"{_CARD}.querySelector('{_PROCEED}').scrollIntoView({{ block: 'end' }})")
        path.write_bytes(tab.picture())
        _press(tab, _PROCEED)
        _until(tab, "document.title === 'The class'")


def _ask(tab: Tab, expression: str) -> Any:
    """What an expression gives in the page, which may not run what the tests put into pages."""
    answer = tab.firefox.tell(
        "script.evaluate", expression=expression, target={"context": tab.context}, awaitPromise=False
    )
    return answer.get("result", {}).get("value")


def _until(tab: Tab, expression: str) -> None:
    end = time.monotonic() + PATIENCE_S
    while not _ask(tab, f"Boolean({expression})"):
        if time.monotonic() > end:
            raise AssertionError(f"in vain: {expression}")


def _press(tab: Tab, button: str) -> None:
    _until(tab, f"{_CARD}?.querySelector('{button}')")
    _ask(tab, f"{_CARD}.querySelector('{button}').scrollIntoView({{ block: 'center' }})")
    middle = "(r => JSON.stringify([r.x + r.width / 2, r.y + r.height / 2].map(Math.round)))"
    x, y = json.loads(_ask(tab, f"{middle}({_CARD}.querySelector('{button}').getBoundingClientRect())"))
    press: list[dict[str, object]] = [{"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
    actions = [{"type": "pointerMove", "x": x, "y": y}, *press]
    tab.firefox.tell(
        "input.performActions",
        context=tab.context,
        actions=[{"type": "pointer", "id": "pointer", "actions": actions}],
    )


def main() -> int:
    with warned_address() as address:
        take_in_firefox(address, PICTURES / "warning-firefox.png")
        if not take_in_chromium(address, PICTURES / "warning-chrome.png"):
            print("left out: this Chromium has no warning page; name a whole one in KITROBOT_CHROMIUM")
    return 0


if __name__ == "__main__":
    sys.exit(main())
