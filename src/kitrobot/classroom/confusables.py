"""Characters that a person takes for another one, or does not see at all, after the idea of Unicode's UTS #39.

Only letters of which names are made are listed, and of each only what looks the same in most fonts: Latin letters and
their doubles in Cyrillic, Greek, Armenian, Cherokee and Lisu; forms of one Arabic letter that Urdu, Persian and Arabic
keyboards type; dashes and apostrophes. What is only a form of another character (𝐀, Ａ) is Unicode's NFKC.
"""

from __future__ import annotations

import re
import unicodedata
from typing import Final

INVISIBLE: Final = re.compile(
    "[\u00ad\u034f\u061c\u115f\u1160\u17b4\u17b5\u180b-\u180f\u200b-\u200f\u202a-\u202e\u2060-\u206f\u2800\u3164"
    "\ufe00-\ufe0f\ufeff\uffa0\ufff0-\ufffb\U0001bca0-\U0001bca3\U0001d173-\U0001d17a\U000e0000-\U000e0fff]"
)
"""What draws nothing (Default_Ignorable_Code_Point of Unicode, and an empty Braille cell)."""

_DOUBLES: Final = (
    "AΑАᎪꓮᴀ BΒВᏴꓐʙ CСϹᏟꓚⅭ DᎠꓓᴅ EΕЕᎬꓰᴇ FϜꓝ GᏀꓖԌɢ HΗНᎻꓧʜн JЈᎫꓙ KΚКᏦꓗᴋкκĸ LᏞꓡʟԼ MΜМᎷꓟᴍм NΝꓠɴ OΟОՕꓳ0 PΡРᏢꓑᴘ"
    " QԚ RᎡꓣʀ SЅՏᏚꓢ TΤТᎢꓔᴛтτ UՍꓴ VѴᏙꓦ WԜᏔꓪ XΧХꓫ YΥҮꓬʏ ZΖᏃꓜ aαаɑ bьƄ cсϲᴄ dԁ eеҽ gɡցɢ hһհ iіıιɩ jјյϳ lIΙІӀӏ1|ǀꓲ"
    " nոηп oοоօᴏσ pρр qԛգ rгᴦ sѕꜱ uսυᴜ vνѵᴠ wԝաᴡ xхχ yуүγ zᴢ 3ЗзƷӠ '’‘ʼʻ′`´ʹ -‐‑‒–—−"
    " ییىي ککك ہهە ۰٠ ۱١ ۲٢ ۳٣ ۴٤ ۵٥ ۶٦ ۷٧ ۸٨ ۹٩"
)
"""Words of a character and all that look like it."""

_MEANT: Final = {ord(double): word[0] for word in _DOUBLES.split(" ") for double in word[1:]} | {ord("ـ"): None}
"""The last one, an Arabic line, only stretches the word."""


def visible_form(text: str) -> str:
    """What is the same for texts that look the same; for comparing, not for showing."""
    shown = INVISIBLE.sub("", unicodedata.normalize("NFKC", text))
    # Before case is folded: the capital Η is an H, the small η an n.
    return unicodedata.normalize("NFKC", shown.translate(_MEANT).casefold())
