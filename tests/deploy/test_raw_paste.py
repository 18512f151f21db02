"""Telling a current board a text through mpremote's transport."""

from __future__ import annotations

import pytest

from kitrobot.deploy.line.raw_paste import run_by_raw_paste
from kitrobot.deploy.line.repl import GarbledError
from tests.deploy.fake_boards import FakeLine

PROMPT = {b"\r\x03\x01": [(0.0, b">")]}


def test_what_the_transport_did_not_expect_is_an_error_and_nothing_is_printed(
    capsys: pytest.CaptureFixture[str],
) -> None:
    answers = PROMPT | {b"\x05A\x01": [(0.0, b"??")]}
    with pytest.raises(GarbledError, match="raw repl"):
        run_by_raw_paste(FakeLine(lambda data: answers.get(data, [])), "s=1")
    assert capsys.readouterr().out == ""


def test_what_was_lost_is_given_up_by_the_clock_of_the_line_and_soon() -> None:
    answers = PROMPT | {b"\x05A\x01": [(0.0, b"R\x01\x80\x00\x01")]}
    line = FakeLine(lambda data: answers.get(data, []))
    with pytest.raises(GarbledError, match="raw paste"):
        run_by_raw_paste(line, "s=1")
    assert 1 < line.now() < 3
