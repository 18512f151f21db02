"""Plain values as TOML, which Python reads and does not write: what `plan.toml` needs of it."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence

Plain = str | int | float | bool | Sequence["Plain"]

_UNSAFE = re.compile(r"[\x00-\x08\x0b-\x1f\x7f]|'''|'$")


def write_toml(values: Mapping[str, Plain], tables: Sequence[tuple[str, Mapping[str, Plain]]]) -> str:
    """A document: values, then tables of an array each, in their order."""
    lines = [f"{name} = {_text(value)}" for name, value in values.items()]
    for name, table in tables:
        lines += ["", f"[[{name}]]", *(f"{key} = {_text(value)}" for key, value in table.items())]
    return "\n".join(lines) + "\n"


def _text(value: Plain) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        if "\n" in value and not _UNSAFE.search(value):
            return f"'''\n{value}'''"
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, int | float):
        return repr(value)
    return f"[{', '.join(map(_text, value))}]"
