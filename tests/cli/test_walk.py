"""`kitrobot walk`: a state and its steps, one taken by its number, and what is told of a step that is not possible."""

from __future__ import annotations

from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
LOOP = EXAMPLES / "passing-loop" / "passing-loop.krt"


@pytest.fixture
def typing(kitrobot):
    """Runs `kitrobot walk` with typed lines."""

    def walk(*lines: str, file: Path = LOOP, options: tuple[str, ...] = ()):
        return kitrobot("walk", file, *options, stdin="".join(f"{line}\n" for line in lines).encode())

    return walk


def test_a_step_is_taken_by_its_number_and_taken_back(typing) -> None:
    said = typing("1", "b", "1", "1", "b 9", "q", "1")
    assert said.status == 0
    heads = [line for line in said.out.splitlines() if line.startswith("state ")]
    first = "state 1: carrier-1 goes on in its program; AskANorth = 1"
    assert heads[:4] == ["state 0", first, "state 0", first]
    assert heads[4].startswith("state 2: carrier-2 goes on in its program")
    assert heads[5:] == ["state 0"]
    assert "  carrier-1   north 720–948 mm  at v1\n" in said.out
    assert "    1  carrier-1 goes on in its program; AskANorth = 1\n" in said.out


def test_enter_goes_on_while_only_one_step_is_possible(typing) -> None:
    said = typing("", file=EXAMPLES / "blink" / "blink.krt", options=("--timing", "lockstep"))
    assert "  ! the mission is done\nno step is possible any more\n" in said.out
    stays = typing("")
    assert stays.err == "there is no single step to go on with: type the number of one\n"


@pytest.mark.parametrize("typed", ["0", "99999", "999999999999999999", "b x", "1 2", "hello", "-1", "é" * 300])
def test_what_is_no_step_changes_nothing_and_says_what_can_be_typed(typing, typed: str) -> None:
    said = typing(typed)
    assert said.status == 0
    assert said.out.count("state ") == 1
    assert "there is no step" in said.err or ("is no command" in said.err and "take that step" in said.out)


def test_json_tells_the_state_after_the_steps_that_are_taken(kitrobot) -> None:
    found = kitrobot("walk", LOOP, "--failures", "1", "--take", "1,2", "--json").json
    assert (found["state"], found["taken"], found["more"]) == (2, [1, 2], 0)
    assert "Run = 1" in found["shared"]
    assert found["robots"][0]["vertices"] == [{"program": "carrier-north", "vertex": "v4"}]
    failing = [step for step in found["possible"] if step["failure"]]
    assert failing[0]["text"] == ["carrier-1 fails"]
    on = kitrobot("walk", EXAMPLES / "blink" / "blink.krt", "--timing", "lockstep", "--take", "on", "--json").json
    assert (on["possible"], on["situation"]) == ([], ["the mission is done"])


@pytest.mark.parametrize(
    ("options", "status", "words"),
    [
        (("--take", "1,99"), 1, "there is no step 99 out of state 1"),
        (("--take", "first"), 2, "expected numbers and `on`"),
        (("--take", "0"), 1, "there is no step 0 out of state 0"),
        (("--timing", "slow"), 2, "expected one of lockstep, prompt, free"),
        (("--failures", "4"), 2, "a check takes 0 to 3 failures"),
        (("--kind", "mute"), 2, "say with --failures how many there may be"),
    ],
)
def test_a_walk_that_cannot_be_is_refused_in_a_sentence(kitrobot, options, status: int, words: str) -> None:
    said = kitrobot("walk", LOOP, *options, "--json")
    assert said.status == status
    assert words in said.err
    assert "error" in said.json


def test_a_mission_that_has_no_states_says_why(kitrobot) -> None:
    said = kitrobot("walk", EXAMPLES / "nowhere.krt")
    assert said.status == 1
    assert "nowhere.krt" in said.err
