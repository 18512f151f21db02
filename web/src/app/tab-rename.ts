/** Which program's name is being edited in its tab. */
import { create } from "zustand";

export const useRenaming = create<{ program: string | null }>(() => ({ program: null }));

export function renameInTab(program: string | null): void {
  useRenaming.setState({ program });
}
