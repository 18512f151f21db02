"""A class over https with a certificate of its own: what is kept and when it is made anew, and who is let in."""

from __future__ import annotations

import os
import re
import socket
import ssl
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path

import httpx
import pytest

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.server.classroom import own_certificate as module
from kitrobot.server.classroom.certificate import certificates_in, validity
from kitrobot.server.classroom.own_certificate import DAYS, RENEWED_DAYS, OwnCertificate, own_certificate
from tests.certificates import self_signed
from tests.patience import PATIENCE_S

pytest.importorskip("cryptography")
HOST = "192.168.4.20"


@pytest.fixture(autouse=True)
def state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    return tmp_path / "state"


def names(made: OwnCertificate) -> list[str]:
    from cryptography import x509

    read, authority = x509.load_pem_x509_certificates(made.path.read_bytes())
    read.verify_directly_issued_by(authority)
    value = read.extensions.get_extension_for_class(x509.SubjectAlternativeName).value
    return [str(one.value) for one in value]


def test_a_certificate_is_kept_and_used_again():
    made = own_certificate(HOST)
    assert made.new
    assert names(made) == [HOST]
    assert re.fullmatch(r"([0-9A-F]{2}:){31}[0-9A-F]{2}", made.fingerprint)
    again = own_certificate(HOST)
    assert not again.new
    assert again.fingerprint == made.fingerprint
    assert own_certificate("192.168.4.21").fingerprint != made.fingerprint


def test_it_has_the_other_names_of_the_machine_and_is_kept_while_it_has_them_all():
    others = ["desk-4", "desk-4.local", "10.0.0.7"]
    made = own_certificate(HOST, others)
    assert names(made) == [HOST, *others]
    assert not own_certificate(HOST, others).new
    assert not own_certificate(HOST, ["desk-4.local"]).new
    again = own_certificate(HOST, [*others, "10.0.0.8"])
    assert again.new
    # What is cut off from a name is another name.
    assert own_certificate(HOST, ["desk-4.loca"]).new


def test_what_other_machines_install_is_an_authority_whose_key_is_gone():
    from cryptography import x509

    made = own_certificate(HOST)
    authority = x509.load_pem_x509_certificate(made.public.read_bytes())
    limits = authority.extensions.get_extension_for_class(x509.BasicConstraints).value
    assert (limits.ca, limits.path_length) == (True, 0)
    assert made.path.read_text().count("PRIVATE KEY-----") == 2  # its beginning and its end
    secret = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    with pytest.raises(ssl.SSLError, match="KEY_VALUES_MISMATCH"):
        secret.load_cert_chain(made.public, made.path)
    assert made.authority_fingerprint != made.fingerprint


@pytest.mark.parametrize("address", ["fe80::1", "::1"])
def test_an_address_of_ipv6_has_a_certificate(address: str):
    made = own_certificate(address)
    assert names(made) == [address]
    assert ":" not in made.path.name
    assert not own_certificate(address).new


@pytest.mark.skipif(os.name == "nt", reason="modes of POSIX")
def test_the_key_is_for_its_user_alone(state: Path):
    made = own_certificate(HOST)
    assert made.path.stat().st_mode & 0o777 == 0o600
    assert (state / "https").stat().st_mode & 0o777 == 0o700
    assert "PRIVATE" not in made.public.read_text()
    assert sorted(one.name for one in (state / "https").iterdir()) == [f"{HOST}.crt", f"{HOST}.pem"]


def test_it_is_renewed_a_month_before_its_end():
    now = datetime.now(UTC)
    made = own_certificate(HOST, now=now)
    for one in certificates_in(made.path.read_text()):
        first, last = validity(one)
        assert last - first == timedelta(days=DAYS)
        assert first < now - timedelta(days=1)
    assert not own_certificate(HOST, now=last - timedelta(days=RENEWED_DAYS, seconds=1)).new
    assert own_certificate(HOST, now=last - timedelta(days=RENEWED_DAYS)).new


def _other_key(made: OwnCertificate, folder: Path) -> None:
    certificates = made.path.read_text().partition("-----BEGIN CERTIFICATE")
    made.path.write_text(self_signed(folder).key.read_text() + "".join(certificates[1:]))


def _older_form(made: OwnCertificate, folder: Path) -> None:
    alone = self_signed(folder)
    made.path.write_text(alone.key.read_text() + alone.certificate.read_text())
    made.public.write_text(alone.certificate.read_text())


def _other_address(made: OwnCertificate, folder: Path) -> None:
    other = own_certificate("192.168.4.21")
    made.path.write_bytes(other.path.read_bytes())
    made.public.write_bytes(other.public.read_bytes())


SPOILED = {
    "torn": lambda made, folder: made.path.write_bytes(made.path.read_bytes()[:300]),
    "torn in the certificate": lambda made, folder: made.path.write_bytes(made.path.read_bytes()[:-80]),
    "empty": lambda made, folder: made.path.write_bytes(b""),
    "binary": lambda made, folder: made.path.write_bytes(bytes(range(256)) * 9),
    "only the certificate": lambda made, folder: made.path.write_bytes(made.public.read_bytes()),
    "another key": _other_key,
    "another address": _other_address,
    "signed by itself": _older_form,
    "the authority of another": lambda made, folder: made.public.write_bytes(
        own_certificate("::1").public.read_bytes()
    ),
    "the public one is gone": lambda made, folder: made.public.unlink(),
    "the public one is torn": lambda made, folder: made.public.write_text("-----BEGIN CERTIFICATE-----\nAA"),
    "others can read it": lambda made, folder: made.path.chmod(0o644),
    "a link": lambda made, folder: made.path.rename(folder / "x") and made.path.symlink_to(folder / "x"),
}


@pytest.mark.parametrize("how", SPOILED)
def test_what_cannot_be_used_is_made_anew(tmp_path: Path, how: str):
    made = own_certificate(HOST)
    before = made.fingerprint
    SPOILED[how](made, tmp_path)
    again = own_certificate(HOST)
    assert again.new
    assert again.fingerprint != before
    assert names(again) == [HOST]
    assert not own_certificate(HOST).new


def _file_in_the_way(state: Path) -> None:
    state.write_text("")


def _folder_in_the_way(state: Path) -> None:
    (state / "https" / f"{HOST}.pem").mkdir(parents=True)


@pytest.mark.parametrize("spoil", [_file_in_the_way, _folder_in_the_way])
def test_a_folder_that_cannot_be_written_is_a_sentence(state: Path, spoil):
    spoil(state)
    with pytest.raises(KitRobotError, match="could not be kept in") as found:
        own_certificate(HOST)
    assert "KITROBOT_STATE" in str(found.value.help)


def test_without_the_package_the_command_to_install_it_is_named(monkeypatch: pytest.MonkeyPatch, state: Path):
    monkeypatch.setitem(sys.modules, "cryptography", None)
    with pytest.raises(KitRobotError, match="needs the package `cryptography`") as found:
        own_certificate(HOST)
    assert "`pip install kitrobot[https]`" in str(found.value.help)
    assert not state.exists()


def test_with_one_that_is_kept_nothing_is_needed(monkeypatch: pytest.MonkeyPatch):
    own_certificate(HOST)
    monkeypatch.setattr(module, "_made", None)
    assert not own_certificate(HOST).new


@dataclass(frozen=True)
class OpenClass:
    """A class that is open over https as a process: its address without scheme, and what it said until it was ready."""

    place: str
    said: str
    certificate: Path


@pytest.fixture
def open_class(tmp_path: Path, state: Path) -> Iterator[OpenClass]:
    command = [sys.executable, "-m", "kitrobot", "class", str(tmp_path / "Class"), "--no-browser", "--port", "0"]
    process = subprocess.Popen([*command, "--https"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        assert process.stdout is not None
        assert process.stderr is not None
        found = re.match(r"https://(127\.0\.0\.1:\d+)/teacher\?token=", process.stdout.readline())
        assert found is not None
        said = []
        for line in process.stderr:
            said.append(line)
            if "Ctrl-C" in line:
                break
        yield OpenClass(found[1], "".join(said), state / "https" / "127.0.0.1.crt")
    finally:
        process.kill()
        process.communicate()


def _plain(place: str, sent: bytes) -> bytes:
    """What comes back until the connection ends; nothing where it is broken off."""
    host, _, port = place.rpartition(":")
    with socket.create_connection((host, int(port)), PATIENCE_S) as line:
        line.sendall(sent)
        try:
            return b"".join(iter(lambda: line.recv(65536), b""))
        except ConnectionResetError:
            return b""


def a_client_that_trusts_the_certificate_gets_the_page(opened: OpenClass) -> None:
    trusting = ssl.create_default_context(cafile=str(opened.certificate))
    # As Python checks from 3.13 on.
    trusting.verify_flags |= ssl.VERIFY_X509_STRICT
    with httpx.Client(base_url=f"https://{opened.place}", verify=trusting, timeout=PATIENCE_S) as client:
        assert '<meta name="kitrobot-class" content="pupil">' in client.get("/").text
        assert client.get("/api/class").status_code == 200
    with pytest.raises(httpx.ConnectError, match="CERTIFICATE_VERIFY_FAILED"):
        httpx.get(f"https://{opened.place}/", timeout=PATIENCE_S)


def another_name_is_not_of_the_certificate(opened: OpenClass) -> None:
    trusting = ssl.create_default_context(cafile=str(opened.certificate))
    address = opened.place.replace("127.0.0.1", "localhost")
    with pytest.raises(httpx.ConnectError, match="CERTIFICATE_VERIFY_FAILED"):
        httpx.get(f"https://{address}/", verify=trusting, timeout=PATIENCE_S)


def the_terminal_says_fingerprint_warning_and_use(opened: OpenClass) -> None:
    own = OwnCertificate(opened.certificate.with_suffix(".pem"), opened.certificate, new=False)
    assert f"is new; its fingerprint (SHA-256) is\n{own.fingerprint}\n" in opened.said
    assert f"install its certificate from http://{opened.place}/certificate\n" in opened.said
    assert f"with this one:\n{own.authority_fingerprint}\n" in opened.said
    assert "press `Advanced`, then `Proceed to 127.0.0.1`" in opened.said
    assert f"where {opened.certificate} is installed as trusted" in opened.said


def plain_http_gets_the_address_over_https(opened: OpenClass) -> None:
    answer = httpx.get(f"http://{opened.place}/teacher?token=x", timeout=PATIENCE_S)
    assert answer.status_code == 426
    assert f'<a href="https://{opened.place}/">' in answer.text
    assert "<code>Advanced</code>" in answer.text
    french = httpx.get(f"http://{opened.place}/", headers={"Accept-Language": "fr-CA,en"}, timeout=PATIENCE_S)
    assert '<html lang="fr" dir="ltr">' in french.text
    assert httpx.head(f"http://{opened.place}/", timeout=PATIENCE_S).text == ""
    # Nothing of a request stands in the page, and a request may come in pieces.
    forged = _plain(opened.place, b"GET /<b> HTTP/1.1\r\nHost: evil.example\r\n\r\n")
    assert b"evil" not in forged
    assert b"<b>" not in forged


def plain_http_gives_the_certificate_to_install(opened: OpenClass) -> None:
    page = httpx.get(f"http://{opened.place}/", timeout=PATIENCE_S).text
    found = re.search(r'href="(http://[^"]*/certificate)"', page)
    assert found is not None
    answer = httpx.get(found[1], timeout=PATIENCE_S)
    assert (answer.status_code, answer.headers["content-type"]) == (200, "application/x-x509-ca-cert")
    assert answer.content == opened.certificate.read_bytes()
    assert b"PRIVATE" not in answer.content
    assert httpx.head(found[1], timeout=PATIENCE_S).headers["content-length"] == str(len(answer.content))
    for other in ("/certificates", "/certificate/x", "//certificate", "/%63ertificate"):
        assert httpx.get(f"http://{opened.place}{other}", timeout=PATIENCE_S).status_code == 426
    assert httpx.post(found[1], timeout=PATIENCE_S).status_code == 426


def who_sends_something_else_is_put_off(opened: OpenClass) -> None:
    assert _plain(opened.place, b"x" * 20_000) == b""
    # A record of TLS that is none gets an alert of TLS, which is no page.
    assert b"HTTP" not in _plain(opened.place, b"\x16\x03\x01\x00\x08no hello")
    host, _, port = opened.place.rpartition(":")
    silent = [socket.create_connection((host, int(port)), PATIENCE_S) for _ in range(5)]
    a_client_that_trusts_the_certificate_gets_the_page(opened)
    for one in silent:
        one.close()


def test_a_class_with_a_certificate_of_its_own(open_class: OpenClass):
    a_client_that_trusts_the_certificate_gets_the_page(open_class)
    another_name_is_not_of_the_certificate(open_class)
    the_terminal_says_fingerprint_warning_and_use(open_class)
    plain_http_gets_the_address_over_https(open_class)
    plain_http_gives_the_certificate_to_install(open_class)
    who_sends_something_else_is_put_off(open_class)


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["--https", "--host", "school.example"], "`school.example` is no address of this machine"),
        (["--https", "--tls", "a.pem", "b.pem"], "`--https` and `--tls` name two certificates"),
    ],
)
def test_options_that_do_not_fit_are_a_sentence(tmp_path: Path, state: Path, options: list[str], expected: str):
    command = [sys.executable, "-m", "kitrobot", "class", str(tmp_path / "Class"), "--no-browser", *options]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S)
    assert done.returncode != 0
    assert expected in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "Class").exists()
    assert not state.exists()
