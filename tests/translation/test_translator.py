"""A sentence is said in another language from its template and its values; one of a recording is found again."""

from __future__ import annotations

import threading
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import COMMA, SEMICOLON, Label, Recorded, Sentence, Series, Word
from kitrobot.translation import translator
from kitrobot.translation.catalogue import Catalogue, catalogue
from kitrobot.translation.languages import TRANSLATED
from kitrobot.translation.reader_language import best_language, override_language, reader_language, translate
from kitrobot.translation.recorded import LONGEST, recalled
from kitrobot.translation.translator import translate_to

TABLE = r"""
msgid ""
msgstr ""
"Plural-Forms: nplurals=2; plural=(n > 1);\n"

#: somewhere.py
msgid "the robot `{robot}` has no `{part}`"
msgstr "`{part}` manque au robot `{robot}`"

msgid "expected {wanted}, found {found}"
msgstr ""
"attendu {wanted}, "
"trouvé {found}"

msgid "a number from {least} to {most}"
msgstr "un nombre de {least} à {most}"

msgid "the program has ended"
msgstr "le programme est fini"

msgid "say \"{word}\"\\"
msgstr "dites « {word} »\\"

msgid "{count} box in {place}"
msgid_plural "{count} boxes in {place}"
msgstr[0] "{place} : {count} caisse"
msgstr[1] "{place} : {count} caisses"

msgid "not translate_to yet"
msgstr ""

msgid "{front} or {last}"
msgstr "{front} ou {last}"

msgid "{front} and {last}"
msgstr "{front} et {last}"

msgid ", "
msgstr ", "

msgid "; "
msgstr " ; "

msgctxt "recorded"
msgid "Done after {seconds} s: {what}."
msgstr "Fini en {seconds} s : {what}."

msgctxt "recorded"
msgid "{name} holds {count} box"
msgid_plural "{name} holds {count} boxes"
msgstr[0] "{name} contient {count} caisse"
msgstr[1] "{name} contient {count} caisses"

msgctxt "recorded"
msgid "by hand"
msgstr "à la main"

msgctxt "recorded"
msgid "fails ({why})"
msgstr "tombe en panne ({why})"

msgctxt "word"
msgid "permission denied"
msgstr "accès refusé"

msgctxt "part"
msgid "While"
msgstr "Tant que"
"""


@pytest.fixture
def french(monkeypatch: pytest.MonkeyPatch) -> Catalogue:
    known = Catalogue(TABLE)
    monkeypatch.setattr(translator, "catalogue", lambda language: known)
    return known


SWAPPED = "`the program has ended` manque au robot `{part}`"
BOXES = "{count} box in {place}", "{count} boxes in {place}"


@pytest.mark.parametrize(
    ("english", "other"),
    [
        (Sentence("the robot `{robot}` has no `{part}`", "a", "b"), "`b` manque au robot `a`"),
        (Sentence("the robot `{robot}` has no `{part}`", "While", "box"), "`box` manque au robot `Tant que`"),
        (Sentence("the robot `{robot}` has no `{part}`", "{part}", "the program has ended"), SWAPPED),
        (
            Sentence("expected {wanted}, found {found}", Sentence("a number from {least} to {most}", 1, 3), 1.5),
            "attendu un nombre de 1 à 3, trouvé 1,5",
        ),
        (
            Sentence("expected {wanted}, found {found}", "the program has ended", Word("Permission denied")),
            "attendu the program has ended, trouvé Accès refusé",
        ),
        (Sentence("expected {wanted}, found {found}", Word("While"), "`While`"), "attendu Tant que, trouvé `Tant que`"),
        (
            Sentence("expected {wanted}, found {found}", one_of(["a", "b", "c"]), Word("who knows")),
            "attendu a, b ou c, trouvé who knows",
        ),
        (Word("the program has ended"), "le programme est fini"),
        (Sentence('say "{word}"\\', "x"), "dites « x »\\"),
        (Sentence("the program has ended"), "le programme est fini"),
        (Sentence.counted(*BOXES, 0, "A"), "A : 0 caisse"),
        (Sentence.counted(*BOXES, 1, "A"), "A : 1 caisse"),
        (Sentence.counted(*BOXES, 5, "A"), "A : 5 caisses"),
        (Series(SEMICOLON, [Sentence("the program has ended"), "x"]), "le programme est fini ; x"),
        (Sentence("not translate_to yet"), "not translate_to yet"),
        (Sentence("nobody says {this}", Sentence("the program has ended")), "nobody says the program has ended"),
        ("the program has ended", "the program has ended"),
        (Sentence(""), ""),
    ],
)
@pytest.mark.usefixtures("french")
def test_a_sentence_is_said_again_with_its_values(english: str, other: str) -> None:
    assert translate_to(english, "fr") == other


@pytest.mark.parametrize(
    ("english", "other"),
    [
        ("fails (by hand)", "tombe en panne (à la main)"),
        ("Done after 1.5 s: A holds 1 box.", "Fini en 1,5 s : A contient 1 caisse."),
        (
            "Done after 2 s: A holds 1 box and B holds 2 boxes.",
            "Fini en 2 s : A contient 1 caisse et B contient 2 caisses.",
        ),
        ("Done after 2 s: by hand; A holds 3 boxes.", "Fini en 2 s : à la main ; A contient 3 caisses."),
        ("Done after 2 s: A holds x boxes.", "Fini en 2 s : A holds x boxes."),
        ("Done after 2 s: a, b and c.", "Fini en 2 s : a, b et c."),
        ("the robot `a` has no `b`", "the robot `a` has no `b`"),
        ("the program has ended", "le programme est fini"),
        ("nobody says this", "nobody says this"),
    ],
)
@pytest.mark.usefixtures("french")
def test_the_finished_english_of_a_recording_finds_its_template(english: str, other: str) -> None:
    assert translate_to(Recorded(english), "fr") == other
    assert translate_to(str(english), "fr") == english, "only what comes from a recording is looked for"


@pytest.mark.usefixtures("french")
def test_what_stays_english_is_set_apart_in_a_language_from_right_to_left() -> None:
    made = Sentence("expected {wanted}, found {found}", Series(COMMA, ["a", "b"]), 7)
    assert translate_to(made, "ur") == "attendu \u2068a\u2069, \u2068b\u2069, trouvé 7"
    assert translate_to(Sentence("the robot `{robot}` has no `{part}`", "a", "b"), "ur") == "`b` manque au robot `a`"


@given(st.text(max_size=200), st.text(max_size=200))
def test_whatever_a_name_holds_the_sentence_comes_out_whole(one: str, other: str) -> None:
    for language in TRANSLATED:
        found = translate_to(Sentence("the robot `{robot}` has no `{object}`", one, other), language)
        assert found.count("`") >= 4
        assert translate_to(Recorded(f"touches {one}"), language)


@pytest.mark.parametrize(
    "hostile",
    [
        "Done after " * 360,
        "a, " * 1300,
        "a; " * 1300,
        "fails (" * 500,
        ": " * 1999,
        "Done after 1 s: " + "x holds 1 box and " * 200,
        "Done after " + "x holds y and " * 280,
        "x" * 1_000_000,
    ],
    ids=lambda text: text[:12],
)
def test_a_hostile_recording_is_bounded_work(hostile: str) -> None:
    began = time.thread_time()
    for language in TRANSLATED:
        translate_to(Recorded(hostile), language)
    assert time.thread_time() - began < 2, "ten times what it takes"


def test_a_language_says_english_while_its_catalogue_is_not_there() -> None:
    assert catalogue("tlh").template(Sentence("the program has ended")) is None


def test_what_is_longer_than_any_sentence_is_not_looked_for(french: Catalogue) -> None:
    assert recalled("fails (" + "b" * LONGEST + ")", french) is None


def test_sentences_in_sentences_without_end_stay_english() -> None:
    made = Sentence("a test")
    for _ in range(100):
        made = Sentence("drop {wanted} on it", made)
    assert translate_to(made, "fr").startswith("déposez-y déposez-y")
    assert "drop" in translate_to(made, "fr")


def test_a_label_brings_its_own_translations() -> None:
    label = Label("Eye", {"": "Left eye", "fr": "Œil gauche"})
    failed = Sentence("`{part}` failed: {reason}", label, "-")
    assert translate_to(failed, "fr") == "`Œil gauche` a échoué : -"
    assert translate_to(failed, "ur").startswith("`Left eye`")
    assert translate_to(label, "fr") == "Œil gauche"
    assert translate_to(label, "ur") == "Left eye"


def test_an_unknown_language_is_english() -> None:
    assert translate_to(Sentence("the disk could not be used"), "xx") == "the disk could not be used"


@pytest.mark.parametrize(
    ("wish", "language"),
    [
        ("fr-CA,en;q=0.8", "fr"),
        ("UR", "ur"),
        ("xx, de;q=0.9", "en"),
        ("", "en"),
        ("en,fr", "en"),
        (",;q=,," * 10_000 + "fr", "en"),
        ("constructor", "en"),
    ],
)
def test_the_first_language_that_is_there_is_taken(wish: str, language: str) -> None:
    assert best_language(wish) == language


def test_a_language_lasts_as_long_as_its_block_and_is_the_threads_own() -> None:
    others = []
    with override_language("fr"):
        assert translate(Sentence("the disk could not be used")) == "le disque n'a pas pu servir"
        thread = threading.Thread(target=lambda: others.append(reader_language()))
        thread.start()
        thread.join()
    assert reader_language() == "en"
    assert others == ["en"]
