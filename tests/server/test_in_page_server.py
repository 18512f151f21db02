"""The studio without a network, threads, processes and every package that a browser does not have."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.text.json_text import from_json, plain_from_json, plain_to_json, to_json
from tests.server.in_page_scenario import environment

SCENARIO = Path(__file__).with_name("in_page_scenario.py")


def test_a_page_opens_checks_runs_and_saves_where_only_is_what_a_browser_has(tmp_path: Path) -> None:
    folder = tmp_path / "missions"
    ran = subprocess.run(
        [sys.executable, str(SCENARIO), str(folder)],
        capture_output=True,
        text=True,
        check=False,
        env=environment(tmp_path),
    )
    assert ran.returncode == 0, ran.stderr
    told = json.loads(ran.stdout.splitlines()[-1])
    assert told["first"] == "example:transport/transport.krt"
    assert told["vertices"] > 5
    assert told["check"] == [200, 5]
    assert told["run"] == "done"
    assert told["frames"] > 1
    assert told["saved"] == [200, True]
    assert told["own"] == ["mine.krt"]
    # Where calls cannot be put to sleep.
    assert told["boards"] == "This browser cannot wait for robots while it does other things."
    assert told["sweep"] == "map"
    assert told["experiment"] == ["study", 2]
    assert told["verify"] == "end"
    assert told["fleet"] == "A team as processes cannot run in a page."
    assert told["french"].startswith("La demande n'a pas été comprise")
    assert told["nowhere"] == 404
    # Where they can.
    assert told["ports"] == ["micro:bit"]
    assert told["checked meanwhile"] == [200]
    assert told["stopped"]
    assert told["network"] == "A page reaches only boards that were chosen in it."
    assert told["pulled"] == "The link to `micro:bit` is lost: its motors stop within one second."
    assert told["imported"] == []


PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**53), 2**53) | st.floats(allow_subnormal=False) | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=20,
)


@given(PLAIN)
def test_json_of_the_standard_library_says_what_orjson_says(value: object) -> None:
    assert from_json(plain_to_json(value)) == from_json(to_json(value))
    assert plain_from_json(to_json(value)) == from_json(to_json(value))


@pytest.mark.parametrize(
    "text",
    [b"", b"{", b"NaN", b"[Infinity]", b'"\\ud800"', b"\xff", b"[" * 100_000, b'{"a":1,}', b"\xef\xbb\xbf1", b"'a'"],
)
def test_what_one_reader_of_json_refuses_the_other_refuses(text: bytes) -> None:
    for read in (from_json, plain_from_json):
        with pytest.raises(json.JSONDecodeError):
            read(text)
