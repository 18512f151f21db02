"""Messages as bytes: JSON lists `[version, run, kind, field, …]`, read by the types of the fields and by nothing else.

`run` is a number that all members of one run share, so that an earlier run is not heard. Reading never fails with
anything but `MessageError`, whatever the bytes are: cut off, too large, of another version, of wrong types.
"""

from __future__ import annotations

import json
import types
from collections.abc import Callable
from itertools import chain, starmap
from typing import Any, get_args, get_origin, get_type_hints

from kitrobot.team import commands, messages, tables
from kitrobot.team.messages import Message
from kitrobot.text.sentences import Sentence

VERSION = 2
MOST_BYTES = 1 << 18
LARGEST = 1 << 53

_NAMES: dict[str, type] = {kind.__name__: kind for kind in get_args(Message)}
_Reader = Callable[[object], Any]


class MessageError(ValueError):
    """Bytes that are no message of this run; its one argument is a `Sentence`."""


def encode(message: Message, run: int) -> bytes:
    """The message as bytes, at most `MOST_BYTES` for any message that a member sends."""
    plain = [VERSION, run, type(message).__name__, *_plain(message)]
    return json.dumps(plain, separators=(",", ":")).encode()


def decode(data: bytes, run: int) -> Message:
    """The message that the bytes stand for.

    Raises:
        MessageError: they are no message of this version and run.
    """
    if len(data) > MOST_BYTES:
        raise MessageError(Sentence("a message of {size} bytes is too large", len(data)))
    try:
        match json.loads(data):
            case [int(version), *_] if version != VERSION:
                raise MessageError(Sentence("a message of version {other}, this is version {own}", version, VERSION))
            case [int(), int(other), *_] if other != run:
                raise MessageError(Sentence("a message of another run"))
            case [int(), int(), str(name), *fields] if name in _NAMES:
                message: Message = _READERS[name](fields)
                return message
    except (ValueError, RecursionError, UnicodeDecodeError) as error:
        if isinstance(error, MessageError):
            raise
    raise MessageError(Sentence("this is no message of a team"))


def _plain(value: object) -> Any:
    """A value as lists and numbers."""
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    if not hasattr(value, "__dataclass_fields__"):
        return value
    fields = [_plain(getattr(value, name)) for name in value.__dataclass_fields__]
    return [_BODIES.index(type(value)), *fields] if type(value) in _BODIES else fields


_BODIES: tuple[type, ...] = get_args(commands.Body)


def _number(value: object) -> int:
    if type(value) is not int or not -LARGEST <= value <= LARGEST:
        raise ValueError
    return value


def _numbers(value: object) -> list[int]:
    """A list of numbers alone, which most of what is read is."""
    found = _list(value)
    if not set(map(type, found)) <= {int} or (found and not -LARGEST <= min(found) <= max(found) <= LARGEST):
        raise ValueError
    return found


def _rows_of_numbers(kind: type, count: int) -> _Reader:
    """A list of rows, each of so many numbers: checked all at once, because heartbeats hold one for each member."""

    def read(value: object) -> Any:
        rows = _list(value)
        if not set(map(type, rows)) <= {list} or not set(map(len, rows)) <= {count}:
            raise ValueError
        _numbers(list(chain.from_iterable(rows)))
        return tuple(starmap(kind, rows))

    return read


def _truth(value: object) -> bool:
    if type(value) is not bool:
        raise ValueError
    return value


def _row(item: _Reader) -> _Reader:
    return lambda value: tuple([item(one) for one in _list(value)])


def _of_numbers(kind: type, count: int) -> _Reader:
    def read(value: object) -> Any:
        numbers = _numbers(value)
        if len(numbers) != count:
            raise ValueError
        return kind(*numbers)

    return read


def _fields(kind: type, readers: list[_Reader]) -> _Reader:
    return lambda value: kind(*[read(one) for read, one in zip(readers, _list(value), strict=True)])


def _one_of(kinds: list[_Reader]) -> _Reader:
    def read(value: object) -> Any:
        which, *fields = _list(value)
        if not 0 <= _number(which) < len(kinds):
            raise ValueError
        return kinds[which](fields)

    return read


def _list(value: object) -> list[Any]:
    if not isinstance(value, list):
        raise ValueError
    return value


def _reader(kind: Any) -> _Reader:
    """What reads a value of a type."""
    if kind is int:
        return _number
    if kind is bool:
        return _truth
    if get_origin(kind) is tuple:
        item = get_args(kind)[0]
        if item is int:
            return lambda value: tuple(_numbers(value))
        hints = _hints(item) if isinstance(item, type) else []
        return _rows_of_numbers(item, len(hints)) if set(hints) == {int} else _row(_reader(item))
    if isinstance(kind, types.UnionType):
        return _one_of([_reader(one) for one in get_args(kind)])
    hints = _hints(kind)
    return _of_numbers(kind, len(hints)) if set(hints) == {int} else _fields(kind, [_reader(hint) for hint in hints])


def _hints(kind: Any) -> list[Any]:
    """The types of the fields of a message, or of a part of one."""
    return list(get_type_hints(kind, {**vars(commands), **vars(tables), **vars(messages)}).values())


_READERS = {name: _reader(kind) for name, kind in _NAMES.items()}
