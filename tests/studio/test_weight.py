"""What a first load fetches stays small: scripts, styles, letters and pictures, as they travel."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Route, expect

from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.translation.languages import ENGLISH, TRANSLATED
from kitrobot.wire.catalogue import catalogue_shape
from tests.effort import cases
from tests.studio.conftest import EXAMPLES, Studio

pytestmark = pytest.mark.browser

MOST_BYTES, MOST_BYTES_WITH_EDITING = 290_000, 320_000
FETCHED = """() => {
  const of = (kind) => performance.getEntriesByType(kind);
  return [...of("navigation"), ...of("resource")]
    .map(({ name, encodedBodySize }) => [new URL(name).pathname, encodedBodySize])
    .filter(([path]) => !path.startsWith("/api/"));
}"""

OpenStudio = Callable[..., Studio]


def fetched(studio: Studio) -> dict[str, int]:
    """The bytes of each file that the page has fetched, once it has all that it fetches unasked."""
    expect(studio.at("code-editor").locator(".cm-line").first).to_be_visible()
    studio.page.wait_for_load_state("networkidle")
    return dict(studio.page.evaluate(FETCHED))


def none_comes_before_it_is_used(files: dict[str, int], language: str) -> None:
    others = [f"/{one}-" for one in TRANSLATED if one != language]
    later = ["/all-", "/more-", "/Sheets", "/Panel", "/editing", *others]
    assert [path for path in files if any(name in path for name in later)] == []


TRANSPORT, BLINK = "transport/transport.krt", "blink/blink.krt"


@pytest.mark.parametrize(("example", "language"), cases([(BLINK, "ur")], [(TRANSPORT, "fr"), (BLINK, "en")]))
def test_the_first_load_fits_in_290_kb_and_what_edits_text_comes_with_the_first_touch(
    open_studio: OpenStudio, example: str, language: str
) -> None:
    studio = open_studio(example, first_visit=True, locale=language)
    files = fetched(studio)
    assert any(path.endswith(".woff2") for path in files), "letters count"
    none_comes_before_it_is_used(files, language)
    is_light(files)
    studio.edit_code()
    files = fetched(studio)
    assert any("/editing" in path for path in files)
    is_light(files, MOST_BYTES_WITH_EDITING)


def keys_that_are_pressed_before_what_edits_text_is_there_are_typed(studio: Studio) -> None:
    held: list[Route] = []
    typed: list[bool] = []
    studio.page.route("**/editing-*", lambda route: route.continue_() if typed else held.append(route))
    studio.at("code").locator(".cm-content").focus()
    studio.page.keyboard.press("Control+Home")
    studio.page.keyboard.type("WAIT(7);")
    expect(studio.at("code-editor")).to_have_attribute("data-writable", "false")
    typed.append(True)
    for route in held:
        route.continue_()
    studio.expect_code("WAIT(7);")


def is_light(files: dict[str, int], most_bytes: int = MOST_BYTES) -> None:
    total = sum(files.values())
    assert total <= most_bytes, "\n".join(f"{size} {path}" for path, size in sorted(files.items(), key=lambda f: -f[1]))


def test_every_icon_of_what_ships_travels_with_the_page() -> None:
    theme = Path(__file__).parents[2] / "web" / "src" / "theme"
    sets = [(theme / name).read_text(encoding="utf-8") for name in ("icons.lucide", "more.lucide")]
    travels = {name for one in sets for name in re.sub("(?m)^#.*$", "", one).split()}
    shipped = catalogue_shape(load_catalogue(), ENGLISH).model_dump_json()
    named = set(re.findall(r'"icon":"([a-z0-9-]+)"', shipped))
    lessons = [path.read_text(encoding="utf-8") for path in EXAMPLES.rglob("*.xml")]
    named |= {name for text in lessons for name in re.findall(r'icon="([a-z0-9-]+)"', text)}
    assert len(named) > 40
    assert sorted(named - travels) == [], "such a name makes the page fetch every icon there is"


@pytest.mark.thorough(
    "the test of the first load above: none comes before it is used; web/src/ui/later.test.tsx: a part is fetched "
    "at its first use; held-keys.test.ts: keys that are pressed before it are given to it"
)
def test_a_sheet_comes_at_its_first_use_and_keys_are_typed_that_come_before_what_edits_text(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(TRANSPORT, first_visit=True, locale="en")
    first = fetched(studio)
    is_light(first)
    none_comes_before_it_is_used(first, "en")
    studio.page.keyboard.press("?")
    expect(studio.page.get_by_role("dialog")).to_be_visible()
    assert any("/Sheets" in path for path in fetched(studio))
    studio.page.keyboard.press("Escape")
    keys_that_are_pressed_before_what_edits_text_is_there_are_typed(studio)
