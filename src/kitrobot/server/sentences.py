"""Messages as the page shows them."""


def spoken(words: str) -> str:
    """A message as a sentence of its own: a capital letter and a full stop."""
    if not words:
        return ""
    return words[0].upper() + words[1:] + ("" if words.endswith((".", "?", "!")) else ".")
