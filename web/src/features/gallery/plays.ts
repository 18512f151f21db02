/** Whether pictures of the gallery move by themselves; remembered in this browser. */
import { create } from "zustand";

const KEY = "kitrobot.gallery-still";

function remembered(): boolean {
  try {
    return localStorage.getItem(KEY) === null;
  } catch {
    return true;
  }
}

export const usePlays = create<{ on: boolean }>(() => ({ on: remembered() }));

export function playsAlways(on: boolean): void {
  usePlays.setState({ on });
  try {
    if (on) localStorage.removeItem(KEY);
    else localStorage.setItem(KEY, "yes");
  } catch {
    // Then it is remembered until the page is closed.
  }
}
