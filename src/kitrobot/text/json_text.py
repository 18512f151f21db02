r"""JSON to and from bytes: through orjson, and where there is none through the standard library, with the same meaning.

Either reads what RFC 8259 allows and nothing else: no NaN, no half of a character (`"\ud800"`). Either writes plain
types and nothing else: what only orjson could write would fail in a page. Left to others: mending what an editor sends
that is no JSON by that (`json_bodies`).
"""

from __future__ import annotations

import json
from json import JSONDecodeError
from typing import Any

try:
    import orjson as fast
except ImportError:
    HAS_ORJSON = False
else:
    HAS_ORJSON = True
    _PLAIN_TYPES = fast.OPT_PASSTHROUGH_DATACLASS | fast.OPT_PASSTHROUGH_DATETIME


def to_json(value: Any) -> bytes:
    """A value of plain types as JSON in UTF-8, without spaces.

    Raises:
        TypeError: there is something else in it.
    """
    return fast.dumps(value, option=_PLAIN_TYPES) if HAS_ORJSON else plain_to_json(value)


def from_json(text: bytes | str) -> Any:
    """The value of a JSON text.

    Raises:
        JSONDecodeError: it is none, or nested too deeply.
    """
    return fast.loads(text) if HAS_ORJSON else plain_from_json(text)


def plain_to_json(value: Any) -> bytes:
    """As `to_json`, by the standard library."""
    try:
        text = json.dumps(value, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    except ValueError:
        # What is no number is null, as orjson says it.
        text = json.dumps(_with_numbers_only(value), ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.encode()


def plain_from_json(text: bytes | str) -> Any:
    """As `from_json`, by the standard library."""
    try:
        words = text if isinstance(text, str) else text.decode()
        value = json.loads(words, parse_constant=_refuse)
        if "\\u" in words:
            json.dumps(value, ensure_ascii=False).encode()  # half of a character cannot be written
    except JSONDecodeError:
        raise
    except (ValueError, RecursionError) as error:
        raise JSONDecodeError(f"no JSON: {type(error).__name__}", "", 0) from error
    return value


def _refuse(constant: str) -> Any:
    raise ValueError(constant)


def _with_numbers_only(value: Any) -> Any:
    if isinstance(value, float) and (value != value or value in (float("inf"), float("-inf"))):
        return None
    if isinstance(value, dict):
        return {key: _with_numbers_only(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [_with_numbers_only(one) for one in value]
    return value
