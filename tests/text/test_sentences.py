"""A sentence is its English text and keeps what it was made of."""

from __future__ import annotations

import copy
import json
import pickle

import orjson
import pytest

from kitrobot.text.phrases import listed, one_of
from kitrobot.text.sentences import COMMA, Label, Recorded, Sentence, Series, Word


def test_a_sentence_is_its_english_text() -> None:
    made = Sentence("the robot `{robot}` has no `{part}` like `{robot}`", "r", "p")
    assert made == "the robot `r` has no `p` like `r`"
    assert hash(made) == hash(str(made))
    assert (made.template, made.values) == (
        "the robot `{robot}` has no `{part}` like `{robot}`",
        {"robot": "r", "part": "p"},
    )
    assert json.dumps(made) == orjson.dumps(made).decode() == '"the robot `r` has no `p` like `r`"'


def test_a_value_that_looks_like_a_template_is_not_filled() -> None:
    assert Sentence("`{one}` and `{two}`", "{two}", "{one}") == "`{two}` and `{one}`"


def test_braces_without_a_value_are_text() -> None:
    assert Sentence("`{name}` is a hole") == "`{name}` is a hole"
    assert Sentence("`{{hole}}` is a hole", "x") == "`{x}` is a hole"


@pytest.mark.parametrize("values", [(), ("a", "b")])
def test_a_template_takes_as_many_values_as_it_has_holes(values: tuple[str, ...]) -> None:
    if values:
        with pytest.raises(ValueError):
            Sentence("the robot {robot}", *values)
    else:
        assert Sentence("the robot {robot}") == "the robot {robot}"


@pytest.mark.parametrize(("count", "english"), [(0, "0 boxes in A"), (1, "1 box in A"), (2, "2 boxes in A")])
def test_a_sentence_that_counts_takes_its_form(count: int, english: str) -> None:
    made = Sentence.counted("{count} box in {house}", "{count} boxes in {house}", count, "A")
    assert made == english
    assert (made.template, made.plural) == ("{count} box in {house}", "{count} boxes in {house}")


@pytest.mark.parametrize(
    "made",
    [
        Sentence("{one} {two}", Sentence("a {x}", 1), Series(COMMA, ["p", Word("q")])),
        Sentence.counted("{count} box", "{count} boxes", 2),
        Recorded("fails ({why})", Recorded("by hand")),
        Word("slot"),
        Series(COMMA, ["a", Sentence("b {x}", 2)]),
    ],
    ids=lambda made: type(made).__name__,
)
def test_a_sentence_stays_one_when_it_is_copied_and_sent_to_another_process(made: Sentence) -> None:
    for again in (pickle.loads(pickle.dumps(made)), copy.deepcopy(made)):
        assert (type(again), again, again.template, again.plural) == (type(made), made, made.template, made.plural)
        assert [type(value) for value in again.values.values()] == [type(value) for value in made.values.values()]
        assert again.values == made.values
        assert getattr(again, "parts", ()) == getattr(made, "parts", ())


def test_lists_of_names() -> None:
    assert one_of(["a"]) == "a"
    assert one_of(["a", "b", "c"]) == "a, b or c"
    assert not listed([])
    assert listed("abc") == "a, b, c"
    assert listed("abcdefghij") == "a, b, c, d, e, f, g, h …"


def test_a_sentence_with_another_value_keeps_its_template() -> None:
    made = Sentence("`{part}` failed: {reason}", "Captor", "no answer").with_value("part", "Eye")
    assert made == Sentence("`{part}` failed: {reason}", "Eye", "no answer")
    assert made.values == {"part": "Eye", "reason": "no answer"}
    boxes = Sentence.counted("{count} box in {house}", "{count} boxes in {house}", 1, "A")
    assert boxes.with_value("count", 2) == "2 boxes in A"
    assert boxes.with_value("house", "B") == "1 box in B"


def test_a_label_is_the_english_one_and_survives_copying() -> None:
    label = Label("Captor", {"": "Distance sensor", "fr": "Capteur"})
    assert label == "Distance sensor"
    assert Label("Captor", {"fr": "Capteur"}) == "Captor"
    for again in (copy.deepcopy(label), pickle.loads(pickle.dumps(label))):
        assert (again, again.name, again.texts) == (label, "Captor", label.texts)
