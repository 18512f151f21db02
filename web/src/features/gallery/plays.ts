/** Whether pictures of the gallery move by themselves; remembered in this browser. */
import { create } from "zustand";
import { readStored, writeStored } from "../../ui/stored";

const KEY = "kitrobot.gallery-still";

export const usePlays = create<{ on: boolean }>(() => ({ on: readStored(KEY) === null }));

export function playsAlways(on: boolean): void {
  usePlays.setState({ on });
  writeStored(KEY, on ? null : "yes");
}
