/** Files of parts go beside the mission; what holds none is refused, and one of that name is replaced only after a question. */
import { act } from "react";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { Banner } from "../../app/Banner";
import { DifferenceSheet } from "../../app/DifferenceSheet";
import { moreWords } from "../../i18n/words";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { PARTS } from "../../model/testing/parts";
import { useStudio } from "../../model/studio";
import { dismissBanner, show, useDocument } from "../../session/document";
import { furnish } from "../../testing/graph";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { refusal, testLine, type TestLine } from "../../testing/socket";
import { takeFiles } from "./take";

function Page() {
  const overlay = useDocument((document) => document.overlay);
  return (
    <>
      <Banner />
      {overlay === "difference" ? <DifferenceSheet /> : null}
    </>
  );
}

let page: Mounted;
let hands: Hands;
let line: TestLine;
const added = (file: string, kind: string, ...names: string[]) => ({ file, kind, names, known: false });
const banner = () => hands.find("banner").textContent;
const until = (fact: () => void) =>
  vi.waitFor(async () => {
    await act(() => new Promise<void>((done) => setTimeout(done)));
    fact();
  });
const sent = () => line.asked.filter(([address]) => address.startsWith("api/parts?")).length;

/** Drops a file; what becomes of it may be asked first. */
async function take(name: string, text = "<parts/>"): Promise<void> {
  await act(async () => {
    void takeFiles([new File([text], name)]);
    await Promise.resolve();
  });
}
function answer(words: string): void {
  const found = [...hands.find("banner").querySelectorAll("button")].find((one) => one.textContent === words);
  if (found === undefined) throw new Error(`no ${words}`);
  page.act(() => found.click());
}

beforeEach(async () => {
  furnish();
  await moreWords();
  line = testLine({ "api/catalogue": { catalogue: PARTS, problems: [] }, "api/worlds": [] });
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  page = mount(<Page />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  line.end();
  dismissBanner();
  show(null);
});

describe("parts that are dropped", () => {
  it("are there, and a program for a robot is one press away", async () => {
    line.answers["api/parts"] = added("rover.robot.xml", "robot", "rover");
    await take("rover.robot.xml");
    await until(() => expect(banner()).toContain("The robot rover is there now."));
    expect(banner()).toContain("Add a program for it");
  });

  it("a world is used by one press", async () => {
    line.answers["api/parts"] = added("field.world.xml", "world", "Yard");
    await take("field.world.xml");
    await until(() => expect(hands.has("banner")).toBe(true));
    answer("Use this world");
    expect(useStudio.getState().mission.world).toBe("field.world.xml");
  });

  it("what holds none is refused in the server's words, what is too large before it is sent", async () => {
    line.answers["api/parts"] = refusal("`song.xml` is no XML.", "Choose another file.");
    await take("song.xml");
    await until(() => expect(banner()).toContain("song.xml is no XML."));
    const before = sent();
    await take("film.xml", " ".repeat(4 * 1024 * 1024 + 1));
    await until(() => expect(banner()).toContain("is larger than 4 MB"));
    expect(sent()).toBe(before);
  });
});

describe("a file whose name is taken", () => {
  beforeEach(async () => {
    line.answers["api/parts"] = refusal("There is another.", "", 409);
    line.answers["api/parts/difference"] = { changes: ["The kit: actuator `lamp`: pin 3 → 5"] };
    await take("tank.board.xml");
    await until(() => expect(banner()).toContain("There is another tank.board.xml in this folder."));
  });

  it("stays as it is where that is wanted", async () => {
    const before = sent();
    answer("Leave it");
    await until(() => expect(hands.has("banner")).toBe(false));
    expect(sent()).toBe(before);
  });

  it("is replaced where that is wanted, after a look at what is different", async () => {
    answer("Show the difference");
    await until(() => expect(hands.find("differences").textContent).toBe("The kit: actuator lamp: pin 3 → 5"));
    page.act(() => show(null));
    line.answers["api/parts"] = added("tank.board.xml", "board", "tank");
    await until(() => expect(hands.has("banner")).toBe(true));
    answer("Replace it");
    await until(() => expect(banner()).toContain("The kit tank is there now."));
  });
});

describe("a program as text", () => {
  const WAITS = { ...CARRIER, name: "fragment" };
  const TREE = '<?xml version="1.0"?>\n<!-- from Groot --><root BTCPP_format="4"/>';
  const names = () => useStudio.getState().mission.programs.map((program) => program.name);

  it.each([
    ["patrol.xml", TREE, "patrol"],
    ["patrol.lll", "WAIT(5);", "patrol"],
    ["3 ways.lll", "WAIT(5);", "program-1"],
    [`${CARRIER.name}.lll`, "WAIT(5);", `${CARRIER.name}-1`],
  ])("%s becomes a program for the robot in view, and undo takes it back", async (file, text, name) => {
    const before = names();
    line.answers["api/fragment"] = { program: WAITS, problems: [] };
    await take(file, text);
    await until(() => expect(names()).toEqual([...before, name]));
    const added = useStudio.getState().mission.programs.at(-1);
    expect(added).toMatchObject({ robot: CARRIER.robot, vertices: WAITS.vertices, arcs: WAITS.arcs });
    expect(useStudio.getState().activeProgram).toBe(name);
    act(() => useStudio.getState().undo());
    expect(names()).toEqual(before);
  });

  it("that is none is refused with its line and changes nothing", async () => {
    const before = names();
    const wrong = (message: string) => ({ message, help: "ask before it", line: 7 });
    line.answers["api/fragment"] = { program: null, problems: [wrong("actions never fail"), wrong("no such part")] };
    await take("patrol.xml", TREE);
    await until(() => expect(banner()).toContain("patrol.xml, line 7: Actions never fail."));
    expect(banner()).toContain("Ask before it. It has 1 more mistake.");
    expect(names()).toEqual(before);
  });
});
