"""Proofs of who knows a folder's secret, for pages and for a second `kitrobot` on the folder."""

from __future__ import annotations

import hashlib
import hmac


def compute_proof(secret: str, who: str, address: str, asked: str, answered: str) -> str:
    """The proof of knowing `secret`; `who` is "studio" or "page", `address` a name and a port."""
    words = "\n".join((who, address, asked, answered))
    return hmac.new(secret.encode(), words.encode(), hashlib.sha256).hexdigest()
