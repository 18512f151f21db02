"""The sentences of all rooms in the reader's language.

The rooms speak English and know no other language; their sentences keep the template and the values that they were made
of (`kitrobot.text.Sentence`). At the door they are said again in the reader's language (`rendering`). The languages are
gettext catalogues beside this file, `fr.po` and `ur.po`, read when they are first asked for (`catalogue`);
`tools/sentences.py` finds what lacks a translation.
"""

from kitrobot.translation.languages import best_language, override_language, reader_language, translate
from kitrobot.translation.translator import DIRECTIONS, ENGLISH, LANGUAGES, STOPS

__all__ = [
    "DIRECTIONS",
    "ENGLISH",
    "LANGUAGES",
    "STOPS",
    "best_language",
    "override_language",
    "reader_language",
    "translate",
]
