"""The static site in Firefox, by the main path: run, edit, save, another tab, a visit without a server, a link.

One test that starts Python twice, because in a page that takes seconds. The rest is tried in Chromium (`test_site`).
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.sites import made_site
from tests.studio.conftest import IS_OPEN
from tests.studio.firefox import Firefox, Tab
from tests.studio.test_site import BLINK, PATH, FileServer, link

pytestmark = [pytest.mark.firefox, pytest.mark.site]

NO_SERIAL = {"dom.webserial.enabled": False}
"""As older ones are, and Safari."""
HAS_ALL = "() => navigator.serviceWorker.ready.then(() => caches.keys()).then((names) => names.length === 2)"


def opened(tab: Tab) -> None:
    tab.until(IS_OPEN)
    tab.until("() => !at('site')")


def test_a_site_runs_keeps_what_is_saved_and_works_without_its_server_in_firefox(
    firefox_path: str, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    shutil.copytree(made_site(tmp_path_factory.getbasetemp()), tmp_path / PATH.strip("/"))
    server = FileServer(tmp_path)
    with Firefox(firefox_path, **NO_SERIAL) as firefox:
        tab = firefox.tab(server.address)
        opened(tab)

        # The example runs to its end.
        tab.click("speed")
        tab.press("End")
        tab.click("run-button")
        tab.shows("status", "Done")
        tab.shows("arena-summary", "12 of 12 delivered")

        # It is edited by the mouse and by keys.
        tab.drag("part-Wait", "arc-start.next")
        tab.shows("code", "WAIT(10);")
        tab.click(':[data-testid="inspector"] input:not([type="range"])')
        tab.press("Control+a")
        tab.write("0.7 s")
        tab.shows("code", "WAIT(7);")

        # It is saved under a name of its own.
        tab.press("Control+s")
        tab.click("save-name")
        tab.press("Control+a")
        tab.write("mine")
        tab.press("Enter")
        tab.until("() => at('saved-state').textContent === 'saved'")
        tab.press("Control+o")
        tab.shows("open-dialog", "mine")
        tab.press("Escape")

        # Another tab does not write over it.
        other = firefox.tab(server.address)
        other.shows("site", "open in another tab")
        other.close()

        # Once the browser has the files, and Python's memory, nobody else is asked for them.
        tab.ask(HAS_ALL)
        server.end()
        tab.reload()
        opened(tab)
        tab.until("() => document.title.includes('mine')")
        tab.shows("code", "WAIT(7);")

        # A mission in a link is opened. Where robots are looked for it is said what this browser cannot.
        tab.ask("hash => { location.hash = hash; }", link(BLINK, "linked"))
        tab.until("() => document.title.includes('linked')")
        tab.shows("code", "WAIT(17);")
        tab.click("run-on-robot")
        tab.shows("find-board-not", "This browser reaches no boards by itself.")
        tab.shows("robots-in-page", "need KitRobot installed")

        assert firefox.faults == []
        assert [one for one in firefox.asked if not one.startswith((server.address, "data:", "blob:"))] == []
