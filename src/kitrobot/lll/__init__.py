"""The Low Level Language as text and tree: tokens, parser, printer."""

from kitrobot.lll.collection import collection_paused
from kitrobot.lll.formatting import format_text
from kitrobot.lll.parser import Parsed, parse, parse_template
from kitrobot.lll.printer import print_program, print_template
from kitrobot.lll.tokens import is_name
from kitrobot.lll.tree import (
    MAX_NESTING,
    MAX_NUMBER,
    And,
    Break,
    Call,
    Condition,
    Conditional,
    Event,
    Hole,
    Instr,
    Instruction,
    Interrupt,
    Node,
    Not,
    Number,
    Or,
    Parallel,
    Param,
    Repeat,
    Seq,
    Wait,
    While,
)
from kitrobot.lll.walk import bodies, children, nodes, without_comments

__all__ = [
    "MAX_NESTING",
    "MAX_NUMBER",
    "And",
    "Break",
    "Call",
    "Condition",
    "Conditional",
    "Event",
    "Hole",
    "Instr",
    "Instruction",
    "Interrupt",
    "Node",
    "Not",
    "Number",
    "Or",
    "Parallel",
    "Param",
    "Parsed",
    "Repeat",
    "Seq",
    "Wait",
    "While",
    "bodies",
    "children",
    "collection_paused",
    "format_text",
    "is_name",
    "nodes",
    "parse",
    "parse_template",
    "print_program",
    "print_template",
    "without_comments",
]
