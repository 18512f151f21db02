import type { ReactNode } from "react";

/** The graph of the program in view; fills its parent. `emptyExtras` is shown under the teaching text of a new program. */
export function Canvas({ emptyExtras }: { emptyExtras?: ReactNode }) {
  return <div className="canvas">{emptyExtras}</div>;
}
