"""The team's view: roles, groups and work made by dragging and by keys; a first program of a team."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import expect

from tests.studio.conftest import LOOKS, Studio
from tests.studio.looks import choose, find_nothing
from tests.studio.test_variables import save

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]
CONVOY, FILE = "convoy/convoy.krt", "convoy.krt"


def robots_are_dragged_into_roles_and_groups_and_out(studio: Studio) -> None:
    before = (studio.folder / FILE).read_text(encoding="utf-8")
    studio.at("side-team").click()
    leader, follower, spare = studio.at("card-leader"), studio.at("card-follower"), studio.at("card-spare")
    expect(leader).to_contain_text("1 of 1")
    expect(spare.get_by_test_id("chip-robot-4")).to_be_visible()
    studio.drag(studio.at("chip-robot-4"), leader)
    expect(leader.get_by_test_id("chip-robot-4")).to_be_visible()
    studio.expect_code("role leader: mini-robot 1..2;")
    studio.drag(leader.get_by_test_id("chip-robot-4"), follower)
    expect(follower).to_contain_text("3 of 2–3")
    expect(leader.locator(".member-chip")).to_have_count(1)
    studio.drag(studio.at("chip-robot-2"), studio.at("card-convoy"))
    studio.expect_code("group convoy = {leader, follower, robot-2} on failure substitute;")
    chip = studio.at("chip-convoy-robot-2")
    chip.focus()
    studio.page.keyboard.press("Delete")
    studio.expect_code("group convoy = {leader, follower} on failure substitute;")
    # The last one of a role stays, and it is said why.
    studio.drag(studio.at("chip-robot-1"), spare)
    expect(studio.at("roster-said")).to_contain_text("robot-1 is the last one in leader")
    for _ in range(4):
        studio.page.keyboard.press("Control+z")
    assert save(studio, FILE) == before


def the_team_is_made_by_keys_alone(studio: Studio) -> None:
    press = studio.page.keyboard.press
    studio.at("side-parts").focus()
    press("ArrowLeft")
    expect(studio.at("side-team")).to_be_focused()
    studio.at("add-role").focus()
    press("Enter")
    expect(studio.at("name-role")).to_be_focused()
    studio.page.keyboard.type("scout")
    press("Enter")
    expect(studio.at("card-scout")).to_be_visible()
    studio.at("chip-robot-4").focus()
    press("Enter")
    choose_entry = studio.page.get_by_role("menuitemradio", name="Role scout")
    expect(choose_entry).to_be_visible()
    press("r")
    while not choose_entry.evaluate("one => one === document.activeElement"):
        press("ArrowDown")
    press("Enter")
    expect(studio.at("card-scout").get_by_test_id("chip-robot-4")).to_be_visible()
    studio.at("add-work").focus()
    press("Enter")
    expect(studio.at("name-Boxes")).to_be_focused()
    studio.page.keyboard.type("Stones")
    press("Enter")
    studio.at("units-Stones").fill("7")
    press("Enter")
    studio.at("failure-convoy-abort").check()
    saved = save(studio, FILE)
    assert '<role name="scout" robot="mini-robot"/>' in saved
    assert '<work name="Stones" units="7"/>' in saved
    assert 'failure="abort"' in saved


def a_role_is_renamed_where_it_is_spoken_of_and_mistakes_stand_on_its_card(studio: Studio) -> None:
    studio.at("change-leader").click()
    find_nothing(studio, "roster", within=".side")
    name = studio.at("name-leader")
    name.fill("follower")
    expect(studio.page.get_by_role("alert").first).to_contain_text("follower is declared already.")
    name.fill("head of all")
    studio.page.keyboard.press("Enter")
    studio.expect_code('ParOfSeq "head of all"')
    studio.expect_code('group convoy = {"head of all", follower}')
    studio.at("change-follower").click()
    studio.at("most-follower").fill("9")
    studio.page.keyboard.press("Enter")
    studio.at("least-follower").fill("9")
    studio.page.keyboard.press("Enter")
    expect(studio.at("trouble-follower")).to_contain_text("wants 9 of the robot")
    studio.page.keyboard.press("Control+z")
    expect(studio.at("trouble-follower")).to_have_count(0)


@pytest.mark.thorough(
    "web/src/features/team/roster/roster.test.tsx: by keys, menus and drags, renamed, mistakes on cards; dragged, "
    "saved and told in the text: test_a_team_s_program_is_changed_saved_run_and_its_members_are_followed"
)
def test_the_team_is_made_by_keys_and_by_dragging_and_a_role_is_renamed_with_mistakes_on_its_card(
    open_studio: OpenStudio,
) -> None:
    studio = open_studio(CONVOY)
    the_team_is_made_by_keys_alone(studio)
    studio.take_back()
    save(studio, FILE)
    robots_are_dragged_into_roles_and_groups_and_out(studio)
    a_role_is_renamed_where_it_is_spoken_of_and_mistakes_stand_on_its_card(studio)


def a_first_program_of_the_team_is_started(studio: Studio) -> None:
    studio.at("tab-of-team").click()
    expect(studio.at("first-team")).to_contain_text("what the robots do together")
    studio.at("start-team").click()
    expect(studio.at("tab-team")).to_have_attribute("aria-selected", "true")
    studio.expect_code("ParOfSeq square ( PROGRAM square; );")
    expect(studio.at("card-square")).to_contain_text("1 of 1")


def its_members_glow_it_has_programs_of_groups_and_runs(studio: Studio) -> None:
    members_glow_in_a_program_that_stands_in_the_team_s(studio)
    studio.at("add-program").click()
    studio.page.get_by_role("menuitem", name="Program of a group").click()
    expect(studio.at("tab-group")).to_have_attribute("aria-selected", "true")
    studio.at("tab-of-team").click()
    expect(studio.at("first-team")).to_have_count(0)
    expect(studio.at("agent-robot-0")).to_have_value("mini-robot")
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()


def the_projection_follows_each_edit_and_leads_to_vertices_and_back(studio: Studio) -> None:
    studio.at("tab-team").click()
    studio.at("code-tab-projection").click()
    text = studio.at("projection")
    find_nothing(studio, "projection", within=".side")
    expect(text).to_contain_text("Team.Enter(0);")
    expect(studio.at("projection-mini-robot")).to_have_text("square")
    # A line of the program that stands in the team's leads there, and the other way round.
    lines = studio.page.locator('[data-testid="projection"] .cm-line')
    lines.filter(has_text="Wheel.DriveBy").first.click()
    expect(studio.at("tab-square")).to_have_attribute("aria-selected", "true")
    expect(studio.page.locator(".vertex.is-selected")).to_contain_text("Drive")
    expect(text.locator(".line-selected")).to_contain_text(["Wheel.DriveBy"])
    studio.at("tab-team").click()
    studio.page.locator(".vertex", has_text="Each on its own").first.click()
    expect(text.locator(".line-selected").first).to_contain_text("Team.Enter(0);")
    studio.page.keyboard.press("Control+d")
    expect(text).to_contain_text("Team.Enter(2);")
    studio.at("side-team").click()
    studio.at("change-square").click()
    studio.at("remove-square").click()
    expect(studio.at("projection-none")).to_contain_text("There is a mistake")


def test_a_first_program_of_the_team_is_started_and_its_projection_follows_each_edit(open_studio: OpenStudio) -> None:
    studio = open_studio("square/square.krt")
    expect(studio.at("code-tab-projection")).to_have_count(0)
    a_first_program_of_the_team_is_started(studio)
    the_projection_follows_each_edit_and_leads_to_vertices_and_back(studio)


@pytest.mark.thorough(
    "tests/studio/test_team_view.py: started above, run below; what glows: web/src/features/canvas/active.test.tsx;"
    " that teams of one program run: tests/team_programs"
)
def test_a_first_program_of_the_team_glows_and_runs(open_studio: OpenStudio) -> None:
    studio = open_studio("square/square.krt")
    a_first_program_of_the_team_is_started(studio)
    its_members_glow_it_has_programs_of_groups_and_runs(studio)


def robots_are_dragged_into_a_role_of_the_text(studio: Studio) -> None:
    studio.at("side-team").click()
    studio.drag(studio.at("chip-robot-4"), studio.at("card-leader"))
    studio.expect_code("role leader: mini-robot 1..2;")
    studio.at("change-leader").click()
    find_nothing(studio, "roster", within=".side")
    studio.take_back()
    # What is taken back is shown: that was a change of the team.
    studio.page.locator("[role=tab][data-program]").first.click()


def what_is_typed_before_the_instructions_is_declared_and_saved(studio: Studio) -> None:
    studio.edit_code()
    studio.page.keyboard.press("Control+Home")
    studio.page.keyboard.type("work Stones = 3;\n")
    expect(studio.at("saved-state")).to_have_text("not saved")
    studio.at("canvas").focus()
    studio.expect_code("work Stones = 3;")
    studio.page.locator(".vertex", has_text="Each on its own").first.click()
    studio.page.keyboard.press("Control+d")
    saved = save(studio, FILE)
    assert '<work name="Stones" units="3"/>' in saved
    assert '<program name="convoy" level="social">' in saved
    assert saved.count('element="ParOfSeq"') == 3
    studio.take_back()


def test_a_team_s_program_is_changed_saved_run_and_its_members_are_followed(open_studio: OpenStudio) -> None:
    studio = open_studio(CONVOY)
    studio.expect_code("SeqOfPar convoy (")
    expect(studio.page.locator(".vertex.is-unknown")).to_have_count(0)
    expect(studio.at("part-SeqOfPar")).to_be_visible()
    robots_are_dragged_into_a_role_of_the_text(studio)
    what_is_typed_before_the_instructions_is_declared_and_saved(studio)
    every_member_s_place_glows_and_who_is_missing_is_said(studio)


def every_member_s_place_glows_and_who_is_missing_is_said(studio: Studio) -> None:
    studio.full_speed()
    studio.at("run-button").click()
    studio.wait_until_done()
    studio.at("members-button").click()
    # Robot 2 fails after three seconds and is missed after four. Keys that are pressed quickly are all counted.
    studio.at("event-strip").focus()
    for key in ("Home", *["PageUp"] * 6):
        studio.page.keyboard.press(key)
    expect(studio.at("event-strip")).to_have_attribute("aria-valuenow", "300")
    changes = studio.at("members-changes")
    expect(changes).to_contain_text("takes over for robot-2")
    expect(studio.page.locator(".vertex.is-active [data-testid^='member-robot-']").first).to_be_visible()
    expect(studio.at("member-row-robot-4")).to_contain_text("follower, for robot-2")
    expect(studio.at("member-row-robot-2")).to_contain_text("missed")
    expect(studio.at("meeting").first).to_contain_text("2 of 3 are here; robot-4 is missing")
    expect(studio.page.locator('.strip-events [data-kind="member"]')).to_have_count(1)
    # Back to the moment before: nobody is missed, and nobody stands for another.
    changes.get_by_role("button").last.click()
    expect(studio.at("member-row-robot-2")).to_contain_text("follower")
    expect(studio.at("member-row-robot-4")).to_contain_text("spare")
    expect(studio.at("meeting")).to_have_count(0)


def members_glow_in_a_program_that_stands_in_the_team_s(studio: Studio) -> None:
    studio.at("tab-square").click()
    studio.at("run-button").click()
    expect(studio.page.locator(".vertex.is-active .thread").first).to_be_visible()
    studio.at("stop-button").click()


@pytest.mark.thorough("the journeys above look at the roster and at a projection with axe, in the light theme")
@pytest.mark.parametrize("look", LOOKS)
def test_axe_finds_nothing_wrong_with_the_roster(open_studio: OpenStudio, look: tuple[str, ...]) -> None:
    studio = open_studio(CONVOY)
    choose(studio, *look)
    studio.at("side-team").click()
    studio.at("change-leader").click()
    studio.at("code-tab-projection").click()
    expect(studio.at("projection")).to_contain_text("Team.Join();")
    find_nothing(studio, "roster", within=".side")
