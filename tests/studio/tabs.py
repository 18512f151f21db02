"""Tabs of the browser that tests use one after another.

A tab that is led on keeps its process, and what that has compiled and laid out: opening the studio in it takes a third
of the work of opening it in a new one. Between two tests a tab stands on an empty page of the studio's own address,
without anything kept and nobody's keys held. A test gets it with a window of its own size; what is fixed as a tab is
made (fingers, language, whether the text is kept) decides which tests share one.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal

from playwright.sync_api import Browser, Page, ViewportSize
from playwright.sync_api import Error as PlaywrightError

from tests.patience import STATE_MS

NOTHING = "/nothing"
"""The path of the empty page: between two tests a tab is of no studio, and yet at the address of all of them."""
IDLE, USES = 3, 16
"""How many tabs wait for the next test, and how many tests use one: the browser frees little between them."""
KEEP_TEXT = """try {
    if (localStorage.getItem("kitrobot.text") === null) localStorage.setItem("kitrobot.text", "yes");
    if (localStorage.getItem("kitrobot.simple") === null) localStorage.setItem("kitrobot.simple", "no");
} catch {}"""
"""Somebody who works with the text, and with every detail, asks once that they stay."""
HANDS_MS = int(os.environ.get("KITROBOT_HANDS_MS", "0"))
"""How long a test waits between two things it does: what comes late in the page has come by then."""
LINE_MS = int(os.environ.get("KITROBOT_LINE_MS", "0"))
"""How long each request of the page takes more: what is fetched at its first use comes after the next keys."""


Kind = tuple[bool, dict[str, Any]]
"""What stays as a tab is made: whether its visits are first ones, and the words of its context but for `CHANGED`."""
CHANGED = ("viewport", "reduced_motion")
"""Words of a context that each test sets anew."""


@dataclass
class Tab:
    """A page in a context of its own, what is fixed of it, and how many tests it has served."""

    page: Page
    kind: Kind
    uses: int = 0
    listeners: list[tuple[str, Callable[..., None]]] = field(default_factory=list)

    def hear(self, event: str, listener: Callable[..., None]) -> None:
        """Tells the listener of an event until the test has ended."""
        self.page.on(event, listener)  # type: ignore[call-overload]
        self.listeners.append((event, listener))

    def clear(self, address: str) -> bool:
        """Leads the tab away from the studio at that address, and takes back all that the test did to it."""
        page = self.page
        for event, listener in self.listeners:
            page.remove_listener(event, listener)
        self.listeners.clear()
        self.uses += 1
        if page.is_closed() or self.uses >= USES:
            return False
        for other in page.context.pages:
            if other != page:
                other.close()
        page.unroute_all()
        page.context.clear_permissions()
        page.goto(address + NOTHING)
        page.evaluate("localStorage.clear(); sessionStorage.clear()")
        page.context.clear_cookies()
        for key in ("Shift", "Control", "Alt", "Meta"):
            page.keyboard.up(key)
        page.mouse.up()
        page.mouse.move(-9, -9)
        return True

    def set_up(self, viewport: ViewportSize, reduced_motion: Literal["reduce", "no-preference"]) -> None:
        """Gives the page a window of that size, and the usual colours."""
        if self.page.viewport_size != viewport:
            self.page.set_viewport_size(viewport)
        self.page.emulate_media(
            media="null",
            color_scheme="light",
            reduced_motion=reduced_motion,
            forced_colors="none",
            contrast="no-preference",
        )


class Tabs:
    """The tabs of a worker; those that no test uses wait, the last one used last."""

    def __init__(self, browser: Browser) -> None:
        self._browser = browser
        self._idle: list[Tab] = []

    def take(self, device: dict[str, Any], *, first_visit: bool = False) -> Tab:
        """A tab of that device, for one test; unless it is a first visit, its text stays beside what runs."""
        kind = (first_visit, {word: value for word, value in device.items() if word not in CHANGED})
        found = next((tab for tab in reversed(self._idle) if tab.kind == kind), None)
        if found is None:
            found = self._make(kind, device)
        else:
            self._idle.remove(found)
        found.set_up(*(device[word] for word in CHANGED))
        return found

    def _make(self, kind: Kind, device: dict[str, Any]) -> Tab:
        """A tab in which nothing was opened before."""
        context = self._browser.new_context(**device)
        if not kind[0]:
            context.add_init_script(KEEP_TEXT)
        context.set_default_timeout(STATE_MS)
        page = context.new_page()
        if LINE_MS > 0:
            line = {"offline": False, "latency": LINE_MS, "downloadThroughput": -1, "uploadThroughput": -1}
            session = context.new_cdp_session(page)
            session.send("Network.enable")
            session.send("Network.emulateNetworkConditions", line)
        return Tab(page, kind)

    def give_back(self, tab: Tab, address: str) -> None:
        """Keeps a tab whose test has ended for another one, or closes it."""
        try:
            kept = tab.clear(address)
        except PlaywrightError:
            kept = False  # its page has crashed, which its test has told
        if not kept:
            tab.page.context.close()
            return
        self._idle.append(tab)
        while len(self._idle) > IDLE:
            self._idle.pop(0).page.context.close()

    def close(self) -> None:
        for tab in self._idle:
            tab.page.context.close()
