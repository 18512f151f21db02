"""A mission inside a picture comes out as it went in; a cut, foreign or hostile picture is refused in a sentence."""

from __future__ import annotations

import zlib
from xml.sax.saxutils import escape

import pytest

from kitrobot.files import embedded_mission
from kitrobot.files.embedded_mission import CarriedError, carried_mission

KRT = '<kitrobot version="1">\n  <label>Größe &amp; ✓ &#10;</label>\n</kitrobot>\n'.encode()


def chunk(kind: bytes, body: bytes) -> bytes:
    return len(body).to_bytes(4) + kind + body + zlib.crc32(kind + body).to_bytes(4)


def png(*middle: bytes) -> bytes:
    head = chunk(b"IHDR", bytes(13))
    return b"\x89PNG\r\n\x1a\n" + head + b"".join(middle) + chunk(b"IDAT", b"x") + chunk(b"IEND", b"")


def svg(text: str, before: str = "") -> bytes:
    metadata = f'<metadata id="kitrobot-mission">{escape(text)}</metadata>'
    return f'{before}<svg xmlns="http://www.w3.org/2000/svg"><g><text>no</text></g>{metadata}</svg>'.encode()


def pdf(body: bytes, length: int | None = None) -> bytes:
    """A PDF as the studio wrote it, as far as the mission is concerned."""
    packed = zlib.compress(body)
    head = (
        b"<< /Type /EmbeddedFile /Subtype /application#2Fxml /Params << /Size %d >> /Filter /FlateDecode /Length %d >>"
    )
    claimed = len(packed) if length is None else length
    stream = head % (len(body), claimed) + b"\nstream\n" + packed + b"\nendstream\nendobj\n"
    return b"%%PDF-1.7\n%%\xe2\xe3\xcf\xd3\n1 0 obj\n%sstartxref\n0\n%%%%EOF\n" % stream


OURS = png(chunk(b"tEXt", b"Comment\0x"), chunk(b"iTXt", b"kitrobot-mission\0\0\0\0\0" + KRT))


def test_a_png_gives_its_mission_word_for_word_under_a_missions_name() -> None:
    assert carried_mission(OURS, "folder/square.png") == (KRT, "square.krt")


@pytest.mark.parametrize("before", ["", "\ufeff", '<?xml version="1.0"?>\n', "<!-- made -->\n"])
def test_an_svg_gives_its_mission_word_for_word(before: str) -> None:
    data, name = carried_mission(svg(KRT.decode(), before), "square.svg")
    assert data == KRT.strip()
    assert name == "square.krt"


@pytest.mark.parametrize("data", [b"", KRT, b"rubbish", b"<other><svg></svg></other>", b"\x89PN", bytes(100)])
def test_what_is_no_picture_comes_back_as_it_is(data: bytes) -> None:
    assert carried_mission(data, "a.krt") == (data, "a.krt")


@pytest.mark.parametrize("data", [png(), svg("")], ids=["png", "svg"])
def test_a_picture_of_somebody_else_is_refused(data: bytes) -> None:
    with pytest.raises(CarriedError, match="without a mission"):
        carried_mission(data, "cat.png")


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"\xff\xd8\xff\xe0\0\x10JFIF\0", "a photo (JPEG)"),
        (b"GIF89a\1\0\1\0", "a picture (GIF)"),
        (b"RIFF\x24\0\0\0WEBPVP8 ", "a picture (WebP)"),
        (b"RIFF\x24\0\0\0WAVEfmt ", "a sound (WAV)"),
        (b"BM\x36\0\0\0\0\0\0\0\x36\0", "a picture (BMP)"),
        (b"PK\3\4\x14\0", "a packed file (ZIP)"),
        (b"\0\0\0\x20ftypisom\0\0\2\0", "a film (MP4)"),
        (b"\0\0\0\x18ftypheic\0\0\0\0", "a photo (HEIC)"),
        (b"\x1f\x8b\x08\0", "a packed file (gzip)"),
    ],
)
@pytest.mark.parametrize("name", ["holiday.jpg", "holiday.krt", "holiday.png", "holiday"])
def test_a_file_of_another_kind_is_told_what_it_is_whatever_its_name(data: bytes, words: str, name: str) -> None:
    with pytest.raises(CarriedError) as caught:
        carried_mission(data, name)
    assert caught.value.message == f"`{name}` is {words}: there is no mission inside"
    assert "KitRobot exported" in caught.value.help


@pytest.mark.parametrize("data", [b"RIFF", b"BM", b"BM xyz mission", b"xxxxWEBP", b"<kitrobot", b"\xff\xfe<\0k\0"])
def test_what_only_looks_a_little_like_it_is_left_to_the_reader(data: bytes) -> None:
    assert carried_mission(data, "a.krt") == (data, "a.krt")


@pytest.mark.parametrize("length", range(8, len(OURS) - len(KRT) - 100))
def test_a_png_that_was_cut_before_its_mission_ended_is_refused(length: int) -> None:
    with pytest.raises(CarriedError, match="damaged"):
        carried_mission(OURS[:length], "square.png")


def test_a_png_with_a_flipped_bit_in_its_mission_is_refused() -> None:
    at = OURS.index(b"version")
    with pytest.raises(CarriedError, match="damaged"):
        carried_mission(OURS[:at] + b"W" + OURS[at + 1 :], "square.png")


def test_a_png_that_claims_a_chunk_of_four_gigabytes_is_refused() -> None:
    with pytest.raises(CarriedError, match="damaged"):
        carried_mission(OURS[:8] + b"\xff\xff\xff\xffiTXt", "square.png")


@pytest.mark.parametrize(
    "data",
    [
        svg(KRT.decode())[:-10],
        svg("x", '<!DOCTYPE svg [<!ENTITY a "b">]>'),
        b'<svg xmlns="http://www.w3.org/2000/svg"><metadata id="kitrobot-mission">\xff</metadata></svg>',
        b"<svg " + b"a" * 5000,
    ],
    ids=["cut", "entities", "not UTF-8", "no end"],
)
def test_a_damaged_or_hostile_svg_is_refused(data: bytes) -> None:
    with pytest.raises(CarriedError, match="damaged"):
        carried_mission(data, "square.svg")


def test_ten_thousand_comments_before_nothing_cost_nothing() -> None:
    data = b"<!---->" * 10_000
    assert carried_mission(data, "a.krt") == (data, "a.krt")


@pytest.mark.parametrize("data", [b"", KRT, b"<!---->" * 10_000, b"GIF", b"%PDX-1.7"])
@pytest.mark.parametrize("name", ["a.svg", "folder/a.PNG", "a.pdf"])
def test_what_only_calls_itself_a_picture_is_refused(data: bytes, name: str) -> None:
    with pytest.raises(CarriedError, match=r"not the picture|is empty"):
        carried_mission(data, name)


def test_an_svg_nested_a_hundred_thousand_deep_costs_nothing() -> None:
    deep = b"<svg>" + b"<g>" * 100_000 + b"</g>" * 100_000 + b"</svg>"
    with pytest.raises(CarriedError):
        carried_mission(deep, "deep.svg")


def test_a_pdf_that_a_studio_exported_once_gives_its_mission_word_for_word() -> None:
    assert carried_mission(pdf(KRT), "folder/square.pdf") == (KRT, "square.krt")


@pytest.mark.parametrize("body", [b"", b"<< /Type /Catalog >>", b"<< /Type /EmbeddedFile >>\nstream\n" + KRT])
def test_a_printed_pdf_says_what_it_is_and_which_files_have_the_mission(body: bytes) -> None:
    with pytest.raises(CarriedError) as caught:
        carried_mission(b"%PDF-1.4\n" + body, "square.pdf")
    assert caught.value.message == "`square.pdf` is a document (PDF): there is no mission inside"
    assert "an SVG or PNG that KitRobot exported" in caught.value.help


BEGIN = pdf(KRT).index(b"stream\n") + len(b"stream\n")


@pytest.mark.parametrize("length", range(BEGIN, BEGIN + len(zlib.compress(KRT))))
def test_a_pdf_that_was_cut_before_its_mission_ended_is_refused(length: int) -> None:
    with pytest.raises(CarriedError, match="damaged"):
        carried_mission(pdf(KRT)[:length], "square.pdf")


@pytest.mark.parametrize("claimed", [0, 5, len(zlib.compress(KRT)) - 1])
def test_a_pdf_whose_mission_is_said_to_be_shorter_is_refused(claimed: int) -> None:
    with pytest.raises(CarriedError, match="damaged"):
        carried_mission(pdf(KRT, claimed), "square.pdf")


def test_a_pdf_whose_mission_is_a_bomb_is_not_unpacked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(embedded_mission, "MAX_BYTES", 100_000)
    assert carried_mission(pdf(bytes(100_000)), "a.pdf")[0] == bytes(100_000)
    with pytest.raises(CarriedError, match="damaged"):
        carried_mission(pdf(bytes(100_001)), "a.pdf")
