/**
 * An icon by its lucide name, as robots and constructors name theirs in XML.
 *
 * Names of the bounded set are drawn at once. For another one the whole set is fetched (once, from our own server); until
 * it is there, and for an unknown name, a plain square is drawn.
 */
import type { LucideIcon } from "lucide-react";
import { createElement, useEffect, useState } from "react";

import { ICONS } from "./icons";

interface IconProps {
  name: string;
  size?: number;
  /** The accessible name; without it the icon is decoration. */
  label?: string;
  className?: string;
}

const FALLBACK = "square-dashed";

let all: Readonly<Record<string, LucideIcon>> | null = null;
let loading: Promise<void> | null = null;

function pascal(name: string): string {
  return name.replace(/(?:^|-)([a-z0-9])/g, (_, letter: string) => letter.toUpperCase());
}

/** Every lucide icon by its PascalCase name, from a chunk of its own. */
export function loadIcons(): Promise<void> {
  loading ??= import("./all-icons").then(
    (module) => {
      all = module.ALL_ICONS;
    },
    () => {
      // Offline or cut off: the fallback stays.
      loading = null;
    },
  );
  return loading;
}

function known(name: string): LucideIcon | undefined {
  return Object.hasOwn(ICONS, name) ? ICONS[name] : all?.[pascal(name)];
}

export function Icon({ name, size = 16, label, className }: IconProps) {
  const [, setLoaded] = useState(0);
  const found = known(name);
  const missing = found === undefined && name !== "" && all === null;
  useEffect(() => {
    if (!missing) return;
    let alive = true;
    void loadIcons().then(() => {
      if (alive) setLoaded((n) => n + 1);
    });
    return () => {
      alive = false;
    };
  }, [missing]);
  const drawn = found ?? ICONS[FALLBACK];
  if (drawn === undefined) return null;
  return createElement(drawn, {
    size,
    strokeWidth: size >= 20 ? 1.75 : 2,
    className: className ?? "",
    ...(label === undefined ? { "aria-hidden": true } : { role: "img", "aria-label": label }),
  });
}
