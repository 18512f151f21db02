/** Robots in their panel: what is said of each state, what its buttons send, its kit, its parts by hand, and MicroPython for it. */
import { act } from "react";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

import { firmwareApi } from "../../api/firmware";
import { partsApi } from "../../api/parts";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useDock } from "../../session/dock";
import { buildWith, useKit } from "../../session/kit";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted, settle } from "../../testing/hooks";
import { runOnAll } from "./actions";
import { BoardCard } from "./BoardCard";
import { placesOf, takeMessage, useBoards } from "./boards";
import { FirmwarePart } from "./Firmware";
import { KitAtHand } from "./KitAtHand";
import { useKitQuestion } from "./kits";
import { KitSheet } from "./KitSheet";
import { EmptyRobots, FindBoard, Robots } from "./Robots";
import * as socket from "./socket";
import * as Team from "./Team";
import type { Board } from "./wire";

await moreWords();

const ADDRESS = "socket://127.0.0.1:4000";
const BOARD: Board = {
  type: "board",
  address: ADDRESS,
  name: "Robot",
  holder: "me",
  phase: "open",
  state: "ready",
  held: true,
  free: 2048,
  generation: 1,
  package: "",
  installed: "i",
  program: "carrier",
  progress: null,
  fault: null,
  message: "",
  help: "",
  way: "",
  micropython: "1.25",
  recorded: false,
  bench: null,
};
const KIT = {
  ...{ name: "tank", label: { "": "Tank" }, help: {}, micropython: "", firmware: "", file: "" as const, picture: "" },
  absent: { carrier: [{ category: "actuator", name: "Motor" }], plain: [] },
};

let page: Mounted | null;
let hands: Hands;
const send = vi.fn();

beforeEach(() => {
  localStorage.clear();
  send.mockClear();
  vi.spyOn(socket, "connect").mockImplementation(() => undefined);
  vi.spyOn(socket, "send").mockImplementation(send);
  vi.spyOn(Team, "TeamPart").mockReturnValue(null);
  vi.spyOn(partsApi, "kits").mockResolvedValue([KIT as never]);
  vi.spyOn(partsApi, "fits").mockResolvedValue([
    { kit: "", missing: [], problem: "" },
    { kit: "tank", missing: [{ part: "Motor", label: { "": "Motor" } }], problem: "No." },
  ]);
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  useBoards.setState({ ...useBoards.getInitialState(), you: "me", ports: [], kits: { [ADDRESS]: "" } });
  useBoards.setState({ boards: {}, steps: {}, refused: {}, given: {}, chosen: {}, typed: [ADDRESS], bodies: {} });
  buildWith(null);
});
afterEach(() => {
  page?.end();
  page = null;
  useBoards.setState(useBoards.getInitialState());
  useKitQuestion.setState({ asking: null });
  useDock.setState({ open: null });
  buildWith(null);
  localStorage.clear();
  vi.restoreAllMocks();
});

async function open(tree: React.JSX.Element): Promise<void> {
  await settle(() => {
    page = mount(tree);
  });
  if (page !== null) hands = handsOn(page);
}
const hear = (more: Partial<Board>) => settle(() => takeMessage({ ...BOARD, ...more }));

/** The card of the robot, as the studio tells of it. */
function Card() {
  const place = placesOf(useBoards()).find(({ address }) => address === ADDRESS);
  return place === undefined ? null : <BoardCard place={place} />;
}
async function openCard(more: Partial<Board> = {}): Promise<void> {
  takeMessage({ ...BOARD, ...more });
  await open(<Card />);
}
const state = () => hands.find("robot-state");
const sent = () => send.mock.calls.map(([request]) => request as { type: string });

it("a robot says its program and memory; Run sends what is drawn, and Stop stops it", async () => {
  await openCard();
  expect(state().textContent).toMatch(/carrier.*2.048.{0,2} bytes free.*MicroPython 1.25/u);
  hands.click("robot-run");
  expect(sent()).toMatchObject([{ type: "send", address: ADDRESS, then: "held", program: "carrier", kit: "" }]);
  await hear({ state: "running" });
  // It has what is drawn: only the start is told.
  hands.click("robot-free");
  expect(sent()[1]).toEqual({ type: "start", address: ADDRESS, held: false });
  hands.click("robot-stop");
  expect(sent()[2]).toEqual({ type: "stop", address: ADDRESS });
  await hear({ state: "running", held: false });
  expect([state().textContent?.includes("Running on its own"), hands.has("robot-free")]).toEqual([true, false]);
  hands.click("robot-watch");
  expect(useDock.getState().open).toBe("watch-panel");
  hands.click("robot-disconnect");
  expect(sent().at(-1)).toEqual({ type: "forget", address: ADDRESS });
});

it("what is edited after it was sent is sent anew", async () => {
  await openCard();
  hands.click("robot-send");
  await hear({});
  page?.act(() =>
    useStudio.getState().execute({ label: "E", execute: (one) => ({ ...one, programs: [...one.programs] }) }),
  );
  hands.click("robot-run");
  expect(sent().map(({ type }) => type)).toEqual(["send", "send"]);
});

it("a robot that is lost says that its motors stop, and is greeted again", async () => {
  await openCard({ phase: "lost", message: "The robot is gone.", help: "Its motors stop within one second." });
  expect(state().dataset["phase"]).toBe("lost");
  expect(hands.find("robot-trouble").textContent).toContain("motors stop within one second");
  hands.click("robot-reconnect");
  expect(sent()[0]).toMatchObject({ type: "connect", address: ADDRESS });
  await hear({ phase: "closed", message: "It cannot be opened.", recorded: true });
  expect(hands.find("robot-trouble").textContent).toContain("cannot be opened");
  expect([hands.has("robot-play-recording"), hands.has("robot-save-recording")]).toEqual([true, true]);
});

it("a fault names its place and leads to its vertex", async () => {
  const fault = { number: 1, sentence: "a driver failed", text: "Display", program: "carrier", vertex: "v8", line: 2 };
  await openCard({ state: "fault", fault: fault as never });
  expect(hands.find("robot-fault").textContent).toMatch(/Fault 1.*Display.*line 2/u);
  hands.click("robot-fault-vertex");
  expect(useStudio.getState().selection).toEqual(["v8"]);
});

it("a robot of another page can only be stopped here", async () => {
  await openCard({ holder: "another", state: "running" });
  expect([hands.has("robot-run"), hands.has("robot-disconnect")]).toEqual([false, false]);
  hands.click("robot-stop");
  expect(sent()).toEqual([{ type: "stop", address: ADDRESS }]);
});

it("one key runs every robot that this page has, and the only one there is, which it greets first", () => {
  const other = "socket://127.0.0.1:4001";
  useBoards.setState({ typed: [ADDRESS, other], kits: { [ADDRESS]: "", [other]: "" } });
  for (const address of [ADDRESS, other]) takeMessage({ ...BOARD, address });
  runOnAll();
  expect(sent()).toMatchObject([
    { type: "send", address: ADDRESS },
    { type: "send", address: other },
  ]);
  send.mockClear();
  useBoards.setState({ boards: {}, typed: [other] });
  runOnAll();
  expect(sent()).toMatchObject([{ type: "send", address: other }]);
});

it("parts are tried one at a time: a value, one that is slow, one that is broken, and what to look for", async () => {
  const step = (part: string, call: string) => ({
    ...{ part, label: {}, call, reads: { type: "boolean", unit: "", meaning: null } },
    ...{ seen: { "": `${part} moves.` }, trouble: { "": "A wire may be swapped." } },
  });
  const steps = [step("Wheel", "Wheel.Advance(40)"), step("Button", "")];
  await openCard({ bench: { step: null, value: null, slow: false, failed: [] } });
  await settle(() => takeMessage({ type: "steps", address: ADDRESS, steps: steps as never, left_out: [] }));
  const rows = () => [...(page?.place.querySelectorAll<HTMLElement>('[data-testid="bench-step"]') ?? [])];
  const find = (row: number, testId: string) => rows()[row]?.querySelector<HTMLElement>(`[data-testid="${testId}"]`);
  expect(hands.find("bench").textContent).toContain("Lift the wheels off the ground first.");
  expect(rows()[0]?.textContent).toContain("Wheel moves.");
  page?.act(() => find(0, "bench-try")?.click());
  expect(sent()).toEqual([{ type: "try", address: ADDRESS, step: 0 }]);
  await hear({ bench: { step: 1, value: 1, slow: true, failed: [{ step: 0, message: "Wheel failed.", help: "" }] } });
  expect(rows().map(({ dataset }) => dataset["going"])).toEqual(["false", "true"]);
  expect(find(0, "bench-failure")?.textContent).toContain("Wheel failed.");
  expect([find(1, "bench-value") !== null, find(1, "bench-slow") !== null]).toEqual([true, true]);
  expect(rows()[0]?.querySelector("details")?.textContent).toContain("A wire may be swapped.");
  page?.act(() => find(1, "bench-try")?.click());
  expect(sent()[1]).toEqual({ type: "try", address: ADDRESS, step: null });
  hands.click("bench-done");
  expect([hands.has("bench"), sent()[2]]).toEqual([false, { type: "stop", address: ADDRESS }]);
});

it("what a robot is built of is asked once, with what the program would lack, and remembered", async () => {
  useBoards.setState({ kits: {} });
  await openCard();
  await settle(() => hands.click("robot-try"));
  expect(sent()).toEqual([]);
  const sheet = mount(<KitSheet />);
  await settle();
  const cards = () => [...sheet.place.querySelectorAll<HTMLElement>('[data-testid="kit-card"]')];
  expect(cards().map(({ dataset }) => dataset["kit"])).toEqual(["", "tank"]);
  expect(cards().map(({ textContent }) => textContent)).toEqual([
    expect.stringContaining("Runs"),
    expect.stringContaining("Lacks: Motor"),
  ]);
  expect(document.activeElement).toBe(cards()[0]);
  await settle(() => cards()[1]?.click());
  expect(sent()).toMatchObject([{ type: "bench", address: ADDRESS, kit: "tank" }]);
  await settle(() => hands.click("robot-try"));
  expect(sent()).toHaveLength(2);
  sheet.end();
});

it("who has no board yet chooses a kit: the parts follow, and its robot is one press away", async () => {
  const { catalogue } = fileOf(missionOf(CARRIER));
  const plain = { ...catalogue.robots[0], name: "plain" };
  useStudio.getState().openMission({
    ...fileOf(missionOf(CARRIER)),
    catalogue: { ...catalogue, robots: [...catalogue.robots, plain as (typeof catalogue.robots)[number]] },
  });
  await open(<KitAtHand />);
  await settle(() => hands.click("kit-pick"));
  const { asking } = useKitQuestion.getState();
  expect(asking?.address).toBe("");
  useBoards.setState({ kits: { "": "tank" } });
  await settle(() => asking?.waiting[0]?.());
  expect(useKit.getState().kit?.name).toBe("tank");
  expect(hands.find("kit-at-hand").textContent).toContain("This kit has no");
  hands.click("kit-take-robot");
  expect([useStudio.getState().mission.programs[0]?.robot, hands.has("kit-take-robot")]).toEqual(["plain", false]);
  hands.click("kit-all-parts");
  expect(useKit.getState().kit).toBeNull();
});

it("without a robot it is said how one gets there, and an address that is none is told", async () => {
  useBoards.setState({ typed: [] });
  await open(<Robots />);
  expect(hands.find("robots-empty").textContent).toContain("Plug a micro:bit");
  hands.fill("robots-address", "not a robot");
  page?.act(() => hands.find("robots-address").closest("form")?.requestSubmit());
  expect(page?.place.querySelector('[role="alert"]')?.textContent).toContain("socket://192.168.4.1:4000");
  expect(send.mock.calls.some(([request]) => (request as { type: string }).type === "connect")).toBe(false);
});

it("a reader of Linux is told of the group that may use boards", async () => {
  vi.spyOn(navigator, "userAgent", "get").mockReturnValue("X11; Linux");
  await open(<EmptyRobots />);
  expect(hands.find("robots-empty").textContent).toContain("dialout");
});

it("where the browser cannot reach boards that is said in the place of the button", async () => {
  vi.stubGlobal("isSecureContext", true);
  await open(<FindBoard />);
  vi.unstubAllGlobals();
  expect(hands.find("find-board-not").textContent).toContain("Edge and Firefox do; or install KitRobot");
  expect(hands.has("find-board")).toBe(false);
});

it("MicroPython is copied to a board that shows a drive; what is not for it is told", async () => {
  const drive = { folder: "/media/RPI-RP2", board: "RPI-RP2", chip: "RP2040" };
  const look = vi.spyOn(firmwareApi, "look").mockResolvedValue({ drives: [], page: "" });
  const flash = vi.spyOn(firmwareApi, "flash").mockRejectedValueOnce(new Error("It is for RP2350."));
  // jsdom scrolls nothing.
  Element.prototype.scrollIntoView = vi.fn();
  await open(<FirmwarePart />);
  await settle(() => {
    const details = page?.place.querySelector("details");
    if (details !== null && details !== undefined) details.open = true;
    details?.dispatchEvent(new Event("toggle"));
  });
  expect(hands.has("firmware-none")).toBe(true);
  look.mockResolvedValue({ drives: [drive], page: "" });
  await settle(() => hands.click("firmware-look"));
  expect(hands.find("firmware-drive").textContent).toBe("RPI-RP2 · RP2040");
  expect(hands.find<HTMLButtonElement>("firmware-copy").disabled).toBe(true);
  const file = new File(["x"], "pico.uf2");
  const choose = () =>
    act(() => {
      Object.defineProperty(hands.find("firmware-file"), "files", { configurable: true, value: [file] });
      hands.find("firmware-file").dispatchEvent(new Event("change", { bubbles: true }));
    });
  choose();
  hands.click("firmware-copy");
  await act(() => vi.waitFor(() => expect(flash).toHaveBeenCalledWith("pico.uf2", drive.folder, expect.anything())));
  await settle();
  expect(hands.find("firmware-trouble").textContent).toContain("It is for RP2350.");
  flash.mockResolvedValue({ board: "Pico", micropython: "1.27.0" });
  hands.click("firmware-copy");
  await act(() => vi.waitFor(() => expect(flash).toHaveBeenCalledTimes(2)));
  await settle();
  expect(hands.find("firmware-done").textContent).toContain("MicroPython 1.27.0 is on the board");
});
