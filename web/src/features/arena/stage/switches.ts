/** What the arena shows besides the robots, switched by a person and remembered; in tutorials all of it is on at first. */
import { create } from "zustand";

import type { Key } from "../../../i18n/words";
import { useStage } from "../../../session/stage";
import { parseStored, readStored, writeStored } from "../../../ui/browser-storage";

export type Shows = "trails" | "rays" | "ahead" | "radio" | "names" | "tag" | "sound";

type On = Readonly<Record<Shows, boolean>>;

/** In the order of the bar. */
export const SHOWS: readonly { id: Shows; label: Key }[] = [
  { id: "trails", label: "arena.trails" },
  { id: "rays", label: "arena.rays" },
  { id: "ahead", label: "arena.ahead" },
  { id: "radio", label: "arena.radio" },
  { id: "names", label: "arena.names" },
  { id: "tag", label: "arena.tag" },
  { id: "sound", label: "arena.sound" },
];

const KEY = "kitrobot.arena";
const USUAL: On = { trails: true, rays: true, ahead: false, radio: false, names: true, tag: true, sound: true };
const LESSON: On = { trails: true, rays: true, ahead: true, radio: true, names: true, tag: true, sound: true };

/** What was remembered, as far as it makes sense. */
export function readSwitches(text: string | null): On {
  const found = parseStored(text);
  if (typeof found !== "object" || found === null) return USUAL;
  const kept = Object.entries(found).filter(([id, on]) => Object.hasOwn(USUAL, id) && typeof on === "boolean");
  return { ...USUAL, ...(Object.fromEntries(kept) as Partial<On>) };
}

/** `lesson`: what is switched while a tutorial is on; that is not remembered, but for the sound. */
export const useSwitches = create<{ own: On; lesson: On }>(() => {
  const own = readSwitches(readStored(KEY));
  return { own, lesson: { ...LESSON, sound: own.sound } };
});

export function switches(): On {
  return useSwitches.getState()[useStage.getState().lesson ? "lesson" : "own"];
}

export function useOn(): On {
  const lesson = useStage((stage) => stage.lesson);
  return useSwitches((state) => (lesson ? state.lesson : state.own));
}

export function flip(id: Shows): void {
  const on = !switches()[id];
  useSwitches.setState(({ own, lesson }) => {
    if (useStage.getState().lesson && id !== "sound") return { lesson: { ...lesson, [id]: on } };
    return { own: { ...own, [id]: on }, lesson: id === "sound" ? { ...lesson, sound: on } : lesson };
  });
}

useSwitches.subscribe(({ own }, before) => {
  if (own !== before.own) writeStored(KEY, JSON.stringify(own));
});
