import { beforeAll, expect, test, vi } from "vitest";

import { api } from "../../api/client";
import { moreWords } from "../../i18n/words";
import { useStudio } from "../../model/studio";
import { useDocument } from "../../session/document";
import { download } from "../../ui/download";
import { saveBoardFile } from "./board-file";
import { chooseKit, dropKitQuestion, useKitQuestion } from "./kits";

vi.mock("../../ui/download", () => ({ download: vi.fn() }));
vi.mock("../../api/client", async (original) => {
  const { api } = await original<{ api: object }>();
  return { api: { ...api, boardFile: vi.fn() } };
});
beforeAll(moreWords);

test("it is asked what the robot is built of, and the file is saved for that kit with what is said of it", async () => {
  vi.mocked(api.boardFile).mockResolvedValue({
    file: btoa(":00000001FF\n"),
    boards: "micro:bit V2",
    reasons: ["Too large."],
  });
  saveBoardFile();
  expect(api.boardFile).not.toHaveBeenCalled();
  const asking = useKitQuestion.getState().asking;
  chooseKit(asking?.address ?? "", "cutebot");
  await vi.waitFor(() => {
    expect(download).toHaveBeenCalled();
  });
  const { mission, file } = useStudio.getState();
  const program = mission.programs[0]?.name ?? "";
  expect(api.boardFile).toHaveBeenCalledWith(mission, file.path, program, "cutebot");
  const [name, bytes] = vi.mocked(download).mock.calls[0] ?? [];
  expect([name, new TextDecoder().decode(bytes as Uint8Array)]).toEqual([`${program}.hex`, ":00000001FF\n"]);
  const banner = useDocument.getState().banner;
  expect(banner?.message).toContain("micro:bit V2");
  expect(banner?.help).toMatch(/^Too large\. Plug the board in/);
});

test("who leaves the question saves nothing", () => {
  vi.mocked(api.boardFile).mockClear();
  saveBoardFile();
  dropKitQuestion();
  expect(api.boardFile).not.toHaveBeenCalled();
});
