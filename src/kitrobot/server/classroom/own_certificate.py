"""The certificate that a class makes for itself: for one address, signed by itself, kept for the user.

`https/ADDRESS.pem` in the user's state folder holds the key and the certificate in one file, so that no cut leaves a
pair that does not match; `https/ADDRESS.crt` is the certificate alone, for who installs it on other machines. What is
kept is used again until a month before its end, so that browsers warn once; a file that cannot be used any more, or
that others could have read, is replaced. It names its address and nothing else, and signs nothing: a machine that
trusts it trusts this one class.
"""

from __future__ import annotations

import hashlib
import ipaddress
import os
import ssl
import stat
import tempfile
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.server.classroom.certificate import usable_certificate, validity
from kitrobot.server.studio_server import ServerError
from kitrobot.text.sentences import Sentence
from kitrobot.user_folders import state_folder

DAYS: Final = 397
"""How long a certificate counts: browsers refuse some that count for longer."""
RENEWED_DAYS: Final = 30
"""So many days before its end a new one is made."""
_EARLIER: Final = timedelta(days=2)
"""It counts from then on: clocks of pupils' machines go wrong."""


@dataclass(frozen=True)
class OwnCertificate:
    """A certificate and its key in `path`, the certificate alone in `public`; `new` if it was made just now."""

    path: Path
    public: Path
    new: bool

    @property
    def fingerprint(self) -> str:
        """SHA-256 of the certificate, as browsers show it: 32 pairs of hexadecimal digits with colons."""
        digest = hashlib.sha256(ssl.PEM_cert_to_DER_cert(self.public.read_text("ascii"))).hexdigest().upper()
        return ":".join(digest[at : at + 2] for at in range(0, len(digest), 2))


def own_certificate(address: str, now: datetime | None = None) -> OwnCertificate:
    """The certificate of this user for an address in the network; made where there is none that can be used.

    Args:
        address: the number that pupils open, of IPv4 or IPv6, without brackets.
        now: for tests.

    Raises:
        ServerError: it cannot be kept, or the package `cryptography` is missing.
    """
    now = now or datetime.now(UTC)
    folder = state_folder() / "https"
    # Windows takes no colon in a name.
    stem = str(ipaddress.ip_address(address)).replace(":", "-").replace("%", "-")
    kept = OwnCertificate(folder / f"{stem}.pem", folder / f"{stem}.crt", new=False)
    if _can_be_used(kept, address, now):
        return kept
    key, certificate = _made(address, now)
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        _write(kept.public, certificate, 0o644)
        _write(kept.path, key + certificate, 0o600)
    except OSError as error:
        raise ServerError(
            Sentence(
                "the certificate of the class could not be kept in {folder}: {reason}", folder, error.strerror or error
            ),
            Sentence("let yourself write there, or name another folder: `KITROBOT_STATE`"),
        ) from None
    return OwnCertificate(kept.path, kept.public, new=True)


def _can_be_used(kept: OwnCertificate, address: str, now: datetime) -> bool:
    """Whether what is kept is ours alone, whole, of this address, and counts for some time yet."""
    try:
        state = os.lstat(kept.path)
        others = os.name != "nt" and (state.st_uid != os.geteuid() or state.st_mode & 0o077)
        if others or not stat.S_ISREG(state.st_mode):
            return False
        usable_certificate(kept.path, kept.path, now)
        certificate = kept.path.read_text("ascii")
        der = ssl.PEM_cert_to_DER_cert(certificate[certificate.index("-----BEGIN CERTIFICATE") :].strip())
        same = der == ssl.PEM_cert_to_DER_cert(kept.public.read_text("ascii"))
        return same and _names(der, address) and validity(der)[1] - now > timedelta(days=RENEWED_DAYS)
    except (KitRobotError, OSError, ValueError, IndexError):
        return False


def _names(der: bytes, address: str) -> bool:
    """Whether a certificate of ours is for that address: its list of names has one element."""
    packed = ipaddress.ip_address(address).packed
    return bytes([0x04, len(packed) + 4, 0x30, len(packed) + 2, 0x87, len(packed)]) + packed in der


def _made(address: str, now: datetime) -> tuple[bytes, bytes]:
    """A new key and its certificate, in PEM.

    Raises:
        ServerError: the package `cryptography` is missing.
    """
    try:
        from cryptography import x509
        from cryptography.hazmat.primitives import hashes, serialization
        from cryptography.hazmat.primitives.asymmetric import ec
        from cryptography.x509.oid import ExtendedKeyUsageOID
    except ImportError:
        raise ServerError(
            Sentence("a certificate of its own needs the package `{package}`", "cryptography"),
            Sentence(
                "install it: {command}; or give a certificate that you have: `--tls CERT KEY`",
                "`pip install kitrobot[https]`",
            ),
        ) from None
    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, f"KitRobot class at {address}")])
    use = x509.KeyUsage(True, False, False, False, False, False, False, False, False)
    identifier = x509.SubjectKeyIdentifier.from_public_key(key.public_key())
    certificate = (
        x509.CertificateBuilder(name, name, key.public_key(), x509.random_serial_number())
        .not_valid_before(now - _EARLIER)
        .not_valid_after(now - _EARLIER + timedelta(days=DAYS))
        .add_extension(x509.SubjectAlternativeName([x509.IPAddress(ipaddress.ip_address(address))]), critical=False)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(use, critical=True)
        .add_extension(x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH]), critical=False)
        .add_extension(identifier, critical=False)
        .sign(key, hashes.SHA256())
    )
    secret = key.private_bytes(
        serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
    return secret, certificate.public_bytes(serialization.Encoding.PEM)


def _write(path: Path, data: bytes, mode: int) -> None:
    """Writes a file whole or not at all, which until then nobody else could read."""
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=".new-")  # mode 0600
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        os.chmod(temporary, mode)
        os.replace(temporary, path)
    except BaseException:
        with suppress(OSError):
            os.unlink(temporary)
        raise
