/** What the teacher wants of a pupil: a mission, an exercise, a comment or a note; opened at once, or offered. */
import { create } from "zustand";

import { classApi } from "../../api/class";
import { api } from "../../api/client";
import { exerciseApi } from "../../api/exercises";
import { useStudio } from "../../model/studio";
import { text } from "../../model/texts";
import { remember as rememberExercise } from "../../session/open-exercise";
import { beginMission, openMissionOfLesson } from "../../session/open-requests";

export interface Offer {
  kind: "handed" | "exercise" | "note" | "comment";
  words: string;
  open: (() => void) | null;
}

export const useOffers = create<{ offers: readonly Offer[] }>(() => ({ offers: [] }));

export function offer(one: Offer): void {
  useOffers.setState(({ offers }) => ({ offers: [...offers.filter(({ kind }) => kind !== one.kind), one] }));
}

/** It was read, or is put off. */
export function dismissOffer(one: Offer): void {
  useOffers.setState(({ offers }) => ({ offers: offers.filter((other) => other !== one) }));
}

/** Opens it where nothing is unsaved, else offers it. */
export function openOrOffer(one: Offer): void {
  if (one.open !== null && !useStudio.getState().dirty) one.open();
  else offer(one);
}

export function openHanded(name: string): void {
  beginMission(async () => api.readMission(`${name}.krt`, (await classApi.handed()).bytes), name);
}

/** The offer of an exercise; null for one that does not judge. `fetched`: false where the class does not answer. */
export async function exerciseOffer(name: string, fetched = true): Promise<Offer | null> {
  if (fetched) await fetchExercise(name);
  const found = (await exerciseApi.all()).find((one) => one.name === name);
  if (found === undefined || found.goals.length === 0) return null;
  const open = () => {
    rememberExercise({ name, path: found.start });
    if (useStudio.getState().file.path !== found.start) openMissionOfLesson(found.start);
  };
  return { kind: "exercise", words: text(found.label, name), open };
}

/** Gives the files of the exercise, where they are the teacher's own, to the studio of this page. */
async function fetchExercise(name: string): Promise<void> {
  const files = await classApi.exercise(name);
  if (files.byteLength > 0) await exerciseApi.keep(name, files);
}
