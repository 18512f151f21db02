"""Telling a current board a text through mpremote's transport."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from mpremote.transport_serial import SerialTransport

from kitrobot.deploy.modern import tell_at_once
from kitrobot.deploy.repl import GarbledError


def test_what_the_transport_did_not_expect_is_an_error_and_nothing_is_printed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    answers = [b">", b"R\x01\x80\x00\x01"]
    monkeypatch.setattr(SerialTransport, "read_until", lambda self, *args, **more: answers.pop(0))
    line: Any = SimpleNamespace(
        address="a port", now=lambda: 0.0, read=lambda wait_s: b"??", waiting=lambda: 0, write=lambda data: None
    )
    with pytest.raises(GarbledError, match="raw repl"):
        tell_at_once(line, "s=1")
    assert capsys.readouterr().out == ""
