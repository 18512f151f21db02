"""What kits say of themselves on a page in another language than English (`tools.kit_pages` writes it)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kitrobot.primitives.kit import Kit
from kitrobot.primitives.robot import Texts
from kitrobot.text.sentences import Label, Sentence
from kitrobot.translation.languages import LANGUAGES
from kitrobot.translation.reader_language import override_language, translate


def page_in(language: str, kits: Sequence[Kit]) -> str:
    """The page of what the kits say in a language."""
    with override_language(language):
        return "\n".join(_lines(kits, language))


def _said(texts: Texts) -> str:
    return translate(Label("", texts))


def _lines(kits: Sequence[Kit], language: str) -> Iterator[str]:
    """The same, line by line."""
    right_to_left = LANGUAGES[language].direction == "rtl"
    yield from ['<div dir="rtl">', ""] if right_to_left else []
    first = Sentence(
        "What a robot can be made of. Which program runs on which kit, the pins and the settings are on [the page in "
        "English](kits.md)."
    )
    yield from (f"# {translate(Sentence('Kits'))}", "", translate(first), "")
    for kit in kits:
        yield from (f"## {_said(kit.label)}", "", f"`{kit.name}` – {_said(kit.help)}", "")
        if kit.supplies:
            yield from (translate(Sentence("You need:")), "", *(f"- {_said(text)}" for text in kit.supplies), "")
            wired = translate(Sentence("How the parts are wired"))
            yield from (f"![{wired}](pictures/wiring-{kit.name}.svg)", "")
            yield from (f"{number}. {_said(text)}" for number, text in enumerate(kit.steps, 1))
            yield ""
        told = [part for part in kit.parts if part.help]
        if told:
            yield from (translate(Sentence("| part | what the kit says of it |")), "|---|---|")
        for part in told:
            which = " ".join(f"`{one}`" for one in (*part.devices, *part.names, *filter(None, [part.when])))
            sign = f"{translate(Sentence('there is none'))}: " if part.is_missing else ""
            yield f"| {which} | {sign}{_said(part.help)} |"
        yield from [""] if told else []
    yield from ["</div>", ""] if right_to_left else []
