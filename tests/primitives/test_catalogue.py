"""The catalogue: where files are looked for, who wins, and that a bad file hides nothing."""

from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

import pytest

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.regular import open_regular
from kitrobot.lll.tree import Break, Conditional, Seq, While
from kitrobot.primitives import catalogue
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.match_template import is_more_specific
from kitrobot.primitives.robot_xml import read_robot
from kitrobot.primitives.templates import shape
from tests.primitives.samples import CONSTRUCTORS, ROBOT, constructors


@pytest.fixture(autouse=True)
def config(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "config"
    monkeypatch.setenv("KITROBOT_CONFIG", str(folder))
    return folder


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "mission"
    made.mkdir()
    return made


def names(catalogue: Catalogue) -> dict[str, list[str]]:
    return {group.name: [constructor.name for constructor in group.constructors] for group in catalogue.groups}


def test_what_is_shipped_is_always_there(tmp_path: Path) -> None:
    catalogue = load_catalogue([tmp_path / "not-there"])
    assert catalogue.problems == []
    assert "mini-robot" in catalogue.robots
    assert "While" in catalogue.constructors


def test_a_file_dropped_into_a_folder_is_enough(folder: Path) -> None:
    (folder / "mine.xml").write_text(constructors('<constructor name="Mine"><code>BREAK</code></constructor>'))
    (folder / "tiny.robot.xml").write_text(ROBOT)
    catalogue = load_catalogue([folder])
    assert names(catalogue)["G"] == ["Mine"]
    assert catalogue.robot("tiny").name == "tiny"


def test_a_file_is_read_once_until_it_changes(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    load_catalogue([])  # what is shipped
    read: list[str] = []
    for name, reader in (("read_robot", read_robot), ("read_constructors", read_constructors)):

        def counting(data: bytes, file: str, reader: Callable[[bytes, str], object] = reader) -> object:
            read.append(Path(file).name)
            return reader(data, file)

        monkeypatch.setattr(catalogue, name, counting)
    (folder / "own.robot.xml").write_text(ROBOT)
    (folder / "own.xml").write_text(constructors("<oops/>"))
    first, second = load_catalogue([folder]), load_catalogue([folder])
    assert sorted(read) == ["own.robot.xml", "own.xml"]
    assert (first.robots, first.constructors, first.problems) == (second.robots, second.constructors, second.problems)
    assert first.problems is not second.problems
    (folder / "own.robot.xml").write_text(ROBOT.replace("<robot ", '<robot tick="40" ', 1))
    assert load_catalogue([folder]).robots != first.robots
    large = ROBOT + " " * catalogue.REMEMBERED_BYTES
    (folder / "own.robot.xml").write_text(large)
    read.clear()
    for _ in range(2):
        assert load_catalogue([folder]).robots == first.robots
    assert read == ["own.robot.xml"] * 2, "large files are not kept in memory"


def test_a_later_folder_wins_and_the_order_of_the_palette_stays(config: Path, folder: Path) -> None:
    config.mkdir()
    before = names(load_catalogue())
    (config / "constructors.xml").write_text(CONSTRUCTORS, encoding="utf-8")
    assert load_catalogue().constructors["While"].help == {"": "Ä test < — ✓"}
    (folder / "constructors.xml").write_text(CONSTRUCTORS.replace("Ä test", "B test"), encoding="utf-8")
    catalogue = load_catalogue([folder])
    assert catalogue.constructors["While"].help == {"": "B test < — ✓"}
    assert names(catalogue) == before
    assert catalogue.problems == []


def test_groups_of_one_name_become_one_with_all_labels(folder: Path) -> None:
    (folder / "a.xml").write_text(
        '<constructors version="1"><group name="Loops" colour="loop"><label xml:lang="de">Schleifen</label>'
        '<constructor name="Mine"><code>BREAK</code></constructor></group></constructors>'
    )
    catalogue = load_catalogue([folder])
    [loops] = [group for group in catalogue.groups if group.name == "Loops"]
    assert loops.constructors[-1].name == "Mine"
    assert loops.label["de"] == "Schleifen"
    assert loops.label["fr"] == "Boucles"


@pytest.mark.parametrize(
    "damage", ["", "<robot", "<!DOCTYPE x><robot/>", "<robot name='tiny' version='1'><variable/></robot>"]
)
def test_a_bad_file_is_reported_and_hides_nothing(folder: Path, damage: str) -> None:
    (folder / "bad.robot.xml").write_text(damage)
    (folder / "constructors.xml").write_text("<constructors")
    (folder / "tiny.robot.xml").write_text(ROBOT)
    catalogue = load_catalogue([folder])
    files = {Path(problem.place.file).name for problem in catalogue.problems if problem.place}
    assert files == {"bad.robot.xml", "constructors.xml"}
    assert {"tiny", "mini-robot"} <= set(catalogue.robots)
    assert "While" in catalogue.constructors


def test_a_wrong_robot_in_a_later_folder_leaves_the_earlier_one(folder: Path) -> None:
    (folder / "x.robot.xml").write_text('<robot name="mini-robot" version="1"><variable/></robot>')
    catalogue = load_catalogue([folder])
    assert catalogue.robot("mini-robot").actuators
    assert catalogue.problems


def test_the_same_name_twice_in_one_folder_is_a_warning(folder: Path) -> None:
    (folder / "a.robot.xml").write_text(ROBOT)
    (folder / "b.robot.xml").write_text(ROBOT.replace('initial="3"', 'initial="4"'))
    catalogue = load_catalogue([folder])
    [problem] = catalogue.problems
    assert problem.code == "catalogue-twice"
    assert not problem.is_error
    assert catalogue.robots["tiny"].variables[0].initial == 4


def test_other_files_of_the_folder_are_left_alone(folder: Path) -> None:
    (folder / "ring.world.xml").write_text("<world><<<")
    (folder / "notes.xml").write_text("<svg/>")
    (folder / "empty.xml").write_bytes(b"")
    (folder / "folder.xml").mkdir()
    (folder / "transport.krt").write_text("<kitrobot/>")
    assert load_catalogue([folder]).problems == []


def test_what_adds_to_nothing_is_reported_and_left_out(folder: Path) -> None:
    adds = '<constructor name="{}"><adds constructor="{}" slot="{}"/></constructor>'
    (folder / "c.xml").write_text(
        constructors(
            adds.format("A", "Paralelism", "branch")
            + adds.format("B", "Parallelism", "brunch")
            + adds.format("C", "While", "body")
            + adds.format("D", "Parallelism", "branch")
        )
    )
    catalogue = load_catalogue([folder])
    assert names(catalogue)["G"] == ["D"]
    assert [problem.code for problem in catalogue.problems] == ["constructor-adds"] * 3
    assert catalogue.problems[0].help == "did you mean Parallelism?"


def test_a_file_that_cannot_be_read_is_reported(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (folder / "tiny.robot.xml").write_text(ROBOT)

    def refuse(path: Path) -> BinaryIO:
        if path.name == "tiny.robot.xml":
            raise PermissionError(13, "Permission denied")
        return open_regular(path)

    monkeypatch.setattr("kitrobot.primitives.catalogue.open_regular", refuse)
    [problem] = load_catalogue([folder]).problems
    assert problem.code == "catalogue-unreadable"
    assert problem.message.endswith("Permission denied")


def test_a_robot_is_found_by_name_or_by_its_file(tmp_path: Path) -> None:
    path = tmp_path / "other.robot.xml"
    path.write_text(ROBOT)
    catalogue = load_catalogue()
    assert catalogue.robot(path) == catalogue.robot(str(path))
    assert catalogue.robot(path).name == "tiny"


def test_an_unknown_robot_is_refused_with_the_nearest_name() -> None:
    with pytest.raises(KitRobotError, match="there is no robot named mini-rabbit") as caught:
        load_catalogue().robot("mini-rabbit")
    assert caught.value.help == "did you mean mini-robot?"


def test_a_robots_file_that_is_missing_or_wrong_is_refused(tmp_path: Path) -> None:
    catalogue = load_catalogue()
    with pytest.raises(KitRobotError, match="cannot read"):
        catalogue.robot(tmp_path / "none.robot.xml")
    wrong = tmp_path / "wrong.robot.xml"
    wrong.write_text("<robot>")
    with pytest.raises(KitRobotError, match="cannot be used") as caught:
        catalogue.robot(wrong)
    assert [problem.code for problem in caught.value.diagnostics] == ["xml-not-well-formed"]


def test_the_inverse_is_found_from_the_template_and_the_first_wins(folder: Path) -> None:
    inverse = load_catalogue().inverse
    one = Seq()
    assert inverse[shape(While(Break(), one))].name == "While"  # type: ignore[arg-type]
    assert inverse[shape(Conditional(Break(), one))].name == "If Then"  # type: ignore[arg-type]
    assert inverse[shape(Conditional(Break(), one, one))].name == "If Then Else"  # type: ignore[arg-type]
    assert {kind.__name__ for kind, _ in inverse} == {
        *("Repeat", "While", "Conditional", "Event", "Parallel", "Wait", "Break", "Interrupt", "And", "Or", "Not"),
        *("SeqOfPar", "ParOfSeq", "Where", "ProgramCall", "Move", "Joint"),
    }


def test_a_template_bigger_than_one_construct_has_no_inverse(folder: Path) -> None:
    inverse = load_catalogue().inverse
    assert not {"Repeat Until", "Wait Until", "Unless"} & {found.name for found in inverse.values()}
    codes = ["3*({b})", "{n}*(BREAK; )", "//({b},{c})", "//({b},BREAK)"]
    slots = ['<flow name="b"/>', '<number name="n"/>', '<flow name="b"/><flow name="c"/>', '<flow name="b"/>']
    inside = "".join(
        f'<constructor name="X{n}">{slot}<code>{code}</code></constructor>'
        for n, (code, slot) in enumerate(zip(codes, slots, strict=True))
    )
    (folder / "c.xml").write_text(constructors(inside))
    catalogue = load_catalogue([folder])
    assert len(names(catalogue)["G"]) == 4
    assert not [found for found in catalogue.inverse.values() if found.name.startswith("X")]


SPECIAL = [
    ("{n}*({b})", "2*({b})"),
    ("*[{c}]({b})", "*[!({c})]({b})"),
    ("*[!({c})]({b})", "*[!({c} & {d})]({b})"),
    ("*[{c}]({b})", "*[{c}]({b}; WAIT(1))"),
    ("*[{c}]({b}; WAIT(1))", "*[{c}](WAIT(2); {b}; WAIT(1))"),
    ("&lt;{c}&gt;({b})", "&lt;{c}&gt;()"),
    ("//({r})", "//({b}, {e})"),
    ("//({r})", "//({b}, °{a}°)"),
    ("*(A.b({v}); {b})", "*(A.b({n}); {b})"),
    ("*(A.b({n}); {b})", "*(A.b(7); {b})"),
    ("!({c})", "!({c} | {d})"),
]
"""A template and a special case of it."""

STRANGERS = [
    ("*[{c} & Run.IsTrue()]({b})", "*[!({c})]({b})"),
    ("*(WAIT(1); {b})", "*({b}; WAIT(1))"),
    ("{n}*({b})", "{n}*({b})"),
    ("//({b})", "//({b}, {e})"),
    ("*({b})", "*[{c}]({b})"),
]
"""Neither is a special case of the other."""

SLOTS = {"n": "number", "v": "value", "c": "condition", "d": "condition", "b": "flow", "e": "flow", "a": "action"}


def made_of(code: str, name: str) -> str:
    used = {hole for hole in (*SLOTS, "r") if f"{{{hole}}}" in code}
    slots = "".join(f'<{SLOTS[one]} name="{one}"/>' for one in SLOTS if one in used)
    slots += '<flow name="r" repeat="yes"/>' if "r" in used else ""
    return f'<constructor name="{name}">{slots}<code>{code.replace(" & ", " &amp; ")}</code></constructor>'


def both(one: str, other: str) -> tuple[Constructor, Constructor]:
    groups, problems = read_constructors(constructors(made_of(one, "One") + made_of(other, "Other")).encode(), "c.xml")
    assert problems == []
    first, second = groups[0].constructors
    return first, second


@pytest.mark.parametrize(("wide", "special"), SPECIAL)
def test_a_template_that_another_would_read_is_the_more_specific(wide: str, special: str) -> None:
    one, other = both(wide, special)
    assert is_more_specific(other, one)
    assert not is_more_specific(one, other)


@pytest.mark.parametrize(("one", "other"), STRANGERS)
def test_templates_that_do_not_read_each_other_or_both_do_are_not_ordered(one: str, other: str) -> None:
    first, second = both(one, other)
    assert not is_more_specific(first, second)
    assert not is_more_specific(second, first)


def test_the_more_specific_is_tried_first_and_then_what_stands_first_in_the_palette(folder: Path) -> None:
    codes = ["*[{c}](WAIT(1); {b})", "*[{c}]({b})", "*[!({c})]({b})", "*[!({c} & {d})]({b})"]
    inside = "".join(made_of(code, f"X{n}") for n, code in enumerate(codes))
    (folder / "c.xml").write_text(constructors(inside))
    found = [one.name for one in load_catalogue([folder]).drawn[shape(While(Break(), Seq()))]]  # type: ignore[arg-type]
    assert found == ["X3", "Repeat Until", "X0", "X2", "While", "X1"]


READS = [
    ("<code>*({b})</code><reads>*[{x}]({b})</reads>", "the hole {x} has no slot"),
    ("<code>*({b})</code><reads>*[a.b()]()</reads>", "expected a hole {b} for the slot b, found none"),
    ("<code>*({b})</code><reads>WAIT(1); *({b})</reads>", "expected one construct to read"),
]


@pytest.mark.parametrize(("inside", "message"), READS)
def test_other_code_that_is_read_must_be_one_construct_around_the_same_slots(inside: str, message: str) -> None:
    text = constructors(f'<constructor name="X"><flow name="b"/>{inside}</constructor>')
    groups, problems = read_constructors(text.encode(), "c.xml")
    assert [one for group in groups for one in group.constructors] == []
    assert message in problems[0].message
