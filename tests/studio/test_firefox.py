"""The studio in Firefox by the main path: run, edit by mouse and keys, save; and the static site, thorough profile.

The rest is tried in Chromium. With the site also: another tab, a visit without a server, a link.
"""

from __future__ import annotations

import shutil
from contextlib import closing
from pathlib import Path

import pytest

from tests.sites import made_site
from tests.studio.conftest import EXAMPLES, IS_OPEN, ServerThread
from tests.studio.firefox import Firefox, Tab
from tests.studio.sites import BLINK, PATH, FileServer, link

pytestmark = pytest.mark.firefox

NO_SERIAL = {"dom.webserial.enabled": False}
"""As older ones are, and Safari."""
HAS_ALL = "() => navigator.serviceWorker.ready.then(() => caches.keys()).then((names) => names.length === 2)"


def opened(tab: Tab) -> None:
    tab.until(IS_OPEN)
    tab.until("() => !at('site')")


def a_mission_runs_to_its_end(tab: Tab) -> None:
    tab.click("speed")
    tab.press("End")
    tab.click("run-button")
    tab.shows("status", "Done")


def it_is_edited_by_the_mouse_and_by_keys_and_saved_under_a_name_of_its_own(tab: Tab) -> None:
    tab.click("arena-text")
    tab.until("() => { at('part-Wait').scrollIntoView(); return true; }")
    tab.drag("part-Wait", "arc-start.next")
    tab.shows("code", "WAIT(10);")
    tab.click(':[data-testid="inspector"] input:not([type="range"])')
    tab.press("Control+a")
    tab.write("0.7 s")
    tab.shows("code", "WAIT(7);")
    tab.press("Control+Shift+s")
    tab.click("save-name")
    tab.press("Control+a")
    tab.write("mine")
    tab.press("Enter")
    tab.until("() => at('saved-state').textContent === 'saved'")


def test_a_mission_runs_is_edited_and_saved_in_firefox(
    firefox_path: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, servers: ServerThread
) -> None:
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    mission = Path(shutil.copy(EXAMPLES / "square" / "square.krt", tmp_path))
    with closing(servers.serve(mission)) as studio, Firefox(firefox_path, **NO_SERIAL) as firefox:
        tab = firefox.tab(studio.address)
        opened(tab)
        a_mission_runs_to_its_end(tab)
        it_is_edited_by_the_mouse_and_by_keys_and_saved_under_a_name_of_its_own(tab)
        assert 'element="Wait"><set name="duration">7</set>' in (tmp_path / "mine.krt").read_text()
        tab.click("run-on-robot")
        tab.shows("find-board-not", "This browser reaches no boards by itself.")
        assert firefox.faults == []


@pytest.mark.site
@pytest.mark.thorough("the visit above to the installed studio; the site in Chromium: test_site.py")
def test_a_site_runs_keeps_what_is_saved_and_works_without_its_server_in_firefox(
    firefox_path: str, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    shutil.copytree(made_site(tmp_path_factory.getbasetemp()), tmp_path / PATH.strip("/"))
    server = FileServer(tmp_path)
    with Firefox(firefox_path, **NO_SERIAL) as firefox:
        tab = firefox.tab(server.address)
        opened(tab)

        a_mission_runs_to_its_end(tab)
        tab.shows("arena-summary", "12 of 12 delivered")
        it_is_edited_by_the_mouse_and_by_keys_and_saved_under_a_name_of_its_own(tab)
        # Answered after the journal was told of the new name.
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
