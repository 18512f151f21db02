"""The sentences of all rooms in the reader's language.

The rooms speak English and know no other language. At the door a sentence is matched with the English one that it was
made of, and said again in the other language (`matching`). The languages are tables beside this file, `fr.json` and
`ur.json`, read when they are first asked for; `tools/sentences.py` finds what lacks a translation.
"""

from kitrobot.translation.languages import best_language, reading_in, said, said_in
from kitrobot.translation.matching import DIRECTIONS, ENGLISH, LANGUAGES

__all__ = ["DIRECTIONS", "ENGLISH", "LANGUAGES", "best_language", "reading_in", "said", "said_in"]
