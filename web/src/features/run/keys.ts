/** Keys of the run. */
import { changeSpeed, pause, run, stepVertex } from "../../session/actions";
import type { PageKey } from "../../session/key-table";
import { useRun } from "../../session/run";

export const KEYS = {
  run: { chords: ["F5"], says: "help.keys-run", also: "search.run", typing: true, run: run },
  pause: { chords: ["F6"], says: "help.keys-pause", typing: true, run: pause },
  step: {
    chords: ["F10"],
    says: "help.keys-step",
    also: "search.step",
    typing: true,
    run: () => useRun.getState().step(),
  },
  stepBack: {
    chords: ["F9"],
    says: "run.step-back",
    also: "search.back",
    typing: true,
    run: () => useRun.getState().step("tick", true),
  },
  stepVertex: {
    chords: ["Ctrl+F10"],
    says: "run.step-vertex",
    also: "search.step",
    typing: true,
    run: () => stepVertex(false),
  },
  stepVertexBack: {
    chords: ["Ctrl+F9"],
    says: "run.step-vertex-back",
    also: "search.back",
    typing: true,
    run: () => stepVertex(true),
  },
  slower: { chords: [","], says: "run.slower", run: () => changeSpeed(-1) },
  faster: { chords: ["."], says: "run.faster", run: () => changeSpeed(1) },
} satisfies Record<string, PageKey>;
