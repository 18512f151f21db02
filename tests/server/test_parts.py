"""Parts over the wire: files that a person adds, what they hold as they change on disk, worlds, and new variables."""

from __future__ import annotations

import pytest

from kitrobot.files.examples import examples_folder
from kitrobot.translation.languages import TEXT_LANGUAGES
from tests.server.conftest import SHORT, SOCKET, TOKEN
from tests.server.test_missions import opened

WATCH = f"{SOCKET}/api/watch?token={TOKEN}"
ROBOT = """<robot name="rover" version="1">
  <actuator name="Lamp"><procedure name="Shine"/></actuator>
  <variable name="Trips" max="9"/>
</robot>
"""
WORLD = '<world version="1" name="Yard" width="1000" height="800"><start name="a" x="200" y="200"/></world>'
CONSTRUCTORS = """<constructors version="1">
  <group name="Mine" colour="loop">
    <constructor name="Twice"><flow name="body"/><code>2*({body})</code></constructor>
  </group>
</constructors>
"""


KIT = (
    '<board name="tank" version="1"><label xml:lang="fr">Char</label>'
    '<actuator device="lamp" driver="led" pin="3"/></board>'
)


@pytest.fixture(autouse=True)
def state(tmp_path, monkeypatch):
    monkeypatch.setenv("KITROBOT_STATE", str(tmp_path / "state"))
    monkeypatch.setenv("KITROBOT_CONFIG", str(tmp_path / "config"))


def add(page, text, file="rover.robot.xml", path="blink.krt", over=""):
    data = text.encode() if isinstance(text, str) else text
    return page.post("/api/parts", params={"path": path, "file": file, "over": over}, content=data)


def parts(page, path="blink.krt"):
    return page.get("/api/catalogue", params={"path": path}).json()


def robots(page, path="blink.krt"):
    return [robot["name"] for robot in parts(page, path)["catalogue"]["robots"]]


def variable(page, name="Steps", robot="mini-robot", was="", own=(), path="blink.krt", **changes):
    wanted = {"type": "integer", "min": 0, "max": 10, "initial": 3, "shared": False, **changes}
    sent = {"path": path, "robot": robot, "name": name, "was": was, "variables": list(own), **wanted}
    return page.post("/api/variable", json=sent)


class TestFiles:
    def test_a_robot_is_put_beside_the_mission_and_is_there(self, page, folder):
        added = add(page, ROBOT).json()
        assert added == {"file": "rover.robot.xml", "kind": "robot", "names": ["rover"], "known": False}
        assert (folder / "rover.robot.xml").read_text() == ROBOT
        assert "rover" in robots(page)

    @pytest.mark.parametrize(
        ("text", "file", "kept", "names"),
        [
            (ROBOT, "rover.xml", "rover.robot.xml", ["rover"]),
            (KIT, "tank.xml", "tank.board.xml", ["tank"]),
            (WORLD, "yard", "yard.world.xml", ["Yard"]),
            (CONSTRUCTORS, "mine.xml", "mine.xml", ["Twice"]),
            ("\ufeff" + ROBOT, "روبوٹ.xml", "روبوٹ.robot.xml", ["rover"]),
        ],
    )
    def test_every_kind_gets_the_name_by_which_it_is_found(self, page, folder, text, file, kept, names):
        added = add(page, text, file).json()
        assert (added["file"], added["names"]) == (kept, names)
        assert (folder / kept).is_file()

    def test_a_kit_beside_the_mission_is_offered_with_those_that_come_along(self, page):
        add(page, KIT, "tank.board.xml")
        kits = page.get("/api/kits", params={"path": "blink.krt"}).json()
        assert {"pico", "xrp", "tank"} <= {kit["name"] for kit in kits}
        assert [kit["label"] for kit in kits if kit["name"] == "tank"] == [{"fr": "Char"}]

    def test_a_kit_has_a_picture_and_it_is_said_whether_a_program_runs_on_it_or_what_it_lacks(self, page):
        add(page, KIT, "tank.board.xml")
        kits = page.get("/api/kits", params={"path": "blink.krt"}).json()
        assert all(kit["picture"].startswith("<svg") for kit in kits)
        mission = opened(page, "blink.krt")["mission"]
        program = mission["programs"][0]["name"]
        asked = {"path": "blink.krt", "mission": mission, "program": program}
        fits = {fit["kit"]: fit for fit in page.post("/api/kits/fit", json=asked).json()}
        assert set(fits) == {"", *(kit["name"] for kit in kits)}
        assert fits["pico"] == {"kit": "pico", "missing": [], "problem": ""}
        assert fits["tank"]["problem"] == ""
        wheels = mission["programs"][0]["vertices"]
        next(vertex for vertex in wheels if vertex["element"] == "Light.LightOn")["element"] = "Wheel.Advance"
        changed = {fit["kit"]: fit for fit in page.post("/api/kits/fit", json=asked).json()}
        assert [part["part"] for part in changed["tank"]["missing"]] == ["Wheel"]
        assert "lacks what the program uses" in changed["tank"]["problem"]
        assert "driver" in fits[""]["problem"]
        missing = page.post("/api/kits/fit", json={**asked, "program": "none"})
        assert missing.status_code == 422
        assert "none" in missing.json()["message"]

    @pytest.mark.parametrize("element", ["While", "Arm.Unload", "If Then"])
    def test_a_program_with_a_constructor_that_nobody_knows_is_told_so_for_each_kit(self, page, folder, element):
        examples = examples_folder()
        assert examples is not None
        shipped = examples / "transport-team"
        for file in shipped.iterdir():
            (folder / file.name).write_bytes(file.read_bytes())
        mission = opened(page, "transport-team.krt")["mission"]
        program = next(one for one in mission["programs"] if one["name"] == "unload")
        next(vertex for vertex in program["vertices"] if vertex["element"] == element)["element"] = "Nope"
        asked = {"path": "transport-team.krt", "mission": mission, "program": "unload"}
        answer = page.post("/api/kits/fit", json=asked)
        assert answer.status_code == 200
        said = "The program `unload` has errors: `Nope` is not in the constructors’ XML."
        assert {fit["problem"].replace("'", "’") for fit in answer.json()} == {said}

    def test_the_question_has_each_kit_in_each_language_and_what_it_lacks_in_the_one_asked_for(self, page):
        kits = page.get("/api/kits", params={"path": "blink.krt"}).json()
        assert {
            kit["name"]
            for kit in kits
            if set(TEXT_LANGUAGES) - kit["label"].keys() | set(TEXT_LANGUAGES) - kit["help"].keys()
        } == set()
        mission = opened(page, "blink.krt")["mission"]
        vertices = mission["programs"][0]["vertices"]
        next(vertex for vertex in vertices if vertex["element"] == "Light.LightOn")["element"] = "Door.Open"
        asked = {"path": "blink.krt", "mission": mission, "program": mission["programs"][0]["name"]}
        for language, words in {"fr": "Il manque au kit `pololu-3pi`", "ur": "کٹ `pololu-3pi` میں وہ نہیں"}.items():
            answer = page.post("/api/kits/fit", json=asked, headers={"Accept-Language": language}).json()
            assert next(fit for fit in answer if fit["kit"] == "pololu-3pi")["problem"].startswith(words)

    def test_what_is_different_in_a_kit_from_the_one_that_is_there_is_said(self, page):
        def differences(data, file="tank.xml"):
            asked = {"path": "blink.krt", "file": file}
            return page.post("/api/parts/difference", params=asked, content=data.encode()).json()

        assert differences(KIT) == {"changes": []}, "there is none yet"
        add(page, KIT, "tank.board.xml")
        assert differences(KIT) == {"changes": []}
        changed = KIT.replace('<board name="tank"', '<board name="tank" micropython="1.25"')
        assert changed != KIT
        assert differences(changed) == {"changes": ["The kit: micropython – → 1.25"]}
        assert differences(changed.replace('version="1"', 'version="x"')) == {"changes": []}, (
            "with a mistake in it it is no kit"
        )
        assert differences(ROBOT) == {"changes": []}
        assert "cut off" in differences(changed[:-12])["help"]
        assert "begins with <svg>" in differences("<svg/>")["message"]

    @pytest.mark.parametrize("path", ["", "example:transport/transport.krt"])
    def test_parts_of_a_new_mission_and_of_an_example_are_in_the_folder_of_missions(self, page, folder, path):
        add(page, ROBOT, path=path)
        assert (folder / "rover.robot.xml").is_file()
        assert "rover" in robots(page, path)
        examples = examples_folder()
        assert examples is not None
        assert not list((examples / "transport").glob("rover*"))

    def test_a_world_of_the_persons_own_can_be_used_in_an_example(self, page):
        add(page, WORLD, "yard.world.xml", path="example:transport/transport.krt")
        found = page.get("/api/world", params={"path": "example:transport/transport.krt", "href": "yard.world.xml"})
        assert found.json()["world"]["name"] == "Yard"
        mission = {**opened(page)["mission"], "world": "yard.world.xml"}
        report = page.post("/api/check", json={"mission": mission, "path": "example:transport/transport.krt"}).json()
        assert "mission-no-world" not in [problem["code"] for problem in report["problems"]]

    def test_another_file_of_that_name_is_replaced_only_when_it_is_said_which(self, page, folder):
        (folder / "rover.robot.xml").write_text(ROBOT.replace("Lamp", "Horn"))
        refused = add(page, ROBOT)
        assert refused.status_code == 409
        assert "Horn" in (folder / "rover.robot.xml").read_text()
        assert add(page, ROBOT, over=refused.json()["revision"]).status_code == 200
        assert (folder / "rover.robot.xml").read_text() == ROBOT

    def test_the_very_same_file_once_more_is_no_question(self, page):
        add(page, ROBOT)
        assert add(page, ROBOT).json()["known"] is True

    def test_a_robot_with_a_mistake_is_taken_in_and_its_mistake_has_a_file_and_a_line(self, page):
        added = add(page, ROBOT.replace('max="9"', 'max="nine"'))
        assert (added.status_code, added.json()["names"]) == (200, [])
        (problem,) = parts(page)["catalogue"]["problems"]
        assert problem["file"].endswith("rover.robot.xml")
        assert problem["line"] == 3

    @pytest.mark.parametrize(
        ("data", "says"),
        [
            (b"\x89PNG\r\n\x1a\n\x00\x00\xff", "is no XML"),
            (b"", "is no XML"),
            (b"<robot name='rover'><actuator", "cannot be read"),
            (b"<!DOCTYPE robot [<!ENTITY a 'b'>]><robot name='&a;'/>", "cannot be read"),
            (b"<robot>" + b"<a>" * 70 + b"</a>" * 70 + b"</robot>", "cannot be read"),
            (b"<robot name='caf\xe9'/>", "cannot be read"),
            (b"<svg/>", "begins with <svg>"),
            (SHORT.encode(), "is a mission"),
            (b'<root BTCPP_format="4"/>', "is a behaviour tree"),
            (b"<robot name='rover'/>" + b" " * 5_000_000, "larger than 4 MB"),
        ],
        ids=["picture", "empty", "cut off", "entities", "deep", "latin-1", "svg", "mission", "behaviour tree", "large"],
    )
    def test_what_holds_no_parts_is_refused_and_nothing_changes(self, page, folder, data, says):
        before = sorted(folder.iterdir())
        refused = add(page, data)
        assert refused.status_code == 422
        assert says in refused.json()["message"]
        assert sorted(folder.iterdir()) == before

    def test_what_is_larger_than_any_request_is_refused(self, page, folder):
        assert add(page, b" " * (50 * 1024 * 1024)).status_code == 413
        assert not (folder / "rover.robot.xml").exists()

    @pytest.mark.parametrize("file", ["../rover.robot.xml", "/etc/rover.robot.xml", "a/b/rover.robot.xml"])
    def test_a_name_never_leads_out_of_the_folder(self, page, folder, file):
        assert add(page, ROBOT, file).json()["file"] == "rover.robot.xml"
        assert (folder / "rover.robot.xml").is_file()

    @pytest.mark.parametrize("file", ["", "..", "a\\b.xml", "a:b.xml", "a\x00b.xml", "x" * 300 + ".xml"])
    def test_a_name_that_no_file_has_is_refused(self, page, folder, file):
        before = sorted(folder.iterdir())
        assert add(page, ROBOT, file).status_code in (403, 422)
        assert sorted(folder.iterdir()) == before

    def test_a_link_is_not_followed_out_of_the_folder(self, page, folder, tmp_path):
        outside = tmp_path / "outside.xml"
        outside.write_text("mine")
        (folder / "rover.robot.xml").symlink_to(outside)
        assert add(page, ROBOT).status_code == 403
        assert outside.read_text() == "mine"


class TestNews:
    def test_a_page_hears_of_files_that_come_change_and_go(self, page, folder):
        held = opened(page)["parts"]
        assert held == parts(page)["stamp"]
        with page.websocket_connect(WATCH) as socket:
            tab = socket.receive_json()["tab"]
            page.post("/api/journal/claim", json={"tab": tab, "path": "blink.krt", "journal": ""})

            def wait_for_other_parts(than):
                news = socket.receive_json()
                while news["path"] != "blink.krt" or news["parts"] == than:
                    news = socket.receive_json()
                return news["parts"]

            file = folder / "rover.robot.xml"
            file.write_text(ROBOT)
            came = wait_for_other_parts(held)
            file.write_text(ROBOT.replace("Lamp", "Horn"))
            changed = wait_for_other_parts(came)
            assert changed == parts(page)["stamp"]
            file.unlink()
            assert wait_for_other_parts(changed) == held

    def test_the_world_of_the_mission_belongs_to_it_wherever_it_is(self, page, folder):
        (folder / "worlds").mkdir()
        file = folder / "worlds" / "yard.world.xml"
        file.write_text(WORLD)
        mission = {**opened(page)["mission"], "world": "worlds/yard.world.xml"}
        page.post("/api/check", json={"mission": mission, "path": "blink.krt"})
        before = parts(page)["stamp"]
        file.write_text(WORLD.replace("Yard", "Garden"))
        assert parts(page)["stamp"] != before


class TestWorlds:
    def test_worlds_of_the_folder_come_before_those_that_are_shipped(self, page, folder):
        (folder / "yard.world.xml").write_text(WORLD)
        (folder / "broken.world.xml").write_text("<world")
        found = page.get("/api/worlds", params={"path": "blink.krt"}).json()
        assert [(one["href"], one["shipped"], one["world"] is not None) for one in found[:2]] == [
            ("broken.world.xml", False, False),
            ("yard.world.xml", False, True),
        ]
        assert found[0]["problems"][0]["file"] == "broken.world.xml"
        assert ("", True) in [(one["href"], one["shipped"]) for one in found[2:]]

    @pytest.mark.parametrize("href", ["../secret.world.xml", "nowhere.world.xml", "/etc/passwd"])
    def test_a_world_that_is_not_there_is_none(self, page, folder, href):
        (folder.parent / "secret.world.xml").write_text(WORLD)
        assert page.get("/api/world", params={"path": "blink.krt", "href": href}).json() == {"world": None}


class TestVariables:
    def test_a_variable_comes_with_its_methods_and_can_be_checked(self, page):
        made = variable(page, "Steps").json()
        assert made["robot"] == "mini-robot"
        assert (made["variable"]["name"], made["variable"]["max"], made["variable"]["initial"]) == ("Steps", 10, 3)
        assert len(made["variable"]["methods"]) > 3
        mission = {**opened(page)["mission"], "variables": [made]}
        assert page.post("/api/check", json={"mission": mission, "path": "blink.krt"}).status_code == 200

    def test_a_truth_has_no_range(self, page):
        made = variable(page, "Found", type="boolean", min=5, max=2, initial=1).json()["variable"]
        assert (made["type"], made["min"], made["max"], made["initial"]) == ("boolean", 0, 1, 1)

    @pytest.mark.parametrize("name", ["چکر", "Čeština", "距離", " Steps "])
    def test_names_are_of_any_script(self, page, name):
        assert variable(page, name).json()["variable"]["name"] == name.strip()

    @pytest.mark.parametrize(
        ("changes", "says"),
        [
            ({"name": ""}, "no name yet"),
            ({"name": "two words"}, "cannot be called"),
            ({"name": "2nd"}, "cannot be called"),
            ({"name": "WAIT"}, "cannot be called"),
            ({"name": "x" * 101}, "cannot be called"),
            ({"name": "Light"}, "is an actuator of the robot mini-robot already"),
            ({"name": "Fault"}, "is a part of the robot mini-robot already"),
            ({"min": 9, "max": 3}, "holds no number"),
            ({"initial": 11}, "cannot begin at 11"),
            ({"max": 10**9}, "too large"),
            ({"robot": "nobody"}, "no robot named nobody"),
            ({"was": "Gone"}, "is no variable of this mission"),
        ],
        ids=str,
    )
    def test_what_cannot_be_is_said_in_a_sentence(self, page, changes, says):
        refused = variable(page, **changes)
        assert refused.status_code == 422
        assert says in refused.json()["message"]

    def test_a_name_is_taken_by_another_variable_but_not_by_itself(self, page):
        own = [variable(page, "Steps").json()]
        assert "there is a variable" in variable(page, "Steps", own=own).json()["message"].lower()
        assert variable(page, "Steps", was="Steps", max=99, own=own).json()["variable"]["max"] == 99
        assert variable(page, "Trips", was="Steps", own=own).json()["variable"]["name"] == "Trips"

    def test_a_variable_of_the_robots_own_file_says_where_it_is(self, page):
        add(page, ROBOT)
        refused = variable(page, "Laps", robot="rover", was="Trips").json()
        assert "rover.robot.xml" in refused["help"]
