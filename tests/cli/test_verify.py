"""`kitrobot verify`: the table, the JSON, and what is told of a check that cannot be made."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from kitrobot.cli.verify import odds_words, progress_words
from tests.verifier.check_fixtures import mutant
from tests.verifier.test_known_answers import UNCOUNTED

ROOT = Path(__file__).parents[2]
SMALL = ROOT / "examples" / "passing-loop" / "passing-loop.krt"
ENDLESS = ("--seconds", "1e9")
"""A check that no busy machine cuts short."""
MORE = "--approximate looks at more, and does not say that anything holds"


def test_every_property_that_holds_is_in_the_table(kitrobot) -> None:
    said = kitrobot("verify", SMALL, "--timing", "lockstep", *ENDLESS)
    assert said.status == 0, said
    rows = {line.split()[0]: line.split()[1:] for line in said.out.splitlines() if line and line[0] != " "}
    assert rows["empty-storehouse"] == ["holds"]
    assert rows["served-carrier-2"] == ["holds"]
    assert int(rows["states"][0].replace(",", "")) > 1000
    assert "taken for granted: robots on different roads" in said.out


def test_what_is_broken_is_told_as_a_run_and_confirmed(kitrobot, tmp_path: Path) -> None:
    text = SMALL.read_text(encoding="utf-8").replace(
        '<vertex id="v1" element="Repetition"><set name="count">3</set>',
        '<vertex id="v1" element="Repetition"><set name="count">9</set>',
    )
    path = tmp_path / "greedy.krt"
    path.write_text(text, encoding="utf-8")
    arguments = ("verify", path, "--timing", "lockstep", "--property", "empty-storehouse", *ENDLESS)
    said = kitrobot(*arguments)
    assert said.status == 1
    assert "reaches into the empty storehouse A\n  confirmed in the simulator: seed 1, at " in said.out
    assert "  why:  loader-1 reaches into the empty storehouse A: this breaks `empty-storehouse`\n" in said.out
    found = kitrobot(*arguments, "--json").json
    broken = found["checks"][0]["properties"][0]
    assert broken["answer"] == "broken"
    assert len(broken["why"]["sentences"]) <= 3
    decided = broken["why"]["step"]
    assert f"\n> {decided:>4}  " in said.out if decided is not None else broken["why"]["certainty"] == "never"
    assert broken["confirmed"]["seed"] == 1
    assert broken["confirmed"]["failures"] == []
    assert broken["run"][-1]["text"].endswith("reaches into the empty storehouse A")


def test_a_run_of_the_simulator_that_keeps_it_is_told(kitrobot, tmp_path: Path) -> None:
    mutant(tmp_path, UNCOUNTED, stock=1)
    arguments = ("verify", tmp_path / "mutant.krt", "--timing", "lockstep", *ENDLESS)
    said = kitrobot(*arguments, "--property", "empty-storehouse")
    assert "  kept there if carrier-2 waits 0.50 s at 4.94 s\n" in said.out
    found = kitrobot(*arguments, "--property", "empty-storehouse", "--json").json
    kept = found["checks"][0]["properties"][0]["why"]["kept"]
    assert (kept["delayed"], kept["delay_seconds"], kept["ends_well"]) == ("carrier-2", 0.5, True)


def test_a_search_that_is_cut_never_holds(kitrobot) -> None:
    said = kitrobot("verify", SMALL, "--timing", "free", "--max-states", "50", "--json", *ENDLESS)
    assert said.status == 3
    checked = said.json["checks"][0]
    assert (checked["states"], checked["complete"], checked["cut"]) == (50, False, "states")
    assert {one["answer"] for one in checked["properties"]} == {"not finished"}


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (
            ("--timing", "prompt", "--max-states", "50"),
            f"prompt; free came to the limit of states; --max-states sets another; {MORE}",
        ),
        (("--max-memory", "1"), f"free came to the limit of memory; --max-memory sets another; {MORE}"),
        (("--timing", "prompt", "--seconds", "0.000001"), "prompt ran out of time; --seconds gives it more"),
    ],
)
def test_why_a_search_is_not_finished_is_said_with_what_helps(kitrobot, options: tuple[str, ...], words: str) -> None:
    said = kitrobot("verify", SMALL, "--timing", "free", *options)
    assert said.status == 3
    assert [line for line in said.out.splitlines() if "not finished:" in line] == [f"  not finished: {words}"]


@pytest.mark.parametrize(
    ("options", "status", "words"),
    [
        (("--property", "nobody"), 1, "this mission has no property nobody"),
        (("--timing", "never"), 2, "expected one of lockstep, prompt, free"),
        (("--failures", "9"), 2, "a check takes 0 to 3 failures"),
        (("--failures", "1", "--kind", "rust"), 2, "expected one of fail, stall, mute"),
        (("--kind", "mute"), 2, "say with --failures how many there may be"),
        (("--seconds", "0"), 2, "a check takes more than 0 seconds"),
        (("--max-states", "0"), 2, "--max-states"),
        (("--max-memory", "0"), 2, "--max-memory"),
        (("--approximate", "--max-memory", "lots"), 2, "--max-memory"),
        (("--cores", "0"), 2, "--cores"),
        (("--cores", "4096"), 1, "a check takes 1"),
    ],
)
def test_a_check_that_makes_no_sense_is_refused(kitrobot, options: tuple[str, ...], status: int, words: str) -> None:
    said = kitrobot("verify", SMALL, *options)
    assert said.status == status
    assert words in said.err


def test_an_approximate_check_says_what_it_found_how_sure_it_is_and_what_it_cannot_decide(kitrobot) -> None:
    asked = ("verify", SMALL, "--timing", "lockstep", "--approximate", *ENDLESS)
    said = kitrobot(*asked)
    assert said.status == 3
    rows = {line.split()[0]: line.split()[1:] for line in said.out.splitlines() if line and line[0] != " "}
    assert (rows["deadlock"], rows["delivered"]) == (["nothing", "found"], ["not", "decided"])
    assert "holds" not in said.out
    assert (
        "  approximate: lockstep: fewer than 1 in 1,000,000,000 states that steps lead to may have been missed"
        in said.out
    )
    assert (
        "  not decided: what waits, or depends on what came before, needs all steps; leave out --approximate"
        in said.out
    )
    (checked,) = kitrobot(*asked, "--property", "deadlock", "--json").json["checks"]
    assert (checked["approximate"], checked["complete"], checked["cut"]) == (True, False, None)
    assert 0 <= checked["missed_odds"] < 1e-9


def test_an_approximate_check_whose_memory_ends_keeps_what_it_knows(kitrobot) -> None:
    said = kitrobot("verify", SMALL, "--timing", "lockstep", "--approximate", "--max-memory", "1")
    assert said.status == 3
    assert "  not finished: lockstep came to the limit of memory; --max-memory sets another\n" in said.out
    assert "nothing found" in said.out


def test_odds_are_said_in_whole_states() -> None:
    assert odds_words(0.0003).startswith("at most 1 in 3,333 states")
    assert odds_words(0.9).startswith("its memory was full")


def test_a_team_is_checked_with_members_that_fail_and_what_is_cut_is_not_finished(kitrobot) -> None:
    convoy = ROOT / "examples" / "convoy" / "convoy.krt"
    said = kitrobot("verify", convoy, "--timing", "lockstep", "--failures", "1", "--max-states", "2000", *ENDLESS)
    assert said.status == 3
    assert re.search(r"deadlock +holds +not finished", said.out)


def test_a_property_about_nothing_is_left_out_or_vacuous_and_the_check_says_so(kitrobot, tmp_path: Path) -> None:
    asked = {
        "nobody": ("any carrier-9 (Cargo.IsPressed())", "no agent of this team"),
        "nothing": ("any carrier-south (Wings.IsPressed())", "Wings"),
        "never": ("any carrier-south (Sign.EqualTo(99)) &amp; any carrier-north (Sign.EqualTo(99))", ""),
    }
    lines = "".join(f'  <property name="{name}" never="{one}"/>\n' for name, (one, _) in asked.items())
    path = tmp_path / "asked.krt"
    text = SMALL.read_text(encoding="utf-8")
    path.write_text(text.replace("  <world", f"{lines}  <world", 1), encoding="utf-8")
    said = kitrobot("verify", path, "--timing", "lockstep", *ENDLESS)
    assert "vacuous" in next(line for line in said.out.splitlines() if line.startswith("never"))
    for name, (_, words) in asked.items():
        if words:
            assert f"the property {name} is left out: " in said.out
            assert words in said.out
            alone = kitrobot("verify", path, "--timing", "lockstep", "--property", name, *ENDLESS)
            assert (alone.status, alone.out) == (1, "")
            assert f"this mission has no property {name}" in alone.err


def test_who_shares_nothing_has_no_radio_to_lose_and_a_check_of_that_says_so(kitrobot) -> None:
    blink = ROOT / "examples" / "blink" / "blink.krt"
    said = kitrobot("verify", blink, "--timing", "lockstep", "--failures", "1", "--kind", "mute", *ENDLESS)
    assert said.status == 0, said
    assert "lockstep, 1 failure (mute)" in said.out
    assert "taken for granted: nobody loses its radio" in said.out


def test_progress_says_how_many_states_a_second_and_how_much_memory() -> None:
    words = progress_words("free, 1 failure", 1_200_000, 63, 2.0, 345_600_000)
    assert words == "free, 1 failure: 1,200,000 states, 600,000 a second, 63 deep, 346 MB"
    assert progress_words("lockstep", 12, 3, 0.0, 0) == "lockstep: 12 states, 3 deep"
