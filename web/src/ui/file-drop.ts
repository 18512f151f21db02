/** Files that are dropped on an element. */
import type { DragEvent } from "react";

function carriesFile(event: DragEvent): boolean {
  return event.dataTransfer.types.includes("Files");
}

/** The handlers of an element on which files can be dropped. */
export function fileDrop(take: (files: File[]) => void): {
  onDragOver: (event: DragEvent) => void;
  onDrop: (event: DragEvent) => void;
} {
  return {
    onDragOver: (event) => {
      if (carriesFile(event)) event.preventDefault();
    },
    onDrop: (event) => {
      if (!carriesFile(event)) return;
      event.preventDefault();
      // The list of files is empty after the event.
      take([...event.dataTransfer.files]);
    },
  };
}
