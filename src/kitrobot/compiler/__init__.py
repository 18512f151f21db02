"""Translations: graph → LLL, LLL → graph, LLL → three-address code → image; and the check of a program's names."""

from kitrobot.compiler.checker import check
from kitrobot.compiler.compilation import Compiled, compile_lll, compile_program, compile_text
from kitrobot.compiler.graph_to_lll import Translation, graph_to_lll
from kitrobot.compiler.lll_to_graph import lll_to_graph
from kitrobot.compiler.own_part import Chosen, Look, Offered, Part, PartError, make_part, offer_part
from kitrobot.compiler.part_offers import Offer
from kitrobot.compiler.part_reading import PartText, draw_template, read_part
from kitrobot.compiler.selection import SelectionError
from kitrobot.compiler.target import Target, target_of
from kitrobot.compiler.text_edit import Followed, VertexPlace, follow_text

__all__ = [
    "Chosen",
    "Compiled",
    "Followed",
    "Look",
    "Offer",
    "Offered",
    "Part",
    "PartError",
    "PartText",
    "SelectionError",
    "Target",
    "Translation",
    "VertexPlace",
    "check",
    "compile_lll",
    "compile_program",
    "compile_text",
    "draw_template",
    "follow_text",
    "graph_to_lll",
    "lll_to_graph",
    "make_part",
    "offer_part",
    "read_part",
    "target_of",
]
