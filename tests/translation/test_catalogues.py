"""Nothing is said to people that is not said in every language. When this fails: CONTRIBUTING.md, "Sentences"."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from babel.messages.catalog import Message

from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.text.sentences import HOLE
from kitrobot.translation.catalogue import catalogue as read_catalogue
from kitrobot.translation.languages import LANGUAGES, TRANSLATED
from tools.sentences import CATALOGUE_SETS, PROGRAM, english, entries, forms

COUNTS = (0, 1, 2, 3, 10, 11, 21, 100, 1_000_000)
ANY_HOLE = re.compile(r"\{(\w+)\}")

each_catalogue = pytest.mark.parametrize(
    ("half", "language"), [(half, one) for half in CATALOGUE_SETS for one in TRANSLATED]
)
each_language = pytest.mark.parametrize("language", TRANSLATED)


def filled(half: str, language: str) -> list[Message]:
    """The entries that are translated; the first test tells of the others."""
    return [one for one in entries(CATALOGUE_SETS[half].catalogue(language)).values() if all(forms(one))]


def pairs(half: str, language: str) -> Iterator[tuple[str, str]]:
    """English and translation, of what counts for 1 and for the first other count that has another form."""
    for one in filled(half, language):
        yield english(one)[0], forms(one)[0]
        yield english(one)[-1], forms(one)[-1]


@each_catalogue
def test_every_sentence_has_a_translation_and_every_translation_a_sentence(half: str, language: str) -> None:
    assert CATALOGUE_SETS[half].faults(language) == ([], []), (
        "python tools/sentences.py --write, then fill in what is empty"
    )


@pytest.mark.parametrize("half", CATALOGUE_SETS)
def test_the_languages_have_the_same_entries(half: str) -> None:
    first, *others = (list(entries(CATALOGUE_SETS[half].catalogue(language))) for language in TRANSLATED)
    assert all(other == first for other in others)


@each_catalogue
def test_no_entry_waits_for_somebody_to_look_at_it(half: str, language: str) -> None:
    assert [one.id for one in CATALOGUE_SETS[half].catalogue(language) if one.fuzzy] == []


@each_catalogue
def test_a_translation_has_the_holes_of_its_sentence_and_pairs_its_back_quotes(half: str, language: str) -> None:
    for one in filled(half, language):
        said = [set(ANY_HOLE.findall(text)) for text in english(one)]
        for form in forms(one):
            assert set.intersection(*said) <= set(ANY_HOLE.findall(form)) <= set.union(*said), one.id
            assert form.count("`") % 2 == 0, one.id


@each_catalogue
def test_what_counts_has_each_plural_form_of_its_language(half: str, language: str) -> None:
    known = CATALOGUE_SETS[half].catalogue(language)
    counting = [one for one in known if one.id and one.pluralizable]
    assert counting
    for one in counting:
        assert len(forms(one)) == known.num_plurals
        assert half == "page" or "count" in HOLE.findall(english(one)[1]), one.id
    assert {read_catalogue(language).form(count) for count in COUNTS} == set(range(known.num_plurals))


def test_the_plural_forms_are_those_of_the_languages() -> None:
    assert [read_catalogue("fr").form(count) for count in (0, 1, 2, 11)] == [0, 0, 1, 1]
    assert [read_catalogue("pt").form(count) for count in (0, 1, 2, 11)] == [0, 0, 1, 1]
    assert [read_catalogue("es").form(count) for count in (0, 1, 2, 11)] == [1, 0, 1, 1]
    assert [read_catalogue("ur").form(count) for count in (0, 1, 2, 11)] == [1, 0, 1, 1]


@each_language
def test_what_is_read_at_run_time_is_what_translators_wrote(language: str) -> None:
    read = read_catalogue(language)
    for one in filled("program", language):
        key = one.context or "", english(one)[0]
        assert tuple(read.entries[key]) == forms(one)
        assert read.plurals[key] == "".join(english(one)[1:])
    assert len(read.entries) == len(filled("program", language))


def test_a_template_of_recordings_names_each_hole_once_and_its_plural_in_the_same_order() -> None:
    for one in PROGRAM.sentences:
        names = HOLE.findall(english(one)[0]) if one.id else []
        assert one.context != "recorded" or len(set(names)) == len(names), one.id
        assert not one.id or HOLE.findall(english(one)[-1]) == names, one.id


@pytest.mark.parametrize("half", CATALOGUE_SETS)
def test_urdu_is_written_in_urdu(half: str) -> None:
    for said, other in pairs(half, "ur"):
        name = half == "page" or re.fullmatch(r"[^a-z]*", HOLE.sub("", said))
        assert name or re.search(r"[\u0600-\u06ff]", other), said


@each_language
def test_a_sentence_ends_where_english_does(language: str) -> None:
    for said, other in pairs("program", language):
        assert said.endswith(".") == other.endswith(LANGUAGES[language].stop), said


@each_language
def test_constructors_are_called_in_sentences_as_on_the_canvas(
    language: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_CONFIG", str(tmp_path_factory.mktemp("none")))
        shipped = load_catalogue()
    for constructor in shipped.constructors.values():
        assert read_catalogue(language).word("part", constructor.name) == constructor.label[language]


def test_what_is_kept_by_hand_is_words() -> None:
    for context, said in entries(PROGRAM.catalogue("fr")):
        assert context not in PROGRAM.by_hand or not HOLE.search(said), said
