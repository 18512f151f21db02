"""The schemas are what the tables of tags say, and refuse what the readers refuse."""

from __future__ import annotations

import pytest
import xmlschema

from tools import schemas


def test_the_schemas_are_current() -> None:
    assert schemas.stale() == [], "run: python tools/schemas.py"


@pytest.mark.parametrize("name", schemas.TABLES)
def test_every_schema_is_one(name: str) -> None:
    assert xmlschema.XMLSchema(schemas.FOLDER / f"{name}.xsd").elements.keys() == schemas.TABLES[name].keys()


@pytest.mark.parametrize(
    ("tick", "is_valid"), [("0", False), ("1", True), ("1000", True), ("1001", False), ("soon", False)]
)
def test_a_schema_knows_the_limits_of_a_number(tick: str, is_valid: bool) -> None:
    schema = xmlschema.XMLSchema(schemas.FOLDER / "robot.xsd")
    assert schema.is_valid(f'<robot name="small" version="1" tick="{tick}"/>') is is_valid


def test_a_schema_knows_what_must_be_there_and_which_names_differ() -> None:
    schema = xmlschema.XMLSchema(schemas.FOLDER / "robot.xsd")
    light = '<sensor name="Light"/>'
    assert schema.is_valid(f'<robot name="small" version="1">{light}</robot>')
    assert not schema.is_valid(f'<robot version="1">{light}</robot>')
    assert not schema.is_valid(f'<robot name="small" version="1">{light}{light}</robot>')
