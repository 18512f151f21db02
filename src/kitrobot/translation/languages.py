"""The languages that people read KitRobot in: the one list of them, which the page has too (`tools/api_types.py`).

A language is a line here, and its catalogues `CODE.po` of the program (beside this module) and of the page. What a
catalogue lacks is said in English.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, Literal


@dataclass(frozen=True)
class Language:
    """A language by its name in English, by that which its readers give it, and by how it is written.

    `stop` ends a sentence, `decimal` stands before the tenths of a number.
    """

    english: str
    name: str
    direction: Literal["ltr", "rtl"] = "ltr"
    stop: str = "."
    decimal: str = "."


ENGLISH: Final = "en"

LANGUAGES: Final[Mapping[str, Language]] = MappingProxyType(
    {
        ENGLISH: Language("English", "English"),
        "es": Language("Spanish", "Español", decimal=","),
        "fr": Language("French", "Français", decimal=","),
        "pt": Language("Portuguese", "Português", decimal=","),
        "ur": Language("Urdu", "اردو", "rtl", stop="۔"),
    }
)
"""By code (ISO 639-1), English first and the others in the order of their codes."""

TRANSLATED: Final = tuple(code for code in LANGUAGES if code != ENGLISH)
"""The codes of those that English is translated to."""

TEXT_LANGUAGES: Final = ("", *TRANSLATED)
"""The same as the texts of XML are kept by: "" is English."""
