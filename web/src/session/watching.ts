/** Whether the watch is open; it takes the place of the list of problems, and the other way round. */
import { create } from "zustand";

import { useProblemList } from "./problem-walk";

interface Watching {
  open: boolean;
  show: (open: boolean) => void;
}

export const useWatch = create<Watching>((set) => ({
  open: false,
  show: (open) => {
    if (open) useProblemList.setState({ open: false });
    set({ open });
  },
}));

useProblemList.subscribe((list, before) => {
  if (list.open && !before.open) useWatch.setState({ open: false });
});
