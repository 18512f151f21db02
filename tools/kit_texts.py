"""What kits say of themselves on a page in another language than English (`tools.kit_pages` writes it)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from kitrobot.primitives.kit import Kit
from kitrobot.translation.translator import DIRECTIONS


@dataclass(frozen=True)
class PageWords:
    """What a page in another language than English says besides the texts of the kits."""

    title: str
    first: str
    needed: str
    wired: str
    parts: str
    missing: str


WORDS = {
    "fr": PageWords(
        "# Les kits",
        "De quoi un robot peut être fait. Quel programme marche sur quel kit, les broches et les réglages sont sur"
        " [la page en anglais](kits.md).",
        "Il vous faut :",
        "Comment les pièces sont câblées",
        "| pièce | ce que le kit en dit |",
        "il n’y en a pas",
    ),
    "ur": PageWords(
        "# کٹیں",
        "روبوٹ کس کس چیز سے بن سکتا ہے۔ کون سا پروگرام کس کٹ پر چلتا ہے، پنیں اور ترتیبات [انگریزی صفحے](kits.md)"
        " پر ہیں۔",
        "یہ چاہیے:",
        "پرزے کیسے جڑے ہیں",
        "| پرزہ | کٹ اس کے بارے میں کیا کہتی ہے |",
        "نہیں ہے",
    ),
}


def page_in(language: str, kits: Sequence[Kit]) -> str:
    """The page of what the kits say in a language of `WORDS`."""
    return "\n".join(_lines(kits, language, WORDS[language]))


def _lines(kits: Sequence[Kit], language: str, words: PageWords) -> Iterator[str]:
    """The same, line by line; Urdu is written from right to left."""
    right_to_left = DIRECTIONS[language] == "rtl"
    yield from ['<div dir="rtl">', ""] if right_to_left else []
    yield from (words.title, "", words.first, "")
    for kit in kits:
        yield from (f"## {kit.label[language]}", "", f"`{kit.name}` – {kit.help[language]}", "")
        if kit.supplies:
            yield from (words.needed, "", *(f"- {text[language]}" for text in kit.supplies), "")
            yield from (f"![{words.wired}](pictures/wiring-{kit.name}.svg)", "")
            yield from (f"{number}. {text[language]}" for number, text in enumerate(kit.steps, 1))
            yield ""
        told = [part for part in kit.parts if part.help]
        if told:
            yield from (words.parts, "|---|---|")
        for part in told:
            which = " ".join(f"`{one}`" for one in (*part.devices, *part.names, *filter(None, [part.when])))
            sign = f"{words.missing}: " if part.is_missing else ""
            yield f"| {which} | {sign}{part.help[language]} |"
        yield from [""] if told else []
    yield from ["</div>", ""] if right_to_left else []
