import { act } from "react";
import { afterEach, beforeEach, describe, expect, it, type Mock, vi } from "vitest";

import type { ExperimentChoices, Study, StudyRun } from "../../api/generated";
import { setTransport, transport } from "../../api/transport";
import { moreWords, speak } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { CARRIER, fileOf, missionOf } from "../../model/testing/missions";
import { useRun } from "../../session/run";
import { useVaried, vary } from "../../session/varied-axes";
import { type Hands, handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import { ExperimentPanel } from "./ExperimentPanel";
import { changeSetup } from "./setup";
import { useStudy } from "./study-work";

const asked: [string, unknown][] = [];
let answers: Record<string, unknown> = {};
let sockets: Socket[] = [];

class Socket extends EventTarget {
  readonly sent: unknown[] = [];
  readyState: number = WebSocket.OPEN;
  constructor() {
    super();
    sockets.push(this);
  }
  send(text: string): void {
    this.sent.push(JSON.parse(text));
  }
  close(): void {
    this.readyState = WebSocket.CLOSED;
  }
  say(message: unknown): void {
    this.dispatchEvent(new MessageEvent("message", { data: JSON.stringify(message) }));
  }
}

const usual = transport();

function talkToStudio(): void {
  setTransport({
    fetch: (address, init) => {
      const name = address.split("?")[0] ?? "";
      asked.push([address, init.body]);
      const answer = answers[name];
      if (answer instanceof Response) return Promise.resolve(answer.clone());
      return Promise.resolve(new Response(JSON.stringify(answer ?? {})));
    },
    socket: () => new Socket() as unknown as WebSocket,
  });
}

const SPEED = "carry.v1.speed";
const CHOICES: ExperimentChoices = {
  addresses: [
    { address: SPEED, current: "50", expected: "a whole number from 0 to 100", example: "25:75:12" },
    { address: "radio.loss", current: "0", expected: "a number from 0 to 100", example: "0:4:1" },
  ],
  measures: ["seconds", "done"],
  studies: [],
};

function studyOf(done = 4): Study {
  const cell = (estimate: number) => ({ runs: 2, estimate, low: estimate - 1, high: estimate + 1, method: "t" });
  return {
    ...{ study: "carry-study", seeds: 2, measures: ["seconds", "done"], seconds: 60, version: "1", done, total: 4 },
    ...{ confidence: 0.95, command: "kitrobot sweep carry-study --resume" },
    axes: [{ address: SPEED, values: [30, 60] }],
    points: [30, 60].map((speed, number) => ({
      ...{ number, values: [speed], outcomes: { done: 2 }, cells: [cell(speed), cell(1)] },
    })),
  };
}

const RUNS: StudyRun[] = [0, 1, 2, 3].map((row) => ({
  ...{
    row,
    seed: (row % 2) + 1,
    outcome: row === 1 ? "time" : "done",
    sentence: "All is done.",
    measures: [30 + row, 1],
  },
}));

let page: Mounted;
let hands: Hands;

/** Lets what is waited for, and what was promised meanwhile, come. */
async function settle(): Promise<void> {
  await act(async () => {
    await vi.advanceTimersByTimeAsync(400);
  });
}

/** What is scrolled to, which jsdom cannot. */
let shown: Mock<Element["scrollIntoView"]>;
beforeEach(async () => {
  await speak("en");
  await moreWords();
  // A picture that is asked for while intervals are faked would be the last one of the window.
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
  talkToStudio();
  asked.length = 0;
  sockets = [];
  answers = {
    "api/experiment/choices": CHOICES,
    "api/experiment/plan": { points: 2, runs: 4, command: "kitrobot sweep carry.krt --seeds 1-2" },
    "api/experiment/study": studyOf(),
    "api/experiment/runs": RUNS,
    "api/experiment/replay": { recording: "r7" },
  };
  useStudio.getState().openMission(fileOf(missionOf(CARRIER)));
  useStudy.setState(useStudy.getInitialState(), true);
  useVaried.setState({ axes: [] });
  changeSetup({ seeds: "1-2", measures: ["seconds"], own: "", seconds: "60" });
  shown = vi.fn<Element["scrollIntoView"]>();
  Element.prototype.scrollIntoView = shown;
  page = mount(<ExperimentPanel />);
  hands = handsOn(page);
});
afterEach(() => {
  page.end();
  setTransport(usual);
  vi.useRealTimers();
  vi.restoreAllMocks();
});

/** The panel with a complete study in it. */
async function withStudy(): Promise<void> {
  answers["api/experiment/choices"] = { ...CHOICES, studies: [{ study: "carry-study", runs: 4 }] };
  await settle();
  await settle();
}

const textOf = (testId: string) => hands.find(testId).textContent;

describe("setting up", () => {
  it("says what an experiment is, then how many runs, and the command that does the same", async () => {
    await settle();
    expect(page.place.textContent).toContain("An experiment runs the mission many times");
    await settle();
    expect(textOf("experiment-begin")).toBe("Do 4 runs");
    expect(page.place.textContent).toContain("kitrobot sweep carry.krt --seeds 1-2");
  });

  it("gets a number that was marked in the graph, proposes its values, and takes others", async () => {
    await settle();
    page.act(() => vary(SPEED));
    expect(hands.find<HTMLInputElement>(`values-${SPEED}`).placeholder).toBe("25:75:12");
    await settle();
    expect(JSON.parse(String(asked.at(-1)?.[1]))).toMatchObject({ axes: [{ address: SPEED, values: "25:75:12" }] });
    hands.fill(`values-${SPEED}`, "۳۰,60");
    await settle();
    expect(JSON.parse(String(asked.at(-1)?.[1]))).toMatchObject({ axes: [{ address: SPEED, values: "30,60" }] });
    hands.click(`vary-no-more-${SPEED}`);
    expect(hands.has(`values-${SPEED}`)).toBe(false);
  });

  it("finds another number by a part of its address", async () => {
    await settle();
    hands.fill("experiment-address", "nothing");
    expect(hands.find<HTMLButtonElement>("experiment-vary").disabled).toBe(true);
    hands.fill("experiment-address", "loss");
    hands.press("experiment-address", "Enter");
    expect(useVaried.getState().axes).toEqual([{ address: "radio.loss", values: "" }]);
  });

  it("says what is wrong, and begins nothing", async () => {
    answers["api/experiment/plan"] = new Response(JSON.stringify({ message: "`x` is no range.", help: "" }), {
      status: 422,
    });
    await settle();
    await settle();
    expect(textOf("refused")).toContain("`x` is no range.".replaceAll("`", ""));
    expect(hands.find<HTMLButtonElement>("experiment-begin").disabled).toBe(true);
    hands.fill("experiment-seconds", "0");
    hands.click("measure-seconds");
    const alerts = [...page.place.querySelectorAll("[role=alert]")].map((one) => one.textContent);
    expect(alerts).toEqual([
      "Choose something to measure.",
      "A number of more than 0 and at most 36\u202f000, please.",
    ]);
  });
});

describe("the work", () => {
  it("says what is left, draws while it runs, is broken off, and tells a lost connection", async () => {
    await settle();
    await settle();
    hands.click("experiment-begin");
    const [socket] = sockets;
    page.act(() => socket?.dispatchEvent(new Event("open")));
    expect(socket?.sent).toMatchObject([{ type: "start", seeds: "1-2", measures: ["seconds"], seconds: 60 }]);
    page.act(() => socket?.say({ type: "progress", done: 2, total: 4, left_s: 75, study: studyOf(2) }));
    expect(textOf("experiment-progress")).toContain("2 of 4 runs about 01:15.0 left");
    expect(hands.has("experiment-curve")).toBe(true);
    hands.click("experiment-break-off");
    expect(socket?.sent.at(-1)).toEqual({ type: "stop" });
    page.act(() => socket?.say({ type: "study", study: studyOf(2) }));
    expect(textOf("experiment-done")).toBe("2 of 4 runs");
    hands.click("experiment-resume");
    page.act(() => sockets[1]?.dispatchEvent(new Event("open")));
    expect(sockets[1]?.sent).toEqual([{ type: "resume", path: "test.krt", study: "carry-study" }]);
    page.act(() => sockets[1]?.dispatchEvent(new Event("close")));
    expect(textOf("refused")).toContain("Every run that had ended is kept");
  });
});

describe("a study", () => {
  it("is there again when the page was loaded again", async () => {
    await withStudy();
    expect(textOf("experiment-done")).toBe("4 of 4 runs");
    expect(hands.has("experiment-resume")).toBe(false);
    expect(page.place.textContent).toContain("kitrobot sweep carry-study --resume");
  });

  it("has the room of the whole panel, with the next study below it, which is shown to whoever marks a number", async () => {
    await withStudy();
    const [results, setup] = page.place.querySelector(".experiment-body")?.children ?? [];
    expect(results?.querySelector("[data-testid=experiment-next]")).not.toBeNull();
    expect(setup?.querySelector("form")).not.toBeNull();
    hands.click("experiment-next");
    page.act(() => vary(SPEED));
    expect(shown.mock.contexts).toEqual([setup, setup]);
  });

  it("has points that keys walk to, and shows the runs of the one that is chosen", async () => {
    await withStudy();
    expect(hands.find("point-0").getAttribute("aria-label")).toBe(`${SPEED} = 30: 30 (29 … 31)`);
    page.act(() => hands.find("point-0").focus());
    hands.press("point-0", "ArrowRight");
    expect(document.activeElement).toBe(hands.find("point-1"));
    expect([hands.has("run-0"), hands.has("run-2")]).toEqual([true, false]);
    hands.press("point-1", "Enter");
    expect([hands.has("run-0"), hands.has("run-2")]).toEqual([false, true]);
    expect(hands.find("point-1").getAttribute("aria-pressed")).toBe("true");
  });

  it("plays the very run of a dot, by keys and by its button", async () => {
    const replay = vi.fn();
    useRun.setState({ replay });
    await withStudy();
    page.act(() => hands.find("run-0").focus());
    hands.press("run-0", "End");
    expect(document.activeElement).toBe(hands.find("run-1"));
    hands.press("run-1", "Enter");
    await settle();
    expect(asked.at(-1)?.[0]).toBe("api/experiment/replay?path=test.krt&study=carry-study&row=1");
    expect(replay).toHaveBeenCalledWith(expect.objectContaining({ recording: "r7" }));
    expect(hands.find("run-1").dataset["played"]).toBe("true");
    expect(textOf("experiment-chosen")).toContain("Seed 2: seconds 31 · All is done.");
    hands.press("run-1", "Home");
    hands.click("experiment-play");
    await settle();
    expect(asked.at(-1)?.[0]).toContain("row=0");
  });

  it("leaves its curve as a file of its own, on the ground of the page and without what is the page's alone", async () => {
    await withStudy();
    const saved: Blob[] = [];
    vi.stubGlobal("URL", {
      createObjectURL: (blob: Blob) => `blob:${String(saved.push(blob))}`,
      revokeObjectURL: () => undefined,
    });
    const click = vi.spyOn(HTMLAnchorElement.prototype, "click").mockImplementation(() => undefined);
    hands.click("experiment-svg");
    vi.unstubAllGlobals();
    expect(click.mock.contexts.map((link) => (link as HTMLAnchorElement).download)).toEqual(["carry-study.svg"]);
    const text = (await saved[0]?.text()) ?? "";
    const file = new DOMParser().parseFromString(text, "image/svg+xml");
    expect(file.documentElement.namespaceURI).toBe("http://www.w3.org/2000/svg");
    expect(file.documentElement.firstElementChild?.getAttribute("width")).toBe("100%");
    expect(file.querySelectorAll("circle").length).toBeGreaterThan(1);
    expect(text).not.toMatch(/class=|data-testid=|tabindex=/);
  });

  it("is a table too, each row with a way to its runs", async () => {
    await withStudy();
    const rows = [...hands.find("experiment-table").querySelectorAll("tbody tr")].map((row) =>
      [...row.querySelectorAll("td")].map((cell) => cell.textContent).slice(0, 4),
    );
    expect(rows).toEqual([
      ["30", "2", "30 (29 … 31)", "1 (0 … 2)"],
      ["60", "2", "60 (59 … 61)", "1 (0 … 2)"],
    ]);
    hands.click("show-runs-1");
    expect(hands.has("run-3")).toBe(true);
  });

  it("speaks Urdu with the pictures from left to right", async () => {
    await speak("ur");
    await moreWords();
    await withStudy();
    expect(page.place.querySelector(".experiment-picture")?.getAttribute("dir")).toBe("ltr");
    expect(textOf("experiment-done")).toBe("4 میں سے 4 بار");
  });
});
