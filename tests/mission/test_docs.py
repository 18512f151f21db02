"""The page about `.krt` files is right: its example, and its table of elements."""

from __future__ import annotations

import re
from pathlib import Path

from kitrobot.mission.reader import MISSION
from kitrobot.mission.trial import TRIAL, FailureKind
from kitrobot.workspace.mission_loader import open_mission

PAGE = (Path(__file__).parents[2] / "docs" / "krt.md").read_text(encoding="utf-8")
README = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
ROWS = {name: line for line in PAGE.splitlines() if line.startswith("| `<") for name in re.findall(r"`<(\w+)>`", line)}


def test_the_example_opens_without_a_problem_runs_and_is_written_again_to_the_byte(tmp_path: Path) -> None:
    from kitrobot.mission.writer import write_mission

    [example, _] = re.findall(r"```xml\n(.*?)```", PAGE, re.DOTALL)
    path = tmp_path / "example.krt"
    path.write_text(example)
    opened = open_mission(path)
    assert [problem for problem in opened.check().problems if problem.is_error] == []
    assert opened.diagnostics == ()
    assert write_mission(opened.mission).decode() == example
    assert opened.run(seconds=120).ticks > 0


def test_the_example_of_declarations_is_written_as_it_stands() -> None:
    from kitrobot.mission.reader import read_mission
    from kitrobot.mission.writer import write_mission

    [_, example] = re.findall(r"```xml\n(.*?)```", PAGE, re.DOTALL)
    mission, found = read_mission(f'<kitrobot version="1">{example}</kitrobot>'.encode(), "team.krt")
    assert mission is not None
    assert found == []
    assert "".join(f"  {line}\n" for line in example.splitlines()) in write_mission(mission).decode()
    team = MISSION["kitrobot"].children["team"].children
    for name in ("role", "group", "work"):
        assert all(f" {attribute}=" in example for attribute in team[name].attributes), name


def test_every_element_of_a_mission_is_in_the_table_and_the_example() -> None:
    assert set(MISSION["kitrobot"].children) | {"kitrobot"} == set(ROWS)
    for name in ROWS:
        assert f"<{name}" in PAGE.split("```")[1], name


def test_what_breakpoints_and_failures_say_is_told() -> None:
    for name, tag in TRIAL.items():
        assert all(f"`{one}" in ROWS[name] for one in tag.attributes), name
    assert all(f"`{kind}`" in ROWS["failure"] for kind in FailureKind)


def test_the_page_is_linked_from_the_readme() -> None:
    assert "docs/krt.md" in README
