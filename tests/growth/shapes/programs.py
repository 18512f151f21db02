"""Inputs of programs, listings and images."""

from __future__ import annotations

from tests.growth.shapes.registry import lines, shape

lines(
    "csv",
    {
        "rows": ("tick,Captor\n", "#,5\n", ""),
        "rows of one tick": ("tick,Captor\n", "5,5\n", ""),
        "rows that go back": ("tick,Captor\n9999999,5\n", "#,5\n", ""),
        "rows with too few cells": ("tick,Captor\n", "#\n", ""),
        "rows without numbers": ("tick,Captor\n", "x,y\n", ""),
        "rows with values that are no numbers": ("tick,Captor\n", "#,y\n", ""),
        "blank lines": ("tick,Captor\n", "\n", ""),
        "carriage returns": ("tick,Captor\n", "\r", ""),
        "spaces": ("tick,Captor\n", " ", ""),
        "columns": ("tick", ",Captor#", "\n0\n"),
        "columns of one name": ("tick", ",Captor", "\n0\n"),
        "columns of one unknown name": ("tick", ",Captorr", "\n0\n"),
        "columns of no name": ("tick", ",", "\n0\n"),
        "done columns": ("tick", ",done:Motor#", "\n0\n"),
        "cells of one row": ("tick,Captor\n0", ",5", "\n"),
        "quotation marks": ("tick,Captor\n0,", '"', "\n"),
        "quotation marks with a space": ("tick,Captor\n0,", '" ', "\n"),
        "quoted cells": ("tick,Captor\n", '"#","5"\n', ""),
        "quoted cells that do not end": ("tick,Captor\n0", ',"', "\n"),
        "spaces in a cell": ("tick,Captor\n0,", " ", "5\n"),
        "spaces before a quotation mark": ("tick,Captor\n0,", " ", '"5\n'),
        "letters of a column": ("tick,Captor", "r", "\n0,5\n"),
        "digits": ("tick,Captor\n0,", "9", "\n"),
    },
)


_KRA = ".robot 0000000000000000\n.tick 20\n.wait-unit 100\n"
lines(
    "kra",
    {
        "comments": (_KRA, "; a comment\n", ""),
        "cells": (_KRA, ".cell 0\n", ""),
        "slots": (_KRA, ".slot - 0 0 1\n", ""),
        "directives that nobody knows": (_KRA, ".x\n", ""),
        "spaces": (_KRA, " ", ""),
    },
)


@shape("kra instructions")
def _listing(n: int) -> str:
    from kitrobot.compiler.compilation import compile_text
    from kitrobot.image.listing import disassemble
    from kitrobot.primitives.catalogue import load_catalogue

    image = compile_text("Wheel.Stop();\n" * min(n, 8000), load_catalogue([]).robot("mini-robot")).image
    assert image is not None
    return disassemble(image)


@shape("kra parallels")
def _parallel_listing(n: int) -> str:
    from kitrobot.compiler.compilation import compile_text
    from kitrobot.image.listing import disassemble
    from kitrobot.primitives.catalogue import load_catalogue

    text = "//(Wheel.Stop();, WAIT(5););\n" * min(n, 100)
    image = compile_text(text, load_catalogue([]).robot("mini-robot")).image
    assert image is not None
    return disassemble(image)
