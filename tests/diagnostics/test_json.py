"""What programs read: the published shape, exactly."""

from __future__ import annotations

from kitrobot.diagnostics.model import Diagnostic, Fix, Place, Severity
from kitrobot.diagnostics.renderer import to_json, to_page_json
from kitrobot.text.sentences import Sentence

FULL = Diagnostic(
    "two-arcs",
    Severity.ERROR,
    Sentence("two arcs leave `v1` at `next`"),
    Place("carrier.lll", 3, 5, 4, 1),
    help=Sentence("delete one of them"),
    program="carrier",
    vertices=("v1", "v2"),
    arcs=(("v1", "next", "v2", "in"), ("v1", "next", "v3", "in")),
    fix=Fix(";"),
)


def test_the_published_shape() -> None:
    assert to_json(FULL) == {
        "file": "carrier.lll",
        "line": 3,
        "column": 5,
        "end_line": 4,
        "end_column": 1,
        "severity": "error",
        "code": "two-arcs",
        "message": Sentence("two arcs leave `v1` at `next`"),
        "help": "delete one of them",
    }


def test_the_order_of_the_published_shape() -> None:
    wanted = ["file", "line", "column", "end_line", "end_column", "severity", "code", "message", "help"]
    assert list(to_json(FULL)) == wanted
    assert list(to_page_json(FULL)) == [*wanted, "program", "vertices", "arcs", "thing", "fix"]


def test_what_has_no_place_has_the_place_nought() -> None:
    bare = Diagnostic("parked", Severity.HINT, Sentence("think"))
    assert to_json(bare) == {
        "file": "",
        "line": 0,
        "column": 0,
        "end_line": 0,
        "end_column": 0,
        "severity": "hint",
        "code": "parked",
        "message": "think",
        "help": "",
    }


def test_the_page_gets_vertices_and_arcs_too() -> None:
    assert to_page_json(FULL) == {
        **to_json(FULL),
        "program": "carrier",
        "vertices": ["v1", "v2"],
        "arcs": [["v1", "next", "v2", "in"], ["v1", "next", "v3", "in"]],
        "thing": "",
        "fix": {"text": ";", "kind": "text", "name": ""},
    }


def test_a_severity_is_plain_text() -> None:
    assert [type(to_json(Diagnostic("c", one, Sentence("m")))["severity"]) for one in Severity] == [str, str, str]
    assert list(Severity) == ["error", "warning", "hint"]
