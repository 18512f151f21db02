"""A page in Chromium, measured as its user waits for it: on the clock, from the input to the frame with the answer.

A time ends when the frame in which a condition holds has been drawn: the next animation frame, and a task after it.
Frames a second are the animation frames between a press of the mouse and its release, while it moves as fast as the
page takes it; sixty is the most there is.
"""

from __future__ import annotations

import gzip
import re
import subprocess
import sys
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page, sync_playwright

from tools import chromium

WIDTH, HEIGHT = 1600, 1000
PATIENCE_MS = 30_000

_SCRIPT = """
(() => {
  const painted = () =>
    new Promise((ready) => requestAnimationFrame(() => setTimeout(() => ready(performance.now()), 0)));
  const when = (holds) => new Promise((ready) => {
    const look = () => {
      let held = false;
      try { held = holds(); } catch {}
      if (held) void painted().then(ready);
      else setTimeout(look, 1);
    };
    look();
  });
  let pressed = 0;
  addEventListener("keydown", (event) => { pressed = event.timeStamp; }, true);
  const frames = { count: 0, from: 0, to: 0, on: false };
  const count = (now) => {
    if (!frames.on) return;
    if (frames.from === 0) frames.from = now;
    else frames.count += 1;
    frames.to = now;
    requestAnimationFrame(count);
  };
  window.measuring = {
    first: (holds) => when(holds),
    // ms from the last key that was pressed, or from the call of `act`.
    expect: (holds) => { measuring.waiting = when(holds).then((at) => at - pressed); },
    act: async (act, holds) => { const from = performance.now(); await act(); return (await when(holds)) - from; },
    begin: () => {
      Object.assign(frames, { count: 0, from: 0, to: 0, on: true });
      requestAnimationFrame(count);
    },
    end: () => { frames.on = false; return (1000 * frames.count) / (frames.to - frames.from); },
  };
})();
"""


@contextmanager
def browser() -> Iterator[Browser | None]:
    """The Chromium of the machine; None where there is none."""
    path = chromium.find()
    if path is None:
        yield None
        return
    with sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=path, args=list(chromium.FLAGS))
        try:
            yield found
        finally:
            found.close()


@contextmanager
def studio(mission: Path) -> Iterator[str]:
    """A studio in a process of its own on a mission's file; gives its address."""
    command = [sys.executable, "-m", "kitrobot", "studio", str(mission), "--no-browser", "--port", "0"]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        assert server.stdout is not None
        said = re.search(r"http://\S+", server.stdout.readline())
        assert said is not None, "the studio says its address on its first line"
        yield said.group(0)
    finally:
        server.terminate()
        server.wait(10)


@contextmanager
def opened(browser: Browser, address: str, shown: str) -> Iterator[tuple[Page, float]]:
    """A page in a browser without a cache, and the ms until `shown`, a condition in JavaScript, was drawn."""
    context = browser.new_context(viewport={"width": WIDTH, "height": HEIGHT})
    context.set_default_timeout(PATIENCE_MS)
    try:
        page = context.new_page()
        page.add_init_script(_SCRIPT + f"measuring.shown = measuring.first(() => {shown});")
        page.goto(address, wait_until="commit")
        yield page, float(page.evaluate("measuring.shown"))
    finally:
        context.close()


def wait(page: Page, shown: str) -> None:
    """Waits until a condition in JavaScript holds and has been drawn."""
    page.evaluate(f"measuring.first(() => {shown})")


def key_to_picture(page: Page, key: str, shown: str) -> float:
    """The ms from a key to the frame that shows what it does."""
    page.evaluate(f"measuring.expect(() => {shown})")
    page.keyboard.press(key)
    return float(page.evaluate("measuring.waiting"))


def act_to_picture(page: Page, act: str, shown: str = "true") -> float:
    """The ms from a call in the page to the frame that shows what it does."""
    return float(page.evaluate(f"measuring.act(() => {act}, () => {shown})"))


def frames_while_dragging(page: Page, x: float, y: float, steps: int) -> float:
    """Frames a second while the mouse, pressed at a place, goes to and fro."""
    mouse = page.mouse
    mouse.move(x, y)
    mouse.down()
    mouse.move(x + 12, y + 12, steps=2)
    page.evaluate("measuring.begin()")
    for number in range(steps):
        along = 1 - abs((number / 20) % 2 - 1)
        mouse.move(x + 300 * along, y + 200 * along)
    rate = float(page.evaluate("measuring.end()"))
    mouse.move(x, y)
    page.keyboard.press("Escape")
    mouse.up()
    return rate


def place_on(page: Page, selector: str, within: str) -> tuple[float, float]:
    """A place where the topmost element is one of those, in px of the window."""
    found = page.evaluate(
        """([selector, within]) => {
          const box = document.querySelector(within).getBoundingClientRect();
          for (let y = box.top + 120; y < box.bottom - 220; y += 8)
            for (let x = box.left + 40; x < box.right - 320; x += 8)
              if (document.elementFromPoint(x, y)?.closest(selector)) return [x, y];
          return null;
        }""",
        [selector, within],
    )
    assert found is not None, f"nothing of {selector} can be pointed at"
    return found[0], found[1]


def weight(page: Page) -> int:
    """The bytes of the page and of all that it fetched so far, as they travelled; what the server tells apart."""
    return int(
        page.evaluate(
            """() => performance.getEntriesByType("resource").concat(performance.getEntriesByType("navigation"))
                 .filter(({ name }) => !/\\/api\\/|given\\.json/.test(name))
                 .reduce((sum, { encodedBodySize }) => sum + encodedBodySize, 0)"""
        )
    )


@contextmanager
def served(files: Mapping[str, tuple[str, bytes]]) -> Iterator[str]:
    """Files by path (kind, content) on a server of this machine, compressed for who takes it; gives its address."""
    packed = {path: (kind, gzip.compress(content, 9)) for path, (kind, content) in files.items()}
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Files, packed))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


class _Files(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def __init__(self, files: Mapping[str, tuple[str, bytes]], *given: Any) -> None:
        self.files = files
        super().__init__(*given)

    def do_GET(self) -> None:
        kind, content = self.files.get(self.path.lstrip("/"), ("", b""))
        self.send_response(200 if kind else 404)
        self.send_header("Content-Type", kind or "text/plain")
        self.send_header("Content-Length", str(len(content)))
        if kind:
            self.send_header("Content-Encoding", "gzip")
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, format: str, *args: Any) -> None:
        """Says nothing."""
