"""The mission attached to a PDF comes out as it went in, whoever wrote the file; a hostile file costs a sentence."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.files import pdf_attachment as room
from kitrobot.files.embedded_mission import CarriedError, carried_mission
from tests.effort import THOROUGH
from tests.files.pdf_files import Numbered, attached, packed, pdf, stream

KRT = '<kitrobot version="1">\n  <label>Größe &amp; ✓ endstream endobj 3 0 obj</label>\n</kitrobot>\n'.encode()


def opened(data: bytes) -> bytes:
    found, name = carried_mission(data, "folder/square.pdf")
    assert name == "square.krt"
    return found


def test_the_mission_comes_out_word_for_word() -> None:
    assert opened(pdf(attached(KRT))) == KRT


def test_a_file_that_another_program_packed_gives_it_too() -> None:
    file, specification = attached(KRT)
    assert opened(pdf([file, packed(7, [(5, b"<< /Other 1 >>"), specification, (8, b"[1 2 3]")])])) == KRT


def test_an_attachment_that_is_not_packed_gives_it_too() -> None:
    objects = [stream(1, KRT, b"/Type /EmbeddedFile", packed=False), *attached(b"", first=1)[1:]]
    assert opened(pdf(objects)) == KRT


@pytest.mark.parametrize("length", [0, 3, 10**9, -1])
def test_a_length_that_lies_changes_nothing(length: int) -> None:
    body = b"<kitrobot/>"
    objects = [stream(1, body, packed=False, length=length), attached(b"")[1]]
    assert opened(pdf(objects)).strip() == body


def test_the_name_may_be_in_any_form_that_pdf_has() -> None:
    file, _ = attached(KRT)
    names = [
        b"/UF <FEFF006D002E004B00520054>",
        b"/F (a\\(1\\).krt)",
        b"/UF (\xef\xbb\xbfm\xc3\xbc.krt)",
        b"/F (m.\\153rt)",
        b"/F (m(2).krt)",
    ]
    for name in names:
        assert opened(pdf([file, (2, b"<< %s /EF << /F 1 0 R >> >>" % name)])) == KRT


def test_ours_goes_before_other_missions_that_were_attached() -> None:
    other = attached(b"<other/>", b"a.krt", first=1)
    ours = attached(KRT, b"z.krt", first=3, more=b"/AFRelationship /Source")
    assert opened(pdf([*other, *ours])) == KRT


def test_what_was_written_later_counts() -> None:
    assert opened(pdf(attached(b"<old/>")) + pdf(attached(KRT))) == KRT


@pytest.mark.parametrize(
    "objects",
    [[], [(1, b"<< /Type /Catalog >>")], attached(KRT, b"notes.txt"), [(2, b"<< /F (a.krt) >>")]],
    ids=["nothing", "no attachment", "another attachment", "only a name"],
)
def test_a_pdf_without_a_mission_says_so(objects: list[Numbered]) -> None:
    with pytest.raises(CarriedError, match="without a mission"):
        opened(pdf(objects))


@pytest.mark.parametrize(
    "data",
    [
        pdf(attached(KRT), b"/Root 1 0 R /Encrypt 5 0 R"),
        pdf([*attached(KRT), stream(9, b"", b"/Type /XRef /Encrypt << /V 5 >>")]),
    ],
    ids=["old", "new"],
)
def test_a_pdf_with_a_password_says_so(data: bytes) -> None:
    with pytest.raises(CarriedError, match="locked with a password"):
        opened(data)


def test_a_bomb_is_not_unpacked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(room, "MAX_BYTES", 100_000)
    monkeypatch.setattr(room, "MOST_UNPACKED_BYTES", 100_000)
    assert opened(pdf(attached(bytes(100_000)))) == bytes(100_000)
    for objects in (attached(bytes(100_001)), [packed(1, [(2, b" " * 60_000)]), packed(3, [(4, b" " * 60_000)])]):
        with pytest.raises(CarriedError, match="holds more than"):
            opened(pdf(objects))


def test_too_many_objects_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(room, "MOST_OBJECTS", 10)
    many = [(number, b"null") for number in range(10, 17)]
    # With the trailer of `pdf` these are ten.
    assert opened(pdf([*attached(KRT), *many])) == KRT
    with pytest.raises(CarriedError, match="holds more than"):
        opened(pdf([*attached(KRT), *many, (99, b"null")]))


MANY = 1_000_000 if THOROUGH else 200_000
DEEP = [
    b"[" * MANY,
    b"<<" * (MANY // 2),
    b"(" * MANY,
    b"<< /A " * (MANY // 5),
    b"1 0 obj " * (MANY // 10),
    b"1 0 obj << " * (MANY // 10),
    b"1 0 obj (" * (MANY // 10),
    b"1 0 obj <" * (MANY // 10),
    b"%" * MANY,
    b"1 0 " * (MANY // 4),
    b"9" * MANY,
    b"1 0 obj <<>> stream\n" * (MANY // 20),
    b"(\\" * (MANY // 2),
    b"/A#" * (MANY // 3),
]


@pytest.mark.parametrize("body", DEEP, ids=lambda body: body[:20].decode().strip())
def test_what_never_ends_costs_little(body: bytes) -> None:
    for data in (b"%PDF-1.7\n" + body, b"%PDF-1.7\n1 0 obj\n" + body, b"%PDF-1.7\n1 0 obj\n" + body + b"\n%%EOF"):
        with pytest.raises(CarriedError):
            opened(data)


WHOLE = pdf([*attached(KRT), packed(7, [(5, b"<< /Other (1) >>")])])


def outcome(data: bytes) -> bytes | str:
    """The mission, or the word that the sentence turns on; anything but a sentence is raised."""
    try:
        return opened(data)
    except CarriedError as error:
        words = ("damaged", "locked", "more than", "without a mission")
        return next(word for word in words if word in error.message)


@given(st.integers(5, len(WHOLE) - 1))
def test_a_file_that_was_cut_gives_the_whole_mission_or_none(length: int) -> None:
    assert outcome(WHOLE[:length]) in (KRT, "damaged")


@given(st.integers(5, len(WHOLE) - 1), st.binary(min_size=1, max_size=8))
def test_damage_anywhere_gives_the_mission_or_a_sentence(at: int, junk: bytes) -> None:
    assert outcome(WHOLE[:at] + junk + WHOLE[at + len(junk) :])


@given(st.binary(max_size=300))
def test_any_bytes_behind_the_head_of_a_pdf_give_a_sentence(body: bytes) -> None:
    with pytest.raises(CarriedError):
        opened(b"%PDF-1.7\n" + body)
