/** The MicroPython that comes along in a file for a board's drive. */
import { act } from "react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";

import { api, ApiError } from "../../api/client";
import type { BoardFile, KitEntry } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useDocument } from "../../session/document";
import { handsOn } from "../../testing/hands";
import { mount, type Mounted } from "../../testing/hooks";
import * as files from "../../ui/download";
import { dropFirmwareQuestion, useFirmwareQuestion } from "./board-file";
import { BoardFileSheet } from "./BoardFileSheet";

const PICO: KitEntry = {
  ...{ name: "pico", label: {}, help: {}, picture: "", absent: {}, file: ".uf2" },
  ...{ micropython: "1.20", firmware: "https://example.org/pico" },
};
const MADE: BoardFile = { file: btoa("UF2"), ending: ".uf2", boards: "a Pico", steps: "Hold BOOTSEL.", reasons: [] };
/** More than is made into letters at once. */
const FIRMWARE = new File([new Uint8Array(70_000).fill(200)], "RPI_PICO.uf2");

let page: Mounted;
const saved = vi.fn();

beforeEach(async () => {
  await moreWords();
  vi.spyOn(files, "download").mockImplementation((name) => void saved(name));
  page = mount(<BoardFileSheet />);
});

afterEach(() => {
  page.act(dropFirmwareQuestion);
  page.end();
  vi.restoreAllMocks();
  saved.mockReset();
});

function choose(file: File) {
  const input = handsOn(page).find("board-file-firmware");
  Object.defineProperty(input, "files", { value: [file], configurable: true });
  page.act(() => void input.dispatchEvent(new Event("change", { bubbles: true })));
}

/** Presses the button, and waits for all that comes of it. */
async function save(): Promise<void> {
  await act(async () => {
    handsOn(page).find("board-file-save").click();
    await FIRMWARE.arrayBuffer();
    await Promise.resolve();
  });
}

test("a file is chosen once, comes along whole, and is offered again", async () => {
  const made = vi.spyOn(api, "boardFile").mockResolvedValue(MADE);
  const hands = handsOn(page);
  expect(hands.has("board-file")).toBe(false);
  page.act(() => useFirmwareQuestion.setState({ kit: PICO }));
  expect(hands.find("board-file").querySelector("a")?.href).toBe("https://example.org/pico");
  expect(hands.find<HTMLButtonElement>("board-file-save").disabled).toBe(true);
  choose(FIRMWARE);
  await save();
  expect(hands.has("board-file")).toBe(false);
  const asked = made.mock.calls[0]?.[0];
  expect([asked?.kit, asked?.firmware_name]).toEqual(["pico", "RPI_PICO.uf2"]);
  expect(atob(asked?.firmware ?? "")).toBe(String.fromCharCode(200).repeat(70_000));
  expect(saved.mock.calls[0]?.[0]).toMatch(/\.uf2$/);
  expect(useDocument.getState().banner?.help).toBe("Hold BOOTSEL.");
  page.act(() => useFirmwareQuestion.setState({ kit: PICO }));
  expect(hands.find("board-file-kept").textContent).toBe("RPI_PICO.uf2 comes along.");
  expect(hands.find<HTMLButtonElement>("board-file-save").disabled).toBe(false);
});

test("one that cannot be used says why, and another one can be chosen", async () => {
  vi.spyOn(api, "boardFile").mockRejectedValue(new ApiError("It is for RP2350.", "Fetch another."));
  const hands = handsOn(page);
  page.act(() => useFirmwareQuestion.setState({ kit: PICO }));
  choose(FIRMWARE);
  await save();
  expect(hands.find("board-file-trouble").textContent).toContain("It is for RP2350.");
  expect(saved).not.toHaveBeenCalled();
  choose(new File(["x"], "other.uf2"));
  expect(hands.has("board-file-trouble")).toBe(false);
});
