"""Kits of two people brought together: by parts, and in a part by its settings."""

from __future__ import annotations

from itertools import product

import pytest

from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.primitives.kit import Kit
from kitrobot.primitives.kit_xml import read_kit, write_kit
from kitrobot.versions.file_comparison import CompareError
from kitrobot.versions.kit_merge import merge_kits
from kitrobot.workspace.file_merge import merge_files

BASE = """<board name="k" version="1" micropython="1.20" pins="0..5">
  <label>Tank</label>
  <!-- the left motor is the red one -->
  <actuator device="turn drive" left-forward="1" rate="180"/>
  <actuator device="pen" pin="4"/>
  <sensor device="range" driver="ultrasonic" trigger="2" echo="3"/>
  <measured device="drive" speed="300"/>
</board>
"""


def kit(text: str) -> Kit:
    found, problems = read_kit(text.encode(), "k.board.xml")
    assert found is not None, problems
    return found


def edited(*changes: tuple[str, str]) -> str:
    text = BASE
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    return text


OURS = edited(
    ('rate="180"', 'rate="150"'),
    ('<actuator device="pen" pin="4"/>', ""),
    ("<label>Tank</label>", '<label>Tank</label><label xml:lang="fr">Char</label>'),
)
THEIRS = edited(
    ('left-forward="1"', 'left-forward="5"'),
    ('speed="300"', 'speed="310" noise="2"'),
    ("</board>", '<actuator device="lamp" driver="led" pin="0"/></board>'),
    ('micropython="1.20"', 'micropython="1.25"'),
)


def test_edits_of_different_parts_settings_and_texts_all_stand() -> None:
    merged, conflicts = merge_kits(kit(BASE), kit(OURS), kit(THEIRS))
    assert conflicts == ()
    turn, finder, lamp = merged.parts
    assert turn.board.settings == {"left-forward": "5", "rate": "150"}
    assert (finder.devices, lamp.devices) == (("range",), ("lamp",))
    assert merged.measured[0].settings == {"speed": "310", "noise": "2"}
    assert (merged.micropython, merged.label) == ("1.25", {"": "Tank", "fr": "Char"})
    assert kit(write_kit(merged)) == merged


def test_where_both_changed_the_same_ours_is_kept_and_a_sentence_says_so() -> None:
    ours = kit(
        edited(('rate="180"', 'rate="150"'), ('pins="0..5"', 'pins="0..6"'), ('<actuator device="pen" pin="4"/>', ""))
    )
    theirs = kit(edited(('rate="180"', 'rate="160"'), ('pins="0..5"', 'pins="0..7"'), ('pin="4"', 'pin="5"')))
    merged, conflicts = merge_kits(kit(BASE), ours, theirs)
    assert merged == ours
    assert [one.sentence for one in conflicts] == [
        "the pins of the kit was changed in both: ours is kept",
        "the rate of actuator turn drive was changed in both: ours is kept",
        "the part actuator pen of the kit was changed in both: ours is kept",
    ]


def test_of_two_new_files_what_only_one_has_stands_and_the_rest_is_ours() -> None:
    merged, conflicts = merge_kits(None, kit(OURS), kit(THEIRS))
    assert {part.devices for part in merged.parts} == {part.devices for part in (*kit(OURS).parts, *kit(THEIRS).parts)}
    assert merged.parts[0].board.settings == {"left-forward": "1", "rate": "150"}
    assert "micropython" in " ".join(one.sentence for one in conflicts)


def test_who_changed_nothing_takes_the_other_side() -> None:
    base, ours = kit(BASE), kit(OURS)
    assert merge_kits(base, ours, base) == merge_kits(base, base, ours) == merge_kits(base, ours, ours) == (ours, ())


def test_two_elements_for_one_part_are_no_kit_so_ours_is_kept_as_a_whole() -> None:
    apart = '<actuator device="turn" rate="90"/><actuator device="drive" left-forward="1"/>'
    ours = kit(edited(('<actuator device="turn drive" left-forward="1" rate="180"/>', apart)))
    theirs = kit(edited(('device="turn drive"', 'device="drive turn wheel"')))
    merged, conflicts = merge_kits(kit(BASE), ours, theirs)
    assert merged == ours
    assert [one.sentence for one in conflicts] == [
        "both changed which parts are wired together: ours is kept as a whole"
    ]


def test_whatever_two_people_change_a_kit_comes_out() -> None:
    changes = (
        ('rate="180"', 'rate="9"'),
        ('<actuator device="pen" pin="4"/>', '<missing kind="actuator" device="pen"/>'),
        ("<label>Tank</label>", ""),
        ('device="range"', 'device="range" part="Captor"'),
        ('<measured device="drive" speed="300"/>', ""),
        ('pin="4"', 'pin="3"'),
        ('device="turn drive"', 'device="drive"'),
    )
    for one, other in product(changes, changes):
        ours, theirs = kit(edited(one)), kit(edited(other))
        merged, _ = merge_kits(kit(BASE), ours, theirs)
        assert kit(write_kit(merged)) == merged


def test_files_are_known_by_what_they_hold_and_one_that_says_it_all_stays_as_it_was_written(tmp_path) -> None:
    base, ours, theirs, out = (tmp_path / name for name in (".merge_a", ".merge_b", ".merge_c", "k.board.xml"))
    base.write_text(BASE)
    ours.write_text(BASE)
    theirs.write_text(THEIRS)
    assert merge_files(base, ours, theirs, out).conflicts == ()
    assert out.read_text() == THEIRS
    ours.write_text(OURS)
    assert merge_files(base, ours, theirs, ours).conflicts == ()
    assert kit(ours.read_text()) == merge_kits(kit(BASE), kit(OURS), kit(THEIRS))[0]
    base.write_text("")
    assert merge_files(base, theirs, theirs, out).conflicts == ()


@pytest.mark.parametrize("text", ["<board", "<board/>", BASE[:-20], BASE.replace('pin="4"', 'pin="4" pin="5"')])
@pytest.mark.parametrize("place", [0, 1, 2])
def test_a_kit_that_cannot_be_used_is_trouble_and_nothing_is_written(tmp_path, text: str, place: int) -> None:
    paths = [tmp_path / f"{at}.board.xml" for at in range(3)]
    for at, path in enumerate(paths):
        path.write_text(text if at == place else BASE)
    with pytest.raises(ProblemsError):
        merge_files(paths[0], paths[1], paths[2], tmp_path / "out.board.xml")
    assert sorted(tmp_path.iterdir()) == paths


def test_a_kit_and_a_mission_are_not_merged(tmp_path) -> None:
    (tmp_path / "a").write_text(BASE)
    (tmp_path / "b").write_text('<kitrobot version="1"/>')
    with pytest.raises(CompareError, match="three kits"):
        merge_files(tmp_path / "a", tmp_path / "a", tmp_path / "b", tmp_path / "a")


LINES = "<step>Glue it.</step>{}<step>Wait.</step>{}"


def with_steps(text: str) -> Kit:
    return kit(BASE.replace("</board>", f"{text}</board>"))


def test_two_translators_of_the_steps_and_who_adds_one_do_not_stand_in_each_others_way() -> None:
    base = with_steps(LINES.format("", ""))
    ours = with_steps(LINES.format('<step xml:lang="fr">Collez.</step>', ""))
    theirs = with_steps(LINES.format('<step xml:lang="ur">چپکائیں۔</step>', "<step>Drive.</step>"))
    merged, conflicts = merge_kits(base, ours, theirs)
    assert conflicts == ()
    assert merged.steps == ({"": "Glue it.", "fr": "Collez.", "ur": "چپکائیں۔"}, {"": "Wait."}, {"": "Drive."})


def test_one_step_that_both_translate_differently_is_a_conflict_and_ours_stays() -> None:
    base = with_steps(LINES.format("", ""))
    ours = with_steps(LINES.format('<step xml:lang="fr">Collez.</step>', ""))
    theirs = with_steps(LINES.format('<step xml:lang="fr">Fixez.</step>', ""))
    merged, conflicts = merge_kits(base, ours, theirs)
    assert merged == ours
    assert [(one.ours, one.theirs) for one in conflicts] == [("Collez.", "Fixez.")]


def test_steps_that_are_the_same_in_english_are_merged_as_a_whole() -> None:
    base = with_steps("<step>Wait.</step><step>Wait.</step>")
    theirs = with_steps("<step>Wait.</step>")
    assert merge_kits(base, base, theirs)[0].steps == ({"": "Wait."},)
