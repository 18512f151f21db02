"""Nothing is said to people that is not said in every language. When this fails: CONTRIBUTING.md, "Sentences"."""

from __future__ import annotations

import re

import pytest

from kitrobot.primitives import load_catalogue
from tools.sentences import LANGUAGES, faults, sentences, table

HOLE = re.compile(r"\{[0-9]+\}")


def filled(language: str) -> list[tuple[str, str]]:
    """The sentences that are translated; the first test tells of the others."""
    return [pair for pair in table(language)["sentences"].items() if pair[1]]


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_sentence_of_the_rooms_has_a_translation_and_every_translation_a_sentence(language: str) -> None:
    lacking, idle = faults(language, sentences())
    assert (lacking, idle) == ([], []), "python tools/sentences.py --write, then fill in what is empty"


def test_the_languages_have_the_same_keys() -> None:
    first, *others = (table(language) for language in LANGUAGES)
    for other in others:
        assert {section: list(texts) for section, texts in other.items()} == {
            section: list(texts) for section, texts in first.items()
        }


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_has_no_hole_that_its_sentence_lacks_and_pairs_its_back_quotes(language: str) -> None:
    for texts in table(language).values():
        for english, other in texts.items():
            assert set(HOLE.findall(other)) <= set(HOLE.findall(english)), english
            assert other.count("`") % 2 == 0, english


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_leaves_out_no_hole_but_the_plurals(language: str) -> None:
    for english, other in filled(language):
        left = set(HOLE.findall(english)) - set(HOLE.findall(other))
        for hole in left:
            assert re.search(rf"[a-z]{re.escape(hole)}", english), english


def test_urdu_is_written_in_urdu_and_ends_as_urdu_does() -> None:
    for english, other in filled("ur"):
        assert re.search(r"[\u0600-\u06ff]", other) or re.fullmatch(r"[^a-z]*", HOLE.sub("", english)), english
        assert english.endswith(".") == other.endswith("۔"), english


def test_french_ends_a_sentence_where_english_does() -> None:
    for english, other in filled("fr"):
        assert english.endswith(".") == other.endswith("."), english


@pytest.mark.parametrize("language", LANGUAGES)
def test_constructors_are_called_in_sentences_as_on_the_canvas(
    language: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_CONFIG", str(tmp_path_factory.mktemp("none")))
        catalogue = load_catalogue()
    parts = table(language)["parts"]
    for constructor in catalogue.constructors.values():
        assert parts[constructor.name] == constructor.label[language]
