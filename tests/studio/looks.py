"""Themes and languages of a page, and axe-core, which looks at what it shows."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Page, expect

from kitrobot.translation.languages import TRANSLATED
from tests.effort import THOROUGH
from tests.studio.studio_page import Studio
from tools.sentences import CATALOGUE_SETS, entries, forms

AXE = Path(__file__).resolve().parents[2] / "web" / "node_modules" / "axe-core" / "axe.min.js"

RULES = "{ 'label-content-name-mismatch': { enabled: true } }"
FIND = f"""async ([everyTheme, within]) => {{
    const root = document.documentElement;
    const chosen = root.dataset.theme;
    const all = ['light', 'dark', 'contrast'];
    // What is as it was when axe looked last is left out; the first look is at the whole page.
    const seen = window.axeSeen ??= new WeakMap();
    const around = root.outerHTML.slice(0, root.outerHTML.indexOf('>')) + document.body.className;
    const looks = window.axeLooks = (window.axeLooks ?? -1) + 1;
    const parts = [...document.querySelectorAll('.studio > *, .studio > * > *')];
    // Written out only where it is asked what is new: it is all of the page.
    const now = new Map(within !== '' ? [] : parts.map(part => [part, around + part.outerHTML]));
    const same = part => now.has(part) && seen.get(part) === now.get(part);
    const where = within !== '' ? {{ include: [[within]] }}
        : {{ include: [document], exclude: parts.filter(part => same(part) && !same(part.parentElement)) }};
    const colours = {{ type: 'rule', values: ['color-contrast', 'link-in-text-block'] }};
    const violations = [];
    let passes = 0;
    const others = all.filter(one => one !== chosen);
    for (const theme of everyTheme ? [chosen, ...others] : [all[(all.indexOf(chosen) + looks) % 3]]) {{
        root.dataset.theme = theme;
        const narrowed = passes > 0 ? {{ runOnly: colours }} : {{ rules: {RULES} }};
        const found = await axe.run(where, {{ resultTypes: ['violations'], ...narrowed }});
        passes ||= found.passes.length;
        for (const one of found.violations)
            violations.push(...one.nodes.map(node => `${{theme}}: ${{one.id}}: ${{node.target}}`));
    }}
    root.dataset.theme = chosen;
    if (within === '') now.forEach((text, part) => seen.set(part, text));
    return {{ passes, violations }};
}}"""


RUN = {"en": "Run"} | {
    language: forms(entries(CATALOGUE_SETS["page"].catalogue(language))["run.run", "Run"])[0] for language in TRANSLATED
}
CUT_OFF = """() => [...document.querySelectorAll(
    '.menubar-title, .palette-name, .vertex-name, .chip-words, .run-button, .side-tab, .tab-name, h2, .team-stop'
)].filter(one => one.offsetParent !== null && one.scrollWidth > one.clientWidth + 1
    && getComputedStyle(one).display !== 'inline')
  .map(one => `${one.className} ${one.textContent}`)"""


def choose(studio: Studio, *entries: str) -> None:
    """Chooses entries of the View menu; a language is there when the page speaks it, which takes loading it."""
    for entry in entries:
        studio.at("menu-View").click()
        studio.at(f"menu-view-{entry}").click()
        if entry in RUN:
            expect(studio.at("run-button")).to_have_text(RUN[entry])


def find_nothing(studio: Studio | Page, screen: str, every_theme: bool = THOROUGH, within: str = "") -> None:
    """Runs axe over the page as it stands: first over all of it, then over what is new.

    With `within`, a selector, only what is in there is looked at, but in the thorough profile all. Each look is in the
    next one of the three themes, beginning with the chosen one; in the thorough profile, and where it is asked for, in
    all of them.
    """
    page = studio if isinstance(studio, Page) else studio.page
    if page.evaluate("typeof axe") == "undefined":
        page.evaluate(AXE.read_text(encoding="utf-8") + ";0")
    inside = "" if THOROUGH else within
    found = page.evaluate(FIND, [every_theme, inside])
    assert found["passes"] > (2 if inside else 10), screen
    assert found["violations"] == [], screen
