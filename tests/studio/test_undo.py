"""Undo has no holes: edits of all kinds at random, by mouse and keys, are taken back to the very bytes of the file."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import Studio

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
FILE = "transport.krt"
NAMES = ("Scout", "چکر", "Rounds", "Zeta", "Kappa", "Omega", "Sigma", "Tau")


class Editor:
    """Hands that do something at random; each way says nothing when it cannot be done now."""

    def __init__(self, studio: Studio, seed: int) -> None:
        self.studio = studio
        self.page = studio.page
        self.dice = random.Random(seed)
        self.names = list(NAMES)
        self.dice.shuffle(self.names)

    def name(self) -> str:
        """A name that nobody has yet."""
        return self.names.pop() if self.names else f"N{self.dice.randrange(10**6)}"

    def program(self) -> None:
        """Opens the first program, with something of it selected."""
        self.studio.at("tab-carrier").click()
        self.studio.at("canvas").focus()
        for _ in range(self.dice.randrange(1, 6)):
            self.page.keyboard.press("ArrowDown")

    def add_part(self) -> None:
        self.program()
        self.page.keyboard.press("/")
        self.studio.at("add-find").fill(self.dice.choice(("Wait", "While", "Advance", "Forever")))
        self.page.keyboard.press("Enter")

    def delete_part(self) -> None:
        self.program()
        self.page.keyboard.press("Delete")

    def duplicate_part(self) -> None:
        self.program()
        self.page.keyboard.press("Control+d")

    def note(self) -> None:
        self.program()
        self.page.keyboard.press("n")
        field = self.studio.at("note-field")
        if field.count():
            field.fill(f"note {self.dice.random()}")
            self.page.keyboard.press("Enter")

    def parameter(self) -> None:
        self.program()
        field = self.page.locator('.inspector input[data-testid^="field-"]').first
        if field.count():
            field.fill(str(self.dice.randrange(1, 90)))
            self.page.keyboard.press("Tab")

    def variable(self) -> None:
        self.program()
        self.page.keyboard.press("Alt+v")
        name = self.name()
        self.studio.at("variable-name").fill(name)
        self.page.keyboard.press("Enter")
        expect(self.studio.at("variable-form")).to_be_hidden()
        found = self.page.locator(f'[data-row="object variable {name}"]')
        expect(found).to_be_visible()
        if self.dice.random() < 0.7:
            self.page.locator(f'[data-testid^="part-{name}."]').first.click()
        if self.dice.random() < 0.5:
            found.focus()
            self.page.keyboard.press("F2")
            other = self.name()
            self.studio.at("variable-rename").fill(other)
            self.page.keyboard.press("Enter")
            expect(self.page.locator(f'[data-row="object variable {other}"]')).to_be_visible()

    def text(self) -> None:
        self.program()
        self.studio.edit_code()
        self.page.keyboard.press("Control+Home")
        self.page.keyboard.insert_text(f"WAIT({self.dice.randrange(1, 99)});\n")
        expect(self.studio.at("code").locator('[aria-busy="true"]')).to_have_count(0)
        self.studio.at("canvas").focus()

    def team(self) -> None:
        self.page.keyboard.press("Alt+t")
        expect(self.studio.at("world-ring")).to_be_visible()

    def agent(self) -> None:
        self.team()
        self.studio.at("add-agent").click()
        self.page.locator('[data-testid^="agent-name-"]').last.fill(self.name())
        self.page.keyboard.press("Enter")

    def agent_away(self) -> None:
        self.team()
        self.page.locator('[data-testid^="agent-remove-"]').nth(self.dice.randrange(3)).click()

    def agent_moves(self) -> None:
        self.team()
        self.studio.at("agent-down-0").click()

    def goal(self) -> None:
        self.team()
        button = self.studio.at("add-goal")
        if button.count() and button.is_enabled():
            button.click()

    def world(self) -> None:
        self.team()
        worlds = self.page.locator(".team-world input")
        worlds.nth(self.dice.randrange(worlds.count())).check()

    def title(self) -> None:
        self.team()
        self.studio.at(self.dice.choice(("team-title", "team-help"))).fill(f"Title {self.dice.random()}")

    def new_program(self) -> None:
        self.page.keyboard.press("Alt+n")
        self.studio.at("menu-add-mini-robot").click()

    def rename_program(self) -> None:
        tab = self.studio.at("tab-loader")
        if tab.count():
            tab.dblclick()
            self.studio.at("tab-name-field").fill(self.name())
            self.page.keyboard.press("Enter")

    def ways(self) -> list[Callable[[], None]]:
        """Everything that can be done."""
        parts = [self.add_part, self.delete_part, self.duplicate_part, self.note, self.parameter, self.text]
        team = [self.agent, self.agent_away, self.agent_moves, self.goal, self.world, self.title]
        return [*parts, *team, self.variable, self.new_program, self.rename_program]


def save(studio: Studio) -> bytes:
    """Saves and gives the bytes of the file."""
    studio.page.keyboard.press("Control+s")
    expect(studio.at("saved-state")).to_have_text("saved")
    return (studio.folder / FILE).read_bytes()


def press_until_nothing_is_left(studio: Studio, keys: str, button: str) -> int:
    """Presses a key until its button says that nothing is left; how often that was."""
    studio.page.evaluate("document.activeElement?.blur()")
    left = studio.page.get_by_role("toolbar").get_by_role("button", name=button)
    for times in range(400):
        if left.is_disabled():
            return times
        studio.page.keyboard.press(keys)
    raise AssertionError(f"{button} never ends")


@pytest.mark.thorough("web/src/model/everything.test.ts; by hand: web/src/features/palette/variables.test.tsx")
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_edits_of_all_kinds_are_undone_to_the_same_bytes_and_done_again(open_studio: OpenStudio, seed: int) -> None:
    studio = open_studio(f"transport/{FILE}")
    before = (studio.folder / FILE).read_bytes()
    hands = Editor(studio, seed)
    ways = hands.ways()
    hands.dice.shuffle(ways)
    for way in ways:
        way()
    after = save(studio)
    assert after != before
    undone = press_until_nothing_is_left(studio, "Control+z", "Undo")
    assert undone >= 10
    assert save(studio) == before
    assert press_until_nothing_is_left(studio, "Control+y", "Redo") == undone
    assert save(studio) == after
