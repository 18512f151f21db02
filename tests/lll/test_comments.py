"""Which instruction a comment belongs to, and that none is lost."""

from __future__ import annotations

import pytest

from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Conditional, Instr, Parallel, Repeat, Seq


def items(text: str) -> list[Instr]:
    parsed = parse(text)
    assert parsed.diagnostics == []
    return parsed.program.items


@pytest.mark.parametrize(
    "text",
    [
        "a.b();  # why\nc.d();",
        "a.b();# why\nc.d();",
        "a.b()  # why\n; c.d();",
        "a.b() ;\t# why\r\nc.d();",
        "2*(\n);  # why\nc.d();",
        "°a.b()°;  # why\nc.d();",
        "WAIT(1);  # why\nc.d();",
        "//(a.b(), c.d());  # why\nc.d();",
        "a.b(); # why",
    ],
)
def test_a_comment_behind_an_instruction_on_its_line_belongs_to_it(text: str) -> None:
    assert items(text)[0].after == "why"


@pytest.mark.parametrize(
    "text", ["# why\na.b();", "#why\n\n\na.b();", "# why\r\na.b();", "; # why\na.b();", "\f# why\n\ta.b();"]
)
def test_a_comment_on_a_line_of_its_own_belongs_to_the_next_instruction(text: str) -> None:
    (node,) = items(text)
    assert (node.above, node.after) == (["why"], None)


def test_comments_above_keep_their_order() -> None:
    assert items("# one\n# two\n\n# three\na.b();")[0].above == ["one", "two", "three"]


def test_a_comment_on_the_line_after_an_instruction_is_the_next_one_s() -> None:
    first, second = items("a.b();\n# why\nc.d();")
    assert (first.after, second.above) == (None, ["why"])


def test_two_instructions_on_a_line_share_no_comment() -> None:
    first, second = items("a.b(); c.d();  # why")
    assert (first.after, second.after) == (None, "why")


def test_a_comment_with_nothing_after_it_belongs_to_the_program() -> None:
    assert parse("a.b();\n# the end\n").program.below == ["the end"]


def test_a_comment_in_an_empty_program_belongs_to_the_program() -> None:
    assert parse("# nothing yet").program == Seq(below=["nothing yet"])


def test_a_comment_with_nothing_after_it_belongs_to_the_body_it_stands_in() -> None:
    (loop,) = items("2*(\n  a.b();\n  # in here\n);\n")
    assert isinstance(loop, Repeat)
    assert loop.body.below == ["in here"]


def test_a_comment_in_an_empty_body_belongs_to_the_body() -> None:
    (loop,) = items("2*(\n  # nothing yet\n);")
    assert isinstance(loop, Repeat)
    assert loop.body == Seq(below=["nothing yet"])


def test_a_comment_behind_the_bracket_that_opens_a_body_is_the_first_instruction_s() -> None:
    (loop,) = items("2*(  # first\n  a.b();\n);")
    assert isinstance(loop, Repeat)
    assert (loop.after, loop.body.items[0].above) == (None, ["first"])


@pytest.mark.parametrize("comma", ["a.b();,  # why\n", "a.b();  # why\n,", "a.b()  # why\n;,", "a.b(),  # why\n"])
def test_a_comment_behind_the_last_instruction_of_a_branch_is_that_one_s_on_either_side_of_the_comma(
    comma: str,
) -> None:
    (parallel,) = items(f"//(\n{comma}  c.d();\n);")
    assert isinstance(parallel, Parallel)
    assert parallel.branches[0].items[0].after == "why"
    assert parallel.branches[1].items[0].above == []


def test_comments_of_a_branch_that_is_dropped_go_to_the_parallel() -> None:
    (parallel,) = items("//(\n  # left out\n  ,\n  c.d();\n);")
    assert isinstance(parallel, Parallel)
    assert parallel.above == ["left out"]


@pytest.mark.parametrize(
    "text",
    [
        "a.b(  # why\n  1);\nc.d();",
        "a.b(1,  # why\n  2);\nc.d();",
        "a  # why\n.b();\nc.d();",
        "WAIT(  # why\n1);\nc.d();",
    ],
)
def test_a_comment_inside_an_instruction_is_the_next_one_s(text: str) -> None:
    assert items(text)[1].above == ["why"]


@pytest.mark.parametrize(
    "head", ["[a.b()  # why\n  & c.d()]", "*[  # why\n  a.b()]", "2  # why\n*", "<a.b()  # why\n>"]
)
def test_a_comment_inside_the_head_of_a_body_is_the_body_s(head: str) -> None:
    (node,) = items(f"{head}(e.f(););")
    body = node.then if isinstance(node, Conditional) else node.body  # type: ignore[union-attr]
    assert body.items[0].above == ["why"]


def test_a_separator_on_a_later_line_does_not_carry_a_comment_back() -> None:
    first, second = items("a.b()\n;  # why\nc.d();")
    assert (first.after, second.above) == (None, ["why"])


def test_a_comment_inside_the_last_instruction_is_the_program_s() -> None:
    assert parse("a.b(  # why\n  1);").program.below == ["why"]


@pytest.mark.parametrize(
    ("written", "kept"),
    [
        ("#", ""),
        ("#   ", ""),
        ("# x  ", "x"),
        ("#x", "x"),
        ("#  x", " x"),
        ("## x", "# x"),
        ("#\tx", "\tx"),
        ("# a; b(, WAIT(1) # c", "a; b(, WAIT(1) # c"),
        ("# °Größe° رفتار", "°Größe° رفتار"),
        ("# {hole}", "{hole}"),
    ],
)
def test_the_text_of_a_comment_is_kept_without_its_sign_and_one_space(written: str, kept: str) -> None:
    (node,) = items(f"{written}\na.b();  {written}\r\n")
    assert (node.above, node.after) == ([kept], kept)
    assert parse(print_program(Seq([node]))).program == Seq([node])


ALL_PLACES = """\
# 1
a.b();  # 2
# 3
[c.d()](  # 4
  # 5
  e.f();  # 6
  # 7
)!(
  # 8
);  # 9
//(
  # 10
  2*(  # 11
    # 12
  );,  # 13
  # 14
  °g.h()°;  # 15
  # 16
);  # 17
# 18
"""


def test_no_comment_is_lost_or_doubled_by_reading_and_printing() -> None:
    printed = print_program(parse(ALL_PLACES).program)
    assert sorted(int(line.split("# ")[1]) for line in printed.split("\n") if "#" in line) == list(range(1, 19))
    assert parse(printed).program == parse(ALL_PLACES).program


def test_comments_of_a_construct_that_cannot_be_read_stay_in_its_body() -> None:
    parsed = parse("# one\n3;\n# two\nc.d();\n2*(\n  # three\n  4;\n);\n")
    assert parsed.program.below == ["one"]
    call, loop = parsed.program.items
    assert call.above == ["two"]
    assert isinstance(loop, Repeat)
    assert loop.body.below == ["three"]
