/** What a mission does, as a picture: fetched when it comes into sight for the first time. */
import { type ReactNode, useEffect, useRef, useState } from "react";

import { ask } from "../api/client";
import type { RunPreview } from "../api/generated";
import { reportError } from "../session/document";
import { later } from "../ui/later";

const RunPicture = later(() => import("./RunPicture").then((chunk) => chunk.RunPicture), reportError, { words: false });

/** Previews that were fetched, by the mission as it was then. */
const known = new Map<string, Promise<RunPreview>>();

/** What a mission does; fetched once for each state of its file. A fetch that failed is tried again. */
function previewOf(path: string, modified: string): Promise<RunPreview> {
  const name = `${modified} ${path}`;
  const before = known.get(name);
  if (before !== undefined) return before;
  const asked = ask<RunPreview>(`missions/preview?path=${encodeURIComponent(path)}`);
  known.set(name, asked);
  asked.catch(() => known.delete(name));
  return asked;
}

interface MissionPictureProps {
  path: string;
  /** When its file was changed, where that is known. */
  modified?: string;
  className: string;
  /** Whether it moves while it is seen. */
  plays: boolean;
  children?: ReactNode;
}

/** The picture in its frame; of one that cannot be had the frame alone. */
export function MissionPicture({ path, modified = "", className, plays, children }: MissionPictureProps) {
  const frame = useRef<HTMLSpanElement>(null);
  const [preview, setPreview] = useState<RunPreview | null>(null);
  useEffect(() => {
    const element = frame.current;
    if (element === null) return;
    let there = true;
    const sight = new IntersectionObserver((entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      sight.disconnect();
      previewOf(path, modified).then(
        (found) => {
          if (there) setPreview(found);
        },
        () => undefined,
      );
    });
    sight.observe(element);
    return () => {
      there = false;
      sight.disconnect();
    };
  }, [path, modified]);
  return (
    <span className={className} ref={frame}>
      {preview === null ? null : <RunPicture preview={preview} plays={plays} />}
      {children}
    </span>
  );
}
