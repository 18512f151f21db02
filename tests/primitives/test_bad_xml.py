"""Files that are damaged, hostile or of another kind: one clear error with its place, quickly, for every reader."""

import codecs

import pytest

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.xml.decoder import MAX_BYTES
from kitrobot.xml.reader import MAX_DEPTH
from tests.primitives.samples import KINDS, Read

each_kind = pytest.mark.parametrize(("root", "text", "read"), KINDS, ids=[kind[0] for kind in KINDS])


def one_error(read: Read, data: bytes) -> Diagnostic:
    found, problems = read(data, "f.xml")
    assert not found
    [problem] = problems
    assert problem.is_error
    assert problem.place is not None
    assert problem.place.file == "f.xml"
    return problem


def at(problem: Diagnostic) -> tuple[int, int]:
    assert problem.place is not None
    return problem.place.line, problem.place.column


@each_kind
def test_the_sample_itself_is_right(root: str, text: str, read: Read) -> None:
    found, problems = read(text.encode(), "f.xml")
    assert found
    assert problems == []


@each_kind
def test_a_file_cut_off_at_any_byte_is_one_error_inside_the_file(root: str, text: str, read: Read) -> None:
    data = text.encode()
    end = data.rindex(b">")
    for length in range(end):
        problem = one_error(read, data[:length])
        assert problem.code in ("xml-not-well-formed", "xml-encoding")
        assert at(problem)[0] <= data[:length].count(b"\n") + 1


@each_kind
def test_a_cut_off_file_names_what_is_still_open(root: str, text: str, read: Read) -> None:
    problem = one_error(read, text.encode()[: text.encode().rindex(b"</")])
    assert problem.message == f"expected </{root}> for the <{root}> of line 1, found the end of the file"


@each_kind
def test_any_single_byte_may_be_damaged_without_a_traceback(root: str, text: str, read: Read) -> None:
    data = text.encode()
    for position in range(len(data)):
        for damage in (0x00, 0x3C, 0x26, 0xFF):
            read(data[:position] + bytes([damage]) + data[position + 1 :], "f.xml")


@each_kind
def test_a_document_type_is_refused_at_its_place(root: str, text: str, read: Read) -> None:
    problem = one_error(read, f"<!-- x -->\n<!DOCTYPE {root}>{text}".encode())
    assert (problem.code, at(problem)) == ("xml-forbidden", (2, 1))


@each_kind
def test_an_entity_bomb_is_refused_at_once(root: str, text: str, read: Read) -> None:
    entities = '<!ENTITY a0 "ha">' + "".join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 30))
    problem = one_error(read, f"<!DOCTYPE x [{entities}]><{root}>&a29;</{root}>".encode())
    assert problem.code == "xml-forbidden"


@each_kind
def test_a_file_outside_is_never_pulled_in(root: str, text: str, read: Read) -> None:
    data = f'<!DOCTYPE x [<!ENTITY e SYSTEM "other.xml">]><{root}>&e;</{root}>'
    assert one_error(read, data.encode()).code == "xml-forbidden"


@each_kind
def test_ten_thousand_levels_are_one_error(root: str, text: str, read: Read) -> None:
    problem = one_error(read, f"<{root}>{'<a>' * 10_000}{'</a>' * 10_000}</{root}>".encode())
    assert problem.code == "xml-too-deep"


@each_kind
def test_depth_is_allowed_up_to_the_limit(root: str, text: str, read: Read) -> None:
    inside = MAX_DEPTH - 1
    _, problems = read(f"<{root}>{'<a>' * inside}{'</a>' * inside}</{root}>".encode(), "f.xml")
    assert "xml-too-deep" not in [problem.code for problem in problems]
    problem = one_error(read, f"<{root}>{'<a>' * (inside + 1)}{'</a>' * (inside + 1)}</{root}>".encode())
    assert problem.code == "xml-too-deep"


@each_kind
def test_a_file_over_the_size_limit_is_not_read(root: str, text: str, read: Read) -> None:
    assert one_error(read, b" " * (MAX_BYTES + 1)).code == "xml-too-large"


@each_kind
def test_a_byte_that_is_not_utf_8_is_shown_at_its_column(root: str, text: str, read: Read) -> None:
    problem = one_error(read, f"<!-- é -->\r\n<{root}>é".encode() + b"\xe9" + f"</{root}>".encode())
    assert (problem.code, at(problem)) == ("xml-encoding", (2, len(root) + 4))


@each_kind
def test_a_file_that_says_it_is_latin_1_is_refused(root: str, text: str, read: Read) -> None:
    problem = one_error(read, f'<?xml version="1.0" encoding="ISO-8859-1"?><{root}/>'.encode("latin-1"))
    assert problem.message == "expected UTF-8, found a file that says “ISO-8859-1”"


@each_kind
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_utf_8_and_utf_16_with_a_mark_are_read(root: str, text: str, read: Read, encoding: str) -> None:
    assert read(text.encode(encoding), "f.xml") == read(text.encode(), "f.xml")


@each_kind
def test_utf_16_without_its_mark_or_cut_in_half_is_one_error(root: str, text: str, read: Read) -> None:
    one_error(read, text.encode("utf-16-le"))
    one_error(read, codecs.BOM_UTF16_LE + text.encode("utf-16-le")[:-1])


@each_kind
def test_line_breaks_of_any_system_are_the_same(root: str, text: str, read: Read) -> None:
    expected = read(text.encode(), "f.xml")
    assert read(text.replace("\n", "\r\n").encode(), "f.xml") == expected
    assert read(text.replace("\n", "\r").encode(), "f.xml") == expected


@each_kind
def test_a_nul_is_named(root: str, text: str, read: Read) -> None:
    problem = one_error(read, f"<{root}>\n \0</{root}>".encode())
    assert problem.message == "found the character U+0000, which XML cannot hold"
    assert at(problem) == (2, 2)


@each_kind
@pytest.mark.parametrize("data", [b"", b" \n", b"hello", b"\xef\xbb\xbf", b"<", b"<!---->", b"PK\x03\x04", b"{}"])
def test_what_is_no_xml_is_one_error(root: str, text: str, read: Read, data: bytes) -> None:
    one_error(read, data)


@each_kind
def test_another_kind_of_file_is_named(root: str, text: str, read: Read) -> None:
    problem = one_error(read, b'<svg width="3"/>')
    assert problem.message == f"expected <{root}> as the first element, found <svg>"


@pytest.mark.parametrize(("root", "text", "read"), KINDS[:2], ids=["constructors", "robot"])
def test_a_newer_file_is_not_touched(root: str, text: str, read: Read) -> None:
    problem = one_error(read, f'<{root} name="x" version="2"><surprise/></{root}>'.encode())
    assert problem.code == "xml-newer-version"


@each_kind
@pytest.mark.parametrize(
    ("inside", "message", "column"),
    [
        ("<a></b>", "expected </a> for the <a> of line 2, found </b>", 4),
        ("&copy;", "expected one of &lt; &gt; &amp; &quot; &apos; or &#number;, found &copy;", 1),
        ("a & b", "expected XML, found ` ` where it cannot stand", 4),
        ('<a b="<"/>', "expected XML, found `<` where it cannot stand", 7),
        ("<a b=1/>", "expected XML, found `1` where it cannot stand", 6),
        ('<a b="1" b="2"/>', "an attribute is given twice in this tag", 10),
    ],
)
def test_malformed_xml_says_what_was_expected(
    root: str, text: str, read: Read, inside: str, message: str, column: int
) -> None:
    problem = one_error(read, f"<{root}>\n{inside}</{root}>".encode())
    assert (problem.message, at(problem)) == (message, (2, column))
    assert problem.help


@each_kind
def test_more_after_the_first_element_is_an_error(root: str, text: str, read: Read) -> None:
    assert "expected the end of the file" in one_error(read, f"{text}<more/>".encode()).message


@each_kind
def test_unknown_elements_and_attributes_are_left_out_and_reported(root: str, text: str, read: Read) -> None:
    expected, _ = read(text.encode(), "f.xml")
    start, _, rest = text.partition(">\n")
    changed = f'{start} colour-of-hat="red">\n<hat size="3">of <b>felt</b></hat>\n{rest}'
    found, problems = read(changed.encode(), "f.xml")
    assert found == expected
    assert [(problem.code, at(problem)) for problem in problems] == [
        ("xml-unknown-attribute", (1, len(start) + len(' colour-of-hat="') + 1)),
        ("xml-unknown-element", (2, 1)),
    ]


@each_kind
def test_stray_text_is_left_out_and_reported_at_its_place(root: str, text: str, read: Read) -> None:
    expected, _ = read(text.encode(), "f.xml")
    start, _, rest = text.partition(">\n")
    found, problems = read(f"{start}>\n  hello\n{rest}".encode(), "f.xml")
    assert found == expected
    assert [(problem.code, at(problem)) for problem in problems] == [("xml-stray-text", (2, 3))]


@each_kind
def test_what_belongs_to_xml_editors_is_no_problem(root: str, text: str, read: Read) -> None:
    start, _, rest = text.partition(">\n")
    about = ' xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="x.xsd"'
    found, problems = read(f"<?xml-stylesheet href='x'?>{start}{about}>\n<!-- {rest[:9]} -->{rest}".encode(), "f.xml")
    assert found
    assert problems == []


@each_kind
def test_a_huge_attribute_is_read_in_time(root: str, text: str, read: Read) -> None:
    _, problems = read(f'<{root} version="1" name="{"x" * 8_000_000}"/>'.encode(), "f.xml")
    assert all(len(problem.message) < 300 for problem in problems)


@each_kind
@pytest.mark.parametrize(
    "inside",
    [
        "<nothing/>" * 3_000,
        '<sensor name="A"><operation odd="1"/></sensor>\n' * 1_000,
        '<program name="p" robot="r">' + '<vertex id="v" element="e"/>' * 1_000 + "</program>",
        '<group name="G" colour="loop">'
        + '<constructor name="X"><code>{ { {</code></constructor>\n' * 500
        + "</group>",
        "x &amp; y\n" * 10_000,
    ],
)
def test_many_mistakes_cost_little_and_are_counted(root: str, text: str, read: Read, inside: str) -> None:
    _, problems = read(f'<{root} version="1" name="n">{inside}</{root}>'.encode(), "f.xml")
    assert len(problems) <= 101
    if len(problems) == 101:
        assert problems[-1].message.endswith("more problems are not shown")
