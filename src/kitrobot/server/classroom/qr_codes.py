"""QR codes of addresses, for the teacher's page and for a terminal."""

from __future__ import annotations

import io


def qr_rows(text: str) -> tuple[str, ...]:
    """A QR code: rows of 0 and 1, without the quiet zone."""
    import segno

    return tuple("".join("1" if module else "0" for module in row) for row in segno.make(text, micro=False).matrix)


def qr_text(text: str) -> str:
    """The same for a terminal."""
    import segno

    out = io.StringIO()
    segno.make(text, micro=False).terminal(out, compact=True)
    return out.getvalue()
