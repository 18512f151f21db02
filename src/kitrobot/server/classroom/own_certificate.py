"""The certificate that a class makes for itself: for an address and the other names of this machine, kept for the user.

`https/ADDRESS.pem` in the user's state folder holds the key, the certificate and its authority in one file, so that no
cut leaves a pair that does not match; `https/ADDRESS.crt` is the authority alone, for other machines: tablets install
nothing but authorities. The key of the authority is forgotten as soon as it has signed this one certificate, so a
machine that trusts it trusts this one class. What is kept is used again until a month before its end, so that browsers
warn once; a file that cannot be used any more, that lacks a name, or that others could have read, is replaced.
"""

from __future__ import annotations

import hashlib
import ipaddress
import os
import stat
import tempfile
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.server.classroom.certificate import certificates_in, usable_certificate, validity
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
    """A certificate with its key and its authority in `path`, the authority alone in `public`; `new` if it was made
    just now.
    """

    path: Path
    public: Path
    new: bool

    @property
    def fingerprint(self) -> str:
        """SHA-256 of the certificate, as browsers show it: 32 pairs of hexadecimal digits with colons."""
        return _fingerprint(self.path)

    @property
    def authority_fingerprint(self) -> str:
        """The same of the authority, as a machine shows it that is to trust it."""
        return _fingerprint(self.public)


def _fingerprint(path: Path) -> str:
    digest = hashlib.sha256(certificates_in(path.read_text("ascii"))[0]).digest()
    return ":".join(f"{byte:02X}" for byte in digest)


def own_certificate(address: str, others: Sequence[str] = (), now: datetime | None = None) -> OwnCertificate:
    """The certificate of this user for an address in the network; made where there is none that can be used.

    Args:
        address: the number that pupils open, of IPv4 or IPv6, without brackets.
        others: names and numbers that lead to this machine too.
        now: for tests.

    Raises:
        ServerError: it cannot be kept, or the package `cryptography` is missing.
    """
    now = now or datetime.now(UTC)
    folder = state_folder() / "https"
    # Windows takes no colon in a name.
    stem = str(ipaddress.ip_address(address)).replace(":", "-").replace("%", "-")
    kept = OwnCertificate(folder / f"{stem}.pem", folder / f"{stem}.crt", new=False)
    names = list(dict.fromkeys((address, *others)))
    if _can_be_used(kept, names, now):
        return kept
    pair, authority = _made(names, now)
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        _write(kept.public, authority, 0o644)
        _write(kept.path, pair + authority, 0o600)
    except OSError as error:
        raise ServerError(
            Sentence(
                "the certificate of the class could not be kept in {folder}: {reason}", folder, error.strerror or error
            ),
            Sentence("let yourself write there, or name another folder: `KITROBOT_STATE`"),
        ) from None
    return OwnCertificate(kept.path, kept.public, new=True)


def _can_be_used(kept: OwnCertificate, names: Sequence[str], now: datetime) -> bool:
    """Whether what is kept is ours alone, whole, has these names, and counts for some time yet."""
    try:
        state = os.lstat(kept.path)
        others = os.name != "nt" and (state.st_uid != os.geteuid() or state.st_mode & 0o077)
        if others or not stat.S_ISREG(state.st_mode):
            return False
        usable_certificate(kept.path, kept.path, now)
        der, *rest = certificates_in(kept.path.read_text("ascii"))
        whole = len(rest) == 1 and rest == certificates_in(kept.public.read_text("ascii"))
        named = all(_encoded(name) in der for name in names)
        return whole and named and validity(der)[1] - now > timedelta(days=RENEWED_DAYS)
    except (KitRobotError, OSError, ValueError, IndexError):
        return False


def _number(name: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        return ipaddress.ip_address(name)
    except ValueError:
        return None


def _encoded(name: str) -> bytes:
    """A name or number as it stands in a certificate's list of names."""
    number = _number(name)
    tag, data = (0x82, name.encode("ascii")) if number is None else (0x87, number.packed)
    return bytes([tag, len(data)]) + data


def _made(names: Sequence[str], now: datetime) -> tuple[bytes, bytes]:
    """A new key with its certificate, and the authority that signed it, in PEM.

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
    master, key = ec.generate_private_key(ec.SECP256R1()), ec.generate_private_key(ec.SECP256R1())

    def signed(
        title: str, of: ec.EllipticCurvePrivateKey, is_authority: bool, *extensions: x509.ExtensionType
    ) -> bytes:
        # A server signs what it says, an authority certificates.
        use = x509.KeyUsage(not is_authority, False, False, False, False, is_authority, False, False, False)
        issuer, subject = (x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, one)]) for one in (root, title))
        made = (
            x509.CertificateBuilder(issuer, subject, of.public_key(), x509.random_serial_number())
            .not_valid_before(now - _EARLIER)
            .not_valid_after(now - _EARLIER + timedelta(days=DAYS))
            .add_extension(x509.BasicConstraints(is_authority, 0 if is_authority else None), critical=True)
            .add_extension(use, critical=True)
            .add_extension(x509.SubjectKeyIdentifier.from_public_key(of.public_key()), critical=False)
            .add_extension(x509.AuthorityKeyIdentifier.from_issuer_public_key(master.public_key()), critical=False)
        )
        for one in extensions:
            made = made.add_extension(one, critical=False)
        return made.sign(master, hashes.SHA256()).public_bytes(serialization.Encoding.PEM)

    root = f"KitRobot class at {names[0]}"
    numbers = [(name, _number(name)) for name in names]
    listed = [x509.DNSName(name) if number is None else x509.IPAddress(number) for name, number in numbers]
    certificate = signed(
        names[0],
        key,
        False,
        x509.SubjectAlternativeName(listed),
        x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH]),
    )
    secret = key.private_bytes(
        serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
    return secret + certificate, signed(root, master, True)


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
