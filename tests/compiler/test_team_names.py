"""Groups that hold themselves, against a search from each of them, and in time linear in what they hold."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.team_names import Names
from kitrobot.lll import parse_team
from kitrobot.primitives import Crew, declaring

NAMES = ("a", "b", "c", "d", "e", "f")


def in_circles(groups: dict[str, list[str]]) -> frozenset[str]:
    text = "".join(f"group {name} = {{{', '.join(members)}}};" for name, members in groups.items())
    return Names(declaring(Crew(), parse_team(text).program)).in_circles


def holds_itself(groups: dict[str, list[str]], group: str) -> bool:
    reached = set(groups[group])
    for _ in groups:
        reached |= {inner for name in reached for inner in groups.get(name, [])}
    return group in reached


@given(st.dictionaries(st.sampled_from(NAMES), st.lists(st.sampled_from(NAMES), min_size=1, max_size=3, unique=True)))
def test_the_groups_in_circles_are_those_that_a_search_from_them_comes_back_to(groups: dict[str, list[str]]) -> None:
    assert in_circles(groups) == {name for name in groups if holds_itself(groups, name)}
