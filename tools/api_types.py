"""The page's TypeScript types, from the server's models: `web/src/api/generated.ts`; and `web/src/i18n/languages.ts`.

    python tools/api_types.py            write the files
    python tools/api_types.py --check    exit with 1 when they are not what the models and the list of languages say

The names are those of the models without `Shape`. One type a model, or one union an enumeration, in the order of their
names: those that a source of the page names, and those that these are made of. So the file changes only where a model
or the page's use of it did. What is not required is optional: the page may leave it out.
"""

from __future__ import annotations

import json
import re
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from pydantic.json_schema import models_json_schema

from kitrobot.classroom.messages import PUPIL_MESSAGE_MODELS, PUPIL_REQUEST_MODELS
from kitrobot.server.app import create_app
from kitrobot.server.classroom.app import class_api
from kitrobot.translation.languages import LANGUAGES
from kitrobot.wire.run import RUN_MESSAGE_MODELS
from kitrobot.wire.run_requests import REQUEST_MODELS

ROOT = Path(__file__).resolve().parent.parent
SOURCES = ROOT / "web" / "src"
TARGET = SOURCES / "api" / "generated.ts"
LANGUAGES_TARGET = SOURCES / "i18n" / "languages.ts"
LINE_WIDTH = 120

_HEAD = """/**
 * What travels between the server and the page.
 *
 * Written by `python tools/api_types.py` from the models in `src/kitrobot/wire`: change those instead.
 */
"""
# What the framework adds for its own errors; ours are a Failure.
_NOT_OURS = {"HTTPValidationError", "ValidationError"}
_WORD = re.compile(r"\w+")
_COMMENT = re.compile(r"/\*.*?\*/", flags=re.DOTALL)
_PLAIN = {"integer": "number", "number": "number", "string": "string", "boolean": "boolean", "null": "null"}


def types() -> str:
    """The file as it should be."""
    with tempfile.TemporaryDirectory() as folder:
        schemas = create_app(Path(folder), None, "").openapi()["components"]["schemas"] | _of_class()
    ours = sorted(schemas.keys() - _NOT_OURS)
    named = {_name(name): schemas[name] for name in ours}
    assert len(named) == len(ours), f"two models have one name: {ours}"
    declared = {name: _declaration(name, schema) for name, schema in sorted(named.items())}
    for union, models in (("RunMessage", RUN_MESSAGE_MODELS), ("RunRequest", REQUEST_MODELS)):
        declared[union] = _alias(union, [_name(model.__name__) for model in models])
    sources = [path.read_text(encoding="utf-8") for path in SOURCES.rglob("*.ts*") if path != TARGET]
    used = reached_types(declared, sources)
    return "\n".join([_HEAD, *(text for name, text in declared.items() if name in used)])


def languages() -> str:
    """The languages as the page has them."""
    head = """/**
 * Languages by the name that their readers give them, and the way they run.
 *
 * Written by `python tools/api_types.py` from the list in `src/kitrobot/translation/languages.py`: change that instead.
 */
export const LANGUAGES = {"""
    lines = (f'  {code}: {{ name: "{one.name}", dir: "{one.direction}" }},' for code, one in LANGUAGES.items())
    return "\n".join([head, *lines, "} as const;", ""])


def reached_types(declared: Mapping[str, str], sources: Sequence[str]) -> set[str]:
    """The names of `declared` that a source names, and those whose declarations these are made of."""
    reached: set[str] = set()
    named = {word for text in sources for word in _WORD.findall(text)}
    while found := (named & declared.keys()) - reached:
        reached |= found
        named = {word for name in found for word in _WORD.findall(_COMMENT.sub("", declared[name]))}
    return reached


def _of_class() -> dict[str, Any]:
    """The shapes of a class, which is an application of its own."""
    models: Any = [(model, "validation") for model in PUPIL_REQUEST_MODELS]
    models += [(model, "serialization") for model in PUPIL_MESSAGE_MODELS]
    _, extra = models_json_schema(models, ref_template="#/components/schemas/{model}")
    schemas: dict[str, Any] = class_api().openapi()["components"]["schemas"]
    defined: dict[str, Any] = extra["$defs"]
    return schemas | defined


def _name(model: str) -> str:
    return model.removesuffix("Shape")


def _declaration(name: str, schema: Mapping[str, Any]) -> str:
    comment = _comment(schema.get("description", ""))
    if "enum" in schema:
        return "\n".join([*comment, _alias(name, _members(schema))])
    required = set(schema.get("required", ()))
    starts = {
        f"{field}{'' if field in required else '?'}: ": inner for field, inner in schema.get("properties", {}).items()
    }
    line = f"export type {name} = {{ {'; '.join(start + _type(inner) for start, inner in starts.items())} }};"
    if starts and len(line) <= LINE_WIDTH:
        return "\n".join([*comment, line]) + "\n"
    fields = [line for start, inner in starts.items() for line in _field(f"  {start}", inner)]
    return "\n".join([*comment, f"export interface {name} {{", *fields, "}"]) + "\n"


def _field(start: str, schema: Mapping[str, Any]) -> list[str]:
    """The line of a field; one member of a union a line where they do not fit."""
    line = f"{start}{_type(schema)};"
    if len(line) <= LINE_WIDTH:
        return [line]
    members = _members(schema)
    return [start.rstrip(), *(f"    | {member}" for member in members[:-1]), f"    | {members[-1]};"]


def _alias(name: str, members: list[str]) -> str:
    line = f"export type {name} = {' | '.join(members)};"
    if len(line) <= LINE_WIDTH:
        return line + "\n"
    return "\n".join([f"export type {name} =", *(f"  | {member}" for member in members)]) + ";\n"


def _comment(text: str) -> list[str]:
    words = " ".join(text.partition(">>>")[0].split())
    if not words:
        return []
    line = f"/** {words} */"
    if len(line) <= LINE_WIDTH:
        return [line]
    rows, row = ["/**"], " *"
    for word in words.split(" "):
        if len(row) + 1 + len(word) > LINE_WIDTH:
            rows.append(row)
            row = " *"
        row += f" {word}"
    return [*rows, row, " */"]


def _members(schema: Mapping[str, Any]) -> list[str]:
    if "enum" in schema:
        return [json.dumps(value) for value in schema["enum"]]
    return [_type(member) for member in schema.get("anyOf", ())] or [_type(schema)]


def _type(schema: Mapping[str, Any]) -> str:
    if "$ref" in schema:
        return _name(schema["$ref"].rpartition("/")[2])
    if "const" in schema:
        return json.dumps(schema["const"])
    if "enum" in schema or "anyOf" in schema:
        return " | ".join(_members(schema))
    kind = schema.get("type")
    if kind == "array":
        if "prefixItems" in schema:
            return f"[{', '.join(_type(item) for item in schema['prefixItems'])}]"
        inner = _type(schema["items"])
        return f"({inner})[]" if " " in re.sub(r"\[.*\]|<.*>", "", inner) else f"{inner}[]"
    if kind == "object" and "additionalProperties" in schema:
        return f"Record<string, {_type(schema['additionalProperties'])}>"
    if kind in _PLAIN:
        return _PLAIN[kind]
    raise ValueError(f"no TypeScript for {schema}")


def main(arguments: list[str]) -> int:
    """Writes or checks the files; the exit status."""
    status = 0
    for target, wanted in ((TARGET, types()), (LANGUAGES_TARGET, languages())):
        if target.is_file() and target.read_text(encoding="utf-8") == wanted:
            continue
        if "--check" in arguments:
            print(f"{target.relative_to(ROOT)} is not current: python tools/api_types.py", file=sys.stderr)
            status = 1
        else:
            target.write_text(wanted, encoding="utf-8", newline="\n")
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
