"""The examples of docs/xml.md are right."""

import re
from pathlib import Path

import pytest
import xmlschema

from kitrobot.primitives import read_constructors, read_robot
from tests.primitives.test_shipped import SCHEMAS

PAGE = Path(__file__).parents[2] / "docs" / "xml.md"
EXAMPLES = re.findall(r"```xml\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("example", EXAMPLES, ids=range(len(EXAMPLES)))
def test_an_example_is_read_without_a_problem_and_valid_by_its_schema(example: str) -> None:
    root = "robot" if example.startswith("<robot") else "constructors"
    found, problems = (read_robot if root == "robot" else read_constructors)(example.encode(), "xml.md")
    assert found
    assert problems == []
    xmlschema.XMLSchema(SCHEMAS / f"{root}.xsd").validate(example)


def test_there_are_examples_of_both_kinds() -> None:
    assert {re.match(r"<(\w+)", example).group(1) for example in EXAMPLES} == {"robot", "constructors"}  # type: ignore[union-attr]
