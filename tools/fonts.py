"""Make the page's Latin letters: the packages' fonts without what the page never shows.

    python tools/fonts.py

Weights from 400 to 700 only, no hinting, and of the features kerning, letters of a language, and figures of one width.
All letters stay; a browser puts letter and accent together by itself where the font has both in one. It needs
`fonttools` and `brotli`, which nothing else here does: install them for the occasion, after the packages' fonts have
changed, and commit what it makes (web/src/theme/fonts).
"""

from __future__ import annotations

import io
import sys
from pathlib import Path

WEB = Path(__file__).resolve().parent.parent / "web"
MADE = WEB / "src" / "theme" / "fonts"
WEIGHTS = (400, 700)
FEATURES = {
    "inter": ["kern", "locl", "tnum"],
    "jetbrains-mono": ["locl"],
}


def make(family: str) -> Path:
    """The small font of a family; gives its file."""
    from fontTools import subset  # type: ignore[import-not-found, import-untyped, unused-ignore]
    from fontTools.ttLib import TTFont  # type: ignore[import-not-found, import-untyped, unused-ignore]
    from fontTools.varLib.instancer import (  # type: ignore[import-not-found, import-untyped, unused-ignore]
        instantiateVariableFont,
    )

    name = f"{family}-latin-wght-normal.woff2"
    font = TTFont(WEB / "node_modules" / "@fontsource-variable" / family / "files" / name)
    options = subset.Options()
    options.layout_features = FEATURES[family]
    options.hinting = False
    options.glyph_names = False
    options.notdef_outline = True
    # Copyright and licence stay inside.
    options.name_IDs = ["*"]
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=set(font.getBestCmap()))
    subsetter.subset(font)
    plain = io.BytesIO()
    font.flavor = None
    font.save(plain)
    plain.seek(0)
    font = instantiateVariableFont(TTFont(plain), {"wght": WEIGHTS})
    font.flavor = "woff2"
    MADE.mkdir(exist_ok=True)
    font.save(MADE / name)
    return MADE / name


if __name__ == "__main__":
    try:
        for family in FEATURES:
            made = make(family)
            print(f"{made.name}: {made.stat().st_size / 1000:.1f} kB")
    except ImportError as missing:
        sys.exit(f"{missing.name} is missing: pip install fonttools brotli")
