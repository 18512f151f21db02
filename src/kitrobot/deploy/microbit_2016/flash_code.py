"""The part of KitRobot that is executed from the flash of a small board, where it takes no memory.

A board without enough memory compiles these functions once, while nothing else is loaded; the host reads the compiled
code and writes it to flash that the board's files do not use (`kitrobot.deploy.microbit_2016.flash`). When a robot
starts, each becomes a function whose code is there: 16 bytes of memory, and its name.

Such code refers to names by the numbers that this firmware gives them, so it may use only names of the firmware
(`kitrobot.deploy.minification.builtin_names`; checked on the board before); and it may refer to no object of its own,
because the garbage collector does not scan flash. So strings and bytes become variables that the start of the robot
fills.

The layout is that of MicroPython 1.9, which every firmware of this board has: a function is four words (type, globals,
code, names of its arguments); its code begins with a prelude for the virtual machine, then come the function's name
and its file's, and so on to the last byte, whose position is stored nowhere. So each function ends in a number that
is searched for.
"""

from __future__ import annotations

import ast
import hashlib
import re
import struct
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from kitrobot.deploy.errors import BoardError
from kitrobot.text.sentences import Sentence

CHUNK = 128
"""Bytes of a piece of the board's file system, whose first byte says what it is."""

OF_OTHERS = frozenset({0, 253, 254, 255, ord("M")})
"""First bytes of a piece that mean something to the board's files: freed, the spare page, a file's start, unused; and,
at one address, that a script lies there."""

HEAD = 12
"""Bytes in front: see `head`."""

DUMP = "krd"
"""The file that the board writes what its compiler made into."""

_END = 703710
"""What each function ends in on its way through the compiler."""

_BEHIND = bytes((0x14, 0xAA, 0xF9, 0x5E, 0x5B))  # that number is loaded, and given back
_SPACES = re.compile(r"^ +", re.MULTILINE)
_ARGUMENTS = 32
"""Bytes of names of arguments that are written down for each function: enough for eight."""


@dataclass(frozen=True)
class Function:
    """A function by its name on the board, with the number of its arguments and the letters of its text."""

    name: str
    arguments: int
    letters: int

    @property
    def written(self) -> int:
        """Bytes that the board writes down of it."""
        return _ARGUMENTS + self.dumped

    @property
    def dumped(self) -> int:
        """Bytes of code that are written down for it: compiled, it has fewer bytes than letters, but for short ones."""
        return -(-(self.letters + 32) // 16) * 16


@dataclass(frozen=True)
class FlashBlock:
    """Functions for the flash of a board.

    Args:
        name: by content, `kr` and eight digits.
        groups: the functions that are compiled together, with their text.
        names: all that they name.
        literals: Python values, written out, by the names that stand for them.
    """

    name: str
    groups: Sequence[tuple[str, Sequence[Function]]]
    names: frozenset[str]
    literals: Mapping[str, str]

    @property
    def functions(self) -> list[Function]:
        """All, in their order."""
        return [function for _, functions in self.groups for function in functions]

    @property
    def sign(self) -> int:
        """The second word of the head."""
        return sign_of(self.name)


def sign_of(name: str) -> int:
    """The sign of a block by its name; that of a file is no block's."""
    return int(name[2:], 16) & 0x3FFFFFFF


def build_block(texts: Sequence[Sequence[ast.FunctionDef]], literals: Mapping[str, str]) -> FlashBlock:
    """Groups of functions, made ready; `literals` have their names in the functions already.

    Raises:
        TypeError: there is something in a function that has no place in flash.
    """
    groups = []
    names: set[str] = set()
    for functions in texts:
        text = ""
        listed = []
        for function in functions:
            names |= set(_named(function))
            whole = _SPACES.sub(lambda found: " " * (len(found[0]) // 4), ast.unparse(_ending(function)))
            listed.append(Function(function.name, len(function.args.args), len(whole)))
            text += whole + "\n"
        groups.append((text + _dumping(listed), tuple(listed)))
    digest = hashlib.sha256("".join(text for text, _ in groups).encode()).hexdigest()
    return FlashBlock(f"kr{digest[:8]}", tuple(groups), frozenset(names), literals)


def literals_of(functions: Sequence[ast.FunctionDef]) -> list[str]:
    """The strings and bytes in functions, written out, each once."""
    return list(
        dict.fromkeys(
            repr(node.value)
            for function in functions
            for node in ast.walk(function)
            if isinstance(node, ast.Constant) and isinstance(node.value, str | bytes)
        )
    )


class WithNames(ast.NodeTransformer):
    """Puts names into the places of strings and bytes."""

    def __init__(self, names: Mapping[str, str]) -> None:
        self.names = names

    def visit_Constant(self, node: ast.Constant) -> ast.expr:
        if isinstance(node.value, str | bytes):
            return ast.copy_location(ast.Name(self.names[repr(node.value)], ast.Load()), node)
        return node


def head(sign: int, chunks: int, *, whole: bool) -> bytes:
    """The words in front: a byte that no file of the board has, and whether all is there; the sign; how many pieces.

    Flash goes from one to zero only, so a block becomes whole by one more writing.
    """
    return struct.pack("<4siI", b"\xa7kr" + (b"\x2a" if whole else b"\xff"), sign, chunks)


def lay_out(one: FlashBlock, dumps: Sequence[bytes]) -> bytes:
    """What is put into the flash, with room for its head.

    Behind the head stand, for each function, where its code and its arguments are, from the start of the head on.

    Args:
        one: what was compiled.
        dumps: what the board wrote down for each group.

    Raises:
        BoardError: the board's compiler is none that we know.
    """
    data = bytearray(b"\x01" * (HEAD + 4 * len(one.functions)))
    places = b""
    for (_, functions), dump in zip(one.groups, dumps, strict=True):
        at = 0
        for function in functions:
            arguments = dump[at : at + 4 * function.arguments]
            at += _ARGUMENTS
            code = _code(dump[at : at + function.dumped], function)
            at += function.dumped
            places += struct.pack("<HH", _placed(data, code), _placed(data, arguments))
    data[HEAD : HEAD + len(places)] = places
    if any(data[edge] in OF_OTHERS for edge in range(CHUNK, HEAD + len(places), CHUNK)):
        raise unknown_firmware()
    return bytes(data)


def _placed(data: bytearray, code: bytes) -> int:
    """Appends to the data, at a word, so that no first byte of a piece is one that means something; where."""
    at = -(-len(data) // 4) * 4
    for start in range(at, at + CHUNK, 4):
        filled = bytes(data) + b"\x01" * (start - len(data)) + code
        if all(filled[edge] not in OF_OTHERS for edge in range(0, len(filled), CHUNK) if edge >= len(data)):
            data[:] = filled
            return start
    raise unknown_firmware()


def _code(dump: bytes, function: Function) -> bytes:
    """The code of a function, up to its end, and without the name of the file that it came from."""
    end = dump.find(_BEHIND)
    try:
        if end < 0:
            raise ValueError
        at = 0
        for _ in range(2):
            at = _number(dump, at)[1]
        flags, count, named, given = dump[at : at + 4]
        if flags or named or given or count != function.arguments:
            raise ValueError
        at = _number(dump, at + 4)[1]
        file = _number(dump, at)[1]
        after = _number(dump, file)[1]
        if file - at > after - file:
            raise ValueError
    except (ValueError, IndexError):
        raise unknown_firmware() from None
    own = dump[at:file]
    return dump[:file] + own.rjust(after - file, b"\x80") + dump[after:end]


def unknown_firmware() -> BoardError:
    """A MicroPython that differs from those that we know."""
    return BoardError(
        Sentence("the board's MicroPython is none that KitRobot knows"),
        Sentence("put the latest MicroPython for the micro:bit V1 onto it, from microbit.org"),
    )


def _number(data: bytes, at: int) -> tuple[int, int]:
    """A number of seven bits a byte, the highest first, and where it ends."""
    value = 0
    while data[at] & 0x80:
        value = value << 7 | data[at] & 0x7F
        at += 1
    return value << 7 | data[at], at + 1


def _ending(function: ast.FunctionDef) -> ast.FunctionDef:
    last = [ast.Return(), ast.Return(ast.Constant(_END))]
    return ast.FunctionDef(
        function.name, function.args, [*function.body, *last], function.decorator_list, lineno=1, col_offset=0
    )


def _dumping(functions: Sequence[Function]) -> str:
    listed = "".join(f"({one.name},{one.dumped})," for one in functions)
    return (
        "from machine import mem8 as m,mem32 as n\n"
        f"f=open({DUMP!r},'wb')\n"
        "b=bytearray(16)\n"
        "def d(a,c):\n"
        " for i in range(a,a+c,16):\n"
        "  for j in range(16):b[j]=m[i+j]\n"
        "  f.write(b)\n"
        f"for g,c in({listed}):\n"
        f" d(n[id(g)+12],{_ARGUMENTS})\n"
        " d(n[id(g)+8],c)\n"
        "f.close()\n"
    )


def _named(function: ast.FunctionDef) -> Iterator[str]:
    """What a function names.

    Raises:
        TypeError: there is something in it that has no place in flash.
    """
    for node in ast.walk(function):
        match node:
            case ast.FunctionDef(name=name) if node is function:
                yield name
            case ast.arg(arg=name) | ast.Name(id=name) | ast.Attribute(attr=name) | ast.ExceptHandler(name=str(name)):
                yield name
            case ast.keyword(arg=str(name)):
                yield name
            case ast.Constant(value=None | bool()):
                pass
            case ast.Constant(value=int(number)) if abs(number) < 1 << 30:
                pass
            case (
                ast.Constant()
                | ast.FunctionDef()
                | ast.ClassDef()
                | ast.Lambda()
                | ast.GeneratorExp()
                | ast.ListComp()
                | ast.DictComp()
                | ast.SetComp()
                | ast.JoinedStr()
                | ast.Import()
                | ast.ImportFrom()
                | ast.Yield()
            ):
                raise TypeError(f"`{function.name}` cannot run from flash: there is {ast.unparse(node)} in it")
            case ast.Tuple(elts=elements) if elements and all(isinstance(one, ast.Constant) for one in elements):
                raise TypeError(f"`{function.name}` cannot run from flash: there is {ast.unparse(node)} in it")
