/** The picture of a choice: an icon, five by five lights, or a patch of its colour. */
import "./choice-picture.css";

import { lightsPath } from "../model/meaning";
import type { Choice } from "../model/types";
import { Icon } from "../theme";

export function ChoicePicture({ choice, size }: { choice: Choice; size: number }) {
  const { icon, lights, colour } = choice;
  if (icon) return <Icon name={icon} size={size} />;
  return (
    <svg className="choice-picture rigid" width={size} height={size} viewBox="-.1 -.1 5 5" aria-hidden="true">
      {colour ? <rect width="4.8" height="4.8" rx=".8" fill={colour} /> : null}
      <path d={lightsPath(lights ?? "")} fill="currentColor" />
    </svg>
  );
}
