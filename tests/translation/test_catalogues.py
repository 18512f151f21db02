"""Nothing is said to people that is not said in every language. When this fails: CONTRIBUTING.md, "Sentences"."""

from __future__ import annotations

import re

import pytest
from babel.messages.catalog import Message

from kitrobot.primitives import load_catalogue
from kitrobot.text import HOLE
from kitrobot.translation.catalogue import Catalogue
from kitrobot.translation.catalogue import catalogue as read_catalogue
from tools.sentences import BY_HAND, LANGUAGES, catalogue, entries, faults, forms, sentences

COUNTS = (0, 1, 2, 3, 10, 11, 21, 100, 1_000_000)


def templates(message: Message) -> tuple[str, ...]:
    """The English of an entry, for one and for many."""
    return (message.id,) if isinstance(message.id, str) else tuple(message.id)


def filled(language: str) -> list[Message]:
    """The entries that are translated; the first test tells of the others."""
    return [one for one in entries(catalogue(language)).values() if all(forms(one))]


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_sentence_has_a_translation_and_every_translation_a_sentence(language: str) -> None:
    lacking, idle = faults(language, sentences())
    assert (lacking, idle) == ([], []), "python tools/sentences.py --write, then fill in what is empty"


def test_the_languages_have_the_same_entries() -> None:
    first, *others = (list(entries(catalogue(language))) for language in LANGUAGES)
    assert all(other == first for other in others)


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_entry_waits_for_somebody_to_look_at_it(language: str) -> None:
    assert [one.id for one in catalogue(language) if one.fuzzy] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_translation_has_the_holes_of_its_sentence_and_pairs_its_back_quotes(language: str) -> None:
    for one in filled(language):
        holes = set(HOLE.findall("".join(templates(one))))
        for form in forms(one):
            left = holes - set(HOLE.findall(form))
            assert set(HOLE.findall(form)) <= holes, one.id
            assert not left or any(re.search(rf"[a-z]\{{{hole}\}}|\{{{hole}\}}[a-z]", str(one.id)) for hole in left), (
                one.id
            )
            assert form.count("`") % 2 == 0, one.id


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_counts_has_each_plural_form_of_its_language(language: str) -> None:
    known, read = catalogue(language), read_catalogue(language)
    counting = [one for one in known if one.id and one.pluralizable]
    assert counting
    for one in counting:
        assert len(forms(one)) == known.num_plurals
        assert "count" in HOLE.findall(templates(one)[1]), one.id
    assert {read.form(count) for count in COUNTS} == set(range(known.num_plurals))


def test_the_plural_forms_are_those_of_the_languages() -> None:
    assert [read_catalogue("fr").form(count) for count in (0, 1, 2, 11)] == [0, 0, 1, 1]
    assert [read_catalogue("ur").form(count) for count in (0, 1, 2, 11)] == [1, 0, 1, 1]


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_is_read_at_run_time_is_what_translators_wrote(language: str) -> None:
    read: Catalogue = read_catalogue(language)
    for one in filled(language):
        key = one.context or "", templates(one)[0]
        assert tuple(read.entries[key]) == forms(one)
        assert read.plurals[key] == "".join(templates(one)[1:])
    assert len(read.entries) == len(filled(language))


def test_a_template_of_recordings_names_each_hole_once_and_its_plural_in_the_same_order() -> None:
    for context, english in entries(sentences()):
        names = HOLE.findall(english)
        assert context != "recorded" or len(set(names)) == len(names), english
    for one in sentences():
        if one.id and one.pluralizable:
            assert HOLE.findall(templates(one)[0]) == HOLE.findall(templates(one)[1]), one.id


def test_urdu_is_written_in_urdu_and_ends_as_urdu_does() -> None:
    for one in filled("ur"):
        english = templates(one)[0]
        for form in forms(one):
            assert re.search(r"[\u0600-\u06ff]", form) or re.fullmatch(r"[^a-z]*", HOLE.sub("", english)), english
            assert english.endswith(".") == form.endswith("۔"), english


def test_french_ends_a_sentence_where_english_does() -> None:
    for one in filled("fr"):
        assert all(templates(one)[0].endswith(".") == form.endswith(".") for form in forms(one)), one.id


@pytest.mark.parametrize("language", LANGUAGES)
def test_constructors_are_called_in_sentences_as_on_the_canvas(
    language: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_CONFIG", str(tmp_path_factory.mktemp("none")))
        shipped = load_catalogue()
    for constructor in shipped.constructors.values():
        assert read_catalogue(language).word("part", constructor.name) == constructor.label[language]


def test_what_is_kept_by_hand_is_words() -> None:
    for context, english in entries(catalogue("fr")):
        assert context not in BY_HAND or not HOLE.search(english), english
