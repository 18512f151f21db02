"""LLL read by Lark: the same grammar, LALR with the standard lexer, a tree of every construct.

Kind to Lark: no positions are propagated and comments are dropped, both of which our parser keeps, and punctuation is
filtered out of the tree.
"""

from __future__ import annotations

from importlib.metadata import version

from lark import Lark, Tree

GRAMMAR = r"""
start: seq
seq: (_instr | ";")*
_instr: call | interrupt | repeat | while | conditional | event | parallel | wait | break
interrupt: _MARK call _MARK
repeat: NB "*" "(" seq ")"
while: "*" ("[" _cond "]")? "(" seq ")"
conditional: "[" _cond "]" "(" seq ")" [ "!" "(" seq ")" ]
event: "<" _cond ">" "(" seq ")"
parallel: "//" "(" seq ("," seq)* ")"
wait: "WAIT" "(" NB ")"
break: "BREAK"
_cond: _conj | or
or: _cond "|" _conj
_conj: _unary | and
and: _conj "&" _unary
_unary: not | "(" _cond ")" | call
not: "!" "(" _cond ")"
call: IDENT "." IDENT "(" [ _param ("," _param)* ] ")"
_param: NB | call
_MARK: /[°º˚]/
IDENT: /[^\W\d][\w]*/
NB: /[0-9]+/
COMMENT: /#[^\n]*/
%ignore COMMENT
%ignore /\s+/
"""


class LarkParser:
    """Lark, ready to read."""

    name = f"Lark {version('lark')}, LALR"

    def __init__(self) -> None:
        self._lark = Lark(GRAMMAR, parser="lalr", lexer="basic", maybe_placeholders=False)

    def parse(self, text: str) -> Tree:
        """The tree of a text."""
        return self._lark.parse(text)


def calls(tree: Tree) -> int:
    """How many calls a tree holds."""
    return sum(1 for _ in tree.find_data("call"))
