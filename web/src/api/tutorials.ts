/** Routes of tutorials: which there are, and which steps of one are done. */
import type { Mission } from "../model/types";
import { ask } from "./client";
import type { Tutorial, TutorialFit } from "./generated";

export const tutorialApi = {
  all: () => ask<Tutorial[]>("tutorials"),
  watch: (tutorial: string, mission: Mission, path: string, signal?: AbortSignal) =>
    ask<TutorialFit>("tutorial/watch", {
      method: "POST",
      json: { tutorial, mission, path },
      ...(signal === undefined ? {} : { signal }),
    }),
};
