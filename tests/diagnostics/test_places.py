"""Offsets of a text as lines and columns."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.diagnostics.model import Place, Source

TEXT = "ab\ncd\r\n\nگاڑی x\n"


@pytest.mark.parametrize(
    ("offset", "position"),
    [
        (0, (1, 1)),
        (1, (1, 2)),
        (2, (1, 3)),  # the line break belongs to its line
        (3, (2, 1)),
        (5, (2, 3)),
        (6, (2, 4)),
        (7, (3, 1)),
        (8, (4, 1)),
        (13, (4, 6)),
        (14, (4, 7)),
        (15, (5, 1)),  # the end of the text
    ],
)
def test_an_offset_has_a_line_and_a_column_from_one(offset: int, position: tuple[int, int]) -> None:
    assert Source("x", TEXT).position(offset) == position


@pytest.mark.parametrize(
    ("number", "line"), [(0, ""), (1, "ab"), (2, "cd"), (3, ""), (4, "گاڑی x"), (5, ""), (6, ""), (-1, "")]
)
def test_a_line_is_its_text_without_the_line_break(number: int, line: str) -> None:
    assert Source("x", TEXT).line(number) == line


def test_a_place_begins_and_ends_at_offsets() -> None:
    assert Source("x", TEXT).place(1, 4) == Place("x", 1, 2, 2, 2)


def test_a_place_that_ends_before_it_begins_is_empty() -> None:
    assert Source("x", TEXT).place(4, 1) == Place("x", 2, 2, 2, 2)


def test_only_a_line_feed_ends_a_line() -> None:
    assert Source("x", "a\u2028b\x0cc\x85d").position(6) == (1, 7)


@given(st.text(alphabet="a\n\r ", max_size=50), st.integers(0, 50))
def test_a_position_leads_back_to_its_offset(text: str, offset: int) -> None:
    offset = min(offset, len(text))
    line, column = Source("x", text).position(offset)
    assert sum(len(one) + 1 for one in text.split("\n")[: line - 1]) + column - 1 == offset
