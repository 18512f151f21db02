"""What every reader of a text needs: lines and columns, words that were meant, values as sentences repeat them."""

from kitrobot.text.collection import collection_paused
from kitrobot.text.forms import (
    FINISH_MERGE,
    UNFINISHED_MERGE,
    conflict_mark,
    line_feeds,
    name_form,
    no_text,
    number_form,
    older_copy,
)
from kitrobot.text.phrases import all_of, listed, one_of, shown
from kitrobot.text.positions import BytePositions, TextPositions
from kitrobot.text.sentences import COMMA, HOLE, SEMICOLON, Help, Label, Recorded, Sentence, Series, Word, clipped
from kitrobot.text.suggestions import Suggestions, did_you_mean, nearest

__all__ = [
    "COMMA",
    "FINISH_MERGE",
    "HOLE",
    "SEMICOLON",
    "UNFINISHED_MERGE",
    "BytePositions",
    "Help",
    "Label",
    "Recorded",
    "Sentence",
    "Series",
    "Suggestions",
    "TextPositions",
    "Word",
    "all_of",
    "clipped",
    "collection_paused",
    "conflict_mark",
    "did_you_mean",
    "line_feeds",
    "listed",
    "name_form",
    "nearest",
    "no_text",
    "number_form",
    "older_copy",
    "one_of",
    "shown",
]
