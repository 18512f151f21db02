"""The names on the labels of boards, stored in the user's state folder.

A label is stored with the serial number of the board's USB, so the board keeps it at any port; for an address that is
no serial port (`socket://…`) it is stored with the address. A label belongs to one board: given to another, it is taken
from the first.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

from kitrobot.boards.json_store import read_entries, write_entries
from kitrobot.deploy.firmware.ports import list_ports
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

LONGEST_LABEL = 40
_KEPT = 1000
_NAME = "labels"


class LabelError(KitRobotError):
    """A board cannot have that label."""


def label_key(label: str) -> str:
    """What is the same for labels that a person takes for one."""
    return unicodedata.normalize("NFKC", unicodedata.normalize("NFKC", label).casefold())


def clean_label(given: str) -> str:
    """A label as it is kept.

    Raises:
        LabelError: it is empty, too long, or no text of one line.
    """
    label = unicodedata.normalize("NFC", " ".join(given.split()))
    if not label or len(label) > LONGEST_LABEL or any(unicodedata.category(one).startswith("C") for one in label):
        raise LabelError(
            Sentence("`{label}` is no name for a label", given[:80]),
            Sentence("a label has 1 to {most} letters or digits", LONGEST_LABEL),
        )
    return label


def store_label(address: str, given: str) -> str:
    """Gives the board at an address a label; "" takes its own away. The label as it is kept.

    Raises:
        LabelError: it cannot be a label, or the board has nothing to be known by.
        FileError: it cannot be written.
    """
    label = clean_label(given) if given else ""
    board = _key(address, _numbers())
    if board is None:
        raise LabelError(
            Sentence("the board on `{port}` has no number of its own by which it could be known again", address),
            Sentence("write its port into the list instead, in the column `port`"),
        )
    found = {key: one for key, one in _stored_labels().items() if key != board and label_key(one) != label_key(label)}
    if label:
        found[board] = label
    write_entries(_NAME, found, _KEPT)
    return label


def labels_of(addresses: Iterable[str]) -> dict[str, str]:
    """The labels of the boards at these addresses, as far as they have some."""
    known = _stored_labels()
    if not known:
        return {}
    numbers = _numbers()
    keys = {address: _key(address, numbers) for address in addresses}
    return {address: known[key] for address, key in keys.items() if key in known}


def _key(address: str, numbers: dict[str, str]) -> str | None:
    """By what a board is known; None for one that has nothing."""
    if re.match(r"[A-Za-z][A-Za-z0-9+.-]*://", address):
        return address
    number = numbers.get(address, "")
    return f"usb {number}" if number else None


def _numbers() -> dict[str, str]:
    """The numbers of the boards that are plugged in, by address."""
    return {port.address: port.number for port in list_ports()}


def _stored_labels() -> dict[str, str]:
    found = read_entries(_NAME).items()
    return {key: one for key, one in found if isinstance(one, str) and 0 < len(one) <= LONGEST_LABEL}
