"""Everything that is shipped speaks each language: each part by name, in a sentence, and on its chip."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import kitrobot.world
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.robot import Category, SearchWords, Texts
from kitrobot.translation.languages import TEXT_LANGUAGES, TRANSLATED
from kitrobot.world.xml_reader import read_world

WORLDS = sorted((Path(kitrobot.world.__file__).parent / "shipped").glob("*.xml"))
ALL = set(TEXT_LANGUAGES)


@pytest.fixture(scope="module")
def catalogue(tmp_path_factory: pytest.TempPathFactory) -> Catalogue:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_CONFIG", str(tmp_path_factory.mktemp("none")))
        return load_catalogue()


def lacks(texts: Texts, wanted: set[str]) -> bool:
    return any(not texts.get(language) for language in wanted)


def test_every_robot_object_method_and_parameter_has_a_label_and_a_help_in_each_language(catalogue: Catalogue) -> None:
    silent = []
    for robot in catalogue.robots.values():
        things = [(robot.name, robot.label, robot.help)]
        for part in robot.objects:
            things.append((part.name, part.label, part.help))
            for method in part.methods:
                name = f"{part.name}.{method.name}"
                things.append((name, method.label, method.help))
                things += [(f"{name} {one.name}", one.label, one.help) for one in method.parameters]
        # In English a part goes by its own name.
        silent += [f"{robot.name}: {what}" for what, label, help in things if lacks(label, set(TRANSLATED))]
        silent += [f"{robot.name}: help of {what}" for what, _, help in things if lacks(help, ALL)]
    assert silent == []


def test_a_phrase_with_words_is_there_in_each_language_with_the_same_holes(catalogue: Catalogue) -> None:
    holes = re.compile(r"\{\w+\}")
    found = 0
    for robot in catalogue.robots.values():
        for part in robot.objects:
            for method in part.methods:
                english = method.phrase.get("", "")
                if not re.search(r"[A-Za-z]", holes.sub("", english)):
                    continue  # signs are the same everywhere
                found += 1
                assert not lacks(method.phrase, ALL), f"{robot.name} {part.name}.{method.name}"
                for phrase in method.phrase.values():
                    assert sorted(holes.findall(phrase)) == sorted(holes.findall(english)), phrase
    assert found > 10


def test_what_is_found_by_words_is_found_by_words_in_each_language(catalogue: Catalogue) -> None:
    silent = [name for name, one in catalogue.constructors.items() if set(one.words) != ALL]
    for robot in catalogue.robots.values():
        for part in robot.objects:
            if part.category in (Category.ACTUATOR, Category.SENSOR) and set(part.words) != ALL:
                silent.append(f"{robot.name} {part.name}")
            silent += [f"{part.name}.{one.name}" for one in part.methods if one.words and set(one.words) != ALL]
    assert silent == []


def found(catalogue: Catalogue, robot: str, word: str) -> set[str]:
    """The methods of a robot, and the constructors, that a word of the XML finds."""

    def has(*words: SearchWords) -> bool:
        return any(word in one for each in words for one in each.values())

    methods = {
        f"{part.name}.{method.name}"
        for part in catalogue.robots[robot].objects
        for method in part.methods
        if has(part.words, method.words)
    }
    return methods | {name for name, one in catalogue.constructors.items() if has(one.words)}


@pytest.mark.parametrize(
    ("robot", "word", "part"),
    [
        ("mini-robot", "left", "Motor.LeftBy"),
        ("mini-robot", "droite", "Motor.RightBy"),
        ("mini-robot", "سیدھا", "Wheel.DriveBy"),
        ("mini-robot", "back", "Wheel.BackBy"),
        ("mini-robot", "spin", "Motor.Turn"),
        ("mini-robot", "draw", "Pen.PenDown"),
        ("mini-robot", "blink", "Light.LightOn"),
        ("mini-robot", "wall", "Captor.LessThan"),
        ("mini-robot", "colour", "Light.IsRed"),
        ("kit-robot", "forward", "LeftWheel.Forward"),
        ("line-follower", "see", "LeftEye.IsRed"),
        ("carrier", "go", "Wheel.Advance"),
        ("microbit", "music", "Music.Play"),
        ("microbit", "beep", "Music.Tone"),
        ("microbit", "random", "Dice.Value"),
        ("microbit", "toujours", "Forever"),
        ("microbit", "always", "Forever"),
        ("loader", "انتظار", "Wait"),
        ("loader", "repeat", "Repetition"),
    ],
)
def test_what_a_child_types_finds_the_part(catalogue: Catalogue, robot: str, word: str, part: str) -> None:
    assert part in found(catalogue, robot, word)


@pytest.mark.parametrize("path", WORLDS, ids=lambda path: path.name)
def test_every_world_is_named_and_told_of_in_each_language(path: Path) -> None:
    world, problems = read_world(path.read_bytes(), path.name)
    assert problems == []
    assert world is not None
    assert not lacks(world.label, ALL)
    assert not lacks(world.help, ALL)


def test_urdu_texts_are_urdu(catalogue: Catalogue) -> None:
    for robot in catalogue.robots.values():
        for part in robot.objects:
            for method in part.methods:
                for text in (part.label["ur"], part.help["ur"], method.label["ur"], method.help["ur"]):
                    assert re.search(r"[\u0600-\u06ff]", text), text
