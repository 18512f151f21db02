"""The certificate of a class and its key, looked at before anything listens: what is wrong with them is one sentence.

A certificate's days are read here by hand (`validity`): Python gives them only for certificates that it has verified.
"""

from __future__ import annotations

import ssl
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from kitrobot.files.disk import read_bytes
from kitrobot.server.studio_server import ServerError
from kitrobot.text.sentences import Sentence

_BEGIN: Final = "-----BEGIN CERTIFICATE-----"
_END: Final = "-----END CERTIFICATE-----"
_SEQUENCE: Final = 0x30
_VERSION: Final = 0xA0
_UTC_TIME: Final = 0x17
_GENERALIZED_TIME: Final = 0x18


def usable_certificate(certificate: Path, key: Path, now: datetime | None = None) -> None:
    """Looks whether a class can be served with them.

    Raises:
        FileError: one of them cannot be read.
        ServerError: they cannot be used, or the certificate does not count today.
    """
    words = read_bytes(certificate).decode("latin-1")
    secret = read_bytes(key).decode("latin-1")
    if _BEGIN not in words:
        raise ServerError(
            Sentence("there is no certificate in `{path}`", certificate),
            Sentence("first comes a file with a certificate in PEM, then one with its key"),
        )
    if "PRIVATE KEY-----" not in secret:
        raise ServerError(
            Sentence("there is no key in `{path}`", key),
            Sentence("first comes a file with a certificate in PEM, then one with its key"),
        )
    if "ENCRYPTED" in secret:
        raise ServerError(
            Sentence("the key `{path}` has a password", key),
            Sentence("write it without one: `openssl pkey -in {path} -out key.pem`", key.name),
        )
    try:
        # Otherwise OpenSSL asks in the terminal for a password that the lines above did not reveal.
        ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER).load_cert_chain(certificate, key, password=lambda: "-")
        first, last = validity(certificates_in(words)[0])
    except ssl.SSLError as error:
        if error.reason == "KEY_VALUES_MISMATCH":
            raise ServerError(
                Sentence("the key `{key}` does not belong to the certificate `{path}`", key, certificate),
                Sentence("give the key that was made with it"),
            ) from None
        raise _no_use(certificate) from None
    except (OSError, ValueError, IndexError):
        raise _no_use(certificate) from None
    _expect_today(certificate, first, last, now or datetime.now(UTC))


def certificates_in(words: str) -> list[bytes]:
    """The certificates of a text in PEM, one after the other, as DER.

    Raises:
        ValueError: one is none.
    """
    return [ssl.PEM_cert_to_DER_cert(_BEGIN + part.partition(_END)[0] + _END) for part in words.split(_BEGIN)[1:]]


def validity(der: bytes) -> tuple[datetime, datetime]:
    """The first and the last moment of a certificate.

    Raises:
        ValueError: it is none.
        IndexError: it ends in the middle.
    """
    inner = _inside(_inside(der)[0][1])
    fields = inner[1:] if inner[0][0] == _VERSION else inner
    # Number, algorithm, issuer, and then from when till when.
    first, last = _inside(fields[3][1])[:2]
    return _moment(*first), _moment(*last)


def _inside(der: bytes) -> list[tuple[int, bytes]]:
    """What is in a sequence: of each its tag, and the bytes: of a sequence with its head, of others without."""
    tag, start, end = _head(der, 0)
    if tag != _SEQUENCE or end > len(der):
        raise ValueError
    found = []
    at = start
    while at < end:
        tag, start, after = _head(der, at)
        found.append((tag, der[at:after] if tag == _SEQUENCE else der[start:after]))
        at = after
    return found


def _head(der: bytes, at: int) -> tuple[int, int, int]:
    """The tag at that place, where its bytes begin and where they end."""
    tag, length, start = der[at], der[at + 1], at + 2
    if length >= 0x80:
        count = length & 0x7F
        length, start = int.from_bytes(der[start : start + count], "big"), start + count
    return tag, start, start + length


def _moment(tag: int, text: bytes) -> datetime:
    words = text.decode("ascii")
    if tag == _UTC_TIME:
        words = ("19" if int(words[:2]) >= 50 else "20") + words
    elif tag != _GENERALIZED_TIME:
        raise ValueError
    return datetime.strptime(words, "%Y%m%d%H%M%SZ").replace(tzinfo=UTC)


def _expect_today(path: Path, first: datetime, last: datetime, now: datetime) -> None:
    if now > last:
        raise ServerError(
            Sentence("the certificate `{path}` ended on {day}", path, f"{last:%Y-%m-%d}"),
            Sentence("get a new one: browsers do not open the class with this one"),
        )
    if now < first:
        raise ServerError(
            Sentence("the certificate `{path}` counts from {day} on", path, f"{first:%Y-%m-%d}"),
            Sentence("look whether the clock of this machine is right"),
        )


def _no_use(path: Path) -> ServerError:
    return ServerError(
        Sentence("the certificate `{path}` and its key cannot be used", path),
        Sentence("get them anew: both are files in PEM, as they were made"),
    )
