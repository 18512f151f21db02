"""Certificates for tests, on the curve P-256, in plain Python: self-signed, or by an authority. Not for secrets."""

from __future__ import annotations

import base64
import hashlib
import ipaddress
import secrets
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path

_P = 2**256 - 2**224 + 2**192 + 2**96 - 1
_N = 0xFFFFFFFF00000000FFFFFFFFFFFFFFFFBCE6FAADA7179E84F3B9CAC2FC632551
_G = (
    0x6B17D1F2E12C4247F8BCE6E563A440F277037D812DEB33A0F4A13945D898C296,
    0x4FE342E2FE1A7F9B8EE7EB4A7C0F9E162BCE33576B315ECECBB6406837BF51F5,
)
_Point = tuple[int, int] | None


def _add(one: _Point, other: _Point) -> _Point:
    if one is None or other is None:
        return one or other
    (x1, y1), (x2, y2) = one, other
    if x1 == x2 and (y1 + y2) % _P == 0:
        return None
    slope = (3 * x1 * x1 - 3) * pow(2 * y1, -1, _P) if one == other else (y2 - y1) * pow(x2 - x1, -1, _P)
    x = (slope * slope - x1 - x2) % _P
    return x, (slope * (x1 - x) - y1) % _P


def _times(factor: int, point: _Point) -> tuple[int, int]:
    found: _Point = None
    while factor:
        if factor & 1:
            found = _add(found, point)
        point, factor = _add(point, point), factor >> 1
    assert found is not None
    return found


def _der(tag: int, *parts: bytes) -> bytes:
    data = b"".join(parts)
    if len(data) < 0x80:
        return bytes([tag, len(data)]) + data
    length = len(data).to_bytes((len(data).bit_length() + 7) // 8, "big")
    return bytes([tag, 0x80 | len(length)]) + length + data


def _integer(value: int) -> bytes:
    return _der(0x02, value.to_bytes(value.bit_length() // 8 + 1, "big"))


def _bits(data: bytes) -> bytes:
    return _der(0x03, b"\0", data)


_CURVE = bytes.fromhex("06082a8648ce3d030107")
_EC_KEY = bytes.fromhex("06072a8648ce3d0201")
_SIGNED_SO = _der(0x30, bytes.fromhex("06082a8648ce3d040302"))


def _pem(kind: str, der: bytes) -> str:
    text = base64.encodebytes(der).decode()
    return f"-----BEGIN {kind}-----\n{text}-----END {kind}-----\n"


@dataclass(frozen=True)
class Certificate:
    """A certificate and its key, as files."""

    certificate: Path
    key: Path


def _named(text: str) -> bytes:
    return _der(0x30, _der(0x31, _der(0x30, bytes.fromhex("0603550403"), _der(0x0C, text.encode()))))


def _extension(number: str, value: bytes, critical: bool = False) -> bytes:
    return _der(0x30, bytes.fromhex(number), _der(0x01, b"\xff") if critical else b"", _der(0x04, value))


_AUTHORITY = _extension("0603551d13", _der(0x30, _der(0x01, b"\xff")), critical=True)
_LOOPBACK = _extension("0603551d11", _der(0x30, _der(0x87, ipaddress.ip_address("127.0.0.1").packed)))


@dataclass(frozen=True)
class _Signer:
    """Who signs: a name and a secret number."""

    name: bytes
    secret: int


def _new_signer(name: str) -> _Signer:
    return _Signer(_named(name), secrets.randbelow(_N - 1) + 1)


def _made(subject: _Signer, signer: _Signer, extension: bytes, days: int, since: int) -> tuple[str, str]:
    """A certificate and its key, as PEM; it counts from `since` days on, for so many."""
    public = b"\x04" + b"".join(one.to_bytes(32, "big") for one in _times(subject.secret, _G))
    first = datetime.now(UTC) + timedelta(days=since)
    moments = [_der(0x18, f"{one:%Y%m%d%H%M%SZ}".encode()) for one in (first, first + timedelta(days=days))]
    inner = _der(
        0x30,
        _der(0xA0, _integer(2)),
        _integer(secrets.randbits(64)),
        _SIGNED_SO,
        signer.name,
        _der(0x30, *moments),
        subject.name,
        _der(0x30, _der(0x30, _EC_KEY, _CURVE), _bits(public)),
        _der(0xA3, _der(0x30, extension)),
    )
    digest = int.from_bytes(hashlib.sha256(inner).digest(), "big")
    once = secrets.randbelow(_N - 1) + 1
    r = _times(once, _G)[0] % _N
    s = pow(once, -1, _N) * (digest + r * signer.secret) % _N
    whole = _der(0x30, inner, _SIGNED_SO, _bits(_der(0x30, _integer(r), _integer(s))))
    private = _der(
        0x30,
        _integer(1),
        _der(0x04, subject.secret.to_bytes(32, "big")),
        _der(0xA0, _CURVE),
        _der(0xA1, _bits(public)),
    )
    return _pem("CERTIFICATE", whole), _pem("EC PRIVATE KEY", private)


def self_signed(folder: Path, days: int = 30, since: int = -1, stem: str = "class") -> Certificate:
    """A certificate of 127.0.0.1 that counts from `since` days on, for so many."""
    own = _new_signer("a class")
    made = Certificate(folder / f"{stem}.pem", folder / f"{stem}.key")
    for path, text in zip((made.certificate, made.key), _made(own, own, _LOOPBACK, days, since), strict=True):
        path.write_text(text)
    return made


def by_authority(folder: Path) -> Path:
    """The folder, with `ca.pem`, and `cert.pem` and `key.pem` of 127.0.0.1 that this authority has signed."""
    authority = _new_signer("an authority")
    (folder / "ca.pem").write_text(_made(authority, authority, _AUTHORITY, 30, -1)[0])
    certificate, key = _made(_new_signer("a team"), authority, _LOOPBACK, 30, -1)
    (folder / "cert.pem").write_text(certificate)
    (folder / "key.pem").write_text(key)
    return folder
