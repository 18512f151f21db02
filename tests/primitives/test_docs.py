"""The examples of docs/xml.md are right."""

import re
from pathlib import Path

import pytest
import xmlschema

from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.kit_xml import read_kit
from kitrobot.primitives.robot_xml import read_robot
from tests.primitives.test_shipped import SCHEMAS

PAGE = Path(__file__).parents[2] / "docs" / "xml.md"
READERS = {"robot": read_robot, "constructors": read_constructors, "board": read_kit}
EXAMPLES = re.findall(r"```xml\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("example", EXAMPLES, ids=range(len(EXAMPLES)))
def test_an_example_is_read_without_a_problem_and_valid_by_its_schema(example: str) -> None:
    root = re.match(r"<(\w+)", example).group(1)  # type: ignore[union-attr]
    found, problems = READERS[root](example.encode(), "xml.md")
    assert found
    assert problems == []
    xmlschema.XMLSchema(SCHEMAS / f"{root}.xsd").validate(example)


def test_there_are_examples_of_each_kind() -> None:
    assert {re.match(r"<(\w+)", example).group(1) for example in EXAMPLES} == set(READERS)  # type: ignore[union-attr]
