/** On a phone: which panel is open under the graph. */
import { create } from "zustand";

import type { Panel } from "./layout";

/** The panel that is open, or null for the graph alone. */
export const useMobileRoom = create<{ room: Panel | null }>(() => ({ room: null }));

export function openRoom(room: Panel | null): void {
  useMobileRoom.setState({ room });
}

/** Opens the panel, or closes it where it is open. */
export function toggleRoom(panel: Panel | null): void {
  useMobileRoom.setState(({ room }) => ({ room: room === panel ? null : panel }));
}
