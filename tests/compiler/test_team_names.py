"""Who groups stand for, and which of them hold themselves, against a search from each of them."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.team.names import Names
from kitrobot.lll.parse_results import parse_team
from kitrobot.primitives.crew import Crew, declaring

NAMES = ("a", "b", "c", "d", "e", "f")


AGENTS = (("e", "carrier"), ("f", "carrier"))
ROLE = "role a: carrier;"
"""A role counts before a group of its name, and a group before an agent."""


def names_of(groups: dict[str, list[str]]) -> Names:
    text = "".join(f"group {name} = {{{', '.join(members)}}};" for name, members in groups.items())
    return Names(declaring(Crew(AGENTS), parse_team(ROLE + text).program))


def reached(groups: dict[str, list[str]], name: str) -> set[str]:
    """Every name inside a group."""
    found = set(groups.get(name, []))
    for _ in groups:
        found |= {inner for one in found for inner in groups.get(one, [])}
    return found


GROUPS = st.dictionaries(st.sampled_from(NAMES), st.lists(st.sampled_from(NAMES), min_size=1, max_size=3, unique=True))


@given(GROUPS)
def test_the_groups_in_circles_are_those_that_a_search_from_them_comes_back_to(groups: dict[str, list[str]]) -> None:
    assert names_of(groups).in_circles == {name for name in groups if name in reached(groups, name)}


@given(GROUPS)
def test_a_group_stands_for_the_roles_and_agents_inside_it(groups: dict[str, list[str]]) -> None:
    names = names_of(groups)
    opened = {name: members for name, members in groups.items() if name != "a"}
    for name in NAMES:
        inside = reached(opened, name) if name in opened else {name}
        expected = {one for one in inside if one not in opened and one in {"a", "e", "f"}}
        assert {(atom.name, atom.is_role) for atom in names.atoms((name,))} == {(one, one == "a") for one in expected}
