import { afterEach, beforeAll, beforeEach, expect, test, vi } from "vitest";

import { api } from "../../api/client";
import type { BoardFile } from "../../api/generated";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useDocument } from "../../session/document";
import { saveBoardFile } from "./board-file";
import { chooseKit, dropKitQuestion, useKitQuestion } from "./kits";

const HEX = ":00000001FF\n";
const MADE: BoardFile = {
  ...{ file: btoa(HEX), ending: ".hex", boards: "micro:bit V2" },
  ...{ steps: "Plug the board in.", reasons: ["Too large."] },
};

/** Names of files that the page gave the browser, and what is in them. */
let saved: [name: string, content: Blob][] = [];

beforeAll(moreWords);

beforeEach(() => {
  saved = [];
  let content = new Blob();
  vi.stubGlobal("URL", {
    createObjectURL: (blob: Blob) => {
      content = blob;
      return "blob:1";
    },
    revokeObjectURL: () => undefined,
  });
  vi.spyOn(HTMLAnchorElement.prototype, "click").mockImplementation(function (this: HTMLAnchorElement) {
    saved.push([this.download, content]);
  });
});

afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

test("it is asked what the robot is built of, and the file is saved for that kit with what is said of it", async () => {
  const made = vi.spyOn(api, "boardFile").mockResolvedValue(MADE);
  const { mission, file } = useStudio.getState();
  saveBoardFile();
  expect(made).not.toHaveBeenCalled();
  chooseKit(useKitQuestion.getState().asking?.address ?? "", "cutebot");
  await vi.waitFor(() => expect(useDocument.getState().banner).not.toBeNull());
  const program = mission.programs[0]?.name ?? "";
  const asked = { mission, path: file.path, program, kit: "cutebot", firmware: "", firmware_name: "" };
  expect(made).toHaveBeenCalledWith(asked);
  expect(saved.map(([name, { size }]) => [name, size])).toEqual([[`${program}.hex`, HEX.length]]);
  const banner = useDocument.getState().banner;
  expect(banner?.message).toContain("micro:bit V2");
  expect(banner?.help).toBe("Too large. Plug the board in.");
});

test("who leaves the question saves nothing", () => {
  const made = vi.spyOn(api, "boardFile").mockResolvedValue(MADE);
  saveBoardFile();
  dropKitQuestion();
  expect(made).not.toHaveBeenCalled();
});
