"""Debian's Firefox without a window, driven over WebDriver BiDi: numbered JSON messages on a WebSocket.

Playwright drives a Firefox of its own making, or a newer one than Debian's. Firefox chooses its port and prints it; its
profile is a temporary folder. What is waited for is looked at in the page, in each frame.
"""

from __future__ import annotations

import base64
import json
import os
import subprocess
import tempfile
import threading
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any

from websockets.sync.client import connect

from tests.patience import PATIENCE_S, STATE_MS

LISTENS = "WebDriver BiDi listening on "
PREFERENCES: dict[str, object] = {
    # Nothing is asked for outside this machine.
    "app.normandy.enabled": False,
    "app.update.disabledForTesting": True,
    "browser.safebrowsing.malware.enabled": False,
    "browser.safebrowsing.phishing.enabled": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "extensions.getAddons.cache.enabled": False,
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
    "services.settings.server": "data:,",
    # Pages do not glide.
    "ui.prefersReducedMotion": 1,
}
EVENTS = ["log.entryAdded", "network.beforeRequestSent", "browsingContext.load"]
KEYS = {
    **{f"F{number}": chr(0xE030 + number) for number in range(1, 13)},
    "Backspace": "\ue003",
    "Enter": "\ue006",
    "Shift": "\ue008",
    "Control": "\ue009",
    "Alt": "\ue00a",
    "Escape": "\ue00c",
    "End": "\ue010",
    "ArrowLeft": "\ue012",
    "ArrowUp": "\ue013",
    "ArrowRight": "\ue014",
    "ArrowDown": "\ue015",
    "Delete": "\ue017",
}
UNTIL = """(ask, limit) => new Promise((yes, no) => {
    const end = performance.now() + limit;
    const look = () => {
        const seen = ask();
        if (seen) yes(seen instanceof Node || seen);
        else if (performance.now() > end) no(new Error(`in vain: ${ask}; ${document.body.innerText.slice(0, 2000)}`));
        else requestAnimationFrame(look);
    };
    look();
})"""
AT = """const at = (name) => document.querySelector(name.startsWith(":") ? name.slice(1) : `[data-testid="${name}"]`);
let last = "";
/** The middle of what is asked for, once it stands still and nothing covers it. */
const still = (name) => {
    const found = at(name);
    if (!found || found.disabled) return null;
    const seen = found.getBoundingClientRect();
    const { left, top, width, height } = seen;
    const [x, y] = [Math.floor(left + width / 2), Math.floor(top + height / 2)];
    const there = JSON.stringify(seen);
    if (there !== last) {
        last = there;
        if (x < 0 || y < 0 || x >= innerWidth || y >= innerHeight) found.scrollIntoView({ block: "center" });
        return null;
    }
    const hit = document.elementFromPoint(x, y);
    const free = hit && (found.contains(hit) || hit.contains(found) || hit.closest("label")?.contains(found));
    return width > 0 && free ? [x, y] : null;
};
"""


class Firefox:
    """One Firefox, which ends with its `with`. `faults`: what pages reported; `asked`: addresses of their requests."""

    def __init__(self, program: str, **preferences: object) -> None:
        self.faults: list[str] = []
        self.asked: list[str] = []
        self._said: dict[int, dict[str, Any]] = {}
        self._last = 0
        self._ends = ExitStack()
        with ExitStack() as ends:
            profile = Path(
                ends.enter_context(tempfile.TemporaryDirectory(prefix="kitrobot-firefox-", ignore_cleanup_errors=True))
            )
            wanted = PREFERENCES | preferences
            lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in wanted.items()]
            (profile / "user.js").write_text("\n".join(lines), encoding="utf-8")
            words = [program, "--headless", "--no-remote", "--remote-debugging-port", "0", "--profile", str(profile)]
            own = {"HOME": str(profile), "MOZ_CRASHREPORTER_DISABLE": "1"}
            process = ends.enter_context(
                subprocess.Popen(words, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, env=os.environ | own)
            )
            ends.callback(process.kill)
            assert process.stderr is not None
            heard = iter(line.decode(errors="replace") for line in process.stderr)
            address = next(line.split(LISTENS)[1].strip() for line in heard if LISTENS in line)
            # What else it says is read away, or it would wait for a reader.
            threading.Thread(target=list, args=(heard,), daemon=True).start()
            self._wire = ends.enter_context(
                connect(
                    f"{address}/session", compression=None, max_size=None, ping_interval=None, open_timeout=PATIENCE_S
                )
            )
            self.tell("session.new", capabilities={})
            ends.callback(self._quit, process)
            self.tell("session.subscribe", events=EVENTS)
            self._ends = ends.pop_all()

    def __enter__(self) -> Firefox:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._ends.close()

    def _quit(self, process: subprocess.Popen[bytes]) -> None:
        self.tell("browser.close")
        process.wait(PATIENCE_S)

    def tell(self, method: str, **words: object) -> dict[str, Any]:
        """What Firefox answers to a command; events that come before are kept."""
        self._last += 1
        self._wire.send(json.dumps({"id": self._last, "method": method, "params": words}))
        while True:
            heard = json.loads(self._wire.recv(PATIENCE_S))
            if heard.get("id") == self._last:
                assert heard["type"] == "success", f"{method}: {heard.get('message')}"
                return dict(heard["result"])
            self._hear(heard)

    def _hear(self, event: dict[str, Any]) -> None:
        told = event["params"]
        if event["method"] == "log.entryAdded" and told["level"] in ("error", "warn"):
            self.faults.append(told["text"])
        if event["method"] == "network.beforeRequestSent":
            self.asked.append(told["request"]["url"])

    def tab(self, address: str, width: int = 1440, height: int = 900) -> Tab:
        """A new tab of that size, in which the address begins to load."""
        tab = Tab(self, str(self.tell("browsingContext.create", type="tab")["context"]))
        tab.size(width, height)
        tab.go(address)
        return tab


@dataclass(frozen=True)
class Tab:
    """A page. What has a test id is named by it, other things by a selector behind a colon."""

    firefox: Firefox
    context: str

    def _tell(self, method: str, **words: object) -> dict[str, Any]:
        return self.firefox.tell(method, context=self.context, **words)

    def size(self, width: int, height: int) -> None:
        self._tell("browsingContext.setViewport", viewport={"width": width, "height": height})

    def go(self, address: str) -> None:
        self._tell("browsingContext.navigate", url=address, wait="interactive")

    def reload(self) -> None:
        self._tell("browsingContext.reload", wait="interactive")

    def close(self) -> None:
        self._tell("browsingContext.close")

    def picture(self) -> bytes:
        """A PNG."""
        return base64.b64decode(self._tell("browsingContext.captureScreenshot")["data"])

    def ask(self, function: str, *values: object) -> Any:
        """What a function of the page makes of the values, once that is there."""
        answer = self.firefox.tell(
            "script.callFunction",
            functionDeclaration=f"async (words) => {{ {AT}\nconst made = await ({function})(...JSON.parse(words));\n"
            "return JSON.stringify(made); }",
            arguments=[{"type": "string", "value": json.dumps(values)}],
            target={"context": self.context},
            awaitPromise=True,
        )
        assert answer["type"] == "success", answer["exceptionDetails"]["text"]
        return json.loads(answer["result"].get("value", "null"))

    def until(self, ask: str, *values: object) -> Any:
        """Waits until a function of the page gives something that is true."""
        return self.ask(f"(...values) => ({UNTIL})(() => ({ask})(...values), {STATE_MS})", *values)

    def shows(self, name: str, text: str) -> None:
        """Waits until that stands in something."""
        self.until("(name, text) => at(name)?.textContent.includes(text)", name, text)

    def _act(self, kind: str, actions: list[dict[str, object]]) -> None:
        self._tell("input.performActions", actions=[{"type": kind, "id": kind, "actions": actions}])

    def press(self, keys: str) -> None:
        """One key, with others held: `Control+s`."""
        values = [KEYS.get(key, key) for key in keys.split("+")]
        down: list[dict[str, object]] = [{"type": "keyDown", "value": value} for value in values]
        up: list[dict[str, object]] = [{"type": "keyUp", "value": value} for value in reversed(values)]
        self._act("key", [*down, *up])

    def write(self, text: str) -> None:
        """Types."""
        self._act("key", [{"type": kind, "value": letter} for letter in text for kind in ("keyDown", "keyUp")])

    def click(self, name: str, button: int = 0) -> None:
        x, y = self.until("still", name)
        down, up = {"type": "pointerDown", "button": button}, {"type": "pointerUp", "button": button}
        self._act("pointer", [{"type": "pointerMove", "x": x, "y": y}, down, up])

    def drag(self, source: str, target: str) -> None:
        """Presses, moves in steps, and lets go over the middle of the target."""
        (left, top), (x, y) = self.until("still", source), self.until("still", target)
        way = [(left + (x - left) * step // 12, top + (y - top) * step // 12) for step in range(13)]
        moves: list[dict[str, object]] = [{"type": "pointerMove", "x": x, "y": y, "duration": 0} for x, y in way]
        self._act(
            "pointer", [moves[0], {"type": "pointerDown", "button": 0}, *moves[1:], {"type": "pointerUp", "button": 0}]
        )
