"""A class over TLS: the page, the requests and the socket; and certificates that cannot be used."""

from __future__ import annotations

import asyncio
import json
import os
import re
import ssl
import subprocess
import sys
import tomllib
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import httpx
import pytest
from websockets import Origin
from websockets.asyncio.client import connect

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.server.classroom.certificate import usable_certificate, validity
from tests import coroutines
from tests.certificates import self_signed
from tests.patience import PATIENCE_S


def first_said(address: str, trusting: ssl.SSLContext, origin: str) -> Any:
    """The first message over a socket. (One thread: Python before 3.13 loses what two read and write over one TLS.)"""

    async def heard() -> Any:
        options: Any = {"ssl": trusting, "origin": Origin(origin), "open_timeout": PATIENCE_S, "proxy": None}
        async with connect(address, **options) as socket:
            return json.loads(await asyncio.wait_for(socket.recv(), PATIENCE_S))

    return coroutines.run(heard())


def test_pupils_join_and_are_told_over_tls(tmp_path):
    made = self_signed(tmp_path)
    folder = tmp_path / "Class"
    command = [sys.executable, "-m", "kitrobot", "class", str(folder), "--no-browser", "--port", "0", "--tls"]
    environment = {**os.environ, "KITROBOT_STATE": str(tmp_path / "state")}
    process = subprocess.Popen(
        [*command, str(made.certificate), str(made.key)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env=environment,
    )
    try:
        assert process.stdout is not None
        found = re.match(r"https://(127\.0\.0\.1:\d+)/teacher\?token=(.+)", process.stdout.readline().strip())
        assert found is not None
        place, key = found.groups()
        trusting = ssl.create_default_context(cafile=str(made.certificate))
        # Python from 3.13 on wants more of a certificate than browsers do.
        trusting.verify_flags &= ~ssl.VERIFY_X509_STRICT
        with httpx.Client(base_url=f"https://{place}", verify=trusting, timeout=PATIENCE_S) as client:
            assert '<meta name="kitrobot-class" content="pupil">' in client.get("/").text
            code = tomllib.loads((folder / "class.toml").read_text())["code"]
            origin = {"Origin": f"https://{place}"}
            joined = client.post("/api/class/join", json={"code": code, "name": "Ada"}, headers=origin).json()
            assert joined["state"] == "in"
            # A page of plain HTTP is another one.
            assert client.get("/api/class", headers={"Origin": f"http://{place}"}).status_code == 403
            watch = f"wss://{place}/api/class/teacher/watch?token={key}"
            own = f"wss://{place}/api/class/pupil?token={joined['key']}"
            assert first_said(own, trusting, f"https://{place}")["name"] == "Ada"
            assert first_said(watch, trusting, f"https://{place}")["address"] == f"https://{place}/"
        # Who does not encrypt learns the address; who does not trust the certificate nothing.
        plain = httpx.get(f"http://{place}/api/class", timeout=PATIENCE_S)
        assert plain.status_code == 426
        assert f'<a href="https://{place}/">' in plain.text
        with pytest.raises(httpx.ConnectError, match="CERTIFICATE_VERIFY_FAILED"):
            httpx.get(f"https://{place}/", timeout=PATIENCE_S)
    finally:
        process.kill()
        process.wait(PATIENCE_S)
        if process.stdout is not None:
            process.stdout.close()


def test_a_certificate_tells_its_days(tmp_path):
    made = self_signed(tmp_path, days=10, since=-3)
    first, last = validity(ssl.PEM_cert_to_DER_cert(made.certificate.read_text()))
    assert last - first == timedelta(days=10)
    assert abs(first - (datetime.now(UTC) - timedelta(days=3))) < timedelta(minutes=5)
    usable_certificate(made.certificate, made.key)
    # Of a chain the first is the class's.
    old = self_signed(tmp_path, since=-90, stem="old")
    made.certificate.write_text(made.certificate.read_text() + old.certificate.read_text())
    usable_certificate(made.certificate, made.key)


def _other_key(made, folder: Path) -> None:
    made.key.write_text(self_signed(folder, stem="other").key.read_text())


def _swapped(made, folder: Path) -> None:
    words = made.key.read_text()
    made.key.write_text(made.certificate.read_text())
    made.certificate.write_text(words)


WRONG = {
    "missing certificate": (lambda made, folder: made.certificate.unlink(), "class.pem"),
    "missing key": (lambda made, folder: made.key.unlink(), "class.key"),
    "empty": (lambda made, folder: made.certificate.write_text(""), "no certificate in"),
    "binary": (lambda made, folder: made.certificate.write_bytes(os.urandom(1000)), "no certificate in"),
    "swapped": (_swapped, "no certificate in"),
    "no key": (lambda made, folder: made.key.write_text("hello"), "no key in"),
    "cut off": (
        lambda made, folder: made.certificate.write_text(made.certificate.read_text()[:200]),
        "cannot be used",
    ),
    "key cut off": (lambda made, folder: made.key.write_text(made.key.read_text()[:80]), "cannot be used"),
    "another key": (_other_key, "does not belong to"),
    "a password": (
        lambda made, folder: made.key.write_text(
            "-----BEGIN ENCRYPTED PRIVATE KEY-----\nAA==\n-----END ENCRYPTED PRIVATE KEY-----\n"
        ),
        "has a password",
    ),
}


@pytest.mark.parametrize("what", WRONG)
def test_a_wrong_certificate_or_key_is_a_sentence(tmp_path, what):
    made = self_signed(tmp_path)
    spoil, expected = WRONG[what]
    spoil(made, tmp_path)
    with pytest.raises(KitRobotError, match=expected) as raised:
        usable_certificate(made.certificate, made.key)
    assert "_ssl.c" not in str(raised.value)


@pytest.mark.parametrize(("since", "days", "expected"), [(-40, 30, "ended on"), (2, 30, "counts from")])
def test_a_certificate_that_does_not_count_today_is_a_sentence(tmp_path, since, days, expected):
    made = self_signed(tmp_path, days=days, since=since)
    with pytest.raises(KitRobotError, match=expected):
        usable_certificate(made.certificate, made.key)


def test_a_class_says_so_before_it_listens(tmp_path):
    made = self_signed(tmp_path, since=-90)
    command = [sys.executable, "-m", "kitrobot", "class", str(tmp_path / "Class"), "--no-browser", "--port", "0"]
    done = subprocess.run(
        [*command, "--tls", str(made.certificate), str(made.key)],
        capture_output=True,
        text=True,
        timeout=PATIENCE_S,
        env={**os.environ, "KITROBOT_STATE": str(tmp_path / "state")},
    )
    assert done.returncode != 0
    assert done.stdout == ""
    assert "ended on" in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "Class").exists()
