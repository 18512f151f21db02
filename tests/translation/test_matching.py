"""A sentence finds the one that it was made of, says its holes anew, and cannot be made slow."""

from __future__ import annotations

import threading
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.translation import best_language, reading_in, said, said_in
from kitrobot.translation.matching import LONGEST, Table, translated

TABLE = {
    "sentences": {
        "expected {1}, found {2}": "attendu {1}, trouvé {2}",
        "expected {1} in {2}, found {3}": "dans {2} attendu {1}, trouvé {3}",
        "the robot `{1}` has no `{2}`": "`{2}` manque au robot `{1}`",
        "a number from {1} to {2}": "un nombre de {1} à {2}",
        "the program has ended": "le programme est fini",
        "Done after {1} s: {2}.": "Fini en {1} s : {2}.",
        "{1} holds {2}": "{1} contient {2}",
    },
    "phrases": {" after {1}": " après {1}"},
    "words": {"and": "et", "or": "ou", "box": "caisse"},
    "parts": {"While": "Tant que"},
}


@pytest.fixture
def french() -> Table:
    return Table("fr", TABLE)


@pytest.mark.parametrize(
    ("english", "other"),
    [
        ("the robot `a` has no `b`", "`b` manque au robot `a`"),
        ("expected a number from 1 to 3 in x, found 4", "dans x attendu un nombre de 1 à 3, trouvé 4"),
        ("expected a, b or c, found box", "attendu a, b ou c, trouvé caisse"),
        ("The program has ended.", "Le programme est fini."),
        ("Done after 1.5 s: the program has ended.", "Fini en 1,5 s : le programme est fini."),
        ("Done after 2 s: A holds 1 and B holds 2.", "Fini en 2 s : A contient 1 et B contient 2."),
        ("Done after 2 s: the program has ended; A holds 1.", "Fini en 2 s : le programme est fini ; A contient 1."),
        ("Done after 2 s: A holds 1; who knows.", "Fini en 2 s : A contient 1; who knows."),
        ("the robot `While` has no `box`", "`box` manque au robot `Tant que`"),
        ("expected “a, b or c”, found “x”", "attendu “a, b or c”, trouvé “x”"),
        ("Box-1 holds  after box", "Box-1 contient  après caisse"),
        (" after box", " after box"),
        ("the robot `a` has no door `b`", "the robot `a` has no door `b`"),
        ("the robot `a` of `b` has no `c`", "the robot `a` of `b` has no `c`"),
        ("nobody says this", "nobody says this"),
        ("", ""),
    ],
)
def test_a_sentence_is_said_again_with_its_holes(french: Table, english: str, other: str) -> None:
    assert french.translate(english) == other


def test_what_stays_english_is_set_apart_in_a_language_from_right_to_left() -> None:
    urdu = Table("ur", {**TABLE, "sentences": {"{1} holds {2} `{3}`.": "{1} میں {2} `{3}`۔"}, "words": {}})
    assert urdu.translate("Box holds 7 `x`.") == "\u2068Box\u2069 میں 7 `x`۔"


@given(st.text(max_size=200), st.text(max_size=200))
def test_whatever_a_name_holds_the_sentence_comes_out_whole(one: str, other: str) -> None:
    for language in ("fr", "ur"):
        found = translated.__wrapped__(f"the robot `{one}` has no `{other}`", language)
        assert isinstance(found, str)
        assert found


@pytest.mark.parametrize(
    "hostile",
    [
        "expected " * 440,
        "`" * LONGEST,
        "a, " * 1300,
        ": " * 1999,
        " in the of " * 350,
        "expected a, " + "expected a, found " * 200,
        "Done after " + "x holds y and " * 280,
        "“" * 3999,
        "x" * 1_000_000,
    ],
    ids=lambda text: text[:12],
)
def test_a_hostile_sentence_is_bounded_work(hostile: str) -> None:
    began = time.thread_time()
    for language in ("fr", "ur"):
        translated.__wrapped__(hostile, language)
    assert time.thread_time() - began < 2, "a hundred times what it takes"


def test_what_is_longer_than_any_sentence_stays_as_it_is(french: Table) -> None:
    assert french.translate("the robot `a` has no `" + "b" * LONGEST + "`").startswith("the robot")


def test_an_unknown_language_is_english() -> None:
    assert translated("the disk could not be used", "xx") == "the disk could not be used"


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
    with reading_in("fr"):
        assert said("the disk could not be used") == "le disque n'a pas pu servir"
        thread = threading.Thread(target=lambda: others.append(said_in()))
        thread.start()
        thread.join()
    assert said_in() == "en"
    assert others == ["en"]
