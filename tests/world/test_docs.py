"""The page about worlds is right: its example, its table of elements, and the worlds it lists."""

from __future__ import annotations

import re
from pathlib import Path

import xmlschema

from kitrobot.world.lookup import SHIPPED
from kitrobot.world.parts import PARTS
from kitrobot.world.xml_reader import read_world
from kitrobot.world.xml_writer import write_world

PAGE = (Path(__file__).parents[2] / "docs" / "worlds.md").read_text(encoding="utf-8")
SCHEMA = SHIPPED.parents[1] / "primitives" / "schemas" / "world.xsd"


def test_the_example_is_read_without_a_problem_and_written_again_to_the_byte() -> None:
    [example] = re.findall(r"```xml\n(.*?)```", PAGE, re.DOTALL)
    world, problems = read_world(example.encode(), "worlds.md")
    assert problems == []
    assert world is not None
    assert write_world(world).decode() == example
    xmlschema.XMLSchema(SCHEMA).validate(example)


def test_every_element_and_each_of_its_attributes_is_told() -> None:
    rows = {line.split("`")[1]: line for line in PAGE.splitlines() if line.startswith("| `<")}
    for name, tag in PARTS.items():
        for attribute in tag.attributes:
            assert f"`{attribute}" in rows[f"<{name}>"] or f"`{attribute}`" in rows[f"<{name}>"], (name, attribute)


def test_every_shipped_world_is_listed() -> None:
    shipped = {path.name.removesuffix(".world.xml") for path in SHIPPED.glob("*.world.xml")}
    assert shipped == set(re.findall(r"^\| `([a-z-]+)` \|", PAGE, re.MULTILINE))
