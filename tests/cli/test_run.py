"""`kitrobot run`."""

from __future__ import annotations

import shutil
import socket

import pytest

from tests.cli.conftest import EXAMPLE

SHORT = """<kitrobot version="1">
  <program name="p" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Light.LightOn"/>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="p"/>
  </team>
</kitrobot>
"""


@pytest.fixture
def transport(here):
    """A copy of the example."""
    return shutil.copy(EXAMPLE, here / "transport.krt")


@pytest.fixture
def short(here):
    """A mission of one tick."""
    (here / "short.krt").write_text(SHORT)
    return "short.krt"


def test_the_example_is_done_and_all_stock_is_delivered(kitrobot, transport):
    said = kitrobot("run", transport, "--seed", 1, "--seconds", 600, "--json")
    assert (said.status, said.err) == (0, "")
    run = said.json
    assert run["outcome"] == "done"
    assert sum(run["delivered"].values()) == run["total"] == 12
    assert set(run["delivered"]) == {"carrier-1", "carrier-2", "carrier-3"}
    assert run["collisions"] == 0
    assert run["seconds"] == pytest.approx(run["ticks"] * 0.02)


def test_json_is_one_object_and_only_timing_depends_on_the_clock(kitrobot, short):
    runs = [kitrobot("run", short, "--json").json for _ in range(2)]
    assert set(runs[0]) == {
        "outcome",
        "sentence",
        "ticks",
        "seconds",
        "delivered",
        "total",
        "collisions",
        "timing",
    }
    assert set(runs[0]["timing"]) == {"real_seconds", "speed"}
    for run in runs:
        del run["timing"]
    assert runs[0] == runs[1]


def test_the_summary_is_for_people(kitrobot, transport):
    said = kitrobot("run", transport)
    assert said.status == 0
    assert said.out.startswith("Done after ")
    for words in ("outcome     done", "carrier-2", "12 of 12", "collisions  0", "simulated", "real time"):
        assert words in said.out
    assert said.err == ""


def test_a_mission_that_runs_out_of_time_is_not_done(kitrobot, transport):
    said = kitrobot("run", transport, "--seconds", 2, "--json")
    assert (said.status, said.json["outcome"], said.json["ticks"]) == (1, "time", 100)


def test_a_mission_whose_goal_is_not_reached_has_failed(kitrobot, here):
    goal = '    <goal storehouse="B" stock="all"/>\n  </team>\n  <world href="ring.world.xml"/>\n'
    text = SHORT.replace("  </team>\n", goal).replace('name="robot-1"', 'name="r" start="carrier-1"')
    (here / "m.krt").write_text(text)
    said = kitrobot("run", "m.krt", "--json")
    assert (said.status, said.json["outcome"]) == (1, "failed")


def test_a_mission_in_which_nothing_can_change_is_stuck(kitrobot, here):
    text = SHORT.replace(
        '    <vertex id="v1" element="Light.LightOn"/>\n',
        '    <vertex id="v1" element="When"/>\n    <vertex id="v2" element="Run.IsFalse"/>\n',
    ).replace(
        '    <arc from="start" to="v1"/>\n',
        '    <arc from="start" to="v1"/>\n    <arc from="v2" to="v1" at="condition"/>\n'
        '    <arc from="v1" out="body" to="v1" at="return"/>\n',
    )
    (here / "m.krt").write_text(text)
    said = kitrobot("run", "m.krt", "--json")
    assert (said.status, said.json["outcome"]) == (1, "stuck")


def test_the_same_seed_gives_the_same_trace_to_the_byte(kitrobot, transport, here):
    for name in ("a", "b"):
        assert kitrobot("run", transport, "--seed", 3, "--trace", f"{name}.krtrace").status == 0
    assert (here / "a.krtrace").read_bytes() == (here / "b.krtrace").read_bytes()
    assert (here / "a.krtrace").stat().st_size > 1000


def test_robots_fail_by_chance_as_the_seed_says_and_the_sentence_names_them(kitrobot, transport):
    def run(rate):
        said = kitrobot("run", transport, "--seed", 5, "--seconds", 60, "--fail-rate", rate, "--json")
        return said.status, said.json

    status, failed = run(1)
    assert (status, failed["outcome"]) == (1, "failed")
    assert failed["sentence"].startswith("Nobody is left to go on: ")
    assert "carrier-1 failed after" in failed["sentence"]
    assert "(by chance)" in failed["sentence"]
    assert run(0.9)[1]["sentence"] == run(0.9)[1]["sentence"]
    assert run(0)[1]["outcome"] in ("done", "time")


@pytest.mark.parametrize("schedule", ['at="1"', 'at="1" kind="stall"'])
def test_a_schedule_in_the_mission_holds(kitrobot, here, transport, schedule):
    text = (here / "transport.krt").read_text()
    gone = "".join(f'<failure agent="carrier-{n}" {schedule}/>' for n in (1, 2, 3))
    (here / "transport.krt").write_text(text.replace("</kitrobot>", f"{gone}</kitrobot>"))
    said = kitrobot("run", "transport.krt", "--seconds", 30, "--json")
    assert said.status == 1
    assert "carrier-1 " + ("stalled" if "stall" in schedule else "failed") in said.json["sentence"]


@pytest.mark.parametrize("trace", ["none/x.krtrace", "."])
def test_a_trace_that_cannot_be_written_is_a_sentence(kitrobot, short, trace):
    said = kitrobot("run", short, "--trace", trace)
    assert (said.status, said.out) == (1, "")
    assert "error: " in said.err


def test_the_trace_is_never_written_over_the_mission(kitrobot, short, here):
    (here / "link.krtrace").symlink_to(here / short)
    for name in (short, "link.krtrace"):
        assert kitrobot("run", short, "--trace", name).status == 1
    assert (here / short).read_text() == SHORT


def test_a_mission_with_errors_is_not_run(kitrobot, here):
    (here / "m.krt").write_text(SHORT.replace("LightOn", "Glow"))
    said = kitrobot("run", "m.krt", "--json")
    assert (said.status, said.json["error"]["diagnostics"][0]["code"]) == (1, "unknown-element")
    assert "m.krt:4:5: error: " in said.err
    assert said.err.count("[unknown-element]") == 1


def test_a_mission_without_agents_is_not_run(kitrobot, here):
    (here / "m.krt").write_text(SHORT[: SHORT.index("  <team>")] + "</kitrobot>\n")
    said = kitrobot("run", "m.krt")
    assert (said.status, said.out) == (1, "")
    assert "no agents" in said.err


def test_check_tells_a_mission_without_agents_as_a_run_does(kitrobot, here):
    (here / "m.krt").write_text(SHORT[: SHORT.index("  <team>")] + "</kitrobot>\n")
    checked = kitrobot("check", "m.krt", "--json")
    assert (checked.status, [one["code"] for one in checked.json]) == (1, ["run-no-agent"])
    assert "run-no-agent" in kitrobot("run", "m.krt").err


TEAM = """<kitrobot version="1">
  <program name="p" robot="mini-robot">
    <vertex id="a" element="Start"/><vertex id="b" element="Stop"/><arc from="a" to="b"/>
  </program>
  <world href="merge.world.xml"/>
  <team>{agents}</team>
</kitrobot>
"""


def test_help_for_a_start_that_is_not_there_names_one_that_is_free(kitrobot, here):
    from kitrobot.workspace.mission_loader import open_mission

    (here / "m.krt").write_text(TEAM.format(agents='<agent name="x" program="p"/>'))
    world = open_mission(here / "m.krt").world
    assert world is not None
    starts = [start.name for start in world.starts]
    others = "".join(f'<agent name="{one}" program="p"/>' for one in starts[1:])
    lost = f'<agent name="y" program="p" start="{starts[1]}x"/>'
    (here / "m.krt").write_text(TEAM.format(agents=others + lost))
    (told,) = (one for one in kitrobot("check", "m.krt", "--json").json if one["code"] == "mission-no-start")
    assert told["help"] in (f"did you mean {starts[0]}?", f"starts that are free there: {starts[0]}")
    taken = "".join(f'<agent name="{one}" program="p"/>' for one in starts)
    (here / "m.krt").write_text(TEAM.format(agents=taken + lost))
    (told,) = (one for one in kitrobot("check", "m.krt", "--json").json if one["code"] == "mission-no-start")
    assert told["help"].startswith("no start of this world is free")


@pytest.mark.parametrize("data", [b"", b"<kitrobot", b"\xff", b'<!DOCTYPE k [<!ENTITY a "b">]><kitrobot version="1"/>'])
def test_a_damaged_mission_is_told_with_its_place(kitrobot, here, data):
    (here / "m.krt").write_bytes(data)
    said = kitrobot("run", "m.krt")
    assert (said.status, said.out) == (1, "")
    assert "m.krt:1:" in said.err


@pytest.mark.parametrize("name", ["none.krt", "."])
def test_a_mission_that_is_not_there_is_a_sentence(kitrobot, name):
    said = kitrobot("run", name)
    assert said.status == 1
    assert f"`{name}`" in said.err


@pytest.mark.parametrize(
    "options",
    [
        ["--seconds", "0"],
        ["--seconds", "-1"],
        ["--seconds", "nan"],
        ["--seconds", "inf"],
        ["--seconds", "x"],
        ["--seconds", "1e308"],
        ["--seconds", "1000000001"],
        ["--seed", str(2**53 + 1)],
        ["--seed", "-1"],
        ["--seed", "1.5"],
        ["--fail-rate", "1.5"],
        ["--fail-rate", "-0.1"],
        ["--fail-rate", "nan"],
        ["--fail-rate", "inf"],
        ["--ros", "233"],
        ["--ros", "-1"],
        ["--ros", "x"],
        ["--ros", "0", "--fail-sweep", "1"],
        ["--ros", "0", "--ros-listen", "tcp/127.0.0.1:0", "--ros-router", "tcp/127.0.0.1:1"],
        ["--ros-listen", "tcp/127.0.0.1:0"],
        ["--ros-router", "tcp/127.0.0.1:1"],
        ["--nothing"],
    ],
)
def test_options_that_make_no_sense_are_refused(kitrobot, short, options):
    said = kitrobot("run", short, *options)
    assert (said.status, said.out) == (2, "")


def test_an_endpoint_for_ros_that_is_taken_or_none_is_told_with_a_way_out(kitrobot, short):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        endpoint = f"tcp/127.0.0.1:{taken.getsockname()[1]}"
        said = [kitrobot("run", short, "--ros", 7, "--ros-listen", one) for one in (endpoint, "nowhere", "")]
    assert [(one.status, one.out) for one in said] == [(1, "")] * 3
    assert all("the network cannot be opened" in one.err for one in said)
    assert not any(".rs" in one.err or "Message {" in one.err for one in said), "where it says so is its own affair"
    assert f"`--ros-router {endpoint}`" in said[0].err


def test_a_router_of_ros_that_is_not_there_is_told(kitrobot, short):
    said = kitrobot("run", short, "--ros", 7, "--ros-router", "tcp/127.0.0.1:1")
    assert (said.status, said.out) == (1, "")
    assert "`ros2 run rmw_zenoh_cpp rmw_zenohd`" in said.err


def test_python_gives_what_the_command_gives(kitrobot, transport):
    import kitrobot as package

    run = package.open(transport).run(seed=1)
    said = kitrobot("run", transport, "--json").json
    ours = run.to_json()
    for result in (said, ours):
        del result["timing"]
    assert said == ours
    assert run.outcome == "done"


def test_a_run_that_ends_at_once_says_how_to_see_more(kitrobot, short):
    said = kitrobot("run", short)
    assert said.out.splitlines()[:2] == [
        "Done after 0.0 s: the program came to its end at once, without a part that takes time.",
        "  help: put a part that takes time before its end, such as `Wait`",
    ]


def test_a_mission_is_set_up_once(kitrobot, short, monkeypatch):
    from kitrobot.sim.setup.setup import Setup

    built = []
    build = Setup._build

    def counted(setup):
        built.append(setup)
        build(setup)

    monkeypatch.setattr(Setup, "_build", counted)
    assert kitrobot("run", short).status == 0
    assert len(built) == 1


def test_an_example_is_run_checked_and_opened_by_its_name(kitrobot):
    assert kitrobot("run", "square").status == 0
    assert kitrobot("check", "examples/square/square.krt").status == 0
    opened = []
    kitrobot("square", studio=lambda opening: opened.append(opening.target))
    assert [path.name for path in opened] == ["square.krt"]
